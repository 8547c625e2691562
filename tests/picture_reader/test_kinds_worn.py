"""Kinds of garments are as often as people wear them."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.picture_reader.kinds_worn import KINDS, kinds_as_worn
from swifttailor.picture_reader.labels import PARTS, statement_labels
from swifttailor.picture_reader.said import share_of

LABELS = statement_labels()
KIND = [k for k, (claim, _) in enumerate(LABELS) if claim == "kind"]
WORDS = [LABELS[k][1] for k in KIND]


def answers(**shares):
    """The same of both parts: shares of kinds, and of all else one half."""
    statements = np.zeros((len(PARTS), len(LABELS)))
    for word, share in zip(WORDS, (shares.get(w, 0.01) for w in WORDS), strict=True):
        statements[:, LABELS.index(("kind", word))] = np.log(share / (1 - share))
    return {"statements": statements, "present": np.ones(2)}


@pytest.mark.parametrize(
    ("skirt", "trousers", "likeliest"),
    [(0.77, 0.17, "trousers"), (0.86, 0.13, "trousers"), (0.95, 0.03, "skirt"), (0.1, 0.9, "trousers")],
)
def test_skirts_have_to_be_seen_better_than_trousers(skirt, trousers, likeliest):
    found = kinds_as_worn(answers(skirt=skirt, trousers=trousers))["statements"]
    lower = dict(zip(WORDS, found[PARTS.index("lower"), KIND], strict=True))
    assert max(lower, key=lower.__getitem__) == likeliest
    upper = found[PARTS.index("upper"), KIND]
    assert WORDS[int(upper.argmax())] == max(("skirt", skirt), ("trousers", trousers), key=lambda p: p[1])[0]


def test_the_odds_may_go_half_of_the_way():
    shares = answers(skirt=0.5, trousers=0.4)
    logits = [kinds_as_worn(shares, how_far)["statements"][PARTS.index("lower")] for how_far in (0, 0.5, 1)]
    skirt, trousers = (LABELS.index(("kind", word)) for word in ("skirt", "trousers"))
    ratios = [np.log(share_of(one[skirt]) / share_of(one[trousers])) for one in logits]
    assert ratios[0] == pytest.approx(np.log(0.5 / 0.4)) and ratios[1] == pytest.approx(
        (ratios[0] + ratios[2]) / 2
    )


def test_what_could_not_be_surer_still_has_logits():
    shares = answers()
    shares["statements"][:, KIND] = [60.0, *[-60.0] * (len(KIND) - 1)]
    assert np.isfinite(kinds_as_worn(shares)["statements"]).all()


@given(st.lists(st.floats(0.01, 0.6), min_size=len(WORDS), max_size=len(WORDS)))
def test_kinds_alone_change_by_their_odds_and_keep_their_sum(shares):
    given_ = answers(**dict(zip(WORDS, shares, strict=True)))
    found = kinds_as_worn(given_)
    others = [k for k in range(len(LABELS)) if k not in KIND]
    assert (found["statements"][:, others] == given_["statements"][:, others]).all()
    assert found["present"] is given_["present"]
    for number, part in enumerate(PARTS):
        before, after = (share_of(a["statements"][number, KIND]) for a in (given_, found))
        assert after.max() <= max(before.max(), 0.98) + 1e-9
        if after.max() < 0.979:
            assert after.sum() == pytest.approx(before.sum())
        rare = np.array([word in KINDS[part] for word in WORDS])
        usual = after[~rare] / before[~rare]
        assert np.ptp(usual) <= 1e-9 * usual.max()
        for k in np.flatnonzero(rare):
            drawn, worn = KINDS[part][WORDS[k]]
            ratio = worn / (1 - worn) * (1 - drawn) / drawn
            assert after[k] / before[k] == pytest.approx(ratio * usual[0])
