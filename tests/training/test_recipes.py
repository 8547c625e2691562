"""The recipes of `runs/`: from nothing to the model files, in little."""

from __future__ import annotations

import gzip
import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from warm_python import warm_python

ROOT = Path(__file__).parents[2]
RECIPES = (
    *("wish_reader", "garment_sewer", "pattern_maker", "picture_reader", "pattern_library"),
    *("close_up_reader", "plain_reader", "picture_reader_on_gpu", "parameter_reader"),
    *("laid_reader", "latent_diffusion"),
)
PLAIN = "laid_reader"
"""The recipe whose commands, of training and of export, are started as anybody's are."""


def environment(work: Path, **more: str) -> dict[str, str]:
    own = {"WORK", "PATTERNS", "GARMENTCODE", "START", "MINUTES"}
    inherited = {k: v for k, v in os.environ.items() if k not in own}
    path = os.pathsep.join([str(ROOT / "src"), *filter(None, [os.environ.get("PYTHONPATH")])])
    settings = {"REHEARSE": "1", "CORES": "1", "OMP_NUM_THREADS": "1", "WORK": str(work)}
    return inherited | settings | {"PYTHON": sys.executable, "PYTHONPATH": path} | more


def run(name: str, work: Path, *arguments: str, **more: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [ROOT / "runs" / f"{name}.sh", *arguments],
        env=environment(work, **more),
        capture_output=True,
        text=True,
        check=False,
    )


def photographed_tees(folder: Path) -> Path:
    """Something red before white, ten garments of it."""
    import numpy as np
    from PIL import Image

    folder.mkdir()
    pixels = np.full((90, 60, 3), 255, np.uint8)
    pixels[20:70, 15:45] = (200, 0, 0)
    Image.fromarray(pixels).save(folder / "tee.png")
    tee = {"image": "tee.png", "upper": {"kind": ["top"], "sleeves": ["short"]}}
    lines = [json.dumps(tee | {"group": str(k)}) for k in range(10)]
    (folder / "garments.jsonl").write_text("\n".join(lines) + "\n")
    return folder


@pytest.mark.needs_torch
@pytest.mark.timeout(1800)  # some minutes on two idle cores
def test_every_recipe_goes_from_nothing_to_a_model_file(tmp_path):
    from swifttailor.garment_sewer.sewer import GarmentSewer
    from swifttailor.latent_diffusion.designer import LatentDesigner
    from swifttailor.parameter_reader import ParameterReader
    from swifttailor.pattern.drafts import draft
    from swifttailor.pattern_library.known import PatternLibrary
    from swifttailor.pattern_maker.maker import PatternMaker
    from swifttailor.picture_reader.reader import PictureReader
    from swifttailor.wishes.reader import WishReader

    work = tmp_path / "work"
    photographs = photographed_tees(tmp_path / "photographs")
    with warm_python(tmp_path, environment(work)) as python:
        for name in RECIPES:
            done = run(name, work, **({} if name == PLAIN else {"PYTHON": python}))
            assert done.returncode == 0, f"{name}\n{done.stdout}\n{done.stderr}"
        assert run("shop_reader", work, PYTHON=python).returncode == 2, "it needs photographs"
        done = run("shop_reader", work, PHOTOGRAPHS=str(photographs), PYTHON=python)
        assert done.returncode == 0, done.stderr
    files = {
        "GarmentSewer": work / "garment-sewer/garment_sewer.onnx",
        "PatternMaker": work / "pattern-maker/pattern_maker.zip",
        "WishReader": work / "wish-reader/wish_reader.onnx",
        "PictureReader": work / "picture-reader/picture_reader.onnx",
    }
    for model, path in files.items():
        card = json.loads(path.with_suffix(".json").read_text())
        assert card["model"] == model and card["config"]["seed"] == 0
        assert ("start" in card) == (model == "PictureReader"), "its stages begin with one another"
        assert card["command"].startswith("swifttailor train ") and card["file"]["sha256"]
        assert all(len(card["data"][split]) >= 2 for split in ("train", "validation"))
    checksums = json.loads(files["PatternMaker"].with_suffix(".json").read_text())["data"]["files"]
    assert {"train.jsonl.gz", "validation.jsonl.gz", "test.jsonl.gz"} < checksums.keys()
    sewn = GarmentSewer.load(files["GarmentSewer"]).sew(draft("t-shirt"))
    assert len(sewn.vertices) > 100
    maker = PatternMaker.load(files["PatternMaker"])
    assert maker.model.runtime.plans and maker.model.card["model"] == "PatternMaker"
    WishReader.load(files["WishReader"]).read("a knee-length dress")
    spoken = WishReader.load_spoken(work / "spoken-reader/spoken_reader.onnx")
    assert spoken.card["model"] == "SpokenReader" and spoken.card["data"]["spoken"]["train"] > 5000
    reader = PictureReader.load(files["PictureReader"])
    assert reader.size == 64 and reader.card["config"]["start"].endswith("full/weights.safetensors")
    assert len(PatternLibrary.load(work / "pattern-library/known_patterns.zip")) == 6
    assert PictureReader.load(work / "gpu/picture_reader.onnx").size == 64
    parameters = ParameterReader.load(work / "parameter-reader/parameter_reader.onnx")
    assert parameters.card["data"]["patterns"] == 40 and len(parameters.parameters) > 40
    designer = LatentDesigner.load(work / "latent-diffusion/latent_diffusion.zip")
    assert designer.shape == (64, 6) and 2 <= designer.card["data"]["patterns"] <= 6
    assert designer.card["trained"]["denoiser"]["steps"] == 3
    names = [work / f"plain-reader/plain_{name}.onnx" for name in ("reader", "neck", "details")]
    plain = PictureReader.load(files["PictureReader"], plain=names).plain()
    assert plain.close_ups == () and plain.card["config"]["unlike"] > 0
    assert [{name.split()[-1] for name in one.close_ups} for one in plain.near] == [
        {"neck"},
        {"waist", "sleeve", "skirt", "armhole"},
    ]
    laid = PictureReader.load(files["PictureReader"], laid=work / "laid-reader/laid_reader.onnx").laid()
    assert laid.card["config"]["laid"] > 0 and laid.close_ups == ()

    shop = PictureReader.load(files["PictureReader"], shop=work / "shop-reader/shop_reader.onnx").shop()
    assert shop.card["config"]["cut_out"] > 0 and shop.card["config"]["photograph"] > 0

    again = run("wish_reader", work)
    assert again.returncode == 0
    steps = [line for line in again.stdout.splitlines() if line.startswith("== ")]
    assert len(steps) >= 4 and all("done before" in line for line in steps)


