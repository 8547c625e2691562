"""A jacket that lacks a detail stays a jacket."""

from __future__ import annotations

from dataclasses import replace

import pytest

from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain
from swifttailor.pattern.drafts import list_drafts
from swifttailor.tailor import Order, Tailor
from swifttailor.tailor.keeping_kinds import OF_NO_OTHER_SOURCE, keeps_its_kind


@pytest.fixture(scope="module")
def jacket():
    (answer,) = Tailor.load().write([Order("jacket with an empire waist")])
    return answer


def test_the_drafts_are_ours():
    assert {one.name for one in list_drafts()} >= OF_NO_OTHER_SOURCE


def test_it_is_kept_and_said(jacket):
    assert jacket.draft == "blazer" and keeps_its_kind(jacket)
    assert jacket.verdict.open == (Gain(Claim("waist_seam", "empire")),)


@pytest.mark.parametrize(
    "others",
    [
        {"open": ()},
        {"open": (Gain(Claim("sleeves", "short")),)},
        {"open": (Gain(Claim("waist_seam", "empire")), Gain(Claim("kind", "dress")))},
        {"refused": (Gain(Claim("collar", "lapel")),)},
    ],
)
def test_what_lacks_nothing_or_more_than_details_is_not(jacket, others):
    assert not keeps_its_kind(replace(jacket, verdict=replace(jacket.verdict, **others)))
    assert not keeps_its_kind(replace(jacket, draft="t-shirt"))


@pytest.mark.parametrize(
    ("claim", "kept"),
    [
        (Claim("bodice", "darted"), True),
        (Claim("neckline", "v"), False),
        (Claim("waist_seam", "natural"), False),
    ],
)
def test_shirts_are_kept_where_they_lack_darts_alone(jacket, claim, kept):
    shirt = replace(jacket, draft="shirt", verdict=replace(jacket.verdict, open=(Gain(claim),)))
    assert keeps_its_kind(shirt) == kept
