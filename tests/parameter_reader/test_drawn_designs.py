"""Designs drawn by lot can be drafted and sewn."""

from __future__ import annotations

from itertools import islice

from swifttailor.parameter_reader.drawn import drawn_designs
from swifttailor.parameter_reader.which_matter import matters
from swifttailor.pattern import Severity, check_pattern
from swifttailor.programs import DESIGN_PARAMETERS


def test_they_are_complete_sound_and_the_same_again():
    found = list(islice(drawn_designs(5), 30))
    again = list(islice(drawn_designs(5), 30))
    assert [design for design, _ in found] == [design for design, _ in again]
    for design, pattern in found:
        assert design.keys() == DESIGN_PARAMETERS.keys()
        assert all(f.severity != Severity.ERROR for f in check_pattern(pattern))
    kinds = {(design["meta.upper"], design["meta.bottom"]) for design, _ in found}
    assert len(kinds) >= 8, "tops, skirts, trousers and dresses"
    assert {name for design, _ in found for name in matters(design)} > {"sleeve.length", "pants.length"}
