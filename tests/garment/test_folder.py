from __future__ import annotations

import json

import numpy as np
import pytest
from PIL import Image
from sewn_tube import tube_garment

from swifttailor.errors import InputError
from swifttailor.garment.folder import plain
from swifttailor.garment.garment import Garment
from swifttailor.pattern import load_pattern

NAMES = {"pattern.json", "pattern.svg", "garment.glb", "garment.obj", "report.json", "preview.png"}


def test_folder_holds_what_is_promised_and_leaves_other_files_alone(tube, tmp_path):
    folder = tmp_path / "deep" / "out"
    folder.mkdir(parents=True)
    (folder / "notes.txt").write_text("mine")
    assert tube.save(folder) == folder
    assert tube.save(folder) == folder, "over what is there of it"
    assert {p.name for p in folder.iterdir()} == NAMES | {"notes.txt", ".swifttailor"}
    assert (folder / "notes.txt").read_text() == "mine"
    assert load_pattern(folder / "pattern.json") == tube.pattern
    assert json.loads((folder / "report.json").read_text()) == tube.report
    with Image.open(folder / "preview.png") as picture:
        assert picture.size == (1500, 900) and picture.mode == "RGB"


def test_same_garment_same_bytes(tmp_path):
    tube_garment().save(tmp_path / "a")
    tube_garment().save(tmp_path / "b")
    for name in NAMES:
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes(), name


def test_preview_can_be_left_out(tube, tmp_path):
    tube.save(tmp_path / "out", preview=False)
    assert {p.name for p in (tmp_path / "out").iterdir()} == NAMES - {"preview.png"} | {".swifttailor"}


def test_a_file_in_the_way_is_an_input_error(tube, tmp_path):
    (tmp_path / "out").write_text("a file")
    with pytest.raises(InputError, match="Cannot write"):
        tube.save(tmp_path / "out", preview=False)


def test_reports_become_plain_json(tube, tmp_path):
    report = {
        "array": np.arange(3),
        "number": np.float32(0.5),
        "lost": float("nan"),
        1: (np.int64(2), {"b", "a"}, None, True),
        "path": tmp_path,
    }
    assert plain(report) == {
        "array": [0, 1, 2],
        "number": 0.5,
        "lost": None,
        "1": [2, ["a", "b"], None, True],
        "path": str(tmp_path),
    }
    Garment(tube.mesh, tube.vertices, report).save(tmp_path / "out", preview=False)
    assert json.loads((tmp_path / "out" / "report.json").read_text())["lost"] is None
