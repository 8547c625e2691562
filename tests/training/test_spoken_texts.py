"""Instructions in people's own words, for the wish reader to learn from."""

from __future__ import annotations

import json

import numpy as np
import pytest

from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.errors import InputError
from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.training.spoken_texts import SpokenText, read_spoken_texts
from swifttailor.training.wish_samples import WishSamples
from swifttailor.wishes.labels import statement_labels

GOOD = {
    "text": "an inch off the hem, and lose the hood",
    "kind": "top",
    "asks": ["step:length:down", "gain:hood:none"],
    "amounts": {"step:length:down": 2.54},
    "voice": "tailor",
}


def write(tmp_path, *lines):
    path = tmp_path / "spoken.jsonl"
    path.write_text("\n".join(line if isinstance(line, str) else json.dumps(line) for line in lines))
    return path


def test_what_is_asked_for_is_read_with_its_amounts(tmp_path):
    bare = {"text": "60 cm sleeves", "kind": "dress", "asks": [], "amounts": {"measure:sleeve_cm": 60}}
    one, other = read_spoken_texts([write(tmp_path, GOOD, "", bare)])
    assert set(one.changes) == {Step("length", -1, 2.54), Gain(Claim("hood", "none"))}
    assert (one.text, one.kind) == (GOOD["text"], "top")
    assert other.changes == (Gain(Claim("sleeve_cm", 60.0)),)


@pytest.mark.parametrize(
    "line",
    [
        "{",
        "[]",
        "3",
        json.dumps({"text": "longer", "kind": "top"}),
        json.dumps(GOOD | {"more": 1}),
        json.dumps(GOOD | {"text": None}),
        json.dumps(GOOD | {"kind": 3}),
        json.dumps(GOOD | {"amounts": {"step:length:down": "much"}}),
        json.dumps(GOOD | {"amounts": []}),
        json.dumps(GOOD | {"asks": ["gain:hood:purple"]}),
        json.dumps(GOOD | {"amounts": {"gain:hood:none": 1.0}}),
    ],
)
def test_a_line_that_says_something_else_is_named(tmp_path, line):
    with pytest.raises(InputError, match="line 2"):
        read_spoken_texts([write(tmp_path, GOOD, line)])


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(InputError, match="nowhere"):
        read_spoken_texts([tmp_path / "nowhere.jsonl"])


def test_some_are_held_out_by_their_text_alone():
    texts = [SpokenText(f"make it {k} cm longer", "top", ()) for k in range(500)]
    held = [one for one in texts if one.held_out]
    assert 25 <= len(held) <= 80
    assert all(SpokenText(one.text.upper(), "skirt", (Step("length", 1),)).held_out for one in held)


def test_samples_say_what_the_texts_say_alone_or_two_of_one_kind():
    spoken = [
        SpokenText("hem up!", "skirt", (Step("length", -1),)),
        SpokenText("i drown in it", "skirt", (Step("length", -1), Gain(Claim("fit", "close")))),
        SpokenText("shorten sleeves", "top", (Step("sleeve length", -1),)),
    ]
    samples = WishSamples(None, TextTokenizer.shipped(), seed=0, typos=0.0, spoken=spoken)
    labels = {"hem up": {"step:length:down"}, "drown": {"step:length:down", "gain:fit:close"}}
    labels |= {"shorten": {"step:sleeve length:down"}}
    both = 0
    for k in range(200):
        text, changes = samples._spoken(np.random.default_rng(k), instruction=True)
        names = [word for word in labels if word in text]
        made = samples.sample(text, changes, instruction=True)
        assert {statement_labels()[n] for n in made.said} == set().union(*(labels[n] for n in names))
        assert not ("shorten" in names and len(names) > 1), "they are about different garments"
        both += len(names) > 1
    assert 0 < both < 100


def test_descriptions_are_shown_as_such():
    spoken = [SpokenText("a thing for the ball", None, (Gain(Claim("kind", "dress")),))]
    samples = WishSamples(None, TextTokenizer.shipped(), seed=0, typos=0.0, spoken=spoken)
    samples._instruction = samples._caption = lambda chance: ("written", ())
    made = [samples.make(k) for k in range(60)]
    shown = [one for one in made if "ball" in one.text]
    assert len(shown) > 5 and not any(one.instruction for one in shown)
    assert {one.changes for one in shown} == {spoken[0].changes}
