"""Photographs of dressed people of which some claims are known."""

from __future__ import annotations

import json
import pickle

import numpy as np
import pytest
from PIL import Image

from swifttailor.data.pictures.bank import PictureBank
from swifttailor.data.pictures.cut_outs import cover_of, on_a_ground, shown_person, white_around
from swifttailor.data.pictures.on_white import on_white
from swifttailor.data.pictures.photograph_lists import SPLITS, listed, split_of
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.data.pictures.scenes import UNTOLD
from swifttailor.errors import InputError
from swifttailor.evaluation.pictures.photographs import PhotographScores
from swifttailor.picture_reader.figures import FIGURES
from swifttailor.picture_reader.labels import statement_labels
from swifttailor.picture_reader.truth import FALSE, TRUE, UNCLEAR

TEE = {"kind": ["top"], "sleeves": ["short", "elbow"], "hood": ["none"]}
SHORTS = {"kind": ["shorts"], "leg_hem": ["thigh"]}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Fifteen garments in three colours: red tees over what nobody tells, blue shorts under bare skin."""
    folder = tmp_path_factory.mktemp("worn")
    rows = []
    for k in range(45):
        pixels = np.full((90, 60, 3), 255, np.uint8)
        tee = k % 2 == 0
        pixels[20:70, 15:45] = (200, k, 0) if tee else (0, k, 200)
        pixels[40:50, 25:35] = 255  # between arm and trunk
        Image.fromarray(pixels).save(folder / f"{k}.png")
        worn = {"upper": TEE} if tee else {"upper": None, "lower": SHORTS}
        rows.append(
            {"image": f"{k}.png", "group": f"garment {k % 15}", "side": "back" if k > 30 else "front"} | worn
        )
    write_list(folder, rows)
    return folder


def write_list(folder, rows):
    (folder / "garments.jsonl").write_text("\n".join(map(json.dumps, rows)) + "\n")


def all_of(folder):
    return [one for split in SPLITS for one in listed(folder, split)]


def test_colours_of_one_garment_stay_together(folder):
    of_split = {
        split: {one.path.stem for one in listed(folder, split)} for split in ("train", "validation", "test")
    }
    for k in range(45):
        assert [split for split, some in of_split.items() if str(k) in some] == [
            split_of(f"garment {k % 15}")
        ]


def test_what_is_not_told_is_not_learnt(folder):
    photographs = Photographs([folder], "train")
    assert len(photographs.kinds) == 2, "equal claims are one kind"
    photographs = pickle.loads(pickle.dumps(photographs))  # as processes that draw have it
    seen, portraits = set(), 0
    for seed in range(60):
        scene = photographs.shown(np.random.default_rng(seed), 32, 100)
        assert FIGURES[scene.figures] == "one" and not scene.placed
        number = int(scene.garments.max()) - 100
        kind = photographs.kinds[number % 2]
        if number >= 2:
            assert kind.part == "upper" and scene.garments[1] == -1, "a portrait shows no legs"
            portraits += 1
            continue
        assert scene.garments[1 if kind.part == "upper" else 0] == (UNTOLD if kind.part == "upper" else -1)
        seen.add((kind.part, bool(scene.views[1] < 0)))
    assert seen == {(part, back) for part in ("upper", "lower") for back in (False, True)} and portraits
    near = photographs.truths()["statements"][2:]
    sleeves = [k for k, (claim, _) in enumerate(statement_labels()) if claim in ("sleeves", "leg_hem")]
    assert (near[:, sleeves] == UNCLEAR).all()


def test_one_word_is_true_and_of_several_each_may_be(folder):
    (tee,) = {id(one.main): one.main for one in all_of(folder) if one.kinds[0]}.values()
    of = dict(zip(statement_labels(), tee.statements(), strict=True))
    assert of["kind", "top"] == TRUE and of["kind", "dress"] == FALSE
    assert of["sleeves", "short"] == UNCLEAR == of["fit", "loose"] and of["sleeves", "none"] == FALSE


def test_people_are_cut_out_of_white(folder):
    pixels = np.array(Image.open(folder / "0.png"))
    ground = white_around(pixels)
    assert ground[:20].all() and ground[42:48, 27:33].all()
    assert not ground[22:38, 17:43].any()
    small = np.array(Image.fromarray(pixels).resize((30, 45)).crop((-8, 0, 37, 45)))
    cover = cover_of(ground, (-15, 0, 90), 45)
    assert cover.shape == (45, 45) and cover[15:18, 18:28].min() == 1 and cover[:8].max() == 0
    shown = on_a_ground(small, cover, np.random.default_rng(3))
    assert (shown[12:18, 18:28, 0] > shown[12:18, 18:28, 1:].max(axis=2) + 40).all(), "the tee is still there"
    assert (shown[:8] < 250).any(axis=2).mean() > 0.9, "and the white around it is not"
    cut = np.array(pixels)
    cut[:, :40] = (90, 120, 60)
    assert white_around(cut) is None


def test_some_are_shown_as_if_cut_out(folder):
    pixels = np.array(Image.open(folder / "0.png"))
    whites = {0.0: 0, 1.0: 0}
    for cut_out in whites:
        for seed in range(40):
            shown, _ = shown_person(pixels, 60, np.random.default_rng(seed), near=False, cut_out=cut_out)
            whites[cut_out] += bool((shown[0] > 250).all() and (shown.min(axis=2) < 200).any())
    assert whites[1.0] > 35 and whites[0.0] < 30, "which a crop may hide"


def test_what_is_cut_out_stays_and_its_edge_moves():
    pixels = np.full((64, 64, 3), 90, np.uint8)
    cover = np.zeros((64, 64), np.float32)
    cover[16:48, 16:48] = 1
    inside, outside = [], []
    for seed in range(20):
        chance = np.random.default_rng(seed)
        shown = on_white(pixels, cover, chance)
        assert (shown[:6] > 200).all() and np.abs(shown[26:38, 26:38].astype(int) - 90).max() < 100
        shown = shown.min(axis=2)
        inside.append((shown[16:48, 16:48] < 170).sum())
        outside.append((shown[14:50, 14:50] < 230).sum() - (shown[16:48, 16:48] < 230).sum())
    assert min(inside) < 1005 and max(inside) > 1020 and min(outside) < 10 and max(outside) > 30


def test_who_is_cut_off_stays_at_the_edge():
    pixels = np.full((120, 100, 3), 255, np.uint8)
    pixels[30:, 30:70] = (180, 0, 0)
    far = 0
    for seed in range(60):
        shown, side = shown_person(pixels, 60, np.random.default_rng(seed), near=False)
        red = shown[:, :, 0].astype(int) > shown[:, :, 1:].max(axis=2) + 8
        if side > 140 and red.sum() > 100:
            far += 1
            assert red[-2:].any(), "no legs end in mid-air"
        near, side = shown_person(pixels, 60, np.random.default_rng(seed), near=True)
        assert near.shape == (60, 60, 3) and side < 0.85 * 90
    assert far > 5


def test_only_what_is_told_is_judged(folder):
    tee = next(one for one in all_of(folder) if one.kinds[0])
    shorts = next(one for one in all_of(folder) if one.kinds[1])
    scores = PhotographScores()
    scores.add_photograph(
        tee, ["upper", "lower"], {"upper": {"sleeves": "elbow", "kind": "dress"}}.__getitem__
    )
    assert scores.shares() == {"parts": 1.0, "kind": 0.0, "sleeves": 1.0, "hood": 0.0}
    scores = PhotographScores()
    scores.add_photograph(shorts, ["upper", "lower"], {"lower": {"leg_hem": "thigh"}}.__getitem__)
    assert scores.shares() == {"parts": 0.0, "kind": 0.0, "leg_hem": 1.0}


@pytest.mark.parametrize(
    "line",
    ["not json", "[]", '{"upper": null}', '{"image": "a.png", "upper": {"kind": ["cape"]}}',
     '{"image": "a.png", "upper": {"colour": ["red"]}}', '{"image": "a.png", "side": "above"}',
     '{"image": "a.png", "upper": [1]}', '{"image": "a.png", "middle": "low"}'],
)  # fmt: skip
def test_lines_that_say_nothing_are_named(tmp_path, line):
    (tmp_path / "garments.jsonl").write_text(line + "\n")
    with pytest.raises(InputError, match=r"Line 1 of .*garments\.jsonl"):
        all_of(tmp_path)


def test_photographs_outside_of_the_folder_are_left_out(tmp_path):
    inside = tmp_path / "inside"
    inside.mkdir()
    Image.new("RGB", (8, 8)).save(tmp_path / "secret.png")
    write_list(inside, [{"image": "../secret.png", "upper": TEE}])
    assert not all_of(inside)


@pytest.mark.needs_torch
def test_a_training_has_what_is_told(data, folder):
    from test_picture_training import tiny_config

    from swifttailor.training.picture_batch_torch import PictureBatches

    bank = PictureBank([data / "train"])
    bank.prepare()
    none = {"plain": 0.0, "studio": 0.0, "nothing": 0.0, "several": 0.0, "close": 0.0}
    config = tiny_config(photograph=1.0, batch_size=24, block=24, **none)
    _, _, truth = PictureBatches(bank, config, workers=0, photographs=Photographs([folder], "train"))[0]
    upper, lower = truth.present[:, 0] == 1, truth.present[:, 1] == 1
    assert upper.any() and lower.any() and not (upper & lower).any()
    portraits = upper & truth.told[:, 1]
    assert truth.told[:, 0].all() and (truth.told[:, 1] == lower | portraits).all() and not portraits.all()
    short = statement_labels().index(("leg_hem", "thigh"))
    assert truth.clear[lower, 1, short].all() and truth.statements[lower, 1, short].all()
    assert not truth.clear[upper, 1].any()


@pytest.mark.needs_torch
def test_of_photographs_no_design_is_learnt(data, folder):
    import torch

    from swifttailor.parameter_reader.placed_designs import PlacedDesigns
    from swifttailor.programs.read_parameter import ReadParameter
    from swifttailor.training.design_table_torch import UNKNOWN, DesignTable

    first, second = ReadParameter("a", ("x", "y")), ReadParameter("b", ("x", "y", "z", "w"))
    designs = PlacedDesigns(
        (first, second), {"one": 0}, np.array([[1, 2]], np.uint8), np.array([[True, True]])
    )
    table = DesignTable(["one", "photographed 0"], designs)
    said = table.unknown(torch.tensor([[1, 1]]))
    assert said.shape == (1, 2, 2, 4)
    np.testing.assert_allclose(said[0, 0], UNKNOWN * np.array([[0.5, 0.5, 0, 0], [0.25, 0.25, 0.25, 0.25]]))
    assert table.answers(torch.tensor([0]), torch.ones(1, 2, dtype=torch.bool))[0, 0, 1] > 0.5


def test_shops_photographs_are_laid_out(tmp_path, monkeypatch):
    import runpy
    import sys
    from pathlib import Path

    shop = tmp_path / "product" / "v" / "d"
    shop.mkdir(parents=True)
    names = [
        "vd01-rd_main",
        "vd01-bl_main",
        "vd01-rd_back",
        "vd01-rd_alt",
        "vp02-bl_main",
        "va03-rd_main",
        "x",
    ]
    for name in names:
        Image.new("RGB", (1200, 1600), "white").save(shop / f"{name}.jpg")
    views = {"_main": {"side": "front"}, "_back": {"side": "back"}, "_alt": {"side": "detail"}}
    claims = {"kind": ["dress"], "neckline": ["v"]}
    dress = {"product": "vd01", "part": "upper", "claims": claims, "views": views}
    legs = {"product": "vp02", "part": "lower", "claims": SHORTS, "other": TEE, "views": views}
    table = tmp_path / "table.jsonl"
    table.write_text(f"{json.dumps(dress)}\n{json.dumps(legs)}\n")
    out = tmp_path / "out"
    script = Path(__file__).parents[2] / "scripts/lay_out_shop_photographs.py"
    monkeypatch.setattr(sys, "argv", ["script", str(tmp_path / "product"), str(table), "--out", str(out)])
    runpy.run_path(str(script), run_name="__main__")
    found = {one.path.stem: one for one in all_of(out)}
    assert set(found) == {"vd01-rd_main", "vd01-bl_main", "vd01-rd_back", "vp02-bl_main"}
    assert found["vd01-rd_main"].pixels().shape == (640, 480, 3)
    assert found["vd01-rd_main"].kinds[1] is None and all(found["vd01-rd_main"].told)
    back = found["vd01-rd_back"]
    assert back.azimuth == 180 and dict(back.kinds[0].are) == {"kind": ("dress",)}
    assert found["vp02-bl_main"].kinds[0].part == "upper" and found["vp02-bl_main"].kinds[1].part == "lower"


@pytest.mark.parametrize("name", ["magento2", "venia"])
def test_the_tables_of_shops_can_be_used(tmp_path, name):
    from pathlib import Path

    table = Path(__file__).parents[2] / f"scripts/shop_garments/{name}.jsonl"
    rows = []
    for row in map(json.loads, table.read_text().splitlines()):
        image = f"{row['product']}.png"
        Image.new("RGB", (4, 4)).save(tmp_path / image)
        rows.append({"image": image, row["part"]: row["claims"]})
    write_list(tmp_path, rows)
    assert len(all_of(tmp_path)) == len(rows) > 50


def test_what_is_made_is_measured(folder):
    from types import SimpleNamespace

    from swifttailor.errors import PatternError
    from swifttailor.evaluation.pictures.photographs import made_of_photographs
    from swifttailor.pattern.drafts import draft

    class Maker:
        def look(self, pixels):
            return pixels

        def generate(self, image, part):
            if part == "lower":
                raise PatternError("no legs today")
            return SimpleNamespace(pattern=draft("t-shirt"))

    scores = made_of_photographs(Maker(), all_of(folder)[:8])
    assert scores["worn top"].shares() == {"made": 1.0, "kind": 1.0, "sleeves": 1.0, "hood": 1.0}
    assert scores["worn shorts"].shares() == {"made": 0.0, "kind": 0.0, "leg_hem": 0.0}
