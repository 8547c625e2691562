"""What facts must not depend on, and what happens to them when a pattern is changed."""

from __future__ import annotations

import random
import re
from dataclasses import fields, is_dataclass, replace

import numpy as np
import pytest

from swifttailor.describing import GarmentFacts, measure_facts
from swifttailor.errors import PatternError
from swifttailor.pattern import EdgeRef, Pattern, Stitch
from swifttailor.pattern.drafts import draft


def numbers(value, path="") -> dict[str, object]:
    """All leaves of a facts object by their path."""
    if is_dataclass(value):
        return {
            k: v
            for f in fields(value)
            for k, v in numbers(getattr(value, f.name), f"{path}.{f.name}").items()
        }
    if isinstance(value, tuple):
        return {k: v for n, each in enumerate(value) for k, v in numbers(each, f"{path}[{n}]").items()}
    return {path: value}


def assert_same(one: GarmentFacts, other: GarmentFacts, tolerance: float = 1e-6) -> None:
    a, b = numbers(one), numbers(other)
    assert a.keys() == b.keys()
    for key, value in a.items():
        if isinstance(value, float):
            assert value == pytest.approx(b[key], abs=tolerance), key
        else:
            assert value == b[key], key


def shuffled(pattern: Pattern, seed: int) -> Pattern:
    """Panels and stitches in another order, stitches named from their other edge."""
    rng = random.Random(seed)
    panels, stitches = list(pattern.panels), list(pattern.stitches)
    rng.shuffle(panels)
    rng.shuffle(stitches)
    turned = [replace(s, first=s.second, second=s.first) if rng.random() < 0.5 else s for s in stitches]
    return Pattern(tuple(panels), tuple(turned), "other name")


def mirrored(pattern: Pattern) -> Pattern:
    """The garment for the other side: everything reflected in x = 0, left names for right ones."""

    def name(old: str) -> str:
        swap = {"left": "right", "right": "left", "l": "r", "r": "l"}
        return "_".join(swap.get(part, part) for part in old.split("_"))

    panels = []
    last = {p.name: len(p.edges) - 1 for p in pattern.panels}
    for panel in pattern.panels:
        (x, y, z), (a, b, c) = panel.placement.translation, panel.placement.rotation
        flipped = panel.mirrored().reversed()
        placement = replace(panel.placement, translation=(-x, y, z), rotation=(a, -b, -c))
        panels.append(replace(flipped, name=name(panel.name), placement=placement))

    def edge(ref: EdgeRef) -> EdgeRef:
        return EdgeRef(name(ref.panel), last[ref.panel] - ref.edge)

    stitches = tuple(Stitch(edge(s.first), edge(s.second), s.right_wrong) for s in pattern.stitches)
    return Pattern(tuple(panels), stitches, pattern.name)


def swapped(facts: GarmentFacts) -> dict[str, object]:
    """Leaves of the facts with left and right exchanged."""
    swap = {"left": "right", "right": "left"}
    return {re.sub("left|right", lambda m: swap[m[0]], k): swap.get(v, v) for k, v in numbers(facts).items()}


def test_order_of_panels_and_stitches_does_not_matter(drafts):
    for name, pattern in drafts.items():
        assert_same(measure_facts(pattern), measure_facts(shuffled(pattern, 3)))
        assert name


def test_order_does_not_matter_on_real_patterns(real_patterns, real_facts):
    for name in list(real_patterns)[::6]:
        assert_same(real_facts[name], measure_facts(shuffled(real_patterns[name], 1)))


def test_the_mirror_image_has_left_and_right_exchanged(real_patterns, real_facts):
    for name in list(real_patterns)[::4]:
        facts = real_facts[name]
        there, back = swapped(facts), numbers(measure_facts(mirrored(real_patterns[name])))
        slits = {k for k in there if ".slits" in k}
        assert there.keys() == back.keys(), name
        for key in there.keys() - slits:
            if isinstance(there[key], float):
                assert there[key] == pytest.approx(back[key], abs=0.6, rel=0.02), (name, key)
            else:
                assert there[key] == back[key], (name, key)


def test_names_of_another_maker_are_understood(drafts):
    """The same shirt with names of another program and without labels of body parts."""
    pattern = drafts["t-shirt"]
    other = {
        "left_ftorso": "Lfront",
        "right_ftorso": "Rfront",
        "left_btorso": "Lback",
        "right_btorso": "Rback",
    }
    other |= {f"{s}_sleeve_{f}": f"{s[0]}{f}sleeve" for s in ("left", "right") for f in "fb"}
    panels = tuple(replace(p, name=other[p.name], label="") for p in pattern.panels)

    def ref(r: EdgeRef) -> EdgeRef:
        return EdgeRef(other[r.panel], r.edge)

    stitches = tuple(Stitch(ref(s.first), ref(s.second), s.right_wrong) for s in pattern.stitches)
    assert_same(measure_facts(pattern), measure_facts(Pattern(panels, stitches)))


