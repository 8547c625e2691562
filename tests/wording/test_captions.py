"""Captions: true, varied, well-formed, and written from nothing but the pattern."""

from __future__ import annotations

import inspect
import re
from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest
from design_reader import READER, false_statements, understood

import swifttailor.wording.captions as captions
from swifttailor.describing import claims_of, measure_facts
from swifttailor.errors import InputError
from swifttailor.pattern import read_specification
from swifttailor.pattern.drafts import draft
from swifttailor.wording.captions import STYLES, write_caption, write_captions
from swifttailor.wording.speech import with_articles
from swifttailor.wording.wordings import all_wordings

SEEDS = range(60)


def every_caption(facts_by_name):
    for name, facts in facts_by_name.items():
        for caption in write_captions(facts, SEEDS):
            yield name, facts, caption


def test_every_claim_is_recomputed_on_drafts(draft_facts):
    for name, facts, caption in every_caption(draft_facts):
        for claim in caption.claims:
            assert claim.holds(facts), (name, caption)


def test_every_claim_is_recomputed_on_real_patterns(real_patterns, real_facts):
    for name, _, caption in every_caption(real_facts):
        for claim in caption.claims:
            assert claim.holds(real_facts[name]), (name, caption)
    # The same from the pattern itself, written to a file and read again.
    name = next(iter(real_patterns))
    assert write_caption(real_patterns[name], 7) == write_caption(real_facts[name], 7)


def test_a_reader_who_knows_the_design_finds_nothing_false(real_samples):
    read: Counter[str] = Counter()
    beside, others = list(real_samples("repository")), list(real_samples("validation", every=2))
    for sample in (*beside, *others):
        facts = measure_facts(read_specification(sample["pattern"]).pattern)
        for caption in write_captions(facts, range(20)):
            assert false_statements(caption.text, sample["design"]) == [], (sample["id"], caption.text)
            read.update(understood(caption.text))
    # None of the patterns beside the tests is strapless on both sides or has an S-curve.
    lacking = () if others else ("strapless", "s-curve")
    assert not {key for key in READER.keys() - read.keys() if not key.strip("\\b").startswith(lacking)}


def test_numbers_in_the_text_are_claimed(draft_facts, real_facts):
    """Every figure with a unit is one of the stated measures."""
    figures = 0
    for _, _, caption in every_caption({**draft_facts, **real_facts}):
        stated = [c.value for c in caption.claims if isinstance(c.value, float)]
        for figure, unit in re.findall(
            r"(\d+(?:\.\d+)?(?: \d/4| 1/2)?)[ -]?(cm|centimetres|in\b|inch|\")", caption.text
        ):
            whole, _, part = figure.partition(" ")
            value = float(whole) + (eval(part) if part else 0.0)
            value *= 1.0 if unit.startswith("c") else 2.54
            assert any(abs(value - s) < 0.02 for s in stated), caption
            figures += 1
    assert figures > 100


def test_nothing_but_the_pattern_is_read(drafts):
    """GarmentCode draws its inert parameters at random; no way may lead from them, or a name, into a text."""
    for function in (measure_facts, write_caption):
        assert set(inspect.signature(function).parameters) <= {"pattern", "source", "body", "seed", "style"}
    folder = Path(captions.__file__).parent
    for path in folder.rglob("*.py"):
        assert not re.search(r"meta\.|f_collar|shirt\.length|design_params|load_design", path.read_text()), (
            path
        )
    pattern = drafts["circle-skirt"]
    renamed = replace(pattern, name="hooded long-sleeved jumpsuit")
    assert [c.text for c in write_captions(pattern, SEEDS)] == [
        c.text for c in write_captions(renamed, SEEDS)
    ]


def test_the_same_seed_writes_the_same(draft_facts):
    facts = draft_facts["shirt-dress"]
    assert write_caption(facts, 11) == write_caption(facts, 11)
    texts = [c.text for c in write_captions(facts, range(200))]
    assert len(set(texts)) > 190


def test_every_style_is_written_and_can_be_asked_for(draft_facts):
    facts = draft_facts["hoodie"]
    assert {c.style for c in write_captions(facts, range(200))} == set(STYLES)
    for style in STYLES:
        assert write_caption(facts, 5, style=style).style == style
    with pytest.raises(InputError, match="no caption style 'poem'"):
        write_caption(facts, 5, style="poem")


def test_lengths_range_from_two_words_to_a_full_description(real_facts):
    counts = [len(c.text.split()) for _, _, c in every_caption(real_facts)]
    assert min(counts) <= 2 and max(counts) >= 40 and max(counts) < 120
    claims = [len(c.claims) for _, _, c in every_caption(real_facts)]
    assert max(claims) >= 12


def test_texts_are_well_formed(draft_facts, real_facts):
    for _, _, caption in every_caption({**draft_facts, **real_facts}):
        text = caption.text
        assert text and text == text.strip(), caption
        assert not re.search(r"[{}@]|  | [,.;]|,,|\.\.|\ba a\b|\bthe the\b|with with|\ban? an?\b", text), (
            caption
        )
        assert not re.search(r"\b[Aa] (?!one|U\b|U-|uni)[aeiou]", text), caption
        assert not re.search(r"\b[Aa]n (?![aeiouAEIOU8]|11|18|S-|X|F\b)", text), caption
        assert text.count("(") == text.count(")"), caption


def test_nothing_is_said_twice(real_facts):
    for _, _, caption in every_caption(real_facts):
        assert len(set(caption.claims)) == len(caption.claims)
        if caption.style == "terse":
            assert len(re.findall(r"sleeve", caption.text)) <= 2, caption


def test_units_and_dialects_are_not_mixed(real_facts):
    for _, _, caption in every_caption(real_facts):
        metric = re.search(r"\d ?-?(cm|centimetres)\b", caption.text)
        imperial = re.search(r"\d ?-?(in|inch|inches|\")(?![a-z])", caption.text)
        assert not (metric and imperial), caption
        assert not (re.search("trousers|roll-neck", caption.text) and re.search("pants|romper", caption.text))


def test_articles():
    assert with_articles("a A-line skirt and a one-shoulder top with a 8 cm band") == (
        "an A-line skirt and a one-shoulder top with an 8 cm band"
    )
    assert with_articles("A ankle-length skirt, a U-neck") == "An ankle-length skirt, a U-neck"


def test_every_wording_can_be_said_somewhere(real_facts, draft_facts):
    """Each names claims that exist together in no contradiction; most are met in a few dozen garments."""
    sets = [set(claims_of(f)) for f in (*real_facts.values(), *draft_facts.values())]
    words = [{c for c in s if isinstance(c.value, str)} for s in sets]
    measures = [{c.name for c in s if not isinstance(c.value, str)} for s in sets]
    met = [
        any(
            w.issuperset(each.needs) and m.issuperset(each.numbers)
            for w, m in zip(words, measures, strict=True)
        )
        for each in all_wordings()
    ]
    assert sum(met) > 0.55 * len(all_wordings())


def test_a_change_of_the_pattern_changes_what_is_said():
    short, long = draft("t-shirt", sleeve_length=14), draft("t-shirt", sleeve_length=60)
    texts = [" ".join(c.text for c in write_captions(p, range(80))) for p in (short, long)]
    assert "short-sleeve" in texts[0] and "short-sleeve" not in texts[1]
    assert "long-sleeve" in texts[1] and "long-sleeve" not in texts[0]
