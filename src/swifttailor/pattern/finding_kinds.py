"""Everything that readers and checks can find, in one table: how bad it is, why it matters, what mends it.

When each is found: docs/checks.md.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, NamedTuple

from swifttailor.pattern.finding import Finding, Severity

_ERROR, _WARNING, _INFO = Severity.ERROR, Severity.WARNING, Severity.INFO


class _Kind(NamedTuple):
    severity: Severity
    why: str
    repair: str = ""


_KINDS: Mapping[str, _Kind] = {
    "open-loop": _Kind(_ERROR, "cloth can only be cut along a closed line"),
    "edge-order": _Kind(
        _INFO, "most readers take the list order as the loop", "written in order by --repair"
    ),
    "unused-vertex": _Kind(
        _WARNING, "a stray vertex shifts the numbering other tools rely on", "dropped by --repair"
    ),
    "panel-order": _Kind(
        _INFO, "tools that walk panel_order would miss or repeat panels", "written anew by --repair"
    ),
    "other-units": _Kind(_INFO, "GarmentCode's own loader forgets to convert arc radii"),
    "unknown-key": _Kind(_INFO, ""),
    "zero-length-edge": _Kind(
        _ERROR,
        "an edge without length has no direction and cannot be sampled",
        "dropped by --repair together with a partner as short",
    ),
    "sliver-edge": _Kind(
        _WARNING,
        "no cloth is cut that exactly; tools that round coordinates lose the edge and its seam",
        "merge it with its neighbour on both sides of the seam",
    ),
    "short-radius": _Kind(
        _WARNING,
        "no such circle joins the end points; it is taken for a semicircle, others may fail. "
        "Radii are absolute: they must change with the end points and the unit",
        "--repair raises the radius to half the chord",
    ),
    "no-area": _Kind(_ERROR, "there is no cloth to sew", "remove the panel or move its corners apart"),
    "sliver-panel": _Kind(
        _WARNING, "it is narrower than its own seams", "remove the panel or move its corners apart"
    ),
    "oversized-panel": _Kind(
        _WARNING,
        "rarely meant (stacked gathered skirts explode like this) and slow to drape",
        "check properties.units_in_meter (100 means cm, 1000 mm) and the gather ratios",
    ),
    "self-crossing": _Kind(
        _ERROR,
        "cloth cannot be cut where it would lie in two layers",
        "move the corner or bend the edge away; --repair does it within half a centimetre",
    ),
    "near-crossing": _Kind(
        _WARNING,
        "less than the accuracy of cutting, but meshing programs may refuse it",
        "--repair moves the corner or flattens the curve, by half a centimetre at most",
    ),
    "self-touching": _Kind(_INFO, "it can be cut, but two parts of the outline coincide there"),
    "unfinished-repair": _Kind(
        _INFO, "trying everything would take minutes", "repair the pattern again, or mend it by hand"
    ),
    "tiny-pattern": _Kind(
        _WARNING,
        "no garment is that small; lengths in metres look like this when read as cm",
        "set properties.units_in_meter to 1 for metres, 39.37 for inches",
    ),
    "dangling-stitch": _Kind(_ERROR, "a stitch needs two edges that exist", "--repair removes the stitch"),
    "self-stitched-edge": _Kind(
        _ERROR, "a seam joins two edges; to fold one in half, split it first", "--repair removes the stitch"
    ),
    "duplicate-stitch": _Kind(
        _ERROR,
        "each edge may be in one stitch only; other programs refuse the pattern",
        "--repair removes the stitch",
    ),
    "edge-stitched-twice": _Kind(
        _ERROR,
        "an edge can be sewn to one other edge; which one is meant cannot be told",
        "remove all but one of these stitches, or split the edge where its partners meet",
    ),
    "uneven-seam": _Kind(
        _WARNING,
        "gathers of real garments stay below 3; this much cloth does not fit into one seam",
        "sew it to another edge, split the longer edge, or change its length",
    ),
    "twisted-seam": _Kind(_WARNING, "the cloth is turned over within the seam and the garment cannot close"),
    "collapsed-edge": _Kind(
        _WARNING,
        "it becomes a loop too small to mesh, or a point",
        "look for a wrong partner among the stitches of its neighbours",
    ),
    "disconnected": _Kind(
        _WARNING,
        "a garment is one piece; a missing seam lets a part of it fall off",
        "add the missing stitches, or keep the garments in files of their own",
    ),
    "inside-out-panel": _Kind(
        _WARNING, "the loop's direction decides the right side, and with it which ends of its seams meet"
    ),
    "turned-panel": _Kind(
        _WARNING,
        "it seems to stand upside down or the wrong way round, and would twist when sewn",
        "turn the placement by 180 degrees in the panel's plane",
    ),
    "misread-angles": _Kind(
        _WARNING,
        "panels turned the wrong way are sewn in twisted",
        "--repair writes the angles anew",
    ),
    "misplaced-panel": _Kind(
        _WARNING,
        "cloth is sewn together where it stands, on the wrong part of the body or beside it",
        "move its translation to where it is worn",
    ),
    "high-sleeve": _Kind(
        _WARNING,
        "it was placed for a body in T-pose; this body's arms hang down, and pass through the cloth",
        "--repair turns it down to the arm",
    ),
    "spread-leg": _Kind(
        _WARNING,
        "it was placed for a body with its legs apart, and is sewn together beside the leg",
        "--repair turns it down to the leg",
    ),
    "far-placement": _Kind(
        _WARNING,
        "its seams are stretched over metres before sewing and catch on the body",
        "move its translation closer; check properties.units_in_meter",
    ),
    "inside-body": _Kind(
        _WARNING,
        "cloth that starts inside the body is hard to get out by draping",
        "move its translation outward",
    ),
}
"""By code."""


def found(code: str, message: str, **more: Any) -> Finding:
    """A finding; what is not given here is as in the table.

    Args:
        code: In the table.
        message: What was found, with the value.
        more: Other fields of `Finding`: its place and value, and what is not as usual.
    """
    kind = _KINDS[code]
    usual = Finding(code, kind.severity, message, why=kind.why, repair=kind.repair)
    return replace(usual, **more)
