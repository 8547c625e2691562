"""Dresses for dancing, evenings, weddings and the stage: what they begin from and what is put on."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.drafts_as_asked import draft_as_asked
from swifttailor.wishes.drafts.ribbed_dresses import is_ribbed_dress
from swifttailor.wishes.drafts.short_flounces import short_flounce_as_asked
from swifttailor.wishes.reader import WishReader
from swifttailor.wishes.trims.trims_wanted import trims_wanted


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "name", "options", "trims"),
    [
        ("tango dress", "strappy-dress", {"crossed": True, "fitted": True}, set()),
        ("salsa dress", "strappy-dress", {"crossed": True, "skirt_fraction": 1.0}, set()),
        ("salsa", "strappy-dress", {"crossed": True}, set()),
        ("flamenco, three flounces starting at the knee", "mermaid-dress", {"tiers": 3.0}, set()),
        ("Irish dancing dress", "drop-waist-dress", {"sleeves": True}, set()),
        ("swim dress with a bit of a skirt", "swimsuit", {}, {"outer skirt"}),
        ("ballet leotard with skirt", "bodysuit", {"sleeves": True}, {"outer skirt"}),
        ("cocktail dress with illusion neckline", "skater-dress", {}, {"illusion yoke"}),
        ("crinoline", "gathered-skirt", {"length": 97.0}, {"hoops"}),
        ("bustle skirt", "circle-skirt", {"length": 98.0}, {"bustle"}),
        ("sundress with ruffled straps", "strappy-dress", {}, {"shoulder frills"}),
        ("nap dress", "empire-dress", {}, {"smocking", "shoulder frills"}),
        ("smock dress", "empire-dress", {"yoke": True}, set()),
        ("mother of the bride", "fitted-dress", {"sleeves": True}, set()),
        ("Old Hollywood", "mermaid-dress", {}, set()),
        ("gown with a floating panel", "skater-dress", {}, {"back cape"}),
        ("drop waist dress with pleats", "drop-waist-dress", {"pleats": 6.0}, set()),
        ("tennis dress with a racer back", "skater-dress", {"racer": True}, set()),
        ("white tennis dress with a polo collar and pleats", "shirt-dress", {"collar": "shirt"}, set()),
        ("tiered maxi dress, spaghetti straps", "strappy-dress", {"skirt_length": 96.0}, set()),
        ("milkmaid midi dress with a slit", "skater-dress", {"gathers": 1.9}, {"smocking"}),
        ("column dress with straps that cross at the back", "strappy-dress", {"crossed": True}, set()),
        ("knitted midi dress with a slit at the back", "shift-dress", {"back_slit": 22.0}, set()),
        ("bias cut evening dress, cowl neck", "slip-dress", {"length": 98.0}, {"cowl folds"}),
    ],
)
def test_it_begins_so(text, name, options, trims, reader):
    heard = hear_description(text, reader)
    first = heard.drafts[0]
    assert first.name == name and options.items() <= dict(first.options).items()
    wishes = trims_wanted(heard, first.name, heard.kind or "")
    assert trims <= {trim for wish in wishes for trim in wish.choices[0]}


@pytest.mark.parametrize(
    ("text", "sleeves"),
    [("wedding dress with illusion neckline and lace sleeves", "long"), ("tango dress", "none")],
)
def test_lace_sleeves_are_sewn_to_an_illusion_neckline(text, sleeves, reader):
    heard = hear_description(text, reader)
    claims = {w.change.claim for w in (*heard.sure, *heard.likely) if hasattr(w.change, "claim")}
    assert Claim("sleeves", sleeves) in claims


def test_a_short_fishtail_has_a_short_close_part():
    knee = [Claim("skirt_hem", "knee")]
    cut = dict(
        short_flounce_as_asked(NamedDraft.parse("mermaid-skirt(close=54;fraction=0.75)"), knee).options
    )
    assert cut == {"close": 39.0, "fraction": 0.75, "length": 58.0}
    for other in ("mermaid-skirt(close=54)", "mermaid-dress(close=52;tiers=4)", "circle-skirt(length=60)"):
        asked = [Claim("skirt_hem", "floor")] if other.startswith("mermaid-skirt") else knee
        assert short_flounce_as_asked(NamedDraft.parse(other), asked) == NamedDraft.parse(other)


@pytest.mark.parametrize(
    ("text", "clings"),
    [
        ("ribbed dress with a mock neck", True),
        ("knitted dress with a mock neck", False),
        ("a loose ribbed dress", False),
        ("ribbed skirt", False),
    ],
)
def test_dresses_of_ribs_cling(text, clings, reader):
    heard = hear_description(text, reader)
    said = [] if heard.words is None else [i.claim for i in heard.words.implications if i.said]
    assert is_ribbed_dress(heard, said) is clings


def test_a_gathered_skirt_keeps_its_gathers_beside_a_slit():
    slit = [Claim("slit", "left")]
    gathered = draft_as_asked(NamedDraft.parse("skater-dress(gathers=1.9;skirt_length=74)"), slit)
    round_ = draft_as_asked(NamedDraft.parse("skater-dress(skirt_length=50)"), slit)
    assert gathered is not None and gathered.name == "skater-dress"
    assert round_ is not None and round_.name == "fitted-dress"
