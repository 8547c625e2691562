"""Pockets, buttons and zips are marked where the pattern has them, whatever becomes of its panels."""

from __future__ import annotations

import io
from dataclasses import replace

import ezdxf
import numpy as np
import pytest
import shapely

from swifttailor.making import cutting_plan
from swifttailor.making.centre_folds import fold_centres, fold_with_trims
from swifttailor.making.decoration_steps import decorations
from swifttailor.making.marker_files import marker_dxf
from swifttailor.making.nesting import pack_boxes
from swifttailor.making.notch_check import notch_faults
from swifttailor.making.overlaps import allowance_faults
from swifttailor.making.pattern_dxf import DRILL_HOLE, INTERNAL, dxf_text, on_table
from swifttailor.making.piece_drawing import draw_piece
from swifttailor.making.size_run import size_run
from swifttailor.making.trim_drawing import shown_marks
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.trims import (
    TRIMS,
    Belt,
    Bow,
    Button,
    Frill,
    Layer,
    Patch,
    Stirrup,
    place_trims,
    trims_that_fit,
)

NAMES = (
    "denim-jacket", "trench coat", "trousers", "shirt-dress", "zipped hoodie", "hoodie", "dungarees",
    "joggers", "polo shirt", "suit", "coat with big buttons", "puffer", "turned-up trousers", "tunic",
    "dirndl", "blouse", "piped shirt", "yoked blouse", "cape", "working vest", "track top", "track bottoms",
    "biker jacket", "raincoat", "duffle coat",
    "banded dress", "sundress", "vest", "knitted jacket", "pyjama bottoms", "slip",
    "suit trousers", "dinner trousers", "hakama",
    "keyhole top", "police shirt", "cheongsam", "sari",
    "hospital gown", "smock", "corset dress", "evening shirt", "ringer tee",
    "ripped jeans", "jeans torn at the knees", "dress buttoned to the waist", "cycling jersey", "tabard",
    "working trousers", "jeans torn at the left", "jeans torn at the right",
    "milkmaid dress", "ruched dress", "cowl dress", "cold shoulder top", "cut-out dress", "patched jumper",
    "draped gown", "tucked blouse", "princess dress", "paper bag trousers",
    "bride's dress", "royal bride's dress", "princess gown", "caped dress",
    "flapper dress", "heart tee", "star hoodie", "pleated blouse", "Norfolk jacket", "pressed blouse",
    "blouse pleated at the neck", "blouse pleated at the shoulders", "blouse gathered at the neck",
    "blouse gathered at the shoulders",
    "stitched jeans", "seamed denim jacket", "buckled dungarees", "kilt", "folded leggings", "running top",
    "girl's dress", "dirndl with a blouse", "maternity top", "skort",
    "dress with frilled shoulders", "illusion dress", "bustle skirt", "crinoline", "wrap top",
    "pleated pencil skirt", "dress of panels",
    "Oxford shirt",
)  # fmt: skip


def on_piece(plan, panel: str, points) -> np.ndarray:
    """Panel-local points on the paper, found anew: the panel's outline is laid on the sew line."""
    piece, own = plan.piece_of(panel), plan.sewn.panel(panel)
    first = plan.sewn.panel((*piece.panels, *piece.mirrored)[0])
    sign = np.array([-1.0 if panel in piece.mirrored else 1.0, 1.0])
    outline, drawn = own.outline * sign, first.outline
    shift = (drawn.min(axis=0) + drawn.max(axis=0)) / 2 - (outline.min(axis=0) + outline.max(axis=0)) / 2
    laid, paper = shapely.Polygon(outline + shift), shapely.Polygon(drawn)
    assert shapely.symmetric_difference(laid, paper).area < 1e-3 * paper.area
    return np.asarray(points) @ own.turn.T * sign + shift


def away(points, mark) -> float:
    """How far a mark lies from where it belongs, cm."""
    if mark.kind in ("button", "hole"):
        return float(np.hypot(*(mark.points[0] - points[0])))
    shape = shapely.LinearRing if mark.kind == "outline" else shapely.LineString
    return float(shapely.hausdorff_distance(shape(mark.points), shape(points)))


