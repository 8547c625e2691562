"""Model files that read pictures are opened, and refused, before any work is done."""

from __future__ import annotations

import pytest

from swifttailor.cli.picture_reader_files import chosen_reader
from swifttailor.errors import InputError
from swifttailor.picture_reader.reader import (
    SHIPPED,
    SHIPPED_LAID,
    SHIPPED_PLAIN,
    SHIPPED_SHOP,
    PictureReader,
)


def test_without_files_of_ones_own_those_of_the_package_are_left_to_open():
    assert chosen_reader(None, [], []) is None


@pytest.mark.parametrize(
    ("option", "more"),
    [
        ("--close-up-weights", {"close_ups": ["mine.onnx"]}),
        ("--plain-reader-weights", {"plain": ["mine.onnx"]}),
        ("--laid-reader-weights", {"laid": "mine.onnx"}),
        ("--shop-reader-weights", {"shop": "mine.onnx"}),
    ],
)
def test_details_need_a_reader_of_the_whole(option, more):
    given = {"close_ups": [], "plain": []} | more
    with pytest.raises(InputError, match=rf"{option} 'mine\.onnx' goes with .*--picture-reader-weights"):
        chosen_reader(None, **given)


@pytest.mark.skipif(not SHIPPED.exists(), reason="the package has no picture reader")
def test_a_damaged_reader_of_plain_pictures_is_refused_at_once(tmp_path):
    damaged = tmp_path / "damaged.onnx"
    damaged.write_bytes(b"no model")
    with pytest.raises(InputError, match=r"damaged\.onnx"):
        chosen_reader(SHIPPED, [], [damaged])
    with pytest.raises(InputError, match=r"damaged\.onnx"):
        chosen_reader(SHIPPED, [], [], damaged)
    with pytest.raises(InputError, match=r"damaged\.onnx"):
        chosen_reader(SHIPPED, [], [], None, damaged)


@pytest.mark.skipif(not SHIPPED.exists(), reason="the package has no picture reader")
def test_all_files_of_the_package_may_be_named(tmp_path):
    reader = chosen_reader(SHIPPED, [], SHIPPED_PLAIN, SHIPPED_LAID, SHIPPED_SHOP)
    assert isinstance(reader, PictureReader) and reader.plain is not None and reader.laid is not None
    assert reader.laid().card["config"]["laid"] > 0
    assert reader.shop().card["config"]["photograph"] > 0 == reader.shop().card["config"]["laid"]
    assert reader.plain().card == PictureReader.load(SHIPPED_PLAIN[0]).card
