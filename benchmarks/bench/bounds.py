# SPDX-License-Identifier: Apache-2.0
"""The least time that the arithmetic of a network can take, from operation counts and the measured peak.

Operations of the fused multiply-add ports a sample, for a network of I inputs, H units and D = H (I + 2) + 1
weights; a fused product counts once. Loads, stores and whatever runs on other ports are taken to be free.
"""

TANH = 18  # the exponential's polynomial and table, the reciprocal and its refinement, the quotient
UNIT_OUTPUT = 1  # v_j h_j, summed; the argument b_j + w_j . x takes I
RESIDUAL = 2  # target - output; its square, summed
UNIT_SLOPE = 2  # v_j (1 - h_j²)
TANH_PASSES = 1  # an epoch needs tanh at its trial point alone: the Jacobian is at the last one accepted


def forward(inputs, hidden):
    return hidden * (inputs + TANH + UNIT_OUTPUT) + RESIDUAL


def jacobian(inputs, hidden):
    """Columns by weights, biases and output weights out of the hidden outputs."""
    return hidden * (UNIT_SLOPE + inputs)


def normal_equations(inputs, hidden):
    """Upper triangle of JᵀJ, and Jᵀe."""
    weights = hidden * (inputs + 2) + 1
    return weights * (weights + 1) / 2 + weights


def solution(inputs, hidden):
    """Cholesky's factor and the two triangular systems: an epoch, not a sample."""
    weights = hidden * (inputs + 2) + 1
    return weights**3 / 6 + weights**2


def epoch(inputs, hidden, rows):
    return (
        TANH_PASSES * forward(inputs, hidden)
        + jacobian(inputs, hidden)
        + normal_equations(inputs, hidden)
        + solution(inputs, hidden) / rows
    )


def nanoseconds(operations, limits):
    return 1e9 * operations / limits["per_second"]["fma"]
