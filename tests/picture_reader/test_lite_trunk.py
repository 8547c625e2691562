"""The trunk that has seen photographs."""

from __future__ import annotations

import runpy
from dataclasses import asdict
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

torch = pytest.importorskip("torch")
pytestmark = pytest.mark.needs_torch

SCRIPT = Path(__file__).parents[2] / "scripts/take_picture_trunk_torch.py"


def padded_as_tensorflow(x, weight, stride, groups):
    """Padding "SAME", as TensorFlow documents it."""
    kernel = weight.shape[-1]
    around = []
    for size in reversed(x.shape[-2:]):
        total = max((-(-size // stride) - 1) * stride + kernel - size, 0)
        around += [total // 2, total - total // 2]
    return torch.nn.functional.conv2d(
        torch.nn.functional.pad(x, around), weight, stride=stride, groups=groups
    )


@given(
    kernel=st.sampled_from((3, 5)),
    stride=st.sampled_from((1, 2)),
    down=st.integers(2, 6),
    across=st.integers(2, 6),
    grouped=st.booleans(),
)
def test_convolutions_pad_as_those_that_the_weights_were_learnt_for(kernel, stride, down, across, grouped):
    from swifttailor.picture_reader.lite_trunk_torch import _SameConv

    groups = 4 if grouped else 1
    conv = _SameConv(4, 4, kernel, stride, groups)
    x = torch.randn(2, 4, down * 2, across * 2)
    with torch.no_grad():
        expected = padded_as_tensorflow(x, conv.weight, stride, groups)
        assert torch.allclose(conv(x), expected, atol=1e-5)


@pytest.mark.parametrize(
    ("name", "all_weights", "last"),
    [("efficientnet-lite0", 4_652_008, 320), ("efficientnet-lite2", 6_092_072, 352)],
)
def test_stages_halve_the_resolution_and_have_the_weights_of_the_paper(name, all_weights, last):
    from swifttailor.picture_reader.lite_trunk_torch import LiteTrunk

    trunk = LiteTrunk(name, 3).eval()
    x = trunk.embedder(torch.rand(1, 3, 64, 96))
    assert len(trunk.channels) == 4 and trunk.channels[-1] == last
    for stage, channels, stride in zip(trunk.stages, trunk.channels, (4, 8, 16, 32), strict=True):
        x = stage(x)
        assert x.shape == (1, channels, 64 // stride, 96 // stride)
    # Of all weights of the network the head has the rest.
    head = last * 1280 + 2 * 1280 + 1280 * 1000 + 1000
    assert sum(p.numel() for p in trunk.parameters()) == all_weights - head


@pytest.mark.parametrize(
    ("name", "more", "off"), [("efficientnet-lite0", [], 1e-5), ("efficientnet-lite2", ["--half"], 5e-3)]
)
def test_a_reader_begins_with_its_weights_and_not_yet_with_what_it_is_told(
    tmp_path, monkeypatch, name, more, off
):
    from safetensors.torch import load_file

    from swifttailor.picture_reader.export_torch import build_network
    from swifttailor.picture_reader.lite_trunk_torch import LiteTrunk
    from swifttailor.training.picture_config import EyesSize
    from swifttailor.training.start_torch import load_start

    torch.manual_seed(3)
    given = LiteTrunk(name, 3)
    for module in given.modules():
        if isinstance(module, torch.nn.BatchNorm2d):
            torch.nn.init.normal_(module.bias)
            module.running_mean.normal_()
            module.running_var.uniform_(0.5, 2)
    values = [value for name, value in given.state_dict().items() if "num_batches" not in name]
    named = {f"_blocks.{k}": value for k, value in enumerate(values)}
    torch.save(named | {"_conv_head.weight": torch.zeros(1280, 320, 1, 1)}, tmp_path / "lite.pth")
    start = tmp_path / "start.safetensors"
    monkeypatch.setattr(
        "sys.argv", [str(SCRIPT), str(tmp_path / "lite.pth"), "--name", name, *more, "--start", str(start)]
    )
    runpy.run_path(str(SCRIPT), run_name="__main__")

    network = build_network(asdict(EyesSize(trunk=name))).eval()
    load_start(network, start)
    assert load_file(start).keys() == network.state_dict().keys()
    pictures = torch.rand(1, 3, 64, 64)
    told = torch.tensor([[0.3, 0.1, 0.9, 0.2, 0.1, -0.1, 1.0]])
    with torch.no_grad():
        expected = given.eval().embedder((pictures - 0.5) / 0.5)
        for k in range(2):
            expected = given.stages[k](expected)
            assert torch.allclose(network.trunk(pictures, told)[k], expected, atol=off, rtol=off)
