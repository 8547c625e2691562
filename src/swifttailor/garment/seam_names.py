"""Names of seams in files, which say what is sewn to what, and are read back.

``seam_007:skirt_front.2+skirt_back.5`` is stitch 7 of the pattern: edge 2 of one panel and edge 5 of
another; an exclamation mark at the end says that right side meets wrong side. Panel names are
percent-encoded, so that every name can be told from what stands around it.
"""

from __future__ import annotations

import re
from urllib.parse import quote, unquote

from swifttailor.pattern import EdgeRef, Pattern, Stitch

_NAME = re.compile(r"seam_(\d{1,9}):([^\s:+]+)\.(\d{1,9})\+([^\s:+]+)\.(\d{1,9})(!?)")


def seam_name(number: int, stitch: Stitch) -> str:
    """The name of a seam.

    Args:
        number: Position of its stitch in the pattern.
        stitch: What it joins.
    """
    first, second = (f"{quote(ref.panel, safe='')}.{ref.edge}" for ref in stitch.sides)
    return f"seam_{number:03d}:{first}+{second}{'!' if stitch.right_wrong else ''}"


def seam_names(pattern: Pattern) -> tuple[str, ...]:
    """The names of all seams, in the order of the pattern's stitches."""
    return tuple(seam_name(k, stitch) for k, stitch in enumerate(pattern.stitches))


def read_seam_name(name: str) -> tuple[int, Stitch] | None:
    """Number and stitch of a seam by its name; None where it is not such a name."""
    found = _NAME.fullmatch(name)
    if found is None:
        return None
    first = EdgeRef(unquote(found[2]), int(found[3]))
    second = EdgeRef(unquote(found[4]), int(found[5]))
    return int(found[1]), Stitch(first, second, bool(found[6]))
