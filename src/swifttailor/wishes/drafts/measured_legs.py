"""Drafts of trousers as wide at knee and hem, and as high, as figures tell."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.text.leg_figures import below_waist_cm, knee_cm

_LEGS = ("trousers", "pull-on-trousers")
_MAY_SIT_LOWER = (*_LEGS, "jeans", "flares", "joggers", "leggings")
_LEG_CM, _ROOM_CM = 36.7, {"trousers": 9.0, "pull-on-trousers": 22.0}
"""Girth of the usual leg at the knee and below it; the room there that the drafts have by themselves, cm."""
_LEAST_CM, _MOST_CM, _NARROWS_CM, _WIDENS_CM = 0.5, 60.0, -26.0, 30.0
_OVER_HEM_CM = 8.0
"""By how much legs whose ends are told are wider at the knee at most: they fall straight."""
_WIDE_CM = 30.0
"""Legs with so much room are narrowed as wide ones are."""
_SHORTS_CM = 66.0
_FLARES, _FLARES_ROOM_CM = "flares", 9.0
_FLARES_CM: tuple[float, float] = (8.0, 40.0)
"""By how much their hem is wider than their knee."""


def legs_as_measured(draft: NamedDraft, text: str, claims: Sequence[Claim]) -> NamedDraft:
    """Trousers with the rise and the widths at knee and hem that are told; others as they are.

    Args:
        draft: As it was asked for otherwise.
        text: All of it.
        claims: What is asked for.
    """
    options = dict(draft.options)
    below = below_waist_cm(text) if draft.name in _MAY_SIT_LOWER else None
    if below is not None:
        options["below_waist"] = below
    if draft.name in _LEGS and float(options.get("length", 100.0)) > _SHORTS_CM:
        hems = [float(c.value) for c in claims if c.name == "leg_width_cm" and not isinstance(c.value, str)]
        room, flare = float(options.get("leg_ease", _ROOM_CM[draft.name])), float(options.get("flare", 0.0))
        knee = knee_cm(text)
        if knee is not None or (hems and room < _WIDE_CM):
            hem = hems[0] if hems else None
            wide = _LEG_CM + room if knee is None else knee
            if knee is None and hem is not None:
                wide = max(min(wide, hem + _OVER_HEM_CM), hem)
            options["leg_ease"] = round(min(max(wide - _LEG_CM, _LEAST_CM), _MOST_CM), 1)
            told = min(flare, 0.0) if hem is None else hem - wide
            options["flare"] = round(min(max(told, _NARROWS_CM), _WIDENS_CM), 1)
    if draft.name == _FLARES:
        options |= _flares_by_figures(options, knee_cm(text), claims)
    return draft if options == dict(draft.options) else replace(draft, options=tuple(options.items()))


def _flares_by_figures(
    own: Mapping[str, float | bool | str], knee: float | None, claims: Sequence[Claim]
) -> dict[str, float]:
    """Room at the knee and width of the hem of flares, where they are told."""
    hems = [float(c.value) for c in claims if c.name == "leg_width_cm" and not isinstance(c.value, str)]
    room = float(own.get("leg_ease", _FLARES_ROOM_CM)) if knee is None else max(knee - _LEG_CM, _LEAST_CM)
    found = {} if knee is None else {"leg_ease": round(room, 1)}
    if hems:
        least, most = _FLARES_CM
        found["flare"] = round(min(max(hems[0] - _LEG_CM - room, least), most), 1)
    return found
