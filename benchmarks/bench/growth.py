# SPDX-License-Identifier: Apache-2.0
"""Growth of the time per sample, and of memory, with rows and with hidden units."""
import statistics

from bench import bounds
from bench.checks import present
from bench.rounds import interleave

SIZES = (1400, 14_000, 140_000, 1_400_000)
HIDDEN = (3, 5, 7, 9, 12, 16, 20, 25)  # bench_data writes a start for each
EPOCHS = 10


def costs(stable, plan, start, peers, **flags):
    """Growth of forward evaluation and of training from one start."""
    flags.update(data=plan.folder / "samples.csv", starts=plan.folder / start, seconds=plan.seconds)
    trainers = [stable.ours("lm", variant="lm"), stable.ours("varpro", variant="varpro"), *peers]
    answers = {
        **interleave(stable, [stable.ours("forward")], plan.growth_rounds, "forward", **flags),
        **interleave(stable, trainers, plan.growth_rounds, "train", epochs=EPOCHS, **flags),
    }
    line = {}
    for name, list_of_answers in present(answers):
        line[name] = statistics.median(a["ns"] for a in list_of_answers)
        line[name + " peak_mib"] = max(a["peak_kib"] for a in list_of_answers) / 1024
    return line


def rows(stable, plan, checks):
    """The same 1400 samples repeated, so that training takes the same path."""
    del checks
    peers = [] if plan.quick else [stable.program("GSL lm, tuned", "gsl_tuned", variant="lm")]
    return [
        {"rows": n, "data_mib": n * 4 * 8 / 2**20, **costs(stable, plan, "starts-7.csv", peers, rows=n)}
        for n in SIZES
    ]


def hidden(stable, plan, checks):
    del checks
    return [
        {
            "hidden": units,
            "forward operations": bounds.forward(3, units),
            "lm operations": bounds.epoch(3, units, SIZES[0]),
            **costs(stable, plan, f"starts-{units}.csv", [], hidden=units),
        }
        for units in HIDDEN
    ]
