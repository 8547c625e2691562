"""GarmageNet: the pattern that its stitching network writes, placed by the borders of its geometry images.

GarmageNet itself writes pickles, which are never opened: a pickle can run any program. Its stitching network,
GarmageJigsaw, writes patterns as JSON, from borders of panels in space that are OBJ files. Both are read.
"""

from __future__ import annotations

import re
from pathlib import PurePosixPath
from typing import Any

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.data.released.known_place import KnownPlace
from swifttailor.data.released.layout import Answer, Layout
from swifttailor.data.released.listing import Listing
from swifttailor.data.released.stretches import cut_at_stitches
from swifttailor.data.released.style3d_pattern import Outline, parse_style3d
from swifttailor.errors import InputError, PatternError
from swifttailor.pattern import Finding, Panel, Pattern, Placement, Reading
from swifttailor.pattern.finding_kinds import found
from swifttailor.pattern.json_values import as_index, as_list, as_object, read_json_file

_PICKLES = (".pkl", ".pickle")
_CM, _RAISED_CM = 100.0, 100.0
"""Geometry images hold (x, y - 1 m, z) in metres: 2 m of space are the numbers from -1 to 1."""
_MAX_OBJ_BYTES = 8_000_000
_WHAT_TO_GIVE = (
    "Give the folder in which GarmageJigsaw's extract_boundary_pts.py and inference_ps2es.py have written "
    "..._extracted/garment_NAME and garmagejigsaw_output/garment_NAME/garment.json"
)


def _answers(listing: Listing) -> list[Answer]:
    sewn = [file for file in listing.files if file.name == "garment.json"]
    done = {file.parent.name for file in sewn}
    unsewn = [
        file
        for file in listing.files
        if re.fullmatch(r"annotations?", file.parent.name)
        and file.stem == file.parent.parent.name not in done
    ]
    why = f"GarmageNet has not predicted how these panels are sewn. {_WHAT_TO_GIVE}."
    answers = [Answer(_input(file.parent.name), file) for file in sewn]
    answers += [Answer(_input(file.stem), None, error=why) for file in unsewn]
    known = {answer.input for answer in answers}
    why = f"GarmageNet's own output is a pickle, which is never opened: it can run programs. {_WHAT_TO_GIVE}."
    names = {folder.name for folder in listing.folders}
    return answers + [
        Answer(file.stem, None, error=why)
        for file in listing.files
        if file.suffix in _PICKLES
        and file.stem not in known | {"orig_data", "vis_resource"}
        and file.parent.name != "original_data"
        and f"garment_{file.stem}" not in names
        and _is_garmage(listing, file)
    ]


def _is_garmage(listing: Listing, file: PurePosixPath) -> bool:
    """Whether a pickle has beside it the picture that GarmageNet draws; others are no business of ours."""
    return f"{file.stem}_geo_img.png" in listing.names_in[file.parent]


def _input(name: str) -> str:
    return name.removeprefix("garment_")


def _read(listing: Listing, answer: Answer) -> Reading:
    assert answer.file is not None
    drawn = parse_style3d(read_json_file(listing.root / answer.file))
    borders = _borders(listing, answer.file.parent.name)
    if len(borders) != len(drawn.outlines):
        raise PatternError(
            f"'{answer.file}' has {len(drawn.outlines)} panels; piece_*.obj tell where {len(borders)} are. "
            "Both must come from one run."
        )
    placements = [
        _placement(outline, border) for outline, border in zip(drawn.outlines, borders, strict=True)
    ]
    outlines, stitches, lost = cut_at_stitches(drawn)
    panels = tuple(
        Panel(outline.name, cut.vertices, cut.edges, placement)
        for outline, cut, placement in zip(drawn.outlines, outlines, placements, strict=True)
    )
    pattern = _facing_outward(Pattern(panels, tuple(stitches)))
    return Reading(pattern, tuple(_findings(drawn.left_out + lost, drawn.outlines)))


def _findings(lost: int, outlines: tuple[Outline, ...]) -> list[Finding]:
    findings = []
    if lost:
        text = f"{lost} in all, which lead to inner lines, overlap others or have uneven sides"
        findings.append(found("dangling-stitch", text))
    for outline in outlines:
        if outline.lines_inside:
            text = f"{outline.lines_inside} holes or inner lines; a panel is one outline"
            findings.append(found("unknown-key", text, panel=outline.name))
    return findings


