"""Whether patterns are what prompts ask for."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.data.edits.pairs import pairs_of
from swifttailor.describing import Claim, claims_of, measure_facts
from swifttailor.errors import InputError, PatternError
from swifttailor.evaluation.patterns import judge_claims, judge_instructions
from swifttailor.evaluation.patterns.adherence import Share, adherence_table, by_chance
from swifttailor.pattern import Edge, Panel, Pattern
from swifttailor.pattern.drafts import draft
from swifttailor.wording.captions import write_caption

NAMES = ("t-shirt", "fitted-skirt", "trousers", "shirt-dress")


@pytest.fixture(scope="module")
def patterns() -> list[Pattern]:
    return [draft(name) for name in NAMES]


@pytest.fixture(scope="module")
def prompts(patterns) -> list[tuple[Claim, ...]]:
    return [write_caption(p, seed=k).claims for k, p in enumerate(patterns)]


def test_captions_hold_of_what_they_were_written_from(patterns, prompts):
    found = judge_claims(prompts, patterns)
    made = sum(map(len, prompts))
    assert found.claims == Share(made, made) and made > 12
    assert found.whole == Share(4, 4) and found.unmeasured == 0
    assert sum(share.made for share in found.kinds.values()) == made
    assert all(share.share == 1 for share in found.kinds.values())


def test_and_not_of_other_garments(patterns, prompts):
    found = by_chance(prompts, patterns)
    assert found.claims.made == sum(map(len, prompts)) and found.whole.held == 0
    kinds = found.kinds["kind"]
    assert kinds.share == 0
    assert found == judge_claims(prompts, patterns[1:] + patterns[:1])


def test_each_claim_is_judged_by_the_pattern(patterns):
    skirt = measure_facts(patterns[1])
    right = claims_of(skirt)[:5]
    wrong = tuple(c for c in claims_of(measure_facts(patterns[0])) if not c.holds(skirt))[:3]
    assert len(wrong) == 3
    found = judge_claims([(*right, *wrong)], [patterns[1]])
    assert found.claims == Share(5, 8) and found.whole == Share(0, 1)
    for name, share in found.kinds.items():
        held = sum(c.name == name for c in right)
        assert share.held == held


def test_nothing_holds_of_what_is_not_there(patterns, prompts, monkeypatch):
    found = judge_claims(prompts, [None, Pattern(()), *patterns[2:]])
    assert found.unmeasured == 2 and found.whole == Share(2, 4)
    assert found.claims == Share(sum(map(len, prompts[2:])), sum(map(len, prompts)))
    from swifttailor.evaluation.patterns import adherence

    def refuse(pattern):
        raise PatternError("The panels lie inside each other.")

    monkeypatch.setattr(adherence, "measure_facts", refuse)
    assert judge_claims(prompts, patterns).unmeasured == 4
    with pytest.raises(InputError, match="4 prompts and 3 patterns"):
        judge_claims(prompts, patterns[:3])


def test_outlines_in_a_tangle_are_not_measured(patterns, monkeypatch):
    """Each side of this star crosses nearly all others: 1,300 crossings, which measuring cannot cope with."""
    from swifttailor.evaluation.patterns import adherence

    turns = np.arange(53) * (26 / 53) * 2 * np.pi
    star = Panel("skirt_front", 60 * np.stack([np.cos(turns), np.sin(turns)], axis=1), (Edge(),) * 53)
    asked: list[Pattern] = []
    monkeypatch.setattr(adherence, "measure_facts", asked.append)
    assert adherence.measured(Pattern((*patterns[1].panels[1:], star))) is None and asked == []
    adherence.measured(patterns[1])
    assert asked == [patterns[1]]


@pytest.fixture(scope="module")
def pairs():
    made = [pairs_of(draft("t-shirt", sleeve_length=20.0), draft("t-shirt", sleeve_length=55.0), seed=3)]
    made.append(pairs_of(draft("fitted-skirt", length=45.0), draft("fitted-skirt", length=80.0), seed=4))
    return [pair for both in made for pair in both]


def test_instructions_are_followed_by_the_edit_and_not_by_a_copy(pairs):
    assert len(pairs) == 4
    given = [p.instruction for p in pairs]
    before, after = [p.base for p in pairs], [p.edited for p in pairs]
    done = judge_instructions(given, before, after)
    assert done.claims.share == 1 == done.whole.share and done.claims.made >= 4
    assert sum(share.made for share in done.kinds.values()) == done.claims.made
    copied = judge_instructions(given, before, before)
    assert copied.claims.share == 0 and copied.whole == Share(0, 4)
    missing = judge_instructions(given, before, [None, *after[1:]])
    assert missing.unmeasured == 1 and missing.whole == Share(3, 4)
    with pytest.raises(InputError, match="4 prompts and 3 patterns"):
        judge_instructions(given, before, after[:3])


def test_the_table_has_a_line_for_each_kind_of_claim(patterns, prompts):
    true, chance = judge_claims(prompts, patterns), by_chance(prompts, patterns)
    none = judge_claims(prompts, [None] * 4)
    text = adherence_table([("true", true), ("chance", chance), ("nothing", none)])
    lines = {line.split("  ")[0]: line.split() for line in text.splitlines()}
    assert lines["all statements"][-4:] == [
        str(true.claims.made),
        "100.0",
        f"{100 * (chance.claims.share or 0):.1f}",
        "0.0",
    ]
    assert set(true.kinds) <= lines.keys()
    assert "nothing: 4 patterns" in text and "true: " not in text
    assert Share().share is None
