"""Prompts of people (benchmarks/words): readable, in the vocabulary of claims, dealt into halves by lot.

What is said of the final half when a test fails is a file, a line or a number, never a text.
"""

from __future__ import annotations

import json
import sys
from collections import Counter
from pathlib import Path

import pytest

from swifttailor.errors import InputError

BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"
sys.path.append(str(BENCHMARKS))

from people_prompts import HALVES, WORDS, read_people_edits, read_people_prompts  # noqa: E402
from split_people_prompts import deal, lines_of  # noqa: E402

FILES = {"prompts": (read_people_prompts, 300), "edits": (read_people_edits, 150)}


def read_half(half, name):
    try:
        return FILES[name][0](WORDS / half / f"{name}.jsonl")
    except InputError as error:
        message = str(error)
    pytest.fail(message, pytrace=False)  # a traceback would show the line


@pytest.fixture(scope="module")
def everything():
    return [prompt for name in FILES for half in HALVES for prompt in read_half(half, name)]


@pytest.mark.parametrize("name", FILES)
@pytest.mark.parametrize("half", HALVES)
def test_every_line_is_in_the_vocabulary(half, name):
    prompts = read_half(half, name)
    assert len(prompts) == FILES[name][1]


@pytest.mark.parametrize(
    ("file", "count"),
    [
        ("edits.jsonl", 150),
        ("edits_after.jsonl", 75),
        ("edits_voices.jsonl", 36),
        ("edits_persons.jsonl", 50),
        ("edits_persons_after.jsonl", 50),
    ],
)
def test_instructions_written_later_are_in_the_vocabulary_and_new(file, count):
    later = read_people_edits(WORDS / "fresh" / file)
    assert len({prompt.text.lower() for prompt in later}) == count
    known = {p.text.lower() for half in HALVES for p in read_half(half, "edits")}
    assert (
        len(known & {prompt.text.lower() for prompt in later}) <= count // 20
    )  # "no sleeves" is said by many


def test_the_rehearsal_is_in_the_vocabulary_and_nearly_all_new():
    wishes = read_people_prompts(WORDS / "rehearsal" / "prompts.jsonl")
    edits = read_people_edits(WORDS / "rehearsal" / "edits.jsonl")
    for name, later in (("prompts", wishes), ("edits", edits)):
        texts = {prompt.text.lower() for prompt in later}
        known = {p.text.lower() for half in HALVES for p in read_half(half, name)}
        assert len(texts) == len(later) == 120
        assert len(known & texts) <= 12  # "no slit" is said by many


def test_the_wishes_of_five_writers_are_in_the_vocabulary_and_nearly_all_new():
    wishes = read_people_prompts(WORDS / "fresh" / "prompts_of_five.jsonl")
    texts = {prompt.text.lower() for prompt in wishes}
    known = {p.text.lower() for half in HALVES for p in read_half(half, "prompts")}
    assert len(wishes) == 800 and len(texts) >= 750, "two of five may think of the same name"
    assert len(known & texts) <= 40, "many say no more than what a garment is called"
    assert all(any(e.claim == "kind" for e in p.expect) for p in wishes if len(p.text.split()) == 1)


def test_texts_of_later_writers_are_in_the_vocabulary_and_nearly_all_new():
    wishes = read_people_prompts(WORDS / "fresh" / "prompts_of_three.jsonl")
    edits = read_people_edits(WORDS / "fresh" / "edits_of_one.jsonl")
    for name, later, count in (("prompts", wishes, 255), ("edits", edits, 100)):
        known = {p.text.lower() for half in HALVES for p in read_half(half, name)}
        assert len(later) == len({p.id for p in later}) == count
        assert len(known & {p.text.lower() for p in later}) <= count // 10


@pytest.mark.parametrize("name", FILES)
def test_texts_are_unique_and_the_halves_are_those_of_the_lot(name):
    paths = [WORDS / half / f"{name}.jsonl" for half in HALVES]
    dealt = deal(lines_of(paths), seed=0)
    for path, lines in zip(paths, dealt, strict=True):
        same = path.read_text(encoding="utf-8") == "".join(line + "\n" for line in lines)
        assert same, f"{path} is not what the lot gave it."


def test_nothing_is_expected_that_would_be_wrong(everything):
    clashes = [
        prompt.id
        for prompt in everything
        for wrong in prompt.never
        for wanted in prompt.expect
        if wrong.claim == wanted.claim and set(wrong.values) & set(wanted.values)
    ]
    assert not clashes


def test_a_prompt_that_asks_for_nothing_to_wear_expects_nothing(everything):
    assert not [p.id for p in everything if not p.garment and (p.expect or p.never or p.cannot)]


def test_unknown_words_are_words_of_the_text(everything):
    assert not [p.id for p in everything for word in p.unknown if word not in p.text.lower()]


def test_all_kinds_of_prompt_are_there(everything):
    total = len(everything)
    assert sum(len(p.text.split()) <= 2 for p in everything) >= total / 4
    assert sum(len(p.text.split()) >= 40 for p in everything) >= total / 20
    languages = Counter(p.language for p in everything)
    assert 0.07 * total < total - languages["en"] < 0.1 * total
    assert {"de", "fr", "es"} <= set(languages)
    for some in ("never", "cloth", "size", "cannot", "unknown", "contradiction"):
        assert sum(bool(getattr(p, some)) for p in everything) >= 10, some


@pytest.mark.parametrize(
    ("change", "complaint"),
    [
        ({"expect": [{"claim": "pockets", "values": ["two"], "sure": "must"}]}, "no claim 'pockets'"),
        ({"expect": [{"claim": "sleeves", "values": ["longish"], "sure": "must"}]}, "no value 'longish'"),
        ({"expect": [{"claim": "sleeves", "values": ["long"], "sure": "maybe"}]}, "'must' or 'should'"),
        ({"expect": [{"claim": "tiers", "number": 3, "sure": "must"}]}, "lacks within"),
        ({"expect": [{"claim": "sleeves", "number": 3, "within": 1, "sure": "must"}]}, "no value 3"),
        ({"never": [{"claim": "hood", "values": []}]}, "never.values is empty"),
        ({"cloth": {"texture": ["rough"]}}, "unknown keys: texture"),
        ({"mood": "sunny"}, "unknown keys: mood"),
        ({"garment": "no"}, "it should be bool"),
        ({"text": " "}, "text is empty"),
        (
            {"steps": [{"measure": "charm", "direction": "+", "cm": None, "sure": "must"}]},
            "no measure 'charm'",
        ),
        ({"steps": [{"measure": "length", "direction": "up", "cm": None, "sure": "must"}]}, "received 'up'"),
        ({"base": {"kind": "cape", "statements": []}}, "no value 'cape'"),
    ],
)
def test_the_reader_is_strict(tmp_path, change, complaint):
    line = (WORDS / "building" / "edits.jsonl").read_text(encoding="utf-8").splitlines()[0]
    file = tmp_path / "edits.jsonl"
    file.write_text(json.dumps({**json.loads(line), **change}) + "\n", encoding="utf-8")
    with pytest.raises(InputError, match=complaint):
        read_people_edits(file)


def test_the_same_text_twice_is_refused(tmp_path):
    line = json.loads((WORDS / "building" / "prompts.jsonl").read_text(encoding="utf-8").splitlines()[0])
    file = tmp_path / "prompts.jsonl"
    file.write_text("\n".join(json.dumps(r) for r in (line, {**line, "id": "other"})), encoding="utf-8")
    with pytest.raises(InputError, match="same text"):
        lines_of([file])
