"""Named drafts that cling or are shaped, where a text asks for room: a polo neck that is not clingy."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.clinging_drafts import SHAPING, STRETCH

_ROOM_CM: Mapping[str, float] = {"easy": 10.0, "loose": 15.0, "oversized": 22.0}
"""Least room on top of the bust girth, all around, of what is to be so."""
_STRAIGHT = ("t-shirt", "tank-top", "turtleneck", "camisole", "shift-dress")
"""Drafts that hang straight where nothing shapes them."""
_CLINGING_DRESS, _SKIRT_CM, _FLARE_CM = "fitted-dress", 60.0, 24.0
_BARE_CM, _NECK_CM = 13.0, 1.5
"""Most room without sleeves, as wide armholes catch the arms, and how much wider the neck is, cm."""
_JUMPSUIT = "jumpsuit"
_LOOSE_JUMPSUIT: Mapping[str, float] = {"bust_ease": 16.0, "waist_ease": 14.0}
"""Room of jumpsuits that are to be loose: widened once they are cut, their armholes gape to the waist."""
_KEPT = ("neckline", "neck_widening", "neck_depth", "sleeves", "sleeve_length", "sleeve_end")
"""Options of fitted dresses that those without a waist have as well."""


def is_to_be_loose(claims: Sequence[Claim]) -> bool:
    """Whether room is asked for."""
    return _room(claims) is not None


def loosened_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A draft that hangs straight where its name alone would have it cling, or has room; others as they are.

    Args:
        draft: As it was asked for otherwise.
        claims: What is asked for, all of it.
    """
    room = _room(claims)
    options = dict(draft.options)
    if draft.name == _JUMPSUIT and room == _ROOM_CM["loose"] and not options.get(STRETCH):
        told = {name: max(own, float(options.get(name, own))) for name, own in _LOOSE_JUMPSUIT.items()}
        return replace(draft, options=tuple({**options, **told}.items()))
    if room is None or not (options.get(STRETCH) or options.get(SHAPING)):
        return draft
    if draft.name == _CLINGING_DRESS and options.get(STRETCH):
        kept = {name: options[name] for name in _KEPT if name in options}
        bare = not options.get("sleeves")
        straight = {
            "length": options.get("skirt_length", _SKIRT_CM),
            "chest_ease": min(room, _BARE_CM) if bare else room,
            "flare": _FLARE_CM,
            "neck_widening": _NECK_CM,
        }
        return NamedDraft("shift-dress", tuple({**straight, **kept}.items()))
    if draft.name not in _STRAIGHT:
        return draft
    options = {name: value for name, value in options.items() if name not in (STRETCH, SHAPING)}
    options["chest_ease"] = max(room, float(options.get("chest_ease", 0.0)))
    return replace(draft, options=tuple(options.items()))


def _room(claims: Sequence[Claim]) -> float | None:
    """Room that is asked for at the chest, cm; None where none is."""
    return next((_ROOM_CM[str(c.value)] for c in claims if c.name == "fit" and c.value in _ROOM_CM), None)
