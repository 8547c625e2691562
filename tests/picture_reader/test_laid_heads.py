"""What photographs of clothes that nobody wears look like joins what a network says of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from swifttailor.data.pictures.photograph_labels import KINDS
from swifttailor.errors import InputError
from swifttailor.picture_reader.labels import PARTS, statement_labels
from swifttailor.picture_reader.laid_heads import (
    ASKED,
    FARTHEST,
    NAME,
    PART,
    SHIPPED,
    LaidHeads,
    name_told,
    with_told,
)
from swifttailor.picture_reader.person_halves import LOWER, UPPER
from swifttailor.picture_reader.said import share_of
from swifttailor.picture_reader.worn_heads import COLLARED, WornHeads

LABELS = statement_labels()
PHOTOGRAPH = Path(__file__).parents[2] / "docs/images/woman-with-dog.jpg"


def answers(part, claim, shares, present=(0.0, 0.0)):
    """Answers that say these words of a claim so surely."""
    statements = np.full((len(PARTS), len(LABELS)), -6.0)
    for word, share in shares.items():
        statements[part, LABELS.index((claim, word))] = np.log(share) - np.log1p(-share)
    return {"statements": statements, "present": np.array(present, np.float32)}


def said(found, part, claim):
    shares = share_of(found["statements"][part])
    return {word: float(shares[k]) for k, (name, word) in enumerate(LABELS) if name == claim}


def logs(**shares):
    return {word: float(np.log(share)) for word, share in shares.items()}


@pytest.fixture(scope="module")
def heads():
    return LaidHeads.load(WornHeads.load().trunk)


@pytest.mark.parametrize(
    ("present", "upper", "there"),
    [
        ((1.0, -1.0), 0.02, (False, True)),
        ((-1.0, 1.0), 0.98, (True, False)),
        ((1.0, -1.0), 0.6, (True, False)),
        ((6.0, 6.0), 0.001, (True, True)),
    ],
)
def test_which_part_of_the_body_it_is_for(present, upper, there):
    before = answers(UPPER, "kind", {"top": 0.9}, present)
    found = with_told(before, {PART: logs(upper=upper, lower=1 - upper)})
    assert tuple(found["present"] > 0) == there
    assert (abs(found["present"] - before["present"]) <= FARTHEST + 1e-6).all()
    assert (found["statements"] == before["statements"]).all()


def test_shorts_are_no_skirt():
    before = answers(LOWER, "kind", {"skirt": 0.7, "shorts": 0.25, "trousers": 0.05})
    kinds = [word for claim, word in LABELS if claim == "kind"]
    told = dict.fromkeys(kinds, float(np.log(0.002))) | logs(shorts=0.95, skirt=0.03)
    found = said(with_told(before, {"lower_kind": told}), LOWER, "kind")
    assert max(found, key=found.__getitem__) == "shorts" and found["shorts"] > 0.9
    assert with_told(before, {})["statements"] is before["statements"]


def test_hems_of_legs_are_no_surer_of_a_skirt():
    hems = [word for claim, word in LABELS if claim == "leg_hem"]
    told = dict.fromkeys(hems, float(np.log(0.01))) | logs(knee=0.9)
    of_skirt = answers(LOWER, "leg_hem", {"ankle": 0.04})
    found = said(with_told(of_skirt, {"leg_hem": told}), LOWER, "leg_hem")
    assert (
        sum(found.values())
        < 0.12
        < sum(said(answers(LOWER, "leg_hem", {"ankle": 0.6}), LOWER, "leg_hem").values())
    )
    of_shorts = answers(LOWER, "leg_hem", {"ankle": 0.5, "knee": 0.4})
    assert said(with_told(of_shorts, {"leg_hem": told}), LOWER, "leg_hem")["knee"] > 0.8


@pytest.mark.parametrize(
    ("read", "collared", "told"),
    [
        ({"none": 0.7, "lapel": 0.25}, 0.9, "lapel"),
        ({"none": 0.7, "stand": 0.25}, 0.9, "stand"),
        ({"lapel": 0.6, "none": 0.4}, 0.1, "none"),
        ({"lapel": 0.9, "none": 0.1}, 0.4, "lapel"),
    ],
)
def test_a_collar_is_there_where_photographs_look_so(read, collared, told):
    before = answers(UPPER, "collar", read)
    shares = said(with_told(before, {"collar": logs(none=1 - collared, some=collared)}), UPPER, "collar")
    assert max(shares, key=shares.__getitem__) == told


@pytest.mark.parametrize(
    ("shares", "name"),
    [({"Shirt": 0.7, "Polo": 0.3}, "Shirt"), ({"Shirt": 0.5, "Polo": 0.5}, ""), ({}, "")],
)
def test_clothes_are_called_what_they_surely_are(shares, name):
    assert name_told({NAME: logs(**shares)} if shares else {}) == name
    before = answers(UPPER, "kind", {"top": 0.9})
    assert with_told(before, {NAME: logs(**shares)}) is before


def test_words_are_those_that_readers_know(heads):
    for name, which in ASKED.items():
        known = PARTS if which is None else [word for claim, word in LABELS if claim == which[1]]
        known = KINDS if name == NAME else known
        known = ("none", COLLARED) if name == "collar" else known
        assert heads.words[name] == tuple(known)


def test_a_picture_is_told_by_shares(heads):
    pixels = np.asarray(Image.open(PHOTOGRAPH).convert("RGB"))
    height, width = pixels.shape[:2]
    side = max(height, width)
    told = heads.told(pixels, ((width - side) // 2, (height - side) // 2, side))
    assert list(told) == list(ASKED)
    for shares in told.values():
        assert np.exp(list(shares.values())).sum() == pytest.approx(1)
    mirrored = heads.told(
        np.ascontiguousarray(pixels[:, ::-1]), ((width - side) // 2, (height - side) // 2, side)
    )
    for name, shares in told.items():
        assert list(mirrored[name].values()) == pytest.approx(list(shares.values()), abs=0.5)


def test_another_file_is_refused(tmp_path):
    trunk = WornHeads.load().trunk
    damaged = tmp_path / "heads.onnx"
    damaged.write_bytes(SHIPPED.read_bytes()[:-500])
    with pytest.raises(InputError, match=r"heads\.onnx"):
        LaidHeads.load(trunk, damaged)
    with pytest.raises(InputError, match=r"larger than 1 MB"):
        LaidHeads.load(trunk, SHIPPED.with_name("laid_reader.onnx"))
