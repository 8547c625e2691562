"""Patterns from a model file, without torch; the network is untrained (scripts/make_tiny_maker_torch.py)."""

from __future__ import annotations

import io
import json
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from token_reference import faults

from swifttailor.errors import InputError, PatternError
from swifttailor.pattern import Pattern, check_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.tidying.mending import mend
from swifttailor.pattern_maker.asking.pictures import picture_for_network
from swifttailor.pattern_maker.maker import PatternMaker, Request
from swifttailor.pattern_maker.network.model_file import load_model
from swifttailor.pattern_maker.tokens.decode import decode
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.render.picture_file import read_picture

TINY = Path(__file__).with_name("tiny_maker.zip")


@pytest.fixture(scope="module")
def maker():
    return PatternMaker.load(TINY)


def content(generated):
    return replace(generated, seconds={}).__dict__ | {"pattern": generated.pattern.canonical()}


def test_text_image_and_edit_give_patterns(maker):
    image = np.random.default_rng(0).integers(255, size=(40, 60, 3), dtype=np.uint8)
    requests = [
        Request("a long dress"),
        Request("", image),
        Request("a long dress", image),
        Request("make it shorter", edit=draft("t-shirt")),
    ]
    made = maker.generate_all(requests, temperature=1.0, seed=3)
    for one in made:
        assert faults(encode(one.pattern).tokens.tolist(), 1024, 64) == [] or one.changes
        assert one.findings == check_pattern(one.pattern)
        assert one.log_likelihood < 0
        assert not one.notes
        assert set(one.seconds) == {"reading", "writing", "checking"}
    assert len({one.log_likelihood for one in made}) == 4, "all parts of a request are looked at"


def test_together_is_as_alone(maker, unmended):
    requests = [Request("a dress"), Request("trousers with pockets and a waistband"), Request("a hood")]
    together = maker.generate_all(requests)
    for request, one in zip(requests, together, strict=True):
        alone = maker.generate(request.text)
        assert alone.tokens == one.tokens
        assert alone.log_likelihood == pytest.approx(one.log_likelihood, rel=1e-4)


def test_the_same_seed_gives_the_same(maker):
    first, again, other = (maker.generate("a skirt", seed=s, temperature=1.0) for s in (1, 1, 2))
    assert content(first) == content(again)
    assert content(first) != content(other)


def test_each_request_can_have_its_own_seed(maker, unmended):
    requests = [Request("a skirt"), Request("a dress"), Request("a skirt")]
    made = maker.generate_all(requests, seed=[1, 7, 2], temperature=1.0)
    for request, seed, one in zip(requests, (1, 7, 2), made, strict=True):
        alone = maker.generate(request.text, seed=seed, temperature=1.0)
        assert alone.sequence.tokens.tolist() == one.sequence.tokens.tolist()
    assert made[0].sequence.tokens.tolist() != made[2].sequence.tokens.tolist()
    with pytest.raises(InputError, match="2 seeds for 3 requests"):
        maker.generate_all(requests, seed=[1, 2])
    with pytest.raises(InputError, match="seed is -1"):
        maker.generate_all(requests, seed=[1, -1, 2])


def test_what_was_written_comes_along(maker):
    made = maker.generate("a skirt", seed=5, temperature=1.0)
    written = decode(made.sequence)
    assert made.tokens == len(made.sequence)
    repaired = mend(written, alike=True)
    assert (repaired.pattern, repaired.changes) == (made.pattern, made.changes)


def test_every_draw_of_a_seed_is_another_pattern(maker, unmended):
    request = Request("a skirt")
    drawn = [maker.generate_all([request], seed=5, temperature=1.0, draw=k)[0] for k in range(4)]
    assert len({one.log_likelihood for one in drawn}) == 4
    assert content(drawn[0]) == content(maker.generate("a skirt", seed=5, temperature=1.0))
    cold = [maker.generate_all([request], seed=5, draw=k)[0] for k in (0, 3)]
    assert content(cold[0]) == content(cold[1])


def test_a_long_text_is_cut_and_that_is_said(maker, unmended):
    made = maker.generate("flared " * 15_000)
    (note,) = made.notes
    assert "32 tokens" in note
    assert made.log_likelihood == maker.generate("flared " * 100).log_likelihood


@pytest.mark.parametrize(
    ("request_", "message"),
    [
        ({}, "a text or an image is needed"),
        ({"text": " \n"}, "a text or an image is needed"),
        ({"text": "", "edit": draft("t-shirt")}, "an instruction is needed"),
        ({"text": "x", "temperature": -1.0}, "temperature"),
        ({"text": "x", "temperature": float("nan")}, "temperature"),
        ({"text": "x", "seed": -1}, "seed is -1"),
        ({"image": np.zeros((4, 4), np.uint8)}, "of three|three|(h, w, 3)"),
        ({"image": "/nowhere.png"}, "There is no picture"),
    ],
)
def test_what_cannot_be_answered_is_refused(maker, request_, message):
    with pytest.raises(InputError, match=message):
        maker.generate(**request_)


