"""Saying a measure: units, rounding, words for counts."""

from __future__ import annotations

import random
from typing import Literal, NamedTuple

from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.inches import CM_PER_INCH

Units = Literal["cm", "inches"]
_COUNTS = (
    "no one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen"
).split()
_HALVES = {0.25: "1/4", 0.5: "1/2", 0.75: "3/4"}


class Said(NamedTuple):
    """A number in words."""

    text: str
    claim: Claim
    """The number as it was said, so that rounding is part of what is claimed."""


def say_measure(name: str, value: float, units: Units, rng: random.Random, *, before_noun: bool) -> Said:
    """Puts a measure into words.

    Args:
        name: Its claim type.
        value: cm, or pieces.
        units: Which system of measures.
        rng: Chooses among ways to say it.
        before_noun: Whether it stands before a noun, as in "a 3-inch cuff".
    """
    if not name.endswith("_cm"):
        count = round(value)
        text = _COUNTS[count] if count < len(_COUNTS) and rng.random() < 0.8 else str(count)
        return Said(text, Claim(name, float(count)))
    if units == "cm":
        rounded = round(value * 2) / 2 if value < 8 else float(round(value))
        figure = f"{rounded:g}"
        if before_noun:
            text = rng.choice([f"{figure} cm", f"{figure}cm", f"{figure}-cm"])
        else:
            text = rng.choice([f"{figure} cm", f"{figure} cm", f"{figure}cm", f"{figure} centimetres"])
        return Said(text, Claim(name, rounded))
    step = 0.25 if value < 12 else 0.5
    inches = max(round(value / CM_PER_INCH / step) * step, step)
    figure = _inches(inches, rng)
    if before_noun:
        text = rng.choice([f"{figure}-inch", f"{figure} inch", f'{figure}"'])
    else:
        unit = "inch" if inches <= 1 else "inches"
        text = rng.choice([f"{figure} {unit}", f"{figure} in", f'{figure}"'])
    return Said(text, Claim(name, round(inches * CM_PER_INCH, 2)))


def is_length(name: str) -> bool:
    """Whether a measure is in cm, not a count."""
    kind = CLAIM_TYPES[name]
    return kind.measure is not None and name.endswith("_cm")


def _inches(value: float, rng: random.Random) -> str:
    whole, part = divmod(value, 1)
    if part == 0:
        return f"{whole:.0f}"
    if rng.random() < 0.5:
        return f"{value:g}"
    fraction = _HALVES[part]
    return f"{whole:.0f} {fraction}" if whole else fraction
