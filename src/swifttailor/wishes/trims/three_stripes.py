"""Stripes down legs and sleeves that are three, where a text says so."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

_THREE: Mapping[str, str] = {
    "side stripes": "three side stripes",
    "satin stripes": "three side stripes",
    "sleeve stripes": "three sleeve stripes",
}
THREE = tuple(dict.fromkeys(_THREE.values()))
"""The trims that are three stripes, side by side."""
_SAID = re.compile(
    r"(?<![\w-])(?:three|3|triple|drei|trois|tres|tre|três|drie)[ -]?"
    r"(?:(?!(?:and|an?|with|und|mit|et|y|con|e|com|en|met)\b)[\w-]+ ){0,2}?"
    r"(?:stripe[sd]?|streifen|bandes|rayas|franjas|strisce|listras|riscas|strepen)(?!\w)",
    re.IGNORECASE,
)


def three_as_said(choices: Sequence[tuple[str, ...]], text: str) -> tuple[tuple[str, ...], ...]:
    """Choices of trims with three stripes before each single one, where a text counts three.

    Args:
        choices: See `TrimWish.choices`.
        text: All of the wish.
    """
    if not _SAID.search(text):
        return tuple([names for names in choices if not set(names) & set(THREE)])
    three = [tuple([_THREE.get(name, name) for name in names]) for names in choices]
    return tuple(dict.fromkeys([*three, *choices]))
