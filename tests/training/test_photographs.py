"""Photographs of clothes of which only the kind is known."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from swifttailor.data.pictures.bank import PictureBank
from swifttailor.data.pictures.blocks import Blocks
from swifttailor.data.pictures.photograph_labels import KINDS
from swifttailor.data.pictures.photograph_lists import SPLITS, split_of
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.errors import InputError
from swifttailor.picture_reader.figures import FIGURES
from swifttailor.picture_reader.labels import PARTS, statement_labels
from swifttailor.picture_reader.truth import FALSE, TRUE, UNCLEAR
from swifttailor.picture_reader.view import camera_of

LABELS = ("T-Shirt", "Skirt", "Hat", "Not sure")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Eighty photographs of one colour: red T-shirts, green skirts, blue hats, white what nobody knows."""
    folder = tmp_path_factory.mktemp("photographs")
    (folder / "images").mkdir()
    colors = dict(zip(LABELS, ((200, 0, 0), (0, 200, 0), (0, 0, 200), (255, 255, 255)), strict=True))
    lines = ["image,sender_id,label,kids"]
    for k in range(80):
        label = LABELS[k % len(LABELS)]
        lines.append(f"image-{k},1,{label},False")
        Image.new("RGB", (60, 80 + k % 3), colors[label]).save(folder / "images" / f"image-{k}.jpg")
    (folder / "images.csv").write_text("\n".join(lines) + "\n")
    return folder


def test_splits_are_apart_and_only_known_labels_count(folder):
    splits = {name: Photographs([folder], name).photographs for name in ("train", "validation", "test")}
    names = [one.path.stem for some in splits.values() for one in some]
    assert len(names) == len(set(names)) == 60, "but those of which nobody is sure"
    for split, some in splits.items():
        assert some and all(split_of(one.path.stem) == split for one in some)
    assert len(splits["train"]) > 3 * len(splits["test"])


def test_each_shows_what_its_label_says(folder):
    photographs = Photographs([folder], "train")
    seen = set()
    for seed in range(40):
        scene = photographs.shown(np.random.default_rng(seed), 32, 1000)
        again = photographs.shown(np.random.default_rng(seed), 32, 1000)
        np.testing.assert_array_equal(scene.pixels, again.pixels)
        color = LABELS[int(scene.pixels.reshape(-1, 3).mean(axis=0).argmax())]
        seen.add(color)
        if color == "Hat":
            assert FIGURES[scene.figures] == "none" and (scene.garments == -1).all()
            continue
        kind = KINDS[color]
        assert FIGURES[scene.figures] == "one" and not scene.placed
        garments = np.full(len(PARTS), -1)
        garments[PARTS.index(kind.part)] = 1000 + [one is kind for one in photographs.kinds].index(True)
        np.testing.assert_array_equal(scene.garments, garments)
        camera = camera_of(scene.views)
        assert abs(camera.height - kind.seen) < 0.25 * kind.seen and abs(camera.target[1] - kind.middle) < 2
        assert not scene.masks.any() and np.isnan(scene.places.astype(float)).all()
    assert seen == {"T-Shirt", "Skirt", "Hat"}
    truths = photographs.truths()
    kinds = [*photographs.kinds, *(kind.of_a_portrait() for kind in photographs.kinds)]
    assert [PARTS[k] for k in truths["part"]] == [kind.part for kind in kinds]
    for row, kind in zip(truths["statements"], kinds, strict=True):
        np.testing.assert_array_equal(row, kind.statements())
    assert np.isnan(truths["measures"]).all() and not truths["panels"].any()
    assert photographs.ground(np.random.default_rng(0), 16).shape == (16, 16, 3)


def test_of_a_kind_is_said_what_nearly_all_are():
    labels = statement_labels()
    of = {name: dict(zip(labels, kind.statements(), strict=True)) for name, kind in KINDS.items()}
    assert of["T-Shirt"]["sleeves", "long"] == FALSE == of["T-Shirt"]["kind", "dress"]
    assert of["T-Shirt"]["sleeves", "short"] == UNCLEAR == of["T-Shirt"]["fit", "loose"]
    assert of["Hoodie"]["hood", "hood"] == TRUE == of["Skirt"]["kind", "skirt"]
    assert of["Undershirt"]["sleeves", "none"] == TRUE


def test_blocks_show_photographs_and_drawings_on_parts_of_them(data, folder):
    bank = PictureBank([data / "train"])
    bank.prepare()
    photographs = Photographs([folder], "train")
    shares = {"photograph": 0.5, "laid": 0.3, "worn": 0.2}
    block = Blocks(bank, seed=5, size=32, count=24, shares=shares, photographs=photographs)[0]
    shown = ~block.placed
    assert 4 < shown.sum() < 20
    assert (block.garments[shown].max(axis=1) >= len(bank)).all()
    assert (block.garments[block.placed] < len(bank)).all() and block.masks[block.placed].any()


