"""Photographs are told from drawings."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from swifttailor.errors import InputError
from swifttailor.picture_reader.photograph_head import LEAST_LOGIT, SHIPPED, PhotographHead
from swifttailor.picture_reader.worn_heads import WornHeads

IMAGES = Path(__file__).parents[2] / "docs/images"


@pytest.fixture(scope="module")
def head():
    return PhotographHead.load(WornHeads.load().trunk)


@pytest.mark.parametrize(
    ("name", "square", "photograph"),
    [
        ("woman-with-dog.jpg", (-202, 0, 769), True),
        ("shirt-dress.png", (0, -256, 1280), False),
        *[("pictures-to-read.webp", (128 * k, 128 * k, 128), False) for k in range(0, 8, 2)],
    ],
)
def test_a_photograph_is_told_from_drawings(head, name, square, photograph):
    pixels = np.asarray(Image.open(IMAGES / name).convert("RGB"))
    logit = head.logit(pixels, square)
    assert (logit >= LEAST_LOGIT) == photograph
    left, top, side = square
    mirrored = head.logit(np.ascontiguousarray(pixels[:, ::-1]), (pixels.shape[1] - left - side, top, side))
    assert mirrored == pytest.approx(logit, abs=0.3)


def test_another_file_is_refused(tmp_path):
    trunk = WornHeads.load().trunk
    damaged = tmp_path / "head.onnx"
    damaged.write_bytes(SHIPPED.read_bytes()[:-100])
    with pytest.raises(InputError, match=r"head\.onnx"):
        PhotographHead.load(trunk, damaged)
    with pytest.raises(InputError, match=r"not a network that tells photographs from drawings"):
        PhotographHead.load(trunk, SHIPPED.with_name("laid_heads.onnx"))
