import io
import json
import zipfile
from dataclasses import replace

import numpy as np
import pytest
from ggi_patterns import HARD_CASES, any_garment, dart_pattern
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from swifttailor.errors import InputError
from swifttailor.ggi import encode
from swifttailor.ggi.file import STEPS, dequantize, quantize, read_ggi, write_ggi
from swifttailor.pattern.drafts import draft


@pytest.fixture(scope="module")
def images():
    return encode(any_garment(draft("t-shirt"), 4.0), 128)


@pytest.fixture
def file(images, tmp_path):
    return write_ggi(images, tmp_path / "ggi.npz")


def assert_same(one, two, error=0.0):
    assert (one.layout is None) == (two.layout is None)
    if one.layout is not None:
        assert one.layout.pattern == two.layout.pattern and one.layout.pattern.name == two.layout.pattern.name
        assert one.layout.cm_per_pixel == two.layout.cm_per_pixel
        assert np.array_equal(one.layout.origins, two.layout.origins)
        assert np.array_equal(one.layout.mirrored, two.layout.mirrored)
    for name in ("occupancy", "panel", "semantic"):
        assert np.array_equal(getattr(one, name), getattr(two, name)), name
        assert getattr(one, name).dtype == getattr(two, name).dtype
    for name in ("ids", "pixels", "fraction", "start"):
        assert np.array_equal(getattr(one.stitching, name), getattr(two.stitching, name)), name
        assert getattr(one.stitching, name).dtype == getattr(two.stitching, name).dtype
    assert (one.geometry is None) == (two.geometry is None)
    if one.geometry is not None:
        assert one.geometry.dtype == two.geometry.dtype == np.float32
        assert np.abs(one.geometry - two.geometry)[one.occupancy].max() <= error
        assert not two.geometry[~two.occupancy].any()


def test_what_was_written_is_read_within_the_stated_error(images, file):
    stated = json.loads(bytes(np.load(file)["about"]))["max_error_cm"]
    spread = np.ptp(images.geometry[images.occupancy], axis=0).max()
    assert stated == pytest.approx(spread / STEPS / 2, rel=1e-6) and stated < 0.005
    assert_same(images, read_ggi(file), stated * 1.001 + 1e-5)


@pytest.mark.parametrize("case", HARD_CASES)
def test_a_pattern_alone_is_written_too(case, tmp_path):
    images = encode(HARD_CASES[case](), 64)
    read = read_ggi(write_ggi(images, tmp_path / "ggi.npz"))
    assert read.geometry is None
    assert_same(images, read)


def test_images_without_a_layout_are_written_too(images, tmp_path):
    bare = replace(images, layout=None)
    assert_same(bare, read_ggi(write_ggi(bare, tmp_path / "ggi.npz")), 0.01)


def test_the_rotation_of_placements_is_kept(tmp_path):
    pattern = draft("t-shirt").with_rotation_reading("extrinsic")
    read = read_ggi(write_ggi(encode(pattern, 64), tmp_path / "ggi.npz"))
    assert read.layout.pattern == pattern.canonical()


def test_placements_read_in_two_ways_are_refused(tmp_path):
    one, other = draft("t-shirt"), draft("t-shirt").with_rotation_reading("extrinsic")
    mixed = replace(one, panels=(*one.panels[:1], *other.panels[1:]))
    with pytest.raises(InputError, match="read in 2 ways"):
        write_ggi(encode(mixed, 64), tmp_path / "ggi.npz")


def test_any_numpy_reads_it_without_pickle(images, file):
    with np.load(file, allow_pickle=False) as stored:
        assert stored["geometry"].dtype == np.uint16 and stored["geometry"].shape == (128, 128, 3)
        low, step = stored["geometry_low_step"]
        positions = low + step * stored["geometry"]
        occupied = stored["occupancy"]
        assert np.abs(positions - images.geometry)[occupied].max() < 0.01
        assert np.array_equal(stored["panel"] >= 0, occupied)


def test_equal_images_give_equal_bytes_at_any_time(images, tmp_path, monkeypatch):
    first = write_ggi(images, tmp_path / "a.npz").read_bytes()
    monkeypatch.setattr("time.time", lambda: 2_000_000_000.0)
    assert write_ggi(images, tmp_path / "b.npz").read_bytes() == first
    with zipfile.ZipFile(tmp_path / "a.npz") as archive:
        assert {m.date_time for m in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}


