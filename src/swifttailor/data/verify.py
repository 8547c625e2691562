"""Looking for faults in a data set: checksums, and everything that must hold of every sample."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from swifttailor.data.builder.settings import body_identity
from swifttailor.data.index import Shard, SplitIndex, split_folders
from swifttailor.data.reader import SplitReader
from swifttailor.data.renders.files import FOLDER as RENDERS
from swifttailor.data.renders.files import SplitRenders
from swifttailor.data.sample import Sample, load_sample
from swifttailor.data.shard_file import ShardFile
from swifttailor.draping.quality import seam_gap
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Severity, check_pattern
from swifttailor.pattern.digest import pattern_digest

REACH_CM = 400.0
"""No vertex of a garment on a body is farther from the origin than this."""
_TOP_CM = 0.02
"""By how much the stored height of a garment may differ from that of its 16-bit vertices."""


@dataclass(frozen=True)
class Fault:
    """Something in a data set that must not be."""

    file: str
    """Relative to the data set's folder."""
    sample: str
    """Id; empty where it concerns the file."""
    message: str

    def __str__(self) -> str:
        sample = f", sample '{self.sample}'" if self.sample else ""
        return f"{self.file}{sample}: {self.message}"


def verify_dataset(folder: Path, *, workers: int = 1) -> Iterator[Fault | int]:
    """Goes through a data set.

    Args:
        folder: The data set, or one split of it.
        workers: Processes.

    Yields:
        Faults, and between them numbers of samples that were looked at.

    Raises:
        InputError: There is no data set.
    """
    from swifttailor.workers import run_tasks

    readers: dict[str, SplitReader] = {}
    tasks: list[_Task] = []
    for name, path in split_folders(folder).items():
        try:
            readers[name] = reader = SplitReader(path)
        except SwiftTailorError as error:
            yield Fault(f"{name}/index.json", "", str(error))
            continue
        yield from _index_faults(name, reader.index, path)
        edge_length = reader.index.settings.get("edge_length")
        if not isinstance(edge_length, int | float):
            yield Fault(f"{name}/index.json", "", f"its edge length is {edge_length!r}; a number is expected")
            continue
        tasks += [_Task(path, name, s, float(edge_length)) for s in reader.index.shards]
        if (path / RENDERS).exists():
            yield from _render_faults(name, reader)
    patterns: dict[str, tuple[str, str]] = {}
    done = (_verify_shard(t) for t in tasks)
    if workers > 1:
        outcomes = run_tasks(_verify_shard, tasks, workers=workers, time_limit=36_000.0)
        done = (o.result or _lost(o.task, o.lost) for o in outcomes)
    for result in done:
        yield from result.faults
        yield len(result.patterns)
        for id, digest in result.patterns.items():
            other_split, other = patterns.setdefault(digest, (result.split, id))
            if other_split != result.split:
                yield Fault(
                    f"{result.split}/index.json", id, f"the same pattern as '{other}' in '{other_split}'"
                )
    yield from _shared_ids(readers)


@dataclass(frozen=True)
class _Task:
    folder: Path
    split: str
    shard: Shard
    edge_length: float


@dataclass(frozen=True)
class _Result:
    split: str
    faults: list[Fault]
    patterns: dict[str, str]
    """Checksum of the pattern without its name, of each id."""


def sample_faults(sample: Sample, edge_length: float) -> Iterator[str]:
    """What is wrong with a sample.

    Args:
        sample: Any sample.
        edge_length: Of its split, cm.
    """
    if sample.edge_length != edge_length:
        yield f"its edge length is {sample.edge_length:g} cm, that of the split {edge_length:g} cm"
    errors = [f for f in check_pattern(sample.pattern) if f.severity is Severity.ERROR]
    yield from (f"its pattern has an error: {f.code}: {f.message}" for f in errors[:3])
    vertices = sample.vertices
    if not np.isfinite(vertices).all() or np.abs(vertices).max(initial=0) > REACH_CM:
        yield f"a vertex lies beyond {REACH_CM:g} cm, or nowhere"
        return
    try:
        mesh = sample.mesh
    except SwiftTailorError as error:
        yield str(error)
        return
    gap = seam_gap(mesh, vertices)
    if gap > 0:
        yield f"a seam is open by {gap:g} cm"
    quality = sample.about.get("quality", {})
    if quality.get("accepted") is not True or quality.get("reasons"):
        yield f"it was not accepted: {'; '.join(quality.get('reasons', ['no quality is given']))}"
    top = float(vertices[:, 1].max())
    if abs(top - float(quality.get("top_cm", np.nan))) > _TOP_CM:
        yield f"its highest vertex is at {top:.2f} cm, its quality says {quality.get('top_cm')}"
    edges = mesh.faces[:, [0, 1]]
    flat = mesh.flat_vertices[mesh.flat_faces[:, [0, 1]]]
    rest = np.linalg.norm(flat[:, 0] - flat[:, 1], axis=1)
    stretch = np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1) / np.maximum(rest, 1e-6)
    if np.median(stretch) > 1.25 or np.median(stretch) < 0.5:
        yield f"its cloth is stretched to {np.median(stretch):.2f} of its length; are these its vertices?"


