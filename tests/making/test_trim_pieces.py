"""What is cut, bought and done for pockets, buttons, zips and belts."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely

from swifttailor.making import Allowances, cutting_plan
from swifttailor.making.notions import buttons, notions, zips
from swifttailor.making.sewing_steps import sewing_steps, steps_markdown
from swifttailor.making.waist_girth import waist_girth
from swifttailor.pattern.drafted_for import DraftedFor
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.trims import Belt, Button, Patch


def own(plan, trim: str) -> dict:
    return {p.name: p for p in plan.pieces if p.trim == trim}


def centred(points) -> np.ndarray:
    return points - (points.min(axis=0) + points.max(axis=0)) / 2


def apart(a, b) -> float:
    """How far two outlines lie from each other at most, laid middle on middle, either way up, cm."""
    rings = [shapely.LinearRing(centred(np.asarray(b) * (sign, 1.0))) for sign in (1.0, -1.0)]
    return min(float(shapely.hausdorff_distance(shapely.LinearRing(centred(a)), ring)) for ring in rings)


@pytest.mark.parametrize(
    ("name", "trim", "pocket", "flap"),
    [
        ("denim-jacket", "chest pockets", "Breast pocket", "Breast pocket flap"),
        ("shirt-dress", "chest pocket", "Breast pocket", None),
        ("trousers", "back pockets", "Back pocket", None),
        ("dungarees", "cargo pockets", "Cargo pocket", "Cargo pocket flap"),
        ("tunic", "patch pockets", "Patch pocket", None),
        ("zipped hoodie", "kangaroo pocket", "Kangaroo pocket", None),
    ],
)
def test_a_pocket_is_as_large_as_its_outline(trimmed_plans, name, trim, pocket, flap):
    plan = trimmed_plans[name]
    patches = [t for t in plan.trims if isinstance(t, Patch) and t.trim == trim and t.look == "cloth"]
    pieces = own(plan, trim)
    assert set(pieces) == {pocket, *([flap] if flap else [])}
    fits = dict.fromkeys(pieces, 0)
    for patch in patches:
        outline = patch.outline @ plan.sewn.panel(patch.panel).turn.T
        nearest = min(pieces.values(), key=lambda piece: apart(outline, piece.sew_line))
        assert apart(outline, nearest.sew_line) < 0.01
        fits[nearest.name] += 1
    assert pieces[pocket].count == fits[pocket]
    if flap:  # an outer and an inner side
        assert pieces[flap].count == 2 * fits[flap] and "interfacing" in pieces[flap].cloth


def test_the_facing_of_a_pocket_is_at_its_upper_edge(trimmed_plans):
    (pocket,) = own(trimmed_plans["trousers"], "back pockets").values()
    low, high = pocket.sew_line.min(axis=0), pocket.sew_line.max(axis=0)
    box = pocket.box
    assert box[1, 1] - high[1] == pytest.approx(3.0, abs=0.2)  # its edge is a little slanted on the panel
    assert low[0] - box[0, 0] == pytest.approx(1.0, abs=0.1)
    assert [run.allowance for run in pocket.runs].count(3.0) == 1
    wide = cutting_plan(trimmed_plans["trousers"].sewn.pattern, Allowances(seam=1.5))
    (pocket,) = own(wide, "back pockets").values()
    assert sorted({run.allowance for run in pocket.runs}) == [1.5, 3.0]


@pytest.mark.parametrize(
    ("name", "trim", "facings"), [("hoodie", "kangaroo pocket", 2), ("dungarees", "bib pocket", 1)]
)
def test_halves_that_meet_are_one_pocket(trimmed_plans, name, trim, facings):
    plan = trimmed_plans[name]
    (pocket,) = own(plan, trim).values()
    halves = [shapely.Polygon(t.outline) for t in plan.trims if t.trim == trim]
    assert len(halves) == 2 and pocket.count == 1 and pocket.symmetric
    assert shapely.Polygon(pocket.sew_line).area == pytest.approx(sum(h.area for h in halves), abs=0.05)
    width = sum(float(np.ptp(shapely.get_coordinates(h)[:, 0])) for h in halves)
    assert np.ptp(pocket.sew_line[:, 0]) == pytest.approx(width, abs=0.01)
    assert [run.allowance for run in pocket.runs].count(3.0) == facings


def test_flaps_have_a_buttonhole_over_the_button(trimmed_plans):
    for name, trim in (("denim-jacket", "chest pockets"), ("dungarees", "cargo pockets")):
        plan = trimmed_plans[name]
        flap = next(p for p in own(plan, trim).values() if "flap" in p.name)
        (mark,) = flap.marks
        button = next(t for t in plan.trims if isinstance(t, Button) and t.trim == trim)
        patch = min(
            (t for t in plan.trims if isinstance(t, Patch) and t.trim == trim and t.panel == button.panel
             and t.look == "cloth"), key=lambda t: shapely.Polygon(t.outline).area,
        )  # fmt: skip
        turn = plan.sewn.panel(button.panel).turn
        outline, at = patch.outline @ turn.T, np.array(button.at) @ turn.T
        middle = (outline.min(axis=0) + outline.max(axis=0)) / 2
        sewn = (flap.sew_line.min(axis=0) + flap.sew_line.max(axis=0)) / 2
        np.testing.assert_allclose(mark.points[0] - sewn, at - middle, atol=0.01)
        assert np.hypot(*np.diff(mark.hole, axis=0)[0]) == pytest.approx(2 * button.radius + 0.3)
        assert shapely.Polygon(flap.sew_line).contains(shapely.LineString(mark.hole))


@pytest.mark.parametrize(
    ("name", "trim", "more"), [("trench coat", "tie belt", 60.0), ("trousers", "buckle belt", 20.0)]
)
def test_belts_go_around_the_waist(trimmed_plans, name, trim, more):
    plan = trimmed_plans[name]
    (piece,) = own(plan, trim).values()
    belt = next(t for t in plan.trims if isinstance(t, Belt))
    girth = waist_girth(plan.sewn.pattern)
    np.testing.assert_allclose(np.ptp(piece.sew_line, axis=0), [2 * belt.width, girth + more], atol=0.01)
    assert 60 < girth < 100 and piece.name == "Belt"
    wide = replace(
        plan.sewn.pattern, drafted_for=DraftedFor("w", "women", (("waist", 100.0), ("hips", 120.0)))
    )
    assert name == "trousers" or waist_girth(wide) > girth + 15


def test_bands_are_as_long_as_the_front(trimmed_plans):
    plan = trimmed_plans["shirt-dress"]
    (band,) = own(plan, "button placket").values()
    bodice, skirt = plan.piece_of("left_ftorso"), plan.piece_of("skirt_front")
    x = min(m.points[:, 0].min() for m in bodice.marks if m.words == "front band") + 1.6

    def height(piece, at):
        line = shapely.LineString([(at, -500), (at, 500)])
        return shapely.intersection(line, shapely.Polygon(piece.sew_line)).length

    length = height(bodice, x) + height(skirt, skirt.middle + 1.6)
    np.testing.assert_allclose(np.ptp(band.sew_line, axis=0), [6.4, length], atol=0.05)
    assert band.count == 2
    polo = trimmed_plans["polo shirt"]
    (short,) = own(polo, "polo placket").values()
    assert 12 < np.ptp(short.sew_line[:, 1]) < 17


@pytest.mark.parametrize(("name", "beyond"), [("denim-jacket", 2.0), ("trench coat", 9.0)])
def test_fronts_that_lap_reach_beyond_their_middle(trimmed_plans, name, beyond):
    plan = trimmed_plans[name]
    closing = plan.closing
    assert closing.extension == pytest.approx(beyond, abs=0.05)
    facings = [p for p in own(plan, closing.trim).values() if "facing" in p.name]
    assert sum(p.count for p in facings) == 2
    for ref in closing.edges:
        piece = plan.piece_of(ref.panel)
        edges = {r.edge for r in closing.edges if r.panel == (*piece.panels, *piece.mirrored)[0]}
        run = next(r for r in piece.runs if r.edge in edges)
        assert run.allowance == pytest.approx(beyond + 1.0, abs=0.05)
        cloth = shapely.Polygon(piece.cut.outline)
        middle = run.points.mean(axis=0)
        out = np.array([np.sign(middle[0] - piece.middle), 0.0])
        assert cloth.contains(shapely.Point(middle + (beyond + 0.9) * out))
        assert not cloth.contains(shapely.Point(middle + (beyond + 1.1) * out))
        # Behind both fronts' edges lies a facing as high as they are.
        assert any(np.ptp(f.sew_line[:, 1]) >= np.ptp(run.points[:, 1]) - 0.1 for f in facings)
        for mark in piece.marks:
            if mark.hole is not None:
                assert all(cloth.buffer(-1.0).contains(shapely.Point(end)) for end in mark.hole)


KINDS, FRONTS = ("button", "hole"), {"left_ftorso", "right_ftorso"}


def test_double_breasted_buttons_meet_their_holes(trimmed_plans):
    """Laid with middle on middle, every hole lies over a button of the other front, its mirror image."""
    plan = trimmed_plans["trench coat"]
    piece = plan.piece_of("left_ftorso")
    assert (*piece.panels, *piece.mirrored) == ("left_ftorso", "right_ftorso")
    left = plan.sewn.pattern.panel("left_ftorso")
    turn = plan.sewn.panel("left_ftorso").turn
    seen = {kind: [m.points @ np.linalg.inv(turn).T for m in piece.marks if m.kind == kind] for kind in KINDS}
    assert len(seen["button"]) == len(seen["hole"]) == 4  # two above the belt, two below it
    (seam,) = (s for s in plan.sewn.pattern.stitches if {r.panel for r in s.sides} == FRONTS)
    edge = next(r.edge for r in seam.sides if r.panel == "left_ftorso")
    middle = float(left.chord(edge)[:, 0].mean())
    for hole, button in zip(seen["hole"], seen["button"], strict=True):
        assert hole[0, 1] == pytest.approx(button[0, 1], abs=0.01)
        assert middle - hole[0, 0] == pytest.approx(button[0, 0] - middle, abs=0.01)


def test_bags_lie_behind_their_front(trimmed_plans):
    plan = trimmed_plans["trousers"]
    pieces = own(plan, "slant pockets")
    front = plan.piece_of("pant_f_l")
    line = next(m for m in front.marks if m.trim == "slant pockets")
    cloth = shapely.Polygon(front.sew_line)
    back, cut = (shapely.Polygon(pieces[f"Pocket bag, {side}"].sew_line) for side in ("back", "front"))
    assert [p.count for p in pieces.values()] == [2, 2]
    assert all(p.instruction.startswith("Cut 2, mirrored") for p in pieces.values())
    assert back.within(cloth.buffer(0.01)) and cut.within(back.buffer(0.01))
    assert 20 < back.area - cut.area < 120  # the corner that the hand goes past
    assert (
        shapely.LineString(line.points).hausdorff_distance(
            shapely.intersection(shapely.LineString(line.points), cut.exterior.buffer(0.02))
        )
        < 0.05
    )
    low, high = line.points.min(axis=0), line.points.max(axis=0)
    assert back.bounds[1] < low[1] - 10 and back.bounds[3] >= high[1]
    (bag,) = own(trimmed_plans["joggers"], "side pockets").values()
    assert bag.count == 4 and len(bag.panels) == len(bag.mirrored) == 2


def test_the_shopping_list(trimmed_plans):
    for name, plan in trimmed_plans.items():
        count = sum(isinstance(t, Button) for t in plan.trims)
        assert sum(buttons(plan).values()) == count, name
        said = [int(line.split()[0]) for line in notions(plan) if " button" in line]
        assert sum(said) == count, name
    denim = notions(trimmed_plans["denim-jacket"])
    assert denim[:2] == ["2 buttons of 12 mm", "5 buttons of 20 mm"]
    assert "buckle for a belt of 35 mm" in notions(trimmed_plans["trousers"])
    assert any(line.startswith("cord of 1") for line in notions(trimmed_plans["joggers"]))
    assert any(line.startswith("elastic of ") for line in notions(trimmed_plans["pyjama bottoms"]))
    assert "Elastic" in [step.title for step in sewing_steps(trimmed_plans["pyjama bottoms"])]
    assert notions(cutting_plan(draft("t-shirt"))) == []


def test_zips_are_as_long_as_their_openings(trimmed_plans):
    hoodie = trimmed_plans["zipped hoodie"]
    ((kind, length),) = zips(hoodie)
    seam = next(hoodie.sewn.length(ref) for ref in hoodie.closing.edges)
    band = np.ptp(hoodie.piece_of("wb_front").sew_line[:, 1])
    assert kind == "separating zip" and length == pytest.approx(seam + band - 0.6, abs=0.1)
    assert f"separating zip of {int(length)} cm (or the next shorter one)" in notions(hoodie)
    assert [kind for kind, _ in zips(trimmed_plans["hoodie"])] == ["zip"]
    ((_, side),) = zips(trimmed_plans["dungarees"])
    assert 17 < side < 19
    ((_, fly),) = zips(trimmed_plans["trousers"])
    assert 12 < fly < 14


def order(plan, *titles: str) -> list[int]:
    all_titles = [step.title for step in sewing_steps(plan)]
    return [all_titles.index(title) for title in titles]


@pytest.mark.parametrize(
    ("name", "titles"),
    [
        ("denim-jacket", ["Breast pockets", "Side and underarm seams", "Front facings", "Neckline",
                          "Buttonholes and buttons"]),
        ("shirt-dress", ["Breast pocket", "Pockets in the side seams", "Skirt seams", "Waist seam",
                         "Front bands", "Hems", "Belt", "Buttonholes and buttons"]),
        ("trousers", ["Back pockets", "Slanted pockets", "Outer leg seams", "Fly", "Crotch seam", "Belt"]),
        ("zipped hoodie", ["Kangaroo pockets", "Neckline seam", "Zip", "Neckline"]),
        ("hoodie", ["Centre front seam", "Kangaroo pocket", "Zip at the neck", "Neckline seam"]),
        ("dungarees", ["Cargo pockets", "Bib pocket", "Outer leg seams", "Zip in the side seam", "Hems"]),
        ("joggers", ["Eyelets for the cord", "Ends of the waistband", "Waist seam"]),
    ],
)  # fmt: skip
def test_the_order_of_sewing(trimmed_plans, name, titles):
    plan = trimmed_plans[name]
    assert order(plan, *titles) == sorted(order(plan, *titles))
    if any(isinstance(t, Button) for t in plan.trims):
        assert sewing_steps(plan)[-1].title == "Buttonholes and buttons"
    closed = sorted(k for step in sewing_steps(plan) for k in step.stitches)
    assert closed == list(range(len(plan.sewn.pattern.stitches)))


def test_steps_say_what_stays_open(trimmed_plans):
    text = steps_markdown(trimmed_plans["denim-jacket"])
    assert "Centre front, which stays open" in text and "by 2.0 cm, so that they lap" in text
    assert "Waistband front is open in the middle, too" in text
    assert "- 5 buttons of 20 mm" in text and "no zip and no buttons" not in text
    assert "- **Breast pocket**: cut 2; sewn 11.0 x 12.5 cm, grain along the 12.5 cm" in text
    hems = next(s for s in sewing_steps(trimmed_plans["tunic"]) if s.title == "Hems")
    assert "Patch pocket" not in " ".join(hems.sentences)
    assert "no zip and no buttons" in steps_markdown(trimmed_plans["joggers"])
