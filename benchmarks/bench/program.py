# SPDX-License-Identifier: Apache-2.0
"""The whole program as users start it: wall-clock and processor time from start to end of the process."""
import json
import os
import resource
import statistics
import subprocess
import sys
import time


def run(stable, *words):
    """Wall-clock and processor seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    begin = time.perf_counter()
    subprocess.run(
        [str(stable.bin / "proofmass"), *map(str, words)], check=True, stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    passed = time.perf_counter() - begin
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return passed, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def line(name, times, which="median"):
    """The figure of several runs: their median, or the worst of them."""
    choose = {"median": statistics.median, "worst": max}[which]
    seconds, processor = zip(*times)
    return {
        "name": name, "which": which, "runs": len(times), "seconds": choose(seconds),
        "processor_seconds": choose(processor), "all": seconds,
    }


def short_jobs(stable, plan, record):
    jobs = {"--help": ("--help",), "identify --method ols, 2000 rows": ("identify", record, "--method", "ols")}
    times = {name: [] for name in jobs}
    for _ in range(3 * plan.rounds):
        for name, words in jobs.items():
            times[name].append(run(stable, *words))
    return [line(name, runs) for name, runs in times.items()]


def identify(stable, plan, record, *words):
    """Times and the RMSE on the test rows."""
    path = plan.folder / "result.json"
    times = run(stable, "identify", record, *words, "--split", "0.7", "--json", path)
    return times, json.loads(path.read_text(encoding="utf-8"))["metrics"]["test"]["rmse"]


def pso_bp(stable, plan, record):
    """Worst of ten seeds, each with its split; the floor is full-model least squares on the same split."""
    table = []
    seeds = range(1, 4 if plan.quick else 11)
    floor = {s: identify(stable, plan, record, "--model", "full", "--seed", s)[1] for s in seeds}
    for threads in (1, 2):
        words = ("--method", "pso-bp", "--threads", threads, "--seed")
        results = {s: identify(stable, plan, record, *words, s) for s in seeds}
        entry = line(f"identify --method pso-bp, {on(threads)}", [times for times, _ in results.values()], "worst")
        entry["worst_over_floor"] = max(rmse / floor[s] for s, (_, rmse) in results.items())
        entry["worst_over_sigma"] = max(rmse / 1e-6 for _, rmse in results.values())
        table.append(entry)
    return table


def on(threads):
    return "1 thread" if threads == 1 else f"{threads} threads"


def end_to_end(stable, plan):
    record = plan.folder / "twin.csv"
    run(stable, "simulate", "data/twin.toml", "--out", record)
    table = short_jobs(stable, plan, record) + pso_bp(stable, plan, record)
    if (os.cpu_count() or 1) < 2:
        print("   one processor: figures for two threads mean nothing", file=sys.stderr)
    rounds = 1 if plan.quick else 3
    for threads in (1, 2):
        words = ("identify", record, "--method", "pso-bp", "--preset", "paper", "--threads", threads)
        table.append(line(f"identify --preset paper, {on(threads)}", [run(stable, *words) for _ in range(rounds)]))
    if not plan.quick:
        words = ("reproduce", "--quick", "--out", plan.folder / "reproduce")
        table.append(line("reproduce --quick", [run(stable, *words)]))
    return table
