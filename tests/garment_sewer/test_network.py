"""The network: shapes, where it starts, what it does not look at, other people's weights."""

from __future__ import annotations

from dataclasses import replace

import pytest

from swifttailor.errors import InputError
from swifttailor.garment_sewer.network_config import PAPER_NETWORK, NetworkConfig

TINY = NetworkConfig(
    resolution=64,
    patch_size=16,
    hidden_size=32,
    layers=4,
    heads=2,
    decoder_sizes=(16, 16, 16, 16),
    fusion_size=16,
    input_skip=8,
)
HYBRID = NetworkConfig(
    resolution=64, patch_size=8, hidden_size=32, layers=2, heads=2, convolutions=(8, 8, 16)
)
both_kinds = pytest.mark.parametrize("shape", [TINY, HYBRID], ids=["dpt", "hybrid"])


def given(size=(64, 64), channels=5, seed=0):
    import torch

    torch.manual_seed(seed)
    occupancy = torch.zeros(2, 1, *size)
    occupancy[:, :, 4:30, 4:20] = 1
    occupancy[:, :, 4:30, 22:50] = 1
    return torch.randn(2, channels, *size) * occupancy, occupancy, torch.randn(2, 3, *size) * 50


def unsettled(config, channels=5):
    """A network whose last layer is not zero."""
    import torch

    from swifttailor.garment_sewer.network_torch import build_network

    torch.manual_seed(1)
    network = build_network(config, channels).eval()
    torch.nn.init.normal_(network.last.weight)
    return network


@pytest.mark.needs_torch
@pytest.mark.parametrize("skip", [0, 8])
@pytest.mark.parametrize("patch", [8, 16])
def test_untrained_network_predicts_its_prior(patch, skip):
    import torch

    from swifttailor.garment_sewer.network_torch import build_network

    for shape in (replace(TINY, patch_size=patch, input_skip=skip), HYBRID):
        network = build_network(shape, 5)
        conditioning, occupancy, prior = given()
        assert torch.equal(network(conditioning, occupancy, prior), prior)


@pytest.mark.needs_torch
@both_kinds
def test_untrained_absolute_network_predicts_one_point(shape):
    import torch

    from swifttailor.garment_sewer.network_torch import build_network
    from swifttailor.garment_sewer.positions_torch import ORIGIN_CM

    network = build_network(replace(shape, output="absolute"), 5)
    predicted = network(*given())
    assert torch.equal(predicted, torch.tensor(ORIGIN_CM)[None, :, None, None].expand_as(predicted))


@pytest.mark.needs_torch
@both_kinds
@pytest.mark.parametrize("size", [(64, 64), (96, 96), (32, 80)])
def test_any_size_that_the_patch_divides(shape, size):
    import torch

    with torch.no_grad():
        predicted = unsettled(shape)(*given(size))
    assert predicted.shape == (2, 3, *size)
    assert predicted.dtype == torch.float32
    assert torch.isfinite(predicted).all()


@pytest.mark.needs_torch
@both_kinds
def test_absolute_output_does_not_look_at_the_prior(shape):
    import torch

    network = unsettled(replace(shape, output="absolute"))
    conditioning, occupancy, prior = given()
    with torch.no_grad():
        assert torch.equal(
            network(conditioning, occupancy, prior), network(conditioning, occupancy, prior + 9)
        )


@pytest.mark.needs_torch
@both_kinds
def test_displacement_follows_the_prior(shape):
    import torch

    network = unsettled(shape)
    conditioning, occupancy, prior = given()
    with torch.no_grad():
        moved = network(conditioning, occupancy, prior + 9) - network(conditioning, occupancy, prior)
    assert torch.allclose(moved, torch.full_like(moved, 9.0), atol=1e-4)


@pytest.mark.needs_torch
@both_kinds
def test_one_garment_of_a_batch_does_not_change_another(shape):
    import torch

    network = unsettled(shape)
    conditioning, occupancy, prior = given()
    with torch.no_grad():
        both = network(conditioning, occupancy, prior)
        alone = network(conditioning[:1], occupancy[:1], prior[:1])
    assert torch.allclose(both[:1], alone, rtol=1e-4, atol=1e-3)


