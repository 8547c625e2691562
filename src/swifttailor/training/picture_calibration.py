"""How sure a picture reader is and how sure it should be: one line for each claim from logit to logit."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.picture_reader.labels import statement_labels
from swifttailor.picture_reader.truth import FALSE, TRUE

_PRIOR = 20.0
"""How many statements the belief that nothing has to change is worth."""
_ROUNDS, _NO_STEP = 40, 1e-6
_BINS = 10


def fit_scales(logits: NDArray[Any], judged: NDArray[Any]) -> NDArray[np.float64]:
    """Factor and summand for the logits of each statement, the same for all words of a claim (Platt 1999).

    Args:
        logits: (n, S) as the network says them of pictures that it has not learnt from.
        judged: (n, S) `truth.FALSE`, `TRUE` or `UNCLEAR`, which does not count.

    Returns:
        (S, 2): with them the logits are as sure as they are right.
    """
    claims = np.array([claim for claim, _ in statement_labels()])
    scales = np.tile(np.array([1.0, 0.0]), (len(claims), 1))
    for claim in dict.fromkeys(claims):
        columns = np.flatnonzero(claims == claim)
        clear = (judged[:, columns] == TRUE) | (judged[:, columns] == FALSE)
        scales[columns] = _line(logits[:, columns][clear], judged[:, columns][clear] == TRUE)
    return scales


def _line(logits: NDArray[Any], true: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Newton's steps on the cross entropy, held near (1, 0); each is shortened until it pays."""
    line, usual = np.array([1.0, 0.0]), np.array([1.0, 0.0])
    points = np.stack([logits.astype(np.float64), np.ones(len(logits))], axis=1)

    def loss(at: NDArray[np.float64]) -> float:
        said = points @ at
        return float((np.logaddexp(0, said) - true * said).sum() + _PRIOR / 2 * ((at - usual) ** 2).sum())

    for _ in range(_ROUNDS):
        share = 1 / (1 + np.exp(-np.clip(points @ line, -40, 40)))
        gradient = points.T @ (share - true) + _PRIOR * (line - usual)
        curve = (points * (share * (1 - share))[:, None]).T @ points + _PRIOR * np.eye(2)
        step, before = np.linalg.solve(curve, gradient), loss(line)
        while np.abs(step).max() > _NO_STEP and loss(line - step) > before:
            step = step / 2
        if np.abs(step).max() <= _NO_STEP:
            break
        line = line - step
    return line


def calibration_error(certain: NDArray[Any], judged: NDArray[Any]) -> float:
    """By how much certainties differ from the shares that are true, on average (Naeini et al. 2015).

    Args:
        certain: (n,) 0 to 1.
        judged: (n,) whether true.
    """
    which = np.minimum((certain * _BINS).astype(int), _BINS - 1)
    apart = [
        abs(certain[which == k].mean() - judged[which == k].mean()) * (which == k).sum()
        for k in range(_BINS)
        if (which == k).any()
    ]
    return float(sum(apart) / max(len(certain), 1))
