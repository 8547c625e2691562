from __future__ import annotations

import time
from dataclasses import replace

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from pattern_faults import dart, panel, skirt, tube
from pattern_strategies import patterns

from swifttailor.pattern import EdgeRef, Pattern, Stitch, check_pattern
from swifttailor.pattern.check.seam_topology import SeamTopology

CHECKED = settings(max_examples=60, deadline=None)


def partition(topology):
    """Classes as a set of frozen sets, whatever corner stands for each."""
    classes = {}
    for corner, c in enumerate(topology.class_of):
        classes.setdefault(c, set()).add(corner)
    return {frozenset(members) for members in classes.values()}


def flipped(pattern, stitches):
    turned = [replace(s, right_wrong=s.right_wrong ^ (k in stitches)) for k, s in enumerate(pattern.stitches)]
    return replace(pattern, stitches=tuple(turned))


@CHECKED
@given(patterns(), st.lists(st.sets(st.integers(0, 20), max_size=3), max_size=5))
def test_turning_stitches_joins_what_a_fresh_look_would_join(pattern, moves):
    topology = SeamTopology(pattern)
    turned = set()
    for move in moves:
        move = {s for s in move if s < len(pattern.stitches)}
        saved = topology.collapses_saved(sorted(move))
        before = topology.collapses()
        topology.flip(sorted(move))
        turned ^= move
        assert partition(topology) == partition(SeamTopology(flipped(pattern, turned)))
        assert saved is None or saved == before - topology.collapses()
    assert all(topology.start_to_start(s) == pattern.stitches[s].right_wrong ^ (s in turned)
               for s in topology.stitches)  # fmt: skip


def test_sound_seams_join_no_corners_of_one_panel_but_the_mouths_of_darts():
    for pattern in (tube(), skirt(), dart()):
        topology = SeamTopology(pattern)
        assert topology.collapses() == topology.dart_count() and topology.collapsed_edges() == []
        for s in topology.stitches:
            saved = topology.collapses_saved([s])
            assert saved is not None and saved <= 0
    assert SeamTopology(skirt(flip=[1])).collapses_saved([1]) == 2


def test_only_neighbours_touch():
    topology = SeamTopology(skirt())
    assert topology.touching([0]) == {0, 1} and topology.touching([2, 3]) == {2, 3}


def test_thousands_of_wrong_stitches_are_judged_in_time():
    """Partners drawn from close by, so that there are many small contradictions to resolve."""
    rng = np.random.default_rng(0)
    angle = np.linspace(0, 2 * np.pi, 1000, endpoint=False)
    circle = 100 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    panels = tuple(panel(f"p{k}", circle, z=30.0 + k) for k in range(10))
    refs = [EdgeRef(p.name, k) for p in panels for k in range(1000)]
    order = np.argsort(np.arange(10_000) + rng.uniform(0, 6, 10_000))
    stitches = [Stitch(refs[a], refs[b], bool(a % 2)) for a, b in order.reshape(-1, 2)]
    started = time.process_time()
    found = check_pattern(Pattern(panels, tuple(stitches)))
    assert time.process_time() - started < 10
    assert any(f.code == "twisted-seam" for f in found)
