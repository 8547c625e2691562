"""Logistic regressions of what a network makes of photographs, where several words may be true of one."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from swifttailor.arrays import Array

LEAST_SPREAD = 0.05
"""Of a sign, for its unit: what hardly differs is not blown up."""


def fitted(signs: Array, accepted: NDArray[np.bool_], ridge: float) -> Array:
    """Weights (n + 1, words) of a multinomial logistic regression, its summands last.

    Args:
        signs: (photographs, n).
        accepted: (photographs, words) which words may be true; the sum of their shares is to be large.
        ridge: Of the weights, for signs of unit length.
    """
    middle, spread = signs.mean(axis=0), (signs.std(axis=0) + LEAST_SPREAD) * np.sqrt(signs.shape[1])
    extended = np.column_stack([(signs - middle) / spread, np.ones(len(signs))])
    shape = extended.shape[1], accepted.shape[1]

    def loss(flat: Array) -> tuple[float, Array]:
        weights = flat.reshape(shape)
        logits = extended @ weights
        shares = np.exp(logits - np.logaddexp.reduce(logits, axis=1, keepdims=True))
        right = (shares * accepted).sum(axis=1)
        slope = extended.T @ (shares - shares * accepted / right[:, None])
        slope[:-1] += ridge * weights[:-1]
        return float(-np.log(right).sum() + ridge / 2 * (weights[:-1] ** 2).sum()), slope.ravel()

    best = minimize(loss, np.zeros(shape).ravel(), jac=True, method="L-BFGS-B", options={"maxiter": 500})
    weights = best.x.reshape(shape)
    weights[-1] -= (middle / spread) @ weights[:-1]
    weights[:-1] /= spread[:, None]
    return np.asarray(weights)
