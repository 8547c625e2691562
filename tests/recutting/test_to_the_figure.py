"""Figures that are asked for: cut to the centimetre where that can be, and told where it cannot."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.measuring import measure_facts
from swifttailor.recutting.alter import Alteration, alter
from swifttailor.recutting.to_the_figure import NEAR_CM, figures_missed, to_the_figures

DRESS = swifttailor.draft("shirt-dress")
FACTS = measure_facts(DRESS)
HEM = QUANTITIES["skirt hem"].of(FACTS)
NEARLY = Gain(Claim("hem_cm", round(HEM - 6.0, 1)))


def test_what_nearly_holds_is_moved_on_to_its_figure():
    start = Alteration(DRESS, FACTS, (), (), ())
    assert NEARLY.holds(FACTS, FACTS) and figures_missed([NEARLY], FACTS, FACTS) == [NEARLY]
    done = to_the_figures(start, [NEARLY], FACTS)
    assert QUANTITIES["skirt hem"].of(done.facts) == pytest.approx(HEM - 6.0, abs=NEAR_CM)
    assert done.cuts and not figures_missed([NEARLY], FACTS, done.facts)


def test_what_is_at_its_figure_is_left_alone():
    wish = Step("length", -1, 7.5)
    done = alter(DRESS, [wish])
    assert to_the_figures(done, [wish], FACTS) is done


@pytest.mark.parametrize("wish", [Step("length", -1), Gain(Claim("sleeves", "none")), Step("tiers", 1, 2.0)])
def test_words_and_pieces_have_no_figure(wish):
    assert figures_missed([wish], FACTS, FACTS) == []
