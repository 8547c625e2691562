"""A print that a photograph shows is made as one that words ask for, and words outrank it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from seeing import Seeing, worn

from swifttailor.picture_reader.seen_print import SeenPrint
from swifttailor.tailor.order import Order
from swifttailor.tailor.orders_read import read_order
from swifttailor.tailor.picture_print import cloth_of, print_line, print_report
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.reader import WishReader

PHOTO = np.random.default_rng(0).integers(0, 255, (90, 60, 3), np.uint8)
NAVY, WHITE, RED = "#1f2a44", "#ffffff", "#b3202c"
STRIPES = SeenPrint("stripes", 0.9, (NAVY, WHITE), (0.75, 0.25), 0.0, 4.0)


def test_stripes_are_as_wide_as_they_are_seen_and_told_in_words_that_are_heard():
    cloth = cloth_of(STRIPES)
    assert cloth.kind == "stripes" and cloth.colors == (NAVY, WHITE)
    assert cloth.sizes == {"width": 3.0, "gap": 1.0, "angle": 0.0}
    line = print_line(STRIPES)
    assert line.startswith("navy and white stripes around the body, again after 4.0 cm")
    heard = hear_description("T-shirt, navy and white horizontal stripes", WishReader.load()).print
    assert (heard.kind, heard.size("angle")) == (cloth.kind, cloth.size("angle"))
    assert print_report(STRIPES)["kind"] == "stripes"


@pytest.mark.parametrize(
    ("seen", "kind", "sizes"),
    [
        (replace(STRIPES, angle=90.0, repeat=None), "stripes", {"width": 1.8, "gap": 0.6, "angle": 90.0}),
        (replace(STRIPES, angle=90.0, repeat=60.0), "stripes", {"width": 1.8, "gap": 0.6, "angle": 90.0}),
        (
            SeenPrint("stripes", 0.9, (NAVY, WHITE, RED), (0.4, 0.3, 0.3), 0.0, 6.0),
            "motif",
            {"repeat": 12.0, "angle": 0.0},
        ),
        (SeenPrint("checks", 0.9, (RED, NAVY), (0.6, 0.4), 0.0, 4.0), "checks", {"width": 2.0}),
        (SeenPrint("checks", 0.9, (RED, NAVY, WHITE), (0.5, 0.3, 0.2), 0.0, 5.0), "plaid", {"spacing": 2.0}),
        (SeenPrint("figures", 0.9, (RED, NAVY), (0.8, 0.2)), "motif", {"repeat": 15.0}),
    ],
)
def test_prints_are_those_that_words_ask_for(seen, kind, sizes):
    cloth = cloth_of(seen)
    assert cloth.kind == kind and dict(cloth.sizes) == sizes
    assert cloth.drawn().colors(np.zeros((1, 2))).shape == (1, 3)


def test_dots_lie_apart_and_do_not_touch():
    cloth = cloth_of(SeenPrint("dots", 0.9, (NAVY, WHITE), (0.9, 0.1), 0.0, 2.0))
    assert cloth.colors == (NAVY, WHITE) and 0 < cloth.size("radius") < cloth.size("spacing") / 2


@pytest.mark.parametrize(
    ("text", "printed", "color"),
    [
        ("", True, NAVY),
        ("with a pocket", True, NAVY),
        ("a red one", False, None),
        ("plain", False, None),
        ("white dots on blue", False, None),
    ],
)
def test_words_about_colours_and_prints_outrank_what_is_seen(text, printed, color):
    part = replace(worn("upper", {"kind": ("top", 0.95), "sleeves": ("short", 0.9)}), print=STRIPES)
    order = Order(text, image=PHOTO)
    wanted = read_order(order, WishReader.load(), Seeing((part,), is_photograph=True, is_laid=True))
    assert (wanted.seen_print is not None) == printed
    if printed:
        assert wanted.print == cloth_of(STRIPES) and wanted.color == color
    else:
        assert wanted.print is None or wanted.print.kind == "dots"
