"""How words for what becomes true of a garment are written down."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.describing.claims import Claim
from swifttailor.wording.phrases.phrase import TOPIC


@dataclass(frozen=True)
class GainWording:
    """What can be asked for, in the imperative, when claims become true."""

    claims: tuple[Claim, ...]
    """The first has become true; the others are true afterwards."""
    was: tuple[Claim, ...]
    """What was true before."""
    was_not: tuple[Claim, ...]
    """What was not claimed before."""
    topic: str
    importance: float
    texts: tuple[str, ...]


def _claims(text: str) -> tuple[Claim, ...]:
    pairs = (need.split("=") for need in text.split())
    return tuple(Claim(name, value.replace("_", " ")) for name, value in pairs)


def gain(
    claims: str, importance: float, *texts: str, was: str = "", was_not: str = "", topic: str = ""
) -> GainWording:
    """Writes a wording down briefly.

    Args:
        claims: Such as ``"sleeves=long cuffs=band"``; ``_`` in a value stands for a space.
        importance: 9 for parts that come or go, down to 2 for what is hardly noticed.
        texts: Synonyms in the imperative.
        was: Claims that were true before.
        was_not: Claims that were not made before.
        topic: What it is about, where that is not the topic of the first claim.
    """
    made = _claims(claims)
    about = topic or TOPIC.get(made[0].name, made[0].name)
    return GainWording(made, _claims(was), _claims(was_not), about, importance, texts)
