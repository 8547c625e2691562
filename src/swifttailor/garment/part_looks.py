"""Parts of a garment that look otherwise than its cloth: a white collar, sleeves of lace, a belt in red.

A garment holds a few statements, each of one part (`PartLook`). Panels are told by their names and places
which part they are (`panels_of`); `looks_of_panels` says what all statements come to on each of them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from swifttailor.garment.cloth_color import cloth_color
from swifttailor.garment.color_blocks import block_panels
from swifttailor.pattern.names import body_region
from swifttailor.pattern.panel_parts import Part, named_part
from swifttailor.render.color import GREY, to_linear

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment
    from swifttailor.pattern import Panel, Pattern

BLOCKS = "blocks"
"""What is in the second of two colours, whichever panels that is."""
LAYERED = "tulle layers"
"""A trim below which a skirt is opaque, whatever it is of."""
LOOKS = "looks"
"""What a report calls them."""
OPACITIES: Mapping[str, float] = {
    "sheer": 0.45,
    "mesh": 0.5,
    "net": 0.38,
    "tulle": 0.44,
    "chiffon": 0.52,
    "organza": 0.46,
    "lace": 0.38,
    "opaque": 1.0,
}
"""Share of what lies beneath that one layer of a cloth hides; of lace the net between its figures."""
SEVERAL_LAYERS = 0.8
"""The same of net that lies in several layers, as in skirts of tulle."""
_ARMS = frozenset({Part.SLEEVE, Part.CUFF})
_UPPER = _ARMS | {Part.TORSO, Part.HOOD, Part.COLLAR}
_SKIRT = frozenset({Part.SKIRT, Part.GODET})
_LEGS = frozenset({Part.TROUSER, Part.LEG_CUFF})
_PARTS: Mapping[str, tuple[frozenset[Part], str]] = {
    "all": (frozenset(Part), ""),
    "left_half": (frozenset(Part) - {Part.WAISTBAND}, r"(^|_)(left|l)(_|$)"),
    "right_half": (frozenset(Part) - {Part.WAISTBAND}, r"(^|_)(right|r)(_|$)"),
    BLOCKS: (frozenset(), ""),
    "bodice": (_UPPER, ""),
    "skirt": (_SKIRT, ""),
    "lower_half": (_SKIRT | _LEGS, ""),
    "legs": (_LEGS, ""),
    "left_leg": (_LEGS, r"(^|_)(left|l)(_|$)"),
    "right_leg": (_LEGS, r"(^|_)(right|r)(_|$)"),
    "front": (frozenset({Part.TORSO}), r"_ftorso|front"),
    "back": (frozenset({Part.TORSO}), r"_btorso|back"),
    "tiers": (_SKIRT, r"^skirt_(front|back)_\d"),
    "gores": (_SKIRT, r"^skirt_panel_\d"),
    "godets": (frozenset({Part.GODET}), ""),
    "peplum": (_SKIRT, ""),
    "sleeves": (_ARMS, ""),
    "left_sleeve": (_ARMS, r"(^|_)(left|l)(_|$)"),
    "right_sleeve": (_ARMS, r"(^|_)(right|r)(_|$)"),
    "collar": (frozenset({Part.COLLAR}), ""),
    "hood": (frozenset({Part.HOOD}), ""),
    "waistband": (frozenset({Part.WAISTBAND}), ""),
    "hem_band": (frozenset({Part.WAISTBAND}), ""),
    "straps": (frozenset({Part.TORSO}), r"strap"),
    "cuffs": (frozenset({Part.CUFF}), ""),
    "leg_cuffs": (frozenset({Part.LEG_CUFF}), ""),
}
"""Kinds of panels of each part and what their names match; what comes later says more, and wins."""
TRIMS_OF_PARTS: Mapping[str, tuple[str, ...]] = {
    "buttons": (
        "buttons",
        "big buttons",
        "button placket",
        "polo placket",
        "waist placket",
        "double-breasted buttons",
        "back buttons",
        "fly",
    ),
    "zip": ("zip", "half zip", "back zip", "side zip"),
    "pockets": (
        *("chest pocket", "chest pockets", "patch pockets", "welt pockets", "kangaroo pocket", "bib pocket"),
        *("side pockets", "slant pockets", "back pockets", "cargo pockets"),
        *("front pocket", "lower back pockets", "thigh pocket", "back welt pockets"),
    ),
    "belt": ("tie belt", "buckle belt", "sash", "side tie"),
    "drawstring": ("drawstring", "neck cord"),
    "frills": ("neck frill", "sleeve frills", "hem frill", "front frills", "yoke frill", "shoulder frills"),
    "fringe": ("hem fringe",),
    "edging": (
        *("edging", "piping", "bands", "narrow bands", "lace trim", "neck lace"),
        *("fur trim", "neck fur", "sleeve fur", "hem border"),
    ),
    "side_stripes": (
        *("side stripes", "satin stripes", "sleeve stripes"),
        *("three side stripes", "three sleeve stripes"),
    ),
    "side_panels": ("side panels",),
    "bow": ("neck bow", "nape bow", "waist bow", "shoulder bows", "back bow", "back ties", "hip knot"),
    "lacing": ("lacing", "back lacing"),
    "apron": ("apron",),
    "motif": ("chest heart", "chest star"),
}
"""What is put on a garment and may have a colour of its own, and which trims it is."""
PANEL_PARTS = tuple(_PARTS)
"""Parts that are panels of their own on some garment."""
PARTS = (*PANEL_PARTS, *TRIMS_OF_PARTS)
"""All parts that may look otherwise."""
_HEX = re.compile("#[0-9a-f]{6}")
_PLAIN = ("all", None, "opaque")
_MOST = 64
"""Of statements in a report."""


@dataclass(frozen=True)
class PartLook:
    """How one part looks; what is None is as on the rest of the garment."""

    part: str
    """One of `PARTS`."""
    color: str | None = None
    """``#rrggbb``."""
    cloth: str | None = None
    """A key of `OPACITIES`."""
    opacity: float | None = None
    """Share of what lies beneath that it hides, where that is not usual of `cloth`: 1.0 of lined cloth."""
    printed: bool | None = None
    """Whether it has the garment's print where the rest has a colour of its own instead."""

    def to_json(self) -> dict[str, Any]:
        """As plain JSON values."""
        return {name: value for name, value in vars(self).items() if value is not None}


