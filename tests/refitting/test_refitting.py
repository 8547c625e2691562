"""Patterns refitted to other bodies."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import swifttailor
from swifttailor.body import Body, body_for
from swifttailor.pattern import Edge, EdgeRef, Panel, Pattern, Stitch, check_pattern, load_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.tidying.symmetry import reflected
from swifttailor.refitting import refit
from swifttailor.refitting.body_profile import profile_of
from swifttailor.refitting.cloth_girths import cloth_around
from swifttailor.refitting.first_body import sewn_on
from swifttailor.refitting.stretch import places_of, wanted_width

GARMENTS = ("t-shirt", "fitted-dress", "trousers", "circle-skirt")
SIZES = ("women 36", "women 48", "men 54", "children 128")
LEVELS = {"chest": 6, "waist": 5, "hips": 4}


@pytest.fixture(scope="module")
def bodies():
    return {size: body_for(size=size) for size in SIZES}


@pytest.fixture(scope="module")
def garments():
    sew = sewn_on(Body.default(), 2.5)
    return {name: (draft(name), sew(draft(name))) for name in GARMENTS}


@pytest.fixture(
    scope="module", params=[(g, s) for g in GARMENTS for s in SIZES[1::2]], ids=lambda p: f"{p[0]}-{p[1]}"
)
def made(request, bodies, garments):
    name, size = request.param
    pattern, sewn = garments[name]
    return pattern, bodies[size], refit(pattern, bodies[size], sewn=sewn)


def test_panels_edges_and_stitches_keep_names_numbers_and_kinds(made):
    before, _, done = made
    after = done.pattern
    assert [p.name for p in after.panels] == [p.name for p in before.panels]
    assert after.stitches == before.stitches
    for a, b in zip(before.panels, after.panels, strict=True):
        assert [e.label for e in a.edges] == [e.label for e in b.edges]
        assert (a.label, a.placement.rotation) == (b.label, b.placement.rotation)
        assert np.sign(a.signed_area()) == np.sign(b.signed_area())


def test_seams_keep_the_ratio_of_their_sides(made):
    before, _, done = made
    for stitch in before.stitches:
        ratios = [p.edge_length(stitch.first) / p.edge_length(stitch.second) for p in (before, done.pattern)]
        assert ratios[1] == pytest.approx(ratios[0], rel=1e-4)


def test_what_was_symmetric_stays_so(made):
    before, _, done = made
    for panel in before.panels:
        for other in before.panels:
            if other is panel or reflected(other, panel.name) != panel:
                continue
            one, two = done.pattern.panel(panel.name), done.pattern.panel(other.name)
            assert np.allclose(reflected(two, one.name).vertices, one.vertices, atol=1e-6)


def test_a_check_finds_nothing_new(made):
    before, _, done = made
    known = {f.code for f in check_pattern(before)}
    found = {f.code for f in check_pattern(done.pattern)} - known
    assert found <= {"misplaced-panel"}  # the check knows the default body alone


def test_ease_around_the_body_is_kept(made):
    """The flat panels, cut where they lay, are as wide as the other body and the ease."""
    _, body, done = made
    start, end = profile_of(Body.default()), profile_of(body)
    mesh = done.sewn.mesh
    places = places_of(done.sewn, start)
    counted = np.asarray(~places.arm[mesh.flat_faces].any(axis=1))
    scale = end.measurements.height / start.measurements.height
    grown = replace(mesh, flat_vertices=done.flat_positions)
    for name, level in LEVELS.items():
        heights = start.levels[level] + np.linspace(-1, 1, 5)
        was, now = (
            float(np.median(cloth_around(m, places.points[:, 1], counted, heights))) for m in (mesh, grown)
        )
        girth, other = (float(np.interp(b.levels[level], b.heights, b.girth)) for b in (start, end))
        if was > girth:
            asked = float(wanted_width(np.array([was]), np.array([girth]), np.array([other]), scale)[0])
            # Straight side seams stay straight: what is loose cannot follow every curve of the body.
            assert now == pytest.approx(asked, abs=max(1.2, 0.12 * (was - girth))), name


def test_lengths_follow_the_body(made):
    before, body, done = made
    default = Body.default().measurements
    m = body.measurements
    for panel in before.panels:
        if panel.name.startswith(("pant_f", "pant_b")):
            was, now = (np.ptp(p.panel(panel.name).outline()[:, 1]) for p in (before, done.pattern))
            assert now / was == pytest.approx(m.waist_level / default.waist_level, rel=0.06)
        if panel.name.endswith(("sleeve_f", "sleeve_b")):
            was, now = (np.ptp(p.panel(panel.name).outline()[:, 0]) for p in (before, done.pattern))
            assert now / was == pytest.approx(m.arm_length / default.arm_length, rel=0.12)


def test_the_same_body_changes_nothing(garments):
    for pattern, sewn in garments.values():
        after = refit(pattern, Body.default(), sewn=sewn).pattern
        for a, b in zip(pattern.panels, after.panels, strict=True):
            for k in range(len(a.edges)):
                assert np.allclose(a.sample_edge(k, 5), b.sample_edge(k, 5), atol=0.1)
            assert np.allclose(a.placement.translation, b.placement.translation, atol=0.02)


def test_there_and_back_is_nearly_the_pattern(bodies, garments):
    pattern, sewn = garments["t-shirt"]
    there = refit(pattern, bodies["women 48"], sewn=sewn).pattern
    back = swifttailor.fit(there, Body.default())
    for a, b in zip(pattern.panels, back.panels, strict=True):
        assert np.abs(np.ptp(a.outline(), axis=0) - np.ptp(b.outline(), axis=0)).max() < 2.5


def test_a_refitted_pattern_is_like_one_that_is_drafted_for_the_body(bodies, garments):
    """Of a fitted skirt the drafting rules and the refitting come to the same widths."""
    pattern = draft("fitted-skirt")
    for size in ("women 48", "men 54"):
        body = bodies[size]
        ours = swifttailor.fit(pattern, body)
        theirs = draft("fitted-skirt", measurements=body.measurements)
        width = [
            sum(np.ptp(p.panel(n).outline()[:, 0]) for n in ("skirt_front", "skirt_back"))
            for p in (ours, theirs)
        ]
        assert width[0] == pytest.approx(width[1], abs=3.0)


def test_a_file_says_for_which_body_it_is_and_can_be_refitted_again(tmp_path, bodies, garments):
    pattern, sewn = garments["t-shirt"]
    body = bodies["women 48"]
    path = refit(pattern, body, sewn=sewn).pattern.save(tmp_path / "48.json")
    read = load_pattern(path)
    assert read.drafted_for == body.made_for
    again = swifttailor.fit(read, body)  # it is for this body already
    for a, b in zip(read.panels, again.panels, strict=True):
        assert np.allclose(a.vertices, b.vertices, atol=0.05)


def test_a_size_run_grows_evenly(garments):
    pattern, sewn = garments["fitted-dress"]
    widths = []
    for size in ("38", "40", "42", "44"):
        panel = refit(pattern, body_for(size=size), sewn=sewn).pattern.panel("skirt_back")
        widths.append(np.ptp(panel.outline()[:, 0]))
    steps = np.diff(widths)
    assert (steps > 0.5).all() and np.ptp(steps) < 1.0


def test_curves_that_would_cross_another_edge_are_drawn_flatter():
    from swifttailor.pattern import Edge, Panel, Pattern, Placement
    from swifttailor.pattern.check.crossings import find_crossing
    from swifttailor.pattern.check.outline import trace_outline
    from swifttailor.pattern.curve import Arc
    from swifttailor.refitting.alike import find_likeness
    from swifttailor.refitting.uncrossed import uncrossed

    def band(height: float) -> Pattern:
        # Below, a bow of 8 cm that reaches up into the panel; above, a straight edge.
        corners = [[0.0, 0.0], [20.0, 0.0], [20.0, height], [0.0, height]]
        rise = 8.0
        bow = Arc((10.0**2 + rise**2) / (2 * rise), large=False, right=False)
        return Pattern((Panel("band", corners, (Edge(bow), Edge(), Edge(), Edge()), Placement((0, 0, 0))),))

    before, after = band(10.0), band(7.5)
    assert find_crossing(trace_outline(before.panels[0])) is None
    assert find_crossing(trace_outline(after.panels[0])) is not None
    made = uncrossed(before, after, find_likeness(before))
    assert find_crossing(trace_outline(made.panels[0])) is None
    np.testing.assert_array_equal(made.panels[0].vertices, after.panels[0].vertices)
    bow = made.panels[0].edges[0].curve
    rise = bow.radius - np.sqrt(bow.radius**2 - 10.0**2)
    assert 7.5 * 0.9 < rise < 7.5
    assert uncrossed(after, after, find_likeness(after)) is after, "what crossed itself before is left alone"


def test_side_seams_may_curve_and_nothing_else_does(bodies, garments):
    pattern, sewn = garments["t-shirt"]
    made = refit(pattern, bodies["men 54"], sewn=sewn).pattern
    curved = {
        (new.name, k)
        for new, old in zip(made.panels, pattern.panels, strict=True)
        for k, (a, b) in enumerate(zip(new.edges, old.edges, strict=True))
        if type(a.curve) is not type(b.curve)
    }
    sides = {
        (ref.panel, ref.edge)
        for stitch in pattern.stitches
        for ref in stitch.sides
        if stitch.first.panel != stitch.second.panel and pattern.edge_length(ref) >= 12
    }
    assert curved <= sides


def test_shorts_that_end_above_the_crotch_are_refitted(bodies):
    from swifttailor.refitting.stretch import stretches

    sewn = sewn_on(Body.default(), 2.5)(draft("trousers"))
    start, end = profile_of(Body.default()), profile_of(bodies["women 48"])
    places = places_of(sewn, start)
    lifted = np.maximum(places.points, [-1e3, start.levels[3] + 5.0, -1e3])
    found = stretches(sewn, replace(places, points=lifted), start, end)
    assert np.isfinite(found.around).all() and np.isfinite(found.along).all()


def test_each_place_of_the_cloth_is_corrected_by_one_ring_alone(bodies, garments):
    """Two that each make up for what is lacking would overshoot, and more so every round."""
    from swifttailor.refitting.stretch import stretches

    start, end = profile_of(Body.default()), profile_of(bodies["women 48"])
    for _, sewn in garments.values():
        rings = stretches(sewn, places_of(sewn, start), start, end).rings
        assert rings
        assert np.sum([ring.moved for ring in rings], axis=0).max() == 1


def test_trouser_legs_keep_their_ease(bodies, garments):
    from swifttailor.refitting.stretch import stretches

    pattern, sewn = garments["trousers"]
    start = profile_of(Body.default())
    for size in ("women 48", "men 54"):
        rings = stretches(sewn, places_of(sewn, start), start, profile_of(bodies[size])).rings
        legs = [ring for ring in rings if ring.places.max() < start.levels[3]]
        assert len(legs) == 2
        made = refit(pattern, bodies[size], sewn=sewn)
        grown = replace(sewn.mesh, flat_vertices=made.flat_positions)
        for ring in legs:
            got = cloth_around(grown, ring.along, ring.faces, ring.places, (ring.members,))[:, 0]
            there = (ring.wanted > 0) & (ring.places > start.levels[1] + 3.0)
            assert np.abs(got - ring.wanted)[there].mean() < 1.0


def test_a_panel_that_comes_to_cross_itself_is_taken_from_a_round_before(garments, monkeypatch):
    """Rounds go on for the sake of ease; what cannot be sewn is worth less than a centimetre of it."""
    from swifttailor.refitting import refitted
    from swifttailor.refitting.alike import Likeness
    from swifttailor.refitting.uncrossed import damaged

    _, sewn = garments["t-shirt"]
    before = sewn.pattern
    panel = before.panels[0]
    twisted = panel.vertices.copy()
    twisted[[0, 1]] = twisted[[1, 0]]
    broken = replace(before, panels=(replace(panel, vertices=twisted), *before.panels[1:]))
    assert damaged(before, broken) and not damaged(before, before)
    flat = np.zeros((1, 2))
    rounds = [(before, flat), (before, flat + 1), (broken, flat + 2)]
    monkeypatch.setattr(refitted, "uncrossed", lambda _, after, __: after)
    monkeypatch.setattr(refitted, "keep_seam_ratios", lambda _, after: after)
    after, kept = refitted._last_sound(before, rounds, Likeness((), ()), frozenset())
    assert kept[0, 0] == 1 and not damaged(before, after)
    assert refitted._last_sound(before, [(broken, flat)], Likeness((), ()), frozenset())[1] is flat


@given(height=st.floats(1.0, 10.0), shrunk=st.floats(0.6, 1.5), lost=st.floats(-1.0, 0.3))
def test_a_panel_that_collapses_or_turns_over_is_damaged_and_a_smaller_one_is_not(height, shrunk, lost):
    """Flounces a centimetre high were pulled through themselves on large bodies."""
    from swifttailor.refitting.uncrossed import damaged

    before = _ring(40.0, height)
    assert not damaged(before, _ring(40.0 * shrunk, height * shrunk))
    assert damaged(before, _ring(40.0, lost * height))


def _ring(width: float, height: float) -> Pattern:
    """Two panels sewn to a ring; of a height below zero, they lie the other way round."""
    corners = np.array([[0, 0], [width, 0], [width, height], [0, height]])
    edges = tuple(Edge() for _ in corners)
    panels = tuple(Panel(name, corners, edges) for name in ("front", "back"))
    sewn = ((1, 3), (3, 1))
    stitches = tuple(Stitch(EdgeRef("front", a), EdgeRef("back", b)) for a, b in sewn)
    return Pattern(panels, stitches)
