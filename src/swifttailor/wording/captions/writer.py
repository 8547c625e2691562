"""Writing captions: a pattern and a seed in, a text and the claims it makes out."""

from __future__ import annotations

import random
from collections.abc import Iterable
from dataclasses import dataclass

from swifttailor.body import BodyMeasurements
from swifttailor.describing.claims import Claim, claims_of
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import InputError
from swifttailor.pattern import Pattern
from swifttailor.wording.captions.styles import STYLES
from swifttailor.wording.speech import Speech

_BRITISH = 0.5
_WITH_NUMBERS = 0.3
_INCHES = {"uk": 0.15, "us": 0.75}


@dataclass(frozen=True)
class Caption:
    """A text about a garment."""

    text: str
    claims: tuple[Claim, ...]
    """What it says, each statement once; all of them hold for the pattern it was written from."""
    style: str
    """A key of `styles.STYLES`."""


def write_caption(
    source: Pattern | GarmentFacts,
    seed: int = 0,
    *,
    style: str | None = None,
    body: BodyMeasurements | None = None,
) -> Caption:
    """Writes one caption.

    Args:
        source: The pattern, or its facts where several captions are wanted of one pattern.
        seed: Decides style, words, order, dialect and units; the same seed gives the same text.
        style: One of `styles.STYLES`; chosen by the seed when None.
        body: Who the pattern is made for; the default body when None.

    Raises:
        InputError: There is no such style.
    """
    facts = measure_facts(source, body) if isinstance(source, Pattern) else source
    return _write(claims_of(facts), seed, style)


def write_captions(
    source: Pattern | GarmentFacts, seeds: Iterable[int], *, body: BodyMeasurements | None = None
) -> list[Caption]:
    """Writes one caption for each seed; the pattern is measured once."""
    facts = measure_facts(source, body) if isinstance(source, Pattern) else source
    claims = claims_of(facts)
    return [_write(claims, seed, None) for seed in seeds]


def write_claims(claims: Iterable[Claim], seed: int = 0, *, tries: int = 24) -> Caption:
    """Writes a caption that says as many of some statements as one text of the usual styles can.

    Args:
        claims: What is to be said.
        seed: Decides the words; the same seed gives the same text.
        tries: Texts that are written, of which that is taken which says most, of several the first.
    """
    wanted = tuple(dict.fromkeys(claims))
    if tries < 1:
        raise InputError(f"tries is {tries}; at least 1 is needed.")
    written = (
        _write(wanted, seed * tries + k, style)
        for k in range(tries)
        for style in ("terse", "phrase", "command")
    )
    return max(written, key=lambda caption: len(caption.claims))


def _write(claims: tuple[Claim, ...], seed: int, style: str | None) -> Caption:
    rng = random.Random(f"caption {seed}")
    if style is None:
        style = rng.choices(list(STYLES), [weight for _, weight in STYLES.values()])[0]
    elif style not in STYLES:
        raise InputError(f"There is no caption style '{style}'. Known: {', '.join(STYLES)}.")
    dialect = "uk" if rng.random() < _BRITISH else "us"
    units = "inches" if rng.random() < _INCHES[dialect] else "cm"
    speech = Speech(rng, claims, dialect, units, numbers=rng.random() < _WITH_NUMBERS)
    text, said = STYLES[style][0](speech)
    stated = tuple(dict.fromkeys(claim for phrase in said for claim in phrase.claims))
    return Caption(text, stated, style)