@pytest.mark.needs_torch
def test_masked_convolution_is_a_mean_over_what_is_seen():
    import torch
    from torch import nn

    from swifttailor.garment_sewer.network_torch import _masked

    torch.manual_seed(0)
    convolution = nn.Conv2d(2, 3, 3, padding=1)
    mask = (torch.rand(1, 1, 6, 7) < 0.6).float()
    x = torch.randn(1, 2, 6, 7)
    found = _masked(convolution, x, mask)[0]
    for row in range(6):
        for column in range(7):
            total, seen = torch.zeros(3), 0
            for i in (-1, 0, 1):
                for j in (-1, 0, 1):
                    r, c = row + i, column + j
                    if 0 <= r < 6 and 0 <= c < 7 and mask[0, 0, r, c]:
                        total += convolution.weight[:, :, i + 1, j + 1] @ x[0, :, r, c]
                        seen += 1
            expected = total * 9 / max(seen, 1) + convolution.bias
            assert torch.allclose(found[:, row, column], expected, atol=1e-5)


@pytest.mark.needs_torch
@both_kinds
def test_bfloat16_rounds_features_and_not_positions(shape):
    import torch

    network = unsettled(shape)
    conditioning, occupancy, prior = given()
    prior = prior * 0 + 123.4567
    torch.nn.init.zeros_(network.last.weight)
    with torch.no_grad(), torch.autocast("cpu", torch.bfloat16):
        predicted = network(conditioning, occupancy, prior)
    assert predicted.dtype == torch.float32
    assert torch.equal(predicted, prior)


@pytest.mark.needs_torch
def test_paper_network_has_the_keys_and_shapes_of_dpt_large():
    import torch
    from transformers import DPTConfig, DPTForDepthEstimation

    from swifttailor.garment_sewer.network_torch import GarmentSewerNetwork, dpt_config

    with torch.device("meta"):
        ours = GarmentSewerNetwork(dpt_config(PAPER_NETWORK, 3)).state_dict()
        # The values of Intel/dpt-large's config.json that differ from the defaults of transformers.
        theirs = DPTForDepthEstimation(
            DPTConfig(
                hidden_size=1024,
                num_hidden_layers=24,
                num_attention_heads=16,
                intermediate_size=4096,
                image_size=256,
                neck_hidden_sizes=[256, 512, 1024, 1024],
                readout_type="project",
                reassemble_factors=[4, 2, 1, 0.5],
                backbone_out_indices=[5, 11, 17, 23],
            )
        ).state_dict()
    assert set(ours) == set(theirs)
    different = {k for k in ours if ours[k].shape != theirs[k].shape}
    assert different == {"head.head.4.weight", "head.head.4.bias"}


@pytest.mark.needs_torch
def test_weights_of_a_dpt_are_taken(tmp_path):
    import torch
    from transformers import DPTForDepthEstimation

    from swifttailor.garment_sewer.network_torch import build_network, dpt_config

    torch.manual_seed(3)
    other = DPTForDepthEstimation(dpt_config(replace(TINY, resolution=96), 3))
    other.save_pretrained(tmp_path)
    mine = build_network(replace(TINY, pretrained=str(tmp_path)), 5).state_dict()
    theirs = other.state_dict()
    patches = "dpt.embeddings.patch_embeddings.projection.weight"
    assert torch.equal(mine[patches][:, :3], theirs[patches])
    assert not mine[patches][:, 3:].any()
    assert mine["dpt.embeddings.position_embeddings"].shape == (1, 17, 32)
    same = [
        k
        for k in theirs
        if k in mine and mine[k].shape == theirs[k].shape and not k.startswith("head.head.4")
    ]
    assert len(same) > 80
    unequal = [k for k in same if not torch.equal(mine[k], theirs[k])]
    # The first fusion layer has no second input; what DPT keeps for it is not used.
    assert all(k.startswith("neck.fusion_stage.layers.0.residual") for k in unequal)


