"""Garments that were packed are drawn as before."""

from __future__ import annotations

import runpy
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays_of
from safetensors.numpy import load_file

from swifttailor.data.pictures.bank import PictureBank, open_cache
from swifttailor.data.pictures.blocks import draw
from swifttailor.data.pictures.packed_garments import COARSER, _from_planes, _planes, pack, unpack
from swifttailor.data.pictures.scenes import Wardrobe
from swifttailor.errors import InputError

SCRIPT = Path(__file__).parents[2] / "scripts/pack_worn_garments.py"


@pytest.fixture(scope="module")
def banks(data, tmp_path_factory):
    """What is drawn of a split, and of the same packed and unpacked; and how large the package is."""
    folder = tmp_path_factory.mktemp("packed")
    before = sys.argv
    for arguments in (
        [str(data / "train"), "--out", str(folder / "packed")],
        ["--unpack", str(folder / "packed"), "--out", str(folder / "there")],
    ):
        sys.argv = [str(SCRIPT), *arguments, "--workers", "1"]
        runpy.run_path(str(SCRIPT), run_name="__main__")
    sys.argv = before
    size = sum(path.stat().st_size for path in folder.glob("packed/1/*.xz"))
    return PictureBank([data / "train"]), PictureBank([folder / "there/1"]), size


def areas(corners):
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return 0.5 * np.linalg.norm(across, axis=1)


def lengths(garment, pairs):
    return np.linalg.norm(garment.vertices[pairs[:, 0]] - garment.vertices[pairs[:, 1]], axis=1)


def test_each_garment_has_the_same_surface_seams_and_truth(banks):
    before, after, size = banks
    assert len(after) == len(before) == 6 and after.digests() == before.digests()
    assert size < 15_000 * len(before), "a tenth of what the bank keeps"
    for k in range(len(before)):
        old, new = before[k], after[k]
        assert new.faces.shape == old.faces.shape and new.vertices.shape == old.vertices.shape
        half = 0.005 * COARSER  # cm by which rounding moves a vertex along each axis
        # Triangles are in another order.
        middles = [np.sort(g.vertices[g.faces].mean(axis=1), axis=0) for g in (old, new)]
        assert np.abs(middles[0] - middles[1]).max() < 2 * half
        for panel in np.unique(old.face_panel):
            own = [areas(g.vertices[g.faces[g.face_panel == panel]]).sum() for g in (old, new)]
            assert own[1] == pytest.approx(own[0], rel=5e-3)
            flat = [
                areas(np.pad(g.cloth_at[g.face_panel == panel], ((0, 0), (0, 0), (0, 1)))) for g in (old, new)
            ]
            assert flat[1].sum() == pytest.approx(flat[0].sum(), rel=5e-3)
        for pairs in ("seams", "borders"):
            one, other = (np.sort(lengths(g, getattr(g, pairs))) for g in (old, new))
            assert len(one) == len(other) and np.abs(one - other).max() < 4 * half
        for name in ("statements", "measures", "panels", "boxes"):
            np.testing.assert_array_equal(getattr(new.truth, name), getattr(old.truth, name))
        assert new.weights.share.sum() == pytest.approx(old.weights.share.sum(), rel=1e-3)


@pytest.mark.parametrize(("family", "view"), [("plain", "front"), ("people", "free")])
def test_pictures_are_nearly_the_same(banks, family, view):
    drawn = []
    for bank in banks[:2]:
        chance = np.random.default_rng(5)
        drawn.append(draw(Wardrobe(bank), 1, family, view, chance, 96))
    off = np.abs(drawn[0].pixels.astype(int) - drawn[1].pixels)
    assert np.mean(off.max(axis=2) > 40) < 0.02
    assert np.mean(drawn[0].cells != drawn[1].cells) < 0.03
    assert np.abs(drawn[0].masks.astype(int) - drawn[1].masks).mean() < 2


def test_packed_again_nothing_changes(banks):
    cache = open_cache(banks[1]._caches[0].reader.folder)
    once = load_file(cache.path(0))
    again = unpack(pack(once))
    assert once.keys() == again.keys()
    for name, values in once.items():
        if name != "share":  # of half a unit more or less
            np.testing.assert_array_equal(again[name], values, err_msg=name)


@given(arrays_of.arrays(np.int64, st.integers(0, 50), elements=st.integers(-(2**15), 2**15 - 1)))
def test_numbers_come_back(values):
    np.testing.assert_array_equal(_from_planes(_planes(values)), values)


def test_what_is_too_far_apart_and_what_is_damaged_is_refused():
    with pytest.raises(InputError, match="difference of 40000"):
        _planes(np.array([1, 40_000]))
    for damaged in (b"", b"nothing", pack_of_nothing()[:-4]):
        with pytest.raises(InputError, match=r"no packed garments.*scripts/pack_worn_garments.py"):
            unpack(damaged)


def pack_of_nothing() -> bytes:
    import lzma

    return lzma.compress(b"\x02\0\0\0\0\0\0\0{}")
