"""Configurations of a training: named, from files, with values changed."""

from __future__ import annotations

import json

import pytest

from swifttailor.errors import InputError
from swifttailor.garment_sewer.conditioning import Conditioning
from swifttailor.training.config_file import changed_config, config_values
from swifttailor.training.sewer_config import CONFIGS, SewerConfig, read_config


@pytest.mark.parametrize("name", list(CONFIGS))
def test_a_configuration_survives_its_file(name, tmp_path):
    path = tmp_path / "config.json"
    path.write_text(json.dumps(config_values(CONFIGS[name])))
    assert (
        read_config(str(path)) == CONFIGS[name] == changed_config(SewerConfig(), config_values(CONFIGS[name]))
    )


def test_a_file_says_only_what_differs_from_small(tmp_path):
    path = tmp_path / "config.json"
    path.write_text('{"steps": 5, "losses": {"strain": 2}}')
    config = read_config(str(path))
    assert config.steps == 5
    assert config.losses.strain == 2.0
    assert config.losses.edge == SewerConfig().losses.edge
    assert config.network == SewerConfig().network


def test_values_are_changed_in_order():
    changes = [
        "steps=7",
        "steps=8",
        "losses.edge=100",
        "conditioning.prior=placed",
        'conditioning.channels=["color", "local"]',
        "network.decoder_sizes=[8, 8, 8, 8]",
        "precision=float32",
    ]
    config = read_config("small", changes)
    assert config.steps == 8
    assert config.losses.edge == 100.0
    assert isinstance(config.losses.edge, float)
    assert config.conditioning == Conditioning("placed", ("color", "local"))
    assert config.network.decoder_sizes == (8, 8, 8, 8)
    assert config.precision == "float32"


def test_values_are_judged_together():
    changes = ["conditioning.prior=none", 'conditioning.channels=["color"]', "network.output=absolute"]
    config = read_config("small", changes)
    assert config.conditioning == Conditioning("none", ("color",))
    assert config.network.output == "absolute"


def test_paper_has_the_papers_losses_and_conditioning():
    config = CONFIGS["paper"]
    assert (config.losses.regression, config.losses.edge, config.losses.edge_band) == (1, 100, 10)
    assert (config.losses.stitching, config.losses.normals) == (1000, 0.01)
    assert config.losses.seam_pairs == config.losses.strain == config.losses.penetration == 0
    assert config.conditioning.channels == ("color",)
    assert (config.network.hidden_size, config.network.layers, config.network.patch_size) == (1024, 24, 16)


@pytest.mark.parametrize(
    ("name", "changes", "said"),
    [
        ("medium", [], "small or small-dpt or paper"),
        ("small", ["steps"], "field=value"),
        ("small", ["step=3"], "no 'step'"),
        ("small", ["loss.edge=3"], "'loss' is not a group"),
        ("small", ["losses.edgy=3"], "no 'losses.edgy'"),
        ("small", ["steps=many"], "steps is 'many'"),
        ("small", ["steps=true"], "steps is True"),
        ("small", ["steps=0"], "at least 1"),
        ("small", ["losses=3"], "an object of fields"),
        ("small", ["mirror=2"], "0 to 1"),
        ("small", ["precision=half"], "float32 or bfloat16"),
        ("small", ['conditioning.prior="none"'], "needs a prior"),
        ("paper", ["network.output=displacement"], "no prior to displace"),
        ("small", ["conditioning.layout=stacked"], "no layout 'stacked'"),
        ("small", ["conditioning.layout=3"], "layout is 3"),
        ("per-panel", ["layouts=2"], "per_panel only 1"),
    ],
)
def test_what_cannot_be_is_refused(name, changes, said):
    with pytest.raises(InputError, match=said):
        read_config(name, changes)
