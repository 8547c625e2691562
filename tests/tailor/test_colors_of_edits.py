"""The colour of a garment that is changed: names of garments imply one, and change none."""

from __future__ import annotations

from dataclasses import replace

import pytest

import swifttailor
from swifttailor.garment.cloth_color import cloth_color
from swifttailor.garment.cloth_print import ClothPrint
from swifttailor.tailor import Order


@pytest.fixture(scope="module")
def tailor() -> swifttailor.Tailor:
    return swifttailor.Tailor.load()


@pytest.mark.parametrize(
    ("text", "changes"),
    [
        ("pencil skirt", False),
        ("make it longer", False),
        ("flapper: knee length", False),
        ("make it red", True),
        ("in denim", True),
        ("turn it into jeans", True),
    ],
)
def test_only_colours_that_are_said_or_come_with_another_garment_change_it(tailor, text, changes):
    skirt = swifttailor.draft("circle-skirt")
    wanted = tailor.read(Order(text, edit=skirt, color="#204060"))
    kept = replace(wanted, order=replace(wanted.order, color=None)).color
    assert (wanted.color != "#204060") == changes
    assert changes or kept == cloth_color(skirt)


def test_a_print_stays_where_a_name_has_a_colour(tailor):
    stripes = ClothPrint("stripes", ("#ffffff",))
    skirt = swifttailor.draft("circle-skirt")
    assert tailor.read(Order("pencil skirt", edit=skirt, print=stripes)).print == stripes
