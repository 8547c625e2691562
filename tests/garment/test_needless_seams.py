from dataclasses import replace

import pytest

import swifttailor
from swifttailor.garment.needless_seams import darts_in_yokes, seams_of_knits


@pytest.mark.parametrize(
    ("name", "options", "trims", "middles"),
    [
        ("swimsuit", {}, (), 5),
        ("bodysuit", {"neckline": "square"}, (), 4),
        ("bodysuit", {"neckline": "square"}, ("back zip",), 0),  # the zip is in that seam
        ("bodysuit", {"stretch": 0.0}, (), 0),
        ("blazer", {}, (), 0),
        ("leggings", {}, (), 0),  # legs are not cut on the fold
    ],
)
def test_stretch_has_no_seam_down_the_middle(name, options, trims, middles):
    pattern = replace(swifttailor.draft(name, **options), trims=trims)
    assert len(seams_of_knits(pattern)) == middles


@pytest.mark.parametrize(
    ("name", "trims", "darts"),
    [
        ("trousers", ("topstitching",), 4),
        ("dungarees", ("topstitching",), 4),
        ("trousers", ("fly",), 0),
        ("pull-on-trousers", ("topstitching",), 0),
        ("denim-jacket", ("topstitching",), 0),
    ],
)
def test_the_yoke_of_jeans_takes_in_what_darts_do(name, trims, darts):
    assert len(darts_in_yokes(replace(swifttailor.draft(name), trims=trims))) == darts
