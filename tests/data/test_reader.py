from __future__ import annotations

import json
import pickle
import shutil
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from sample_makers import COARSE, make_quickly, run_here

from swifttailor.data.array_cache import ArrayCache
from swifttailor.data.builder import build_split
from swifttailor.data.geometry_images import GeometryImages, draw
from swifttailor.data.reader import SplitReader
from swifttailor.data.shard_file import ShardFile
from swifttailor.errors import InputError
from swifttailor.ggi import encode
from swifttailor.pattern.pattern_list import read_patterns

IDS = ("a", "bad-b", "c", "d", "e", "f", "g", "h", "i")


@pytest.fixture
def split(patterns_file, tmp_path) -> Path:
    build_split(
        read_patterns(patterns_file(*IDS)),
        tmp_path / "set",
        "train",
        COARSE,
        runner=run_here,
        make=make_quickly,
    )
    return tmp_path / "set" / "train"


def test_samples_by_number_and_id(split):
    reader = SplitReader(split)
    ids = [i for i in IDS if i != "bad-b"]
    assert len(reader) == 8 and list(reader.ids) == ids == [s.id for s in reader]
    assert [reader[k].id for k in range(8)] == ids and reader.sample("g").id == "g"
    assert [list(reader.numbers_in(n)) for n in range(3)] == [[0, 1, 2], [3, 4, 5, 6], [7]]
    assert [reader.place(k) for k in (0, 2, 3, 7)] == [(0, 0), (0, 2), (1, 0), (2, 0)]
    for k in (-1, 8):
        with pytest.raises(IndexError, match="8 samples"):
            reader[k]
    with pytest.raises(InputError, match="no sample 'bad-b'"):
        reader.sample("bad-b")
    assert [s.id for s in pickle.loads(pickle.dumps(reader))] == ids


def test_shuffles_give_every_sample_once_and_are_repeatable(split):
    reader = SplitReader(split)
    orders = {tuple(s.id for s in reader.shuffled(seed, epoch)) for seed in (1, 2) for epoch in (0, 1)}
    assert len(orders) == 4 and {tuple(sorted(o)) for o in orders} == {tuple(sorted(reader.ids))}
    assert [s.id for s in reader.shuffled(1)] == [s.id for s in SplitReader(split).shuffled(1)]
    parts = [[s.id for s in reader.shuffled(1, part=k, parts=3)] for k in range(3)]
    assert sorted(id for p in parts for id in p) == sorted(reader.ids)
    assert max(map(len, parts)) - min(map(len, parts)) <= 1


def test_faults_name_the_file(split):
    shards = sorted(split.glob("shard-*"))
    whole = shards[1].read_bytes()

    def reads(what: bytes | None) -> pytest.ExceptionInfo:
        if what is None:
            shards[1].unlink()
        else:
            shards[1].write_bytes(what)
        with pytest.raises(InputError) as caught:
            SplitReader(split).sample("f")
        assert SplitReader(split).sample("a").id == "a", "other shards are not touched by it"
        return caught

    flipped = bytearray(whole)
    flipped[-30] ^= 1
    for what in (bytes(flipped), whole[:-50], b"", shards[0].read_bytes(), b"x" * len(whole)):
        assert reads(what).match(rf"'{shards[1]}' is damaged or another file: its checksum")
    assert reads(None).match(rf"Cannot read the shard '{shards[1]}': No such file")
    index = split / "index.json"
    text = index.read_text()
    for wrong in (text[:-40], text.replace('"shards"', '"shard"'), "[]", text.replace("split 1", "split 9")):
        index.write_text(wrong)
        with pytest.raises(InputError, match=r"index\.json"):
            SplitReader(split)
    index.unlink()
    with pytest.raises(InputError, match="is no split of a data set"):
        SplitReader(split)


def test_an_index_that_does_not_fit_its_shards(split):
    index = split / "index.json"
    text = index.read_text()
    index.write_text(text.replace('"a"', '"z"'))
    with pytest.raises(InputError, match=r"holds 'a' where the index says 'z'"):
        SplitReader(split).sample("z")
    index.write_text(text.replace('    "a",\n', ""))
    with pytest.raises(InputError, match=r"holds 3 samples, the index says 2"):
        SplitReader(split).sample("c")


