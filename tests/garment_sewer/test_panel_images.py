"""What a network of one image per panel is shown, and that the other is shown what it was."""

from __future__ import annotations

import json

import numpy as np
import pytest

from swifttailor.errors import InputError
from swifttailor.garment_sewer.augmentation import mirror, mirror_points, move_panels, random_cells
from swifttailor.garment_sewer.conditioning import (
    CHANNELS,
    PER_PANEL,
    PLACED,
    Conditioning,
    conditioning_image,
)
from swifttailor.garment_sewer.pixels.pixel_table import tabulate
from swifttailor.garment_sewer.sewer import SHIPPED, GarmentSewer
from swifttailor.ggi import lay_out
from swifttailor.ggi.panel_cells import lay_out_in_cells
from swifttailor.pattern.drafts import draft


@pytest.fixture(scope="module", params=["t-shirt", "shirt-dress"])
def cells(request):
    return lay_out_in_cells(draft(request.param), 96)


@pytest.fixture(scope="module")
def placed(cells, body_distance):
    return tabulate(cells, "placed", body_distance)


def test_pixels_know_where_they_lie_on_their_panel(cells, placed):
    assert np.abs(placed.local() - cells.local_points()).max() < 1e-3
    assert np.abs(placed.prior - placed.placed()).max() < 1e-3


def test_scale_and_aspect_say_what_a_pixel_measures(cells, placed):
    image = conditioning_image(placed, Conditioning("placed", ("scale", "aspect"), "per_panel"))
    mean, half = image.reshape(2, -1)[:, placed.pixels].astype(float)
    cm = cells.panel_cm_per_pixel[placed.panel]
    assert np.allclose(np.exp(mean + half), cm[:, 0], rtol=1e-5)
    assert np.allclose(np.exp(mean - half), cm[:, 1], rtol=1e-5)
    assert np.ptp(half) > 0.1


def test_slope_is_free_of_the_stretch(placed):
    """Where the prior is the placed panel, steps along rows and columns are its own unit axes."""
    slope = np.stack(CHANNELS["slope"].columns(placed), axis=1).reshape(-1, 2, 3)
    sign = np.stack([placed.panel_sign, np.ones_like(placed.panel_sign)], axis=1)
    expected = (placed.panel_axes * sign[:, :, None])[placed.panel]
    inner = ~placed.contour
    assert inner.sum() > 500
    assert np.median(np.abs(slope - expected).max(axis=(1, 2))[inner]) < 1e-4


def test_panels_change_cells_and_stay_what_they_are(cells, placed):
    chance = np.random.default_rng(3)
    seen = set()
    for _ in range(8):
        steps = random_cells(len(cells.boxes), 96, chance)
        moved = move_panels(placed, steps)
        assert len(set(moved.pixels.tolist())) == len(moved.pixels)
        assert moved.pixels.min() >= 0 and moved.pixels.max() < 96**2
        assert moved.panel_box.min() >= 1 and moved.panel_box.max() <= 94
        assert np.abs(moved.local() - placed.local()).max() < 1e-3
        # Boxes are either as far apart as cells, or the same.
        columns = np.unique(moved.panel_box[:, 0])
        assert set(columns.tolist()) <= set(range(1, 96, int(np.diff(columns).min(initial=96))))
        seen.add(tuple(steps.ravel().tolist()))
    assert len(seen) > 4


def test_mirrored_panels_keep_their_cells_and_mirror_in_space(placed):
    mirrored = mirror(placed)
    assert np.array_equal(np.sort(mirrored.panel_box, axis=0), np.sort(placed.panel_box, axis=0))
    assert np.abs(mirrored.placed() - mirror_points(placed.placed())).max() < 2e-3


def test_packed_images_have_square_pixels(body_distance):
    table = tabulate(lay_out(draft("t-shirt"), 64), "placed", body_distance)
    assert not conditioning_image(table, Conditioning("placed", ("aspect",))).any()
    assert Conditioning().channels == PLACED == tuple(c for c in PER_PANEL if c != "aspect")
    assert Conditioning().count + 1 == Conditioning(channels=PER_PANEL).count


def test_an_unknown_layout_is_refused():
    with pytest.raises(InputError, match=r"no layout 'stacked'\. Known ones: packed, per_panel"):
        Conditioning(layout="stacked")


def test_the_card_says_the_layout_and_one_without_is_of_packed_images():
    card = json.loads(SHIPPED.with_suffix(".json").read_text())
    assert "layout" not in card["config"]["conditioning"]
    assert Conditioning.of_card(card).layout == "packed"
    card["config"]["conditioning"]["layout"] = "per_panel"
    assert Conditioning.of_card(card).layout == "per_panel"
    card["config"]["conditioning"]["layout"] = "stacked"
    with pytest.raises(InputError, match="no layout 'stacked'"):
        Conditioning.of_card(card)


def test_the_shipped_network_is_shown_packed_panels(body_distance):
    sewer = GarmentSewer.load()
    assert sewer.model.conditioning.channels == PLACED
    prepared = sewer.prepare(draft("t-shirt"))
    expected = lay_out(draft("t-shirt"), sewer.model.resolution)
    assert prepared.layout.stretch is None
    assert np.array_equal(prepared.layout.origins, expected.origins)
    # The scale as cards without a layout have learnt it.
    image = conditioning_image(prepared.table, Conditioning("placed", ("scale",)))
    scales = image.ravel()[prepared.table.pixels]
    assert (scales == np.float32(np.log(expected.cm_per_pixel))).all()