@pytest.mark.needs_torch
def test_encoder_of_a_vit_computes_the_same_here(tmp_path):
    import torch
    from transformers import ViTConfig, ViTModel

    from swifttailor.garment_sewer.network_torch import build_network

    torch.manual_seed(4)
    config = ViTConfig(
        hidden_size=32,
        num_hidden_layers=4,
        num_attention_heads=2,
        intermediate_size=128,
        image_size=64,
        layer_norm_eps=1e-6,
    )
    vit = ViTModel(config, add_pooling_layer=False).eval()
    vit.save_pretrained(tmp_path)
    network = build_network(replace(TINY, pretrained=str(tmp_path)), 3).eval()
    image = torch.randn(1, 3, 64, 64)
    with torch.no_grad():
        expected = vit(image, output_hidden_states=True).hidden_states
        found = network.dpt(image, output_hidden_states=True).hidden_states
    for a, b in zip(expected[:-1], found[:-1], strict=True):
        assert torch.allclose(a, b, atol=1e-5)


@pytest.mark.needs_torch
def test_weights_of_another_shape_or_kind_are_refused(tmp_path):
    from transformers import BertConfig, DPTForDepthEstimation

    from swifttailor.garment_sewer.network_torch import build_network, dpt_config

    DPTForDepthEstimation(dpt_config(replace(TINY, hidden_size=64), 3)).save_pretrained(tmp_path / "wide")
    BertConfig().save_pretrained(tmp_path / "bert")
    for source, said in (("wide", "do not fit"), ("bert", "'bert'"), ("nothing", "cannot be loaded")):
        with pytest.raises(InputError, match=said):
            build_network(replace(TINY, pretrained=str(tmp_path / source)), 5)


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ({"patch_size": 10}, "8, 16 or 32"),
        ({"resolution": 100}, "multiple of patch_size"),
        ({"heads": 3}, "multiple of heads"),
        ({"layers": 3}, "at least 4"),
        ({"output": "relative"}, "displacement or absolute"),
        ({"hidden_size": 0}, "at least 1"),
        ({"convolutions": (8, 8)}, "are 2 and network.patch_size is 8"),
        ({"convolutions": (8, 0, 8)}, "of at least 1"),
        ({"convolutions": (8, 8, 8), "pretrained": "x"}, "is of a DPT"),
    ],
)
def test_impossible_networks_are_refused(values, said):
    with pytest.raises(InputError, match=said):
        replace(NetworkConfig(), **values)


@pytest.mark.needs_torch
@pytest.mark.parametrize("shape", [replace(TINY, patch_size=8), HYBRID], ids=["dpt", "hybrid"])
def test_learns_what_is_told_at_the_other_end_of_the_image(shape):
    import torch

    from swifttailor.garment_sewer.network_torch import build_network

    torch.manual_seed(0)
    network = build_network(shape, 3).train()
    occupancy = torch.zeros(8, 1, 64, 64)
    occupancy[:, :, 40:, 40:] = 1
    prior = torch.zeros(8, 3, 64, 64)

    def garments():
        given = torch.randn(8, 3, 64, 64) * 0.3
        side = torch.randint(0, 2, (8, 1, 1, 1)) * 2.0 - 1
        given[:, :1, :8, :8] += side
        return given, side

    optimizer = torch.optim.AdamW(network.parameters(), lr=3e-3)
    for _ in range(100):
        given, side = garments()
        found = network(given, occupancy, prior)
        ((found - 5 * side).abs() * occupancy).mean().backward()
        optimizer.step()
        optimizer.zero_grad()
    network.eval()
    given, side = garments()
    with torch.no_grad():
        found = network(given, occupancy, prior)
    # What hears nothing of the other end is off by 5.
    assert float(((found - 5 * side).abs() * occupancy).sum() / (3 * occupancy.sum())) < 2.5