@pytest.mark.parametrize("damage", ["header", "cut", "ends"])
def test_damaged_shards_without_a_checksum(damage, split):
    path = next(split.glob("shard-00001*"))
    data = path.read_bytes()
    path.write_bytes({"header": b"\xff" * 8 + data[8:], "cut": data[:-9], "ends": data[:100]}[damage])
    with pytest.raises(InputError, match=rf"'{path}'"):
        ShardFile(path)
    from safetensors.numpy import save

    path.write_bytes(save({"documents": np.zeros(3, np.uint8)}, metadata={"format": "other"}))
    with pytest.raises(InputError, match="is no shard of this version"):
        ShardFile(path)


# Arrays that are computed once


def lengths(sample, factor=1):
    """Ragged and fixed arrays."""
    count = int(sample.id, 36) % 7
    return {
        "ragged": np.full((count, 2), count * factor, np.int16),
        "one": np.array([[len(sample.vertices)]]),
    }


def test_cached_arrays_are_those_that_were_computed(split, tmp_path):
    reader = SplitReader(split)
    cache = ArrayCache(reader, tmp_path / "cache", "lengths", partial(lengths, factor=3))
    steps = list(cache.prepare(workers=2))
    assert steps == [(1, 3), (2, 3), (3, 3)] and list(cache.prepare()) == []
    files = {p.name: p.stat().st_mtime_ns for p in (tmp_path / "cache").iterdir()}
    for k in reader.order(5):
        found, plain = cache[k], lengths(reader[k], factor=3)
        assert found.keys() == plain.keys()
        for name in plain:
            np.testing.assert_array_equal(found[name], plain[name])
            assert found[name].dtype == plain[name].dtype
    (tmp_path / "cache" / cache.path(1).name).unlink()
    assert len(pickle.loads(pickle.dumps(cache))[4]["ragged"]) == int(reader.ids[4], 36) % 7
    assert {p.name for p in (tmp_path / "cache").iterdir()} == set(files)
    cache.path(0).write_bytes(b"damaged")
    with pytest.raises(InputError, match=r"is damaged.*Delete it"):
        ArrayCache(reader, tmp_path / "cache", "lengths", partial(lengths, factor=3))[0]


def test_a_cache_over_damaged_data_names_the_shard(split, tmp_path):
    cache = ArrayCache(SplitReader(split), tmp_path / "cache", "lengths", lengths)
    next(split.glob("shard-00001*")).write_bytes(b"")
    assert cache[0]["one"].shape == (1, 1)
    with pytest.raises(InputError, match=r"shard-00001"):
        cache[4]
    with pytest.raises(InputError, match=r"shard-00001"):
        list(cache.prepare(workers=2))


def test_geometry_images_are_those_that_are_drawn(split, tmp_path):
    reader = SplitReader(split)
    images = GeometryImages(reader, tmp_path / "images", 64)
    for k in (0, 5):
        found, plain = images[k], encode(reader[k].garment, 64)
        for name in ("occupancy", "panel", "semantic"):
            np.testing.assert_array_equal(getattr(found, name), getattr(plain, name))
            assert getattr(found, name).dtype == getattr(plain, name).dtype
        for name in ("ids", "pixels", "fraction", "start"):
            np.testing.assert_array_equal(getattr(found.stitching, name), getattr(plain.stitching, name))
        assert found.geometry is not None and plain.geometry is not None
        extent = np.ptp(reader[k].vertices, axis=0).max()
        assert np.abs(found.geometry - plain.geometry).max() <= extent / 2**16 + 1e-4
        assert found.geometry.dtype == np.float32
    assert set(draw(reader[0], 64)) >= {"occupancy", "geometry"}
    assert json.loads((split / "index.json").read_text())["complete"]


def test_a_copied_split_reads_alike(split, tmp_path):
    shutil.copytree(split, tmp_path / "copy")
    assert SplitReader(tmp_path / "copy").ids == SplitReader(split).ids
