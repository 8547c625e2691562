"""Wordings: bits of language, each with the claims it makes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Literal

from swifttailor.describing.claims import CLAIM_TYPES, Claim

Form = Literal["head", "adjective", "feature", "tag", "sentence"]
"""head: what the garment is called. adjective: before the head. feature: after "with". tag: stands alone.
sentence: a whole one, whose subject is {it}."""
Dialect = Literal["uk", "us"]
ANY_NUMBER = "?"


@dataclass(frozen=True)
class Wording:
    """Synonyms for the same claims."""

    form: Form
    topics: frozenset[str]
    """What it speaks of; a caption speaks of nothing twice."""
    needs: tuple[Claim, ...]
    """The claims that it makes, numbers left out."""
    numbers: tuple[str, ...]
    """Names of the measures that it states; the texts hold {name}."""
    texts: tuple[str, ...]
    weight: float = 1.0
    plural: bool = False
    """Whether a head is a plural, such as trousers."""
    kinds: frozenset[str] = frozenset()
    """Kinds of garments it can be said of; empty for any."""
    avoids: frozenset[Claim] = frozenset()
    """Claims beside which it would be odd, though not wrong."""


def wording(
    form: Form,
    needs: str,
    *texts: str,
    topics: str = "",
    weight: float = 1.0,
    plural: bool = False,
    kinds: str = "",
    avoids: str = "",
) -> Wording:
    """Writes a wording down briefly.

    Args:
        form: Where it stands in a sentence.
        needs: Claims such as ``"kind=dress sleeve_cm=?"``; ``_`` in a value stands for a space and the
            question mark for any number, which the texts hold as ``{sleeve_cm}``, or ``{sleeve_cm-}``
            before a noun.
        texts: Synonyms. One that ends in ``@uk`` or ``@us`` is used in that dialect only.
        topics: What it speaks of besides the names of its claims.
        weight: How often it is used, compared with others.
        plural: Whether a head is a plural.
        kinds: Kinds of garments it can be said of, without claiming the kind; empty for any.
        avoids: Claims beside which it would be odd, written as in `needs`.
    """
    claims, numbers = [], []
    for need in needs.split():
        name, value = need.split("=")
        if value == ANY_NUMBER:
            assert CLAIM_TYPES[name].measure is not None, name
            numbers.append(name)
        else:
            claims.append(_claim(need))
    about = {TOPIC.get(n, n) for n in (*(c.name for c in claims), *numbers)} | set(topics.split())
    if form != "head":
        about.discard("kind")
    return Wording(
        form,
        frozenset(about),
        tuple(claims),
        tuple(numbers),
        texts,
        weight,
        plural,
        frozenset(kinds.split()),
        frozenset(_claim(each) for each in avoids.split()),
    )


adjective = partial(wording, "adjective")
feature = partial(wording, "feature")
sentence = partial(wording, "sentence")
tag = partial(wording, "tag")


def _claim(text: str) -> Claim:
    name, value = text.split("=")
    return Claim(name, value.replace("_", " "))


TOPIC: dict[str, str] = {
    "skirt_hem": "length",
    "top_hem": "length",
    "leg_hem": "length",
    "length_cm": "length",
    "left_sleeve": "sleeves",
    "right_sleeve": "sleeves",
    "sleeve_cm": "sleeves",
    "sleeve_width_cm": "sleeve_shape",
    "cuff_cm": "cuffs",
    "left_neckline": "neckline",
    "right_neckline": "neckline",
    "neck_depth": "neckline",
    "neck_depth_cm": "neckline",
    "collar_cm": "collar",
    "back_neckline": "back",
    "back_depth": "back",
    "back_depth_cm": "back",
    "slit_size": "slit",
    "slit_cm": "slit",
    "waist_seam": "waist",
    "rise": "waist",
    "waistband_cm": "waistband",
    "leg_cuff_cm": "leg_cuffs",
    "gores": "skirt",
    "tiers": "skirt",
    "godets": "skirt",
    "godet_cm": "skirt",
    "skirt_length_cm": "length",
    "inseam_cm": "length",
    "leg_width_cm": "legs",
    "straps": "shoulders",
    "hips": "fit",
    "chest_cm": "fit",
    "hem_cm": "hem_shape",
}
"""What the claims speak of, where that is not their own name."""
