"""Skirts on a yoke, which is cut where a text asks for one: gathers and pleats begin below it."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.text.yoke_heights import told_yoke_cm

_DRAFTS = ("circle-skirt", "gathered-skirt", "pleated-skirt")
_FLARED: Mapping[str, float] = {"fitted-skirt": 0.22, "gored-skirt": 0.45, "mermaid-skirt": 0.3}
"""Skirts without a yoke that are cut from a part of a circle below one, and from which."""
YOKE, _USUAL_CM = "yoke", 12.0
"""The option, which is a key of ``cannot.txt`` as well, and how high one is where no figure says it, cm."""
_FULLNESS = 1.7
"""Of what is gathered into the wide edge of a yoke, at most."""


def yoke_as_asked(draft: NamedDraft, lacks: Collection[str], text: str) -> NamedDraft:
    """A skirt on a yoke where one is asked for, as high as figures say; other drafts as they are.

    Args:
        draft: As it goes with all else that is asked for.
        lacks: Keys of ``cannot.txt`` that the text asks for or the name of the garment means.
        text: The words.
    """
    if YOKE not in lacks:
        return draft
    options = dict(draft.options)
    if draft.name in _FLARED and not options.get("stretch"):
        kept = {name: value for name, value in options.items() if name == "length"}
        options = {"length": 60.0, **kept, "fraction": _FLARED[draft.name]}
        draft = NamedDraft("circle-skirt", tuple(options.items()))
    if draft.name not in _DRAFTS or options.get("hem_band") or options.get("apron"):
        return draft
    if draft.name == "gathered-skirt":
        options["fullness"] = min(float(options.get("fullness", _FULLNESS)), _FULLNESS)
    options[YOKE] = told_yoke_cm(text) or float(options.get(YOKE, _USUAL_CM))
    options.pop("below_waist", None)
    return replace(draft, options=tuple(options.items()))
