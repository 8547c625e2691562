"""What is refitted to children goes around their necks, and its hem stays level."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern.drafts import draft
from swifttailor.recutting.level_hems import has_level_hem
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.refitted import refitted
from swifttailor.tailor.room_for_necks import with_room_for_the_neck


@pytest.fixture(scope="module")
def child():
    body = Body.default()
    return replace(body, measurements=replace(body.measurements, bust=58.0, neck_w=14.0), name="child")


def test_a_sleeveless_dress_goes_around_the_neck_of_a_child(child):
    before = draft("skater-dress")
    was, now = measure_facts(before), measure_facts(with_room_for_the_neck(before, child))
    wide = 2 * now.front_neck.width * 58.0 / Body.default().measurements.bust
    assert wide == pytest.approx(16.0, abs=0.6)
    assert QUANTITIES["armholes"].of(now) > QUANTITIES["armholes"].of(was) + 1.0


@pytest.mark.parametrize(
    "name", ["t-shirt", "shirt", "hoodie", "trousers", "circle-skirt", "strapless-dress"]
)
def test_what_has_sleeves_or_no_neckline_stays(child, name):
    before = draft(name)
    assert with_room_for_the_neck(before, child) == before


def test_grown_bodies_need_none():
    before = draft("skater-dress")
    assert with_room_for_the_neck(before, Body.default()) == before


def longer_at_sides(pattern):
    """A circle skirt whose sides have grown by 6 cm and bend a little, as refitting does."""
    panels = []
    for panel in pattern.panels:
        if panel.name.startswith("skirt_"):
            hem = max(
                range(len(panel.edges)),
                key=lambda k: panel.edges[k].curve is not None and abs(np.ptp(panel.sample_edge(k, 9)[:, 0])),
            )
            vertices = panel.vertices.copy()
            for corner, top in ((hem, hem - 1), ((hem + 1) % len(vertices), (hem + 2) % len(vertices))):
                way = vertices[corner] - vertices[top]
                vertices[corner] = vertices[corner] + 6.0 * way / np.linalg.norm(way)
            panel = replace(panel, vertices=vertices)
        panels.append(panel)
    return replace(pattern, panels=tuple(panels))


def test_the_hem_of_a_circle_stays_level(monkeypatch, child):
    monkeypatch.setattr("swifttailor.refitting.refitted.fit", lambda pattern, body: longer_at_sides(pattern))
    level = draft("circle-skirt", fraction=0.75)
    assert has_level_hem(level) and not has_level_hem(longer_at_sides(level))
    assert has_level_hem(refitted(Answer(level), child).pattern)
    dipped = draft("circle-skirt", fraction=0.75, hem_dip=14.0)
    assert refitted(Answer(dipped), child).pattern == longer_at_sides(dipped)