def test_the_data_ask_for_patterns_or_a_checkout_of_the_named_commit(tmp_path):
    missing = run("data", tmp_path / "work", "patterns", REHEARSE="")
    assert missing.returncode == 2 and "Give PATTERNS" in missing.stderr
    checkout = tmp_path / "GarmentCode"
    git = ["git", "-C", str(checkout), "-c", "user.name=x", "-c", "user.email=x"]
    subprocess.run(["git", "init", "-q", checkout], check=True)
    (checkout / "pattern_sampler.py").write_text("")
    subprocess.run([*git, "add", "."], check=True)
    subprocess.run([*git, "commit", "-q", "-m", "another"], check=True)
    other = run("data", tmp_path / "work", "patterns", REHEARSE="", GARMENTCODE=str(checkout))
    assert other.returncode == 2 and "checkout d449629979028123a5c4dc9e732a2ec19b7fce31" in other.stderr
    part = run("data", tmp_path / "work", "hems")
    assert part.returncode == 2 and "'hems' is no part of the data" in part.stderr


def test_ready_made_patterns_are_those_that_were_recorded(garmentcode_folder, tmp_path):
    given = tmp_path / "given"
    given.mkdir()
    names = [line.split()[1] for line in (ROOT / "runs/checksums.txt").read_text().splitlines()]
    for name in names:
        (given / name).symlink_to(garmentcode_folder / name)
    work = tmp_path / "work"
    done = run("data", work, "patterns", PATTERNS=str(given))
    assert done.returncode == 0, done.stderr
    for name in names:
        with gzip.open(work / "patterns" / name, "rt") as lines:
            assert len(lines.readlines()) == (1242 if name == "edits.jsonl.gz" else 6)
    (given / names[0]).unlink()
    (given / names[0]).write_bytes(b"another")
    other = run("data", tmp_path / "other", "patterns", PATTERNS=str(given))
    assert other.returncode != 0 and names[0] in other.stdout + other.stderr


@pytest.fixture(scope="module")
def arranging():
    spec = importlib.util.spec_from_file_location("arrange_patterns", ROOT / "scripts/arrange_patterns.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_split_is_the_recorded_one(arranging, garmentcode_folder):
    given = {
        name: arranging.read(garmentcode_folder / f"{name}.jsonl.gz")
        for name in ("train", "validation", "test", "train-2", "train-3")
    }
    first = sorted((s for n in ("test", "train", "validation") for s in given[n]), key=arranging.place_of)
    assert len(first) == sum(arranging.FILES["first"].values())
    found = arranging.arrange({"first": first, "train-2": given["train-2"], "train-3": given["train-3"]})
    assert {name: [s["id"] for s in samples] for name, samples in found.items()} == {
        name: [s["id"] for s in samples] for name, samples in given.items()
    }
    arranging.check(found, ROOT / "runs/designs.txt")
    other = [found["test"][0] | {"design": {}}, *found["test"][1:]]
    with pytest.raises(SystemExit, match="designs of test are not those recorded"):
        arranging.check({"test": other}, ROOT / "runs/designs.txt")


def test_twins_of_held_out_patterns_are_left_out(arranging):
    def sample(k, x):
        panels = {"front": {"vertices": [[x, 0.0], [1.0, 2.0]]}}
        return {"id": f"gc_{k}", "seed": k, "design": {}, "pattern": {"pattern": {"panels": panels}}}

    first = [sample(k, float(k)) for k in range(8)]
    split = arranging.arrange({"first": first, "train-3": []})
    assert [len(split[name]) for name in ("test", "validation", "train")] == [2, 2, 4]
    twin = split["validation"][0]["seed"] + 1e-9
    kept = split["train"][0]["seed"]
    found = arranging.arrange({"first": first, "train-3": [sample(100, twin), sample(101, float(kept))]})
    assert [s["id"] for s in found["train-3"]] == ["gc_101"], "a twin of what is learnt from may stay"
