"""What a PatternMaker's training counts: changes more than what is taken over."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from swifttailor.pattern.drafts import draft
from swifttailor.pattern_maker.asking.counterpart import counterparts
from swifttailor.pattern_maker.asking.prompt import make_prompt, pattern_part
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.vocabulary import SIZE
from swifttailor.training.maker_config import CONFIGS, MakerLosses

pytestmark = pytest.mark.needs_torch


@pytest.fixture(scope="module")
def edit():
    """A batch of one edit, a dress made shorter and given other sleeves, and its sequences."""
    from swifttailor.training.maker_batch_torch import assemble
    from swifttailor.training.maker_samples import MakerSample

    old, new = (
        encode(draft("shirt-dress")),
        encode(draft("shirt-dress", skirt_length=45.0, sleeve_length=30.0)),
    )
    whole = make_prompt((1, 2), 10, edit=old) + pattern_part(new, 10)
    return assemble([MakerSample("edit", whole.tokens, whole.numbers, new, None, old)], 64), old, new


def losses_of(batch, **weights):
    import torch

    from swifttailor.pattern_maker.asking.foresight import FORESEEN
    from swifttailor.training.maker_losses_torch import compute_losses

    torch.manual_seed(0)
    logits, numbers = torch.randn(len(batch.answers), SIZE), torch.randn(len(batch.answers), 8)
    found = compute_losses(logits, numbers, torch.zeros(1, FORESEEN), batch, MakerLosses(**weights))
    return {k: float(v) for k, v in found.items()}, logits


def test_tokens_and_numbers_that_change_count_more(edit):
    batch, old, new = edit
    plain, logits = losses_of(batch, changed=1.0)
    more, _ = losses_of(batch, changed=3.0)
    own = counterparts(old, new)
    other = np.array([c.token >= 0 and c.token != t for c, t in zip(own, new.tokens, strict=True)])
    cross_entropy = -logits.log_softmax(-1).numpy()[np.arange(len(new)), new.tokens]
    assert plain["tokens"] == pytest.approx(cross_entropy.mean(), rel=1e-5)
    assert more["tokens"] == pytest.approx((cross_entropy * np.where(other, 3, 1)).mean(), rel=1e-5)
    assert plain["numbers"] < more["numbers"] < 3 * plain["numbers"]
    assert more["foresight"] == plain["foresight"]


def test_what_is_no_edit_and_not_symmetric_counts_as_ever(edit):
    import torch

    batch = replace(edit[0], copied=torch.full_like(edit[0].copied, -1))
    assert losses_of(batch, changed=5.0)[0] == losses_of(batch, changed=1.0)[0]


def test_the_paper_weighs_all_alike():
    assert CONFIGS["paper"].losses.changed == 1
