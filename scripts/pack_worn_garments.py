"""Packs sewn garments, measured, for training a picture reader elsewhere: 9 kB each.

``python scripts/pack_worn_garments.py SEWN/train SEWN/validation --out packed``
``python scripts/pack_worn_garments.py --unpack packed --out DATA``

The first measures and meshes what has not been (0.1 s of a core each) and writes packed/1, packed/2 ... in
the order given; the second makes splits of them that ``swifttailor train picture-reader`` draws. Their
patterns are not there, so nothing else can be done with them.
"""

from __future__ import annotations

import argparse
import os
from pathlib import Path

from safetensors.numpy import load_file, save

from swifttailor.atomic_files import write_bytes
from swifttailor.data.pictures.bank import open_cache
from swifttailor.data.pictures.packed_garments import pack, unpack
from swifttailor.workers import run_tasks

INDEX = "index.json"
PACKED = ".xz"
_HOURS = 3600.0


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("splits", type=Path, nargs="*", help="folders of splits of sewn or draped garments")
    parser.add_argument("--unpack", type=Path, help="folder of packed ones, instead of splits")
    parser.add_argument("--out", type=Path, required=True, help="folder to write")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args()
    if bool(options.splits) == bool(options.unpack):
        parser.error("give either splits to pack or --unpack")
    lost = 0
    if options.unpack:
        tasks = [
            (file, options.out / file.parent.name) for file in sorted(options.unpack.glob(f"*/*{PACKED}"))
        ]
        for folder in sorted(options.unpack.glob(f"*/{INDEX}")):
            copy(folder, options.out / folder.parent.name / INDEX)
    else:
        tasks = [(split, options.out / str(number)) for number, split in enumerate(options.splits, 1)]
    for outcome in run_tasks(
        unpack_one if options.unpack else pack_split, tasks, workers=options.workers, time_limit=_HOURS
    ):
        print(outcome.lost or outcome.result, flush=True)
        lost += bool(outcome.lost)
    if lost:
        raise SystemExit(f"{lost} of {len(tasks)} could not be made.")


def pack_split(task: tuple[Path, Path]) -> str:
    """Packs the files of a split, each with a shard's garments."""
    split, out = task
    cache = open_cache(split)
    for _ in cache.prepare():
        pass
    size = 0
    for number, shard in enumerate(cache.reader.index.shards):
        if shard.file:
            packed = pack(load_file(cache.path(number)))
            write_bytes(out / f"{shard.sha256}{PACKED}", packed, overwrite=True)
            size += len(packed)
    copy(split / INDEX, out / INDEX)
    return f"{split}: {len(cache)} garments in {size / 1e6:.1f} MB"


def unpack_one(task: tuple[Path, Path]) -> str:
    """Writes what a `PictureBank` would have measured of a shard."""
    file, split = task
    cache = open_cache(split)
    number = [shard.sha256 for shard in cache.reader.index.shards].index(file.stem)
    if cache.path(number).is_file():
        return f"{file.name}: was unpacked before"
    cache.folder.mkdir(parents=True, exist_ok=True)
    write_bytes(cache.path(number), save(unpack(file.read_bytes())), overwrite=True)
    return f"{file.name}: unpacked"


def copy(source: Path, to: Path) -> None:
    """Of a small file."""
    to.parent.mkdir(parents=True, exist_ok=True)
    write_bytes(to, source.read_bytes(), overwrite=True)


if __name__ == "__main__":
    main()