@settings(max_examples=60, deadline=None)
@given(
    arrays(np.float32, (5, 5, 3), elements=st.floats(-1e4, 1e4, width=32)),
    arrays(np.bool_, (5, 5)),
)
def test_sixteen_bits_err_by_half_a_step_at_most(positions, occupancy):
    steps, low_step = quantize(positions, occupancy)
    read = dequantize(steps, low_step, occupancy)
    assert not steps[~occupancy].any() and not read[~occupancy].any()
    off = np.abs(read.astype(float) - positions)[occupancy]
    allowed = low_step[1] / 2 + np.abs(positions).max() * 2.0**-23
    assert (off <= allowed).all()


def test_positions_that_are_not_finite_are_not_stored(images, tmp_path):
    geometry = images.geometry.copy()
    row, column = np.argwhere(images.occupancy)[0]
    geometry[row, column, 1] = np.nan
    with pytest.raises(InputError, match="not finite"):
        write_ggi(replace(images, geometry=geometry), tmp_path / "ggi.npz")
    assert not (tmp_path / "ggi.npz").exists()


def changed(file, **changes):
    """The file with some arrays replaced (None: left out), or given as bytes of a member."""
    with np.load(file) as stored:
        arrays_ = {name: stored[name] for name in stored} | changes
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, value in arrays_.items():
            if isinstance(value, bytes):
                archive.writestr(f"{name}.npy", value)
            elif value is not None:
                content = io.BytesIO()
                np.lib.format.write_array(content, np.asanyarray(value))
                archive.writestr(f"{name}.npy", content.getvalue())
    return file


def about(file, **changes):
    value = json.loads(bytes(np.load(file)["about"])) | changes
    return np.frombuffer(json.dumps(value).encode(), np.uint8)


def header(shape, descr):
    """A member that announces an array and holds nothing of it."""
    content = io.BytesIO()
    np.lib.format.write_array_header_1_0(content, {"descr": descr, "fortran_order": False, "shape": shape})
    return content.getvalue()


def with_value(array, index, value):
    array = array.copy()
    array[index] = value
    return array


BROKEN = {
    "no about": (lambda f, a: {"about": None}, "'about' is missing"),
    "no layout half": (lambda f, a: {"origins": None}, "'origins' is missing"),
    "no geometry scale": (lambda f, a: {"geometry_low_step": None}, "'geometry_low_step' is missing"),
    "about no json": (lambda f, a: {"about": np.frombuffer(b"{", np.uint8)}, "is not JSON"),
    "about nested": (lambda f, a: {"about": np.frombuffer(b"[" * 99_999, np.uint8)}, "nested too deeply"),
    "other format": (lambda f, a: {"about": about(f, format="x")}, "of another format"),
    "other version": (lambda f, a: {"about": about(f, version=2)}, "version 2 and this program reads"),
    "resolution text": (lambda f, a: {"about": about(f, resolution="128")}, "resolution is '128'"),
    "resolution true": (lambda f, a: {"about": about(f, resolution=True)}, "resolution is True"),
    "resolution vast": (lambda f, a: {"about": about(f, resolution=10**9)}, "resolution is 1000000000"),
    "resolution other": (lambda f, a: {"about": about(f, resolution=64)}, "128x128 bool; 64x64"),
    "scale text": (lambda f, a: {"about": about(f, cm_per_pixel="1")}, "scale is '1'"),
    "scale zero": (lambda f, a: {"about": about(f, cm_per_pixel=0.0)}, "scale is 0.0"),
    "scale other": (lambda f, a: {"about": about(f, cm_per_pixel=9.0)}, "do not belong to its layout"),
    "scale tiny": (lambda f, a: {"about": about(f, cm_per_pixel=1e-300)}, "scale is 1e-300"),
    "no pattern": (lambda f, a: {"about": about(f, pattern=None)}, "an object was expected"),
    "rotation": (lambda f, a: {"about": about(f, rotation="up")}, "rotation must be"),
    "origins nan": (lambda f, a: {"origins": a["origins"] * np.nan}, "finite"),
    "origins moved": (lambda f, a: {"origins": a["origins"] + 1}, "do not belong to its layout"),
    "origins gone": (lambda f, a: {"origins": a["origins"] + 1e6}, "layout leaves the image"),
    "origins few": (lambda f, a: {"origins": a["origins"][:-1]}, "origins of shape"),
    "mirrored": (lambda f, a: {"mirrored": ~a["mirrored"]}, "layout"),
    "panel type": (lambda f, a: {"panel": a["panel"].astype(np.int32)}, "'panel' is 128x128 int32"),
    "panel order": (lambda f, a: {"panel": np.asfortranarray(a["panel"])}, "'panel' is"),
    "panel beyond": (lambda f, a: {"panel": a["panel"] + 90}, "panels it does not have"),
    "panel shifted": (lambda f, a: {"panel": np.roll(a["panel"], 1)}, "panels and its occupancy differ"),
    "semantic beyond": (
        lambda f, a: {"semantic": (a["semantic"] > 0) * np.uint8(200)}, "types that do not exist"),
    "semantic empty": (lambda f, a: {"semantic": a["semantic"] * 0}, "types and its occupancy differ"),
    "stitch beyond": (lambda f, a: {"stitch": a["stitch"] + np.uint16(500)}, "stitches it does not have"),
    "seam outside": (lambda f, a: {"seam_pixels": a["seam_pixels"] + 10**6}, "seams leave the image"),
    "seam negative": (lambda f, a: {"seam_pixels": -1 - a["seam_pixels"]}, "seams leave the image"),
    "seam empty": (lambda f, a: {"seam_pixels": a["seam_pixels"] * 0}, "empty pixels"),
    "seam nan": (lambda f, a: {"seam_fraction": a["seam_fraction"] * np.nan}, "outside themselves"),
    "seam short": (lambda f, a: {"seam_fraction": a["seam_fraction"][1:]}, "no order"),
    "seam start": (lambda f, a: {"seam_start": with_value(a["seam_start"], 1, 10**6)}, "no order"),
    "seam start even": (lambda f, a: {"seam_start": a["seam_start"][:-1]}, "no order"),
    "seam start none": (lambda f, a: {"seam_start": a["seam_start"][:0]}, "no order"),
    "step negative": (lambda f, a: {"geometry_low_step": -a["geometry_low_step"] - 1}, "no scale"),
    "step nan": (lambda f, a: {"geometry_low_step": a["geometry_low_step"] * np.nan}, "no scale"),
    "objects": (lambda f, a: {"panel": header((128, 128), "|O") + b"cos\nsystem\n"}, "128x128 object"),
    "vast": (lambda f, a: {"panel": header((10**6, 10**6), "<i2")}, "'panel' is 1000000x1000000"),
    "vast seam": (lambda f, a: {"seam_pixels": header((10**12,), "<i4")}, "'seam_pixels' is 10000"),
    "vast about": (lambda f, a: {"about": header((10**12,), "|u1")}, "'about' is 10000"),
    "negative shape": (lambda f, a: {"seam_pixels": header((-1,), "<i4")}, "'seam_pixels' is -1"),
    "cut short": (lambda f, a: {"panel": header((128, 128), "<i2")}, "cut short"),
    "no array": (lambda f, a: {"panel": b"hello"}, "magic"),
    "header code": (lambda f, a: {"panel": b"\x93NUMPY\x01\x00\x10\x00__import__('os')"}, "ead"),
    "new numpy": (lambda f, a: {"panel": b"\x93NUMPY\x09\x00\x10\x00"}, "unknown numpy version"),
}  # fmt: skip


