"""A small PatternMaker learns a pattern by heart, goes on exactly where it was interrupted, and keeps a
record."""

from __future__ import annotations

import json
from collections import Counter
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from safetensors.numpy import load_file
from sewer_data import make_data

from swifttailor.cli.main import run
from swifttailor.data.reader import SplitReader
from swifttailor.data.renders.files import RenderSettings, SplitRenders
from swifttailor.errors import InputError
from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.pattern import to_specification
from swifttailor.pattern.drafts import draft
from swifttailor.pattern_maker.asking.pictures import picture_for_network
from swifttailor.pattern_maker.asking.prompt import EDIT, MAKE
from swifttailor.pattern_maker.tokens.decode import decode
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.fidelity import compare
from swifttailor.pattern_maker.tokens.vocabulary import SIZE, STITCH_TOKENS
from swifttailor.training.maker_bank import open_bank, sequences_of
from swifttailor.training.maker_config import CONFIGS, MakerConfig, read_config
from swifttailor.training.maker_samples import MakerSamples
from swifttailor.training.misspelling import misspell

TINY = [
    "network.hidden_size=64",
    "network.layers=2",
    "network.heads=2",
    "network.key_value_heads=1",
    "network.intermediate_size=128",
    "network.vision_hidden_size=32",
    "network.vision_layers=1",
    "network.vision_heads=2",
    "network.image_size=64",
    "batch_size=4",
    "reads=4",
    "optimizer=adamw",
    "learning_rate=0.003",
    "warmup_steps=3",
    "steps=8",
    "validate_every=4",
    "validation_samples=2",
    "log_every=2",
    "ema=0.9",
    "precision=float32",
]
TEXT = TextTokenizer.shipped()


def write_lines(path: Path, patterns: dict, **more) -> Path:
    lines = [json.dumps({"id": k, "pattern": to_specification(p)} | more) for k, p in patterns.items()]
    path.write_text("\n".join(lines) + "\n")
    return path


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    folder = tmp_path_factory.mktemp("patterns")
    train = {f"skirt{k}": draft("fitted-skirt", length=45.0 + 8 * k) for k in range(3)}
    train |= {"top": draft("tank-top"), "shirt": draft("t-shirt")}
    write_lines(folder / "train.jsonl", train)
    write_lines(folder / "validation.jsonl", {"other": draft("fitted-skirt", length=50.0)})
    write_lines(folder / "edits.jsonl", {"longer": draft("fitted-skirt", length=80.0)}, base="skirt0")
    return folder


@pytest.fixture(scope="module")
def bank(files):
    return open_bank([files / "train.jsonl"], files / "edits.jsonl", files / "cache", recuts=1)


@pytest.fixture(scope="module")
def config():
    return read_config("small", TINY)


def samples_of(bank, config, renders=()):
    return MakerSamples(bank, renders, config, lambda t: TEXT.encode(t, 192).tokens, TEXT.size)


def drawn(folder: Path, settings: RenderSettings) -> SplitRenders:
    renders = SplitRenders(SplitReader(folder), settings)
    for _ in renders.draw():
        pass
    return renders


def inputs(files):
    return {
        "patterns": [files / "train.jsonl"],
        "validation": [files / "validation.jsonl"],
        "edits": files / "edits.jsonl",
        "cache": files / "cache",
        "threads": 1,
    }


def test_a_bank_holds_patterns_their_facts_and_their_edits(bank, files):
    from swifttailor.describing import measure_facts

    skirt = bank.garments[0]
    pattern = draft("fitted-skirt", length=45.0)
    assert [g.id for g in bank.garments] == ["skirt0", "skirt1", "skirt2", "top", "shirt"]
    assert compare(decode(skirt.pattern.sequence), pattern).outline_cm < 1e-3
    assert skirt.pattern.facts == measure_facts(pattern)
    assert [v.id for v in skirt.edits][-1] == "longer"
    assert all(len(g.edits) == 1 + (g.id == "skirt0") for g in bank.garments)
    again = open_bank([files / "train.jsonl"], files / "edits.jsonl", files / "cache", recuts=1)
    assert again.checksum == bank.checksum
    assert [g.edits[0].sequence for g in again.garments] == [g.edits[0].sequence for g in bank.garments]


