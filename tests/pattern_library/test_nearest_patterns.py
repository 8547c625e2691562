"""Searching a library: the vectorised numbers are the plain ones, and what is asked for is found."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from plain_fit import plain_fit

from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.pattern_library.nearest import CHOSEN, Search, Weights, alike, log_likelihoods, nearest
from swifttailor.pattern_library.sought import (
    ASKED,
    BESIDE_PICTURE,
    FORESEEN,
    FORESEEN_BESIDE_PICTURE,
    SURE,
    UNTOLD,
    UNTOLD_PANEL,
    WORDS,
    Sought,
)
from swifttailor.picture_reader.labels import BOX, measure_labels, statement_labels
from swifttailor.picture_reader.reading import Measure, PartReading, SeenPanel, Statement
from swifttailor.picture_reader.truth import TRUE
from swifttailor.wishes.reader import Wish

S, M, P = len(statement_labels()), len(measure_labels()), len(PANEL_NAMES)


def random_sought(seed: int) -> Sought:
    chance = np.random.default_rng(seed)

    def share(n):
        return chance.uniform(0.01, 0.99, n).astype(np.float32)

    def some(n):
        return (chance.random(n) * (chance.random(n) < 0.6)).astype(np.float32)

    measured = np.stack([chance.normal(0, 2, M), chance.uniform(0.001, 1, M)], axis=1)
    boxes = chance.normal(0, 60, (P, len(BOX)))
    return Sought(
        share(S),
        some(S),
        share(M),
        measured.astype(np.float32),
        some(M),
        share(P),
        some(P),
        boxes.astype(np.float32),
        some(P),
    )


def reading(**given) -> PartReading:
    values = {
        "statements": (Statement(Claim("neckline", "v"), 0.9), Statement(Claim("sleeves", "long"), 0.6)),
        "measures": (Measure("length", 90.0, 5.0, 0.95),),
        "panels": (SeenPanel("left_ftorso", 0.8, (1.0, 120.0, 25.0, 30.0, 40.0)),),
    }
    return PartReading("upper", 0.99, mask=np.zeros((2, 2), np.float32), **(values | given))


@given(st.integers(0, 2**31))
@settings(max_examples=25)
def test_the_numbers_are_those_of_the_plain_formulas(library, seed):
    sought, weights = random_sought(seed), Weights(0.7, 1.3, 2.0, 0.4)
    found = log_likelihoods(library.table, sought, weights)
    expected = [plain_fit(library.table[k], sought, weights) for k in range(len(library))]
    np.testing.assert_allclose(found, expected, rtol=1e-4, atol=1e-2)


def test_a_pattern_is_nearest_to_what_is_true_of_it(library, truths):
    for k, truth in enumerate(truths):
        best = nearest(library, Sought.of_truth(truth), 3)
        assert best[0].number == k
        assert best[0].id == best[0].pattern.name == library.ids[k]
        assert best[0].fit > best[1].fit >= best[2].fit


def test_any_pattern_is_judged_by_the_same_number(library):
    search = Search(library, Sought.of_claims([Claim("kind", "dress"), Claim("sleeves", "none")]))
    for k in range(0, len(library), 3):
        assert search.fit_of(library.table[k]) == pytest.approx(search.fits[k], abs=0.05)


def test_what_is_usual_counts_where_no_panels_are_known(library, truths):
    words, picture = Sought.of_claims([Claim("kind", "dress")]), Sought.of_truth(truths[0])
    assert Search(library, picture).usual is None
    np.testing.assert_array_equal(
        Search(library, picture).fits, log_likelihoods(library.table, picture, CHOSEN)
    )
    fits = log_likelihoods(library.table, words, CHOSEN)
    usual = alike(library.table, fits + np.log(library.stands_for + 1.0))
    expected = fits + CHOSEN.alike * log_likelihoods(library.table, usual, CHOSEN)
    np.testing.assert_allclose(Search(library, words).fits, expected, rtol=1e-6)


def test_how_common_patterns_are_decides_what_is_usual(library):
    """Where one pattern stands for very many garments, what is not said is as in that one."""
    sought = Sought.of_claims([Claim("sleeves", "none")])
    fits = log_likelihoods(library.table, sought)
    candidates = np.flatnonzero(fits == fits.max())
    assert len(candidates) > 2
    for k in candidates[:4]:
        stands = np.zeros(len(library), np.int64)
        stands[k] = 10**9
        assert Search(replace(library, stands_for=stands), sought).nearest()[0].number == k


def test_what_is_asked_for_is_found(library):
    for claim in (Claim("kind", "trousers"), Claim("hood", "hood"), Claim("sleeves", "long")):
        number = statement_labels().index((claim.name, claim.value))
        assert (library.table.statements[:, number] == TRUE).any()
        best = Search(library, Sought.of_claims([claim])).nearest()[0]
        assert library.table.statements[best.number, number] == TRUE


def test_of_those_that_fit_the_common_one_is_taken(library):
    """Of what is not said, that is likely which most garments of this kind have."""
    number = statement_labels().index(("kind", "dress"))
    fits = log_likelihoods(library.table, Sought.of_claims([Claim("kind", "dress")]))
    usual = alike(library.table, fits)
    dresses = library.table.statements[:, number] == TRUE
    assert usual.statements[number] == pytest.approx(SURE)
    share = library.table.panels[dresses].mean(axis=0)
    np.testing.assert_allclose(usual.panels, np.clip(share, 1 - SURE, SURE), atol=0.02)
    certain = share > 0.99
    np.testing.assert_allclose(
        usual.boxes[certain],
        [np.mean([library.table[k].boxes[n] for k in np.flatnonzero(dresses)], axis=0)
         for n in np.flatnonzero(certain)],
        atol=0.5,
    )  # fmt: skip


def test_without_anything_sought_all_fit_alike(library):
    nothing = Sought.nothing()
    assert nothing.is_empty
    assert not log_likelihoods(library.table, nothing).any()
    assert not Sought.of_claims([Claim("hood", "none")]).is_empty


def test_what_a_picture_shows():
    sought = Sought.of_reading(reading())
    of = {label: k for k, label in enumerate(statement_labels())}
    assert sought.statements[of["neckline", "v"]] == pytest.approx(0.9)
    assert sought.statements[of["neckline", "round"]] == pytest.approx(UNTOLD)
    length = measure_labels().index("length")
    assert np.sinh(sought.measured[length, 0]) * 10 == pytest.approx(90.0, rel=1e-4)
    # Half of such measures are off by at most 5 cm: that is the median of a Laplace distribution.
    width_cm = sought.measured[length, 1] * np.hypot(90.0, 10.0)
    assert width_cm * np.log(2) == pytest.approx(5.0, rel=1e-3)
    panel = PANEL_NAMES.index("left_ftorso")
    assert sought.panels[panel] == pytest.approx(0.8)
    assert sought.panels[panel + 1] == pytest.approx(UNTOLD_PANEL)
    assert tuple(sought.boxes[panel]) == (1.0, 120.0, 25.0, 30.0, 40.0)
    assert sought.placed.sum() == pytest.approx(0.8)


def test_what_words_ask_for():
    wishes = [Wish(Gain(Claim("hood", "hood")), 0.95), Wish(Gain(Claim("length_cm", 100.0)), 1.0)]
    sought = Sought.of_words([*wishes, Wish(Step("length", 1), 0.9)])
    assert sought.said.sum() == sought.measures.sum() == WORDS
    hood = statement_labels().index(("hood", "hood"))
    assert (sought.said[hood], sought.statements[hood]) == (WORDS, pytest.approx(0.95))
    length = measure_labels().index("length")
    assert sought.has[length] == pytest.approx(ASKED)
    assert not sought.named.any()
    assert not sought.placed.any()


def test_words_outrank_the_picture():
    """Of a claim that words speak of, nothing is left of what the picture says of it."""
    seen = Sought.of_reading(reading())
    wishes = [Wish(Gain(Claim("neckline", "round")), 0.97), Wish(Gain(Claim("length_cm", 60.0)), 1.0)]
    both = Sought.of(reading(), wishes)
    asked = Sought.of_words(wishes)
    for k, (claim, _) in enumerate(statement_labels()):
        spoken = claim == "neckline"
        source, counts = (asked, BESIDE_PICTURE / WORDS) if spoken else (seen, 1.0)
        assert (both.statements[k], both.said[k]) == (source.statements[k], source.said[k] * counts)
    length = measure_labels().index("length")
    assert both.measured[length, 0] == pytest.approx(np.arcsinh(6.0), rel=1e-5)
    np.testing.assert_array_equal(both.panels, seen.panels)
    np.testing.assert_array_equal(Sought.of(None, wishes).said, asked.said)
    np.testing.assert_array_equal(Sought.of(reading()).said, seen.said)


@given(st.integers(0, 2**31), st.floats(0.1, 5))
@settings(max_examples=25)
def test_what_is_foreseen_of_panels_is_added_to_what_is_known(library, seed, weight):
    """As of independent witnesses: the sum of both log likelihoods, but for what all patterns share."""
    sought, odds = random_sought(seed), np.random.default_rng(seed).uniform(-4, 4, P)
    alone = Sought.nothing().with_panels(odds, weight)
    assert alone.named.min() == alone.named.max() == pytest.approx(weight)
    np.testing.assert_allclose(alone.panels, 1 / (1 + np.exp(-odds)), rtol=1e-4)
    both = log_likelihoods(library.table, sought.with_panels(odds, weight), CHOSEN)
    apart = log_likelihoods(library.table, sought, CHOSEN) + log_likelihoods(library.table, alone, CHOSEN)
    np.testing.assert_allclose(both - both[0], apart - apart[0], atol=2e-2)


def test_no_panel_that_is_foreseen_is_beyond_doubt():
    certain = Sought.nothing().with_panels(np.where(np.arange(P) % 2, 50.0, -50.0), 1.0).panels
    np.testing.assert_allclose(certain, np.where(np.arange(P) % 2, 0.99, 0.01), atol=1e-3)


def test_panels_foreseen_count_less_beside_a_picture():
    odds, wishes = np.full(P, 3.0), [Wish(Gain(Claim("neckline", "round")), 0.97)]
    words, both = Sought.of(None, wishes, foreseen=odds), Sought.of(reading(), wishes, foreseen=odds)
    assert words.named.max() == FORESEEN and not words.placed.any()
    np.testing.assert_array_equal(both.named, Sought.of_reading(reading()).named + FORESEEN_BESIDE_PICTURE)
    assert (both.panels > Sought.of_reading(reading()).panels).any()


def test_words_decide_between_patterns_that_a_picture_shows_alike(library, truths):
    """Shown one pattern and asked for what another has, a pattern is found that has it."""
    number = statement_labels().index(("hood", "hood"))
    hooded = library.table.statements[:, number] == TRUE
    assert hooded.any()
    bare = next(k for k, t in enumerate(truths) if t.part == 0 and not hooded[k])
    seen = Sought.of_truth(truths[bare])
    asked = seen.outranked_by(Sought.of_claims([Claim("hood", "hood")]))
    before, after = (log_likelihoods(library.table, s, CHOSEN) for s in (seen, asked))
    gained = after - before
    assert gained[hooded].min() > gained[~hooded].max()


def test_parts_of_what_is_sought(library, truths):
    full = Sought.of_truth(truths[0])
    for name in ("statements", "measures", "panels", "boxes"):
        flags = dict.fromkeys(("statements", "measures", "panels", "boxes"), False) | {name: True}
        only = full.only(**flags)
        weights = Weights(**{**dict.fromkeys(flags, 0.0), name: 1.0})
        np.testing.assert_allclose(
            log_likelihoods(library.table, only, Weights(1.0, 1.0, 1.0, 1.0)),
            log_likelihoods(library.table, full, weights),
            rtol=1e-5,
        )
