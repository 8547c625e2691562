"""What a look at a pattern found is remembered by the pattern's value, its name and the body."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from pattern_strategies import patterns
from unchangeable import changeable

from swifttailor.body import Body
from swifttailor.describing import measure_facts
from swifttailor.describing.measuring.anatomy import Anatomy, _look_at
from swifttailor.describing.measuring.cloth import Cloth, _remembered_ways, mutually_visible
from swifttailor.describing.measuring.wear import wear
from swifttailor.describing.measuring.whole_pattern import measure_anatomy
from swifttailor.pattern import curve as curves
from swifttailor.pattern.drafts import draft

MEMOS = (_look_at, wear, measure_anatomy, _remembered_ways)
INNER = (curves._sampled, curves._flattened, curves._length_table)
DRAFTS = ("t-shirt", "shirt-dress", "trousers", "circle-skirt")


def forget():
    for memo in (*MEMOS, *INNER):
        memo.cache_clear()


@pytest.fixture(scope="module")
def body():
    return Body.default().measurements


def seen(anatomy: Anatomy):
    """What is known of a pattern and of how it hangs, in a form that can be compared."""
    cloth, worn = anatomy.cloth, wear(anatomy)
    arrays = [
        cloth.world + 0.0,
        cloth.node,
        cloth.ways.data,
        cloth.ways.indices,
        cloth.ways.indptr,
        worn.level,
    ]
    borders = [(loop.edges, loop.length, kind) for loop, kind in anatomy.borders]
    return (
        [a.tobytes() for a in arrays],
        {ref: samples.tolist() for ref, samples in cloth.samples.items()},
        dict(cloth.lengths),
        dict(anatomy.parts),
        borders,
        (worn.top, worn.shoulders, worn.lifted),
        measure_anatomy(anatomy),
    )


def altered(pattern):
    """The pattern, and some that differ from it in one respect."""
    first, *rest = pattern.panels
    x, y, z = first.placement.translation
    other = "extrinsic" if first.placement.reading == "intrinsic" else "intrinsic"

    def with_first(**changed):
        return replace(pattern, panels=(replace(first, **changed), *rest))

    return [
        pattern,
        with_first(placement=replace(first.placement, translation=(x, y - 7.0, z))),
        with_first(placement=replace(first.placement, rotation=(20.0, 30.0, 5.0))),
        with_first(placement=replace(first.placement, rotation=(20.0, 30.0, 5.0), reading=other)),
        with_first(vertices=first.vertices * 1.1),
        with_first(label="arm" if first.label != "arm" else "leg"),
        replace(pattern, stitches=pattern.stitches[1:]),
        replace(pattern, name="another"),
    ]


@settings(max_examples=10)
@given(patterns())
def test_a_look_sees_what_it_sees_for_the_first_time(pattern):
    body = Body.default().measurements
    each = altered(pattern)
    fresh = []
    for one in each:
        forget()
        fresh.append(seen(Anatomy.of(one, body)))
    for order in (1, -1):
        forget()
        assert [seen(Anatomy.of(one, body)) for one in each[::order]] == fresh[::order]
        assert [seen(Anatomy.of(one, body)) for one in each[::order]] == fresh[::order]


@pytest.mark.parametrize("name", DRAFTS)
def test_drafts_measure_the_same_again_and_after_others(name, body):
    each = altered(draft(name))
    fresh = []
    for one in each:
        forget()
        fresh.append(measure_facts(one, body))
    forget()
    assert [measure_facts(one, body) for one in each * 2] == fresh * 2
    assert len(set(map(repr, fresh))) >= 3, "the alterations can be seen"


def test_equal_patterns_are_looked_at_once_unless_they_are_called_differently(body):
    pattern = draft("t-shirt")
    looked = Anatomy.of(pattern, body)
    assert Anatomy.of(replace(pattern, panels=tuple(map(replace, pattern.panels))), body) is looked
    renamed = Anatomy.of(replace(pattern, name="mine"), body)
    assert renamed is not looked
    assert (looked.pattern.name, renamed.pattern.name) == (pattern.name, "mine")
    for other in altered(pattern)[1:]:
        assert Anatomy.of(other, body) is not looked


def test_each_body_has_its_own_look(body):
    pattern, taller = draft("t-shirt"), replace(body, height=body.height + 10.0)
    facts = measure_facts(pattern, body)
    assert Anatomy.of(pattern, body) is not Anatomy.of(pattern, taller)
    assert measure_facts(pattern, taller).body != facts.body
    assert measure_facts(pattern, replace(body)) == facts


@pytest.mark.parametrize("name", DRAFTS)
def test_what_is_remembered_cannot_be_changed(name, body):
    anatomy = Anatomy.of(draft(name).canonical(), body)
    assert not changeable(anatomy)
    assert not changeable(wear(anatomy))
    assert not changeable(measure_anatomy(anatomy))
    with pytest.raises(ValueError, match="read-only"):
        wear(anatomy).level[0] += 1.0
    with pytest.raises(TypeError):
        anatomy.cloth.lengths[next(iter(anatomy.cloth.lengths))] = 0.0


@settings(max_examples=20)
@given(patterns())
def test_straight_ways_are_those_found_afresh(pattern):
    for panel in pattern.panels:
        points = panel.outline(1.0)
        _remembered_ways.cache_clear()
        expected = mutually_visible(points)
        for _ in range(2):
            found = _remembered_ways(points.tobytes())
            assert all(np.array_equal(a, b) for a, b in zip(found, expected, strict=True))
            assert not changeable(found)


def test_distances_leave_the_cloth_as_it_is():
    cloth = Cloth.of(draft("shirt-dress"))
    before = [cloth.world.tobytes(), cloth.node.tobytes(), cloth.ways.data.tobytes()]
    first = cloth.distances(np.array([0, 3]), np.array([1.0, 2.0]))
    first[:] = np.nan
    assert np.isfinite(cloth.distances(np.array([0, 3]), np.array([1.0, 2.0]))).any()
    assert [cloth.world.tobytes(), cloth.node.tobytes(), cloth.ways.data.tobytes()] == before


@pytest.mark.parametrize("memo", MEMOS, ids=lambda memo: memo.__name__)
def test_only_so_many_are_kept(memo):
    assert 0 < memo.cache_info().maxsize <= 256
