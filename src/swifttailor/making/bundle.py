"""A bundle for pattern and garment CAD such as CLO and Style3D: one .zip file."""

from __future__ import annotations

import csv
import io
import json
import zipfile
from pathlib import Path

from swifttailor.atomic_files import write_bytes
from swifttailor.garment.seam_names import seam_name
from swifttailor.making.allowances import Allowances
from swifttailor.making.flat_panels import panels_obj
from swifttailor.making.pattern_dxf import dxf_text
from swifttailor.making.pieces import CuttingPlan, cutting_plan
from swifttailor.making.sewing_steps import steps_markdown
from swifttailor.pattern import to_specification

_LONG_AGO = (1980, 1, 1, 0, 0, 0)
"""Files contain no dates; this is the first that a .zip file knows."""
_README = """{name}: a sewing pattern for garment CAD

cut-lines-astm.dxf   pieces with seam allowance, by ASTM D6673-10 (millimetres; grain along x)
cut-lines-aama.dxf   the same with the AAMA header, for programs that accept no other
sew-lines-astm.dxf   the same pieces without allowance: layer 1 is the sew line. Import this one to simulate
panels.obj           all panels, flat, placed around the body (centimetres, Y up), a group each; groups called
                     seam_NUMBER:PANEL.EDGE+PANEL.EDGE hold a line for each pair of vertices to be sewn
seams.csv            what is sewn to what: panels, edges, lengths in cm, the number printed on the pieces
steps.md             in what order to sew
pattern.json         the pattern itself, in GarmentCode's format

In the DXF files, the texts "Seam N" (layer 15) stand beside the edges; N is the number in seams.csv.
"""


def write_bundle(
    plan: CuttingPlan, path: Path | str, *, edge_length: float = 2.0, overwrite: bool = False
) -> Path:
    """Writes the bundle.

    Args:
        plan: Pieces and seams.
        path: File to write.
        edge_length: Of the panels' mesh, cm.
        overwrite: Whether another file of that name is replaced.

    Raises:
        InputError: The file cannot be written.
        GeometryError: A panel cannot be meshed.
    """
    pattern = plan.sewn.pattern
    bare = cutting_plan(pattern, Allowances(0.0, 0.0, 0.0, 0.0), trims=plan.trims)
    files = {
        "README.txt": _README.format(name=plan.name),
        "cut-lines-astm.dxf": dxf_text(plan, seam_names=True),
        "cut-lines-aama.dxf": dxf_text(plan, dialect="aama", seam_names=True),
        "sew-lines-astm.dxf": dxf_text(bare, seam_names=True),
        "panels.obj": panels_obj(pattern, edge_length, metres=False),
        "seams.csv": seams_table(plan),
        "steps.md": steps_markdown(plan),
        "pattern.json": json.dumps(to_specification(pattern), indent=1) + "\n",
    }
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as bundle:
        for name, text in files.items():
            bundle.writestr(zipfile.ZipInfo(name, _LONG_AGO), text.encode(), zipfile.ZIP_DEFLATED)
    return write_bytes(path, buffer.getvalue(), overwrite=overwrite)


def seams_table(plan: CuttingPlan) -> str:
    """Every stitch of the pattern as a line of CSV."""
    rows = io.StringIO()
    table = csv.writer(rows, lineterminator="\n")
    table.writerow(
        ["stitch", "name", "number_on_pieces", "kind", "first_panel", "first_edge", "first_piece",
        "first_length_cm",
         "second_panel", "second_edge", "second_piece", "second_length_cm", "right_wrong"]
    )  # fmt: skip
    stitches = plan.sewn.pattern.stitches
    of_stitch = {k: seam for seam in plan.seams for k in seam.stitches}
    for k in sorted(of_stitch):
        stitch, seam = stitches[k], of_stitch[k]
        sides: list[object] = []
        for ref in stitch.sides:
            sides += [ref.panel, ref.edge, plan.piece_of(ref.panel).name, f"{plan.sewn.length(ref):.3f}"]
        name = seam_name(k, stitch)
        table.writerow([k, name, seam.number, seam.role.words, *sides, int(stitch.right_wrong)])
    return rows.getvalue()
