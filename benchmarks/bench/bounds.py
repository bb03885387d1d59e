# SPDX-License-Identifier: Apache-2.0
"""The least time that the arithmetic of a network can take, from operation counts and the measured peak.

The counts are operations of the multiplication ports per sample, for a network of I inputs, H units and D = H (I + 2)
+ 1 weights. A fused product counts once, and so does a division, although it takes longer. Loads, stores and
additions have ports of their own and count as free, and so do products with a column of ones. The counts are those of
our kernels (proofmass/numeric/network/*-inl.hpp). A JᵀJ of whole columns would take D (D + 1) / 2; ours uses products
of slopes with products of inputs.
"""

TANH = 11  # two bounds, six of the polynomial, one of the table, m; the quotient
FINE_TANH = 13  # in training: one more for the polynomial and one for the table
UNIT_OUTPUT = 1  # v_j h_j, summed; the argument b_j + w_j . x takes I
RESIDUAL = 2  # less the padding's; its square, summed
UNIT_SLOPE = 1  # 1 - h_j²; output weights multiply the sums
TANH_PASSES = 1  # an epoch needs tanh at its trial point alone: the Jacobian is at the last one accepted


def forward(inputs, hidden, tanh=TANH):
    return hidden * (inputs + tanh + UNIT_OUTPUT) + RESIDUAL


def jacobian(inputs, hidden):
    """Slopes of the units, and products of two inputs."""
    return hidden * UNIT_SLOPE + inputs * (inputs + 1) / 2


def normal_equations(inputs, hidden):
    """A triangle of JᵀJ, and Jᵀe."""
    slopes = hidden * (hidden + 1) / 2 * (1 + inputs * (inputs + 3) / 2)
    weights = hidden * inputs * (1 + hidden + 1)
    biases = hidden * (hidden + 1)
    outputs = (hidden + 1) * (hidden + 2) / 2
    return slopes + weights + biases + outputs


def solution(inputs, hidden):
    """Cholesky factor and the two triangular systems: per epoch, not per sample."""
    weights = hidden * (inputs + 2) + 1
    return weights**3 / 6 + weights**2


def kernels(inputs, hidden):
    trials = TANH_PASSES * forward(inputs, hidden, FINE_TANH)
    return trials + jacobian(inputs, hidden) + normal_equations(inputs, hidden)


def epoch(inputs, hidden, rows):
    return kernels(inputs, hidden) + solution(inputs, hidden) / rows


def nanoseconds(operations, limits):
    return 1e9 * operations / limits["per_second"]["fma"]
