"""Whom a pattern is for, in words: what one compares with one's own measures before cutting."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from swifttailor.body import Body
from swifttailor.pattern import Pattern

MAIN_MEASURES = ("bust", "waist", "hips", "height")


def made_for(pattern: Pattern) -> str:
    """The body that a pattern was drafted for: ``women EU 44: bust 100, waist 84, hips 108, height 168 cm``.

    What is cut smaller than that body says so, and what cloth it needs.

    Args:
        pattern: Where its file names no body, the default body counts, as everywhere.
    """
    if pattern.cloth_stretch:
        return f"{_body(pattern)}; in cloth that stretches by {pattern.cloth_stretch:.0%} or more"
    return _body(pattern)


def _body(pattern: Pattern) -> str:
    named = pattern.drafted_for
    if named is None:
        measures = measures_in_words(Body.default().measurements.as_dict(), MAIN_MEASURES)
        return f"the default body: {measures}. For yours: swifttailor fit PATTERN --size 44"
    own = measures_in_words(dict(named.measures), MAIN_MEASURES)
    # Bodies by measures alone are named after these.
    titled = all(f"{name} {value:g}" in named.name for name, value in named.measures)
    if not own or titled:
        return f"{named.name} cm" if own else named.name
    return f"{named.name}: {own}" if named.name else own


def measures_in_words(measures: Mapping[str, float], names: Sequence[str]) -> str:
    """Those of the measures that have one of the names: ``bust 100, waist 84 cm``; empty when none has."""
    shown = ", ".join(f"{name} {round(measures[name], 1):g}" for name in names if name in measures)
    return f"{shown} cm" if shown else ""
