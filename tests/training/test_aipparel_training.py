"""The method of AIpparel in little: its samples, its losses, and from a training to a row of a table."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from swifttailor.cli.main import run
from swifttailor.errors import InputError, PatternError
from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.pattern import to_specification
from swifttailor.pattern.drafts import draft
from swifttailor.pattern_maker.asking.prompt import EDIT, MAKE
from swifttailor.pattern_maker.maker import PatternMaker, Request, WrittenPattern
from swifttailor.pattern_maker.tokens.name_text import PANEL_END, PANEL_START, NameText
from swifttailor.pattern_maker.tokens.token_sequence import padded_mask
from swifttailor.pattern_maker.tokens.vocabulary import MOVE, PATTERN_START, SIZE, STITCH_TOKENS
from swifttailor.training.maker_bank import PatternBank, open_bank
from swifttailor.training.maker_config import CONFIGS, read_config
from swifttailor.training.maker_samples import MakerSamples

TINY = [
    "network.hidden_size=32",
    "network.layers=2",
    "network.heads=2",
    "network.key_value_heads=1",
    "network.intermediate_size=32",
    "network.vision_hidden_size=16",
    "network.vision_layers=1",
    "network.vision_heads=2",
    "network.image_size=32",
    "batch_size=2",
    "warmup_steps=1",
    "steps=3",
    "validate_every=3",
    "validation_samples=1",
    "log_every=1",
    "precision=float32",
]
TEXT = TextTokenizer.shipped()
NAMES = NameText.of(TEXT)


def write_lines(path: Path, patterns: dict, **more) -> Path:
    lines = [json.dumps({"id": k, "pattern": to_specification(p)} | more) for k, p in patterns.items()]
    path.write_text("\n".join(lines) + "\n")
    return path


@pytest.fixture(scope="module")
def files(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("patterns")
    write_lines(folder / "train.jsonl", {"top": draft("tank-top"), "skirt": draft("fitted-skirt")})
    write_lines(folder / "validation.jsonl", {"other": draft("fitted-skirt", length=50.0)})
    write_lines(folder / "edits.jsonl", {"longer": draft("tank-top", length=40.0)}, base="top")
    return folder


@pytest.fixture(scope="module")
def bank(files) -> PatternBank:
    return open_bank([files / "train.jsonl"], files / "edits.jsonl", files / "cache", recuts=0)


@pytest.fixture(scope="module")
def samples(bank) -> MakerSamples:
    config = read_config("aipparel", TINY)
    return MakerSamples(bank, (), config, lambda t: TEXT.encode(t, 192).tokens, TEXT.size, NAMES)


def test_it_has_the_size_of_the_small_one_and_differs_in_method():
    small, other = CONFIGS["small"], CONFIGS["aipparel"]
    method = {"command_seen", "copying", "planning", "edits", "names"}
    assert {k for k, v in vars(small.network).items() if v != getattr(other.network, k)} == method
    differs = {k for k, v in vars(small).items() if v != getattr(other, k)}
    assert differs == {"network", "losses", "tags", "decoding", "reads"}
    paper = CONFIGS["paper"]
    assert (paper.network.names, paper.tags, paper.decoding, paper.losses) == (
        other.network.names,
        other.tags,
        other.decoding,
        other.losses,
    )


def test_samples_spell_names_in_answers_and_in_patterns_to_edit(samples):
    whole, chance = NAMES.whole(TEXT.size), np.random.default_rng(0)
    for task in ("text", "edit"):
        sample = samples.make(samples.plan_task(0, task, chance))
        assert sample.spelled is not None
        answer = sample.tokens[len(sample.prompt) :]
        assert np.array_equal(answer, whole[NAMES.spell(sample.answer).outputs])
        assert sample.prompt[-1] == TEXT.size + MAKE
        noise = sample.numbers[len(sample.prompt) :] - sample.spelled.numbers
        mask = padded_mask(NAMES.outputs)[sample.spelled.outputs]
        assert 0.001 < noise[mask].std() < 0.05 and not noise[~mask].any()
        told = (sample.prompt == TEXT.size + PANEL_START).sum()
        assert (TEXT.size + EDIT in sample.prompt) == (task == "edit") == bool(told)
        assert told == (
            0 if sample.before is None else (NAMES.spell(sample.before).outputs == PANEL_END).sum()
        )
    tags = sample.answer.tokens[np.isin(sample.answer.tokens, STITCH_TOKENS)]
    assert tags[0] != STITCH_TOKENS[0], "a permutation by lot"


def test_losses_that_need_counterparts_are_refused():
    with pytest.raises(InputError, match=r"losses.changed is 4 with network.names=text"):
        read_config("aipparel", ["losses.changed=4"])
    with pytest.raises(InputError, match="decoding is"):
        read_config("aipparel", ["decoding=none"])


@pytest.mark.needs_torch
def test_errors_of_numbers_are_averaged_by_kind_of_token_and_text_has_none(samples):
    import torch

    from swifttailor.pattern_maker.network.building_torch import build_network
    from swifttailor.training.maker_batch_torch import assemble
    from swifttailor.training.maker_losses_torch import compute_losses

    config, chance = samples.config, np.random.default_rng(1)
    made = [samples.make(samples.plan_task(k, task, chance)) for k, task in ((0, "edit"), (1, "text"))]
    batch = assemble(made, config.network.image_size, network=config.network)
    whole = torch.from_numpy(NAMES.whole(TEXT.size))
    assert torch.equal(batch.tokens.flatten()[batch.answers + 1], whole[batch.next_tokens])
    assert len(batch.answers) == sum(len(s.outputs) for s in made) and not batch.unplanned
    assert (batch.copied < 0).all() and (batch.planned < 0).all()
    torch.manual_seed(0)
    network = build_network(config.network, TEXT.size).eval()
    with torch.no_grad():
        logits, numbers, foreseen = network(*batch.given)
    assert logits.shape[1] == NAMES.outputs
    found = compute_losses(logits, numbers, foreseen, batch, config.losses)
    text = batch.next_tokens >= SIZE
    assert text.any() and not numbers[text].any() and not batch.next_numbers[text].any()
    apart = (numbers - batch.next_numbers).square()
    turned = (numbers[:, 3:7] + batch.next_numbers[:, 3:7]).square().sum(-1)
    expected = 0.0
    for kind in range(SIZE):
        rows = batch.next_tokens == kind
        if padded_mask(NAMES.outputs)[kind].any() and rows.any():
            each = apart[rows].sum(-1)
            if kind == MOVE:
                quaternions = torch.minimum(apart[rows, 3:7].sum(-1), turned[rows])
                each = apart[rows, :3].sum(-1) + quaternions
            expected += each.mean().item()
    assert found["numbers"].item() == pytest.approx(expected, rel=1e-4)
    assert found["total"].item() == pytest.approx(found["tokens"].item() + 0.1 * expected, rel=1e-4)


@pytest.mark.needs_torch
def test_from_a_training_to_a_row_of_the_table(files, tmp_path, capsys):
    """Trained for three steps it writes no pattern, and every question has a reason why."""
    from swifttailor.training.maker_loop_torch import train

    given = {"validation": [files / "validation.jsonl"], "edits": files / "edits.jsonl", "threads": 1}
    config = read_config("aipparel", [*TINY, "recuts=0"])
    card = train(config, [files / "train.jsonl"], tmp_path / "run", cache=files / "cache", **given)
    assert card["validation"]["text"]["token_loss"] > 0
    model = tmp_path / "model.zip"
    assert run(["train", "export", str(tmp_path / "run"), "--out", str(model), "--half"]) == 0
    assert "of a value from torch" in capsys.readouterr().out
    maker = PatternMaker.load(model)
    assert maker.model.decoding == "free" and maker.model.grammar.tags == "any"
    assert maker.model.names is not None and maker.model.names.spelled == NAMES.spelled
    ruled = maker.generate_all([Request("a top"), Request("longer", edit=draft("tank-top"))])
    assert all(one.pattern.panels and one.sequence.tokens[0] == PATTERN_START for one in ruled)
    (own,) = maker.write_all([Request("a top")], decoding="own")
    assert isinstance(own, PatternError) and "What was written is no pattern" in str(own)
    (forced,) = maker.write_all([Request("a top")], decoding="grammar")
    assert isinstance(forced, WrittenPattern) and forced.sequence == ruled[0].sequence

    out = tmp_path / "out"
    asked = ["evaluate", "systems", "--patterns", str(files / "validation.jsonl"), "--out", str(out)]
    assert run([*asked, "--generators", f"manner={model}", "truth", "--sewers"]) == 0
    summary = json.loads((out / "summary.json").read_text())
    rows = {name: results[0]["patterns"] for name, results in summary["answers"].items()}
    assert rows["manner"]["PatternMaker"]["missing"] == 1 and rows["truth"]["PatternMaker"]["missing"] == 0
    assert summary["about"]["generators"]["manner"]["weights"]["writer"]["file"] == "model.zip"
    record = json.loads((out / "manner" / "answers.jsonl").read_text().splitlines()[0])
    assert "What was written is no pattern" in record["error"] and "pattern" not in record