def test_patterns_to_test_with_are_left_out_under_any_id(bank, tmp_path):
    top = draft("tank-top")
    kept_apart = {"other": draft("fitted-skirt", length=80.0), "test": replace(top, panels=top.panels[::-1])}
    path = write_lines(tmp_path / "test.jsonl", kept_apart)
    left = bank.without(sequences_of([path]))
    assert [g.id for g in left.garments] == ["skirt0", "skirt1", "skirt2", "shirt"]
    # The first skirt may stay, its edit that makes it 80 cm long may not.
    assert [v.id for v in bank.garments[0].edits][-1] == "longer"
    assert [v.id for v in left.garments[0].edits] == [v.id for v in bank.garments[0].edits][:-1]
    assert [id for id, _ in left.skipped] == ["top"] and left.numbers()["garments"] == 4
    with pytest.raises(InputError, match="All patterns to train on"):
        bank.without(bank.sequences())


def test_pictures_come_from_every_data_set_that_has_the_garment(bank, config, tmp_path):
    one, other = (make_data(tmp_path / name) for name in ("one", "other"))
    plain = drawn(one / "train", RenderSettings(size=32, random=0))  # skirt0 to 2, shirt0 to 2
    free = drawn(other / "train", RenderSettings(size=32, random=2, plain=False))
    more = drawn(other / "validation", RenderSettings(size=32, random=1, plain=False))  # shirt, skirt
    samples = samples_of(bank, config, (plain, free, more))
    tasks = {one.id: samples.tasks_of(k) for k, one in enumerate(bank.garments)}
    assert tasks["skirt0"] == tasks["shirt"] == ["text", "image", "text_image", "edit"]
    assert tasks["top"] == ["text", "edit"]
    chance = np.random.default_rng(0)
    plans = [samples.plan_task(0, "image", chance) for _ in range(60)]
    seen = {samples.make(plan, clean=True).picture.tobytes() for plan in plans}
    number = plain.reader.ids.index("skirt0")
    there = {
        picture_for_network(p.pixels(), config.network.image_size).tobytes()
        for renders in (plain, free)
        for p in renders[number]
    }
    assert len(there) == 4 and seen == there
    # In training no picture comes twice.
    assert len({samples.make(plan).picture.tobytes() for plan in plans}) == 60


def test_patterns_that_cannot_be_used_are_named(tmp_path):
    path = write_lines(tmp_path / "some.jsonl", {"top": draft("tank-top")})
    odd = to_specification(draft("tank-top"))
    name = next(iter(odd["pattern"]["panels"]))
    odd = json.loads(json.dumps(odd).replace(f'"{name}"', '"pocket"'))
    with path.open("a") as stream:
        stream.write(json.dumps({"id": "odd", "pattern": odd}) + "\nno json\n")
    bank = open_bank([path], None, tmp_path, recuts=0)
    assert len(bank) == 1
    assert [id for id, _ in bank.skipped] == ["#3", "odd"]
    assert "pocket" in bank.skipped[1][1]
    path.write_text("no json\n")
    with pytest.raises(InputError, match="no pattern to learn from"):
        open_bank([path], None, tmp_path, recuts=0)


def test_only_edits_of_these_patterns_are_measured_and_bad_ones_named(tmp_path):
    train = write_lines(tmp_path / "train.jsonl", {"top": draft("tank-top")})
    edits = write_lines(tmp_path / "edits.jsonl", {"longer": draft("tank-top", length=35.0)}, base="top")
    other = write_lines(tmp_path / "other.jsonl", {"skirt": draft("fitted-skirt")}, base="unknown")
    with edits.open("a") as stream:
        stream.write(
            other.read_text() + json.dumps({"id": "bad", "base": "top", "pattern": {}}) + "\nno json\n"
        )
    bank = open_bank([train], edits, tmp_path / "cache", recuts=0)
    assert [[v.id for v in g.edits] for g in bank.garments] == [["longer"]]
    assert sorted(id for id, _ in bank.skipped) == ["#4", "bad"]
    measured = [json.loads(load_file(path)["about"].tobytes()) for path in (tmp_path / "cache").iterdir()]
    assert sorted(v["id"] for about in measured for v in about["versions"]) == ["longer", "top"]


