"""The colour of cloth is seen in pictures, whatever light, folds and a careless mask do to it."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.picture_reader.seen_color import seen_color
from swifttailor.render.color import encode_srgb, to_linear
from swifttailor.render.lab import lab_of_hex

WHITE, BLACK, RED = "#f6f4ef", "#141417", "#b3202c"
CLOTHS = (WHITE, BLACK, "#85878a", RED, "#1f2a44", "#e0b52a", "#f2a9bb", "#2c6b45", "#5f8fc4", "#c9b08a")
WARM = (1.0, 0.87, 0.7)
HEIGHT, WIDTH = 200, 150
Y, X = np.mgrid[:HEIGHT, :WIDTH]


def cut(left=45, right=105, top=40, bottom=170):
    return (X >= left) & (X < right) & (Y >= top) & (Y < bottom)


def picture(cloth, *, light=(1.0, 1.0, 1.0), wall="#e8e6e1", second=None, where=None):
    """A garment in folds, with a shine and skin above it, before a wall; and where it is."""
    inside = cut()
    linear = np.broadcast_to(to_linear(wall), (HEIGHT, WIDTH, 3)).copy()
    linear[cut(60, 90, 15, 40)] = to_linear("#c68f72")
    linear[inside] = to_linear(cloth)
    if second is not None:
        linear[inside & where] = to_linear(second)
    folds = 0.72 + 0.28 * np.sin(X / 5.0 + Y / 40.0)
    linear[inside] *= folds[inside, None]
    shine = inside & cut(70, 74, 60, 120)
    linear[shine] = 0.4 * linear[shine] + 0.6
    noise = np.random.default_rng(1).normal(0, 3, (HEIGHT, WIDTH, 3))
    pixels = np.clip(encode_srgb(np.clip(linear * light, 0, 1)) + noise, 0, 255).astype(np.uint8)
    return pixels, inside.astype(np.float32)


def apart(one, other):
    return float(np.linalg.norm(lab_of_hex(one) - lab_of_hex(other)))


@pytest.mark.parametrize("cloth", CLOTHS)
@pytest.mark.parametrize("light", [(1.0, 1.0, 1.0), WARM])
def test_cloth_has_its_colour_in_folds_and_in_warm_light(cloth, light):
    seen = seen_color(*picture(cloth, light=light))
    assert apart(seen.rgb, cloth) < 10 and not seen.others and seen.share > 0.85


def test_warm_light_is_told_by_what_is_white_and_a_white_garment_speaks_against_it():
    cream, wood = "#efe3c4", "#d9b98a"
    assert apart(seen_color(*picture(cream, wall="#f2f1ef")).rgb, cream) < 6
    assert apart(seen_color(*picture(WHITE, wall=wood)).rgb, WHITE) < 6
    assert apart(seen_color(*picture("#5f8fc4", wall=wood)).rgb, "#5f8fc4") < 6


def test_of_two_colours_the_one_that_covers_most_is_taken_and_the_other_is_said():
    seen = seen_color(*picture(RED, second=WHITE, where=Y > 125))
    assert apart(seen.rgb, RED) < 9 and 0.55 < seen.share < 0.8
    (other,) = seen.others
    assert apart(other, WHITE) < 9
    striped = seen_color(*picture(BLACK, second=WHITE, where=Y // 10 % 3 == 0))
    assert apart(striped.rgb, BLACK) < 12 and striped.others


def test_skin_and_wall_at_the_border_of_the_mask_do_not_count():
    pixels, _ = picture("#1f2a44")
    wider = (cut(42, 108, 37, 173)).astype(np.float32)
    assert seen_color(pixels, wider) is not None and not seen_color(pixels, wider).others
    spilt = cut(10, 105, 40, 170).astype(np.float32)  # as much wall as cloth
    spilt[:, :45] *= X[:, :45] > 0
    assert apart(seen_color(pixels, spilt).rgb, "#1f2a44") < 9


def test_of_next_to_nothing_no_colour_is_told_and_the_answer_is_always_the_same():
    pixels, mask = picture(RED)
    assert seen_color(pixels, np.zeros_like(mask)) is None
    assert seen_color(pixels, cut(60, 63, 60, 63).astype(np.float32)) is None
    flat = np.full_like(pixels, 200)
    assert apart(seen_color(flat, mask).rgb, "#c8c8c8") < 3
    assert seen_color(pixels, mask) == seen_color(pixels, mask)
    large = np.kron(pixels, np.ones((4, 4, 1), np.uint8)), np.kron(mask, np.ones((4, 4), np.float32))
    assert apart(seen_color(*large).rgb, RED) < 9
