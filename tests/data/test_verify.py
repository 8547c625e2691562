from __future__ import annotations

import dataclasses
import hashlib
import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from sample_makers import make_placed, run_here

from swifttailor.data.builder import BuildSettings, build_split
from swifttailor.data.reader import SplitReader
from swifttailor.data.sample import Sample, store_sample
from swifttailor.data.shard_file import write_shard
from swifttailor.data.verify import Fault, sample_faults, verify_dataset
from swifttailor.draping.batch import BatchSettings
from swifttailor.errors import InputError
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.garmentcode_writer import to_specification
from swifttailor.pattern.pattern_list import read_patterns

COARSE = BuildSettings(BatchSettings(edge_length=5.0, preview=False), shard_size=2)


def patterns(path: Path, **drafts: str) -> Path:
    lines = [json.dumps({"id": id, "pattern": to_specification(draft(name))}) for id, name in drafts.items()]
    path.write_text("\n".join(lines))
    return path


@pytest.fixture
def dataset(tmp_path) -> Path:
    train = patterns(tmp_path / "train.jsonl", a="fitted-skirt", b="tank-top", c="gathered-skirt")
    test = patterns(tmp_path / "test.jsonl", d="shirt-dress")
    for source, split in ((train, "train"), (test, "test")):
        build_split(read_patterns(source), tmp_path / "set", split, COARSE, runner=run_here, make=make_placed)
    return tmp_path / "set"


def faults(dataset: Path, **options) -> list[Fault]:
    return [f for f in verify_dataset(dataset, **options) if isinstance(f, Fault)]


def the_fault(dataset: Path) -> Fault:
    (found,) = faults(dataset)
    return found


def shard_paths(dataset: Path) -> list[Path]:
    return sorted((dataset / "train").glob("shard-*"))


def edit_index(dataset: Path, **changes) -> None:
    path = dataset / "train" / "index.json"
    value = json.loads(path.read_text())
    for name, change in changes.items():
        value[name] = change(value[name])
    path.write_text(json.dumps(value))


def test_a_sound_data_set_has_no_faults(dataset):
    assert list(SplitReader(dataset / "train").ids) == ["a", "b", "c"]
    assert list(verify_dataset(dataset)) == [1, 2, 1]
    assert sorted(verify_dataset(dataset, workers=2)) == [1, 1, 2]
    assert sum(verify_dataset(dataset / "train")) == 3
    with pytest.raises(InputError, match="holds no data set"):
        list(verify_dataset(dataset / "train" / ".samples"))


@pytest.mark.parametrize("workers", [1, 2])
def test_damaged_and_missing_shards(dataset, workers):
    first, second = shard_paths(dataset)
    data = bytearray(first.read_bytes())
    data[len(data) // 2] ^= 1
    first.write_bytes(bytes(data))
    second.unlink()
    found = sorted(faults(dataset, workers=workers), key=lambda f: f.file)
    assert [f.file for f in found] == [f"train/{first.name}", f"train/{second.name}"]
    assert "its checksum is" in found[0].message and "No such file" in found[1].message


def test_a_file_that_no_index_names(dataset):
    first, _ = shard_paths(dataset)
    shutil.copy(first, dataset / "train" / "shard-00009-abc.safetensors")
    assert the_fault(dataset).file == "train/shard-00009-abc.safetensors"


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"complete": lambda _: False}, "build is not complete"),
        ({"split": lambda _: "other"}, "it is of the split 'other'"),
        ({"patterns": lambda n: n + 1}, "it counts 4 patterns"),
        ({"settings": lambda s: s | {"body": s["body"] | {"sha256": "0"}}}, "another default body"),
    ],
)
def test_faults_of_the_index(changes, message, dataset):
    edit_index(dataset, **changes)
    found = the_fault(dataset)
    assert found.file == "train/index.json" and message in found.message


