"""Drafts for cloth that stretches are cut smaller around, as high as before, and say so."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.draping.fabric import STRETCHY
from swifttailor.draping.known_fabrics import get_fabric
from swifttailor.errors import PatternError
from swifttailor.garment_sewer import GarmentSewer
from swifttailor.garment_sewer.relaxing import relaxed
from swifttailor.garment_sewer.tightness import is_too_tight
from swifttailor.making.made_for import made_for
from swifttailor.pattern.drafts import draft, list_drafts
from swifttailor.pattern.drafts.draft_names import STRETCHING
from swifttailor.pattern.garmentcode_reader import read_specification
from swifttailor.pattern.garmentcode_writer import to_specification
from swifttailor.recutting.table.workbench import Workbench

WITH_STRETCH = [d.name for d in list_drafts() if any(o.name == "stretch" for o in d.options)]


def extent(pattern, axis):
    """Of all panels together, how far each goes along a local axis, cm."""
    return sum(float(np.ptp(panel.vertices[:, axis])) for panel in pattern.panels)


ONE_PIECES = ("bodysuit", "swimsuit")
"""What has a seam at the waist and darts where its cloth does not stretch."""


@pytest.mark.parametrize("name", WITH_STRETCH)
def test_it_is_narrower_and_as_long(name):
    least = 4.0 if name in ONE_PIECES else 0.0
    usual, close = draft(name, stretch=least), draft(name, stretch=least + 8)
    assert [p.name for p in usual.panels] == [p.name for p in close.panels]
    assert 0.9 < extent(close, 0) / extent(usual, 0) < 0.985
    assert extent(close, 1) == pytest.approx(extent(usual, 1), rel=0.03)
    assert (usual.cloth_stretch, close.cloth_stretch) == pytest.approx((least / 100, least / 100 + 0.08))


def hem_around(pattern):
    """Of the lower edges of all four parts of a top, cm."""
    return 2 * sum(float(np.ptp(_lowest(pattern.panel(f"left_{side}torso")))) for side in "fb")


def _lowest(panel):
    """Places across of the corners of the lower edge."""
    level = panel.vertices[:, 1].min() + 6.0
    return panel.vertices[panel.vertices[:, 1] < level, 0]


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("tank-top", {"waist_shaping": 4.0, "length": -9.0, "chest_ease": 2.0}),
        ("camisole", {"length": -10.0, "chest_ease": 6.0, "flare": 0.0}),
        ("bandeau", {"knit": True, "length": -6.0}),
    ],
)
def test_what_ends_at_the_ribs_lies_on_them(name, options):
    """It is narrower at its hem than the ribs, though not by more than its cloth gives."""
    ribs, pattern = 91.0, draft(name, stretch=10.0, **options)
    assert 0.8 * ribs < hem_around(pattern) < ribs


def test_a_knitted_bandeau_has_no_darts():
    assert len(draft("bandeau", knit=True).stitches) < len(draft("bandeau").stitches)


def test_those_that_always_stretch_are_known_by_name():
    assert {name for name in WITH_STRETCH if draft(name).cloth_stretch > 0} == STRETCHING


def test_files_and_cuts_keep_it():
    pattern = draft("leggings", stretch=12)
    assert read_specification(to_specification(pattern)).pattern.cloth_stretch == 0.12
    assert Workbench(pattern).pattern().cloth_stretch == 0.12
    assert "cloth that stretches by 12% or more" in made_for(pattern)
    assert "stretches" not in made_for(draft("jeans"))


@pytest.mark.parametrize("stretch", [-0.1, 3, "much"])
def test_files_that_say_nonsense_are_refused(stretch):
    specification = to_specification(draft("leggings"))
    specification["properties"]["cloth_stretch"] = stretch
    with pytest.raises(PatternError, match=r"properties\.cloth_stretch"):
        read_specification(specification)


def test_stiff_cloth_gives_where_it_has_to():
    denim = get_fabric("denim")
    assert denim.membrane(0.0) == denim.stretch > STRETCHY == denim.membrane(0.05)
    assert get_fabric("rib-knit").membrane(0.05) == get_fabric("rib-knit").stretch


def test_leggings_lie_on_the_legs():
    sewer = GarmentSewer.load()
    off = {}
    for stretch in (0, 8):
        prepared = sewer.prepare(draft("leggings", stretch=stretch))
        assert not is_too_tight(prepared)
        (values,) = sewer.predict([prepared])
        garment = relaxed(sewer.decode(prepared, values), fabric="jersey")
        assert "not_relaxed" not in garment.report
        distance, _ = Body.default().signed_distance(garment.vertices)
        off[stretch] = np.quantile(distance, 0.9)
    assert off[8] < 0.6 * off[0]
    assert off[8] < 0.7  # cm