@pytest.mark.parametrize("name", ["trousers", "circle-skirt"])
def test_nameless_panels_are_told_by_place_and_openings(drafts, name):
    pattern = drafts[name]
    other = {p.name: f"panel_{k}" for k, p in enumerate(pattern.panels)}
    panels = tuple(replace(p, name=other[p.name], label="") for p in pattern.panels)
    stitches = tuple(
        Stitch(EdgeRef(other[s.first.panel], s.first.edge), EdgeRef(other[s.second.panel], s.second.edge))
        for s in pattern.stitches
    )
    facts, expected = measure_facts(Pattern(panels, stitches)), measure_facts(pattern)
    assert facts.kind == expected.kind
    assert facts.hem.level == pytest.approx(expected.hem.level, abs=2.0)


def test_a_plain_tube_is_measured(square_pattern):
    """Two rectangles of another maker: a strapless tube from 80 to 140 cm."""
    facts = measure_facts(square_pattern)
    assert facts.kind == "top" and facts.strapless and facts.front_neck is None
    assert facts.hem.length == pytest.approx(80) and facts.torso.chest == pytest.approx(80)


def test_every_real_pattern_is_measured(real_facts):
    for name, facts in real_facts.items():
        for key, value in numbers(facts).items():
            if isinstance(value, float):
                assert np.isfinite(value), (name, key)
        assert facts.kind != "other" and facts.hem is not None, name


def test_left_out_panels_are_missing_in_the_facts(drafts):
    """Parts are measured where they are, not where names would have them."""
    pattern = drafts["hoodie"]
    for part, what in (("hood", "hood"), ("cuff", "cuff"), ("sleeve", "left_sleeve"), ("wb", "waistband")):
        gone = {p.name for p in pattern.panels if part in p.name or (part == "sleeve" and "cuff" in p.name)}
        rest = Pattern(
            tuple(p for p in pattern.panels if p.name not in gone),
            tuple(s for s in pattern.stitches if not {r.panel for r in s.sides} & gone),
        )
        facts = measure_facts(rest)
        if what == "cuff":
            assert facts.left_sleeve.cuff is None
            assert facts.left_sleeve.length < measure_facts(pattern).left_sleeve.length - 5.0
        else:
            assert getattr(facts, what) is None


def test_longer_panels_are_longer_facts():
    short, long = (measure_facts(draft("gathered-skirt", length=x)) for x in (50.0, 70.0))
    assert long.length - short.length == pytest.approx(20.0, abs=0.5)
    assert short.hem.level - long.hem.level == pytest.approx(20.0, abs=0.5)


def test_a_pattern_without_panels_is_refused():
    with pytest.raises(PatternError, match="at least one panel"):
        measure_facts(Pattern(()))


def test_closed_and_odd_shapes_do_not_break_it():
    """Nothing of a garment: two squares sewn together all around."""
    corners = [[0.0, 0.0], [30.0, 0.0], [30.0, 30.0], [0.0, 30.0]]
    from swifttailor.pattern import Placement
    from swifttailor.pattern.panel import Edge, Panel

    a = Panel("a", corners, (Edge(),) * 4, Placement((0, 100, 20)))
    b = Panel("b", corners[::-1], (Edge(),) * 4, Placement((0, 100, -20)))
    pairs = ((0, 2), (1, 1), (2, 0), (3, 3))
    closed = Pattern((a, b), tuple(Stitch(EdgeRef("a", i), EdgeRef("b", j)) for i, j in pairs))
    facts = measure_facts(closed)
    assert facts.hem is None and facts.front_neck is None
    assert measure_facts(Pattern((a,))).panels == 1


@pytest.mark.parametrize(("name", "missing"), [("fitted-skirt", (2, 3)), ("circle-skirt", (0, 2, 3))])
@pytest.mark.filterwarnings("error")
def test_a_skirt_with_a_panel_that_nothing_holds_is_measured(name, missing):
    """As networks write them: a panel is sewn to its neighbours, or to nothing, and not to the waistband."""
    whole = draft(name)
    loose = replace(whole, stitches=tuple(s for k, s in enumerate(whole.stitches) if k not in missing))
    facts = measure_facts(loose)
    assert all(np.isfinite(v) for v in numbers(facts).values() if isinstance(v, float))
    assert facts.skirt is not None and facts.skirt.hips > 0
