"""Reads files to sew from back, and compares nesting with bounding boxes, over many patterns.

.venv/bin/python benchmarks/sewing_files.py ../shared/garmentcode/validation.jsonl.gz --limit 100
"""

from __future__ import annotations

import argparse
import io
import tempfile
from collections import Counter
from itertools import islice
from pathlib import Path

import ezdxf
import numpy as np
import shapely

from benchmarks.small_dxf import read_dxf
from swifttailor.errors import SwiftTailorError
from swifttailor.garment.formats import read_garment_mesh, write_garment_mesh
from swifttailor.garment.seam_names import read_seam_name
from swifttailor.garment.triangle_mesh import TriangleMesh
from swifttailor.making import CuttingPlan, cutting_plan
from swifttailor.making.flat_panels import flat_panels
from swifttailor.making.nesting import nest, overlap, pack_boxes
from swifttailor.making.pattern_dxf import dxf_text, on_table
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.uv_layout import lay_out_uv
from swifttailor.pattern import repair_pattern
from swifttailor.pattern.pattern_list import read_patterns


def distance_mm(first: np.ndarray, second: np.ndarray) -> float:
    """Largest distance between two closed outlines in mm."""
    a, b = shapely.LinearRing(first), shapely.LinearRing(second)
    fine_a, fine_b = shapely.segmentize(a, 1.0), shapely.segmentize(b, 1.0)
    one = shapely.distance(b, shapely.points(shapely.get_coordinates(fine_a))).max()
    two = shapely.distance(a, shapely.points(shapely.get_coordinates(fine_b))).max()
    return float(max(one, two))


def dxf_error(plan: CuttingPlan) -> float:
    """Largest distance in mm of outlines read back from the pieces', by both readers, with both headers."""
    worst = 0.0
    for dialect in ("astm", "aama"):
        text = dxf_text(plan, dialect=dialect)
        blocks, _ = read_dxf(text)
        document = ezdxf.read(io.StringIO(text.replace("\r\n", "\n")))
        assert not document.audit().errors
        inserts = [e.dxf.name for e in document.modelspace().query("INSERT")]
        assert inserts == list(blocks) and len(blocks) == len(plan.pieces)
        for piece, (name, block) in zip(plan.pieces, blocks.items(), strict=True):
            theirs = document.blocks[name]
            for layer, outline in ((1, piece.cut.outline), (14, piece.sew_line)):
                expected = on_table(outline)
                (line,) = theirs.query(f'POLYLINE[layer=="{layer}"]')
                read = np.array([(v.dxf.location.x, v.dxf.location.y) for v in line.vertices])
                worst = max(worst, distance_mm(read, expected), distance_mm(block.outline(layer), expected))
            assert block.texts(1)["Piece Name"] == piece.name
            assert len(block.on(4, "POINT")) == sum(n.teeth for n in piece.notches)
            assert len(block.on(7, "LINE")) == 1
    return worst


def seams_lost(plan: CuttingPlan) -> tuple[int, int]:
    """Seams in all, and those not found again through GLB, USD and OBJ, sewn and as flat panels."""
    pattern = plan.sewn.pattern
    flat = flat_panels(pattern, 4.0)
    mesh = mesh_pattern(pattern, 4.0)
    names = tuple(dict.fromkeys(flat.line_names))
    numbers = [read_seam_name(n)[0] for n in names]
    by_stitch = {s.stitch: s for s in mesh.seams}
    vertices = flat.vertices[mesh.representative]
    lines = tuple(by_stitch[k].vertices for k in numbers)
    panels = tuple(p.name for p in pattern.panels)
    whole = TriangleMesh(
        vertices,
        mesh.faces,
        lay_out_uv(mesh)[0],
        mesh.flat_faces,
        panels,
        mesh.face_panel,
        lines,
        line_names=names,
    )
    lost = 0
    with tempfile.TemporaryDirectory() as folder:
        for ending in ("glb", "usdc", "obj"):
            for name, sent in (("sewn", whole), ("flat", flat)):
                path = write_garment_mesh(sent, Path(folder) / f"{name}.{ending}")
                back = read_garment_mesh(path)
                found = {}
                for line_name, line in zip(back.line_names, back.lines, strict=True):
                    found.setdefault(line_name, []).append(back.vertices[line])
                expected = {}
                for line_name, line in zip(sent.line_names, sent.lines, strict=True):
                    expected.setdefault(line_name, []).append(sent.vertices[line])
                for line_name, places in expected.items():
                    got = found.get(line_name, [])
                    same = len(got) == len(places) and all(
                        np.allclose(a, b, atol=1e-3) for a, b in zip(got, places, strict=True)
                    )
                    number, stitch = read_seam_name(line_name)
                    lost += not (same and pattern.stitches[number] == stitch)
    return len(names), lost


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("patterns", type=Path)
    parser.add_argument("--limit", type=int, default=100)
    parser.add_argument("--width", type=float, default=140.0)
    parser.add_argument("--seconds", type=int, default=5)
    parser.add_argument("--parts", nargs="+", default=["dxf", "nesting", "seams"])
    options = parser.parse_args()
    counts: Counter[str] = Counter()
    worst_dxf, worst_overlap = 0.0, 0.0
    nested, boxed = [], []
    for entry in islice(read_patterns(options.patterns), options.limit):
        pattern = entry.read().pattern
        try:
            plan = cutting_plan(pattern)
        except SwiftTailorError:
            counts["repaired first"] += 1
            plan = cutting_plan(repair_pattern(pattern).pattern)
        counts["patterns"] += 1
        if "dxf" in options.parts:
            worst_dxf = max(worst_dxf, dxf_error(plan))
        if "nesting" in options.parts:
            try:
                marker = nest(plan.pieces, options.width, seconds=options.seconds)
                boxes = pack_boxes(plan.pieces, options.width)
            except SwiftTailorError:
                counts["wider than the cloth"] += 1
            else:
                nested.append((marker.length, marker.waste))
                boxed.append((boxes.length, boxes.waste))
                worst_overlap = max(worst_overlap, overlap(marker))
                counts["no better than boxes"] += marker.length >= boxes.length
        if "seams" in options.parts:
            seams, lost = seams_lost(plan)
            counts["seams"] += seams
            counts["seams lost, of six files each"] += lost
    for name, count in counts.items():
        print(f"{name}: {count}")
    if "dxf" in options.parts:
        print(f"DXF outlines read back: {worst_dxf:.4f} mm away at most")
    if nested:
        ours, theirs = np.array(nested), np.array(boxed)
        print(f"nesting on {options.width:g} cm, {options.seconds} s each, {len(ours)} patterns:")
        print(f"  cloth in all {ours[:, 0].sum() / 100:.1f} m, by boxes {theirs[:, 0].sum() / 100:.1f} m")
        medians = 100 * np.median(ours[:, 1]), 100 * np.median(theirs[:, 1])
        print(f"  waste: median {medians[0]:.1f} %, by boxes {medians[1]:.1f} %")
        print(f"  largest overlap of two pieces {worst_overlap:.6f} cm2")


if __name__ == "__main__":
    main()