def _verify_shard(task: _Task) -> _Result:
    shard, name = task.shard, f"{task.split}/{task.shard.file}"
    faults: list[Fault] = []
    patterns: dict[str, str] = {}
    if not shard.file:
        return _Result(task.split, faults, patterns)
    path = task.folder / shard.file
    try:
        file = ShardFile(path, shard.sha256)
        if path.stat().st_size != shard.bytes:
            faults.append(
                Fault(name, "", f"it has {path.stat().st_size} bytes, the index says {shard.bytes}")
            )
        if len(file) != len(shard.ids):
            faults.append(Fault(name, "", f"it holds {len(file)} samples, the index says {len(shard.ids)}"))
    except (SwiftTailorError, OSError) as error:
        return _Result(task.split, [Fault(name, "", str(error))], patterns)
    for k, id in enumerate(shard.ids[: len(file)]):
        try:
            sample = load_sample(file[k])
            if sample.id != id:
                faults.append(Fault(name, id, f"the file has '{sample.id}' in its place"))
            faults += [Fault(name, id, text) for text in sample_faults(sample, task.edge_length)]
            patterns[id] = pattern_digest(sample.pattern)
        except SwiftTailorError as error:
            faults.append(Fault(name, id, str(error)))
    return _Result(task.split, faults, patterns)


def _lost(task: _Task, why: str) -> _Result:
    return _Result(task.split, [Fault(f"{task.split}/{task.shard.file}", "", f"not looked at: {why}")], {})


def _index_faults(name: str, index: SplitIndex, folder: Path) -> Iterator[Fault]:
    file = f"{name}/index.json"
    if index.split != name:
        yield Fault(file, "", f"it is of the split '{index.split}' in a folder named '{name}'")
    if not index.complete:
        yield Fault(file, "", "the build is not complete; run the same command again")
    shards = index.shards
    if shards and shards[0].first != 0:
        yield Fault(file, "", f"the first {shards[0].first} patterns of the input are missing")
    for before, after in pairwise(shards):
        if before.last != after.first:
            yield Fault(file, "", f"after pattern {before.last} of the input comes pattern {after.first + 1}")
    if index.patterns != sum(s.last - s.first for s in shards):
        yield Fault(file, "", f"it counts {index.patterns} patterns, its shards do not")
    for shard in shards:
        places = [r.position for r in shard.rejected]
        inside = all(shard.first <= p < shard.last for p in places) and len(set(places)) == len(places)
        if not inside or len(shard.ids) + len(places) != shard.last - shard.first:
            yield Fault(f"{name}/{shard.file}", "", "its samples and rejected patterns are not its range")
        if bool(shard.ids) != bool(shard.file):
            yield Fault(file, "", f"the range from pattern {shard.first + 1} has samples or a file, not both")
    ids = Counter(id for s in shards for id in s.ids)
    yield from (Fault(file, id, f"the id occurs {count} times") for id, count in ids.items() if count > 1)
    known = {s.file for s in shards}
    for path in sorted(folder.glob("shard-*")):
        if path.name not in known:
            yield Fault(
                f"{name}/{path.name}", "", "no index names this file; going on with the build removes it"
            )
    body = index.settings.get("body", {})
    if body.get("name") == "default":
        from swifttailor.body import Body

        if body != body_identity(Body.default()):
            yield Fault(file, "", "it was draped on another default body than that of this version")


def _render_faults(name: str, reader: SplitReader) -> Iterator[Fault]:
    try:
        for message in SplitRenders(reader).verify():
            yield Fault(f"{name}/{RENDERS}", "", message)
    except SwiftTailorError as error:
        yield Fault(f"{name}/{RENDERS}", "", str(error))


def _shared_ids(readers: dict[str, SplitReader]) -> Iterator[Fault]:
    first: dict[str, str] = {}
    for name, reader in readers.items():
        for id in reader.ids:
            other = first.setdefault(id, name)
            if other != name:
                yield Fault(f"{name}/index.json", id, f"the id is in the split '{other}', too")