@pytest.mark.parametrize("name", BROKEN)
def test_broken_files_are_refused_with_a_reason(name, file):
    change, says = BROKEN[name]
    with np.load(file) as stored:
        arrays_ = {key: stored[key] for key in stored}
    changed(file, **change(file, arrays_))
    with pytest.raises(InputError, match=says) as refused:
        read_ggi(file)
    assert str(file) in str(refused.value)


@pytest.mark.parametrize("content", [b"", b"PK", b"PK\3\4" + bytes(100), b"\x89PNG" * 50, bytes(5000)])
def test_files_that_are_none_are_refused(content, tmp_path):
    (tmp_path / "ggi.npz").write_bytes(content)
    with pytest.raises(InputError, match=r"Cannot read .*ggi\.npz"):
        read_ggi(tmp_path / "ggi.npz")


def test_missing_files_and_folders_are_refused(tmp_path):
    for path in (tmp_path / "none.npz", tmp_path, tmp_path / "a\0b"):
        with pytest.raises(InputError, match="Cannot read"):
            read_ggi(path)


@settings(max_examples=150, deadline=None)
@given(data=st.data())
def test_damaged_bytes_never_do_worse_than_an_input_error(data, tmp_path_factory):
    path = tmp_path_factory.mktemp("damaged") / "ggi.npz"
    content = bytearray(write_ggi(encode(dart_pattern(), 32), path).read_bytes())
    for _ in range(data.draw(st.integers(1, 5))):
        content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    path.write_bytes(bytes(content[: data.draw(st.integers(1, len(content)))]))
    try:
        read_ggi(path)
    except InputError:
        pass


def test_a_file_in_a_file_of_another_compression_is_no_crash(file):
    with np.load(file) as stored:
        arrays_ = {key: stored[key] for key in stored}
    with zipfile.ZipFile(file, "w", zipfile.ZIP_LZMA) as archive:
        for name, value in arrays_.items():
            content = io.BytesIO()
            np.lib.format.write_array(content, value)
            archive.writestr(f"{name}.npy", content.getvalue())
    assert read_ggi(file).resolution == 128