def test_a_pattern_that_does_not_fit_is_refused(maker):
    shirt = draft("t-shirt")
    odd = Pattern((replace(shirt.panels[0], name="pocket"),), (), "odd")
    with pytest.raises(PatternError, match="pocket"):
        maker.generate("shorter", edit=odd)


def test_without_weights_the_way_to_them_is_named(monkeypatch):
    import swifttailor.pattern_maker.maker as module

    monkeypatch.setattr(module, "SHIPPED", Path("/nowhere/pattern_maker.zip"))
    with pytest.raises(InputError, match="swifttailor train pattern-maker"):
        PatternMaker.load()


def test_pictures_become_square_and_normalised(tmp_path):
    pixels = np.zeros((20, 40, 3), np.uint8)
    pixels[:, :20] = 255
    made = picture_for_network(pixels, 40)
    assert made.shape == (3, 40, 40)
    middle = made[:, 20]
    assert np.allclose(middle[:, 5], (1 - np.array([0.485, 0.456, 0.406])) / [0.229, 0.224, 0.225], atol=1e-5)
    assert np.allclose(middle[:, 35], -np.array([0.485, 0.456, 0.406]) / [0.229, 0.224, 0.225], atol=1e-5)
    picture = Image.new("RGBA", (6, 4), (10, 20, 30, 0))
    picture.putpixel((0, 0), (10, 20, 30, 255))
    picture.save(tmp_path / "p.png")
    read = read_picture(tmp_path / "p.png")
    assert read.shape == (4, 6, 3)
    assert read[0, 0].tolist() == [10, 20, 30]
    assert read[3, 5].tolist() == [255, 255, 255]


@pytest.mark.parametrize("data", [b"", b"no picture", b"\x89PNG\r\n\x1a\n" + b"\0" * 50])
def test_what_is_no_picture_is_refused(data, tmp_path):
    (tmp_path / "p.png").write_bytes(data)
    with pytest.raises(InputError, match="is not a readable picture"):
        read_picture(tmp_path / "p.png")


def test_model_file_says_what_it_is(maker):
    model = load_model(TINY)
    assert model.card["model"] == "PatternMaker"
    assert (model.image_size, model.image_tokens, model.longest_text) == (32, 1, 32)
    assert model.grammar.tags == "ascending"


def repacked(change) -> bytes:
    with zipfile.ZipFile(TINY) as archive:
        members = {name: archive.read(name) for name in archive.namelist()}
    change(members)
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for name, data in members.items():
            archive.writestr(name, data)
    return buffer.getvalue()


def edit_card(change):
    def apply(members):
        card = json.loads(members["card.json"])
        change(card)
        members["card.json"] = json.dumps(card).encode()

    return apply


def swap(members):
    import hashlib

    members["embed.onnx"], members["regress.onnx"] = members["regress.onnx"], members["embed.onnx"]
    card = json.loads(members["card.json"])
    for name in ("embed.onnx", "regress.onnx"):
        card["sha256"][name] = hashlib.sha256(members[name]).hexdigest()
    members["card.json"] = json.dumps(card).encode()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda m: m.pop("vision.onnx"), "is not a PatternMaker: it holds"),
        (lambda m: m.update({"more": b""}), "is not a PatternMaker: it holds"),
        (lambda m: m.update({"embed.onnx": m["embed.onnx"][:-9]}), "embed.onnx is not what"),
        (lambda m: m.update({"text_tokens.json": b"{}"}), "text_tokens.json is not what"),
        (lambda m: m.update({"card.json": b"{}"}), "of this version"),
        (edit_card(lambda c: c.update(format="swifttailor pattern-maker 0")), "of this version"),
        (edit_card(lambda c: c.pop("card")), "does not say how it must be asked"),
        (edit_card(lambda c: c["card"]["config"].update(tags="none")), "does not say how it must be asked"),
        (edit_card(lambda c: c["card"]["config"]["network"].update(image_size=64)), "contradicts itself"),
        (swap, "is another network"),
    ],
)
def test_other_and_changed_files_are_refused(change, message, tmp_path):
    path = tmp_path / "model.zip"
    path.write_bytes(repacked(change))
    with pytest.raises(InputError, match=message):
        load_model(path)


def test_a_damaged_file_is_refused_wherever_it_is_damaged(tmp_path):
    path, whole = tmp_path / "model.zip", TINY.read_bytes()
    for size in (0, 10, 1000, len(whole) // 2, len(whole) - 1):
        path.write_bytes(whole[:size])
        with pytest.raises(InputError):
            load_model(path)
    for place in range(50, len(whole), len(whole) // 40):
        path.write_bytes(whole[:place] + bytes([whole[place] ^ 0x55]) + whole[place + 1 :])
        with pytest.raises(InputError):
            load_model(path)
    with pytest.raises(InputError, match="Cannot read"):
        load_model(tmp_path / "missing.zip")
