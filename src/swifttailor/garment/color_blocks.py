"""Which panels of a garment are in the second of two colours: its skirt, its sleeves, or one half of it."""

from __future__ import annotations

import re
from collections.abc import Mapping

from swifttailor.pattern.panel_parts import Part

_BELOW = frozenset({Part.SKIRT, Part.GODET, Part.TROUSER, Part.LEG_CUFF})
_BESIDE = frozenset({Part.SLEEVE, Part.CUFF, Part.COLLAR, Part.HOOD})
_RIGHT = re.compile(r"(^|_)(right|r)(_|$)")
_EVERY_OTHER = (re.compile(r"_(?:front|back)_[13579]$"), re.compile(r"_panel_\d*[13579]$"))
_BACK = re.compile(r"back|_b(_|$)")


def block_panels(parts: Mapping[str, Part]) -> tuple[str, ...]:
    """Names of the panels in the second colour; none where a garment is all one panel.

    What has a bodice has it below the waist, what has sleeves on these and around the neck. Of what has
    neither, every other tier or gore is, else the right half, else the back.

    Args:
        parts: What each panel is, by its name.
    """
    has = frozenset(parts.values())
    for of, beside in ((_BELOW, Part.TORSO), (_BESIDE, Part.TORSO)):
        if beside in has and (Part.SLEEVE in has or of is _BELOW) and not of.isdisjoint(has):
            return tuple([name for name, part in parts.items() if part in of])
    cut = [name for name, part in parts.items() if part is not Part.WAISTBAND]
    for those in (*_EVERY_OTHER, _RIGHT, _BACK):
        found = tuple([name for name in cut if those.search(name)])
        if found and len(found) < len(cut):
            return found
    return ()
