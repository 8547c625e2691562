"""The network of torch: its cache, its graphs and its parts agree with each other."""

from __future__ import annotations

import copy
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from swifttailor.errors import InputError
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.names import TWINS
from swifttailor.pattern_maker.asking.copying import LEANINGS, UNCHANGED
from swifttailor.pattern_maker.asking.counterpart import counterparts
from swifttailor.pattern_maker.asking.foresight import PANEL_NUMBERS
from swifttailor.pattern_maker.asking.plan import PatternPlan, normalized
from swifttailor.pattern_maker.asking.prompt import EDIT, IMAGE, MAKE, make_prompt, outlines_of, pattern_part
from swifttailor.pattern_maker.network.network_config import NetworkConfig
from swifttailor.pattern_maker.network.runtime import GRAPHS, PLANNING_GRAPHS
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.grammar import Grammar, Limits, Stage, State
from swifttailor.pattern_maker.tokens.panel_tokens import SAME, are_alike, mirrored, panels_of
from swifttailor.pattern_maker.tokens.vocabulary import (
    EDGE_LABEL_TOKENS,
    END,
    MOVE,
    NOT_STITCHED,
    NUMBERS,
    PANEL_TOKENS,
    PATTERN_END,
    SIZE,
    STITCH_TOKENS,
)

TINY = NetworkConfig(
    hidden_size=32,
    layers=2,
    heads=4,
    key_value_heads=2,
    intermediate_size=48,
    vision_hidden_size=32,
    vision_layers=1,
    vision_heads=2,
    image_size=64,
)
TEXT = 300


@pytest.fixture(scope="module")
def network():
    import torch

    from swifttailor.pattern_maker.network.building_torch import build_network

    torch.manual_seed(1)
    network = build_network(TINY, TEXT).eval()
    begun_at_nothing = (network.counterpart_in, network.counterpart_head[2], network.planned_in)
    heads = (*begun_at_nothing, network.planned_head[2], network.panel_in[2])
    for parameter in (head.weight for head in heads):
        torch.nn.init.normal_(parameter, std=0.5)
    return network


def call(network, tokens, numbers, answers, next_tokens, copied=None, copied_numbers=None):
    """The network on one prompt without pictures, nothing read beside it: logits and numbers."""
    import torch

    none, pictures = torch.zeros(0, dtype=torch.long), torch.zeros(0, 3, 64, 64)
    written = (tokens, numbers, pictures, answers, next_tokens, answers[:1])
    repeated, planned = untold(tokens)
    told = repeated if copied is None else (copied, copied_numbers)
    return network(*written, none, none, none, none, pictures, *told, *planned)[:2]


def untold(tokens):
    """No counterparts, and no plans."""
    import torch

    nothing, zeros = torch.full_like(tokens, -1), torch.zeros(*tokens.shape, NUMBERS)
    plans = torch.zeros(len(tokens), len(PANEL_TOKENS), PANEL_NUMBERS)
    return (nothing, zeros), (nothing, zeros, nothing, plans)


def sequence(image=False):
    shirt = encode(draft("t-shirt"))
    prompt = make_prompt((5, 250, 7), TEXT, image_tokens=4 if image else 0, edit=encode(draft("tank-top")))
    return prompt + pattern_part(shirt, TEXT)


def test_a_prompt_is_picture_text_pattern():
    edit = encode(draft("tank-top"))
    prompt = make_prompt((5, 9), TEXT, image_tokens=2, edit=edit)
    expected = [TEXT + IMAGE] * 2 + [5, 9, TEXT + EDIT, *(edit.tokens + TEXT).tolist(), TEXT + MAKE]
    assert prompt.tokens.tolist() == expected
    assert np.array_equal(prompt.numbers[5:-1], edit.numbers)
    assert not prompt.numbers[:5].any()
    assert make_prompt((), TEXT).tokens.tolist() == [TEXT + MAKE]


