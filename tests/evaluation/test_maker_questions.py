"""What a PatternMaker is asked."""

from __future__ import annotations

import json
import shutil
from dataclasses import replace

import numpy as np
import pytest
from maker_standins import DRAFTS, EDITS, write_edits, write_patterns

from swifttailor.data.reader import SplitReader
from swifttailor.data.renders.files import RenderSettings, SplitRenders, draw_render
from swifttailor.errors import InputError
from swifttailor.evaluation.maker.looks import LookPictures
from swifttailor.evaluation.maker.pictures import GarmentPictures
from swifttailor.evaluation.maker.questions import (
    BACK,
    EditSet,
    PatternSet,
    choose,
    edit_questions,
    generation_questions,
    seed_of,
)
from swifttailor.pattern import to_specification
from swifttailor.pattern.digest import pattern_digest
from swifttailor.pattern.drafts import draft


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("questions")


@pytest.fixture(scope="module")
def patterns(folder) -> PatternSet:
    return PatternSet.read([write_patterns(folder)])


@pytest.fixture(scope="module")
def edits(folder, patterns) -> EditSet:
    return EditSet.read(write_edits(folder), patterns)


def asked(patterns, ids=tuple(DRAFTS), tasks=("text",), pictured=lambda id: False, seed=0):
    return generation_questions(patterns, ids, tasks, pictured, seed)


def test_patterns_are_read_with_what_is_wrong_with_others(folder, patterns):
    assert list(patterns.patterns) == list(DRAFTS) and not patterns.skipped
    assert patterns.patterns["short"] == draft("fitted-skirt", length=45.0).canonical()
    bad = folder / "more.jsonl"
    bad.write_text('{"id": "bad", "pattern": {}}\n' + (folder / "patterns.jsonl").read_text())
    both = PatternSet.read([folder / "patterns.jsonl", bad])
    assert list(both.patterns) == list(DRAFTS) and both.digest == patterns.digest
    assert list(both.skipped) == ["bad", *(f"{id} in more.jsonl" for id in DRAFTS)]
    bad.write_text('{"id": "bad", "pattern": {}}\n')
    with pytest.raises(InputError, match=r"no pattern to ask for; 1 cannot be used.*'bad'"):
        PatternSet.read([bad])


def test_a_limit_takes_the_first_of_an_order_drawn_by_lot():
    ids = [f"p{k}" for k in range(50)]
    all_of_them = choose(ids, None, 3)
    assert sorted(all_of_them) == sorted(ids) and all_of_them != ids
    assert choose(ids, 7, 3) == all_of_them[:7] and choose(ids, 30, 3) == all_of_them[:30]
    assert choose(ids, 7, 4) != choose(ids, 7, 3)


def test_a_question_does_not_depend_on_the_others(patterns):
    one, again = asked(patterns), asked(patterns, ids=("long", "shirt"))
    assert [q.key for q in one] == [f"text/{id}" for id in DRAFTS]
    assert [(q.key, q.text, q.fingerprint) for q in again] == [
        (q.key, q.text, q.fingerprint) for q in (one[2], one[0])
    ]
    others = asked(patterns, seed=1)
    assert all(a.fingerprint != b.fingerprint for a, b in zip(one, others, strict=True))
    assert any(a.text != b.text for a, b in zip(one, others, strict=True))


def test_captions_are_true_and_pictures_say_it_without_words(patterns):
    found = asked(patterns, tasks=("text", "image", "text+image"), pictured={"short", "shirt"}.__contains__)
    keys = [q.key for q in found]
    assert keys == [
        *(f"text/{id}" for id in DRAFTS),
        *(f"{task}/{id}" for task in ("image", "text+image") for id in ("shirt", "short")),
    ]
    by_key = dict(zip(keys, found, strict=True))
    for question in found:
        assert question.claims and all(c.holds(question.facts) for c in question.claims)
        assert bool(question.text) == (question.task != "image")
    assert by_key["text/shirt"].text == by_key["text+image/shirt"].text
    assert by_key["text/shirt"].claims == by_key["image/shirt"].claims


def test_patterns_that_cannot_be_measured_are_noted(patterns, monkeypatch):
    from swifttailor.evaluation.maker import questions

    measure = questions.measure_facts

    def refuse(pattern):
        if pattern == patterns.patterns["long"]:
            raise InputError("No waist.")
        return measure(pattern)

    monkeypatch.setattr(questions, "measure_facts", refuse)
    own = PatternSet(dict(patterns.patterns))
    done: list[int] = []
    found = generation_questions(own, ["long", "short"], ("text",), bool, 0, done.append)
    assert [q.id for q in found] == ["short"] and done == [1, 1]
    assert own.skipped == {"long": "It cannot be measured: No waist."}