def test_pairs_that_data_edits_has_written_are_edits_to_learn_from(tmp_path):
    train = write_lines(tmp_path / "train.jsonl", {"top": draft("tank-top"), "shirt": draft("t-shirt")})
    made = tmp_path / "pairs.jsonl"
    assert run(["data", "edits", str(train), "--count", "2", "--out", str(made)]) == 0
    ids = [json.loads(line)["id"] for line in made.read_text().splitlines()]
    bank = open_bank([train], made, tmp_path / "cache", recuts=0)
    assert not bank.skipped
    for garment in bank.garments:
        assert len(garment.edits) == 2 and {v.id for v in garment.edits} <= set(ids)
        assert all(v.facts != garment.pattern.facts for v in garment.edits)


def test_samples_are_prompts_with_their_answers(bank, config):
    samples, tasks = samples_of(bank, config), Counter()
    for place in range(40):
        plan = samples.plan(place)
        sample = samples.make(plan)
        tasks[sample.task] += 1
        answer = sample.tokens[-len(sample.answer) :] - TEXT.size
        assert np.array_equal(answer, sample.answer.tokens)
        noise = sample.numbers[-len(sample.answer) :] - sample.answer.numbers
        assert 0.001 < noise.std() < 0.05
        assert not noise[~sample.answer.number_mask()].any()
        prompt = sample.tokens[: -len(sample.answer)]
        assert (TEXT.size + EDIT in prompt) == (sample.task == "edit")
        assert len(TEXT.decode(t for t in prompt.tolist() if t < TEXT.size)) >= len("top")
        again = samples_of(bank, config).make(samples_of(bank, config).plan(place))
        assert np.array_equal(again.tokens, sample.tokens)
        assert np.array_equal(again.numbers, sample.numbers)
    assert set(tasks) == {"text", "edit"}
    assert {samples.plan(k).garment for k in range(5)} == set(range(5)), "every pattern once in an epoch"


def test_texts_are_of_edited_versions_too_but_those_to_validate_with_are_not(bank, config):
    samples, chance = samples_of(bank, config), np.random.default_rng(0)
    garment = next(k for k, one in enumerate(bank.garments) if one.edits)
    versions = {one.id for one in (bank.garments[garment].pattern, *bank.garments[garment].edits)}
    plans = [samples.plan_task(garment, "text", chance, versions=True) for _ in range(40)]
    assert len(versions) > 1 and {plan.version.id for plan in plans} == versions
    plans = [samples.plan_task(garment, "text", chance) for _ in range(40)]
    assert {plan.version.id for plan in plans} == {bank.garments[garment].id}


def test_misspelt_words_keep_what_tells_them_apart():
    chance = np.random.default_rng(0)
    shirts, skirts = ({misspell(word, chance, 1.0) for _ in range(300)} for word in ("shirt", "skirt"))
    assert len(shirts) > 8 and "shirt" not in shirts and not shirts & skirts
    assert all(word[:3] != "sir" for word in shirts)


def test_captions_are_new_every_time(bank, config):
    samples = samples_of(bank, config)
    chance = np.random.default_rng(0)
    made = [samples.make(samples.plan_task(3, "text", chance), clean=True) for _ in range(12)]
    texts = {TEXT.decode(t for t in s.tokens.tolist() if t < TEXT.size) for s in made}
    assert len(texts) > 8
    assert all(s.answer == made[0].answer for s in made)


def test_random_tags_name_the_same_stitches(bank, config):
    samples = samples_of(bank, replace(config, tags="random"))
    plan = samples.plan_task(4, "text", np.random.default_rng(0))
    made, own = samples.make(plan).answer, bank.garments[4].pattern.sequence
    assert decode(made).stitches == decode(own).stitches
    assert not np.array_equal(made.tokens, own.tokens)
    other = ~np.isin(own.tokens, STITCH_TOKENS)
    assert np.array_equal(made.tokens[other], own.tokens[other])


