"""What a check found is remembered by the pattern's value: equal patterns share it, others never do."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pattern_strategies import patterns
from unchangeable import changeable

from swifttailor.pattern import Cubic, EdgeRef, Finding, Pattern, Quadratic, Severity, Stitch, check_pattern
from swifttailor.pattern import curve as curves
from swifttailor.pattern.check.checker import _check_of_itself
from swifttailor.pattern.check.crossings import find_crossing
from swifttailor.pattern.check.outline import trace_outline
from swifttailor.pattern.names import body_region
from swifttailor.pattern.panel import Panel

MEMOS = (_check_of_itself, find_crossing, trace_outline)
INNER = (curves._sampled, curves._flattened, curves._length_table)


def forget():
    for memo in (*MEMOS, *INNER):
        memo.cache_clear()


def rebuilt(pattern: Pattern) -> Pattern:
    """An equal pattern that shares no panel, array or stitch with the first."""
    made = [
        Panel(p.name, p.vertices.tolist(), tuple(map(replace, p.edges)), replace(p.placement), p.label)
        for p in pattern.panels
    ]
    sewn = [Stitch(EdgeRef(*s.first), EdgeRef(*s.second), s.right_wrong) for s in pattern.stitches]
    return Pattern(tuple(made), tuple(sewn), f"{pattern.name}, again")


def with_zeros_turned(pattern: Pattern) -> Pattern:
    """The same numbers with -0.0 for 0.0 and the other way round: equal, by Python's and by numpy's word."""

    def turned(values):
        return tuple(-v if v == 0 else v for v in values)

    def curve(one):
        if isinstance(one, Quadratic):
            return Quadratic(turned(one.control))
        return Cubic(turned(one.control_1), turned(one.control_2)) if isinstance(one, Cubic) else one

    made = [
        replace(
            p,
            vertices=np.where(p.vertices == 0, -p.vertices, p.vertices),
            edges=tuple(replace(e, curve=curve(e.curve)) for e in p.edges),
            placement=replace(
                p.placement,
                translation=turned(p.placement.translation),
                rotation=turned(p.placement.rotation),
            ),
        )
        for p in pattern.panels
    ]
    return replace(pattern, panels=tuple(made))


def with_first(pattern: Pattern, **changed) -> Pattern:
    return replace(pattern, panels=(replace(pattern.panels[0], **changed), *pattern.panels[1:]))


def others(pattern: Pattern) -> dict[str, Pattern]:
    """Patterns that differ from one in a single respect each."""
    first = pattern.panels[0]
    place, edge = first.placement, first.edges[0]
    other_reading = "extrinsic" if place.reading == "intrinsic" else "intrinsic"
    x, y, z = place.translation
    moved = first.vertices.copy()
    moved[0] = np.nextafter(moved[0], 1e9)
    found = {
        "reading": with_first(pattern, placement=replace(place, reading=other_reading)),
        "rotation": with_first(pattern, placement=replace(place, rotation=(17.0, 5.0, 3.0))),
        "translation": with_first(pattern, placement=replace(place, translation=(x, y + 1.0, z))),
        "panel label": with_first(pattern, label="leg" if first.label != "leg" else "arm"),
        "panel name": with_first(pattern, name="renamed"),
        "edge label": with_first(pattern, edges=(replace(edge, label="left_collar"), *first.edges[1:])),
        "curve": with_first(pattern, edges=(replace(edge, curve=Quadratic((0.5, 0.3))), *first.edges[1:])),
        "vertex": with_first(pattern, vertices=moved),
        "fewer panels": replace(pattern, panels=pattern.panels[1:]),
    }
    if len(pattern.panels) > 1:
        found["order"] = replace(pattern, panels=pattern.panels[::-1])
    if pattern.stitches:
        s, *rest = pattern.stitches
        found["side"] = replace(pattern, stitches=(replace(s, right_wrong=not s.right_wrong), *rest))
        found["unsewn"] = replace(pattern, stitches=tuple(rest))
        found["turned"] = replace(pattern, stitches=(Stitch(s.second, s.first, s.right_wrong), *rest))
    return found


@settings(max_examples=25)
@given(patterns())
def test_a_check_finds_what_it_finds_for_the_first_time(pattern):
    """Of a pattern and of all that differ from it a little, whichever is checked first."""
    each = [pattern, *others(pattern).values(), with_zeros_turned(pattern)]
    fresh = []
    for one in each:
        forget()
        fresh.append(check_pattern(one))
    for order in (1, -1):
        forget()
        again = [check_pattern(one) for one in each[::order]]
        assert again == fresh[::order]
        assert [check_pattern(one) for one in each[::order]] == again


@settings(max_examples=25)
@given(patterns())
def test_equal_patterns_share_and_others_do_not(pattern):
    forget()
    found = check_pattern(pattern)
    for equal in (rebuilt(pattern), with_zeros_turned(pattern), replace(pattern, name="another")):
        assert equal == pattern and hash(equal) == hash(pattern)
        assert check_pattern(equal) is found
    for difference, other in others(pattern).items():
        assert other != pattern, difference
        misses = _check_of_itself.cache_info().misses
        check_pattern(other)
        assert _check_of_itself.cache_info().misses == misses + 1, difference


@settings(max_examples=25)
@given(patterns())
def test_the_sign_of_zero_is_no_difference_between_panels(pattern):
    turned = with_zeros_turned(pattern)
    assert [p.vertices.tobytes() for p in turned.panels] != [p.vertices.tobytes() for p in pattern.panels]
    assert {pattern: 1}[turned] == 1


def test_what_is_found_of_a_reading_is_not_that_of_the_other(square_pattern):
    """A panel that lies flat is turned elsewhere by the same angles, read the other way."""
    turned = with_first(
        square_pattern, placement=replace(square_pattern.panels[0].placement, rotation=(90.0, 0.0, 60.0))
    )
    for reading in ("intrinsic", "extrinsic"):
        read = turned.with_rotation_reading(reading)
        for panel in read.panels:
            outline = trace_outline(panel)
            assert outline.panel.placement.reading == reading
            assert np.array_equal(outline.world, panel.to_world(panel.vertices))
    intrinsic, extrinsic = (
        trace_outline(turned.with_rotation_reading(r).panels[0]).world for r in ("intrinsic", "extrinsic")
    )
    assert np.abs(intrinsic - extrinsic).max() > 1.0


@settings(max_examples=25)
@given(patterns())
def test_what_is_remembered_cannot_be_changed(pattern):
    check_pattern(pattern)
    for panel in pattern.panels:
        outline = trace_outline(panel)
        assert trace_outline(replace(panel)) is outline
        assert not changeable(outline) and not changeable(find_crossing(outline))
    assert not changeable(check_pattern(pattern))


def test_what_others_say_is_not_remembered(square_pattern):
    """With findings of the reader, or a body, it is another check."""
    plain = check_pattern(square_pattern)
    said = Finding("open-loop", Severity.WARNING, "The loop is open.", panel="front")
    assert set(check_pattern(square_pattern, reader_findings=[said])) == {*plain, said}
    inside = check_pattern(square_pattern, body=lambda points: np.full(len(points), -5.0))
    assert set(inside) > set(plain)
    assert check_pattern(square_pattern) is plain


@given(st.lists(st.tuples(st.sampled_from(["sleeve", "skirt", "x"]), st.sampled_from(["", "leg", "arm"]))))
def test_a_label_decides_over_a_name_whatever_was_asked_before(asked):
    by_name = {"sleeve": "arm", "skirt": "leg", "x": "body"}
    for name, label in asked:
        assert body_region(name, label) == (label or by_name[name])


@pytest.mark.parametrize("memo", [*MEMOS, body_region], ids=lambda memo: memo.__name__)
def test_only_so_many_are_kept(memo):
    assert 0 < memo.cache_info().maxsize <= 4096