def test_of_a_pattern_to_edit_the_outlines_are_told_and_a_mirrored_panel_by_its_name():
    shirt = encode(draft("t-shirt"))
    told = outlines_of(shirt)
    panels, brief = panels_of(shirt), panels_of(shirt)
    assert not set(told.tokens.tolist()) & {*STITCH_TOKENS, NOT_STITCHED, *EDGE_LABEL_TOKENS}
    names = [t - PANEL_TOKENS.start for t in told.tokens.tolist() if t in PANEL_TOKENS]
    assert names == sorted(panels)
    starts = [*np.flatnonzero(np.isin(told.tokens, PANEL_TOKENS)), len(told)]
    for name, start, end in zip(names, starts[:-1], starts[1:], strict=True):
        if end - start == 1:
            assert are_alike(mirrored(brief[TWINS[name]], name), panels[name], SAME)
        else:
            expected = [panels[name].placement, *(edge.numbers for edge in panels[name].edges)]
            assert np.array_equal(told.numbers[start + 1 : end], expected)
    assert sum(b - a == 1 for a, b in pairwise(starts)) == len(panels) // 2
    assert len(told) < 0.4 * len(shirt)


@pytest.mark.needs_torch
def test_step_by_step_equals_all_at_once(network):
    """Teacher-forced: two rows of different lengths, a padded prompt, then token by token."""
    import torch

    from swifttailor.pattern_maker.network.runtime_torch import TorchRuntime

    whole = [sequence(), sequence() + make_prompt((1, 2), TEXT)]
    runtime = TorchRuntime(network)
    starts, steps = (40, 31), 20
    tokens, numbers = np.zeros((2, 40), np.int64), np.zeros((2, 40, NUMBERS), np.float32)
    known = np.zeros((2, 40), np.float32)
    for row, (one, start) in enumerate(zip(whole, starts, strict=True)):
        tokens[row, :start], numbers[row, :start] = one.tokens[:start], one.numbers[:start]
        known[row, :start] = 1
    _, logits, cache = runtime.decode(runtime.embed(tokens, numbers), known, runtime.empty_cache(2))
    found = [logits[[0, 1], [starts[0] - 1, starts[1] - 1]]]
    for step in range(steps):
        now = np.stack([o.tokens[s + step] for o, s in zip(whole, starts, strict=True)])[:, None]
        with_numbers = np.stack([o.numbers[s + step] for o, s in zip(whole, starts, strict=True)])[:, None]
        _, logits, cache = runtime.decode(
            runtime.embed(now, with_numbers), np.ones((2, 1), np.float32), cache
        )
        found.append(logits[:, 0])
    for row, (one, start) in enumerate(zip(whole, starts, strict=True)):
        places = torch.arange(start - 1, start + steps)
        with torch.no_grad():
            expected, _ = call(
                network,
                torch.tensor(one.tokens)[None],
                torch.tensor(one.numbers)[None],
                places,
                torch.zeros(len(places), dtype=torch.long),
            )
        assert np.allclose(np.stack([f[row] for f in found]), expected.numpy(), atol=2e-5)


@pytest.mark.needs_torch
def test_written_step_by_step_an_edit_is_what_is_told_of_it_all_at_once(network):
    """Likelihood and numbers of an answer that takes and changes counterparts, by both ways."""
    import torch

    from swifttailor.pattern_maker.asking.generation import Asked, write_answers
    from swifttailor.pattern_maker.network.runtime_torch import TorchRuntime
    from swifttailor.training.maker_batch_torch import assemble
    from swifttailor.training.maker_samples import MakerSample

    network = copy.deepcopy(network)
    with torch.no_grad():
        network.counterpart_head[2].bias[0] = 5.0  # much is taken
    old = encode(draft("tank-top"))
    prompt = make_prompt((5, 250, 7), TEXT, edit=old)
    asked = Asked(prompt, seeds=((3,),), temperature=1.0, edit=old)
    ((written,),) = write_answers(TorchRuntime(network), [asked], Grammar(Limits(60, 8)), TEXT)
    answer = written.sequence
    whole = prompt + pattern_part(answer, TEXT)
    sample = MakerSample("edit", whole.tokens, whole.numbers, answer, None, old)
    batch = assemble([sample], 64)
    with torch.no_grad():
        logits, numbers, _ = network(*batch.given)
    grammar, state, likelihood = Grammar(Limits(60, 8)), State(), 0.0
    for token, row in zip(answer.tokens.tolist(), logits.double(), strict=True):
        allowed = torch.tensor(grammar.allowed(state))
        allowed[PATTERN_END] |= grammar.may_break_off(state)
        likelihood += float(row.masked_fill(~allowed, -torch.inf).log_softmax(-1)[token])
        state = grammar.advance(state, token)
    assert likelihood == pytest.approx(written.log_likelihood, abs=1e-3)
    apart = np.abs(numbers.numpy() - answer.numbers).max(axis=1)
    copied = np.array(
        [(answer.numbers[k] == c.numbers).all() for k, c in enumerate(counterparts(old, answer))]
    )
    assert (apart < np.where(copied, UNCHANGED, 1e-4)).all()
    places = batch.copied.flatten()[batch.answers]
    assert 5 < (places >= 0).sum() and (places == torch.tensor(answer.tokens)).sum() > 3


