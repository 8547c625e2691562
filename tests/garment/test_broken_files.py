"""Whatever a file holds: a mesh or an InputError, soon."""

from __future__ import annotations

import json
import struct
import time

import numpy as np
import pytest

from swifttailor.errors import InputError
from swifttailor.garment.formats import MESH_ENDINGS, read_garment_mesh, write_garment_mesh
from swifttailor.garment.triangle_mesh import TriangleMesh

SECONDS = 3.0


def read_or_refuse(path) -> None:
    started = time.process_time()
    try:
        read_garment_mesh(path)
    except InputError as error:
        assert path.name in str(error)
    assert time.process_time() - started < SECONDS


@pytest.mark.parametrize("ending", [".glb", ".obj", ".ply", ".stl", ".usda", ".usdc"])
def test_cut_and_scrambled_files(tube_mesh, tmp_path, ending):
    whole = write_garment_mesh(tube_mesh, tmp_path / f"whole{ending}").read_bytes()
    read_garment_mesh(tmp_path / f"whole{ending}")
    rng = np.random.default_rng(5)
    path = tmp_path / f"broken{ending}"
    for share in (0.0, 0.001, 0.05, 0.5, 0.99):
        path.write_bytes(whole[: int(len(whole) * share)])
        read_or_refuse(path)
    for _ in range(6):
        bad = np.frombuffer(whole, np.uint8).copy()
        at = rng.integers(0, min(len(bad), 3000), 12)
        bad[at] = rng.integers(0, 256, 12)
        path.write_bytes(bad.tobytes())
        read_or_refuse(path)


@pytest.mark.parametrize("ending", MESH_ENDINGS)
def test_noise_text_and_nothing(tmp_path, ending):
    for content in (b"", b"\x89PNG\r\n\x1a\n" * 20, b"hello\nworld\n", b"\0" * 500):
        path = tmp_path / f"bad{ending}"
        path.write_bytes(content)
        with pytest.raises(InputError, match="bad"):
            read_garment_mesh(path)


def test_announced_sizes_are_not_believed(tmp_path):
    ply = tmp_path / "huge.ply"
    ply.write_text("ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n0\n")
    glb = tmp_path / "huge.glb"
    text = json.dumps({"asset": {"version": "2.0"}, "accessors": [{"count": 10**12, "componentType": 5126}]})
    text += " " * (-len(text) % 4)
    glb.write_bytes(
        struct.pack("<4sII", b"glTF", 2, 20 + len(text))
        + struct.pack("<I4s", len(text), b"JSON")
        + text.encode()
    )
    for path in (ply, glb):
        started = time.process_time()
        with pytest.raises(InputError, match="more than the file can hold"):
            read_garment_mesh(path)
        assert time.process_time() - started < SECONDS


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 4"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "line 4"),
        ("v 0 0\n", "line 1"),
        ("v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n", "NaN"),
        ("v 0 0 0\nv 1 0 0\nf 1 2\n", "at least 3"),
        ("v 0 0 0\n", "no faces"),
    ],
)
def test_broken_obj_says_where(tmp_path, text, reason):
    path = tmp_path / "bad.obj"
    path.write_text(text)
    with pytest.raises(InputError, match=reason):
        read_garment_mesh(path)


def test_wrong_ending_folder_and_missing_file(tmp_path):
    with pytest.raises(InputError, match=r"\.glb, \.obj"):
        read_garment_mesh(tmp_path / "a.docx")
    with pytest.raises(InputError, match="Cannot read"):
        read_garment_mesh(tmp_path / "none.glb")
    (tmp_path / "folder.glb").mkdir()
    with pytest.raises(InputError, match="is not a file"):
        read_garment_mesh(tmp_path / "folder.glb")


@pytest.mark.parametrize(
    "arguments",
    [
        {"vertices": np.zeros((3, 2)), "faces": [[0, 1, 2]]},
        {"vertices": np.full((3, 3), np.nan), "faces": [[0, 1, 2]]},
        {"vertices": np.zeros((3, 3)), "faces": [[0, 1, 3]]},
        {"vertices": np.zeros((3, 3)), "faces": [[0, 1]]},
        {"vertices": np.zeros((3, 3)), "faces": [[0.0, 1.0, 2.0]]},
        {"vertices": np.zeros((3, 3)), "faces": [[0, 1, 2]], "uv": np.zeros((3, 2))},
        {"vertices": np.zeros((3, 3)), "faces": [[0, 1, 2]], "groups": ("a",), "face_group": [1]},
        {"vertices": np.zeros((3, 3)), "faces": [[0, 1, 2]], "groups": ("a",), "face_group": [0, 0]},
    ],
)
def test_meshes_are_checked(arguments):
    with pytest.raises(InputError):
        TriangleMesh(**arguments)


@pytest.mark.parametrize("ending", MESH_ENDINGS)
def test_a_mesh_without_faces_can_be_written(tmp_path, ending):
    empty = TriangleMesh(np.zeros((0, 3)), np.zeros((0, 3), int))
    path = write_garment_mesh(empty, tmp_path / f"empty{ending}")
    assert path.stat().st_size > 0
    if ending == ".glb":
        assert b'"buffers"' not in path.read_bytes()  # glTF allows none of no bytes
    read_or_refuse(path)
