"""The network's input."""

from __future__ import annotations

import math

import numpy as np
import pytest

from swifttailor.errors import InputError
from swifttailor.garment_sewer.conditioning import (
    CHANNELS,
    PLACED,
    SEMANTIC,
    Conditioning,
    conditioning_image,
)
from swifttailor.garment_sewer.pixels.pixel_table import tabulate
from swifttailor.ggi.panel_colors import color_types
from swifttailor.ggi.semantic import semantic_image


def test_paper_conditioning_is_the_semantic_picture(layout, table):
    image = conditioning_image(table, Conditioning("none", SEMANTIC))
    picture = color_types(semantic_image(layout)) / 127.5 - 1
    occupied = layout.raster.occupancy
    assert image.shape == (3, 96, 96)
    assert np.allclose(image[:, occupied], picture[occupied].T, atol=1e-6)
    assert not image[:, ~occupied].any()


def test_every_channel_of_single_pixels_is_what_it_says(layout, table):
    image = conditioning_image(table, Conditioning("sewn", PLACED))
    names = [name for name in PLACED for _ in range(CHANNELS[name].count)]
    assert len(image) == len(names)
    chance = np.random.default_rng(1)
    sewn = np.flatnonzero(table.partner >= 0)
    for slot in [*chance.choice(len(table.pixels), 20), *chance.choice(sewn, 10)]:
        row, column = divmod(int(table.pixels[slot]), 96)
        value = {name: image[[k for k, n in enumerate(names) if n == name], row, column] for name in PLACED}
        panel = layout.pattern.panels[table.panel[slot]]
        local = layout.local_points()[slot]
        placed = panel.to_world(local[None])[0]
        lift = np.array([0, 100, 0])
        assert value["occupancy"] == 1
        assert np.allclose(value["prior"] * 50 + lift, table.prior[slot], atol=1e-3)
        assert np.allclose(value["placed"] * 50 + lift, placed, atol=1e-2)
        assert np.allclose(value["local"] * 50, local, atol=1e-2)
        assert np.allclose(value["normal"], panel.normal(), atol=1e-5)
        assert value["scale"] == pytest.approx(math.log(layout.cm_per_pixel))
        assert value["contour"] == (layout.raster.edge[slot] >= 0)
        partner = table.partner[slot]
        assert value["stitched"] == (partner >= 0)
        if partner >= 0:
            other = layout.pattern.panels[table.panel[partner]].to_world(layout.local_points()[[partner]])[0]
            assert np.allclose(value["partner"] * 50, other - placed, atol=1e-2)
            step = layout.raster.points[partner] - layout.raster.points[slot]
            assert np.allclose(value["partner_pixel"] * 96, step, atol=1e-3)
        else:
            assert not value["partner"].any() and not value["partner_pixel"].any()
        assert value["body_distance"] * 10 == pytest.approx(np.clip(table.distance[slot], -10, 30), abs=1e-4)
        assert np.allclose(value["body_direction"], table.direction[slot], atol=1e-6)


def test_channels_come_in_the_order_asked_for(table):
    one = conditioning_image(table, Conditioning("sewn", ("scale", "color")))
    other = conditioning_image(table, Conditioning("sewn", ("color", "scale")))
    assert np.array_equal(one[0], other[3])
    assert np.array_equal(one[1:], other[:3])


@pytest.mark.parametrize(
    ("prior", "channels", "said"),
    [
        ("sewn", ("colour",), "colour"),
        ("sewn", (), "none"),
        ("sewn", ("color", "color"), "twice"),
        ("flat", ("color",), "flat"),
        ("none", ("color", "prior"), "'prior' needs a prior"),
    ],
)
def test_impossible_conditioning_is_refused(prior, channels, said):
    with pytest.raises(InputError, match=said):
        Conditioning(prior, channels)


def test_slope_of_flat_panels_is_their_axes(layout, body_distance):
    """Where the prior is the placed panel, steps along rows and columns are its own unit axes."""
    table = tabulate(layout, "placed", body_distance)
    slope = np.stack(CHANNELS["slope"].columns(table), axis=1).reshape(-1, 2, 3)
    inner = ~table.contour
    expected = (
        table.panel_axes[table.panel]
        * np.stack([table.panel_sign[table.panel], np.ones(len(table.panel))], axis=1)[:, :, None]
    )
    assert inner.sum() > 500
    # Next to the outline, pixels stand for points of it, off the row and the column.
    apart = np.abs(slope - expected).max(axis=(1, 2))
    assert np.median(apart[inner]) < 1e-4
    lengths = np.linalg.norm(slope, axis=2)
    assert (lengths[inner] > 0.99).all() and (lengths < 1.001).all()