@pytest.mark.needs_torch
def test_written_step_by_step_an_answer_is_told_what_was_foreseen_of_it(network):
    """The plan that a training adds to an answer is the one that it was written with."""
    import torch

    from swifttailor.pattern_maker.asking.generation import Asked, write_answers
    from swifttailor.pattern_maker.network.runtime_torch import TorchRuntime
    from swifttailor.training.maker_batch_torch import assemble, with_plans
    from swifttailor.training.maker_samples import MakerSample

    prompts = [make_prompt(text, TEXT) for text in ((5, 250, 7), (9,), (1, 2, 3, 4, 5))]
    asked = [Asked(p, seeds=((3,),), temperature=1.0) for p in prompts]
    old = encode(draft("tank-top"))
    prompts.append(make_prompt((4, 2), TEXT, edit=old, brief=True))
    asked.append(Asked(prompts[-1], seeds=((3,),), temperature=1.0, edit=old, brief=True))
    written = [one for (one,) in write_answers(TorchRuntime(network), asked, Grammar(Limits(60, 8)), TEXT)]
    samples = []
    for prompt, one in zip(prompts, written, strict=True):
        whole = prompt + pattern_part(one.sequence, TEXT)
        before = old if one is written[-1] else None
        samples.append(MakerSample("text", whole.tokens, whole.numbers, one.sequence, None, before))
    batch = with_plans(assemble(samples, 64, network=replace(TINY, edits="outlines")), network)
    assert not batch.unplanned and (batch.planned >= 0).sum() > 10
    assert (batch.copied >= 0).sum() >= 3  # the first token is always the same
    with torch.no_grad():
        logits, numbers, _ = network(*batch.given)
        unaware = network(*assemble(samples, 64).given)[0]
    likelihoods, start, runtime = [], 0, TorchRuntime(network)
    for one, prompt in zip(written, prompts, strict=True):
        embedded = runtime.embed(prompt.tokens[None], prompt.numbers[None])
        foreseen = runtime.foresee(embedded, np.ones((1, len(prompt)), np.float32))[0]
        plan = PatternPlan.from_foresight(foreseen, old if one is written[-1] else None)
        grammar, state, likelihood = Grammar(Limits(60, 8)), State(), 0.0
        for k, token in enumerate(one.sequence.tokens.tolist(), start):
            mask = grammar.allowed(state)
            mask[PATTERN_END] |= grammar.may_break_off(state)
            allowed = np.flatnonzero(mask)
            logs = normalized(logits[k].double().numpy()[allowed])
            if state.stage is Stage.BETWEEN_PANELS:
                logs = plan.weighed(logs, state.name, allowed)
            likelihood += logs[allowed.tolist().index(token)]
            state = grammar.advance(state, token)
        likelihoods.append(likelihood)
        apart = np.abs(numbers[start : start + len(one.sequence)].numpy() - one.sequence.numbers)
        assert apart.max() < (UNCHANGED if one is written[-1] else 1e-3)
        start += len(one.sequence)
    assert likelihoods == pytest.approx([one.log_likelihood for one in written], abs=1e-3)
    assert not torch.allclose(logits, unaware, atol=0.1)


@pytest.mark.needs_torch
def test_until_it_has_learnt_to_copy_the_network_is_what_it_is_without(network):
    import torch

    from swifttailor.pattern_maker.network.building_torch import build_network

    torch.manual_seed(1)
    fresh = build_network(TINY, TEXT).eval()
    torch.manual_seed(1)
    without = build_network(replace(TINY, copying=False, planning=False), TEXT).eval()
    one = sequence()
    tokens, numbers = torch.tensor(one.tokens)[None], torch.tensor(one.numbers)[None]
    told = torch.full_like(tokens, MOVE), torch.randn(numbers.shape)
    given = (tokens, numbers, torch.arange(30), torch.full((30,), MOVE + 1))
    with torch.no_grad():
        assert torch.equal(call(fresh, *given, *told)[0], call(without, *given)[0])
        assert torch.equal(call(fresh, *given, *told)[1], call(without, *given)[1])  # of another kind
        assert not torch.equal(call(network, *given, *told)[0], call(network, *given)[0])


