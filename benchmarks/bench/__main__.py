# SPDX-License-Identifier: Apache-2.0
"""Runs every section and writes the results: python3 -m bench --build DIR --json FILE --tables FILE."""
import argparse
import dataclasses
import datetime
import json
import pathlib
import subprocess
import sys
import time

from bench import bounds, growth, machine, networks, program, records, tables
from bench.checks import Checks
from bench.contestants import Stable


@dataclasses.dataclass
class Plan:
    """The amount of measurement."""

    quick: bool
    folder: pathlib.Path  # of the data
    rounds: int = 7
    growth_rounds: int = 3
    seconds: float = 0.3
    rows: int = 10_000_000
    record_rows: int = 1_000_000

    @staticmethod
    def of(quick, folder):
        if not quick:
            return Plan(False, folder)
        return Plan(True, folder, 3, 1, 0.1, 1_000_000, 100_000)


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", required=True)
    parser.add_argument("--json", required=True, type=pathlib.Path)
    parser.add_argument("--tables", required=True, type=pathlib.Path)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--target", default="")
    parser.add_argument("--rounds", type=int, help="instead of the plan's")
    parser.add_argument("--sections", default="", help="comma-separated; all when empty")
    return parser.parse_args()


def measure_limits(stable):
    words = [str(stable.bin / "bench_limits")] + ([stable.target] if stable.target else [])
    return json.loads(subprocess.run(words, capture_output=True, text=True, check=True).stdout)


def shares(results, rows):
    """Our kernels compared with the bound."""
    table = []
    for name, section, contestant, operations in (
        ("forward", "forward", "Proofmass", bounds.forward(3, 7)),
        ("epoch's kernels", "epoch", "Proofmass, kernels of one trial", bounds.kernels(3, 7)),
        ("epoch, lm by gain", "epoch", networks.BY_GAIN, bounds.epoch(3, 7, rows)),
    ):
        if section in results:
            least = bounds.nanoseconds(operations, results["limits"])
            ns = results[section][contestant]["ns"]["median"]
            table.append({"name": name, "operations": operations, "bound_ns": least, "ns": ns, "share": least / ns})
    return table


def measure(stable, plan, wanted):
    checks = Checks()
    sections = {
        "forward": networks.forward, "epoch": networks.epoch, "quality": networks.quality,
        "growth": growth.rows, "hidden": growth.hidden,
        "least_squares": records.least_squares, "reading": records.reading,
    }
    results = {"machine": machine.describe()}
    results["machine"]["blas_kernels"] = machine.choose_blas(stable, plan.folder)
    results["limits"] = measure_limits(stable)
    for name, section in sections.items():
        if not wanted or name in wanted:
            begin = time.monotonic()
            results[name] = section(stable, plan, checks)
            print(f"{name}: done in {time.monotonic() - begin:.0f} s", file=sys.stderr)
    # The program chooses its instruction set itself; it cannot be forced.
    if not stable.target and (not wanted or "end_to_end" in wanted):
        results["end_to_end"] = program.end_to_end(stable, plan)
    results["bounds"] = shares(results, 1400)
    results["checks"] = checks.done
    return results, checks


def markdown(results):
    titles = {
        "forward": ("Forward RMSE, ns per particle × sample", lambda r: tables.race(r, "ns")),
        "epoch": ("One training epoch, ns per sample", lambda r: tables.race(r, "ns")),
        "quality": ("Quality: RMSE over sigma after at most 1000 epochs", tables.quality),
        "bounds": ("Fraction of the bound", tables.bounds),
        "limits": ("Limits of the machine, one core", tables.limits),
        "growth": ("Growth with rows, per sample", tables.growth),
        "hidden": ("Growth with hidden units, per sample; cost over operations is relative to 7", tables.hidden),
        "least_squares": (
            "Least squares, 21 terms, ns per row", lambda r: tables.race(r, "ns", [("peak MiB", "peak_mib")])
        ),
        "reading": ("Reading a record", tables.rates),
        "end_to_end": ("The program, start to end of the process", tables.end_to_end),
    }
    about = results["machine"]
    parts = [
        f"{about['date']}, {about['processor']} (family/model {about['family_model']}), {about['cores']} cores, "
        f"{about['system']}, {about['compiler']}. Kernels of ours: {results['limits']['target']}; of OpenBLAS: "
        f"{about['blas_kernels']}. Rounds: {about['rounds']}. Load when it began: {about['load_at_start']}."
    ]
    for key, (title, render) in titles.items():
        if results.get(key):
            parts.append(f"### {title}\n\n{render(results[key])}")
    failed = [c["what"] for c in results["checks"] if not c["good"]]
    done = len(results["checks"])
    broken = "".join(f" Failed: {what}." for what in failed)
    parts.append(f"Checks of what was reached: {done - len(failed)} of {done} hold.{broken}")
    return "\n\n".join(parts) + "\n"


def main():
    asked = arguments()
    stable = Stable(asked.build, asked.target, machine.flags())
    plan = Plan.of(asked.quick, pathlib.Path(asked.build).parent / "bench")
    if asked.rounds:
        plan.rounds = asked.rounds
    lengths = [str(plan.rows)]
    subprocess.run([str(stable.bin / "bench_data"), "data/twin.toml", str(plan.folder), *lengths], check=True)
    wanted = [name for name in asked.sections.split(",") if name]
    results, checks = measure(stable, plan, wanted)
    results["machine"].update(date=datetime.date.today().isoformat(), rounds=plan.rounds, quick=plan.quick)
    asked.json.write_text(json.dumps(results, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    asked.tables.write_text(markdown(results), encoding="utf-8")
    return 1 if checks.failed() or stable.failures else 0


if __name__ == "__main__":
    sys.exit(main())
