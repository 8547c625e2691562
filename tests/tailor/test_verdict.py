"""Which of two attempts is the better one."""

from __future__ import annotations

from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain
from swifttailor.tailor.sitting import FALLS_OFF
from swifttailor.tailor.verdict import Verdict

KNEE, LOOSE, LOW = (
    Gain(Claim(name, word)) for name, word in (("leg_hem", "knee"), ("waistband", "loose"), ("rise", "low"))
)


def test_what_words_ask_for_counts_more_than_what_a_picture_shows_beside_them():
    seen = (LOOSE, LOW)
    words_open, picture_open = Verdict(open=(KNEE,), seen=seen), Verdict(open=seen, seen=seen)
    assert Verdict(seen=seen).rank < Verdict(open=(LOOSE,), seen=seen).rank < picture_open.rank
    assert picture_open.rank < words_open.rank


def test_without_a_picture_all_wishes_count_alike():
    assert Verdict(open=(KNEE,)).rank == Verdict(open=(LOOSE,)).rank
    assert Verdict(open=(KNEE,)).rank < Verdict(open=(LOOSE, LOW)).rank


def test_what_sits_badly_is_tried_again_and_gives_way_to_any_wish():
    badly = Verdict(sits_badly=("its collar stands away from the neck",))
    assert badly.fault == "sits badly: its collar stands away from the neck"
    assert not badly.unsound, "it can be sewn all the same"
    assert Verdict().rank < badly.rank < Verdict(open=(KNEE,)).rank
    assert Verdict(open=(KNEE,), sits_badly=badly.sits_badly).fault.startswith("requested but not met")


def test_what_is_odd_gives_way_to_another_and_nothing_is_written_for_it():
    odd = Verdict(beyond_usual=("its neckline is very deep",))
    assert odd.fault == "sits badly: its neckline is very deep" and odd.is_merely_odd
    assert Verdict().rank < odd.rank < Verdict(open=(KNEE,)).rank
    assert not Verdict().is_merely_odd
    assert not Verdict(open=(KNEE,), beyond_usual=("its neckline is very deep",)).is_merely_odd
    assert not Verdict(sits_badly=("it is narrower than the hips",), beyond_usual=("x",)).is_merely_odd


def test_a_waistband_that_falls_off_counts_more_than_a_wish():
    assert Verdict(open=(KNEE,)).rank < Verdict(sits_badly=(FALLS_OFF,)).rank


def test_shoulders_that_should_be_bare_count_more_than_two_other_wishes():
    covered = Verdict(open=(Gain(Claim("shoulders", "strapless")),))
    assert Verdict(open=(KNEE, LOOSE)).rank < covered.rank
    assert Verdict(open=(Gain(Claim("shoulders", "both")),)).rank == Verdict(open=(KNEE,)).rank
