"""Training the wish reader."""

from __future__ import annotations

import hashlib
import json
from dataclasses import replace

import numpy as np
import pytest

from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.errors import InputError
from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.networks.word_pieces import WordPieces
from swifttailor.training.wish_samples import UNKNOWN, WishSamples
from swifttailor.wishes.labels import change_of, number_labels, statement_labels

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


@pytest.fixture
def lesson(samples):
    return [samples.sample(text, changes, instruction=asked) for text, changes, asked in TEXTS]


def run_of(samples, lesson, out, *, settings=None, **options):
    """A training that sees nothing but the lesson."""
    from swifttailor.training.loop_torch import Loop
    from swifttailor.training.wish_config import ReaderSize, WishConfig
    from swifttailor.training.wish_loop_torch import WishTask

    samples.make = lambda number: lesson[number % len(lesson)]
    config = WishConfig(
        network=ReaderSize(width=64, layers=2),
        steps=120,
        batch_size=10,
        learning_rate=4e-3,
        warmup_steps=10,
        ema=0.9,
        validate_every=1000,
    )
    config = replace(config, **(settings or {}))
    # Two threads that wait for each other on a busy machine are many times slower.
    loop = Loop.start(config, out, threads=1, **options)
    return loop.run(WishTask(config, samples, lesson, {"of": "a lesson"}, loop.processes))


@pytest.mark.needs_torch
def test_it_learns_is_written_and_is_read_again(samples, lesson, tmp_path):
    from safetensors.numpy import load_file

    from swifttailor.cli.train_export import TrainExport
    from swifttailor.wishes.reader import WishReader

    card = run_of(samples, lesson, tmp_path / "run")
    assert (card["validation"]["whole"], card["validation"]["numbers"]) == (1.0, 1.0)
    assert card["training"]["texts_seen"] == 1200
    run_of(samples, lesson, tmp_path / "again", stop_after=37)
    run_of(samples, lesson, tmp_path / "again", resume=True)
    once, again = (load_file(tmp_path / name / "weights.safetensors") for name in ("run", "again"))
    assert once.keys() == again.keys()
    assert all(np.array_equal(once[name], again[name]) for name in once), "interrupted, and the same"

    path = tmp_path / "reader.onnx"
    assert TrainExport(source=tmp_path / "run", out=path, half=True).run() == 0
    reader = WishReader.load(path)
    assert reader.card["model"] == "WishReader" and reader.card["data"] == {"of": "a lesson"}
    beside = json.loads(path.with_suffix(".json").read_text())
    assert beside.pop("file")["sha256"] == hashlib.sha256(path.read_bytes()).hexdigest()
    assert beside == reader.card
    for text, changes, asked in TEXTS:
        assert {w.change for w in reader.read(text, instruction=asked)} == set(changes)
    written = tmp_path / "run" / "card.json"
    written.write_text(json.dumps(card | {"labels_sha256": "0"}))
    with pytest.raises(InputError, match="other statements"):
        TrainExport(source=tmp_path / "run", out=path, overwrite=True).run()


@pytest.mark.needs_torch
def test_one_that_knows_english_reads_words_that_it_has_not_learnt(tmp_path):
    """The weights of the package know what words are like: texts of the test share none with the lesson."""
    from swifttailor.cli.train_export import TrainExport
    from swifttailor.training.wish_config import ReaderSize
    from swifttailor.wishes.reader import SHIPPED_SPOKEN, WishReader

    samples = WishSamples(None, WordPieces.shipped(), seed=0, typos=0.0)
    texts = [("thinner ankles", -1), ("slimmer wrists", -1), ("wider shoulders", 1), ("bigger hips", 1)]
    lesson = [samples.sample(text, [Step("length", sign)], instruction=True) for text, sign in texts]
    size = ReaderSize(**WishReader.load_spoken().card["config"]["network"])
    settings = {"network": size, "start": str(SHIPPED_SPOKEN), "steps": 40, "learning_rate": 2e-4}
    card = run_of(samples, lesson, tmp_path / "run", settings=settings)
    assert card["model"] == "SpokenReader" and card["validation"]["whole"] == 1.0
    path = tmp_path / "spoken.onnx"
    assert TrainExport(source=tmp_path / "run", out=path, int8=True).run() == 0
    assert path.stat().st_size < 1.1 * sum(1 for _ in WordPieces.shipped().pieces) * size.width + 12e6
    with pytest.raises(InputError, match="wish reader"):
        WishReader.load(path)
    reader = WishReader.load_spoken(path)
    assert reader.whole("thinner ankles") == {}, "it has no other network for people's own words"
    whole = replace(reader, own_words=path).whole("larger chest")
    assert whole.keys() <= {change_of(label) for label in statement_labels()} and len(whole) > 200
    assert whole[Step("length", 1)] > 0.5 > whole[Step("length", -1)]


@pytest.mark.needs_torch
def test_it_begins_with_the_packages_weights():
    import torch

    from swifttailor.training.start_torch import load_start
    from swifttailor.wishes.export_torch import build_network
    from swifttailor.wishes.reader import SHIPPED, WishReader

    network = build_network({}).eval()
    load_start(network, SHIPPED)
    tokens = torch.arange(1, 40)[None]
    said, counts = WishReader.load().session.run(None, {"tokens": tokens.numpy()})
    with torch.no_grad():
        expected = network(tokens)
    np.testing.assert_allclose(said, expected[0].numpy(), atol=2e-4)
    np.testing.assert_allclose(counts, expected[1].numpy(), atol=2e-4)


@pytest.mark.needs_torch
def test_batches_are_each_determined_by_their_number(samples, lesson):
    from swifttailor.training.wish_config import WishConfig
    from swifttailor.training.wish_loop_torch import WishBatches

    numbers = {}

    class Ready:
        def __init__(self, number):
            self.number, self.ready = number, type("Text", (), {"tokens": range(number * 7 % 11)})

    samples.make = Ready
    config = WishConfig(batch_size=4)
    batches = WishBatches(samples, config)
    for step in (0, 9, 3, 8, 1, 0):
        found = [sample.number for sample in batches[step]]
        assert numbers.setdefault(step, found) == found
        lengths = [len(sample.ready.tokens) for sample in batches[step]]
        assert max(lengths) - min(lengths) <= 4, "like length"
    pool = {sample.number for step in range(8) for sample in batches[step]}
    assert pool == set(range(32)), "each once"
    parts = [WishBatches(samples, config, part=k, parts=2)[3] for k in (0, 1)]
    assert sorted(s.number for part in parts for s in part) == sorted(numbers[3])
