"""What a network that has learnt nothing but photographs tells of what somebody in one wears.

The networks that read pictures have learnt from drawings, and forgotten some of what photographs look like.
Here a trunk is left as photographs made it (EfficientNet-Lite2, Tan and Le 2019, of ImageNet); what is asked
of it are a few sums, learnt from photographs by shops (`scripts/train_worn_heads_torch.py`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Array, Pixels
from swifttailor.errors import InputError
from swifttailor.networks.model_file import ModelKind, open_model
from swifttailor.picture_reader.body_joints import ANKLES, HIPS, KNEES, LEAST_SEEN, SHOULDERS, BodyJoints
from swifttailor.picture_reader.cut_square import cut_square
from swifttailor.picture_reader.person_halves import View
from swifttailor.picture_reader.view import Square

SHIPPED = Path(__file__).with_name("worn_heads.zip")
TRUNK = "trunk"
TRUNK_SIGNATURE = ("pictures",), ("features",)
HEADS: Mapping[str, tuple[str, ...]] = {
    "collar": ("neck",),
    "sleeves": ("torso", "whole"),
    "kind": ("legs",),
    "leg_hem": ("legs",),
}
"""Of each claim the views that tell it. ``kind`` is that of what is worn on the legs."""
COLLARED = "some"
"""What the head of collars says instead of which: shops show too few of each."""
SIZE = 192
"""Pixels along each side of what the trunk is shown."""
KIND = ModelKind(
    "network for photographs",
    "swifttailor worn heads 1",
    16 << 20,
    ({TRUNK: TRUNK_SIGNATURE} | {name: (views, ("logits",)) for name, views in HEADS.items()},),
    archive=True,
)
_NECK_WIDE, _NECK_HIGH, _NECK_DOWN = 1.5, 0.75, 0.08
"""Side of the square around a neck, in widths of the shoulders, but at least in heights of the torso; and how
far below the shoulders its middle is."""
_LEAST_WIDE = 0.4
"""Shoulders of somebody seen from aside are as wide as that of the height of the torso."""
_TORSO, _LEGS, _LEGS_SPACE = 1.7, 2.2, 1.15
"""Sides of the squares around torso and legs, in heights of the torso; of legs also in their own height."""


@dataclass(frozen=True, eq=False)
class WornHeads:
    """Tells a few claims of somebody in a photograph."""

    trunk: Any
    """Of onnxruntime."""
    heads: Mapping[str, Any]
    """By claim."""
    words: Mapping[str, tuple[str, ...]]
    """Of each claim, in the order of what its head says."""

    @staticmethod
    def load(weights: Path | str | None = None, *, threads: int = 1) -> WornHeads:
        """Opens a model file.

        Args:
            weights: File; the one that comes with the package when None.
            threads: CPU cores for the networks.

        Raises:
            InputError: There is no such file, or it is damaged or another.
        """
        model = open_model(SHIPPED if weights is None else weights, KIND, threads=threads)
        with model.says("the words of its claims"):
            words = {name: tuple(map(str, model.about["card"]["words"][name])) for name in HEADS}
            if any(len(set(some)) < max(len(some), 2) for some in words.values()):
                raise InputError(f"its words are {words}")
        model.require(
            {"what it is shown": (model.shape_given(TRUNK, "pictures")[1:], [3, SIZE, SIZE])}
            | {
                f"what it says of {name}": (model.shape_made(name, "logits"), [1, len(some)])
                for name, some in words.items()
            }
        )
        heads = {name: session for name, session in model.sessions.items() if name != TRUNK}
        return WornHeads(model.sessions[TRUNK], heads, words)

    def told(self, views: Mapping[str, View]) -> dict[str, dict[str, float]]:
        """The logarithm of the share of each word, of each claim whose views are there."""
        return self.told_of(self.features(views))

    def features(self, views: Mapping[str, View]) -> dict[str, NDArray[np.float32]]:
        """(F,) what the trunk makes of each view."""
        return {name: features_of(self.trunk, *view) for name, view in views.items()}

    def told_of(self, features: Mapping[str, NDArray[np.float32]]) -> dict[str, dict[str, float]]:
        """What `told` says, of features of the same views."""
        found = {}
        for claim, needed in HEADS.items():
            if all(name in features for name in needed):
                given = {name: features[name][None] for name in needed}
                logits = self.heads[claim].run(["logits"], given)[0][0].astype(np.float64)
                shares = logits - np.logaddexp.reduce(logits)
                found[claim] = dict(zip(self.words[claim], shares.tolist(), strict=True))
        return found


def features_of(trunk: Any, pixels: Pixels, square: Square, *, mirrored: bool = True) -> NDArray[np.float32]:
    """(F,) what the trunk makes of a square of a picture and of its mirror image, their mean.

    Args:
        trunk: Of onnxruntime.
        pixels: (h, w, 3) sRGB.
        square: Of it.
        mirrored: Whether the mirror image counts as well, which takes twice as long.
    """
    shown = cut_square(pixels, square, SIZE).astype(np.float32).transpose(2, 0, 1)[None] / np.float32(255)
    both = np.ascontiguousarray(np.concatenate([shown, shown[..., ::-1]]) if mirrored else shown)
    features: NDArray[np.float32] = trunk.run(["features"], {"pictures": both})[0]
    return features.mean(axis=0)


def views_of(pixels: Pixels, cut_out: View, joints: BodyJoints) -> dict[str, View]:
    """What is looked at of somebody, by name.

    Args:
        pixels: (h, w, 3) all of the picture.
        cut_out: The same with nothing but white around them, and a square that they fill.
        joints: Of them.
    """
    alone, whole = cut_out
    neck, seat = joints.middle(SHOULDERS), joints.middle(HIPS)
    left, right = (joints.places[k] for k in SHOULDERS)
    high = float(np.hypot(*(seat - neck)))
    wide = max(float(np.hypot(*(left - right))), _LEAST_WIDE * high)
    side = max(_NECK_WIDE * wide, _NECK_HIGH * high)
    views = {
        "whole": (alone, whole),
        "torso": (alone, _around((neck + seat) / 2, _TORSO * high)),
        "neck": (pixels, _around(neck + _NECK_DOWN * (seat - neck), side)),
    }
    if joints.surest(KNEES) >= LEAST_SEEN:
        ankles = joints.middle(ANKLES)
        side = max(_LEGS * high, _LEGS_SPACE * abs(float(ankles[1] - seat[1])))
        views["legs"] = alone, _around((seat + ankles) / 2, side)
    return views


def _around(middle: Array, side: float) -> Square:
    return int(middle[0] - side / 2), int(middle[1] - side / 2), max(int(side), 1)