@pytest.mark.needs_torch
def test_numbers_are_mixed_alike_with_and_without_torch():
    import torch

    from swifttailor.pattern_maker.asking.copying import mix
    from swifttailor.pattern_maker.network import network_torch

    chance = np.random.default_rng(0)
    written, copied = chance.normal(size=(2, 40, NUMBERS)).astype(np.float32)
    leanings = chance.normal(scale=3, size=(40, LEANINGS)).astype(np.float32)
    tokens = np.full(40, MOVE + 1)
    expected = network_torch.mix(*(torch.tensor(a) for a in (written, copied, leanings))).numpy()
    found = mix(written, copied, leanings, tokens, tokens)
    assert np.allclose(found[:, END], expected[:, END], atol=1e-5)
    for other in (MOVE, MOVE + 2, -1):
        assert np.array_equal(mix(written, copied, leanings, tokens, np.full(40, other)), written)
    leanings[:, 1], leanings[:, 2:] = 20, UNCHANGED / 2
    assert np.array_equal(mix(written, copied, leanings, tokens, tokens), copied)


@pytest.mark.needs_torch
def test_pictures_stand_where_their_places_are(network):
    import torch

    one = sequence(image=True)
    torch.manual_seed(0)
    pictures = torch.randn(2, 3, 64, 64)
    tokens = torch.tensor(np.stack([one.tokens] * 2))
    numbers = torch.tensor(np.stack([one.numbers] * 2))
    with torch.no_grad():
        looks = network.look(pictures)
        embedded = network.embed(tokens, numbers, looks)
        assert looks.shape == (2, TINY.image_tokens, 32)
        assert torch.equal(embedded[:, :4], looks)
        assert torch.equal(embedded[0, 4:], embedded[1, 4:])


@pytest.mark.needs_torch
@pytest.mark.parametrize("attention", ["eager", "sdpa"])
def test_prompts_that_are_only_read_say_what_they_say_before_an_answer(network, attention, monkeypatch):
    """In two rows; none sees its neighbours; pictures go to the prompts they belong to."""
    import torch

    from swifttailor.training import packed_prompts
    from swifttailor.training.packed_prompts import pack_prompts

    prompts = [
        make_prompt(text, TEXT, image_tokens=4 * image).tokens
        for text, image in (((5, 9, 7), 0), ((), 1), ((3,), 0), ((8, 8, 2, 1), 1))
    ]
    torch.manual_seed(2)
    pictures = torch.randn(2, 3, 64, 64)
    monkeypatch.setattr(packed_prompts, "ROW", 11)
    numbers = [np.zeros((len(p), NUMBERS)) for p in prompts]
    assert pack_prompts(prompts, numbers, 0).tokens.shape == (2, 11)

    def foreseen(tokens, pictures, read, read_pictures):
        tokens = torch.tensor(tokens)[None]
        last = torch.tensor([tokens.shape[1] - 1])
        numbers = torch.zeros(1, tokens.shape[1], NUMBERS)
        given = (tokens, numbers, pictures, last, torch.zeros(1, dtype=torch.long), last)
        packed = pack_prompts(read, [np.zeros((len(p), NUMBERS)) for p in read], TEXT)
        arrays = (packed.tokens, packed.numbers, packed.positions, packed.ends)
        with torch.no_grad():
            repeated, planned = untold(tokens)
            return network(*given, *map(torch.from_numpy, arrays), read_pictures, *repeated, *planned)[2]

    network.vlm.set_attn_implementation(attention)
    together = foreseen(prompts[0], pictures[:0], prompts, pictures)
    alone = [
        foreseen(prompt, look, [], pictures[:0])[0]
        for prompt, look in zip(
            prompts, (pictures[:0], pictures[:1], pictures[:0], pictures[1:]), strict=True
        )
    ]
    network.vlm.set_attn_implementation("sdpa")
    assert torch.allclose(together, torch.stack([alone[0], *alone]), atol=1e-5)
    assert not torch.allclose(alone[1], alone[3], atol=1e-2)


