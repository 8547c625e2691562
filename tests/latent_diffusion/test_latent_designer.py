"""Drawing latents and patterns: the sampler, the networks and their model file."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from swifttailor.errors import InputError
from swifttailor.latent_diffusion import tensor_layout as at
from swifttailor.latent_diffusion.designer import LatentDesigner
from swifttailor.latent_diffusion.panel_tensor import tensor_of
from swifttailor.latent_diffusion.sampling import drawn_latents
from swifttailor.latent_diffusion.tensor_pattern import pattern_of
from swifttailor.parameter_reader.features import features_of
from swifttailor.pattern.drafts import draft
from swifttailor.pattern_library.sought import Sought

SHAPE = 8, 3


def perfect(middle, spread):
    """The velocity of the very best denoiser of latents with these means and this spread."""

    def velocity(noisy, time, features):
        kept, added = np.cos(time * np.pi / 2)[:, None, None], np.sin(time * np.pi / 2)[:, None, None]
        mean = np.where(features[:, :1, None] > 0, middle, 0.0)
        clean = mean + kept * spread**2 * (noisy - kept * mean) / (kept**2 * spread**2 + added**2)
        noise = (noisy - kept * clean) / np.maximum(added, 1e-6)
        return kept * noise - added * clean

    return velocity


def test_what_is_drawn_has_the_distribution_that_the_denoiser_knows():
    velocity, told = perfect(1.5, 0.2), np.ones(4, np.float32)
    drawn = np.stack(
        [drawn_latents(velocity, told, SHAPE, seed=k, steps=40, guidance=1.0) for k in range(60)]
    )
    assert drawn.mean() == pytest.approx(1.5, abs=0.03) and drawn.std() == pytest.approx(0.2, abs=0.03)
    untold = drawn_latents(velocity, np.zeros(4, np.float32), SHAPE, seed=0, guidance=1.0)
    assert abs(untold.mean()) < 0.2
    farther = drawn_latents(velocity, told, SHAPE, seed=0, guidance=1.5)
    assert farther.mean() > drawn.mean() + 0.3, "guidance goes beyond what is told, away from nothing told"


def test_the_same_seed_draws_the_same():
    velocity, told = perfect(0.5, 1.0), np.ones(4, np.float32)
    one, same, other = (drawn_latents(velocity, told, SHAPE, seed=k, guidance=2.0) for k in (3, 3, 4))
    assert np.array_equal(one, same) and not np.allclose(one, other)


@pytest.mark.needs_torch
def test_the_file_of_trained_networks_draws_what_torch_draws(tmp_path, monkeypatch):
    import torch

    from swifttailor.latent_diffusion.export_torch import export
    from swifttailor.latent_diffusion.network_torch import LATENTS, LEVELS, WIDE, Denoiser
    from swifttailor.training import latent_autoencoder_torch as coding
    from swifttailor.training.latent_bank import TensorBank

    sizes = {"WIDTH": 64, "HIDDEN": 128, "ENCODER_BLOCKS": 1, "DECODER_BLOCKS": 1}
    for name, size in sizes.items():
        monkeypatch.setattr(coding, name, size)
    torch.manual_seed(0)
    torch.set_num_threads(1)
    patterns = [draft(name).canonical() for name in ("t-shirt", "fitted-skirt")]
    tensors = [tensor_of(pattern) for pattern in patterns]
    there = [np.flatnonzero(tensor[:, 0, at.THERE]) for tensor in tensors]
    bank = TensorBank(
        np.array(["a", "b"]),
        np.repeat(np.arange(2, dtype=np.int32), [len(one) for one in there]),
        np.concatenate(there).astype(np.int32),
        np.concatenate([t[k] for t, k in zip(tensors, there, strict=True)]).astype(np.float32),
    )
    assert np.allclose(bank.tensor(1), tensors[1], atol=1e-4)
    assert np.array_equal(bank.chosen([1, 0]).tensor(0), bank.tensor(1))
    panels, coder = coding.Panels.of(bank), coding.AutoEncoder()
    optimizer = torch.optim.Adam(coder.parameters(), 2e-3)
    losses = []
    for _ in range(60):
        loss = coder.loss(panels, torch.arange(2))
        optimizer.zero_grad()
        loss.backward()
        optimizer.step()
        losses.append(float(loss.detach()))
    assert losses[-1] < 0.3 * losses[0]
    coder.eval()
    latents = coder.latents(panels)
    steps = latents * (LEVELS - 1) / 2
    assert torch.allclose(steps, steps.round(), atol=1e-5) and latents.abs().max() <= 1
    decoder = coder.whole_decoder(panels).for_drawn(latents.mean(0), latents.std())
    found = pattern_of(decoder((latents[:1] - latents.mean(0)) / latents.std())[0].detach().double().numpy())
    assert [p.name for p in found.panels] == [p.name for p in patterns[0].panels]

    denoiser = Denoiser(len(features_of(Sought.nothing())), width=64, blocks=1, told=2, dropout=0.1).eval()
    torch.nn.init.normal_(denoiser.last.weight, std=0.05)
    path = export(denoiser, decoder, {"config": {"sampler": {"guidance": 1.5}}}, tmp_path / "diffusion.zip")
    designer = LatentDesigner.load(path)

    def velocity(*given):
        return denoiser(*map(torch.from_numpy, given)).detach().numpy()

    features = np.linspace(-1, 1, denoiser.features, dtype=np.float32)
    own = drawn_latents(velocity, features, (LATENTS, WIDE), seed=5, guidance=designer.guidance)
    theirs = drawn_latents(designer._velocity, features, designer.shape, seed=5, guidance=1.5)
    assert np.allclose(own, theirs, atol=1e-3) and own.std() > 0.1
    tensor = designer.sessions["decoder"].run(None, {"latents": own[None].astype(np.float32)})[0]
    own_tensor = decoder(torch.from_numpy(own[None]).float()).detach().numpy()
    assert np.allclose(tensor, own_tensor, atol=0.05), "but for numbers on the verge of two levels"

    (tmp_path / "other.zip").write_bytes(b"PK nothing")
    with pytest.raises(InputError, match="latent diffusion"):
        LatentDesigner.load(tmp_path / "other.zip")


@pytest.mark.needs_torch
def test_a_stage_that_is_interrupted_goes_on_to_the_same_weights(tmp_path):
    import torch

    from swifttailor.training.latent_stage_torch import Stage, StageConfig

    def staged(folder):
        torch.manual_seed(1)
        network = torch.nn.Sequential(torch.nn.Linear(4, 4), torch.nn.Dropout(0.5))
        config = StageConfig(minutes=60, steps=12, batch_size=8, learning_rate=0.1, weight_decay=0.0, ema=0.9)

        def loss(chance):
            return (network(torch.randn(8, 4, generator=chance)) - 1).square().mean()

        return Stage("test", network, config, folder), loss

    def at_end(stage, loss):
        stage.schedule = replace(stage.schedule, max_seconds=None)  # by steps alone: times differ
        stage.run(loss)
        return stage.network.state_dict()

    whole = at_end(*staged(tmp_path / "whole"))
    interrupted, loss = staged(tmp_path / "parts")
    interrupted.schedule = replace(interrupted.schedule, max_seconds=None)
    for _ in range(5):
        interrupted.take(loss)
    interrupted.save()
    going_on, loss = staged(tmp_path / "parts")
    assert going_on.step == 5 and not going_on.is_over
    again = at_end(going_on, loss)
    assert all(torch.equal(whole[name], again[name]) for name in whole)
    with pytest.raises(InputError, match="other settings"):
        Stage(
            "test",
            torch.nn.Linear(4, 4),
            StageConfig(minutes=1, batch_size=9, learning_rate=0.1, weight_decay=0.0, ema=0.9),
            tmp_path / "parts",
        )