@pytest.mark.parametrize("name", NAMES)
def test_marks_lie_where_the_pattern_has_them(trimmed, trimmed_plans, name):
    plan, pattern = trimmed_plans[name], trimmed[name]
    trims = place_trims(pattern)
    assert {trim.trim for trim in trims} == set(pattern.trims)
    for trim in trims:
        if isinstance(trim, Belt | Frill | Bow | Layer | Stirrup):  # which no mark on a panel tells
            continue
        marks = [m for m in plan.piece_of(trim.panel).marks if m.trim == trim.trim and trim.panel in m.panels]
        if isinstance(trim, Button):
            points = [trim.at]
            marks = [m for m in marks if m.kind == "button" and m.radius == trim.radius]
        else:
            is_line = trim.look == "dark"
            points = (trim.first + trim.second) / 2 if is_line else trim.outline
            marks = [m for m in marks if m.kind == ("line" if is_line else "outline")]
        assert min(away(on_piece(plan, trim.panel, points), mark) for mark in marks) < 0.01, trim


FRONTS = {"left_ftorso", "right_ftorso"}


@pytest.mark.parametrize("name", NAMES)
def test_every_mark_has_its_trim(trimmed_plans, name):
    """Nothing is drawn twice or elsewhere: outlines and buttons are as many as the pattern has on panels."""
    plan = trimmed_plans[name]
    for piece in plan.pieces:
        if piece.trim:
            continue
        panels = (*piece.panels, *piece.mirrored)
        for kind, wanted in (
            ("outline", [t for t in plan.trims if isinstance(t, Patch) and t.look != "dark"]),
            ("button", [t for t in plan.trims if isinstance(t, Button)]),
        ):
            own = [t for t in wanted if t.panel in panels]
            if kind == "button" and len(FRONTS.intersection(panels)) == 1:
                # Where fronts lie over each other, one has the buttonholes of the other's buttons.
                rows = [t for t in wanted if t.trim == "buttons" and t.panel in FRONTS.difference(panels)]
                own += rows
            places = shapely.union_all(
                [shapely.Point(on_piece(plan, t.panel, _points(t)).mean(axis=0)).buffer(0.02) for t in own]
            )
            assert len(shapely.get_parts(places)) == sum(m.kind == kind for m in piece.marks)
        assert all(set(m.panels) <= set(panels) for m in piece.marks)


def _points(trim):
    return [trim.at] if isinstance(trim, Button) else trim.outline


def test_plans_with_trims_are_sound(trimmed_plans):
    assert tuple(trimmed_plans) == NAMES
    assert {trim.trim for plan in trimmed_plans.values() for trim in plan.trims} == set(TRIMS)
    for name, plan in trimmed_plans.items():
        assert notch_faults(plan) == [], name
        names = [p.name for p in plan.pieces]
        assert len(set(names)) == len(names)
        for piece in plan.pieces:
            assert allowance_faults(piece.runs, piece.cut) == [], (name, piece.name)


def test_a_pattern_without_trims_has_no_marks(drafts):
    for pattern in list(drafts.values())[:6]:
        plan = cutting_plan(replace(pattern, trims=()))
        assert not plan.trims and plan.closing is None
        assert not any(piece.marks or piece.trim for piece in plan.pieces)


def test_what_is_on_one_side_alone_says_so(trimmed_plans):
    words = {m.words for p in trimmed_plans["shirt-dress"].pieces for m in p.marks}
    assert "breast pocket, left only" in words
    words = {m.words for p in trimmed_plans["trousers"].pieces for m in p.marks}
    assert "fly: topstitching, left only" in words and "back pocket" in words


def test_on_the_fold_both_sides_are_drawn_once():
    """A skirt that is its own mirror image: two patch pockets, and a zip in the left side seam."""
    plan = cutting_plan(replace(draft("shirt-dress"), trims=("patch pockets", "side zip")))
    skirt = next(p for p in plan.pieces if "skirt_front" in p.panels)
    assert skirt.on_fold
    whole, half = skirt.marks, shown_marks(skirt)
    assert sum(m.kind == "outline" for m in whole) == 2 and sum(m.kind == "outline" for m in half) == 1
    assert all(m.points[:, 0].min() >= skirt.middle - 0.01 for m in half)
    assert {m.words for m in half} == {"patch pocket", "", "zip, left only"}
    right, left = sorted((m for m in whole if m.kind == "outline"), key=lambda m: m.points[:, 0].mean())
    turned = right.moved(-1.0, (2 * skirt.middle, 0.0))
    assert away(left.points, turned) < 0.05 and left.side == "left" and right.side == "right"


