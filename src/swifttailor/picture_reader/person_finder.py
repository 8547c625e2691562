"""Where in a photograph somebody is, and which pixels show them.

Two networks of others, BlazePose's (Bazarevsky et al. 2020, Google's MediaPipe), which have seen many people:
one finds people, one cuts the surest of them out. They know nothing of clothes.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.networks.model_file import ModelKind, open_model
from swifttailor.picture_reader.bare_limbs import BareLimbs
from swifttailor.picture_reader.body_joints import PLACES, SAID, BodyJoints
from swifttailor.picture_reader.cut_square import cut_square
from swifttailor.picture_reader.person_halves import View, chest_of, legs_of
from swifttailor.picture_reader.said import share_of
from swifttailor.picture_reader.squares import halves, mask_of
from swifttailor.picture_reader.view import Square

SHIPPED = Path(__file__).with_name("person_finder.zip")
DETECTOR, CUTTER = "detector", "cutter"
DETECT = ("pictures",), ("boxes", "scores")
CUT = ("pictures",), ("mask", "present", "joints")
KIND = ModelKind(
    "person finder",
    "swifttailor person finder 2",
    16 << 20,
    ({DETECTOR: DETECT, CUTTER: CUT},),
    archive=True,
)
_DETECTED, _CUT = 224, 256
"""Pixels along each side of what either network is shown."""
_STRIDES = (8, 2), (16, 2), (32, 6)
"""Of the detector: pixels from place to place, and boxes at each place."""
_HIPS, _REACH = 2, 3
"""Of the six points that are said of a person: the middle of the hips, and one as far from it as all of that
person reaches."""
_SAME = 0.1
"""Hips that are no farther apart, in sides of what the detector is shown, are the same person's."""
_AROUND = 1.25
"""Side of the square that is cut out of, in widths of the circle around the person."""
LEAST_SURE, _HARDLY, _SHOWN = 0.3, 0.6, 0.5
"""Of both networks: what is less sure is nobody. Where the detector is less sure, it looks nearer. Of the
mask: what is surer shows somebody."""
_LEAST_PIECE = 0.05
"""Pieces that are smaller than this share of the largest are left away."""


_EDGE = 0.4
"""Of the mask: over how much of it the edge of somebody who is cut out fades."""
_SPACE, _AT_EDGE = 0.06, 3
"""Around somebody, in their longer sides; and from how few pixels to the edge somebody reaches it."""


@dataclass(frozen=True, eq=False)
class Person:
    """Somebody in a picture."""

    certainty: float
    """That somebody is there."""
    mask: NDArray[np.float32]
    """(h, w) how surely each pixel shows them, 0 to 1; more than 0.5 somewhere."""
    hips: tuple[float, float]
    """x and y of the middle of their hips, pixels; where they are beyond the picture, outside of it."""
    reach: float
    """From there to the farthest point of them, pixels."""
    joints: BodyJoints
    """Where they are seen, and where they would be."""

    def cut_out(self, pixels: Pixels) -> View:
        """The picture (h, w, 3) with nothing but white around them, and a square that they fill."""
        return before_white(pixels, self.mask), square_around(self.mask)

    def chest(self, cut_out: Pixels) -> View | None:
        """A view from the head to above the hips of what `cut_out` gives; None where hardly any is there."""
        return chest_of(cut_out, self.mask > _SHOWN, self.hips, self.reach)

    def limbs(self, pixels: Pixels) -> BareLimbs:
        """How bare their arms and legs are in the picture (h, w, 3)."""
        return BareLimbs.of(pixels, self.mask > _SHOWN, self.joints)

    def legs(self, cut_out: Pixels) -> tuple[View, ...]:
        """Views from the waist down of what `cut_out` gives; none where no legs are seen."""
        return legs_of(cut_out, self.mask > _SHOWN, self.hips, self.reach)


