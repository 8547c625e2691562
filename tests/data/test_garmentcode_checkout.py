"""Folders written by GarmentCode's own code are read: its names, its meshes, its compaction.

Needs a checkout of GarmentCode, named by $SWIFTTAILOR_GARMENTCODE_CHECKOUT, and a Python with its needs
(libigl, cgal, svgpathtools, cairosvg, matplotlib, trimesh: what the package `pygarment` asks for), named
by $SWIFTTAILOR_GARMENTCODE_PYTHON. The package itself will not do: 2.0.2 lacks `meshgen/render`.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from swifttailor.cli.main import run
from swifttailor.data.garmentcodedata import GarmentCodeData, read_edit_pair, read_sample_folder
from swifttailor.data.reader import SplitReader
from swifttailor.data.released import read_outputs
from swifttailor.data.verify import verify_dataset
from swifttailor.draping.placement import place_vertices
from swifttailor.pattern import load_pattern

WRITER = Path(__file__).with_name("write_garmentcodedata.py")
COUNT, SEED, UP_CM = 3, 3, 7.5
MOST_SECONDS = 280


@pytest.fixture(scope="module")
def download(tmp_path_factory) -> Path:
    checkout = os.environ.get("SWIFTTAILOR_GARMENTCODE_CHECKOUT")
    if not checkout:
        pytest.skip("no checkout of GarmentCode; set SWIFTTAILOR_GARMENTCODE_CHECKOUT to its folder")
    python = os.environ.get("SWIFTTAILOR_GARMENTCODE_PYTHON", sys.executable)
    folder = tmp_path_factory.mktemp("garmentcode")
    done = subprocess.run(
        [python, WRITER, checkout, folder / "gcd", str(COUNT), str(SEED)],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=MOST_SECONDS,
        check=False,
    )
    if "No module named" in done.stderr:
        pytest.skip(f"{python} lacks what GarmentCode needs: {done.stderr.strip().splitlines()[-1]}")
    assert done.returncode == 0, done.stderr[-2000:]
    return folder / "gcd"


def test_samples_failures_design_and_measurements(download):
    data = GarmentCodeData(download)
    everything = list(data.samples(with_failures=True))
    assert len(everything) == COUNT and len(list(data.samples())) == COUNT - 1
    assert [s.failures for s in everything if s.failures] == [("static_equilibrium",)]
    for folder in everything:
        assert folder.body == "default" and folder.measurements()["height"] == pytest.approx(171.99)
        assert {"meta", "shirt", "skirt", "pants"} <= set(folder.design())
        for ending in ("boxmesh.ply", "sim_segmentation.txt", "orig_lens.pickle", "vertex_labels.yaml"):
            assert folder.file(ending).is_file()


def test_meshes_come_over_to_ours(download):
    """The box mesh, moved up: flat panels where they are placed, joined at the mean of both sides."""
    for folder in GarmentCodeData(download).samples(with_failures=True):
        sample = read_sample_folder(folder, edge_length=3.0, rotation="extrinsic")
        on_seam = np.zeros(len(sample.vertices), bool)
        for seam in sample.mesh.seams:
            on_seam[seam.vertices] = True
        touched = on_seam.copy()
        touched[sample.mesh.faces[on_seam[sample.mesh.faces].any(axis=1)].ravel()] = True
        gap = np.linalg.norm(sample.vertices - place_vertices(sample.mesh) - [0, UP_CM, 0], axis=1)
        assert (~touched).sum() > 50 and gap[~touched].max() < 0.05
        assert sample.about["seam_spread_cm"] < 0.2
        assert (
            sample.pattern
            == load_pattern(folder.file("specification.json"), rotation="extrinsic").canonical()
        )


def test_a_whole_folder_becomes_shards(download, tmp_path, capsys):
    arguments = ["data", "import", str(download), "--out", str(tmp_path / "shards"), "--workers", "1"]
    assert run([*arguments, "--edge-length", "4", "--rotation", "extrinsic"]) == 0, capsys.readouterr().err
    assert len(list(SplitReader(tmp_path / "shards" / "train"))) == COUNT - 1
    assert list(verify_dataset(tmp_path / "shards")) == [1] * (COUNT - 1)


def test_edits_of_gcd_mm_beside_it(download, tmp_path):
    first, second = list(GarmentCodeData(download).samples(with_failures=True))[:2]
    edit = tmp_path / first.name
    edit.mkdir()
    texts = {"editing_description_forward": "another garment", "editing_description_reverse": "back"}
    (edit / "editing_caption.json").write_text(json.dumps(texts))
    shutil.copy(second.file("specification.json"), edit / "edited_specification.json")
    pair = read_edit_pair(tmp_path, first)
    assert (
        not pair.unchanged
        and pair.after.canonical() == load_pattern(second.file("specification.json")).canonical()
    )
    shutil.copy(first.file("specification.json"), edit / "edited_specification.json")
    assert read_edit_pair(tmp_path, first).unchanged


def test_it_is_a_folder_of_patterns_too(download):
    outputs = list(read_outputs(download))
    assert len(outputs) == COUNT and {o.layout for o in outputs} == {"garmentcode"}
    assert all(o.error == "" and o.changes == () for o in outputs)