@pytest.mark.needs_torch
def test_a_rotation_and_its_negative_are_embedded_alike_and_cost_nothing(network):
    import torch

    from swifttailor.training.maker_losses_torch import number_penalty

    row = torch.tensor([[0.1, 0.2, 0.3, 0.5, -0.5, 0.1, 0.7, 0.0]])
    other = row * torch.tensor([1, 1, 1, -1, -1, -1, -1, 1])
    move, cubic = torch.tensor([MOVE]), torch.tensor([MOVE + 3])
    with torch.no_grad():
        assert torch.allclose(network.embed_numbers(move, row), network.embed_numbers(move, other))
        assert not torch.allclose(network.embed_numbers(cubic, row), network.embed_numbers(cubic, other))
    assert number_penalty(row, other, move, "squared").sum() == 0
    assert number_penalty(row, other, cubic, "squared").sum() > 0
    assert number_penalty(row, row + 1, cubic, "absolute").sum().item() == pytest.approx(8 * 0.975)


@pytest.mark.needs_torch
def test_numbers_that_mean_nothing_are_not_looked_at(network):
    import torch

    one = sequence()
    noise = np.random.default_rng(0).normal(size=one.numbers.shape).astype(np.float32)
    from swifttailor.pattern_maker.tokens.token_sequence import NUMBER_MASK

    own = one.tokens - TEXT
    means = NUMBER_MASK[own.clip(0, SIZE - 1)] & ((own >= 0) & (own < SIZE))[:, None]
    nothing = torch.zeros(0, 1, 32)
    with torch.no_grad():
        first, second = (
            network.embed(torch.tensor(one.tokens)[None], torch.tensor(n)[None], nothing)
            for n in (one.numbers, np.where(means, one.numbers, noise))
        )
    assert torch.equal(first, second)


@pytest.mark.needs_torch
def test_model_file_predicts_what_torch_does(network, tmp_path):
    from dataclasses import asdict

    from swifttailor.networks.text_tokenizer import TextTokenizer
    from swifttailor.pattern_maker.network.building_torch import build_network
    from swifttailor.pattern_maker.network.export_torch import compare, make_graphs
    from swifttailor.pattern_maker.network.model_file import load_model, write_model
    from swifttailor.pattern_maker.network.runtime_torch import TorchRuntime

    text = TextTokenizer(tuple((k, k) for k in range(TEXT - 256)))
    card = {"config": {"network": asdict(TINY), "tags": "random"}}
    graphs = make_graphs(network)
    path = write_model(tmp_path / "model.zip", graphs, text, card)
    model = load_model(path)
    assert compare(model.runtime, TorchRuntime(network), TEXT, image_size=64) < 1e-4
    assert model.grammar.tags == "any"
    written = path.read_bytes()
    assert write_model(tmp_path / "again.zip", graphs, text, card).read_bytes() == written
    assert b"/" + b"network_torch.py" not in written
    assert model.runtime.copies and model.runtime.plans
    plain = make_graphs(build_network(replace(TINY, copying=False, planning=False), TEXT))
    assert plain.keys() == GRAPHS.keys()
    assert not load_model(write_model(tmp_path / "plain.zip", plain, text, card)).runtime.copies
    copying = {name: graph for name, graph in graphs.items() if name not in PLANNING_GRAPHS}
    with pytest.raises(InputError, match=r"decoder.onnx' is another network"):
        load_model(write_model(tmp_path / "copying.zip", copying, text, card))
    half = plain | {"leaning": graphs["leaning"]}
    with pytest.raises(InputError, match="is not a PatternMaker: it holds"):
        load_model(write_model(tmp_path / "half.zip", half, text, card))


@pytest.mark.needs_torch
def test_low_rank_changes_begin_at_nothing_and_are_what_is_trained(network):
    import torch

    from swifttailor.pattern_maker.network.decoder_torch import CachedDecoder
    from swifttailor.pattern_maker.network.lora_torch import add_lora

    changed = copy.deepcopy(network)
    changed.vlm.language_model.requires_grad_(False)
    add_lora(changed.vlm.language_model, 2)
    one = sequence()
    given = (
        torch.tensor(one.tokens)[None],
        torch.tensor(one.numbers)[None],
        torch.arange(10),
        torch.full((10,), MOVE),
    )
    with torch.no_grad():
        assert torch.equal(call(network, *given)[0], call(changed, *given)[0])
    trained = {n for n, p in changed.vlm.language_model.named_parameters() if p.requires_grad}
    assert trained and all(n.endswith((".up", ".down")) for n in trained)
    for name, parameter in changed.named_parameters():
        if name.endswith(".up"):
            torch.nn.init.normal_(parameter, std=0.1)
    decoder = CachedDecoder(changed)
    with torch.no_grad():
        embedded = changed.embed(given[0], given[1], torch.zeros(0, 1, 32))
        count = embedded.shape[1]
        nothing = decoder.empty_cache(1)
        _, logits, *_ = decoder(embedded, torch.arange(count)[None], torch.ones(1, count), nothing, nothing)
        assert torch.allclose(logits[0, :10], call(changed, *given)[0], atol=1e-4)
        assert not torch.allclose(logits[0, :10], call(network, *given)[0], atol=1e-2)


