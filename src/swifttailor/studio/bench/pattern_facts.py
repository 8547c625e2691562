"""What is known of a pattern at once: findings with their places, seams with their mismatch."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

from swifttailor.pattern import EdgeRef, Finding, Pattern, Severity, check_pattern, repair_pattern
from swifttailor.pattern.check import BodyProbe
from swifttailor.pattern.check.crossings import find_crossing
from swifttailor.pattern.check.outline import trace_outline
from swifttailor.studio.bench.wearers import wearing

_BY_REPAIR = "--repair"
_OF_CROSSINGS = ("self-crossing", "near-crossing", "self-touching")


def body_probe(pattern: Pattern) -> BodyProbe:
    """Who wears a pattern, for checks.

    Raises:
        InputError: No body has the measures that it names.
    """
    return wearing(pattern.drafted_for).probe


def check(pattern: Pattern, reader_findings: Sequence[Finding] = ()) -> tuple[Finding, ...]:
    """What a check finds in a pattern around the body that wears it."""
    return check_pattern(pattern, reader_findings=tuple(reader_findings), body=body_probe(pattern))


def finding_infos(
    pattern: Pattern, findings: Sequence[Finding], *, try_mending: bool = False
) -> list[dict[str, Any]]:
    """Findings with the places to show.

    Args:
        pattern: In which they were found.
        findings: Of `check`.
        try_mending: Whether what can be mended is found out by mending; else what usually can be is said.
    """
    candidates = [f for f in findings if _BY_REPAIR in f.repair and f.severity is not Severity.INFO]
    left = Counter[tuple[str, str]]()
    if candidates and try_mending:
        left = Counter((f.code, f.panel) for f in repair_pattern(pattern, body=body_probe(pattern)).remaining)
    infos = []
    for finding in findings:
        edges, points = _places(pattern, finding)
        mendable = finding in candidates and not left[finding.code, finding.panel]
        value = finding.to_json()
        del value["value"]
        infos.append(value | {"edges": edges, "points": points, "mendable": mendable})
    return infos


def seam_infos(pattern: Pattern, findings: Sequence[Finding] = ()) -> list[dict[str, Any]]:
    """The seams of a pattern, those left out that name edges which do not exist."""
    uneven = {f.stitch for f in findings if f.code == "uneven-seam"}
    known = {p.name: len(p.edges) for p in pattern.panels}
    infos = []
    for k, stitch in enumerate(pattern.stitches):
        if any(not 0 <= r.edge < known.get(r.panel, 0) for r in stitch.sides):
            continue
        first, second = (_length(pattern, r) for r in stitch.sides)
        infos.append(
            {
                "stitch": k,
                "first": _place(stitch.first) | {"length": round(first, 3)},
                "second": _place(stitch.second) | {"length": round(second, 3)},
                "right_wrong": stitch.right_wrong,
                "mismatch": round(first - second, 3),
                "ratio": round(max(first, second) / max(min(first, second), 1e-3), 4),
                "uneven": k in uneven,
            }
        )
    return infos


def _length(pattern: Pattern, ref: EdgeRef) -> float:
    panel = pattern.panels[pattern.panel_index(ref.panel)]
    return float(trace_outline(panel).lengths[ref.edge])


def _place(ref: EdgeRef) -> dict[str, Any]:
    return {"panel": ref.panel, "edge": ref.edge}


def _places(pattern: Pattern, finding: Finding) -> tuple[list[dict[str, Any]], list[tuple[float, float]]]:
    """Edges to show and panel-local points to zoom to."""
    panels = {p.name: p for p in pattern.panels}
    if finding.stitch is not None and 0 <= finding.stitch < len(pattern.stitches):
        sides = pattern.stitches[finding.stitch].sides
        return [_place(r) for r in sides if r.panel in panels and r.edge < len(panels[r.panel].edges)], []
    panel = panels.get(finding.panel)
    if panel is None:
        return [], []
    if finding.code in _OF_CROSSINGS:
        crossing = find_crossing(trace_outline(panel))
        if crossing is not None:
            edges = [{"panel": panel.name, "edge": int(k)} for k in dict.fromkeys(crossing.edges)]
            return edges, [(float(crossing.point[0]), float(crossing.point[1]))]
    if finding.edge is not None and 0 <= finding.edge < len(panel.edges):
        middle = panel.chord(finding.edge).mean(axis=0)
        return [{"panel": panel.name, "edge": finding.edge}], [(float(middle[0]), float(middle[1]))]
    middle = panel.vertices.mean(axis=0)
    return [], [(float(middle[0]), float(middle[1]))]
