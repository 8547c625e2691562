"""The body as cloth feels it."""

from __future__ import annotations

import numpy as np

from swifttailor.body import Body, BodyPart
from swifttailor.garment_sewer.pixels.body_distance import panels_ignoring_arms
from swifttailor.pattern.drafts import draft


def test_arms_are_felt_by_some_points_and_not_by_others(body_distance):
    body = Body.default()
    on_hand = body.vertices[body.vertex_part == BodyPart.LEFT_ARM]
    hand = on_hand[on_hand[:, 1].argmin()] + [0.0, 3.0, 0.0]
    points = np.array([hand, hand])
    distance, direction = body_distance.sample(points, np.array([False, True]))
    assert distance[0] < 1.5
    assert distance[1] > distance[0] + 3
    assert np.allclose(np.linalg.norm(direction, axis=1), 1)


def test_pushed_points_come_out_and_others_stay(body_distance):
    chance = np.random.default_rng(0)
    points = chance.uniform([-20, 80, -15], [20, 150, 15], (500, 3))
    legs = chance.random(500) < 0.5
    before, _ = body_distance.sample(points, legs)
    pushed = body_distance.push_out(points, legs, 0.5, rounds=12)
    after, _ = body_distance.sample(pushed, legs)
    assert (after > 0.3).mean() > 0.98
    assert np.array_equal(pushed[before > 0.5], points[before > 0.5])


def test_skirts_ignore_the_arms_and_sleeves_do_not():
    pattern = draft("shirt-dress")
    ignoring = panels_ignoring_arms(pattern)
    for panel, ignores in zip(pattern.panels, ignoring, strict=True):
        assert ignores == ("skirt" in panel.name)