def test_gaps_and_ranges_that_do_not_add_up(dataset):
    edit_index(dataset, shards=lambda s: [s[0] | {"last": 1}, s[1]], patterns=lambda n: 2)
    messages = [f.message for f in faults(dataset)]
    assert messages == [
        "after pattern 1 of the input comes pattern 3",
        "its samples and rejected patterns are not its range",
    ]
    edit_index(dataset, shards=lambda s: s[1:], patterns=lambda n: 1)
    assert "the first 2 patterns of the input are missing" in [f.message for f in faults(dataset)]


def test_an_unreadable_index_does_not_hide_the_other_splits(dataset):
    (dataset / "test" / "index.json").write_text("{")
    first, _ = shard_paths(dataset)
    first.unlink()
    assert [f.file for f in faults(dataset)] == ["test/index.json", f"train/{first.name}"]


def test_patterns_in_two_splits(dataset, tmp_path):
    """The builder refuses both, but splits may be put together by hand."""
    copy = patterns(tmp_path / "v.jsonl", z="tank-top")
    apart = tmp_path / "apart"
    build_split(read_patterns(copy), apart, "validation", COARSE, runner=run_here, make=make_placed)
    shutil.move(apart / "validation", dataset / "validation")
    (found,) = faults(dataset)
    assert found.sample == "z" and "the same pattern as 'b' in 'train'" in found.message
    shutil.rmtree(dataset / "validation")
    shutil.copytree(dataset / "test", dataset / "validation")
    path = dataset / "validation" / "index.json"
    path.write_text(path.read_text().replace('"split": "test"', '"split": "validation"'))
    messages = {f.message for f in faults(dataset)}
    assert "the id is in the split 'test', too" in messages


def test_each_invariant_of_a_sample(dataset):
    sample = SplitReader(dataset / "train").sample("b")

    def found(**changes) -> str:
        changed = dataclasses.replace(sample, **changes)
        return "; ".join(sample_faults(changed, 5.0))

    assert found() == ""
    quality = sample.about["quality"]
    moved = sample.vertices + np.array([0, 0.5, 0])
    far, nowhere = sample.vertices.copy(), sample.vertices.copy()
    far[3, 0] = 500
    nowhere[3, 0] = np.nan
    mixed = sample.vertices[np.random.default_rng(0).permutation(len(sample.vertices))]
    assert "quality says" in found(vertices=moved)
    assert "beyond 400 cm" in found(vertices=far) and "nowhere" in found(vertices=nowhere)
    assert "are these its vertices?" in found(vertices=mixed)
    assert "panel mesh is not the one" in found(vertices=sample.vertices[:-1])
    assert "panel mesh is not the one" in found(checksum="0" * 32)
    assert "not accepted: too tight" in found(
        about={"quality": quality | {"accepted": False, "reasons": ["too tight"]}}
    )
    assert "no quality is given" in found(about={})
    assert "edge length is 4 cm" in found(edge_length=4.0)
    stitch = sample.pattern.stitches[0]
    twice = dataclasses.replace(sample.pattern, stitches=(*sample.pattern.stitches, stitch))
    assert "its pattern has an error" in found(pattern=twice)


def test_faulty_samples_are_named(dataset):
    """A shard whose checksum is right and whose content is wrong."""
    folder = dataset / "train"
    reader = SplitReader(folder)
    samples = [reader[0], dataclasses.replace(reader[1], vertices=reader[1].vertices + np.array([0, 1.0, 0]))]
    path, checksum = write_shard(folder, "shard-00000", [store_sample(s) for s in samples])
    old = shard_paths(dataset)
    edit_index(
        dataset,
        shards=lambda s: [s[0] | {"file": path.name, "sha256": checksum, "bytes": path.stat().st_size}, s[1]],
    )
    for other in old:
        if other.name.startswith("shard-00000") and other != path:
            other.unlink()
    found = the_fault(dataset)
    assert found.sample == "b" and found.file == f"train/{path.name}" and "highest vertex" in found.message
    assert str(found).startswith(f"train/{path.name}, sample 'b': ")
    assert hashlib.sha256(path.read_bytes()).hexdigest() == checksum
    assert isinstance(samples[1], Sample)
