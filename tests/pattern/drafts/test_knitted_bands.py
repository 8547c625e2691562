"""Cardigans with ribbed bands, jumpers with wide sleeves and with wide collars."""

import numpy as np
import pytest

import swifttailor
from swifttailor.errors import PatternError


def names(pattern: swifttailor.Pattern) -> set[str]:
    return {panel.name for panel in pattern.panels}


@pytest.mark.parametrize("options", [{}, {"length": 6.0}, {"neckline": "round", "neck_depth": 10.0}])
def test_a_closed_cardigan_ends_in_ribs(options):
    ribbed = swifttailor.draft("cardigan", opening=0.0, ribbed=True, **options)
    plain = swifttailor.draft("cardigan", opening=0.0, **options)
    assert names(ribbed) - names(plain) == {
        *("wb_front", "wb_back"),
        *[f"sl_{side}_cuff_{face}" for side in ("left", "right") for face in "fb"],
    }


@pytest.mark.parametrize("options", [{"opening": 6.0}, {"opening": -8.0}])
def test_fronts_that_open_have_no_band_across(options):
    assert "wb_front" not in names(swifttailor.draft("cardigan", ribbed=True, **options))


@pytest.mark.parametrize("options", [{"sleeve_shape": "bell"}, {"armhole": "cut-in-one"}])
def test_only_plain_sleeves_of_cardigans_end_in_ribs(options):
    ribbed = swifttailor.draft("cardigan", opening=0.0, ribbed=True, **options)
    assert not any("cuff" in name for name in names(ribbed))


@pytest.mark.parametrize("shape", ["bell", "wide"])
def test_sleeves_of_jumpers_that_end_wide_have_no_cuffs(shape):
    wide, plain = (swifttailor.draft("sweatshirt", sleeve_shape=each) for each in (shape, "plain"))
    assert not any("cuff" in name for name in names(wide))
    ends = [np.ptp(one.panel("left_sleeve_f").vertices[:, 1]) for one in (wide, plain)]
    assert ends[0] > ends[1] + 2.0


def test_a_loose_collar_is_wider_and_hangs_lower_than_a_rolled_one():
    loose, rolled = (
        swifttailor.draft("sweatshirt", collar=each, collar_height=12.0) for each in ("loose", "rolled")
    )
    for face in ("front", "back"):
        name = f"left_collar_fall_{face}"
        widths = [np.ptp(one.panel(name).vertices[:, 0]) for one in (loose, rolled)]
        falls = [np.ptp(one.panel(name).vertices[:, 1]) for one in (loose, rolled)]
        assert widths[0] > widths[1] + 3.0
        assert falls[0] >= falls[1]


def test_hoodies_have_no_bell_sleeves():
    with pytest.raises(PatternError):
        swifttailor.draft("hoodie", sleeve_shape="bell")
