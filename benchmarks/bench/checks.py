# SPDX-License-Identifier: Apache-2.0
"""Checks the results that contestants report: one program computes them again for all."""
import sys

import numpy as np

from bench.contestants import PEERS

sys.path.insert(0, str(PEERS))
import network  # noqa: E402  (found by the line above)
import numpy_peer  # noqa: E402


class Checks:
    def __init__(self):
        self.done = []

    def expect(self, what, error, tolerance):
        """`error` must not exceed the tolerance."""
        good = bool(error <= tolerance)
        self.done.append({"what": what, "error": float(error), "tolerance": tolerance, "good": good})
        if not good:
            print(f"   CHECK FAILED: {what}: {error:.3g} > {tolerance:.3g}", file=sys.stderr)

    def failed(self):
        return [check for check in self.done if not check["good"]]


def read_samples(path):
    table = np.loadtxt(path, delimiter=",")
    return table[:, :-1], table[:, -1]


def forward(checks, answers, folder):
    x, target = read_samples(folder / "samples.csv")
    swarm = np.loadtxt(folder / "swarm.csv", delimiter=",")
    truth = np.array([network.rmse(weights, x, target) for weights in swarm])
    for name, list_of_answers in present(answers):
        error = np.max(np.abs(np.array(list_of_answers[-1]["values"]) / truth - 1.0))
        checks.expect(f"forward, {name}: RMSE of 50 networks", error, 1e-9)


def stated_rmse(checks, what, answers, folder):
    x, target = read_samples(folder / "samples.csv")
    for name, list_of_answers in present(answers):
        answer = list_of_answers[-1]
        again = np.array([network.rmse(np.array(w), x, target) for w in answer["weights"]])
        error = np.max(np.abs(np.array(answer["values"]) / again - 1.0))
        # Near the noise (5e-8 of the output's range) large output weights leave no more digits.
        checks.expect(f"{what}, {name}: RMSE stated and that of the weights handed in", error, 1e-4)


def same_steps(checks, answers, reference):
    """The same algorithm must be at the same point after a few epochs."""
    truth = np.array(answers[reference][-1]["values"])
    for name, list_of_answers in present(answers):
        error = np.max(np.abs(np.array(list_of_answers[-1]["values"]) / truth - 1.0))
        checks.expect(f"first epochs, {name}: RMSE as {reference}", error, 1e-6)


def same_fit(checks, answers, path, reference):
    """Predictions from the coefficients, in g, on the first rows; the noise is 1e-6 g."""
    rows = path.stat().st_size // 32
    columns = np.memmap(path, dtype=float, mode="r").reshape(4, rows)[:, :1000]
    design = numpy_peer.design(*np.array(columns[:3]))
    truth = design @ np.array(answers[reference][-1]["values"])
    for name, list_of_answers in present(answers):
        error = np.max(np.abs(design @ np.array(list_of_answers[-1]["values"]) - truth))
        checks.expect(f"least squares, {name}: predictions as {reference}, g", error, 1e-9)


def same_record(checks, answers, reference):
    truth = np.array(answers[reference][-1]["values"])
    for name, list_of_answers in present(answers):
        error = np.max(np.abs(np.array(list_of_answers[-1]["values"]) / truth - 1.0))
        checks.expect(f"reading, {name}: rows and mean square as {reference}", error, 1e-12)


def present(answers):
    return [(name, answer) for name, answer in answers.items() if answer]
