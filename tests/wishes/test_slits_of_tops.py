import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import SIDE_SLITS, NamedDraft
from swifttailor.wishes.drafts.slits_as_told import with_side_slits

LEFT, RIGHT = Claim("slit", "left"), Claim("slit", "right")


@pytest.mark.parametrize("name", ["shirt", "t-shirt", "kaftan"])
def test_a_slit_at_the_side_of_a_top_is_one_at_either(name):
    for claims in ([LEFT], [LEFT, RIGHT]):
        assert dict(with_side_slits(NamedDraft(name, ()), claims).options)[SIDE_SLITS] > 4
    assert with_side_slits(NamedDraft(name, ()), [Claim("slit", "back")]).options == ()


def test_a_dress_is_open_at_both_sides_only_where_both_are_asked_for():
    assert with_side_slits(NamedDraft("shift-dress", ()), [LEFT]).options == ()
    assert SIDE_SLITS in dict(with_side_slits(NamedDraft("shift-dress", ()), [LEFT, RIGHT]).options)
