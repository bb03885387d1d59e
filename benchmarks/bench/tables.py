# SPDX-License-Identifier: Apache-2.0
"""Results as Markdown tables."""
import statistics


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines)


def short(number):
    return f"{number:.3g}" if abs(number) < 1000 else f"{number:.0f}"


def span(figure, digits=short):
    return f"{digits(figure['low'])} … {digits(figure['high'])}"


def race(summary, unit, extra=()):
    """One row per contestant: median, its spread, ratio to ours in the same round, its spread."""
    rows = []
    for name, figures in summary.items():
        if "failed" in figures:
            rows.append([name, "failed", "", "", ""] + [""] * len(extra))
            continue
        cells = [figures["ns"], figures["ratio"]]
        row = [name, short(cells[0]["median"]), span(cells[0]), short(cells[1]["median"]), span(cells[1])]
        rows.append(row + [short(figures[key]) if key in figures else "" for _, key in extra])
    return table(["", unit, "spread", "times ours", "spread"] + [title for title, _ in extra], rows)


def rates(summary):
    """The comparison in MB/s; times are per byte."""
    rows = [
        [name, short(1e3 / f["ns"]["median"]), short(f["ratio"]["median"]), span(f["ratio"])]
        for name, f in summary.items() if "failed" not in f
    ]
    return table(["", "MB/s", "times ours", "spread"], rows)


def quality(summary):
    rows = []
    for name, f in summary.items():
        if "failed" in f:
            continue
        reached = f["over_sigma"]
        rows.append([
            name, short(statistics.median(reached)), short(min(reached)), short(max(reached)),
            short(statistics.median(f["test_over_sigma"])), f"{statistics.fmean(f['epochs']):.0f}",
            short(f["seconds"]["median"]), short(f["ratio"]["median"]), span(f["ratio"]),
        ])
    head = ["", "median x sigma", "best", "worst", "test median"]
    return table([*head, "epochs, mean", "s, ten starts", "times ours", "spread"], rows)


def bounds(share):
    head = ["", "operations a sample", "bound, ns", "measured, ns", "fraction of the bound"]
    rows = [
        [s["name"], f"{s['operations']:.0f}", short(s["bound_ns"]), short(s["ns"]), f"{100 * s['share']:.0f} %"]
        for s in share
    ]
    return table(head, rows)


def limits(measured):
    rows = [
        [f"{name}, 10⁹ values a second", short(rate / 1e9)] for name, rate in measured["per_second"].items()
    ]
    rows.append(["loads from the first cache, GB/s", short(measured["load_bytes_per_second"] / 1e9)])
    rows += [[f"tanh by {name}, ns", short(ns)] for name, ns in measured["tanh_ns"].items()]
    return table([f"{measured['target']}, {measured['lanes']} lanes", ""], rows)


def growth(lines):
    paths = [name for name in ("forward", "lm", "varpro", "GSL lm, tuned") if name in lines[0]]
    head = ["rows", "data, MiB"] + [f"{p}, ns" for p in paths] + [f"{p}, memory x data" for p in paths]
    rows = []
    for line in lines:
        row = [f"{line['rows']}", short(line["data_mib"])] + [short(line[p]) for p in paths]
        for p in paths:
            grown = line[p + " peak_mib"] - lines[0][p + " peak_mib"]
            row.append(short(grown / line["data_mib"]) if line["data_mib"] > 1 else "")
        rows.append(row)
    return table(head, rows)


def hidden(lines):
    seven = next(line for line in lines if line["hidden"] == 7)
    head = ["hidden", "forward, ns", "over its operations", "lm epoch, ns", "over its operations", "varpro epoch, ns"]
    rows = []
    for line in lines:
        cost = [line[p] / line[p + " operations"] / (seven[p] / seven[p + " operations"]) for p in ("forward", "lm")]
        rows.append([
            str(line["hidden"]), short(line["forward"]), f"{cost[0]:.2f}", short(line["lm"]), f"{cost[1]:.2f}",
            short(line["varpro"]),
        ])
    return table(head, rows)


def end_to_end(lines):
    rows = []
    for line in lines:
        times = [clock(line[key]) for key in ("seconds", "processor_seconds")]
        over = [f"{line[key]:.3f}" if key in line else "" for key in ("worst_over_floor", "worst_over_sigma")]
        rows.append([line["name"], *times, f"{line['which']} of {line['runs']}", *over])
    return table(["", "by the clock", "processors", "", "worst test RMSE x floor", "x sigma"], rows)


def clock(seconds):
    return f"{1e3 * seconds:.1f} ms" if seconds < 0.1 else f"{seconds:.2f} s"
