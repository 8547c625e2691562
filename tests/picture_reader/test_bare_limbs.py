"""Bare arms and legs of somebody are told by the colours of face and clothes."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image, ImageDraw

from swifttailor.picture_reader.bare_limbs import BareLimbs
from swifttailor.picture_reader.bare_skin import FOREARM, SHIN, BareSkin
from swifttailor.picture_reader.body_joints import (
    ANKLES,
    EYES,
    HIPS,
    KNEES,
    MOUTH,
    NOSE,
    SHOULDERS,
    WRISTS,
    BodyJoints,
)

SKINS = [(224, 172, 140), (140, 90, 60), (90, 58, 42)]
CLOTHS = [(40, 70, 150), (30, 30, 34), (60, 130, 70)]
PLACES = {
    NOSE: [(200, 60)],
    EYES: [(212, 50), (188, 50)],
    MOUTH: [(208, 78), (192, 78)],
    SHOULDERS: [(250, 130), (150, 130)],
    (13, 14): [(280, 220), (120, 220)],
    WRISTS: [(300, 310), (100, 310)],
    HIPS: [(230, 320), (170, 320)],
    KNEES: [(235, 440), (165, 440)],
    ANKLES: [(235, 550), (165, 550)],
}


def joints(unseen=()):
    places, seen = np.zeros((39, 2)), np.zeros(39)
    for which, at in PLACES.items():
        places[list(which)], seen[list(which)] = at, 0.0 if which in unseen else 0.98
    return BodyJoints(places, seen)


def somebody(skin, cloth, *, forearms=True, upper_arms=True, shins=True):
    """A picture of somebody whose limbs are bare or not, lit from aside, and which pixels show them."""
    image, mask = Image.new("RGB", (400, 600), (120, 150, 120)), Image.new("L", (400, 600))
    for pen, colour in ((ImageDraw.Draw(image), None), (ImageDraw.Draw(mask), 255)):

        def limb(a, b, bare, width, pen=pen, colour=colour):
            pen.line([a, b], fill=colour or (skin if bare else cloth), width=width)

        pen.ellipse((165, 20, 235, 105), fill=colour or skin)
        pen.polygon([(150, 118), (250, 118), (235, 330), (165, 330)], fill=colour or cloth)
        for side in (0, 1):
            limb(PLACES[SHOULDERS][side], PLACES[13, 14][side], upper_arms, 34)
            limb(PLACES[13, 14][side], PLACES[WRISTS][side], forearms, 28)
            limb(PLACES[HIPS][side], PLACES[KNEES][side], False, 50)
            limb(PLACES[KNEES][side], PLACES[ANKLES][side], shins, 36)
    lit = np.asarray(image) * np.linspace(0.8, 1.1, 400)[None, :, None]
    noise = np.random.default_rng(0).normal(0, 4, lit.shape)
    return np.clip(lit + noise, 0, 255).astype(np.uint8), np.asarray(mask) > 0


@pytest.mark.parametrize("cloth", CLOTHS)
@pytest.mark.parametrize("skin", SKINS)
def test_what_looks_like_the_face_is_bare(skin, cloth):
    bare = BareLimbs.of(*somebody(skin, cloth), joints())
    short = BareLimbs.of(*somebody(skin, cloth, upper_arms=False), joints())
    covered = BareLimbs.of(*somebody(skin, cloth, forearms=False, upper_arms=False, shins=False), joints())
    assert bare.forearms > 1 and short.forearms > 1 and covered.forearms < -1
    assert bare.upper_arms > 1 and short.upper_arms < -0.5 and covered.upper_arms < -0.5
    assert bare.shins > 0.5 > -0.5 > covered.shins
    assert bare.knees_seen == pytest.approx(0.98) and bare.hips_seen == pytest.approx(0.98)


def test_what_is_not_seen_tells_nothing():
    pixels, mask = somebody(SKINS[0], CLOTHS[0])
    faceless = BareLimbs.of(pixels, mask, joints(unseen=(MOUTH,)))
    assert (faceless.forearms, faceless.upper_arms, faceless.shins) == (0, 0, 0)
    assert faceless.knees_seen == pytest.approx(0.98)
    hidden = BareLimbs.of(pixels, mask, joints(unseen=(WRISTS, KNEES)))
    assert (hidden.forearms, hidden.shins) == (0, 0) and hidden.upper_arms > 1
    assert hidden.knees_seen == 0


def test_places_beyond_the_picture_are_not_looked_at():
    pixels, mask = somebody(SKINS[0], CLOTHS[0])
    cut = BareSkin.of(pixels[:270], mask[:270], joints())
    assert cut.legs(SHIN) == () and len(cut.arms(FOREARM)) == 2
    assert BareSkin.of(pixels[:270, :40], mask[:270, :40], joints()) is None


def test_joints_are_told_in_pixels_of_the_picture():
    said = np.zeros((39, 5), np.float32)
    said[25, :4] = 64, 128, 0, 3
    found = BodyJoints.of(said, (-20, 40, 512), 256)
    assert found.places[25].tolist() == [108.0, 296.0]
    assert found.surest(KNEES) == pytest.approx(1 / (1 + np.exp(-3)), abs=1e-4)
    assert found.least_sure(KNEES) == pytest.approx(0.5)
    assert found.middle(KNEES).tolist() == [44.0, 168.0]
