"""What a sewist should know about an allowance that could not be made as asked."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from swifttailor.arrays import Floats
from swifttailor.making.cut_line import CutLine, Run, outward
from swifttailor.pattern.finding import Finding, Severity

_STEP_CM = 0.5
_ACCURACY_CM = 0.01


def overlap_findings(piece: str, panel: str, runs: Sequence[Run], cut: CutLine) -> list[Finding]:
    """Says where allowances of different edges run into each other, and where a corner was cut short.

    Args:
        piece: Its name.
        panel: The panel it is drawn from.
        runs: The sew line.
        cut: What came of it.
    """
    found = []
    polygon = shapely.Polygon(cut.outline)
    filled = 0.0
    for run in runs:
        if run.allowance <= 0:
            continue
        points, normals = sampled(run, _STEP_CM)
        edge = points + run.allowance * normals
        depth = shapely.distance(polygon.exterior, shapely.points(edge))
        # In a sharp inner corner a little of both allowances always coincides.
        hidden = (depth > 0.25 * run.allowance) & shapely.contains_xy(polygon, edge)
        filled += float(hidden.sum()) * _STEP_CM
    if filled > 6.0 or cut.closed_holes:
        found.append(
            Finding(
                "allowance-overlap",
                Severity.INFO,
                f"{piece}: for {filled:.0f} cm, edges are closer together than their allowances, as in a "
                "narrow slit; "
                "the allowances were joined. Sew along the dashed lines, then cut between them",
                panel=panel,
                value=round(filled, 1),
            )
        )
    if cut.blunted:
        found.append(
            Finding(
                "blunt-corner",
                Severity.INFO,
                f"{piece}: the allowance of {len(cut.blunted)} sharp corner{'s' * (len(cut.blunted) > 1)} "
                "is cut off square",
                panel=panel,
                value=len(cut.blunted),
            )
        )
    return found


def allowance_faults(runs: Sequence[Run], cut: CutLine) -> list[str]:
    """Everything that is wrong with a cut line; nothing when it can be cut.

    Checked anew from the sew line: the cut line is one loop that does not cross itself; the piece lies
    within it; and every point of the sew line has its whole allowance, straight outward, except where a
    hem's end is shaped to be folded.
    """
    faults = []
    polygon = shapely.Polygon(cut.outline)
    if not polygon.is_valid:
        faults.append(f"the cut line is broken: {shapely.is_valid_reason(polygon)}")
        polygon = shapely.make_valid(polygon)
    grown = polygon.buffer(_ACCURACY_CM)
    turned = np.array(cut.turned).reshape(-1, 2)
    for run in runs:
        points, normals = sampled(run, _STEP_CM / 2)
        if not shapely.contains_xy(grown, points).all():
            faults.append(f"edge {run.edge}: the sew line leaves the cut line")
        reach = 3.5 * max(r.allowance for r in runs) if len(turned) else 0.0
        if len(turned) and reach:
            away = np.hypot(*(points[:, None] - turned[None]).transpose(2, 0, 1)).min(axis=1)
            points, normals = points[away > reach], normals[away > reach]
        short = ~shapely.contains_xy(grown, points + run.allowance * normals)
        if short.any():
            faults.append(
                f"edge {run.edge}: the allowance is missing at {points[short][0].round(2).tolist()}"
            )
    return faults


def sampled(run: Run, step: float) -> tuple[Floats, Floats]:
    """Points (n, 2) along a run, not its ends, and outward unit normals (n, 2) there."""
    sizes = np.hypot(*np.diff(run.points, axis=0).T)
    length = np.append(0.0, np.cumsum(sizes))
    count = max(int(length[-1] / step), 1)
    at = (np.arange(count) + 0.5) / count * length[-1]
    segment = np.clip(np.searchsorted(length, at, side="right") - 1, 0, len(sizes) - 1)
    share = (at - length[segment]) / np.maximum(sizes[segment], 1e-12)
    points = run.points[segment] + share[:, None] * np.diff(run.points, axis=0)[segment]
    return points, outward(run.points)[segment]
