# SPDX-License-Identifier: Apache-2.0
"""The network in numpy. Weights: w_1 … w_H (three each), b_1 … b_H, v_1 … v_H, c."""
import numpy as np

INPUTS = 3


def parts(weights):
    hidden = (len(weights) - 1) // (INPUTS + 2)
    w = weights[: hidden * INPUTS].reshape(hidden, INPUTS)
    b, v = weights[hidden * INPUTS : -1].reshape(2, hidden)
    return w, b, v, weights[-1]


def hidden_outputs(weights, x):
    w, b, _, _ = parts(weights)
    z = x @ w.T
    z += b
    return np.tanh(z, out=z)


def outputs(weights, x):
    _, _, v, c = parts(weights)
    return hidden_outputs(weights, x) @ v + c


def rmse(weights, x, target):
    residual = outputs(weights, x) - target
    return np.sqrt(residual @ residual / len(target))


def jacobian(weights, x, h, result):
    """Jacobian of the outputs by the weights, written to `result`, whose columns are contiguous."""
    _, _, v, _ = parts(weights)
    hidden = len(v)
    slope = v * (1.0 - h * h)
    biases = hidden * INPUTS
    for j in range(hidden):
        np.multiply(x, slope[:, j : j + 1], out=result[:, j * INPUTS : (j + 1) * INPUTS])
    result[:, biases : biases + hidden] = slope
    result[:, biases + hidden : -1] = h
    result[:, -1] = 1.0
    return result
