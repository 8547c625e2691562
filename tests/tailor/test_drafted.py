"""Garments that words name and a draft shows begin from that draft."""

from __future__ import annotations

import pytest
from own_library import library_of
from scripted_maker import scripted_maker

from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import InputError
from swifttailor.pattern.drafts import draft
from swifttailor.tailor import Order, Tailor
from swifttailor.wishes.assumed.well_within import FLOOR_AT_LEAST_CM
from swifttailor.wording.lexicon import all_entries

KNOWN = {"skirt": draft("fitted-skirt"), "shirt": draft("t-shirt"), "trousers": draft("trousers")}


@pytest.fixture
def tailor(tmp_path, sewer):
    library = library_of(KNOWN, tmp_path)
    return Tailor(scripted_maker([draft("fitted-dress")]), sewer, pattern_library=library)


@pytest.mark.parametrize(
    ("text", "name", "panels"),
    [
        ("skinny jeans", "jeans", 6),
        ("leggings", "leggings", 6),
        ("a bathrobe", "coat", 16),
        ("a kimono robe", "robe", 8),
        ("a kaftan", "kaftan", 8),
        ("a crop top with spaghetti straps", "camisole", 4),
        ("ein Faltenrock", "pleated-skirt", 24),
        ("a wrap dress", "wrap-dress", 11),
        ("a short-sleeved wrap top", "wrap-top", 8),
        ("a polo shirt", "polo-shirt", 16),
        ("a blazer", "blazer", 16),
        ("bodysuits", "bodysuit", 12),
        ("a red swimsuit", "swimsuit", 8),
        ("dungarees", "dungarees", 10),
        ("a pinafore dress", "pinafore", 8),
        ("a hooded cloak", "cape", 6),
        ("a linen apron", "apron", 7),
        ("a knee-length sarong", "sarong", 5),
        ("a halter dress with a straight skirt", "halter-dress", 8),
        ("halter neck dress, backless", "halter-dress", 8),
        ("cycling shorts", "leggings", 6),
        ("a skirt of eight gores", "gored-skirt", 10),
    ],
)
def test_begins_from_the_draft_and_says_so(tailor, text, name, panels):
    (answer,) = tailor.write([Order(text)])
    assert (answer.draft, answer.known, answer.attempt) == (name, "", 0)
    assert not answer.verdict.fault and len(answer.pattern.panels) == panels


def test_report_and_notes_name_the_draft(tailor):
    made = tailor.generate("a pleated mini skirt")
    assert made.report["writing"]["source"] == "draft"
    assert made.report["writing"]["draft"] == "pleated-skirt"
    assert "Begun from a draft of ours: pleated-skirt." in made.notes
    assert any("pleat" in note and "fold" in note for note in made.notes)
    assert made.report["heard"]["cannot"] == []
    assert "pattern_maker" not in made.report["weights"]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("a wrap top", ["a seam runs where the edge of the upper front would lie", "fronts that overlap"]),
        (
            "a wrap dress",
            ["the edge of the upper front would lie", "tied at the left side"],
        ),
        ("a catsuit", ["Cut smaller than the body, for cloth that stretches by 8%", "a zip"]),
        ("a polo shirt", ["a short front band with buttons", "The slit below its collar is closed"]),
        ("a blazer", ["buttons down the front; two welt pockets"]),
    ],
)
def test_what_a_draft_stands_in_for_is_said(tailor, text, said):
    notes = tailor.generate(text).notes
    assert all(any(words in note for note in notes) for words in said), notes


@pytest.mark.parametrize(
    "text",
    [
        "a one-sleeved dress",
        "a one-sleeved dress over my leggings",
        "a one-sleeved dress, not a kaftan",
    ],
)
def test_nothing_else_begins_from_a_draft(tailor, text):
    (answer,) = tailor.write([Order(text)])
    assert answer.draft == ""


def test_what_a_draft_cannot_be_cut_to_is_tried_otherwise(tailor):
    (answer,) = tailor.write([Order("a pleated skirt of thirty gores")])
    assert answer.verdict.open and len(answer.failures) == 3


def test_seeds_vary_the_draft_and_are_the_same_each_time(tailor):
    orders = [Order("a bathrobe", seed=seed) for seed in (0, 1, 2, 1)]
    patterns = [tailor.write([order])[0].pattern for order in orders]
    assert patterns[1] == patterns[3]
    assert patterns[0] != patterns[1] != patterns[2]


@pytest.mark.parametrize("source", ["library", "writer"])
def test_other_sources_alone_have_no_drafts(tailor, source):
    (answer,) = tailor.write([Order("leggings", source=source)])
    assert answer.draft == ""


def test_drafts_alone_are_refused_where_none_is_named(tailor):
    (answer,) = tailor.write([Order("leggings", source="drafts")])
    assert answer.draft == "leggings"
    with pytest.raises(InputError, match="draft --list"):
        tailor.write([Order("a one-sleeved dress", source="drafts")])


def test_every_entry_names_drafts_of_its_own_kind():
    named = [entry for entry in all_entries() if entry.drafts]
    assert len(named) > 15
    for name, options in {(one.name, one.options) for entry in named for one in entry.drafts}:
        assert draft(name, **dict(options)).panels, f"{name}: {options}"
    for entry in named:
        cut_from = entry.kinds | ({"trousers"} if "shorts" in entry.kinds else frozenset())
        cut_from |= {"jumpsuit"} if "playsuit" in entry.kinds else frozenset()
        cut_from |= {"top"} if "tunic" in entry.kinds else frozenset()
        cut_from |= {"dress"} if "skirt" in entry.kinds else frozenset()  # a dress with an A-line skirt
        assert not entry.kinds or {named.kind for named in entry.drafts} <= cut_from, entry.name


def test_a_gown_is_as_long_as_asked_and_its_change_is_told_once(tailor):
    (answer,) = tailor.write([Order("wedding dress")])
    (told,) = [cut for cut in answer.cuts if cut.startswith("hem ")]
    assert told.endswith("cm longer")
    hem = measure_facts(answer.pattern).hem
    assert hem is not None and FLOOR_AT_LEAST_CM <= hem.level < 7.5


@pytest.mark.parametrize("text", ["halter neck dress, backless", "a long tunic with side slits"])
def test_what_a_draft_shows_to_the_eye_is_not_told_to_be_missing(tailor, text):
    (answer,) = tailor.write([Order(text)])
    assert answer.draft and answer.not_so == ()


@pytest.mark.parametrize("name", ["shirt", "halter-top", "pleated-skirt"])
def test_an_edit_of_what_nobody_can_write_leaves_it_as_it_is(sewer, name):
    """PatternMaker has no names for some panels of drafts; where cutting does nothing, it is not asked."""
    pattern = draft(name)
    made = Tailor(scripted_maker([draft("fitted-dress")]), sewer).edit(pattern, "add two godets")
    assert made.pattern.panels == pattern.panels and made.pattern.stitches == pattern.stitches
    assert made.answer.verdict.open
