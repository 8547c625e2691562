"""Looking again from near: which squares of a picture, and what is then said altogether."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.picture_reader.close_designs import ASYMMETRIC, sees_designs
from swifttailor.picture_reader.close_ups import CLOSE_UPS, LEAST_CM, sees
from swifttailor.picture_reader.units import VIEW_CM
from swifttailor.picture_reader.view import Square
from swifttailor.programs.read_parameter import ReadParameter

Answers = Mapping[str, NDArray[Any]]
"""What the network says of one picture, by the names of its outputs."""
_MARGIN = 0.15
"""Around what is looked at, as a share of its larger extent."""
_NEARER = 0.8
"""A square that is hardly smaller than that of the garment shows nothing new."""
_LEAST_CELLS, _LEAST_PIXELS = 3, 24
_LEAST = -20.0
"""Logarithm of the share of what is never so."""
SHARE = 0.6
"""What is seen from near counts so much, and what is seen of the whole garment the rest."""
DESIGN_SHARE = 0.8
"""The same for design parameters, which whole garments show worse."""


def close_squares(answers: Answers, part: int, square: Square, names: tuple[str, ...]) -> dict[int, Square]:
    """What of a garment is to be looked at from near.

    Args:
        answers: Of a look at it.
        part: Number of `labels.PARTS` on which it is worn.
        square: That was looked at.
        names: Of the close-ups that may be.

    Returns:
        By number of `CLOSE_UPS`: the square of the picture.
    """
    rows, columns = np.nonzero(answers["masks"][part] > 0)
    places = answers["worn_places"][:, rows, columns].T * 100.0
    kinds = answers["panel_kinds"][:, rows, columns].argmax(axis=0)
    left, top, side = square
    cell = side / answers["masks"].shape[-1]
    least = max(LEAST_CM * side * float(np.exp(answers["camera_view"][3])) / VIEW_CM, _LEAST_PIXELS)
    found = {}
    for number, close_up in enumerate(CLOSE_UPS):
        shown = close_up.points(places, kinds) if close_up.name in names else np.zeros(len(rows), bool)
        if np.count_nonzero(shown) < _LEAST_CELLS:
            continue
        low = np.array([columns[shown].min(), rows[shown].min()]) * cell
        high = np.array([columns[shown].max() + 1, rows[shown].max() + 1]) * cell
        new = round(max(float((high - low).max()) * (1 + 2 * _MARGIN), least))
        if new < _NEARER * side:
            across, down = np.round((low + high) / 2 - new / 2).astype(int)
            found[number] = left + int(across), top + int(down), new
    return found


def with_close_looks(
    answers: Answers, part: int, near: Mapping[int, Answers], share: float = SHARE
) -> dict[str, NDArray[Any]]:
    """What is said of a garment altogether.

    Args:
        answers: Of looks at all of it.
        part: Number of `labels.PARTS` on which it is worn.
        near: By number of `CLOSE_UPS`: of a look at that.
        share: Of what is seen from near, where it is.

    Returns:
        The answers; where close-ups tell something they count more.
    """
    numbers = list(near)
    altogether = dict(answers)
    if not numbers:
        return altogether
    cosines = np.array([near[k]["camera_view"][1] for k in numbers])
    told = sees(np.array(numbers), cosines)
    for name, telling in (
        ("statements", told.statements),
        ("has", told.measures),
        ("measures", told.measures),
        ("panels", told.panels),
        ("boxes", told.panels),
    ):
        value = np.array(answers[name], np.float64)
        of_each = np.stack([near[k][name][part] for k in numbers])
        telling = telling.astype(float)
        count = telling.sum(axis=0)
        shape = (len(numbers), -1) + (1,) * (of_each.ndim - 2)
        mean = (of_each * telling.reshape(shape)).sum(axis=0) / np.maximum(count, 1).reshape(shape[1:])
        seen = count > 0
        value[part, seen] = (1 - share) * value[part, seen] + share * mean[seen]
        altogether[name] = value
    return altogether


def with_close_designs(
    designs: NDArray[Any],
    part: int,
    near: Mapping[int, Answers],
    parameters: Sequence[ReadParameter],
    share: float = DESIGN_SHARE,
) -> NDArray[np.float64]:
    """What is said of design parameters altogether.

    Args:
        designs: (2, D, V) logits of looks at all of a garment.
        part: Number of the part of the body on which it is worn.
        near: By number of `CLOSE_UPS`: of a look at that, by a network that says the same parameters of it.
        parameters: D of them.
        share: Of what is seen from near, where it is.

    Returns:
        The logits; of garments that seem the same on both sides, the left one tells of both.
    """
    found = np.array(designs, np.float64)
    if not near:
        return found
    names = tuple(one.name for one in parameters)
    numbers = np.array(list(near))
    cosines = np.array([one["camera_view"][1] for one in near.values()])
    unlike = np.full(len(numbers), _are_unlike(found[part], parameters))
    telling = sees_designs(numbers, cosines, unlike, names).astype(float)
    logs = np.stack([_log_shares(one["designs"][part], parameters) for one in near.values()])
    count = telling.sum(axis=0)
    mean = (logs * telling[:, :, None]).sum(axis=0) / np.maximum(count, 1)[:, None]
    seen = count > 0
    whole = _log_shares(found[part], parameters)
    found[part, seen] = (1 - share) * whole[seen] + share * mean[seen]
    return found


def _log_shares(logits: NDArray[Any], parameters: Sequence[ReadParameter]) -> NDArray[np.float64]:
    """(D, V) logarithms of shares, the lowest where a parameter has no value."""
    there = np.arange(logits.shape[1]) < np.array([len(one.values) for one in parameters])[:, None]
    shown = np.where(there, logits.astype(np.float64), -np.inf)
    shown = shown - shown.max(axis=1, keepdims=True)
    shares = np.exp(shown)
    return np.maximum(shown - np.log(shares.sum(axis=1, keepdims=True)), _LEAST)


def _are_unlike(designs: NDArray[Any], parameters: Sequence[ReadParameter]) -> bool:
    """Whether the sides of a garment seem to differ, by logits (D, V)."""
    for one, logits in zip(parameters, designs, strict=True):
        if one.name == ASYMMETRIC:
            return one.values[int(logits[: len(one.values)].argmax())] is True
    return False