@pytest.mark.parametrize("name", ["half zip", "polo placket"])
def test_folded_middles_take_their_marks_along(name):
    pattern = replace(draft("hoodie"), trims=(name, "kangaroo pocket"))
    folded, trims = fold_with_trims(pattern, front=True, back=True)
    (front,) = (p for p in folded.panels if "ftorso" in p.name)
    assert {t.panel for t in trims} == {front.name} and len(trims) == len(place_trims(pattern))
    plan = cutting_plan(folded, trims=trims)
    piece = plan.piece_of(front.name)
    assert piece.on_fold
    one, other = (m for m in piece.marks if m.words == "kangaroo pocket")
    assert away(one.points, other.moved(-1.0, (2 * piece.middle, 0.0))) < 0.01
    assert one.points[:, 0].max() == pytest.approx(piece.middle, abs=0.01) or (
        one.points[:, 0].min() == pytest.approx(piece.middle, abs=0.01)
    )
    assert sum(m.words == "kangaroo pocket" for m in shown_marks(piece)) == 1
    (pocket,) = (p for p in plan.pieces if p.name == "Kangaroo pocket")
    assert pocket.instruction == "Cut 1 on the fold"
    # Distances to the panel's corners are those that they were before.
    old = pattern.panel("right_ftorso")
    patch = next(t for t in place_trims(pattern) if t.panel == old.name and t.trim == "kangaroo pocket")
    corner = old.vertices[np.argmax(np.abs(old.to_world(old.vertices)[:, 0]))]
    away_before = np.hypot(*(patch.outline - corner).T)
    moved = [
        np.hypot(*(t.outline - v).T)
        for t in trims
        if isinstance(t, Patch) and t.trim == "kangaroo pocket"
        for v in front.vertices
    ]
    assert min(np.abs(d - away_before).max() for d in moved) < 0.01


@pytest.mark.parametrize("name", ["zip", "buttons", "button placket", "double-breasted buttons"])
def test_what_opens_a_front_keeps_it_in_halves(name):
    pattern = replace(draft("coat"), trims=(name,))
    folded = fold_centres(pattern, front=True, back=False)
    assert len(folded.panels) == len(pattern.panels)
    assert cutting_plan(folded).closing is not None


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("dialect", ["astm", "aama"])
def test_dxf_files_have_the_marks(trimmed_plans, name, dialect):
    plan = trimmed_plans[name]
    blocks = ezdxf.read(io.StringIO(dxf_text(plan, dialect=dialect).replace("\r\n", "\n"))).blocks
    for piece in plan.pieces:
        block = next(b for b in blocks for t in b.query("TEXT") if t.dxf.text == f"Piece Name:{piece.name}")
        lines = [
            (np.array([tuple(v.dxf.location)[:2] for v in p.vertices]), p.is_closed)
            for p in block.query(f'POLYLINE[layer=="{INTERNAL}"]')
        ]
        drills = np.array([tuple(p.dxf.location)[:2] for p in block.query(f'POINT[layer=="{DRILL_HOLE}"]')])
        for mark in piece.marks:
            if mark.kind == "button":
                assert np.abs(drills - on_table(mark.points)).sum(axis=1).min() < 0.02
            wanted = [mark.points] if mark.kind in ("outline", "line") else []
            for points in [*wanted, *([] if mark.hole is None else [mark.hole])]:
                same = [
                    p for p, closed in lines if len(p) == len(points) and closed == (mark.kind == "outline")
                ]
                assert min(np.abs(p - on_table(points)).max() for p in same) < 0.01
        texts = {t.dxf.text for t in block.query("TEXT")}
        assert {m.words for m in piece.marks if m.words} <= texts


