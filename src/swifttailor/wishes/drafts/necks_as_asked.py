"""Drafts with the neckline that is asked for: close to the neck, round, a V, or plunging."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import LEVEL_NECK_CM, SEEN_DEEP, NamedDraft

_NECKED = (
    *("t-shirt", "sweatshirt", "tank-top", "fitted-top", "peplum-top"),
    *("fitted-dress", "skater-dress", "shift-dress", "swing-dress", "drop-waist-dress", "mermaid-dress"),
    *("jumpsuit", "empire-dress"),
)
"""Drafts whose neckline is an option in front."""
_WITHOUT_WIDTH = ("empire-dress", "mermaid-dress")
"""Of these, the ones whose straps say how wide it is."""
_ROUND, _CREW, _V = Claim("neckline", "round"), Claim("neckline", "crew"), Claim("neckline", "v")
_HIGH, _PLUNGING = Claim("neck_depth", "high"), Claim("neck_depth", "plunging")
_LOW = Claim("neck_depth", "low")
_WIDE_ROUND = frozenset({Claim("neckline", "scoop"), Claim("neckline", "boat")})
_TOLD_DEPTHS = frozenset({"neck_depth", "neck_depth_cm", "collar", "hood"})
_FIGURES = frozenset({"neck_depth_cm"})
_BARE_BACKS = frozenset({"back_depth", "back_depth_cm", "back_neckline"})
_WIDTH, _DEPTH, _BACK = "neck_widening", "neck_depth", "back_neck_depth"
_CLOSE: Mapping[str, float] = {_WIDTH: -1.2, _DEPTH: 9.5}
_CLOSE_BACK_CM = 2.5
"""Close to the neck: one that starts farther out bares the collar bones, however high it is in front."""
_ROUND_CM: Mapping[str, float] = {_WIDTH: 0.0, _DEPTH: 11.0}
"""One that is seen to be round: a wide one of that depth looks like a boat neck, since the neck leans forward
and what it is cut deep lies nearly flat."""
_DEEPEST_ROUND_CM = 12.0
"""Figures up to that ask for such a one."""
_SCOOP, _SCOOPED = Claim("neckline", "scoop"), ("t-shirt", "sweatshirt")
_SCOOP_CM: Mapping[str, float] = {_WIDTH: 2.0, _DEPTH: 17.0}
_SHALLOW_SCOOP_CM: Mapping[str, float] = {_WIDTH: 2.0, _DEPTH: 14.5}
"""One that is wide and deep, or wide alone, and the tops whose own necks are close: those that are cut so
later would hang by their neck ribs."""
_SQUARE = Claim("neckline", "square")
_SQUARE_CM: Mapping[str, float] = {_WIDTH: 2.5, _DEPTH: 14.5}
"""A shallow square looks like a boat neck."""
_V_CM: Mapping[str, float] = {_WIDTH: 0.0, _DEPTH: 18.0}
"""A shallow V looks like a boat neck."""
_DEEP_V_CM: Mapping[str, float] = {_WIDTH: 0.5, _DEPTH: 22.0}
_PLUNGING_CM: Mapping[str, float] = {_WIDTH: 1.0, _DEPTH: 31.0}
"""It ends a little above the waist."""
_TO_THE_WAIST = frozenset(
    {"fitted-dress", "fitted-top", "jumpsuit", "mermaid-dress", "peplum-top", "skater-dress"}
)
_DEEPEST_CM = 22.0
"""Of other drafts than these, whose bodices have no waist seam or end below it."""
_LEAST_TOLD_CM = 9.0
"""Figures from which that is how deep it is seen to be: who asks for less asks for a close one."""
_SHAPES = ("v", "square")


def neck_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A draft with the neckline that is asked for; as it is where it has a collar, or none is asked for.

    Args:
        draft: As a table names it; a width that it has from there stays, but for close necks and V's.
        claims: What is asked for, all of it.
    """
    worn = any(claim.name in ("collar", "hood") and claim.value != "none" for claim in claims)
    if draft.name not in _NECKED or worn or draft.stands:
        return draft
    options = dict(draft.options)
    cut: dict[str, float] = dict(_neck(claims, told_width=_WIDTH in options))
    if draft.name in _SCOOPED and _SCOOP in claims and not any(c.name in _FIGURES for c in claims):
        cut |= _SHALLOW_SCOOP_CM if _HIGH in claims else _SCOOP_CM
    if draft.name == "t-shirt" and _SQUARE in claims and not any(c.name in _TOLD_DEPTHS for c in claims):
        cut |= {name: max(least, float(options.get(name, 0.0))) for name, least in _SQUARE_CM.items()}
    if draft.name in _WITHOUT_WIDTH:
        cut.pop(_WIDTH, None)
    shapes = [shape for shape in _SHAPES if Claim("neckline", shape) in claims]
    told = _told_depth(claims, shapes) if draft.name in SEEN_DEEP else 0.0
    if told:
        cut[_DEPTH] = round(told + LEVEL_NECK_CM, 2)
    if not cut:
        return draft
    if draft.name not in _TO_THE_WAIST and _DEPTH in cut:
        cut[_DEPTH] = min(cut[_DEPTH], _DEEPEST_CM)
    square = draft.name == "t-shirt" and _SQUARE in claims
    shape: dict[str, str] = {"neckline": shapes[0]} if _V in claims or square or (told and shapes) else {}
    back = _is_close(claims) and not any(claim.name in _BARE_BACKS for claim in claims)
    if back and draft.name not in ("sweatshirt", *_WITHOUT_WIDTH):
        cut[_BACK] = _CLOSE_BACK_CM
    return replace(draft, options=tuple({**options, **shape, **cut}.items()))


def _neck(claims: Sequence[Claim], *, told_width: bool) -> Mapping[str, float]:
    """Options of the neckline that is asked for; none where the draft's own will do."""
    if _is_close(claims):
        return _CLOSE
    if _PLUNGING in claims and (_V in claims or not any(claim.name == "neckline" for claim in claims)):
        return _PLUNGING_CM
    depths = [claim for claim in claims if claim.name in _TOLD_DEPTHS and claim.value != "none"]
    if _V in claims:
        return _V_CM if not depths else _DEEP_V_CM if depths == [_LOW] else {}
    if _ROUND not in claims or told_width or not _WIDE_ROUND.isdisjoint(claims):
        return {}
    if depths:
        shallow = [claim for claim in depths if claim.name == "neck_depth_cm" and _is_shallow(claim)]
        return {_WIDTH: _ROUND_CM[_WIDTH]} if shallow else {}
    return _ROUND_CM


def _told_depth(claims: Sequence[Claim], shapes: Sequence[str]) -> float:
    """A depth that is told in figures, cm, where it can be cut so that it is seen; else 0."""
    told = [c.value for c in claims if c.name == "neck_depth_cm" and isinstance(c.value, int | float)]
    deepest = _PLUNGING_CM[_DEPTH] if "v" in shapes else _DEEPEST_CM
    return float(told[0]) if told and _LEAST_TOLD_CM <= told[0] <= deepest - LEVEL_NECK_CM else 0.0


def _is_close(claims: Sequence[Claim]) -> bool:
    """Whether a neckline is asked for that is high, and round where its shape is told."""
    shaped = any(claim.name == "neckline" for claim in claims)
    return _CREW in claims or (_HIGH in claims and (_ROUND in claims or not shaped))


def _is_shallow(claim: Claim) -> bool:
    return isinstance(claim.value, int | float) and claim.value <= _DEEPEST_ROUND_CM
