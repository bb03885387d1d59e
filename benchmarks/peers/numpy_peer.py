# SPDX-License-Identifier: Apache-2.0
"""numpy as a contestant: networks in a batch, a Levenberg-Marquardt loop by hand, lstsq, loadtxt."""
import os

import contract
import network
import numpy as np


def forward(asked):
    x, target = contract.samples(asked)
    swarm = contract.starts(asked)
    rmse = []

    def work():
        rmse[:] = [network.rmse(weights, x, target) for weights in swarm]

    seconds, repetitions = contract.measure(asked.seconds, work)
    contract.answer(seconds, repetitions, len(swarm) * len(target), rmse, version=np.__version__)


def levenberg_marquardt(x, target):
    """The textbook's loop (Hagan & Menhaj 1994) with MATLAB trainlm's damping, as in --trainer lm."""
    jacobian = np.empty((len(target), 0), order="F")

    def train(start, epochs):
        nonlocal jacobian
        if jacobian.shape[1] != len(start):
            jacobian = np.empty((len(target), len(start)), order="F")
        weights, mu, epoch = start, 1e-3, 0
        h, residual = evaluate(weights)
        sse = residual @ residual
        while epoch < epochs:
            j = network.jacobian(weights, x, h, jacobian)
            normal, gradient = j.T @ j, j.T @ residual
            if np.linalg.norm(gradient) <= 1e-7:
                break
            while mu <= 1e10:
                trial = weights - np.linalg.solve(normal + mu * np.eye(len(weights)), gradient)
                trial_h, trial_residual = evaluate(trial)
                trial_sse = trial_residual @ trial_residual
                if trial_sse < sse:
                    break
                mu *= 10.0
            else:
                break
            weights, h, residual, sse = trial, trial_h, trial_residual, trial_sse
            mu = max(0.1 * mu, 1e-20)
            epoch += 1
        return weights, np.sqrt(sse / len(target)), epoch

    def evaluate(weights):
        _, _, v, c = network.parts(weights)
        h = network.hidden_outputs(weights, x)
        return h, h @ v + c - target

    return train


def train(asked):
    x, target = contract.samples(asked)
    contract.contend_training(
        asked, len(target), levenberg_marquardt(x, target), version=np.__version__, blas=contract.blas_kernel()
    )


def design(i, o, p):
    """The 21 terms of the static model, in the order of the product."""
    columns = (
        np.ones_like(i), i, i**2, abs(i) * i, i**3, i * o, i * p, o * p, o, o**2, o**3, p, p**2, p**3,
        i * o**2, i * p**2, o * p**2, o * i**2, p * o**2, p * i**2, i * o * p,
    )
    result = np.empty((len(i), len(columns)), order="F")
    for k, column in enumerate(columns):
        result[:, k] = column
    return result


def least_squares(asked):
    """lstsq only: the time to make the design is not counted."""
    i, o, p, e = np.fromfile(asked.data).reshape(4, -1)
    terms = design(i, o, p)
    result = []

    def work():
        result[:] = [np.linalg.lstsq(terms, e, rcond=None)[0]]

    seconds, repetitions = contract.measure(asked.seconds, work)
    contract.answer(seconds, repetitions, len(e), result[0], version=np.__version__, blas=contract.blas_kernel())


def read(asked):
    table = []

    def work():
        table[:] = [np.loadtxt(asked.data, delimiter=",", skiprows=header_lines(asked.data))]

    seconds, repetitions = contract.measure(asked.seconds, work)
    e = table[0][:, 3]
    contract.answer(
        seconds, repetitions, os.path.getsize(asked.data), [len(e), np.mean(e * e)], version=np.__version__
    )


def header_lines(path):
    """Number of lines to skip: comments and the line of names."""
    with open(path, encoding="utf-8") as file:
        return next(k for k, line in enumerate(file, 1) if not line.startswith("#"))


if __name__ == "__main__":
    task = contract.request()
    {"forward": forward, "train": train, "least-squares": least_squares, "read": read}[task.task](task)
