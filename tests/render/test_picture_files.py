"""Files of pictures, as they come from cameras, scanners, the web and people who mean harm."""

from __future__ import annotations

import io
import os
import struct
import subprocess
import sys
import zlib
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

from swifttailor.errors import InputError
from swifttailor.render.picture_file import LONGEST_SIDE, MOST_PIXELS, read_picture

GREEN, RED = (30, 160, 60), (200, 30, 20)


def quarters() -> Image.Image:
    """40 x 20 pixels, red with a green quarter at the upper left."""
    picture = Image.new("RGB", (40, 20), RED)
    picture.paste(GREEN, (0, 0, 20, 10))
    return picture


def near(color, wanted, tolerance=12) -> bool:
    return bool(np.abs(np.asarray(color, float) - wanted).max() <= tolerance)


@pytest.mark.parametrize(
    ("mode", "name", "options"),
    [
        ("RGB", "p.png", {}),
        ("RGBA", "p.png", {}),
        ("P", "p.png", {}),
        ("P", "p.gif", {}),
        ("CMYK", "p.jpg", {"quality": 95}),
        ("CMYK", "p.tiff", {}),
        ("YCbCr", "p.tiff", {}),
        ("RGB", "p.jpg", {"quality": 95, "progressive": True}),
        ("RGB", "p.webp", {"lossless": True}),
        ("RGB", "p.bmp", {}),
    ],
)
def test_colours_of_any_mode(mode, name, options, tmp_path):
    picture = quarters()
    if mode == "P":
        picture = picture.quantize(8)
    picture.convert(mode).save(tmp_path / name, **options)
    read = read_picture(tmp_path / name)
    assert read.shape == (20, 40, 3) and read.dtype == np.uint8
    assert near(read[3, 5], GREEN, 16) and near(read[15, 30], RED, 16)


@pytest.mark.parametrize(
    ("values", "name"),
    [
        (np.linspace(0, 65535, 64 * 4).reshape(4, 64).astype(np.uint16), "p.png"),
        (np.linspace(0, 65535, 64 * 4).reshape(4, 64).astype(np.uint16), "p.tiff"),
        (np.linspace(0, 255, 64 * 4).reshape(4, 64).astype(np.uint8), "p.png"),
        (np.linspace(0, 65535, 64 * 4).reshape(4, 64).astype(np.int32), "p.tiff"),
        (np.linspace(0, 255, 64 * 4).reshape(4, 64).astype(np.int32), "p.tiff"),
        (np.linspace(0, 1, 64 * 4).reshape(4, 64).astype(np.float32), "p.tiff"),
        (np.linspace(0, 255, 64 * 4).reshape(4, 64).astype(np.float32), "p.tiff"),
    ],
    ids=lambda v: getattr(v, "dtype", v),
)
def test_greys_of_any_depth(values, name, tmp_path):
    Image.fromarray(values).save(tmp_path / name)
    read = read_picture(tmp_path / name)
    expected = np.linspace(0, 255, 64 * 4).reshape(4, 64)
    assert np.abs(read - expected[..., None]).max() <= 1


def test_numbers_that_are_none_do_no_harm(tmp_path):
    values = np.full((4, 4), 0.5, np.float32)
    values[0] = np.nan, np.inf, -np.inf, -3.0
    Image.fromarray(values).save(tmp_path / "p.tiff")
    assert read_picture(tmp_path / "p.tiff").shape == (4, 4, 3)


@pytest.mark.parametrize("orientation", range(1, 9))
@pytest.mark.parametrize("name", ["p.jpg", "p.png", "p.webp", "p.tiff"])
def test_what_a_camera_held_sideways_stands_upright(orientation, name, tmp_path):
    undo = {
        2: Image.Transpose.FLIP_LEFT_RIGHT,
        3: Image.Transpose.ROTATE_180,
        4: Image.Transpose.FLIP_TOP_BOTTOM,
        5: Image.Transpose.TRANSPOSE,
        6: Image.Transpose.ROTATE_90,
        7: Image.Transpose.TRANSVERSE,
        8: Image.Transpose.ROTATE_270,
    }
    stored = quarters()
    if orientation in undo:
        stored = stored.transpose(undo[orientation])
    exif = Image.Exif()
    exif[0x0112] = orientation
    stored.save(tmp_path / name, exif=exif.tobytes())
    read = read_picture(tmp_path / name)
    assert read.shape == (20, 40, 3)
    assert near(read[3, 5], GREEN, 30) and near(read[15, 5], RED, 30) and near(read[3, 35], RED, 30)


def test_damaged_exif_data_do_not_hide_the_picture(tmp_path):
    quarters().save(tmp_path / "p.jpg", exif=b"Exif\0\0MM\0*" + b"\xff" * 40)
    assert read_picture(tmp_path / "p.jpg").shape == (20, 40, 3)


@pytest.mark.parametrize("name", ["p.gif", "p.webp", "p.png", "p.tiff"])
def test_the_first_frame_of_several(name, tmp_path):
    frames = [Image.new("RGB", (40, 20), c) for c in ((0, 0, 250), GREEN, RED)]
    quarters().save(tmp_path / name, save_all=True, append_images=frames, duration=50)
    read = read_picture(tmp_path / name)
    assert near(read[3, 5], GREEN, 30) and near(read[15, 30], RED, 30)