def test_drawings_and_markers_have_the_marks(trimmed_plans):
    for plan in trimmed_plans.values():
        for piece in plan.pieces:
            drawn = [s for s in draw_piece(piece, "x").strokes if s.style.name == "trim"]
            lines = [m for m in shown_marks(piece) if m.kind in ("outline", "line")]
            assert len(drawn) == len(lines)
            assert all(any(np.array_equal(s.points, m.points) for s in drawn) for m in lines)
    plan = trimmed_plans["denim-jacket"]
    marker = pack_boxes(plan.pieces, 150.0)
    assert {item.piece.name for item in marker.laid} == {p.name for p in plan.pieces}
    space = ezdxf.read(io.StringIO(marker_dxf(marker, "x").replace("\r\n", "\n"))).modelspace()
    lines = space.query(f'POLYLINE[layer=="{INTERNAL}"]')
    laid = [
        item.place(m.points) * 10.0 for item in marker.laid for m in item.piece.marks if m.kind == "outline"
    ]
    found = [np.array([tuple(v.dxf.location)[:2] for v in line.vertices]) for line in lines]
    assert laid and all(
        min(np.abs(f - wanted).max() for f in found if len(f) == len(wanted)) < 0.01 for wanted in laid
    )


def test_sizes_have_marks_of_their_own():
    names = ("button placket", "chest pocket")
    patterns = [
        ("S", replace(draft("shirt"), trims=names)),
        ("M", replace(draft("shirt"), trims=names)),
    ]
    run = size_run(patterns, lambda pattern, alike: cutting_plan(pattern, alike=alike))
    for nested in run.nested:
        assert len(nested.pieces) == 2
        assert all(piece.marks or not nested.pieces[0].marks for piece in nested.pieces)
    assert {"Breast pocket", "Front band"} <= {n.pieces[0].name for n in run.nested}


def test_a_pocket_that_one_size_lacks_room_for_is_on_none():
    shirt = draft("shirt")
    scale = 0.35  # so short that no breast pocket fits
    low = replace(
        shirt,
        panels=tuple(
            replace(
                p,
                vertices=p.vertices * (1.0, scale),
                placement=replace(
                    p.placement,
                    translation=(
                        p.placement.translation[0],
                        139 - scale * (139 - p.placement.translation[1]),
                        p.placement.translation[2],
                    ),
                ),
            )
            for p in shirt.panels
        ),
    )
    trims = ("button placket", "chest pocket")
    assert trims_that_fit(low, trims) != trims_that_fit(shirt, trims)
    run = size_run(
        [("S", replace(low, trims=trims)), ("M", replace(shirt, trims=trims))],
        lambda pattern, alike: cutting_plan(pattern, alike=alike),
    )
    shared = set(trims_that_fit(low, trims))
    assert {p.trim for n in run.nested for p in n.pieces} <= {"", *shared}


def test_recut_fronts_keep_their_buttons():
    """Fronts whose edges slant from the neck to the hem, as sizes are recut: everything follows the edge."""
    shirt = replace(draft("denim-jacket"), trims=("buttons", "chest pockets"))
    panels = []
    for panel in shirt.panels:
        if panel.name.endswith("_ftorso"):
            corners = panel.vertices.copy()
            seen = panel.to_world(corners)
            low = (np.abs(seen[:, 0]) < 0.01) & (seen[:, 1] < seen[:, 1].mean())
            assert low.sum() == 1
            corners[low, 0] += 1.4 if panel.name.startswith("left") else -1.4
            panel = replace(panel, vertices=corners)
        panels.append(panel)
    slanted = replace(shirt, panels=tuple(panels))
    plan, straight = cutting_plan(slanted), cutting_plan(shirt)
    assert plan.closing is not None
    assert sum(isinstance(t, Button) for t in plan.trims) == sum(
        isinstance(t, Button) for t in straight.trims
    )
    piece = plan.piece_of("left_ftorso")
    row = [m for m in piece.marks if m.kind == "button" and m.trim == "buttons"]
    middle = shapely.LineString(next(m.points for m in piece.marks if m.words == "centre front"))
    assert len(row) == 5 and all(set(m.panels) == {"left_ftorso", "right_ftorso"} for m in row)
    assert max(middle.distance(shapely.Point(m.points[0])) for m in row) < 0.01


def test_strips_are_as_long_where_their_panels_are_cut_on_the_fold(trimmed):
    """Folded, a front has another name, and its edges are counted anew."""
    pattern = trimmed["vest"]
    folded, moved = fold_with_trims(pattern, front=True, back=True)
    assert len(folded.panels) < len(pattern.panels)
    plain, on_fold = (
        dict(decorations(plan)) for plan in (cutting_plan(pattern), cutting_plan(folded, trims=moved))
    )
    assert plain == on_fold and "cm in all" in plain["Ribbed band at the neck"]
    (neck,) = (trim for trim in moved if trim.trim == "neck rib")
    assert neck.length > 40.0
