"""Makes the library of known patterns that comes with the package (docs/pattern-library.md).

python scripts/make_pattern_library.py --patterns train.jsonl.gz --usual usual-00.jsonl.gz
    --apart validation.jsonl.gz test.jsonl.gz --out known_patterns.zip

Half of the library is taken from --usual, half from --patterns. Passed over are patterns in which a check
finds an error or a warning, before or after they are rounded, and twins of each other and of those --apart.
The same files, seed and version give the same bytes.
"""

from __future__ import annotations

import argparse
import hashlib
import json
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from swifttailor.atomic_files import write_atomically, write_text
from swifttailor.data.array_cache import name_with_code
from swifttailor.data.pattern_source import parsed_pattern, patterns_of
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern, Severity, check_pattern
from swifttailor.pattern.digest import pattern_digest
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.pattern.pattern_list import read_patterns
from swifttailor.pattern_library.choose import choose, stands_for, usefulness
from swifttailor.pattern_library.known import KnownPattern, rounded, write_library
from swifttailor.pattern_library.nearest import CHOSEN
from swifttailor.pattern_library.truth_table import TruthTable
from swifttailor.picture_reader.labels import BOX
from swifttailor.picture_reader.truth import Truth
from swifttailor.recutting.holes import has_holes

SPARE = 1.15
"""Chosen for each that is taken: some are passed over."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--patterns", type=Path, nargs="+", required=True, help=".jsonl.gz files")
    parser.add_argument("--usual", type=Path, nargs="*", default=[], help="the same, of what people wear")
    parser.add_argument("--apart", type=Path, nargs="*", default=[], help="patterns that must not be in it")
    parser.add_argument("--count", type=int, default=3000, help="patterns of the library")
    parser.add_argument("--wanted", type=int, default=6000, help="garments that it is chosen for")
    parser.add_argument("--seed", type=int, default=0, help="of which garments these are")
    parser.add_argument("--cache", type=Path, help="folder that keeps what was measured")
    parser.add_argument(
        "--out", type=Path, required=True, help="file to write; its card is written beside it"
    )
    options = parser.parse_args()

    apart = {pattern_digest(p) for source in options.apart for _, p in sound_patterns(source)}
    sources = [(path, False) for path in options.patterns] + [(path, True) for path in options.usual]
    pool = Pool.read(sources, apart, options.cache)
    print(f"{len(pool.table)} patterns, {int(pool.usual.sum())} of them usual")
    wanted = drawn(pool.usual, options.wanted, options.seed)
    use = usefulness(pool.table, wanted, CHOSEN, progress=said)
    order = choose(use, pool.usual.astype(int), round(SPARE * options.count))
    known, taken, passed_over = pool.sound(order, options.count)
    stand = stands_for(use, taken)
    card = {
        "patterns": len(known),
        "usual": int(pool.usual[taken].sum()),
        "chosen_from": len(pool.table),
        "passed_over": passed_over,
        "seed": options.seed,
        "wanted": len(wanted),
        "weights": asdict(CHOSEN),
        "inputs": {
            path.name: {"sha256": sha256(path), "usual": usual, "patterns": pool.of_source(number)}
            for number, (path, usual) in enumerate(sources)
        },
        "apart": {path.name: sha256(path) for path in options.apart},
        "command": "python scripts/make_pattern_library.py"
        + f" --patterns {names(options.patterns)}"
        + (f" --usual {names(options.usual)}" if options.usual else "")
        + (f" --apart {names(options.apart)}" if options.apart else "")
        + f" --count {options.count} --wanted {options.wanted} --seed {options.seed}"
        + f" --out {options.out.name}",
    }
    write_library(options.out, known, pool.table.take(taken), stand, card, overwrite=True)
    card |= {"bytes": options.out.stat().st_size, "sha256": sha256(options.out)}
    write_text(options.out.with_suffix(".json"), json.dumps(card, indent=1) + "\n", overwrite=True)
    print(f"Wrote {options.out}: {len(known)} patterns, {card['bytes'] / 1e6:.2f} MB")


@dataclass(frozen=True, eq=False)
class Pool:
    """The patterns that can be chosen."""

    sources: list[Path]
    ids: list[str]
    source: np.ndarray
    """(N,) number of the file of each."""
    usual: np.ndarray
    """(N,) whether it is of a file of usual ones."""
    table: TruthTable

    @staticmethod
    def read(sources: Sequence[tuple[Path, bool]], apart: set[str], cache: Path | None) -> Pool:
        """Those of all files, without twins."""
        known, ids, source, truths = set(apart), [], [], []
        for number, (path, _) in enumerate(sources):
            print(f"measuring {path.name}")
            for id, digest, truth in measured(path, cache):
                if digest not in known:
                    known.add(digest)
                    ids.append(id)
                    source.append(number)
                    truths.append(truth)
        usual = np.array([usual for _, usual in sources])
        return Pool(
            [p for p, _ in sources], ids, np.array(source), usual[np.array(source)], TruthTable.of(truths)
        )

    def of_source(self, number: int) -> int:
        """How many there are of a file."""
        return int((self.source == number).sum())

    def sound(self, order: Sequence[int], count: int) -> tuple[list[KnownPattern], list[int], int]:
        """The first of an order that are sound, their numbers, and how many were passed over."""
        wanted = {(int(self.source[k]), self.ids[k]): k for k in order}
        read: dict[int, Pattern] = {}
        for number, path in enumerate(self.sources):
            for entry in read_patterns(path):
                if (number, entry.id) in wanted:
                    pattern = parsed_pattern(entry)
                    assert isinstance(pattern, Pattern)
                    read[wanted[number, entry.id]] = pattern.canonical()
        known, taken, passed_over = [], [], 0
        for k in order:
            if len(known) == count:
                break
            if is_sound(read[k]) and is_sound(rounded(read[k])):
                known.append(KnownPattern(self.ids[k], read[k]))
                taken.append(k)
            else:
                passed_over += 1
        return known, taken, passed_over


def is_sound(pattern: Pattern) -> bool:
    """Whether a check finds no error and no warning, and no seam is open."""
    severe = (Severity.ERROR, Severity.WARNING)
    return not any(f.severity in severe for f in check_pattern(pattern)) and not has_holes(pattern)


def drawn(usual: np.ndarray, count: int, seed: int) -> list[int]:
    """The garments that the library is chosen for: as many usual ones as others, where there are any."""
    chance = np.random.default_rng([seed, 3])
    groups = [g for g in (np.flatnonzero(usual), np.flatnonzero(~usual)) if len(g)]
    share = count // len(groups)
    return [int(k) for g in groups for k in np.sort(chance.permutation(g)[:share])]


def measured(path: Path, cache: Path | None) -> Iterator[tuple[str, str, Truth]]:
    """Id, digest and truth of all patterns of a file that can be measured."""
    code = name_with_code(
        "truth", "describing", "pattern", "picture_reader/truth.py", "picture_reader/labels.py"
    )
    kept = None if cache is None else cache / f"{code}-{sha256(path)[:16]}.npz"
    if kept is None or not kept.is_file():
        rows = [(id, pattern_digest(p), truth_of(p)) for id, p in sound_patterns(path)]
        rows = [row for row in rows if row[2] is not None]
        if kept is not None:
            keep(kept, rows)
        yield from rows
        return
    found = np.load(kept, allow_pickle=False)
    columns = {name: found[name] for name in found.files}
    table = TruthTable(*(columns[n] for n in ("part", "statements", "measures", "panels", "boxes")))
    first = 0
    for k, (id, digest) in enumerate(zip(columns["ids"], columns["digests"], strict=True)):
        boxes = np.zeros((len(PANEL_NAMES), len(BOX)), np.float32)
        has = table.panels[k] > 0
        boxes[has] = table.boxes[first : first + has.sum()]
        first += int(has.sum())
        truth = Truth(int(table.part[k]), table.statements[k], table.measures[k], table.panels[k], boxes)
        yield str(id), str(digest), truth


def keep(path: Path, rows: list[tuple[str, str, Truth]]) -> None:
    table = TruthTable.of([truth for _, _, truth in rows])
    arrays = {name: getattr(table, name) for name in ("part", "statements", "measures", "panels", "boxes")}
    arrays |= {"ids": np.array([r[0] for r in rows]), "digests": np.array([r[1] for r in rows])}
    write_atomically(path, lambda temporary: np.savez(temporary, **arrays), overwrite=True)


def sound_patterns(path: Path) -> Iterator[tuple[str, Pattern]]:
    for id, pattern in patterns_of(path):
        if not isinstance(pattern, SwiftTailorError):
            yield id, pattern.canonical()


def truth_of(pattern: Pattern) -> Truth | None:
    try:
        return Truth.of(pattern, measure_facts(pattern))
    except SwiftTailorError:
        return None


def names(paths: Sequence[Path]) -> str:
    return " ".join(path.name for path in paths)


def sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def said(done: int, of: int) -> None:
    if done % 500 == 0 or done == of:
        print(f"compared for {done} of {of} garments", flush=True)


if __name__ == "__main__":
    main()