@dataclass(frozen=True)
class PanelLook:
    """How one panel looks."""

    color: str | None = None
    """``#rrggbb``; the garment's where None."""
    opacity: float = 1.0
    """Share of what lies beneath that it hides; of lace its net."""
    lace: bool = False
    """Whether it has the figures of lace: on a lining where it is opaque, else on net."""

    @property
    def is_sheer(self) -> bool:
        """Whether something is seen through it."""
        return self.opacity < 1.0


USUAL_LOOK = PanelLook()
"""Of panels that look as their garment does."""


def panels_of(pattern: Pattern, part: str) -> tuple[str, ...]:
    """Names of the panels that a part is; none where the garment has no such part of its own.

    Args:
        pattern: Of the garment.
        part: One of `PARTS`.
    """
    if part not in _PARTS:
        return ()
    if part == BLOCKS:
        return block_panels({panel.name: _part(panel) for panel in pattern.panels})
    kinds, name = _PARTS[part]
    found = [p for p in pattern.panels if _part(p) in kinds]
    if not name:
        return tuple([p.name for p in found])
    said = re.compile(name, re.IGNORECASE)
    return tuple([p.name for p in found if said.search(p.name)])


def has_part(pattern: Pattern, part: str) -> bool:
    """Whether a garment has a part that can look otherwise than the rest of it."""
    if part in TRIMS_OF_PARTS:
        return any(trim in TRIMS_OF_PARTS[part] for trim in pattern.trims)
    return bool(panels_of(pattern, part))


