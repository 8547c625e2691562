"""What jackets and coats in photographs are called, by what else was read of them."""

from __future__ import annotations

from collections.abc import Mapping

_SHORT = ("cap", "short", "elbow")
_LONG_KINDS = ("dress", "tunic")


def outer_noun(kind: str, said: Mapping[str, str]) -> tuple[str, frozenset[str]] | None:
    """What to ask for where such clothes are called jackets and coats.

    Most in streets close with a zip up to the neck, below a collar that is turned down or stands.

    Args:
        kind: Of the garment: what looks like a dress is a coat.
        said: Of each claim the likeliest word.

    Returns:
        The words, and which claims they say or take away; None where it can be none.
    """
    sleeves, hooded = said.get("sleeves", "long"), said.get("hood") == "hood"
    if sleeves in _SHORT:
        return None
    if sleeves == "none":
        return ("gilet", frozenset({"neckline", "sleeves"})) if kind not in _LONG_KINDS else None
    if kind in _LONG_KINDS:
        return ("hooded coat" if hooded else "coat"), frozenset({"neckline", "sleeves"})
    closed = (
        "hooded jacket with a zip"
        if hooded
        else f"jacket with a zip and a {'shirt' if said.get('collar') == 'lapel' else 'stand'} collar"
    )
    return closed, frozenset({"neckline"})
