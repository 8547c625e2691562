"""Drafts of design parameters that are read come before known patterns."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from own_library import library_of
from scripted_maker import scripted_maker
from seeing import Seeing, worn

from swifttailor.describing.claims import Claim
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import InputError, NothingAskedError
from swifttailor.parameter_reader.reader import ParameterReader
from swifttailor.pattern.drafts import draft
from swifttailor.picture_reader.seen_design import SeenDesign
from swifttailor.programs.read_parameter import ReadParameter
from swifttailor.tailor import Order, Tailor

CHOICES = (
    ReadParameter("meta.bottom", ("PencilSkirt", "SkirtCircle")),
    ReadParameter("pencil-skirt.length", (0.4, 0.8), (0.6,)),
    ReadParameter("meta.wb", ("StraightWB", None)),
    ReadParameter("flare-skirt.suns", (0.5, 1.9), (1.0,)),
)
PICTURE = np.full((64, 64, 3), 200, np.uint8)


class Says:
    """Logits that are always the same."""

    def __init__(self, *logits: float):
        self.logits = np.array([logits], np.float32)

    def run(self, names, given):
        return [self.logits]


def designer(*logits: float) -> ParameterReader:
    return ParameterReader(Says(*logits), CHOICES, {"model": "ParameterReader"})


PENCIL = (9.0, 0.0, 9.0, 0.0, 9.0, 0.0, 9.0, 0.0)
"""A pencil skirt, short, with a waistband."""


@pytest.fixture
def eyes():
    return Seeing((worn("lower", {"kind": ("skirt", 0.99), "skirt_hem": ("midi", 0.97)}),))


@pytest.fixture
def library(tmp_path):
    return library_of({"midi": draft("fitted-skirt", length=75.0)}, tmp_path)


def tailor_of(sewer, eyes, reader, library=None) -> Tailor:
    maker = scripted_maker([draft("fitted-dress")])
    return Tailor(maker, sewer, picture_reader=eyes, parameter_reader=reader, pattern_library=library)


def test_what_is_read_is_drafted_cut_and_said(sewer, eyes, tmp_path):
    made = tailor_of(sewer, eyes, designer(*PENCIL)).generate(image=PICTURE)
    assert made.answer.design is not None and not made.answer.known
    panels = [panel.name for panel in made.pattern.panels]
    assert {"skirt_front", "skirt_back", "wb_front", "wb_back"} <= set(panels)
    writing = made.report["writing"]
    assert writing["source"] == "design" and writing["attempt"] == 1
    assert (
        writing["design"]["meta.bottom"] == "PencilSkirt" and writing["design"]["pencil-skirt.length"] == 0.4
    )
    assert "flare-skirt.suns" not in writing["design"], "of a pencil skirt it does not matter"
    assert "parameter_reader" in made.report["weights"] and "pattern_maker" not in made.report["weights"]
    assert any("design parameters" in note for note in made.notes)
    hem = [w for w in made.report["wishes"] if "midi" in w["wish"] or "calf" in w["wish"]]
    assert made.report["wishes"] and all(w["holds"] for w in hem), "it was drafted too short, and cut"
    made.save(tmp_path, preview=False)


def test_what_the_picture_shows_of_a_design_is_drafted(sewer):
    part = worn("lower", {"kind": ("skirt", 0.99)})
    shares = {"meta.bottom": [0.02, 0.98], "flare-skirt.suns": [0.99, 0.01]}
    shown = tuple(one for one in CHOICES if one.name in shares)
    seen = SeenDesign(shown, tuple(np.array(shares[one.name]) for one in shown))
    unsure = designer(0.5, 0.0, 9.0, 0.0, 9.0, 0.0, 0.0, 0.1)
    designs = [
        tailor_of(sewer, Seeing((one,)), unsure).generate(image=PICTURE, refine=0).answer.design
        for one in (part, replace(part, design=seen))
    ]
    assert [one["meta.bottom"] for one in designs] == ["PencilSkirt", "SkirtCircle"]
    assert designs[1]["flare-skirt.suns"] == 0.5 and designs[1]["meta.wb"] == "StraightWB"


@pytest.mark.parametrize(("certainty", "cut"), [(0.93, False), (0.98, True)])
def test_a_draft_is_cut_only_to_what_is_all_but_certain(sewer, library, certainty, cut):
    eyes = Seeing((worn("lower", {"kind": ("skirt", 0.99), "skirt_hem": ("midi", certainty)}),))
    drafted = tailor_of(sewer, eyes, designer(*PENCIL)).generate(image=PICTURE, refine=0)
    hem = measure_facts(drafted.pattern)
    assert Claim("skirt_hem", "midi").holds(hem) is cut
    assert not drafted.answer.verdict.open, "what the draft speaks against is no wish that is not met"
    seen = [*drafted.report["wishes"], *drafted.report["pictures"]["likely"]]
    assert any("midi" in str(wish) or "calf" in str(wish) for wish in seen), "it is said all the same"
    said = [note for note in drafted.notes if "spoke against" in note]
    assert len(said) == (not cut) and all("midi" in note for note in said)
    known = tailor_of(sewer, eyes, None, library).generate(image=PICTURE, refine=0)
    assert Claim("skirt_hem", "midi").holds(measure_facts(known.pattern)), "known patterns are cut to it"


def test_one_of_several_sources_can_be_chosen(sewer, eyes, library):
    tailor = tailor_of(sewer, eyes, designer(*PENCIL), library)
    assert tailor.generate(image=PICTURE, source="designs").answer.design is not None
    assert tailor.generate(image=PICTURE, source="library").answer.known == "midi"
    written = tailor.generate(image=PICTURE, source="writer", attempts=1).answer
    assert written.design is None and not written.known
    named = tailor.generate("a midi office skirt").answer
    assert named.design is None and named.draft, "what words name begins from a draft of ours"
    assert tailor.generate("a midi office skirt", source="library").answer.known == "midi"
    assert tailor.generate("a midi skirt", source="designs").answer.design is not None
    both = tailor.generate("a midi skirt", image=PICTURE).answer
    assert both.design is not None and not both.verdict.open, "a draft, cut to the words"
    with pytest.raises(NothingAskedError, match="no word of it is known"):
        tailor.generate("zzz", source="designs")
    with pytest.raises(InputError, match="Drafts of designs are there to be altered"):
        Order("longer", edit=draft("t-shirt"), source="designs")


def test_a_design_that_is_refused_is_followed_by_another(sewer, eyes, library):
    # The likeliest is a double circle without an upper part, which would slide down.
    heavy = designer(-0.2, 0.0, 9.0, 0.0, 0.0, 0.2, 0.0, 9.0)
    answer = tailor_of(sewer, eyes, heavy, library).generate(image=PICTURE).answer
    assert answer.design is not None
    assert answer.design["meta.bottom"] == "PencilSkirt"


def test_where_no_design_is_accepted_known_patterns_are_taken(sewer, eyes, library):
    never = designer(-40.0, 0.0, 9.0, 0.0, -40.0, 0.0, 0.0, 9.0)
    assert tailor_of(sewer, eyes, never, library).generate(image=PICTURE).answer.known == "midi"


def test_edits_and_what_is_not_altered_are_not_drafted(sewer, eyes):
    tailor = tailor_of(sewer, eyes, designer(*PENCIL))
    assert tailor.edit(draft("fitted-skirt"), "make it longer", attempts=1).answer.design is None
    assert tailor.generate(image=PICTURE, alter=False, attempts=1).answer.design is None


def test_of_several_garments_each_has_a_design_of_its_own(sewer, eyes):
    open_choice = designer(0.1, 0.0, 9.0, 0.0, 9.0, 0.0, 9.0, 0.0)
    made = tailor_of(sewer, eyes, open_choice).make(Order(image=PICTURE, samples=6, refine=0))
    kinds = {one.answer.design["meta.bottom"] for one in made}
    assert kinds == {"PencilSkirt", "SkirtCircle"}


def test_a_writer_of_your_own_is_not_passed_by(sewer):
    assert Tailor(scripted_maker([draft("fitted-skirt")]), sewer).parameter_reader is None


class Unasked:
    """Must not be asked."""

    def run(self, names, given):
        raise AssertionError("it was asked for nothing")


DESCRIBED = "narrow, to the middle of the calf, with a waistband"


def test_where_the_draft_that_words_name_fails_a_read_design_is_next(sewer, library):
    made = tailor_of(sewer, None, designer(*PENCIL), library).generate(DESCRIBED).answer
    assert made.design is not None and made.design["meta.bottom"] == "PencilSkirt"
    assert not made.verdict.open and made.attempt == 1 and made.failures[0]
    assert tailor_of(sewer, None, None, library).generate(DESCRIBED).answer.known == "midi"


def test_nothing_is_looked_up_where_the_first_draft_will_do(sewer, monkeypatch):
    monkeypatch.setattr("swifttailor.tailor.offers.designed_candidate", Unasked().run)
    monkeypatch.setattr("swifttailor.tailor.offers.CountedCandidate", Unasked().run)
    made = Tailor(garment_sewer=sewer).generate("a midi pencil skirt").answer
    assert made.draft and made.attempt == 0