@pytest.mark.parametrize("broken", ["no table", "no column", "escaping"])
def test_what_is_no_folder_of_photographs_is_refused(tmp_path, broken):
    (tmp_path / "images").mkdir()
    Image.new("RGB", (8, 8)).save(tmp_path / "secret.jpg")
    if broken == "no column":
        (tmp_path / "images.csv").write_text("a,b\n1,2\n")
    if broken == "escaping":
        (tmp_path / "images.csv").write_text("image,label\n../secret,T-Shirt\n")
    with pytest.raises(InputError, match=r"images\.csv"):
        for split in ("train", "validation", "test"):
            Photographs([tmp_path], split)


def test_a_damaged_photograph_is_named(folder):
    photograph = Photographs([folder], "train").photographs[0]
    whole = photograph.path.read_bytes()
    photograph.path.write_bytes(whole[:40])
    try:
        with pytest.raises(InputError, match=photograph.path.name):
            photograph.pixels()
    finally:
        photograph.path.write_bytes(whole)


@pytest.mark.needs_torch
def test_of_photographs_only_the_kind_is_learnt(data, folder):
    from test_picture_training import tiny_config

    from swifttailor.training.picture_batch_torch import PictureBatches

    bank = PictureBank([data / "train"])
    bank.prepare()
    none = {"plain": 0.0, "studio": 0.0, "nothing": 0.0, "several": 0.0, "close": 0.0}
    config = tiny_config(laid=0.3, photograph=0.6, worn=0.1, batch_size=24, block=24, **none)
    photographs = Photographs([folder], "train")
    _, _, truth = PictureBatches(bank, config, workers=0, photographs=photographs)[0]
    shown = ~truth.placed
    upper = shown & (truth.present[:, 0] == 1)
    assert upper.any() and (shown & (truth.present[:, 1] == 1)).any()
    assert not truth.measured[shown].any() and not truth.named[shown].any()
    assert truth.measured[truth.placed].any() and truth.named[truth.placed].any()
    labels = statement_labels()
    top, dress, fit = (labels.index(one) for one in (("kind", "top"), ("kind", "dress"), ("fit", "loose")))
    clear, said = truth.clear[upper, 0], truth.statements[upper, 0]
    assert not clear[:, fit].any() and not clear[:, top].any(), "a T-shirt may be a tunic"
    assert clear[:, dress].all() and not said[:, dress].any(), "but no dress"
    sleeveless = labels.index(("sleeves", "none"))
    assert clear[:, sleeveless].all() and not said[:, sleeveless].any()


@pytest.mark.needs_torch
def test_a_network_is_judged_by_photographs_that_it_has_not_seen(data, folder, tmp_path):
    from test_picture_training import run_of, tiny_config

    none = {"plain": 0.0, "studio": 0.0, "nothing": 0.0, "several": 0.0, "close": 0.0}
    config = tiny_config(laid=0.3, photograph=0.6, worn=0.1, steps=12, **none)
    with pytest.raises(InputError, match="--photographs"):
        run_of(data, tmp_path / "none", config=config)
    card = run_of(data, tmp_path / "run", config=config, photographs=[folder])
    found = card["validation"]["photographs"]
    assert set(found) == {"parts", "kind", "sleeves", "hood", "collar", "neckline", "nothing", "one"}
    assert all(0 <= share <= 1 for share in found.values())
    assert card["data"]["photographs"]["train"] == len(Photographs([folder], "train"))
    assert set(card["validation"]["by_look"]) == {"laid front", "laid back"}
    assert card["validation"]["near_not_false"] is None


def test_any_folder_can_be_laid_out_with_a_label(tmp_path, monkeypatch):
    import runpy
    import sys

    some = tmp_path / "some"
    some.mkdir()
    Image.new("RGBA", (1200, 30)).save(some / "a person.PNG")
    (some / "notes.txt").write_text("no picture")
    out = tmp_path / "out"
    script = Path(__file__).parents[2] / "scripts/label_photographs.py"
    monkeypatch.setattr(sys, "argv", ["script", str(some), "--label", "People", "--out", str(out)])
    runpy.run_path(str(script), run_name="__main__")
    listed = [one for split in SPLITS for one in _listed_of(out, split)]
    assert [(one.path.name, one.label, one.main) for one in listed] == [("a person.jpg", "People", None)]
    assert listed[0].pixels().shape == (20, 800, 3)


def _listed_of(folder, split):
    try:
        return Photographs([folder], split).photographs
    except InputError:
        return ()
