"""Every length of sleeves that words tell is drafted, of every garment that may have sleeves."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.pattern.drafts import find_draft, list_drafts
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.tailor.drafted import DraftCandidate
from swifttailor.wishes.drafts.drafts_as_asked import draft_as_asked


@pytest.mark.parametrize("length", CLAIM_TYPES["sleeves"].words)
def test_any_garment_with_sleeves_of_any_length(length):
    for info in list_drafts():
        asked = draft_as_asked(NamedDraft(info.name), [Claim("sleeves", length)])
        if asked is not None:
            known = {field.name for field in find_draft(asked.name).options}
            assert dict(asked.options).keys() <= known, info.name


@pytest.mark.parametrize("name", ["skater-dress", "shift-dress", "jumpsuit", "sweatshirt"])
def test_extra_long_sleeves_are_longer_than_long_ones(name):
    lengths = {}
    for length in ("long", "extra-long"):
        asked = draft_as_asked(NamedDraft(name), [Claim("sleeves", length)])
        assert asked is not None
        made = DraftCandidate(asked, 0, plain=True).made_for(None)
        sleeve = next(panel for panel in made.panels if "sleeve" in panel.name)
        lengths[length] = float((sleeve.vertices.max(axis=0) - sleeve.vertices.min(axis=0)).max())
    assert lengths["extra-long"] > lengths["long"] + 3.0
