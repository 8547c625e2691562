"""Known patterns are tried before any is written."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np
import pytest
from own_library import library_of
from scripted_maker import scripted_maker
from seeing import Seeing, worn

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.errors import InputError, NothingAskedError
from swifttailor.pattern.drafts import draft
from swifttailor.pattern_library.known import PatternLibrary
from swifttailor.pattern_library.nearest import Search
from swifttailor.pattern_library.sought import Sought
from swifttailor.picture_reader.labels import statement_labels
from swifttailor.tailor import Order, Tailor
from swifttailor.tailor.known import KNOWN_ATTEMPTS, KnownCandidates
from swifttailor.tailor.orders_read import read_order
from swifttailor.wishes.reader import Wish

DRAFTS = {
    "mini": draft("fitted-skirt", length=40.0),
    "midi": draft("fitted-skirt", length=75.0),
    "midi again": draft("fitted-skirt", length=75.5),
    "shirt": draft("t-shirt"),
    "trousers": draft("trousers"),
}
WRITTEN = draft("fitted-dress")


class Darts:
    """Understands one thing, which no cutting makes and no known pattern has."""

    card: ClassVar[dict[str, Any]] = {}

    def read(self, text, *, instruction):
        return (Wish(Gain(Claim("bodice", "darted")), 0.97),)

    def whole(self, text, *, instruction=True):
        return {}


@pytest.fixture(scope="module")
def library(tmp_path_factory) -> PatternLibrary:
    return library_of(DRAFTS, tmp_path_factory.mktemp("known"))


@pytest.fixture
def tailor(library, sewer):
    return Tailor(scripted_maker([WRITTEN]), sewer, pattern_library=library)


def test_what_is_asked_for_is_found_and_said(tailor, tmp_path):
    made = tailor.generate("a midi skirt", source="library")
    assert made.answer.known in ("midi", "midi again") and made.answer.attempt == 0
    assert made.report["writing"] == {
        "source": "library",
        "known_pattern": made.answer.known,
        "attempt": 1,
        "failed_attempts": [],
    }
    assert f"Cut from a known pattern: {made.answer.known}." in made.notes
    assert "pattern_maker" not in made.report["weights"] and "pattern_library" in made.report["weights"]
    assert made.pattern.name == "a midi skirt"
    assert "searching" in made.seconds and "writing" not in made.seconds
    made.save(tmp_path, preview=False)


def test_where_none_will_do_a_pattern_is_written(library, sewer):
    tailor = Tailor(scripted_maker([WRITTEN]), sewer, pattern_library=library, wish_reader=Darts())
    made = tailor.generate("a wuzzle", attempts=KNOWN_ATTEMPTS + 1)
    assert not made.answer.known and made.answer.attempt == KNOWN_ATTEMPTS
    assert made.report["writing"]["source"] == "writer" and len(made.answer.failures) == KNOWN_ATTEMPTS
    assert tailor.pattern_maker.model.runtime.asked == [1]


def test_one_source_can_be_chosen(tailor):
    assert not tailor.generate("a midi skirt", source="writer", attempts=1).answer.known
    found = tailor.generate("long trousers", source="library")
    assert found.answer.known and tailor.pattern_maker.model.runtime.asked == [1]
    with pytest.raises(NothingAskedError, match="no word of it is known"):
        tailor.generate("zzz", source="library")
    with pytest.raises(InputError, match="both, drafts, designs, library, writer are accepted"):
        Order("a skirt", source="shop")
    with pytest.raises(InputError, match="not for edits"):
        Order("longer", edit=DRAFTS["mini"], source="library")


def test_edits_are_written_and_so_is_what_is_not_altered(tailor):
    assert not tailor.generate("zzz", source="writer", attempts=1).answer.known
    assert not tailor.generate("a midi skirt", alter=False, attempts=1).answer.known
    assert not tailor.edit(DRAFTS["mini"], "make it longer", attempts=1).answer.known


def test_a_writer_of_your_own_writes_them_all(sewer):
    tailor = Tailor(scripted_maker([DRAFTS["mini"]]), sewer)
    assert tailor.pattern_library is None
    assert not tailor.generate("a midi skirt").answer.known


def test_seeds_choose_among_those_that_fit_as_well(library, tailor):
    seen = [made.answer.known for made in tailor.make(Order("a midi skirt", samples=4, source="library"))]
    assert len(set(seen)) == 4 and set(seen[:2]) == {"midi", "midi again"}
    cold = {
        tailor.generate("a midi skirt", temperature=0.0, seed=k, source="library").answer.known
        for k in range(3)
    }
    assert len(cold) == 1
    search = Search(library, Sought.nothing())
    search.fits = np.array([-9.0, -1.0, -2.5, 0.0, -50.0])
    orders = [
        [KnownCandidates(search, seed=seed, temperature=0.2, most=5).take(k).known for k in range(5)]
        for seed in range(5)
    ]
    assert orders[0] == ["shirt", "midi", "midi again", "mini", "trousers"]
    assert orders[1] == ["midi", "midi again", "mini", "shirt", "trousers"], "at least four are as good"
    assert orders[4] == orders[0]
    search.fits = np.array([-0.1, -1.0, -1.5, 0.0, -1.8])
    assert {KnownCandidates(search, seed=s, temperature=0.2, most=1).take(0).known for s in range(5)} == set(
        DRAFTS
    )


def test_a_picture_is_looked_up_by_what_was_read_of_it(library, sewer):
    eyes = Seeing((worn("lower", {"kind": ("skirt", 0.99), "skirt_hem": ("midi", 0.97)}),))
    tailor = Tailor(scripted_maker([WRITTEN]), sewer, picture_reader=eyes, pattern_library=library)
    picture = np.full((64, 64, 3), 200, np.uint8)
    assert tailor.generate(image=picture).answer.known in ("midi", "midi again")
    overruled = tailor.generate("a mini skirt", image=picture)
    assert overruled.answer.known == "mini"


def test_what_nobody_speaks_of_is_sought_as_it_is_usual(tailor):
    """No uneven hems for those who ask for none."""

    def likely(text, **given):
        sought = read_order(Order(text, **given), tailor.wish_reader).sought
        number = statement_labels().index(("hem_shape", "level"))
        return float(sought.statements[number]), float(sought.said[number])

    assert likely("a midi skirt")[0] == pytest.approx(0.8) and likely("a midi skirt")[1] > 0
    assert likely("a midi skirt with a high-low hem")[0] < 0.8


def test_panels_are_foreseen_from_words_where_known_patterns_are_asked(library, sewer):
    """By the writer's own network; what nobody foresees is left open."""
    ours, theirs = (
        Tailor(pattern_library=library),
        Tailor(scripted_maker([WRITTEN]), sewer, pattern_library=library),
    )
    assert ours.read(Order("a midi skirt")).sought.named.min() > 0
    assert not theirs.read(Order("a midi skirt")).sought.named.any()
    for order in (
        Order("a midi skirt", source="writer"),
        Order("make it shorter", edit=DRAFTS["midi"]),
        Order("a midi skirt", alter=False),
    ):
        assert ours.read(order).foresight is None
