"""Training the wish reader."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.training.wish_samples import UNKNOWN, WishSamples
from swifttailor.wishes.labels import number_labels, statement_labels

TEXTS = [
    (
        "a knee-length dress with a V neck",
        [Gain(Claim("kind", "dress")), Gain(Claim("neckline", "v"))],
        False,
    ),
    (
        "a skirt with a 5 cm waistband",
        [Gain(Claim("kind", "skirt")), Gain(Claim("waistband_cm", 5.0))],
        False,
    ),
    ("make the sleeves 10 cm longer", [Step("sleeve length", 1, 10.0)], True),
    ("take the hood off", [Gain(Claim("hood", "none"))], True),
    ("good morning", [], False),
]


@pytest.fixture
def samples() -> WishSamples:
    return WishSamples(None, TextTokenizer.shipped(), seed=0, typos=0.0)


def test_numbers_are_told_what_they_are(samples):
    measured = samples.sample(*TEXTS[1][:2], instruction=False)
    assert [number_labels()[k - 1] for k in measured.counts] == ["measure:waistband_cm"]
    assert [statement_labels()[k] for k in measured.said] == ["gain:kind:skirt"]
    step = samples.sample(*TEXTS[2][:2], instruction=True)
    assert [number_labels()[k - 1] for k in step.counts] == ["step:sleeve length:up"]
    assert samples.sample("5 of them", [], instruction=False).counts == (0,)
    both = [Gain(Claim("cuff_cm", 5.0)), Gain(Claim("waistband_cm", 5.0))]
    assert samples.sample("5 cm cuffs, 5 cm waistband", both, instruction=False).counts == (UNKNOWN, UNKNOWN)


@pytest.mark.needs_torch
def test_it_learns_and_is_read_again(samples, tmp_path):
    import torch

    from swifttailor.training.wish_loop_torch import WishTraining, judge, reader_file, train_wish_reader
    from swifttailor.wishes.reader import WishReader

    lesson = [samples.sample(text, changes, instruction=asked) for text, changes, asked in TEXTS]
    samples.make = lambda number: lesson[number % len(lesson)]
    training = WishTraining(steps=150, batch_size=10, learning_rate=2e-3, warmup=10)
    network, score = train_wish_reader(samples, lesson, training, report=lambda line: None)
    assert score.whole == 1.0
    assert score.numbers == 1.0
    again, _ = train_wish_reader(samples, lesson, training, report=lambda line: None)
    for a, b in zip(network.parameters(), again.parameters(), strict=True):
        assert torch.equal(a, b)

    path = tmp_path / "reader.onnx"
    path.write_bytes(reader_file(network, {"seed": 0}))
    reader = WishReader.load(path)
    assert reader.card == {"seed": 0}
    for text, changes, asked in TEXTS:
        assert {w.change for w in reader.read(text, instruction=asked)} == set(changes)
    for sample in lesson:
        said, counts = reader.session.run(None, {"tokens": sample.ready.tokens[None]})
        with torch.no_grad():
            expected = network.eval()(torch.from_numpy(sample.ready.tokens)[None])
        np.testing.assert_allclose(said, expected[0].numpy(), atol=2e-4)
        np.testing.assert_allclose(counts, expected[1].numpy(), atol=2e-4)
    assert judge(network, lesson).precision == 1.0
