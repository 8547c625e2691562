"""Drafts as tables name them, with options."""

from __future__ import annotations

import pytest

from swifttailor.pattern.drafts.draft_names import NamedDraft


def test_options_keep_their_types():
    named = NamedDraft.parse("shirt-dress(cuffs=true;neck_depth=11;neckline=v)")
    assert named == NamedDraft("shirt-dress", (("cuffs", True), ("neck_depth", 11.0), ("neckline", "v")))
    assert NamedDraft.parse("flares") == NamedDraft("flares")


@pytest.mark.parametrize(
    "text", ["flares()", "flares(flare)", "flares(flare=)", "flares(flare=14", "flares(=14)"]
)
def test_what_is_written_otherwise_is_refused(text):
    with pytest.raises(ValueError, match="is not written like"):
        NamedDraft.parse(text)


def test_a_name_without_a_draft_is_refused_with_those_that_are():
    with pytest.raises(ValueError, match=r"there is no draft 'flairs'\. Known: .*flares"):
        NamedDraft.parse("flairs(flare=14)")


def test_a_cape_that_ends_near_the_waist_is_a_top():
    assert NamedDraft.parse("cape(length=4)").kind == "top"
    assert NamedDraft.parse("cape(length=66)").kind == NamedDraft("cape").kind == "dress"
