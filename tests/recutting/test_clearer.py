"""What is asked for and so only just is cut until it can be seen."""

from __future__ import annotations

from dataclasses import replace

import swifttailor
from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.measuring import measure_facts
from swifttailor.recutting.alter import alter
from swifttailor.recutting.clearer import Clearly, clearer, is_clear

KNEE, LONGER = Gain(Claim("skirt_hem", "knee")), Step("length", 1)


def ending(level):
    """Facts of a dress with its hem so many cm below where "knee" is clear."""
    dress = alter(swifttailor.draft("shirt-dress"), [Clearly(KNEE.claim)]).facts
    return replace(dress, hem=replace(dress.hem, level=dress.hem.level - level))


def test_what_is_so_only_just_is_asked_for_clearly():
    barely = next(f for cm in range(1, 30) if not is_clear(KNEE, f := ending(cm)))
    assert KNEE.holds(barely, barely)
    assert clearer([KNEE], barely) == [Clearly(KNEE.claim)]


def test_what_is_clear_or_not_so_is_left_to_the_usual_cuts():
    clear, other = ending(0), ending(40)
    assert is_clear(KNEE, clear)
    assert clearer([KNEE], clear) == []
    assert clearer([KNEE], other) == []
    assert clearer([LONGER, KNEE], clear) == []


def test_a_cut_makes_it_clear():
    trousers = swifttailor.draft("trousers")
    short = alter(trousers, ["leg length -14"]).pattern
    ankle = Gain(Claim("leg_hem", "ankle"))
    facts = measure_facts(short)
    wanted = clearer([ankle], facts)
    if wanted:
        after = alter(short, wanted).facts
        assert is_clear(ankle, after)