def test_edits_are_asked_for_there_and_back(patterns, edits):
    assert list(edits.versions) == list(EDITS) and not edits.skipped
    found = edit_questions(edits, list(EDITS), patterns, seed=2)
    assert [q.id for q in found] == ["longer", "longer" + BACK, "sleeves", "sleeves" + BACK]
    for there, back in (found[:2], found[2:]):
        base, edited = edits.versions[there.id]
        assert there.before == back.truth == patterns.patterns[base]
        assert there.truth == back.before == edited
        assert there.facts == back.before_facts and there.before_facts == back.facts
        for q in (there, back):
            assert q.instruction is not None and q.instruction.text == q.text
            assert q.instruction.holds(q.before_facts, q.facts)
            assert not q.instruction.holds(q.before_facts, q.before_facts)
    alone = edit_questions(edits, ["sleeves"], patterns, seed=2)
    assert [q.fingerprint for q in alone] == [q.fingerprint for q in found[2:]]


def test_edits_that_cannot_be_asked_for_are_noted(folder, patterns):
    same = {"id": "same", "base": "short", "pattern": to_specification(patterns.patterns["short"])}
    shirt = draft("t-shirt")
    odd = replace(shirt, panels=(replace(shirt.panels[0], name="pocket"), *shirt.panels[1:]), stitches=())
    lines = [
        same,
        {"id": "odd", "base": "shirt", "pattern": to_specification(odd)},
        {"id": "bad", "base": "short", "pattern": {}},
    ]
    found = EditSet.read(write_edits(folder, *lines), patterns)
    assert list(found.versions) == [*EDITS, "same", "odd"] and list(found.skipped) == ["bad"]
    assert edit_questions(found, ["same", "odd"], patterns, 0) == []
    assert found.unseen == ["same"]
    assert "pocket" in found.skipped["odd"] and list(found.skipped) == ["bad", "odd"]
    with pytest.raises(InputError, match="1 are of other patterns"):
        strangers = folder / "strangers.jsonl"
        strangers.write_text((folder / "edits.jsonl").read_text().splitlines()[2] + "\n")
        EditSet.read(strangers, patterns)


def test_fingerprints_follow_patterns_and_words_but_not_the_order_of_a_file(patterns):
    (question,) = asked(patterns, ids=["shirt"])
    truth = question.truth
    shuffled = replace(truth, panels=truth.panels[::-1], stitches=truth.stitches[::-1])
    assert pattern_digest(shuffled) == pattern_digest(truth)
    longer = draft("t-shirt", sleeve_length=30.0)
    for other in (
        replace(question, truth=longer),
        replace(question, text=question.text + "!"),
        replace(question, before=longer),
        replace(question, task="text+image"),
    ):
        assert other.fingerprint != question.fingerprint


def test_seeds_of_different_things_differ():
    seeds = [seed_of(s, id, *more) for s in (0, 1) for id in ("a", "b") for more in ((), ("x",), ("x", 1))]
    assert len(set(seeds)) == len(seeds) and all(0 <= s < 2**31 for s in seeds)


def test_pictures_are_drawn_of_drapes_or_read(data, tmp_path, monkeypatch):
    data = shutil.copytree(data, tmp_path / "data")
    from swifttailor.evaluation.maker import pictures as module

    small = RenderSettings(size=24, random=2, plain=False)
    monkeypatch.setattr(module, "RenderSettings", lambda **values: replace(small, **values))
    drawn = GarmentPictures(data, seed=5)
    assert drawn.drawn == ("validation",) and "shirt" in drawn and "trousers" not in drawn
    name, (picture,) = drawn.picture("shirt")
    reader = SplitReader(data / "validation")
    assert np.array_equal(picture, draw_render(reader.sample("shirt"), name, small).pixels())
    names = {GarmentPictures(data, seed=s).picture(id)[0] for s in range(4) for id in reader.ids}
    assert len(names) > 1, "the seed decides the look"

    renders = SplitRenders(reader, small)
    assert list(renders.draw())
    read = GarmentPictures(data / "validation", seed=5)
    assert read.drawn == () and read.identity() == drawn.identity()
    assert json.loads(json.dumps(read.identity())) == read.identity()
    for id in reader.ids:
        (name, (picture,)), (other_name, (other,)) = drawn.picture(id), read.picture(id)
        assert name == other_name and np.array_equal(picture, other)


def test_pictures_in_one_look_show_the_same_person_from_both_sides(data):
    front, both = (LookPictures(data, 5, "people", view) for view in ("front", "both"))
    name, pictures = both.picture("shirt")
    assert name == "people, both" and [p.shape for p in pictures] == [(800, 800, 3)] * 2
    assert np.array_equal(front.picture("shirt")[1][0], pictures[0])
    assert not np.array_equal(*pictures)
    other = LookPictures(data, 6, "people", "front").picture("shirt")[1][0]
    assert not np.array_equal(other, pictures[0]), "the seed decides the rest"
    assert both.drawn == ("validation",) and "trousers" not in both
    assert both.identity() == {"look": "people", "view": "both", "size": 800}
    with pytest.raises(InputError, match="plain, seamless, studio, people, held out, laid and front"):
        LookPictures(data, 5, "several", "front")


def test_a_picture_is_asked_for_what_it_shows(patterns):
    def names(view):
        (question,) = generation_questions(patterns, ["shirt"], ("image",), lambda id: True, 0, view=view)
        return {claim.name for claim in question.claims}

    everything = names("free")
    assert names("both") == everything
    assert names("back") == {n for n in everything if n not in ("neckline", "neck_depth")} < everything