def looks_of_panels(garment: Garment) -> tuple[PanelLook, ...]:
    """How each panel of a garment looks, in their order; `USUAL_LOOK` where it is as the rest."""
    pattern = garment.pattern
    found = {panel.name: USUAL_LOOK for panel in pattern.panels}
    for look in sorted(garment.looks, key=lambda look: PARTS.index(look.part)):
        for name in panels_of(pattern, look.part):
            found[name] = _over(found[name], look)
    if LAYERED in pattern.trims:
        for name in panels_of(pattern, "skirt"):
            found[name] = replace(found[name], opacity=1.0)
    own = garment.color or cloth_color(pattern)
    return tuple([_as_dyed(look, look.color or own) for look in found.values()])


def color_of_panel(garment: Garment, panel: str) -> str | None:
    """The colour ``#rrggbb`` that a panel has of its own; None where it has the garment's."""
    return looks_of_panels(garment)[garment.pattern.panel_index(panel)].color


def merged(before: Iterable[PartLook], new: Iterable[PartLook]) -> tuple[PartLook, ...]:
    """Statements where later ones outdo earlier ones: what becomes sheer all over is so in all its parts."""
    found: dict[str, PartLook] = {}
    for look in (*before, *new):
        if look.part == "all" and look.cloth is not None:
            plain = [PartLook(one.part, one.color, printed=one.printed) for one in found.values()]
            found = {one.part: one for one in plain if one.color is not None or one.printed}
        old = found.get(look.part, PartLook(look.part))
        printed = look.printed or (old.printed if look.color is None else None)
        found[look.part] = replace(_cloth_of(old, look), color=look.color or old.color, printed=printed)
    return tuple([one for one in found.values() if (one.part, one.color, one.cloth) != _PLAIN])


def plain_but_for(looks: Iterable[PartLook], color: str) -> tuple[PartLook, ...]:
    """The looks, and the rest of the garment in one colour where some of its parts alone are printed.

    Args:
        looks: Of parts.
        color: Of the garment, ``#rrggbb``.
    """
    looks = tuple(looks)
    if not any(look.printed for look in looks):
        return looks
    return merged([PartLook("all", color)], looks)


def stated_looks(report: Mapping[str, Any]) -> tuple[PartLook, ...]:
    """The looks of parts that a report states; those that cannot be drawn are left out."""
    said = report.get(LOOKS)
    if not isinstance(said, list):
        return ()
    return tuple([look for entry in said[:_MOST] if (look := _look_of(entry)) is not None])


def _part(panel: Panel) -> Part:
    """By the name of a panel, else by the part of the body that it covers."""
    region = {"arm": Part.SLEEVE, "leg": Part.SKIRT, "body": Part.TORSO}
    return named_part(panel.name) or region[body_region(panel.name, panel.label)]


def _over(before: PanelLook, look: PartLook) -> PanelLook:
    color = None if look.printed else look.color or before.color
    if look.cloth is None:
        return replace(before, color=color)
    opacity = OPACITIES[look.cloth] if look.opacity is None else look.opacity
    return PanelLook(color, opacity, look.cloth == "lace")


def _as_dyed(look: PanelLook, color: str) -> PanelLook:
    """Dark cloth hides more, as it also takes light from what lies beneath it before that is seen."""
    if not look.is_sheer:
        return look
    taken = look.opacity * (1.0 - float(to_linear(color) @ GREY))
    return replace(look, opacity=1.0 - (1.0 - look.opacity) * (1.0 - taken))


def _cloth_of(old: PartLook, new: PartLook) -> PartLook:
    return old if new.cloth is None else replace(old, cloth=new.cloth, opacity=new.opacity)


def _look_of(entry: object) -> PartLook | None:
    if not isinstance(entry, dict) or entry.get("part") not in PARTS:
        return None
    color, cloth, opacity = entry.get("color"), entry.get("cloth"), entry.get("opacity")
    if color is not None and not (isinstance(color, str) and _HEX.fullmatch(color)):
        return None
    if cloth is not None and cloth not in OPACITIES:
        return None
    is_share = isinstance(opacity, int | float) and not isinstance(opacity, bool) and 0.0 <= opacity <= 1.0
    if opacity is not None and not is_share:
        return None
    printed = True if entry.get("printed") is True else None
    return PartLook(entry["part"], color, cloth, None if opacity is None else float(opacity), printed)
