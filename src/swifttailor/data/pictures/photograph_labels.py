"""What is true of photographs of clothes of which only the kind is known: a T-shirt, a skirt, a hoodie.

The kinds are those of the clothing dataset of Alexey Grigorev and 32 others (CC0,
https://github.com/alexeygrigorev/clothing-dataset). Of each is said what nearly all such clothes are, and
nothing of the rest.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from swifttailor.describing.claims import CLAIM_TYPES
from swifttailor.picture_reader.labels import PARTS, statement_labels
from swifttailor.picture_reader.truth import FALSE, TRUE, UNCLEAR

_OF_A_PORTRAIT = frozenset({"collar", "hood", "neckline", "shoulders", "straps", "sides"})
Words = Mapping[str, tuple[str, ...]]
"""Some words of some claims."""


@dataclass(frozen=True)
class PhotographKind:
    """A kind of clothes and what is true of nearly all of that kind."""

    part: str
    """Of `PARTS`."""
    are: Words = field(default_factory=dict)
    """What they are; of each claim all words are false that are neither here nor in `may_be`."""
    may_be: Words = field(default_factory=dict)
    """What some of them are."""
    middle: float = 113.0
    """Level of the middle of one on the standing default body, cm, by our estimate."""
    seen: float = 90.0
    """Centimetres from the bottom to the top of a picture that one fills."""

    def statements(self) -> NDArray[np.uint8]:
        """(S,) `FALSE`, `TRUE` or `UNCLEAR`, as `Truth` has them."""
        found = []
        for claim, word in statement_labels():
            told = claim in self.are or claim in self.may_be
            true = word in self.are.get(claim, ())
            found.append(
                TRUE if true else UNCLEAR if not told or word in self.may_be.get(claim, ()) else FALSE
            )
        return np.array(found, np.uint8)

    def likely(self, claim: str, word: str) -> bool:
        """Whether a word is not false of this kind."""
        told = claim in self.are or claim in self.may_be
        return not told or word in self.are.get(claim, ()) or word in self.may_be.get(claim, ())

    def of_a_portrait(self) -> PhotographKind:
        """What is told of it where no more than head and shoulders are seen."""
        are, may_be = (
            {claim: some for claim, some in words.items() if claim in _OF_A_PORTRAIT}
            for words in (self.are, self.may_be)
        )
        return PhotographKind(self.part, are, may_be, self.middle, self.seen)

    def __post_init__(self) -> None:
        assert self.part in PARTS
        for words in (self.are, self.may_be):
            for claim, some in words.items():
                assert set(some) <= set(CLAIM_TYPES[claim].words), (claim, some)


_LONG = ("three-quarter", "long", "extra-long")
_NOT_BARE = {"shoulders": ("both",)}
_ROUND = ("round", "crew", "scoop", "boat", "v")
_TOP = {"kind": ("top", "tunic")}


def _top(are: Words, may_be: Words, **more: float) -> PhotographKind:
    return PhotographKind("upper", {"sides": ("alike",), **are}, {**_TOP, **may_be}, **more)


def _lower(are: Words, may_be: Words, *, middle: float, seen: float) -> PhotographKind:
    return PhotographKind("lower", {"sides": ("alike",), **are}, may_be, middle, seen)


KINDS: Mapping[str, PhotographKind] = MappingProxyType(
    {
        "T-Shirt": _top(
            {"hood": ("none",), "collar": ("none",), "cuffs": ("none",), **_NOT_BARE},
            {"sleeves": ("cap", "short", "elbow"), "neckline": _ROUND},
        ),
        "Longsleeve": _top(
            {"sleeves": ("long",), **_NOT_BARE},
            {"sleeves": _LONG, "collar": ("none", "stand", "turtleneck"), "neckline": _ROUND},
        ),
        "Shirt": _top(
            {"hood": ("none",), **_NOT_BARE},
            {"sleeves": ("none", "cap", "short", "elbow", *_LONG), "collar": ("stand", "lapel")},
        ),
        "Polo": _top(
            {"hood": ("none",), "sleeves": ("short",), **_NOT_BARE},
            {"sleeves": ("short", "elbow"), "collar": ("stand", "lapel")},
        ),
        "Outwear": _top(
            {"sleeves": ("long",), **_NOT_BARE},
            {"sleeves": _LONG, "kind": ("top", "tunic", "dress"), "hood": ("none", "hood")},
            middle=108.0,
            seen=105.0,
        ),
        "Blazer": _top(
            {"sleeves": ("long",), "collar": ("lapel",), "hood": ("none",), **_NOT_BARE},
            {"sleeves": _LONG},
        ),
        "Hoodie": _top(
            {"sleeves": ("long",), "hood": ("hood",), **_NOT_BARE}, {"sleeves": _LONG}, middle=118.0
        ),
        "Undershirt": _top(
            {"sleeves": ("none",), "hood": ("none",), "collar": ("none",)},
            {"shoulders": ("both",)},
        ),
        "Top": _top({"hood": ("none",)}, {}),
        "Blouse": _top({"hood": ("none",)}, {}),
        "Dress": PhotographKind(
            "upper", {"kind": ("dress",), "sides": ("alike",), "hood": ("none",)}, {}, 95.0, 120.0
        ),
        "Pants": _lower(
            {"kind": ("trousers",)},
            {"leg_hem": ("calf", "ankle", "full"), "leg_cuffs": ("none", "band", "gathered", "deep")},
            middle=54.0,
            seen=120.0,
        ),
        "Shorts": _lower(
            {"kind": ("shorts",)},
            {"kind": ("trousers",), "leg_hem": ("very short", "mid-thigh", "thigh", "knee")},
            middle=82.0,
            seen=65.0,
        ),
        "Skirt": _lower({"kind": ("skirt",)}, {}, middle=80.0, seen=75.0),
    }
)
"""By the label that photographs have."""
NOTHING = ("Hat", "Shoes", "People")
"""Labels of photographs that show a reader of laid garments nothing to read: what cannot be made, and what
somebody wears."""
