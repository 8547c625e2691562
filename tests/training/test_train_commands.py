"""What the commands that train hand over is what the networks' trainings take."""

from __future__ import annotations

import inspect
from importlib import import_module
from pathlib import Path

import pytest

from swifttailor.cli.train_garment_sewer import TrainGarmentSewer
from swifttailor.cli.train_pattern_maker import TrainPatternMaker
from swifttailor.cli.train_picture_reader import TrainPictureReader
from swifttailor.cli.train_wish_reader import TrainWishReader
from swifttailor.errors import SwiftTailorError

FILES, RUN = (Path("patterns.jsonl"),), Path("run")


@pytest.mark.needs_torch
@pytest.mark.parametrize(
    ("command", "loop"),
    [
        (TrainGarmentSewer(data=Path("data"), out=RUN), "sewer_loop_torch"),
        (TrainPatternMaker(patterns=FILES, out=RUN), "maker_loop_torch"),
        (TrainWishReader(patterns=FILES, validation=FILES, out=RUN), "wish_loop_torch"),
    ],
)
def test_every_option_is_a_parameter(command, loop):
    from swifttailor.training.loop_torch import RunOptions

    named = set(inspect.signature(import_module(f"swifttailor.training.{loop}").train).parameters)
    taken = named - {"config", "options"} | set(RunOptions.__annotations__) - {"stop_after"}
    assert set(command.arguments()) == taken


@pytest.mark.needs_torch
def test_pictures_may_be_drawn_between_the_steps(tmp_path):
    from swifttailor.training import picture_config, wish_config

    pictures = TrainPictureReader(data=FILES, validation=FILES, out=tmp_path / "run", workers=0)
    assert pictures.checked_config(picture_config.read_config) and pictures._arguments()["workers"] == 0
    texts = TrainWishReader(patterns=FILES, validation=FILES, out=tmp_path / "run", workers=0)
    with pytest.raises(SwiftTailorError, match="--workers"):
        texts.checked_config(wish_config.read_config)
