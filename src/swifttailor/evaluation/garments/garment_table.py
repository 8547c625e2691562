"""A summary of garments as tables for people, beside the paper's rows."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from swifttailor.evaluation.garments.score import FEW_POINTS, POINTS
from swifttailor.evaluation.garments.summary import Summary
from swifttailor.evaluation.mean import Means, mean_in
from swifttailor.evaluation.paper_rows import GarmentRow
from swifttailor.evaluation.text_table import Column, Row, text_table

Cells = Sequence[tuple[str, Column, Literal["mean", "median"], float]]

_DISTANCES: Cells = (
    ("vertex_mean_cm", Column("vertex cm"), "mean", 1),
    ("vertex_mean_cm", Column("median"), "median", 1),
    ("vertex_p90_cm", Column("p90 cm"), "mean", 1),
    ("surface_cm", Column("surface cm"), "mean", 1),
    ("surface_floor_cm", Column("floor"), "mean", 1),
    ("chamfer_cm2", Column("CD cm2"), "mean", 1),
    ("chamfer_floor_cm2", Column("floor"), "mean", 1),
    ("emd_cm", Column("EMD cm"), "mean", 1),
    ("emd_floor_cm", Column("floor"), "mean", 1),
)
_SOUNDNESS: Cells = (
    ("seam_gap_median_cm", Column("seam gap cm"), "mean", 1),
    ("seam_gap_p95_cm", Column("p95 cm"), "mean", 1),
    ("inside", Column("in body %"), "mean", 100),
    ("deepest_cm", Column("deepest cm"), "mean", 1),
    ("drape_inside", Column("drape %"), "mean", 100),
    ("strain_p50", Column("strain p50 %", ".1f"), "mean", 100),
    ("strain_p95", Column("p95 %", ".1f"), "mean", 100),
    ("drape_strain_p50", Column("drape p50 %", ".1f"), "mean", 100),
    ("drape_strain_p95", Column("p95 %", ".1f"), "mean", 100),
    ("sound", Column("sound %", ".1f"), "mean", 100),
    ("accepted", Column("accepted %", ".1f"), "mean", 100),
    ("seconds", Column("s each"), "median", 1),
)


def garment_tables(summary: Summary) -> str:
    """Means over all garments and those of each kind."""
    groups = [("all", summary.garments, summary.means)]
    groups += [(kind, count, means) for kind, (count, means) in summary.kinds.items()]
    made = f"{summary.failed} more could not be made.\n" if summary.failed else ""
    return (
        f"Distances from the drape; floor: two draws of points from the drape itself\n"
        f"({POINTS:,} points; {FEW_POINTS:,} for EMD)\n\n"
        f"{_table(_DISTANCES, groups)}\n"
        "The garments themselves; seam gap before seams were closed, the rest after\n\n"
        f"{_table(_SOUNDNESS, groups)}{made}"
    )


def paper_table(summary: Summary, name: str, rows: Sequence[GarmentRow]) -> str:
    """CD, EMD, MMD and COV beside rows of the paper.

    Args:
        summary: Ours.
        name: Of our row.
        rows: Of the paper.
    """
    columns = [Column("CD"), Column("EMD"), Column("MMD"), Column("COV"), Column("n", "d")]
    means, boxed = summary.means, (summary.box_sets, summary.box_sets_floor)
    n = summary.garments
    ours = [
        (name, mean_in(means, "chamfer_cm2"), mean_in(means, "emd_cm"), summary.sets),
        ("  floor", mean_in(means, "chamfer_floor_cm2"), mean_in(means, "emd_floor_cm"), summary.sets_floor),
        (f"{name}, unit box", mean_in(means, "chamfer_box_e3"), None, boxed[0]),
        ("  floor", mean_in(means, "chamfer_box_floor_e3"), None, boxed[1]),
    ]
    lines: list[Row] = [(label, [cd, emd, found.mmd, found.coverage, n]) for label, cd, emd, found in ours]
    lines += [(f"paper: {r.name}", [r.chamfer, r.emd, r.mmd, r.coverage, None]) for r in rows]
    return (
        "CD, MMD in cm2 and EMD in cm; in the unit box times 1000, "
        f"{FEW_POINTS:,} points. COV: share.\n"
        "The paper states neither unit nor number of points, and has other data (GarmentCodeData,\n"
        "500 garments): compare with care, see docs/evaluation.md.\n\n" + text_table(columns, lines)
    )


def _table(cells: Cells, groups: Sequence[tuple[str, int, Means]]) -> str:
    columns = [Column("n", "d"), *(column for _, column, _, _ in cells)]
    rows: list[Row] = []
    for name, count, means in groups:
        values = [
            getattr(means[measure], which) * factor if measure in means else None
            for measure, _, which, factor in cells
        ]
        rows.append((name, [count, *values]))
    return text_table(columns, rows)
