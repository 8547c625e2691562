"""Named drafts with armholes as a text asks: raglan, cut in one, at dropped shoulders, racerbacks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from swifttailor.pattern.drafts.draft_names import (
    ARMHOLE,
    CUT_IN_ONE,
    DROPPED,
    DROPPED_BY,
    RACER,
    RACERBACK,
    RAGLAN,
    NamedDraft,
)
from swifttailor.wording.lexicon import Lack

_RAGLAN = frozenset(
    {
        "t-shirt",
        "shirt",
        "turtleneck",
        "cardigan",
        "sweatshirt",
        "hoodie",
        "bomber-jacket",
        "coat",
        "hooded-coat",
        "shift-dress",
    }
)
"""Drafts with that option."""
_IN_ONE = frozenset({"t-shirt", "turtleneck", "cardigan", "sweatshirt", "coat", "shift-dress", "wrap-top"})
_DROPPED = frozenset(
    {
        "t-shirt",
        "shirt",
        "cardigan",
        "sweatshirt",
        "hoodie",
        "bomber-jacket",
        "denim-jacket",
        "coat",
        "hooded-coat",
        "shift-dress",
        "robe",
        "kaftan",
    }
)
_ROOM: Mapping[str, float] = {"chest_ease": 18.0, "armhole_drop": 6.0, "arm_ease": 12.0}
"""Least room that goes with dropped shoulders, cm; with shallower armholes the arms come out of them."""
_DROPPED_CM = 7.5
_OPEN_NECK: Mapping[str, float] = {"chest_ease": 12.0, "neck_widening": 3.0, "back_neck_depth": 5.0}
_OF_WINGS: Mapping[str, Mapping[str, float]] = {
    "t-shirt": _OPEN_NECK,
    "shift-dress": _OPEN_NECK,
    "sweatshirt": {"chest_ease": 14.0, "neck_widening": 3.0},
    "coat": {"chest_ease": 16.0},
    "wrap-top": {"chest_ease": 8.0, "neck_widening": 2.5, "back_neck_depth": 4.0},
}
"""The same of sleeves that are cut in one: a close neckline stands off beside and behind the neck."""
_WING_CM, _WINGS_CM = 18.0, {"coat": 10.0, "wrap-top": 12.0}
"""Where such sleeves begin, cm below the underarm."""
_KIMONO: Mapping[str, float] = {"sleeve_length": 42.0, "sleeve_end": 33.0}
"""Such sleeves of tops whose fronts cross, where nothing else is told of them, cm."""
_TANK, _OF_RACERS = "tank-top", {"strap_width": 3.5, "neck_widening": 1.5, "back_neck_depth": 8.0}
"""Straps of a back that is cut in are at most so wide, and its neck so deep, cm."""
_RACER_DRESS = {"neck_widening": 1.5, "back_neck_depth": 8.0}
_OF_DARTED = {"back_neck_depth": 8.0}
_SUIT = {"stretch": 8.0, "neck_widening": 2.5, "neck_depth": 14.0, **_OF_DARTED, RACER: True}
_DARTED = ("skater-dress", "bodysuit")
"""Drafts with darts whose back may be cut in as well."""
_SLEEVED = ("shift-dress",)
"""Drafts that have sleeves only where an option says so."""


def armholes_as_asked(draft: NamedDraft, lacks: Sequence[Lack]) -> NamedDraft:
    """A draft with the armholes or sleeves that are asked for, where it can have them; others as they are.

    Args:
        draft: As a table names it, or as it goes with what else is asked for.
        lacks: What the text asks for, which counts first, and what names in it mean, that is not made
            otherwise.
    """
    options = dict(draft.options)
    puffed = options.get("sleeve_shape") == "puffed"
    if ARMHOLE in options or options.get("sleeves") is False:
        return draft
    for lack in sorted(lacks, key=lambda each: not each.said):
        if lack.what == CUT_IN_ONE and draft.name in _IN_ONE and not puffed:
            wing = _WINGS_CM.get(draft.name, _WING_CM)
            roomy = _with_room(options, _OF_WINGS.get(draft.name, {}))
            own = _KIMONO if draft.name == "wrap-top" else {}
            return _with(draft, {**own, **roomy, ARMHOLE: "cut-in-one", "wing": wing})
        if lack.what == RACERBACK and draft.name == _TANK:
            narrow = {name: min(float(options.get(name, most)), most) for name, most in _OF_RACERS.items()}
            return _with(draft, {**options, **narrow, RACER: True})
        if lack.what == RACERBACK and draft.name in _SLEEVED and not options.get("sleeves"):
            return replace(draft, options=tuple({**options, **_RACER_DRESS, RACER: True}.items()))
        if lack.what == RACERBACK and draft.name in _DARTED:
            bare = {"sleeves": False, RACER: True}
            return replace(draft, options=tuple({**_OF_DARTED, **options, **bare}.items()))
        if lack.what == RACERBACK and draft.name == "swimsuit" and not options.get("halter"):
            return NamedDraft("bodysuit", tuple(_SUIT.items()))
        if lack.what == RAGLAN and draft.name in _RAGLAN and not puffed:
            return _with(draft, {**options, ARMHOLE: "raglan"})
        if lack.what == DROPPED and draft.name in _DROPPED:
            return _with(draft, {**_with_room(options, _ROOM), DROPPED_BY: _DROPPED_CM})
    return draft


def _with_room(options: Mapping[str, float | bool | str], least: Mapping[str, float]) -> dict[str, Any]:
    return {**options, **{name: max(float(options.get(name, 0.0)), room) for name, room in least.items()}}


def _with(draft: NamedDraft, options: Mapping[str, float | bool | str]) -> NamedDraft:
    if draft.name in _SLEEVED:
        options = {"sleeves": True, **options}
    return replace(draft, options=tuple(options.items()))


def one_racer(drafts: Sequence[NamedDraft]) -> list[NamedDraft]:
    """Drafts of which a dress that the word for such a back begins from gives way to what the text names."""
    darted = any(draft.name in _DARTED and dict(draft.options).get(RACER) for draft in drafts)
    racers = ("shift-dress", _TANK)
    return [d for d in drafts if not (darted and d.name in racers and dict(d.options).get(RACER))]
