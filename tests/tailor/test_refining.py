"""Looking again: the garment that lies where the picture shows it is taken."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from own_library import library_of
from scripted_maker import scripted_maker
from seeing import Seeing, worn

from swifttailor.errors import InputError
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.pattern.drafts import draft
from swifttailor.pattern_library.known import PatternLibrary
from swifttailor.pattern_library.nearest import Search
from swifttailor.pattern_library.sought import Sought
from swifttailor.picture_reader.reading import SeenCells
from swifttailor.tailor import Order, Tailor, refining
from swifttailor.tailor.likeness import can_be_compared, distance_cm
from swifttailor.tailor.looking import look_at

SKIRTS = {f"{length:g} cm": draft("fitted-skirt", length=length) for length in (60.0, 64.0, 68.0, 72.0)}
PICTURE = np.full((64, 64, 3), 200, np.uint8)
SEEN = worn("lower", {"kind": ("skirt", 0.99)})
CELLS = 24


def cells_of(vertices: np.ndarray) -> SeenCells:
    """As a reader would see a garment on the lower body: some of its places."""
    mask, places = np.zeros((CELLS, CELLS), np.float32), np.zeros((CELLS, CELLS, 3), np.float32)
    chosen = vertices[np.random.default_rng(0).choice(len(vertices), CELLS * 12, replace=False)]
    mask[:12] = 1.0
    places[:12] = chosen.reshape(12, CELLS, 3)
    return SeenCells((0, 0, 64, 64), mask, places, np.zeros((CELLS, CELLS), np.uint8))


@pytest.fixture(scope="module")
def library(tmp_path_factory) -> PatternLibrary:
    return library_of(SKIRTS, tmp_path_factory.mktemp("known"))


def tailor(sewer: GarmentSewer, library: PatternLibrary, cells: SeenCells | None) -> Tailor:
    eyes = Seeing((SEEN,), cells=cells)
    return Tailor(scripted_maker([draft("t-shirt")]), sewer, picture_reader=eyes, pattern_library=library)


@pytest.mark.parametrize("name", SKIRTS)
def test_of_garments_that_do_the_one_like_the_picture_is_taken(sewer, library, name, monkeypatch):
    monkeypatch.setattr(refining, "CM_WORTH", 1e3)  # places alone
    shown = sewer.sew(SKIRTS[name]).vertices
    asked = tailor(sewer, library, cells_of(shown))
    for seed in (0, 5):
        made = asked.generate(image=PICTURE, seed=seed)
        assert made.answer.known == name, "whatever the seed"
    found = made.report["writing"]["refinement"]
    assert found["compared"] == 4 and found["distance_cm"] <= found["first_distance_cm"]
    assert found["distance_cm"] < 2.5
    assert any("compared with the picture" in note for note in made.notes)
    assert "refining" in made.seconds


def test_how_well_patterns_fit_what_was_read_counts_too(sewer, library, monkeypatch):
    search = Search(library, Sought.of_reading(SEEN))
    best = library.ids[int(np.argmax(search.fits))]
    other = next(name for name in SKIRTS if name != best)
    asked = tailor(sewer, library, cells_of(sewer.sew(SKIRTS[other]).vertices))
    monkeypatch.setattr(refining, "CM_WORTH", 1e-6)
    assert asked.generate(image=PICTURE).answer.known == best
    monkeypatch.setattr(refining, "CM_WORTH", 1e3)
    assert asked.generate(image=PICTURE).answer.known == other


def test_several_samples_are_those_that_are_most_alike(sewer, library, monkeypatch):
    monkeypatch.setattr(refining, "CM_WORTH", 1e3)
    asked = tailor(sewer, library, cells_of(sewer.sew(SKIRTS["60 cm"]).vertices))
    made = asked.make(Order(image=PICTURE, samples=4, seed=3))
    assert [one.answer.known for one in made] == ["60 cm", "64 cm", "68 cm", "72 cm"]


def test_nothing_is_compared_where_that_is_not_wanted_or_not_possible(sewer, library):
    cells = cells_of(sewer.sew(SKIRTS["60 cm"]).vertices)
    none = tailor(sewer, library, cells).generate(image=PICTURE, refine=0)
    assert none.answer.refinement is None and "refining" not in none.seconds
    few = replace(cells, mask=cells.mask * (np.arange(CELLS * CELLS).reshape(CELLS, CELLS) < 5))
    for unclear in (None, few):
        assert tailor(sewer, library, unclear).generate(image=PICTURE).answer.refinement is None
    written = tailor(sewer, library, cells).generate(image=PICTURE, source="writer", attempts=1)
    assert written.answer.refinement is None and not written.answer.known
    for bad, message in ((-1, "0 to 32"), (33, "0 to 32")):
        with pytest.raises(InputError, match=message):
            Order(image=PICTURE, refine=bad)
    with pytest.raises(InputError, match="no picture to compare with"):
        Order("a skirt", refine=3)


def test_distances_are_those_of_what_the_picture_shows(sewer):
    shown = sewer.sew(SKIRTS["60 cm"]).vertices
    lower = worn("lower", {"kind": ("skirt", 0.99)}, covers=0.7)
    picture = look_at(PICTURE, Seeing((lower,), cells=cells_of(shown)))
    assert can_be_compared([picture], "lower") and not can_be_compared([picture], "upper")
    same = distance_cm([picture], "lower", shown)
    assert same < 1.5
    for cm in (5.0, 10.0, 20.0):
        aside, behind = (shown + np.array(by) for by in ((cm, 0.0, 0.0), (0.0, 0.0, cm)))
        assert same + 0.1 * cm < distance_cm([picture], "lower", aside) < same + cm
        assert abs(distance_cm([picture], "lower", behind) - same) < 1e-6, "it is seen from in front"
    assert distance_cm([picture, picture], "lower", shown) == pytest.approx(same)
    longer = np.concatenate([shown, shown - np.array([0.0, 60.0, 0.0])])
    cut_off = look_at(PICTURE, Seeing((worn("lower", {}, covers=1.0),), cells=cells_of(shown)))
    assert distance_cm([picture], "lower", longer) > same + 5
    assert distance_cm([cut_off], "lower", longer) < same + 1.5, "what lies below the picture is not seen"