def test_misspelling():
    text = "a long dress with a v neck and 3 tiers"
    assert misspell(text, np.random.default_rng(0), 0.0) == text
    wrong = misspell(text, np.random.default_rng(0), 1.0).split()
    for word, before in zip(wrong, text.split(), strict=True):
        assert abs(len(word) - len(before)) <= 1
        assert len(before) >= 3 or word == before
    assert sum(a != b for a, b in zip(wrong, text.split(), strict=True)) >= 5


@pytest.mark.parametrize("name", list(CONFIGS))
def test_configurations_survive_their_file(name):
    from swifttailor.training.config_file import changed_config, config_values

    assert changed_config(MakerConfig(), config_values(CONFIGS[name])) == CONFIGS[name]


@pytest.mark.parametrize(
    "wrong", ["tasks.text=-1", "losses.penalty=cubed", "tags=none", "typos=2", "steps=0", "network.heads=7"]
)
def test_wrong_values_are_refused(wrong):
    with pytest.raises(InputError):
        read_config("small", [wrong])


def test_prompts_to_read_have_no_answer_and_are_edits_only_where_these_are_brief(bank, config):
    samples = samples_of(bank, config)
    plans = [samples.plan_read(k) for k in range(40)]
    assert {plan.task for plan in plans} == {"text", "edit"}  # there are no pictures
    whole = replace(config, network=replace(config.network, edits="whole"))
    assert {samples_of(bank, whole).plan_read(k).task for k in range(40)} == {"text"}
    assert len({plan.garment for plan in plans}) == len(bank)
    made = samples.make(plans[0])
    assert made.prompt.tolist() == made.tokens[: -len(made.answer)].tolist()
    assert made.prompt[-1] == TEXT.size + MAKE
    edits = replace(whole, tasks=replace(config.tasks, text=0, image=0, text_image=0))
    assert samples_of(bank, edits).plan_read(0) is None


@pytest.mark.needs_torch
def test_batches_hold_samples_of_like_length_and_depend_on_their_number_alone(bank, config):
    import torch

    from swifttailor.training.maker_batch_torch import WINDOW, TrainingBatches

    def batches(**parts):
        return TrainingBatches(samples_of(bank, config), **parts)

    planned = [batches().plans(step) for step in range(WINDOW)]
    assert Counter(id(p.version) for b in planned for p in b).total() == 4 * WINDOW
    spread = np.mean([max(p.length for p in b) - min(p.length for p in b) for b in planned])
    everything = [p.length for b in planned for p in b]
    assert spread < 0.3 * (max(everything) - min(everything))
    first, again = batches()[30], batches()[30]
    assert all(torch.equal(a, b) for a, b in zip(first.given, again.given, strict=True))
    assert [u.answer for u in first.unplanned] == [u.answer for u in again.unplanned]
    tokens = first.tokens.flatten()[first.answers + 1] - TEXT.size
    assert torch.equal(tokens, first.next_tokens)
    shares = [batches(part=k, parts=2)[30] for k in (0, 1)]
    assert sum(len(s.next_tokens) for s in shares) == len(first.next_tokens)
    ahead = batches().from_step(30)
    assert torch.equal(next(ahead).tokens, first.tokens)


@pytest.mark.needs_torch
def test_some_samples_read_the_numbers_that_the_network_would_have_written(bank, config):
    import torch

    from swifttailor.pattern_maker.network.building_torch import build_network
    from swifttailor.training.maker_batch_torch import TrainingBatches, with_own_numbers, with_plans

    torch.manual_seed(0)
    network = build_network(config.network, TEXT.size)
    batch = with_plans(TrainingBatches(samples_of(bank, config))[3], network)
    rows = np.arange(len(batch.tokens)) % 2 == 0
    assert rows.any() and not rows.all()
    own = with_own_numbers(batch, network, rows)
    assert network.training
    with torch.no_grad():
        written = network.eval()(*batch.given)[1]
    expected = batch.numbers.clone()
    for place, numbers in zip(batch.answers.tolist(), written, strict=True):
        row, column = divmod(place, batch.tokens.shape[1])
        if rows[row]:
            expected[row, column + 1] = numbers
    assert torch.allclose(own.numbers, expected, atol=1e-6)
    assert not torch.equal(own.numbers, batch.numbers)
    others = [n for n in vars(batch) if n not in ("numbers", "unplanned")]
    assert all(torch.equal(getattr(own, n), getattr(batch, n)) for n in others)