@pytest.mark.needs_torch
def test_a_pretrained_internvl_is_taken_as_it_is(network, tmp_path):
    """A folder as transformers writes it; its language model, vision and tokenizer are used."""
    pytest.importorskip("tokenizers")
    import torch
    from tokenizers import Tokenizer, models, pre_tokenizers
    from transformers import InternVLForConditionalGeneration, PreTrainedTokenizerFast

    from swifttailor.pattern_maker.network.building_torch import build_network, vlm_config
    from swifttailor.pattern_maker.network.pretrained_torch import load_text_tokens

    torch.manual_seed(3)
    whole = InternVLForConditionalGeneration(vlm_config(TINY, 40))
    whole.save_pretrained(tmp_path)
    words = {"[UNK]": 0} | {w: k for k, w in enumerate("a long dress with sleeves".split(), 1)}
    tokenizer = Tokenizer(models.WordLevel(words, unk_token="[UNK]"))
    tokenizer.pre_tokenizer = pre_tokenizers.Whitespace()
    PreTrainedTokenizerFast(tokenizer_object=tokenizer, unk_token="[UNK]").save_pretrained(tmp_path)
    config = NetworkConfig(
        pretrained=str(tmp_path),
        early_convolutions=False,
        image_size=64,
        patch_size=16,
        longest_text=3,
        lora_rank=2,
    )
    size, encode_text = load_text_tokens(config)
    assert (size, encode_text("a long dress with sleeves")) == (6, (1, 2, 3))
    made = build_network(config, size)
    given = (torch.tensor([[1, 2, 3]]), torch.zeros(1, 3, NUMBERS))
    own = whole.model.language_model(input_ids=given[0]).last_hidden_state[0]
    logits, _ = call(made.eval(), *given, torch.arange(3), torch.zeros(3, dtype=torch.long))
    assert torch.allclose(logits, made.token_head(own), atol=1e-5)
    with pytest.raises(InputError, match="image_size and patch_size"):
        build_network(NetworkConfig(pretrained=str(tmp_path), early_convolutions=False, image_size=128), size)
    with pytest.raises(InputError, match="cannot be loaded"):
        build_network(
            NetworkConfig(pretrained=str(tmp_path / "none"), early_convolutions=False, image_size=64), size
        )


@pytest.mark.parametrize(
    "wrong",
    [{"hidden_size": 0}, {"heads": 3}, {"key_value_heads": 3}, {"image_size": 100}, {"lora_rank": 4}],
)
def test_shapes_that_do_not_fit_are_refused(wrong):
    with pytest.raises(InputError, match="network"):
        NetworkConfig(**wrong)


@pytest.mark.needs_torch
@pytest.mark.parametrize(("patch", "widths"), [(8, [16, 32]), (16, [8, 16, 32]), (32, [8, 8, 16, 32])])
def test_convolutions_cut_a_picture_into_patches(patch, widths):
    import torch

    from swifttailor.pattern_maker.network.stem_torch import ConvolutionalStem

    stem = ConvolutionalStem(32, patch).eval()
    pictures = torch.randn(2, 3, 64, 64)
    with torch.no_grad():
        patches = stem(pictures)
        changed = pictures.clone()
        changed[0, :, :8, :8] += 1  # a corner: patches far from it stay as they were
        moved = (stem(changed) - patches).abs().amax(1)
    assert patches.shape == (2, 32, 64 // patch, 64 // patch)
    assert [m.num_features for m in stem.modules() if isinstance(m, torch.nn.BatchNorm2d)][::3] == widths
    assert moved[0, 0, 0] > 0 and not moved[1].any()
    assert patch > 16 or moved[0, -1, -1] == 0
