"""How many wishes altering a pattern fulfils, of each kind, and what it costs.

``python benchmarks/alteration_rates.py [PATTERNS.jsonl.gz] [--every 3] [--wishes 6] [--limit N] [--verbose]``

Every third pattern is given wishes that do not hold of it, each on its own: what can be said of another
pattern of the same kind, and measures that should grow or shrink, half of them by what the other's differ.
Then it is given three of them together. Printed are by kind of wish how many were fulfilled, of those that
there is a lever for, of all; how many findings of the checker are new, and processor time of one core per
pattern and wish: median and ninth decile.
"""

from __future__ import annotations

import argparse
import random
import time
from collections import defaultdict
from itertools import islice
from pathlib import Path

import numpy as np

from machine import describe
from swifttailor.data.pattern_source import patterns_of
from swifttailor.describing.claims import claims_of
from swifttailor.describing.differences import Change, Gain, Step, find_differences
from swifttailor.describing.facts import GarmentFacts
from swifttailor.errors import SwiftTailorError
from swifttailor.recutting import alter
from swifttailor.recutting.plans import find_plans
from swifttailor.recutting.table.cutter import Cutter

PATTERNS = Path("../shared/garmentcode/validation.jsonl.gz")
COUNTS = {"gores", "tiers", "godets", "godet_cm"}


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("patterns", nargs="?", type=Path, default=PATTERNS)
    parser.add_argument("--every", type=int, default=3)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--wishes", type=int, default=6)
    parser.add_argument("--limit", type=int)
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    print(describe())
    read = [(id, p) for id, p in patterns_of(options.patterns) if not isinstance(p, SwiftTailorError)]
    chosen = list(islice(read, options.first, None, options.every))[: options.limit]
    cutters = {id: Cutter(p) for id, p in chosen}
    rng = random.Random(5)
    shares: dict[str, list[tuple[bool, bool]]] = defaultdict(list)
    seconds: list[float] = []
    many: list[float] = []
    many_seconds: list[float] = []
    new_faults = 0
    for id, pattern in chosen:
        before = cutters[id]
        others = [c.facts for o, c in cutters.items() if o != id and c.facts.kind == before.facts.kind]
        if not others:
            continue
        wishes = wishes_for(before.facts, rng.choice(others), rng, options.wishes)
        for wish in wishes:
            started = time.process_time()
            done = alter(pattern, [wish])
            seconds.append(time.process_time() - started)
            plans = find_plans(before.facts, before.facts, [wish], [])[wish]
            shares[name_of(wish)].append((bool(plans) or bool(done.done), bool(done.done)))
            after = Cutter(done.pattern)
            new_faults += len(after.faults - before.faults)
            assert bool(done.done) == wish.holds(before.facts, after.facts)
            if options.verbose:
                print(f"  {id} {'ok ' if done.done else 'NOT'} {wish} {done.cuts}")
        if len(wishes) >= 3:
            started = time.process_time()
            done = alter(pattern, wishes[:3])
            many_seconds.append(time.process_time() - started)
            many.append(len(done.done) / 3)
            new_faults += len(Cutter(done.pattern).faults - before.faults)
    if options.verbose:
        table(shares)
    grouped: dict[str, list[tuple[bool, bool]]] = defaultdict(list)
    for name, found in shares.items():
        grouped[name.split(":")[0].rstrip(" +-")] += found
    table(grouped)
    every = [ok for found in shares.values() for _, ok in found]
    known = sum(k for found in shares.values() for k, _ in found)
    print(
        f"{len(chosen)} patterns: {sum(every)} of {known} that there are levers for, of {len(every)} wishes"
    )
    print(f"{milliseconds(seconds)} a wish")
    print(f"of three at once {np.mean(many):.0%}; {milliseconds(many_seconds)}")
    print(f"{new_faults} new findings of the checker")


def table(shares: dict[str, list[tuple[bool, bool]]]) -> None:
    """Prints fulfilled, of those that there is a lever for, of all."""
    for name, found in sorted(shares.items(), key=lambda item: -len(item[1])):
        known, ok = (sum(column) for column in zip(*found, strict=True))
        print(f"  {name:<32} {ok:>4} of {known:>4} of {len(found):>4}")


def wishes_for(facts: GarmentFacts, other: GarmentFacts, rng: random.Random, count: int) -> list[Change]:
    """Wishes that another garment fulfils and this one does not."""
    gains: list[Change] = [Gain(c) for c in claims_of(other) if not c.holds(facts) and c.name not in COUNTS]
    steps: list[Change] = [
        s if rng.random() < 0.5 else Step(s.quantity, s.direction) for s in find_differences(facts, other)[1]
    ]
    rng.shuffle(gains)
    rng.shuffle(steps)
    mixed = [w for pair in zip(gains[:count], steps[: count // 2], strict=False) for w in pair] + gains[
        count // 2 :
    ]
    return list(dict.fromkeys(mixed))[:count]


def name_of(wish: Change) -> str:
    """What kind of wish it is."""
    if isinstance(wish, Step):
        return f"{wish.quantity} {'+' if wish.direction > 0 else '-'}"
    value = wish.claim.value
    return f"{wish.claim.name}: {value}" if isinstance(value, str) else wish.claim.name


def milliseconds(seconds: list[float]) -> str:
    return f"{np.median(seconds) * 1e3:.0f} ms, {np.quantile(seconds, 0.9) * 1e3:.0f} ms"


if __name__ == "__main__":
    main()