@pytest.mark.needs_torch
def test_interrupted_and_resumed_equals_uninterrupted_bit_for_bit(config, files, tmp_path):
    from swifttailor.training.maker_loop_torch import train

    # In bfloat16 too, where the weights that are optimised are not those that compute.
    lowered = replace(config, precision="bfloat16", steps=6, validate_every=6, own_numbers=0.5)
    whole = train(lowered, out=tmp_path / "whole", **inputs(files))
    train(lowered, out=tmp_path / "run", stop_after=2, **inputs(files))
    resumed = train(lowered, out=tmp_path / "run", resume=True, **inputs(files))
    for name in ("weights.safetensors", "config.json"):
        assert (tmp_path / "run" / name).read_bytes() == (tmp_path / "whole" / name).read_bytes(), name
    assert whole["validation"] == resumed["validation"]
    assert set(whole["validation"]) == {"text", "edit"}
    assert whole["data"]["train"]["garments"] == 5
    assert whole["data"]["validation"]["garments"] == 1
    with pytest.raises(InputError, match="already"):
        train(lowered, out=tmp_path / "run", **inputs(files))


@pytest.mark.needs_torch
def test_training_and_validation_must_not_share_patterns(config, files, tmp_path):
    from swifttailor.training.maker_loop_torch import train

    shared = inputs(files) | {"validation": [files / "train.jsonl"]}
    with pytest.raises(InputError, match="both trained on and validated with"):
        train(config, out=tmp_path / "run", **shared)


@pytest.mark.needs_torch
def test_a_pattern_learnt_by_heart_is_written_under_the_grammar(config, files, tmp_path):
    import torch

    from swifttailor.pattern_maker.asking.generation import Asked, write_answers
    from swifttailor.pattern_maker.asking.prompt import make_prompt
    from swifttailor.pattern_maker.network.export_torch import load_weights
    from swifttailor.pattern_maker.network.runtime_torch import TorchRuntime
    from swifttailor.pattern_maker.tokens.grammar import Grammar
    from swifttailor.training.maker_batch_torch import assemble
    from swifttailor.training.maker_loop_torch import train

    top = write_lines(tmp_path / "top.jsonl", {"top": draft("tank-top")})
    longer = replace(config, steps=350, validate_every=350, ema=0.98, number_noise=0.003, recuts=0)
    given = inputs(files) | {"patterns": [top], "edits": None}
    card = train(longer, out=tmp_path / "run", **given)
    network = load_weights(tmp_path / "run/weights.safetensors", card, TEXT.size)
    prompt = make_prompt(TEXT.encode("a tank top", 192).tokens, TEXT.size)
    ((written,),) = write_answers(TorchRuntime(network), [Asked(prompt)], Grammar(), TEXT.size)
    assert written.sequence.tokens.tolist() == encode(draft("tank-top")).tokens.tolist()
    found = compare(decode(written.sequence), draft("tank-top"))
    assert found.same_structure
    assert found.outline_cm < 3.0
    assert found.placement_cm < 3.0
    assert written.log_likelihood > -2.0
    # What it is asked for is known before the answer begins.
    samples = samples_of(open_bank([top], None, files / "cache", recuts=0), longer)
    sample = samples.make(samples.plan_task(0, "text", np.random.default_rng(0)), clean=True)
    batch = assemble([sample], longer.network.image_size)
    with torch.no_grad():
        _, _, foreseen = network.eval()(*batch.given)
    assert torch.equal(foreseen[:, :SIZE] > 0, batch.present > 0)
    apart = foreseen[:, SIZE:].view_as(batch.panel_numbers) - batch.panel_numbers
    assert apart[batch.panels_known].abs().median() < 0.1
    assert batch.present.sum() == len(set(sample.answer.tokens.tolist()))