@pytest.mark.parametrize(
    ("cloth", "behind"), [((20, 40, 90), 255), ((250, 250, 250), 216), ((214, 216, 218), 255)]
)
def test_what_is_transparent_sets_off_the_cloth(cloth, behind, tmp_path):
    picture = np.zeros((40, 40, 4), np.uint8)
    picture[..., :3] = 77  # hidden colours do not show
    picture[10:30, 10:30] = (*cloth, 255)
    Image.fromarray(picture).save(tmp_path / "p.png")
    read = read_picture(tmp_path / "p.png")
    assert (read[0, 0] == behind).all() and (read[20, 20] == cloth).all()


def test_cloth_of_many_colours_gets_the_backdrop_it_is_least_like(tmp_path):
    picture = np.full((40, 40, 4), 255, np.uint8)
    picture[:, :10, 3] = 0
    picture[:20, :, :3], picture[20:30, :, :3], picture[30:, :, :3] = 216, 250, 138
    picture[38:, 20:, :3] = 0
    Image.fromarray(picture).save(tmp_path / "p.png")
    assert read_picture(tmp_path / "p.png")[0, 0, 0] in (255, 138)  # a quarter each; most is 216


def test_large_pictures_become_smaller_and_keep_their_shape(tmp_path):
    Image.new("RGB", (4000, 1000), RED).save(tmp_path / "p.jpg")
    read = read_picture(tmp_path / "p.jpg")
    assert read.shape == (LONGEST_SIDE // 4, LONGEST_SIDE, 3)
    assert near(read[100, 500], RED)


def png(width: int, height: int, data: bytes = b"", depth: int = 1) -> bytes:
    """A PNG file with a given header, whatever its data."""

    def chunk(kind: bytes, content: bytes) -> bytes:
        return (
            struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
        )

    header = struct.pack(">IIBBBBB", width, height, depth, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


@pytest.mark.parametrize("size", [(50_000, 50_000), (8000, MOST_PIXELS // 8000 + 1), (2**31 - 1, 1)])
def test_bombs_are_refused_by_their_header(size, tmp_path):
    (tmp_path / "bomb.png").write_bytes(png(*size))
    with pytest.raises(InputError, match=r"too large.*50,000,000 pixels"):
        read_picture(tmp_path / "bomb.png")


@pytest.mark.skipif(sys.platform != "linux", reason="limits memory as Linux does")
def test_reading_stays_within_its_memory(tmp_path):
    """The largest picture that is accepted, of zeros so that its file is small, and a bomb."""
    side = int(MOST_PIXELS**0.5)
    Image.new("L", (side, side)).save(tmp_path / "largest.png", compress_level=1)
    (tmp_path / "bomb.png").write_bytes(png(60_000, 60_000, zlib.compress(bytes(10**7))))
    program = """
import resource, sys
import numpy as np
from PIL import Image, ImageOps
from swifttailor.errors import InputError
from swifttailor.render.picture_file import read_picture
base = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (base + 10**9, base + 10**9))
print(read_picture(sys.argv[1]).shape)
try:
    read_picture(sys.argv[2])
except InputError as error:
    print("refused")
"""
    done = subprocess.run(
        [sys.executable, "-c", program, str(tmp_path / "largest.png"), str(tmp_path / "bomb.png")],
        capture_output=True,
        text=True,
    )
    assert done.stdout.split("\n")[:2] == ["(1024, 1024, 3)", "refused"], done.stderr[-800:]


@pytest.mark.parametrize(
    "data",
    [b"", b"a long dress\n" * 1000, b"\xff\xd8\xff\xe0" + bytes(100), b"GIF89a" + b"\xff" * 30, b"<svg/>"],
)
def test_what_is_called_png_and_is_none_is_refused(data, tmp_path):
    (tmp_path / "p.png").write_bytes(data)
    with pytest.raises(InputError, match=r"is not a readable picture"):
        read_picture(tmp_path / "p.png")


def test_what_is_no_file_is_refused(tmp_path):
    with pytest.raises(InputError, match="There is no picture"):
        read_picture(tmp_path / "none.png")
    with pytest.raises(InputError, match="not a file"):
        read_picture(tmp_path)
    with pytest.raises(InputError, match="Cannot read the picture"):
        read_picture("a\0b.png")
    if hasattr(os, "mkfifo"):
        os.mkfifo(tmp_path / "pipe.png")
        with pytest.raises(InputError, match="not a file"):
            read_picture(tmp_path / "pipe.png")


def _encoded(name: str) -> bytes:
    buffer = io.BytesIO()
    quarters().save(buffer, name)
    return buffer.getvalue()


@given(kind=st.sampled_from(["PNG", "JPEG", "GIF", "WEBP", "TIFF", "BMP"]), data=st.data())
@settings(max_examples=150, deadline=None)
def test_damage_anywhere_is_read_or_refused_never_worse(kind, data, tmp_path_factory):
    whole = _encoded(kind)
    place = data.draw(st.integers(0, len(whole) - 1))
    cut = data.draw(st.booleans())
    damaged = (
        whole[:place] if cut else whole[:place] + bytes([data.draw(st.integers(0, 255))]) + whole[place + 1 :]
    )
    path: Path = tmp_path_factory.getbasetemp() / "damaged.png"
    path.write_bytes(damaged)
    try:
        read = read_picture(path)
    except InputError as error:
        assert "damaged.png" in str(error)
    else:
        assert read.ndim == 3 and read.shape[2] == 3 and max(read.shape) <= LONGEST_SIDE
