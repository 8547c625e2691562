"""Prints are measured in photographs, whatever folds and shadows do, and plain cloth stays plain."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.picture_reader.cloth_repeats import repeat_of
from swifttailor.picture_reader.flat_cloth import FlatCloth
from swifttailor.picture_reader.print_colors import print_colors
from swifttailor.picture_reader.print_head import PLAIN, PRINTS, PrintHead, alone, square_of_cloth
from swifttailor.picture_reader.prints_read import measured
from swifttailor.picture_reader.worn_heads import SIZE, WornHeads
from swifttailor.render.color import encode_srgb, to_linear
from swifttailor.render.lab import lab_of_hex

SIDE = 260
Y, X = np.mgrid[:SIDE, :SIDE]
MASK = ((X >= 30) & (X < 230) & (Y >= 20) & (Y < 240)).astype(np.float32)
NAVY, WHITE, RED = "#1f2a44", "#f4f1ea", "#b3202c"


def photograph(first, second=None, where=None, *, seed=0):
    """A garment in folds, half in shadow, before a wall."""
    linear = np.broadcast_to(to_linear("#d8d2c6"), (SIDE, SIDE, 3)).copy()
    cloth = np.broadcast_to(to_linear(first), (SIDE, SIDE, 3)).copy()
    if second is not None:
        cloth[where] = to_linear(second)
    shade = (0.8 + 0.2 * np.sin(X / 23.0 + Y / 90.0)) * np.where(X + Y > SIDE, 0.7, 1.0)
    linear = np.where(MASK[..., None] > 0, cloth * shade[..., None], linear)
    noise = np.random.default_rng(seed).normal(0, 2, linear.shape)
    return np.clip(encode_srgb(np.clip(linear, 0, 1)) + noise, 0, 255).astype(np.uint8)


def apart(one, other):
    return float(np.linalg.norm(lab_of_hex(one) - lab_of_hex(other)))


@pytest.mark.parametrize(("told", "along"), [("across", Y), ("down", X)])
@pytest.mark.parametrize("repeat", [7, 12, 21, 36])
def test_stripes_have_their_width_and_colours_in_folds(told, along, repeat):
    pixels = photograph(NAVY, WHITE, along % repeat < repeat / 3)
    seen = measured(FlatCloth.of(pixels, MASK), told, 0.9, 0.25)
    assert seen.kind == "stripes" and seen.angle == (90 if told == "down" else 0)
    assert seen.repeat == pytest.approx(0.25 * repeat, rel=0.06)
    assert apart(seen.colors[0], NAVY) < 14 and apart(seen.colors[1], WHITE) < 14
    assert seen.shares[1] == pytest.approx(1 / 3, abs=0.12)


def test_checks_and_dots_repeat_and_have_two_colours():
    checks = photograph(RED, NAVY, (X % 24 < 12) & (Y % 24 < 12))
    seen = measured(FlatCloth.of(checks, MASK), "checks", 0.9, 0.25)
    assert seen.repeat == pytest.approx(6.0, rel=0.06) and len(seen.colors) == 2
    dots = photograph(NAVY, WHITE, (X % 20 - 10) ** 2 + (Y % 20 - 10) ** 2 < 20)
    seen = measured(FlatCloth.of(dots, MASK), "dots", 0.9, 0.25)
    assert seen.repeat == pytest.approx(5.0, rel=0.06)
    assert apart(seen.colors[0], NAVY) < 12 and seen.shares[1] < 0.3


@pytest.mark.parametrize("color", [NAVY, WHITE, RED, "#8a8f94"])
def test_cloth_of_one_colour_has_no_second_and_does_not_repeat(color):
    cloth = FlatCloth.of(photograph(color), MASK)
    assert not print_colors(cloth, 3, 0.06)
    assert measured(cloth, "across", 0.8, 0.25) is None
    found = repeat_of(cloth, (0.0, 90.0))
    assert found is None or found.certainty < 0.3


def test_of_next_to_nothing_nothing_is_measured():
    pixels = photograph(NAVY)
    assert FlatCloth.of(pixels, np.zeros_like(MASK)) is None
    assert square_of_cloth(np.zeros_like(MASK)) is None
    tiny = ((X < 8) & (Y < 8)).astype(np.float32)
    assert FlatCloth.of(pixels, tiny) is None and square_of_cloth(tiny) is None


def test_the_square_lies_within_the_garment_and_what_is_alone_shows_nothing_else():
    left, top, side = square_of_cloth(MASK)
    assert MASK[top : top + side, left : left + side].min() == 1 and side > 190
    shown = alone(photograph(RED), MASK)
    assert shown.shape == (SIZE, SIZE, 3)
    assert apart("#" + "".join(f"{v:02x}" for v in shown[SIZE // 2, 2]), RED) < 25


def test_the_network_tells_stripes_from_shadows():
    head = PrintHead.load(WornHeads.load().trunk)
    striped = head.told(photograph(NAVY, WHITE, Y % 18 < 8), MASK)
    assert set(striped) == set(PRINTS) and sum(striped.values()) == pytest.approx(1)
    assert max(striped, key=striped.__getitem__) == "across"
    turned = head.told(photograph(NAVY, WHITE, X % 18 < 8), MASK)
    assert max(turned, key=turned.__getitem__) == "down"
    assert head.told(photograph(RED), MASK)[PLAIN] > 0.5
    assert not head.told(photograph(RED), np.zeros_like(MASK))
