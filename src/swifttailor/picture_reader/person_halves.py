"""What is looked at from nearer of somebody cut out of a photograph: the chest, and all below the waist.

In all of a picture a neckline is a few pixels, and dark trousers below a dark coat are none at all.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.picture_reader.labels import PARTS, statement_labels
from swifttailor.picture_reader.said import parts_present, share_of
from swifttailor.picture_reader.view import Square

View = tuple[Pixels, Square]
"""Pixels (h, w, 3) of all of a picture, and a square of it."""
Answers = dict[str, Any]
"""Of a picture reader's network, by name; of parts first."""
UPPER, LOWER = (PARTS.index(name) for name in ("upper", "lower"))
_CHEST, _WAIST = 0.2, 0.35
"""How far above the hips the square of the chest ends, and that of the legs begins, in the distance from the
hips to the farthest point of somebody."""
_LEAST_BELOW = 0.1
"""Of somebody, below the hips; whose legs are less is shown to the hips, or sits."""
_LEAST_CHEST = 0.15
"""Height of what is shown of the chest, in the same distance."""
_SPACE, _ABOVE = 1.06, 0.03
"""Side of the square of the legs, in their longer side, and how much of it is above them."""
_CHEST_SPACE = 1.04
"""Side of the square of the chest, in its longer side; all of the space is above and beside it."""
NECK_SHARE, LEGS_SHARE = 0.5, 0.3
"""How much looks from nearer count, where the looks at somebody whole see the same."""
_NECK = "neckline", "left_neckline", "right_neckline"
_BY_PART = "present", "statements", "has", "measures", "panels", "boxes", "designs"


def chest_of(
    cut_out: Pixels, mask: NDArray[np.bool_], hips: tuple[float, float], reach: float
) -> View | None:
    """A view of somebody from the head to above the hips; None where hardly anything is there.

    Args:
        cut_out: (h, w, 3) the picture with nothing around them.
        mask: (h, w) which pixels show them.
        hips: x and y of their middle, pixels.
        reach: From there to the farthest point of them, pixels.
    """
    top = int(np.flatnonzero(mask.any(axis=1))[0])
    bottom = min(int(hips[1] - _CHEST * reach), len(mask))
    if bottom - top < _LEAST_CHEST * reach:
        return None
    columns = np.flatnonzero(mask[:bottom].any(axis=0))
    side = int(max(bottom - top, columns[-1] + 1 - columns[0]) * _CHEST_SPACE)
    return cut_out, (int(columns[0] + columns[-1] + 1 - side) // 2, bottom - side, side)


def legs_of(
    cut_out: Pixels, mask: NDArray[np.bool_], hips: tuple[float, float], reach: float
) -> tuple[View, ...]:
    """Two views of somebody from the waist down, with and without what is above; none where no legs are seen.

    Args:
        cut_out: (h, w, 3) the picture with nothing around them.
        mask: (h, w) which pixels show them.
        hips: x and y of their middle, pixels.
        reach: From there to the farthest point of them, pixels.
    """
    if mask[max(int(hips[1]), 0) :].sum() < _LEAST_BELOW * mask.sum():
        return ()
    below = mask.copy()
    below[: max(int(hips[1] - _WAIST * reach), 0)] = False
    rows, columns = np.flatnonzero(below.any(axis=1)), np.flatnonzero(below.any(axis=0))
    high, wide = rows[-1] + 1 - rows[0], columns[-1] + 1 - columns[0]
    side = int(max(high, wide) * _SPACE)
    top = rows[0] - round(_ABOVE * side) if high >= wide else (rows[0] + rows[-1] + 1 - side) // 2
    square = int(columns[0] + columns[-1] + 1 - side) // 2, int(top), side
    alone = cut_out.copy()
    alone[: rows[0]] = 255
    return (alone, square), (cut_out, square)


def with_neck(answers: Answers, chest: Answers) -> Answers:
    """What is said of somebody, with the neckline that is seen from nearer."""
    which = [k for k, (claim, _) in enumerate(statement_labels()) if claim in _NECK]
    value = np.array(answers["statements"], np.float64)
    nearer = chest["statements"][UPPER, which]
    value[UPPER, which] = (1 - NECK_SHARE) * value[UPPER, which] + NECK_SHARE * nearer
    return answers | {"statements": value}


def with_legs(
    whole: tuple[Square, Answers], legs: tuple[Square, Answers] | None, below: float | None = None
) -> dict[int, tuple[Square, Answers]]:
    """By number of the part: a square and what is said of what is worn there.

    What covers the legs of somebody in a dress is that dress. But a coat to the knees is taken for one, too:
    trousers below it are another garment. Where things are is seen better from nearer.

    Args:
        whole: A square around somebody, and what is said of it.
        legs: The same from nearer; None where they are not looked at.
        below: Logit of whether anything apart is worn on the legs, where more than these looks tells that.
    """
    _, answers = whole
    seen = dict.fromkeys(parts_present(answers), whole)
    if below is not None:
        upper = {part: one for part, one in seen.items() if part != LOWER}
        if below <= 0:
            return upper
        square, told = _nearer_of(whole, legs, both=LOWER in seen) if legs else whole
        present = np.array(told["present"], np.float64)
        present[LOWER] = below
        return upper | {LOWER: (square, told | {"present": present})}
    if legs is None:
        return seen
    _, nearer = legs
    covered = UPPER in seen and _covers_legs(answers, nearer)
    if covered or LOWER not in parts_present(nearer):
        return seen
    return seen | {LOWER: _nearer_of(whole, legs, both=LOWER in seen)}


def _nearer_of(
    whole: tuple[Square, Answers], legs: tuple[Square, Answers], *, both: bool
) -> tuple[Square, Answers]:
    """What is seen of legs from nearer, or of both looks."""
    if not both:
        return legs
    (_, answers), (square, nearer) = whole, legs
    mean = dict(nearer)
    for name in _BY_PART:
        if name in answers:
            value = np.array(nearer[name], np.float64)
            value[LOWER] = (1 - LEGS_SHARE) * answers[name][LOWER] + LEGS_SHARE * value[LOWER]
            mean[name] = value
    return square, mean


def _kinds(answers: Answers, part: int) -> dict[str, float]:
    said = share_of(answers["statements"][part])
    return {word: float(said[k]) for k, (claim, word) in enumerate(statement_labels()) if claim == "kind"}


def _covers_legs(answers: Answers, nearer: Answers) -> bool:
    """Whether what is worn on the legs belongs to what is worn above them."""
    kinds, below = _kinds(answers, UPPER), _kinds(nearer, LOWER)
    are_trousers = below["trousers"] == max(below.values()) and below["trousers"] > 0.5
    is_coat = are_trousers and kinds["dress"] > kinds["jumpsuit"]
    return not is_coat and kinds["dress"] + kinds["jumpsuit"] > 0.5


def mean_of(looks: Sequence[Answers]) -> Answers:
    """The mean of what is said in several looks."""
    return {name: np.mean([look[name] for look in looks], axis=0) for name in looks[0]}
