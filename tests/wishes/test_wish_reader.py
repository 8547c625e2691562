"""Reading with the weights of the package."""

from __future__ import annotations

import time

import pytest

from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.errors import InputError
from swifttailor.wishes.reader import SHIPPED, WishReader


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


def gains(**claims: str | float) -> set[Gain]:
    return {Gain(Claim(name, value)) for name, value in claims.items()}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        (
            "a knee-length sleeveless dress with a V neck",
            gains(kind="dress", skirt_hem="knee", sleeves="none", neckline="v"),
        ),
        ("Long-sleeved top with a square neckline", gains(kind="top", sleeves="long", neckline="square")),
        ("a floor-length skirt, waistband 6 cm", gains(kind="skirt", skirt_hem="floor", waistband_cm=6.0)),
        ("ankle-length trousers with cuffs", gains(kind="trousers", leg_hem="ankle")),
        ("a nice red midi dress for the summer", gains(kind="dress", skirt_hem="midi")),
    ],
)
def test_descriptions(reader, text, meant):
    found = {wish.change for wish in reader.read(text)}
    assert meant <= found, found


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("make it 15 cm longer", {Step("length", 1, 15.0)}),
        ("make the sleeves longer", {Step("sleeve length", 1)}),
        ("shorten the sleeves by 4 inches", {Step("sleeve length", -1, 10.16)}),
        ("give it a V neck", gains(neckline="v")),
        ("Please remove the hood.", gains(hood="none")),
        ("Could you make the dress midi-length?", gains(skirt_hem="midi")),
    ],
)
def test_instructions(reader, text, meant):
    assert {wish.change for wish in reader.read(text, instruction=True)} == meant


@pytest.mark.parametrize("text", ["", "   ", "\n", "Приветствую", "<b>&amp;</b>", "lorem ipsum dolor"])
def test_what_says_nothing_asks_for_nothing(reader, text):
    assert reader.read(text) == ()


def test_long_texts_take_bounded_time(reader):
    started = time.perf_counter()
    found = reader.read("a knee-length dress with a V neck. " * 5_000)
    assert time.perf_counter() - started < 2.0
    assert Gain(Claim("kind", "dress")) in {wish.change for wish in found}


def test_surest_first_and_the_same_again(reader):
    text = "a mini dress with three-quarter sleeves, a high collar and a slit"
    wishes = reader.read(text)
    assert wishes == reader.read(text)
    certainties = [wish.certainty for wish in wishes]
    assert certainties == sorted(certainties, reverse=True)
    assert all(0.5 <= c <= 1.0 for c in certainties)


def test_other_files_are_refused(tmp_path):
    from swifttailor.garment_sewer.sewer import SHIPPED as SEWER

    with pytest.raises(InputError, match="Cannot read the weights"):
        WishReader.load(tmp_path / "none.onnx")
    cut = tmp_path / "cut.onnx"
    cut.write_bytes(SHIPPED.read_bytes()[:1000])
    with pytest.raises(InputError, match="not a network that can be run"):
        WishReader.load(cut)
    with pytest.raises(InputError, match="not a wish reader of this version"):
        WishReader.load(SEWER)
