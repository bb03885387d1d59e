# SPDX-License-Identifier: Apache-2.0
"""Least squares on many rows, and reading records."""
import subprocess

from bench import checks as check
from bench.rounds import interleave, summarise


def least_squares(stable, plan, checks):
    path = plan.folder / f"columns-{plan.rows}.f64"
    contestants = [
        stable.ours("Proofmass, ols", variant="ols"),
        stable.ours("Proofmass, wls", variant="wls"),
        stable.python("numpy.linalg.lstsq", "numpy_peer.py"),
    ]
    answers = interleave(stable, contestants, plan.rounds, "least-squares", data=path, seconds=0)
    check.same_fit(checks, answers, path, "Proofmass, ols")
    summary = summarise(answers, "Proofmass, ols")
    for name, list_of_answers in check.present(answers):
        summary[name]["peak_mib"] = max(a["peak_kib"] for a in list_of_answers) / 1024
    return summary


def reading(stable, plan, checks):
    path = plan.folder / f"record-{plan.record_rows}.csv"
    if not path.exists():
        command = [stable.bin / "proofmass", "simulate", "data/twin.toml", "--out", path]
        subprocess.run([*map(str, command), "--rows", str(plan.record_rows), "--quiet"], check=True)
    contestants = [
        stable.ours("Proofmass"),
        stable.python("numpy.loadtxt", "numpy_peer.py"),
        stable.python("Python csv", "csv_peer.py"),
        stable.octave("Octave dlmread"),
    ]
    if pandas_is_there():
        contestants.append(stable.python("pandas.read_csv", "csv_peer.py", variant="pandas"))
    answers = interleave(stable, contestants, plan.rounds, "read", data=path, seconds=0)
    check.same_record(checks, answers, "Proofmass")
    return summarise(answers, "Proofmass")


def pandas_is_there():
    try:
        import pandas  # noqa: F401 (whether it is there is all that is asked)
    except ImportError:
        return False
    return True
