"""Named drafts with what words say of legs, waistbands, straps and shoulders that no claim does."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import (
    BACK_RISE,
    CROSSED,
    CROSSED_STRAPS,
    LEG_SLITS,
    SIDE_SLITS,
    NamedDraft,
)

_LEGS = ("trousers", "jeans", "leggings", "flares", "pull-on-trousers")
"""Drafts whose legs end open."""
_BANDED = (*_LEGS, "joggers")
_SHORT_CM, _CALF_CM = 60.0, 86.0
_SLITS_CM = (9.0, 7.0, 16.0)
"""Length of the slits of shorts, of legs that end at the calf, and of long ones."""
_RISE_CM = 4.0
"""How much higher a waistband is in the middle of the back."""
BRACES = "suspenders"
"""Key of ``cannot.txt`` that straps over the shoulders show."""
_BRACED: Mapping[str, tuple[str, tuple[str, ...]]] = {
    "trousers": ("dungarees", ("length", "hip_ease", "leg_ease", "flare")),
    "circle-skirt": ("pinafore", ("length",)),
    "fitted-skirt": ("pinafore", ("length", "hip_ease", "flare")),
}
"""Drafts that may hang on braces, as what they are cut then, and the options that this has as well."""
_STRAPS_MAY_CROSS = (
    *("dungarees", "pinafore", "apron"),
    *("camisole", "slip-dress", "strappy-dress", "strappy-jumpsuit"),
)
_LOOSE = frozenset({Claim("fit", "loose"), Claim("fit", "oversized"), Claim("legs", "wide")})
_DUNGAREES, _ROOMY = "dungarees", {"hip_ease": 14.0, "leg_ease": 30.0, "flare": 2.0, "crotch_drop": 4.0}
_SHOULDERED, _EXTENSION = ("blazer", "coat"), "shoulder_extension"
_BEYOND = {"shoulder_pads": 4.5, "huge_shoulders": 5.5}
"""How far beyond the shoulder tips jackets reach whose shoulders are padded, or huge, cm."""
_NIPPED, _WAIST = {"waist_shaping": 3.5}, Claim("waist_seam", "natural")
"""Of jackets with huge shoulders, or of which a waist is told: they are close there."""
_TRAILING, _TRAILS = "trailing_sleeves", ("sleeve_shape", "trailing")
_MAY_TRAIL = (
    *("robe", "hooded-coat", "shift-dress", "swing-dress", "fitted-dress", "skater-dress", "shirt-dress"),
    *(
        "mermaid-dress",
        "drop-waist-dress",
        "t-shirt",
        "shirt",
        "turtleneck",
        "fitted-top",
        "peplum-top",
        "cardigan",
    ),
)
_ROLLED_SLEEVES, _SHIRTS = "rolled_sleeves", ("shirt", "shirt-dress")
_ROLLED: Mapping[str, float | bool] = {"sleeve_length": 42.0, "sleeve_end": 32.0, "cuffs": False}
"""Of long sleeves that are rolled up: to the middle of the lower arm."""
_ELBOW_CM = 34.0
_FULL_ABOVE = frozenset({Claim("sleeve_shape", "puffed"), Claim("sleeve_shape", "balloon")})
"""Who asks for these has none that trail, whatever the name of the garment means."""
_LONG_CM = 58.0
_DRAPED, _OF_COWLS = "draped", {"neck_widening": 4.5, "neck_depth": 10.5, "back_neck_depth": 4.0}
_MAY_FALL = ("t-shirt", "tank-top")
"""Tops whose necks are wide and shallow where folds are to hang from them."""


def with_details(draft: NamedDraft, lacks: Collection[str], claims: Collection[Claim]) -> NamedDraft:
    """A draft with legs that are slit, a waistband that rises behind, straps that cross, as a text has them.

    Args:
        draft: As it was asked for otherwise.
        lacks: Keys of ``cannot.txt`` that the text asks for or the name of the garment means.
        claims: What is told.
    """
    more: dict[str, float | bool | str] = {}
    options = dict(draft.options)
    if LEG_SLITS in lacks and draft.name in _LEGS:
        length = float(options.get("length", _CALF_CM + 1))
        more[SIDE_SLITS] = _SLITS_CM[0 if length <= _SHORT_CM else 1 if length <= _CALF_CM else 2]
    if BACK_RISE in lacks and draft.name in _BANDED:
        more[BACK_RISE] = _RISE_CM
    if _DRAPED in lacks and draft.name in _MAY_FALL and options.get("neckline", "round") == "round":
        more |= {name: own for name, own in _OF_COWLS.items() if float(options.get(name, 0.0)) < own + 3.0}
    if CROSSED_STRAPS in lacks and draft.name in _STRAPS_MAY_CROSS:
        more[CROSSED] = True
    if draft.name == _DUNGAREES and not options.get("stretch") and not _LOOSE.isdisjoint(claims):
        short = float(options.get("length", _CALF_CM)) <= _SHORT_CM
        more |= {name: max(own, float(options.get(name, own))) for name, own in _ROOMY.items() if not short}
    if BRACES in lacks and draft.name in _BRACED:
        return _on_braces(draft)
    beyond = [reach for what, reach in _BEYOND.items() if what in lacks]
    if beyond and draft.name in _SHOULDERED:
        more[_EXTENSION] = max([*beyond, float(options.get(_EXTENSION, 0.0))])
    nipped = "huge_shoulders" in lacks or _WAIST in claims
    if nipped and draft.name == "blazer" and _LOOSE.isdisjoint(claims):
        more |= _NIPPED
    rolled = _ROLLED_SLEEVES in lacks and options.get("sleeve_shape", "plain") == "plain"
    if rolled and draft.name in _SHIRTS and float(options.get("sleeve_length", 60.0)) >= _ELBOW_CM:
        more |= _ROLLED
    if _TRAILING in lacks and draft.name in _MAY_TRAIL and _FULL_ABOVE.isdisjoint(claims):
        more |= {
            _TRAILS[0]: _TRAILS[1],
            "sleeve_length": max(_LONG_CM, float(options.get("sleeve_length", 0.0))),
        }
        more |= {"sleeves": True} if draft.name not in ("robe", "t-shirt", "shirt", "cardigan") else {}
        more |= {"cuffs": False} if draft.name in ("shirt", "shirt-dress") else {}
        more["arm_ease"] = min(float(options.get("arm_ease", 8.0)), 16.0)
    return replace(draft, options=tuple({**options, **more}.items())) if more else draft


def _on_braces(draft: NamedDraft) -> NamedDraft:
    """The same garment, its waistband held by straps over the shoulders."""
    name, kept = _BRACED[draft.name]
    own = [option for option in draft.options if option[0] in kept]
    return NamedDraft(name, (("bib", False), *own))
