"""Sewing steps: every stitch once, in an order in which it can be done."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

from swifttailor.making import cutting_plan
from swifttailor.making.allowances import EdgeKind
from swifttailor.making.made_for import made_for
from swifttailor.making.seams import SeamRole, gather
from swifttailor.making.sewing_steps import sewing_steps, steps_markdown
from swifttailor.pattern.drafted_for import DraftedFor
from swifttailor.pattern.drafts import draft


def test_every_stitch_is_closed_once(plans):
    for plan in plans.values():
        closed = Counter(k for step in sewing_steps(plan) for k in step.stitches)
        assert closed == Counter(range(len(plan.sewn.pattern.stitches)))
        numbers = [n for step in sewing_steps(plan) for n in step.numbers]
        assert numbers == sorted(numbers) and len(set(numbers)) == len(numbers)


def test_equal_numbers_are_printed_on_both_sides_of_a_seam(plans):
    for plan in plans.values():
        for seam in plan.seams:
            if seam.role is SeamRole.DART:
                continue
            for name in seam.panels:
                piece = plan.piece_of(name)
                printed = {n for m in piece.seam_marks for n in m.numbers}
                assert seam.number in printed, (plan.name, seam, piece.name)


def test_a_shirt_is_sewn_as_shirts_are(draft_plans):
    plan = draft_plans["t-shirt"]
    titles = [step.title for step in sewing_steps(plan)]
    order = ["Shoulder seams", "Armhole seams", "Side and underarm seams", "Hems"]
    assert [t for t in titles if t in order] == order
    assert "Neckline" in titles and titles.index("Neckline") > titles.index("Side and underarm seams")
    kinds = {r.kind for p in plan.pieces for r in p.runs}
    assert EdgeKind.NECKLINE in kinds and kinds & {EdgeKind.HEM, EdgeKind.CURVED_HEM}


def test_trousers_are_sewn_leg_by_leg(draft_plans):
    titles = [step.title for step in sewing_steps(draft_plans["trousers"])]
    order = ["Outer leg seams", "Inner leg seams", "Crotch seam"]
    assert [t for t in titles if t in order] == order


def test_shoulders_lie_above_sides(plans):
    """The role of a seam is judged by its panels and place; the heights are measured here."""
    for plan in plans.values():
        pattern = plan.sewn.pattern

        def height(seam, pattern=pattern):
            refs = [r for k in seam.stitches for r in pattern.stitches[k].sides]
            places = [pattern.panel(r.panel).to_world(pattern.panel(r.panel).chord(r.edge)) for r in refs]
            return sum(float(p[:, 1].mean()) for p in places) / len(places)

        shoulders = [height(s) for s in plan.seams if s.role is SeamRole.SHOULDER]
        sides = [height(s) for s in plan.seams if s.role is SeamRole.SIDE]
        over = [height(s) for s in plan.seams if s.role is SeamRole.OVERARM]
        under = [height(s) for s in plan.seams if s.role is SeamRole.UNDERARM]
        assert not shoulders or not sides or min(shoulders) > max(sides)
        assert bool(over) == bool(under) or not over
        assert not over or min(over) > min(under)


def test_gathers_are_told_with_their_lengths(shipped_plans):
    plan = shipped_plans["gc_1000272"]
    text = steps_markdown(plan, cloth=["1.25 m of cloth"])
    assert "Gather Bodice back first, from 25.0 to 21.0 cm." in text and "1.25 m of cloth" in text
    assert "# gc_1000272: how to sew it" in text and "**Bodice front**: cut 2, mirrored" in text
    assert gather(25.0, 21.0) == "gather" and gather(20.5, 20.0) == "ease" and gather(20.0, 20.1) == ""


def test_no_two_pieces_of_a_garment_have_one_name(few_real_patterns):
    for pattern in few_real_patterns.values():
        names = [p.name for p in cutting_plan(pattern).pieces]
        assert len(set(names)) == len(names)
        assert not any("_" in name for name in names), names


def test_steps_say_whom_the_pattern_is_for(draft_plans):
    """Compared with one's own measures before the cloth is cut."""
    pattern = draft_plans["t-shirt"].sewn.pattern
    assert "Made for the default body: bust 99.8, waist 84.3, hips 103.5, height 172 cm" in steps_markdown(
        draft_plans["t-shirt"]
    )
    sized = DraftedFor("women EU 44", "women", (("bust", 100.0), ("height", 168.0)))
    measured = DraftedFor("bust 96, height 172", None, (("bust", 96.0), ("height", 172.0)))
    for named, words in (
        (sized, "women EU 44: bust 100, height 168 cm"),
        (measured, "bust 96, height 172 cm"),
        (DraftedFor("me.obj"), "me.obj"),
    ):
        assert made_for(replace(pattern, drafted_for=named)) == words


def test_collars_are_sewn_on_after_raglan_sleeves_and_before_set_in_ones():
    for armhole, later in (("raglan", True), ("set-in", False)):
        seams = cutting_plan(draft("sweatshirt", collar="standing", armhole=armhole)).seams
        roles = [seam.role for seam in seams]
        assert (roles.index(SeamRole.NECKLINE) > roles.index(SeamRole.ARMHOLE)) is later


def test_seams_under_sleeves_that_are_cut_in_one_are_side_seams():
    seams = cutting_plan(draft("t-shirt", armhole="cut-in-one", sleeve_length=56.0)).seams
    roles = [seam.role for seam in seams]
    assert roles.count(SeamRole.SIDE) == 2 and roles.count(SeamRole.SHOULDER) == 2