@dataclass(frozen=True, eq=False)
class PersonFinder:
    """Finds people in photographs."""

    detector: Any
    """Of onnxruntime."""
    cutter: Any

    @staticmethod
    def load(weights: Path | str | None = None, *, threads: int = 1) -> PersonFinder:
        """Opens a model file.

        Args:
            weights: File; the one that comes with the package when None.
            threads: CPU cores for the networks.

        Raises:
            InputError: There is no such file, or it is damaged or another.
        """
        model = open_model(SHIPPED if weights is None else weights, KIND, threads=threads)
        shapes = {name: model.shape_given(name, "pictures") for name in (DETECTOR, CUTTER)}
        sizes = {DETECTOR: _DETECTED, CUTTER: _CUT}
        model.require(
            {f"what the {name} is shown": (shapes[name], [1, 3, n, n]) for name, n in sizes.items()}
            | {
                "what it says of boxes": (model.shape_made(DETECTOR, "boxes"), [1, len(_places()), 12]),
                "what it says of their certainty": (
                    model.shape_made(DETECTOR, "scores"),
                    [1, len(_places()), 1],
                ),
                "its mask": (model.shape_made(CUTTER, "mask"), [1, 1, _CUT, _CUT]),
                "its joints": (model.shape_made(CUTTER, "joints"), [1, PLACES * SAID]),
            }
        )
        return PersonFinder(model.sessions[DETECTOR], model.sessions[CUTTER])

    def find(self, pixels: Pixels, *, small: bool = True) -> Person | None:
        """The surest person of a picture; None where nobody is found.

        Args:
            pixels: (h, w, 3) sRGB.
            small: Whether somebody small is looked for in parts of it, where hardly anybody is seen in all
                of it.
        """
        height, width = pixels.shape[:2]
        side = max(height, width)
        found = self._detected(pixels, ((width - side) // 2, (height - side) // 2, side))
        if small and (found is None or found[0] < _HARDLY):
            parts = (self._detected(pixels, square) for square in halves((height, width)))
            found = max((one for one in (found, *parts) if one is not None), default=None)
        if found is None:
            return None
        certain, square = found
        answers = self.cutter.run(list(CUT[1]), {"pictures": _batch(pixels, square, _CUT)})
        certain = min(certain, float(answers[1].ravel()[0]))
        mask = largest_piece(mask_of(share_of(answers[0][0, 0]), square, (height, width)))
        if certain < LEAST_SURE or mask is None:
            return None
        left, top, side = square
        joints = BodyJoints.of(answers[2].reshape(PLACES, SAID), square, _CUT)
        return Person(certain, mask, (left + side / 2, top + side / 2), side / 2 / _AROUND, joints)

    def _detected(self, pixels: Pixels, square: Square) -> tuple[float, Square] | None:
        """How sure the surest person in a square is, and a square around all of that person."""
        answers = self.detector.run(list(DETECT[1]), {"pictures": 2 * _batch(pixels, square, _DETECTED) - 1})
        scores = share_of(np.clip(answers[1][0, :, 0], -100, 100))
        best = int(scores.argmax())
        if scores[best] < LEAST_SURE:
            return None
        # Places near each other mean the same person; their mean is steadier than the surest alone.
        points = answers[0][0].reshape(-1, 6, 2) / _DETECTED + _places()[:, None]
        apart = np.abs(points[:, _HIPS] - points[best, _HIPS]).max(axis=1)
        near = (scores > LEAST_SURE) & (apart < _SAME)
        hips, reach = np.average(points[near], axis=0, weights=scores[near])[[_HIPS, _REACH]]
        left, top, side = square
        new = max(round(2 * _AROUND * side * float(np.hypot(*(reach - hips)))), 1)
        x, y = left + hips[0] * side, top + hips[1] * side
        return float(scores[best]), (round(x - new / 2), round(y - new / 2), new)


def before_white(pixels: Pixels, mask: NDArray[np.float32]) -> Pixels:
    """(h, w, 3): what a mask (h, w) shows of a picture, before white."""
    cover = np.clip((mask - _SHOWN) / _EDGE + 0.5, 0, 1)[:, :, None]
    return np.round(cover * pixels + (1 - cover) * 255).astype(np.uint8)


def square_around(mask: NDArray[np.float32]) -> Square:
    """A square with a little space around somebody; none below whoever is cut off by the picture's edge."""
    shown = mask > _SHOWN
    rows, columns = np.flatnonzero(shown.any(axis=1)), np.flatnonzero(shown.any(axis=0))
    high, wide = rows[-1] + 1 - rows[0], columns[-1] + 1 - columns[0]
    space = round(_SPACE * max(high, wide))
    below = space if rows[-1] + _AT_EDGE < len(mask) else 0
    side = int(max(high + space + below, wide + 2 * space))
    left = int(columns[0] + columns[-1] + 1 - side) // 2
    top = int(rows[0] - space + rows[-1] + 1 + below - side) // 2
    return left, top, side


def largest_piece(mask: NDArray[np.float32]) -> NDArray[np.float32] | None:
    """(h, w) the mask without pieces that are far smaller than the largest; None where nothing is left."""
    from scipy import ndimage

    labels, count = ndimage.label(mask > _SHOWN)
    if not count:
        return None
    sizes = np.bincount(labels.ravel())[1:]
    small = np.flatnonzero(sizes < _LEAST_PIECE * sizes.max()) + 1
    return np.where(np.isin(labels, small), np.float32(0), mask)


def _batch(pixels: Pixels, square: Square, size: int) -> NDArray[np.float32]:
    """(1, 3, size, size), 0 to 1."""
    shown = cut_square(pixels, square, size)
    return np.ascontiguousarray(shown.transpose(2, 0, 1)[None]).astype(np.float32) / np.float32(255)


@cache
def _places() -> NDArray[np.float32]:
    """(n, 2) where the detector looks for people: x and y, in sides of what it is shown."""
    found = []
    for stride, boxes in _STRIDES:
        count = _DETECTED // stride
        y, x = np.mgrid[0:count, 0:count].reshape(2, -1)
        found.append(np.repeat((np.stack([x, y], axis=1) + 0.5) / count, boxes, axis=0))
    return np.concatenate(found).astype(np.float32)
