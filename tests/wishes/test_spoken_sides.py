"""What is said of the left and of the right, of halves that change places, and of joined clauses."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from test_spoken_changes import gain, heard

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Step
from swifttailor.wishes.text.mentions import find_mentions
from swifttailor.wishes.text.spoken_sides import blanked, spoken_sides


@pytest.mark.parametrize(
    ("text", "claims"),
    [
        ("left sleeve long, right sleeve short", {"left_sleeve": "long", "right_sleeve": "short"}),
        ("a short right sleeve and a long left sleeve", {"left_sleeve": "long", "right_sleeve": "short"}),
        ("one long sleeve, one short", {"left_sleeve": "long", "right_sleeve": "short"}),
        ("with one sleeve long and one short", {"left_sleeve": "long", "right_sleeve": "short"}),
        ("one sleeve is long, the other one short", {"left_sleeve": "long", "right_sleeve": "short"}),
        ("the left arm 3/4 length", {"left_sleeve": "three-quarter"}),
        ("one strap, on the left", {"shoulders": "bare right"}),
        ("right shoulder covered left one bare", {"shoulders": "bare left"}),
        ("bare left shoulder", {"shoulders": "bare left"}),
        ("left sleeve long, right arm completely bare", {"left_sleeve": "long", "sleeves": "left only"}),
        ("no left sleeve", {"sleeves": "right only"}),
        ("one long sleeve and one bare arm", {"sleeves": "left only", "left_sleeve": "long"}),
        (
            "one arm bare, the other in a short sleeve",
            {"sleeves": "left only", "left_sleeve": "short"},
        ),
        ("one arm completely bare", {"sleeves": "left only"}),
        ("bare arms", {}),
        ("left leg bare", {}),
        ("long sleeves", {}),
        ("sleeves left long", {}),
        ("left sleeve long and left sleeve short", {}),  # who says both is not understood
    ],
)
def test_each_side_is_heard_by_itself(text, claims):
    found = spoken_sides(text)
    assert {claim.name: claim.value for claim in found.claims} == claims
    assert len(found.spans) == len(found.claims)


@given(st.text(st.sampled_from("left right sleeve long short one the other,."), max_size=60))
def test_places_lie_in_the_text_and_are_blanked_alone(text):
    spans = spoken_sides(text).spans
    rest = blanked(text, spans)
    assert len(rest) == len(text)
    for k, (old, new) in enumerate(zip(text, rest, strict=True)):
        assert new == (" " if any(a <= k < b for a, b in spans) else old)


@pytest.mark.parametrize(
    ("kind", "text", "true", "changes"),
    [
        ("top", "make the left sleeve longer", ("left_sleeve", "short"), [gain("left_sleeve", "elbow")]),
        ("top", "off with the left sleeve", None, [gain("sleeves", "right only")]),
        ("dress", "trousers instead of the skirt", None, [gain("kind", "jumpsuit")]),
        (
            "jumpsuit",
            "swap the trousers for a pencil skirt",
            None,
            [gain("kind", "dress"), gain("skirt", "pencil")],
        ),
        ("jumpsuit", "swap the skirt for trousers", None, []),  # it has no skirt
        (
            "dress",
            "everything stays apart from the skirt, that should be narrower",
            None,
            [Step("skirt hem", -1)],
        ),
        (
            "dress",
            "make the sleeves and the hem shorter",
            None,
            [Step("sleeve length", -1), Step("length", -1)],
        ),
        (
            "dress",
            "lengthen the skirt and taper it",
            None,
            [Step("length", 1), Step("skirt hem", -1)],
        ),
        ("dress", "longer sleeves and hem", None, [Step("sleeve length", 1), Step("length", 1)]),
        (
            "dress",
            "shorten the sleeves and skirt by 3 cm",
            None,
            [Step("sleeve length", -1, 3.0), Step("length", -1, 3.0)],
        ),
        (
            "dress",
            "elbow sleeves and 10 cm longer",
            None,
            [gain("sleeves", "elbow"), Step("length", 1, 10.0)],
        ),
        ("top", "elbow sleeves and a bit wider", None, [gain("sleeves", "elbow"), Step("sleeve width", 1)]),
        ("dress", "V neck and longer", None, [gain("neckline", "v"), Step("length", 1)]),
        (
            "dress",
            "add a stand collar and make it longer",
            None,
            [gain("collar", "stand"), Step("length", 1)],
        ),
        ("hoodie", "tighter cuffs", None, [Step("cuff opening", -1)]),
        ("skirt", "60 cm long", None, []),
        ("trousers", "narrow the legs below the knee", None, [Step("leg end", -1)]),
        ("dress", "it drags on the floor", ("skirt_hem", "floor"), [Step("length", -1)]),
        ("dress", "ruffles at the sleeves", None, [gain("cuffs", "flounce")]),
        ("dress", "an inch and a half longer", None, [Step("length", 1, 3.81)]),
        ("trousers", "leg end 4 wider", None, [Step("leg end", 1, 4.0)]),
        ("dress", "the stand collar is choking me", ("collar", "stand"), [Step("collar height", -1)]),
        ("top", "vent at each side", None, [gain("slit", "left"), gain("slit", "right")]),
    ],
)
def test_instructions_in_peoples_own_words(kind, text, true, changes):
    is_so = Claim(*true).__eq__ if true else lambda claim: False
    assert list(heard(text, kind, is_so).changes) == changes


@pytest.mark.parametrize(
    ("text", "cm"),
    [("an inch and a half", 3.81), ("two and a half inches", 6.35), ("an inch", 2.54), ("two inches", 5.08)],
)
def test_halves_of_a_unit_are_counted(text, cm):
    (mention,) = find_mentions(text)
    assert mention.value == pytest.approx(cm) and mention.is_length


def test_a_part_of_a_list_that_nothing_came_of_is_left_over():
    clauses = heard("sleeves, hem and neck all a bit smaller", "dress").clauses
    assert "sleeves" in {word for clause in clauses for word in clause.left_over}
