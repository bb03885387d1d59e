#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Prints five small data sets and the results of SciPy's ODR (ODRPACK) for them as JSON.

The tests of errors in variables compare with these results. Run it with /usr/bin/python3 and Debian's python3-scipy.
The data come from a linear congruential generator in this file, so that they are the same everywhere.
"""

import json
import math
import warnings

import numpy as np

warnings.simplefilter("ignore")
from scipy import odr  # noqa: E402

# Powers of Ai, Ao, Ap; "Koq" is |Ai|*Ai.
POWERS = {
    "K0": (0, 0, 0), "Ki": (1, 0, 0), "Kii": (2, 0, 0), "Koq": (2, 0, 0), "Kiii": (3, 0, 0),
    "Kio": (1, 1, 0), "Kip": (1, 0, 1), "Kop": (0, 1, 1), "Ko": (0, 1, 0), "Koo": (0, 2, 0),
    "Kp": (0, 0, 1), "Kpp": (0, 0, 2), "Kioo": (1, 2, 0), "Koii": (2, 1, 0), "Kiop": (1, 1, 1),
}


class Draws:
    """Uniform draws by Knuth's MMIX generator, and sums of twelve of them in place of normal ones."""

    def __init__(self, seed):
        self.state = seed

    def uniform(self, low, high):
        self.state = (6364136223846793005 * self.state + 1442695040888963407) % 2**64
        return low + (high - low) * (self.state >> 11) / 2**53

    def normal(self):
        return sum(self.uniform(-0.5, 0.5) for _ in range(12))


def factor(x, power, signed):
    return np.abs(x) * x if signed else x**power


def slope(x, power, signed):
    if signed:
        return 2 * np.abs(x)
    return power * x ** (power - 1) if power else 0 * x


def regressor(name, x, derivative=None):
    product = np.ones(x.shape[1])
    for axis in range(x.shape[0]):
        signed = name == "Koq" and axis == 0
        function = slope if axis == derivative else factor
        product = product * function(x[axis], POWERS[name][axis], signed)
    return product


def model_of(terms):
    def value(beta, x):
        return sum(b * regressor(t, np.atleast_2d(x)) for b, t in zip(beta, terms))

    def by_beta(beta, x):
        return np.array([regressor(t, np.atleast_2d(x)) for t in terms])

    def by_x(beta, x):
        x = np.atleast_2d(x)
        slopes = [sum(b * regressor(t, x, axis) for b, t in zip(beta, terms)) for axis in range(len(x))]
        return np.array(slopes) if len(slopes) > 1 else slopes[0]

    return value, odr.Model(value, fjacb=by_beta, fjacd=by_x)


def solve(terms, x, y, sigma_x, sigma_y):
    """ODR from the least-squares solution, restarted until it stands still. A sigma of zero fixes the input."""
    value, model = model_of(terms)
    design = np.array([regressor(t, x) for t in terms]).T
    beta = np.linalg.lstsq(design, y, rcond=None)[0]
    weights = np.where(sigma_x > 0, 1 / np.where(sigma_x > 0, sigma_x, 1) ** 2, 1.0)
    fixed = np.where(sigma_x > 0, 1, 0)
    if len(x) == 1:
        x, weights, fixed = x[0], weights[0], fixed[0]
    for _ in range(20):
        data = odr.Data(x, y, we=1 / sigma_y**2, wd=weights)
        problem = odr.ODR(data, model, beta0=beta, ifixx=fixed, maxit=2000, sstol=1e-15, partol=1e-15)
        problem.set_job(fit_type=0, deriv=3)
        found = problem.run()
        moved = np.max(np.abs(found.beta - beta) / found.sd_beta)
        beta = found.beta
        if moved < 1e-9:
            break
    return found


def synthetic(seed, rows, terms, truth, axes, reach, sigma_x, sigma_y):
    """Rows over a cube of side 2 * reach; sigma_x and sigma_y are functions of row and noise-free input."""
    draws = Draws(seed)
    true = np.array([[draws.uniform(-reach, reach) for _ in range(axes)] for _ in range(rows)]).T
    # One row exactly at Ai = 0, where |Ai|*Ai has no second derivative.
    true[0, 0] = 0.0
    sx = np.array([[sigma_x(axis, r, true[axis, r]) for r in range(rows)] for axis in range(axes)])
    sy = np.array([sigma_y(r, true[0, r]) for r in range(rows)])
    clean = sum(b * regressor(t, true) for b, t in zip(truth, terms))
    x = true + sx * np.array([[draws.normal() for _ in range(rows)] for _ in range(axes)])
    y = clean + sy * np.array([draws.normal() for _ in range(rows)])
    return terms, x, y, sx, sy


def pearson_york():
    """Pearson's data with York's weights (D. York, Canadian Journal of Physics 44, 1966)."""
    x = np.array([[0.0, 0.9, 1.8, 2.6, 3.3, 4.4, 5.2, 6.1, 6.5, 7.4]])
    y = np.array([5.9, 5.4, 4.4, 4.6, 3.5, 3.7, 2.8, 2.8, 2.4, 1.5])
    wx = np.array([[1000.0, 1000, 500, 800, 200, 80, 60, 20, 1.8, 1.0]])
    wy = np.array([1.0, 1.8, 4, 8, 20, 20, 70, 70, 100, 500])
    return ["K0", "Ki"], x, y, 1 / np.sqrt(wx), 1 / np.sqrt(wy)


def sets():
    yield "pearson-york", pearson_york()
    yield "quadratic", synthetic(
        11, 40, ["K0", "Ki", "Kii"], [0.3, 1.2, 0.15], 1, 3.0,
        lambda axis, r, a: 0.05 + 0.02 * abs(a), lambda r, a: 0.03 + 0.01 * (r % 4))
    yield "signed-square", synthetic(
        12, 50, ["K0", "Ki", "Kii", "Koq", "Kiii"], [0.01, 0.98, 0.03, -0.04, 0.01], 1, 4.0,
        lambda axis, r, a: 0.04, lambda r, a: 0.02)
    yield "one-exact-axis", synthetic(
        13, 60, ["K0", "Ki", "Kio", "Ko", "Koo", "Kioo", "Koii"], [0.02, 1.01, 0.05, -0.2, 0.03, 0.01, -0.02], 2, 2.0,
        lambda axis, r, a: (0.0 if r % 5 == 0 else 0.05) if axis == 0 else 0.0, lambda r, a: 0.02)
    yield "three-axes", synthetic(
        14, 120, ["K0", "Ki", "Kii", "Kiii", "Kio", "Kip", "Kop", "Ko", "Koo", "Kp", "Kpp", "Kiop"],
        [0.01, 0.99, 0.02, 0.003, 0.01, -0.02, 0.03, 0.1, -0.02, -0.05, 0.01, 0.004], 3, 3.0,
        lambda axis, r, a: (0.05, 0.03, 0.08)[axis], lambda r, a: 0.01 + 0.005 * (r % 3))


def main():
    results = []
    for name, (terms, x, y, sx, sy) in sets():
        found = solve(terms, x, y, sx, sy)
        assert math.isfinite(found.res_var), name
        results.append({
            "name": name, "terms": terms, "x": x.tolist(), "y": y.tolist(), "sigma_x": sx.tolist(),
            "sigma_y": sy.tolist(), "beta": found.beta.tolist(), "sd_beta": found.sd_beta.tolist(),
            "cov_beta": found.cov_beta.tolist(), "res_var": found.res_var, "sum_square": found.sum_square,
            "info": found.info, "stopreason": found.stopreason})
    print(json.dumps(results))


if __name__ == "__main__":
    main()
