# SPDX-License-Identifier: Apache-2.0
"""The contract of contract/request.hpp and contract/answer.hpp for contestants in Python."""
import argparse
import ctypes
import json
import statistics
import sys
import time

import numpy as np


def request():
    parser = argparse.ArgumentParser()
    parser.add_argument("task")
    for flag in ("data", "starts", "variant", "target"):
        parser.add_argument("--" + flag, default="")
    parser.add_argument("--seconds", type=float, default=0.3)
    for flag in ("epochs", "rows", "hidden"):
        parser.add_argument("--" + flag, type=int, default=0)
    return parser.parse_args()


def samples(asked):
    """Inputs, one per column, and target."""
    table = np.loadtxt(asked.data, delimiter=",")
    return np.asfortranarray(table[:, :-1]), table[:, -1].copy()


def starts(asked):
    return np.loadtxt(asked.starts, delimiter=",", ndmin=2)


def measure(seconds, work):
    """Processor seconds of the median run, and the number of runs."""
    times = []

    def once():
        start = time.process_time()
        work()
        times.append(time.process_time() - start)

    once()
    if times[0] < seconds:  # short work: the first run only warms up
        times.clear()
        start = time.process_time()
        while not times or time.process_time() - start < seconds:
            once()
    return statistics.median_high(times), len(times)


def blas_kernel():
    """The processor type for which OpenBLAS chose its kernels."""
    with open("/proc/self/maps", encoding="utf-8") as maps:
        paths = {line.split()[-1] for line in maps if "blas" in line}
    for path in sorted(paths):
        try:
            name = ctypes.CDLL(path).openblas_get_corename
        except (AttributeError, OSError):
            continue
        name.restype = ctypes.c_char_p
        return name().decode()
    return "not OpenBLAS"


def answer(seconds, repetitions, units, values, counts=(), weights=(), **about):
    """Prints the answer; `units` of work were done in `seconds`."""
    with open("/proc/self/status", encoding="ascii") as status:
        peak = next(int(line.split()[1]) for line in status if line.startswith("VmHWM:"))
    json.dump(
        {
            "ns": 1e9 * seconds / units,
            "seconds": seconds,
            "repetitions": repetitions,
            "peak_kib": peak,
            "values": [float(v) for v in values],
            "counts": [int(c) for c in counts],
            "weights": [[float(w) for w in row] for row in weights],
            "about": about,
        },
        sys.stdout,
    )
    print()


def contend_training(asked, rows, train, **about):
    """`train(start, epochs)` returns weights, RMSE and epochs done."""
    networks = starts(asked)
    runs = []

    def work():
        runs[:] = [train(start, asked.epochs) for start in networks]

    seconds, repetitions = measure(asked.seconds, work)
    weights, rmse, epochs = zip(*runs)
    answer(seconds, repetitions, sum(epochs) * rows, rmse, epochs, weights, **about)
