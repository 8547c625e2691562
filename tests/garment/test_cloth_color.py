import json
import struct
from dataclasses import replace

import numpy as np
import pytest

import swifttailor
from swifttailor.garment.cloth_color import PALETTE, cloth_color
from swifttailor.garment.cloth_print import ClothPrint
from swifttailor.garment.cloth_surfaces import cloth_surface, cloth_surfaces
from swifttailor.garment.glb import glb_bytes
from swifttailor.garment.triangle_mesh import mesh_of_garment
from swifttailor.garment.trim_colors import is_dark
from swifttailor.render.color import BACKGROUND, BODY, to_linear

DRAFTS = ("circle-skirt", "fitted-dress", "gathered-skirt", "hoodie", "jumpsuit", "shirt-dress", "trousers")


def test_garments_differ_and_each_keeps_its_colour():
    found = [cloth_color(swifttailor.draft(name)) for name in DRAFTS]
    assert found == [cloth_color(swifttailor.draft(name)) for name in DRAFTS]
    assert len(set(found)) >= 4 and set(found) <= set(PALETTE)


def test_a_longer_skirt_keeps_its_colour():
    short, long = (swifttailor.draft("shirt-dress", skirt_length=length) for length in (45, 60))
    assert cloth_color(short) == cloth_color(long)


@pytest.mark.parametrize("color", PALETTE)
def test_every_colour_can_be_told_from_the_figure_and_the_backdrop(color):
    for other in (BODY, BACKGROUND):
        assert np.abs(np.sqrt(to_linear(color)) - np.sqrt(to_linear(other))).max() > 0.2


def test_files_have_the_colour_of_the_preview(tube):
    base = to_linear(cloth_color(tube.pattern))
    content = glb_bytes(mesh_of_garment(tube))
    length = struct.unpack("<I", content[12:16])[0]
    cloth, seam = (
        m["pbrMetallicRoughness"]["baseColorFactor"]
        for m in json.loads(content[20 : 20 + length])["materials"]
    )
    assert cloth == [*np.round(base, 4), 1.0]
    assert all(dark < light for dark, light in zip(seam[:3], cloth[:3], strict=True))
    shown = cloth_surface(tube, tint_panels=False).color
    assert np.allclose(shown, base)


def test_the_wrong_side_of_printed_cloth_has_the_hue_of_its_first_colour(tube):
    dots = ClothPrint("dots", ("#c02020", "#ffffff"))
    red, green, blue = cloth_surface(replace(tube, print=dots)).back_color
    assert red > 2 * green and red > 2 * blue
    red, green, blue = cloth_surface(replace(tube, print=dots), "#2020c0").back_color
    assert blue > 2 * red, "a colour that is asked for goes first"


def test_what_is_woven_is_seen_on_both_sides(tube):
    """Under the folds of a kilt its tartan goes on; a printed flower does not go through the cloth."""
    checks = ClothPrint("checks", ("#ffffff", "#202020"), {"width": 2.0})
    right, wrong = (seen.surface for seen in cloth_surfaces(replace(tube, print=checks)))
    assert right.back_color is None and wrong.back_color is None, "each is drawn from its own side"
    assert np.array_equal(wrong.faces, right.faces[:, ::-1])
    assert np.array_equal(wrong.print_at, right.print_at[:, ::-1]), "the same threads at the same place"
    assert not wrong.lines
    dots = ClothPrint("dots", ("#ffffff", "#202020"), {})
    (only,) = cloth_surfaces(replace(tube, print=dots))
    assert only.surface.back_color is not None


def test_seams_are_lighter_on_cloth_that_is_nearly_black_and_not_on_strong_colours():
    assert is_dark(to_linear("#17171a")) and is_dark(to_linear("#1f2a44"))
    assert not is_dark(to_linear("#6d1a2d")) and not is_dark(to_linear("#ffffff"))