def _borders(listing: Listing, name: str) -> list[list[Floats]]:
    """Points (n, 3) cm on each edge of each panel's outline, from the folder of the extracted borders."""
    folder = next(
        (
            file.parent.parent
            for file in listing.files
            if file.name == "annotations.json" and file.parent.parent.name == name
        ),
        None,
    )
    if folder is None:
        raise InputError(
            f"Where the panels are in space is not in garment.json, and there is no folder '{name}' with "
            f"annotations/annotations.json and piece_*.obj. {_WHAT_TO_GIVE}."
        )
    names = sorted(n for n in listing.names_in.get(folder, ()) if re.fullmatch(r"piece_\d+\.obj", n))
    pieces = [_vertices(listing, folder / n) for n in sorted(names, key=lambda n: int(n[6:-4]))]
    about = next(f for f in listing.files if f.name == "annotations.json" and f.parent.parent == folder)
    notes = as_object(read_json_file(listing.root / about), str(about))
    owner = [as_index(k, "panel_instance_seg") for k in _listed(notes, "panel_instance_seg")]
    counts = [as_index(k, "contour_nes") for k in _listed(notes, "contour_nes")]
    ends = [
        [as_index(i, "edge_approx") for i in as_list(e, "edge_approx", (2,))]
        for e in _listed(notes, "edge_approx")
    ]
    if not len(pieces) == len(owner) == len(counts) or sum(counts) != len(ends):
        raise PatternError(f"'{about}' does not belong to the {len(pieces)} files piece_*.obj beside it.")
    borders, at = [], 0
    for k, (points, count) in enumerate(zip(pieces, counts, strict=True)):
        if k == 0 or owner[k] != owner[k - 1]:  # the first contour of a panel is its outline
            borders.append([_between(points, *pair) for pair in ends[at : at + count]])
        at += count
    return borders


def _listed(notes: dict[str, Any], key: str) -> list[Any]:
    return as_list(notes.get(key), key)


def _between(points: Floats, first: int, last: int) -> Floats:
    if not (0 <= first < len(points) and 0 <= last < len(points)):
        raise PatternError(f"edge_approx: points {first} and {last} of {len(points)} do not exist.")
    return points[first : last + 1] if first < last else np.concatenate([points[first:], points[: last + 1]])


def _vertices(listing: Listing, file: PurePosixPath) -> Floats:
    """The points of an OBJ without faces, cm in this package's frame."""
    path = listing.root / file
    try:
        if path.stat().st_size > _MAX_OBJ_BYTES:
            raise InputError(f"'{file}' has more than {_MAX_OBJ_BYTES // 10**6} MB; is it a panel's border?")
        lines = path.read_text(encoding="utf-8").splitlines()
        rows = [[float(x) for x in line.split()[1:4]] for line in lines if line.startswith("v ")]
        points = np.array(rows, float).reshape(-1, 3)
    except OSError as error:
        raise InputError(f"Cannot read '{file}': {error.strerror or error}.") from error
    except ValueError as error:
        raise InputError(f"'{file}' is no OBJ of points that can be read: {error}.") from error
    if len(points) < 3 or not np.isfinite(points).all() or np.abs(points).max() > 100:
        raise InputError(f"'{file}' holds no border: at least 3 points within 100 m are expected.")
    return points * _CM + [0.0, _RAISED_CM, 0.0]


def _placement(outline: Outline, border: list[Floats]) -> Placement:
    """The rigid motion that brings an outline nearest to its border in space, which is bent."""
    if len(border) != len(outline.edges):
        raise PatternError(
            f"panel '{outline.name}' has {len(outline.edges)} edges, and {len(border)} in space."
        )
    flat = np.concatenate([_spread(e, len(b)) for e, b in zip(outline.edges, border, strict=True)])
    flat = np.column_stack([flat, np.zeros(len(flat))])
    space = np.concatenate(border)
    middle, target = flat.mean(axis=0), space.mean(axis=0)
    u, _, vt = np.linalg.svd((space - target).T @ (flat - middle))
    turn = u @ np.diag([1.0, 1.0, np.sign(np.linalg.det(u @ vt)) or 1.0]) @ vt
    return Placement().moved(turn, target - turn @ middle)


def _spread(points: Floats, count: int) -> Floats:
    """Points (count, 2) at equal distances along a polyline."""
    steps = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    at = np.linspace(0.0, steps[-1], count)
    return np.stack([np.interp(at, steps, points[:, axis]) for axis in (0, 1)], axis=1)


def _facing_outward(pattern: Pattern) -> Pattern:
    """The pattern with all loops turned if most of its cloth has its right side towards the body."""
    outward = 0.0
    for panel in pattern.panels:
        normal = panel.placement.matrix()[:, 2] * panel.signed_area()
        middle = panel.to_world(panel.vertices).mean(axis=0) * [1.0, 0.0, 1.0]
        outward += float(normal @ middle) / max(float(np.linalg.norm(middle)), 1e-9)
    if outward >= 0:
        return pattern
    last = {p.name: len(p.edges) - 1 for p in pattern.panels}
    stitches = tuple(
        type(s)(*(ref._replace(edge=last[ref.panel] - ref.edge) for ref in s.sides), s.right_wrong)
        for s in pattern.stitches
    )
    return Pattern(tuple(p.reversed() for p in pattern.panels), stitches)


GARMAGENET = Layout(
    "garmagenet",
    "GarmageNet",
    "garment_NAME/garment.json",
    "intrinsic",
    _answers,
    _read,
    place=KnownPlace(raised=0.0, arms_level=False),
)
