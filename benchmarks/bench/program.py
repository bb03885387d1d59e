# SPDX-License-Identifier: Apache-2.0
"""The program as its users start it: time from start to end of the process, on an otherwise idle machine."""
import json
import statistics
import subprocess
import sys
import time


def run(stable, *words):
    begin = time.perf_counter()
    subprocess.run(
        [str(stable.bin / "proofmass"), *map(str, words), "--quiet"], check=True,
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )
    return time.perf_counter() - begin


def short_jobs(stable, plan, record):
    times = {}
    for _ in range(plan.rounds):
        for name, words in {
            "--help": ("--help",),
            "identify --method ols, 2000 rows": ("identify", record, "--method", "ols"),
        }.items():
            times.setdefault(name, []).append(run(stable, *words))
    return [line(name, seconds, "median") for name, seconds in times.items()]


def line(name, seconds, which):
    shown = statistics.median(seconds) if which == "median" else max(seconds)
    return {"name": name, "seconds": shown, "which": which, "runs": len(seconds), "all": seconds}


def test_rmse(stable, plan, record, *words):
    path = plan.folder / "result.json"
    seconds = run(stable, "identify", record, *words, "--json", path)
    return seconds, json.loads(path.read_text(encoding="utf-8"))["metrics"]["test"]["rmse"]


def pso_bp(stable, plan, record):
    """Worst of ten seeds, each with its split; the floor is full-model least squares on the same split."""
    table = []
    seeds = range(1, 4 if plan.quick else 11)
    floor = {s: test_rmse(stable, plan, record, "--method", "ols", "--model", "full", "--seed", s)[1] for s in seeds}
    for threads in (1, 2):
        print(f"   pso-bp: {threads} thread(s)", file=sys.stderr)
        results = {
            s: test_rmse(stable, plan, record, "--method", "pso-bp", "--seed", s, "--threads", threads) for s in seeds
        }
        entry = line(f"identify --method pso-bp, {threads} thread(s)", [r[0] for r in results.values()], "worst")
        entry["worst_over_floor"] = max(rmse / floor[s] for s, (_, rmse) in results.items())
        entry["worst_over_sigma"] = max(rmse / 1e-6 for _, rmse in results.values())
        table.append(entry)
    return table


def end_to_end(stable, plan):
    record = plan.folder / "twin.csv"
    run(stable, "simulate", "data/twin.toml", "--out", record)
    table = short_jobs(stable, plan, record) + pso_bp(stable, plan, record)
    paper = ("identify", record, "--method", "pso-bp", "--preset", "paper", "--threads")
    rounds = 1 if plan.quick else 3
    for threads in (1, 2):
        seconds = [run(stable, *paper, threads) for _ in range(rounds)]
        table.append(line(f"identify --preset paper, {threads} thread(s)", seconds, "median"))
    seconds = [run(stable, "reproduce", "--quick", "--out", plan.folder / "reproduce") for _ in range(rounds)]
    table.append(line("reproduce --quick", seconds, "median"))
    return table
