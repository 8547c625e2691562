"""Whether what somebody in a photograph wears is a jacket or a coat, as those who sort photographs call it.

The sums of `laid_heads` have learnt it of clothes that nobody wears, and hold for a torso that is cut out: of
the people in streets nearly nine in ten of those that are said to wear one do.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.picture_reader.laid_heads import NAME, VIEWS, LaidHeads
from swifttailor.picture_reader.reading import PictureReading

OUTER = "Outwear"
"""What jackets and coats are called, blazers too: on somebody these two are not told apart."""
_OUTER = frozenset({OUTER, "Blazer"})
_NAMES = _OUTER | {
    "T-Shirt",
    "Longsleeve",
    "Shirt",
    "Polo",
    "Hoodie",
    "Undershirt",
    "Top",
    "Blouse",
}
"""Of tops alone: what is worn on the legs, and dresses, are told by other witnesses."""
_SHOWN = ("torso", "torso"), ("whole", "torso")
"""Views of somebody in the place of all of a picture of clothes and its middle; their mean counts."""
LEAST_OUTER = 0.5
"""What is less surely a jacket or coat is called nothing."""


def worn_name(names: LaidHeads, features: Mapping[str, NDArray[np.float32]]) -> str:
    """What a garment on the shoulders is called: `OUTER`, or nothing.

    Args:
        names: Tells what clothes are called.
        features: (F,) what its trunk makes of views of somebody (`worn_heads.features_of`), by their names.
    """
    if any(view not in features for views in _SHOWN for view in views):
        return ""
    shown: list[dict[str, Any]] = [
        {name: features[view][None] for name, view in zip(VIEWS, views, strict=True)} for views in _SHOWN
    ]
    logits = np.asarray([names.session.run([NAME], one)[0][0] for one in shown], np.float64).sum(axis=0) / 2
    tops = np.array([name in _NAMES for name in names.words[NAME]])
    outer = np.array([name in _OUTER for name in names.words[NAME]])
    share = np.logaddexp.reduce(logits[outer]) - np.logaddexp.reduce(logits[tops])
    return OUTER if np.exp(share) >= LEAST_OUTER else ""


def with_name(read: PictureReading, called: str) -> PictureReading:
    """What is read of somebody, whose garment on the shoulders is called so."""
    parts = tuple(replace(part, called=called) if part.part == "upper" else part for part in read.parts)
    return replace(read, parts=parts)
