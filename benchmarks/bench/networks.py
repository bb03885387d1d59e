# SPDX-License-Identifier: Apache-2.0
"""The hot paths of networks, compared with every peer."""
import json

from bench import checks as check
from bench.rounds import interleave, summarise


BY_GAIN = "Proofmass, lm by gain"  # step by step what GSL's lm does


def forward(stable, plan, checks):
    contestants = [
        stable.ours("Proofmass"),
        *stable.ours_by_avx2("Proofmass"),
        stable.program("pagmo, std::tanh", "pagmo_plain"),
        stable.program("pagmo, fastest build", "pagmo_fast"),
        stable.python("numpy, batch", "numpy_peer.py"),
        stable.octave("Octave"),
    ]
    answers = interleave(
        stable, contestants, plan.rounds, "forward", data=plan.folder / "samples.csv",
        starts=plan.folder / "swarm.csv", seconds=plan.seconds,
    )
    check.forward(checks, answers, plan.folder)
    return summarise(answers, "Proofmass")


def trainers(stable, slow_rounds):
    return [
        stable.ours(BY_GAIN, variant="lm-gain"),
        stable.ours("Proofmass, varpro", variant="varpro"),
        stable.ours("Proofmass, lm", variant="lm"),
        stable.program("GSL lm, tuned", "gsl_tuned", variant="lm"),
        stable.program("GSL lmaccel, tuned", "gsl_tuned", variant="lmaccel"),
        stable.program("Ceres, batched", "ceres_fast", variant="batched"),
        stable.python("SciPy least_squares lm", "scipy_peer.py", rounds=slow_rounds),
    ]


def epoch(stable, plan, checks):
    contestants = [
        *trainers(stable, plan.rounds),
        stable.program("GSL lm, as installed", "gsl_installed", variant="lm"),
        stable.program("GSL lmaccel, as installed", "gsl_installed", variant="lmaccel"),
        stable.program("Ceres, a block a sample", "ceres_fast", variant="rows"),
        stable.python("numpy loop", "numpy_peer.py"),
        stable.octave("Octave loop"),
    ]
    for name, variant in (("varpro", "varpro"), ("lm by gain", "lm-gain")):
        contestants[3:3] = stable.ours_by_avx2(f"Proofmass, {name}", variant=variant)
    data = {"data": plan.folder / "samples.csv", "starts": plan.folder / "starts.csv"}
    answers = interleave(stable, contestants, plan.rounds, "train", epochs=30, seconds=plan.seconds, **data)
    check.stated_rmse(checks, "epoch", answers, plan.folder)
    kernels = [stable.ours("Proofmass, kernels of one trial")]
    answers |= interleave(stable, kernels, plan.rounds, "kernels", seconds=plan.seconds, **data)
    for names in (("Proofmass, lm", "numpy loop", "Octave loop"), (BY_GAIN, "GSL lm, tuned")):
        same = [c for c in contestants if c.name in names]
        few = interleave(stable, same, 1, "train", epochs=4, seconds=0, **data)
        check.same_steps(checks, few, names[0])
    return summarise(answers, BY_GAIN)


def quality(stable, plan, checks):
    """RMSE over sigma after at most 1000 epochs from ten starts; all run to the end, timed each round."""
    contestants = trainers(stable, 1)
    if plan.quick:
        contestants = contestants[:5]
    answers = interleave(
        stable, contestants, 1 if plan.quick else plan.rounds, "train", data=plan.folder / "samples.csv",
        starts=plan.folder / "starts.csv", epochs=1000, seconds=0,
    )
    check.stated_rmse(checks, "quality", answers, plan.folder)
    summary = summarise(answers, "Proofmass, varpro", "seconds")
    scale = json.loads((plan.folder / "scale.json").read_text(encoding="utf-8"))["unit_over_sigma"]
    x, target = check.read_samples(plan.folder / "test.csv")
    for name, list_of_answers in check.present(answers):
        last = list_of_answers[-1]
        summary[name]["over_sigma"] = [scale * rmse for rmse in last["values"]]
        summary[name]["test_over_sigma"] = [
            scale * float(check.network.rmse(check.np.array(w), x, target)) for w in last["weights"]
        ]
        summary[name]["epochs"] = last["counts"]
    return summary
