"""Model files that read pictures are opened, and refused, before any work is done."""

from __future__ import annotations

import pytest

from swifttailor.cli.picture_reader_files import chosen_reader
from swifttailor.errors import InputError
from swifttailor.picture_reader.reader import SHIPPED, SHIPPED_PLAIN, PictureReader


def test_without_files_of_ones_own_those_of_the_package_are_left_to_open():
    assert chosen_reader(None, [], []) is None


@pytest.mark.parametrize(
    ("option", "files"), [("--close-up-weights", {"close_ups": 1}), ("--plain-reader-weights", {"plain": 1})]
)
def test_details_need_a_reader_of_the_whole(option, files, tmp_path):
    given = {"close_ups": [], "plain": []} | {name: [tmp_path / "mine.onnx"] for name in files}
    with pytest.raises(InputError, match=rf"{option} '.*mine\.onnx' goes with .*--picture-reader-weights"):
        chosen_reader(None, **given)


@pytest.mark.skipif(not SHIPPED.exists(), reason="the package has no picture reader")
def test_a_damaged_reader_of_plain_pictures_is_refused_at_once(tmp_path):
    damaged = tmp_path / "damaged.onnx"
    damaged.write_bytes(b"no model")
    with pytest.raises(InputError, match=r"damaged\.onnx"):
        chosen_reader(SHIPPED, [], [damaged])


@pytest.mark.skipif(not SHIPPED.exists(), reason="the package has no picture reader")
def test_all_files_of_the_package_may_be_named(tmp_path):
    reader = chosen_reader(SHIPPED, [], SHIPPED_PLAIN)
    assert isinstance(reader, PictureReader) and reader.plain is not None
    assert reader.plain().card == PictureReader.load(SHIPPED_PLAIN[0]).card
