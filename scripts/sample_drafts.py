"""Samples this package's own drafts with random options, and edited versions of them, to learn from.

Each pattern has a seed of its own, and each option is drawn from its whole range or left as it is. Patterns
in which a check finds an error are left out. One JSON object a line, as ``swifttailor train pattern-maker``
reads them: --out holds id, design and pattern, and --edits beside that the base of each.
"""

from __future__ import annotations

import argparse
import gzip
import itertools
import json
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from swifttailor.errors import PatternError
from swifttailor.pattern import Pattern, Severity, check_pattern, to_specification
from swifttailor.pattern.drafts import DraftInfo, OptionField, draft, list_drafts

CHANGED = 0.6
"""Share of the options that are not what they usually are."""
EDITS = 2
TRIES = 8

LATER = {
    *("halter-top", "off-shoulder-top", "halter-dress", "off-shoulder-dress"),
    *("wrap-top", "wrap-dress", "polo-shirt", "blazer", "wrap-skirt", "sarong"),
}
"""Made after the networks were trained: with them the same seeds would give other patterns. PatternMaker
has no name for the strap of a halter."""
SAMPLED = [info for info in list_drafts() if info.name not in LATER]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=600, help="patterns to write")
    parser.add_argument("--start", type=int, default=0, help="seed of the first")
    parser.add_argument("--out", type=Path, required=True, help="a .jsonl.gz file")
    parser.add_argument("--edits", type=Path, required=True, help="another, for edited versions")
    options = parser.parse_args()
    patterns, edits = [], []
    for seed in itertools.count(options.start):
        chance = random.Random(seed)
        info = chance.choice(SAMPLED)
        values = {f.name: drawn(f, chance) for f in info.options if chance.random() < CHANGED}
        pattern = sound(info, values)
        if pattern is None:
            continue
        name = f"draft_{info.name}_{seed}"
        patterns.append({"id": name, "design": values, "pattern": to_specification(pattern)})
        for number, (other, edited) in enumerate(changed(info, values, pattern, chance)):
            content = {"id": f"{name}_e{number}", "base": name, "design": other}
            edits.append(content | {"pattern": to_specification(edited)})
        if len(patterns) == options.count:
            break
    write(options.out, patterns)
    write(options.edits, edits)
    print(f"{len(patterns)} patterns, {len(edits)} edited versions; seeds {options.start} to {seed}")


def changed(
    info: DraftInfo, values: dict[str, Any], pattern: Pattern, chance: random.Random
) -> Iterator[tuple[dict[str, Any], Pattern]]:
    """Versions with one or two other options."""
    found = 0
    for _ in range(TRIES):
        fields = chance.sample(info.options, chance.choice((1, 1, 2)))
        other = values | {f.name: drawn(f, chance) for f in fields}
        edited = sound(info, other)
        if edited is not None and edited != pattern:
            yield other, edited
            found += 1
        if found == EDITS:
            return


def drawn(field: OptionField, chance: random.Random) -> Any:
    """A value of an option."""
    if field.choices:
        return chance.choice(field.choices)
    if field.kind is bool:
        return chance.random() < 0.5
    low, high = field.option.low, field.option.high
    assert low is not None and high is not None  # numbers have ranges
    return chance.randint(int(low), int(high)) if field.kind is int else round(chance.uniform(low, high), 1)


def sound(info: DraftInfo, values: dict[str, Any]) -> Pattern | None:
    """The pattern, unless these options do not go together."""
    try:
        pattern = draft(info.name, **values)
    except PatternError:
        return None
    return None if any(f.severity is Severity.ERROR for f in check_pattern(pattern)) else pattern


def write(path: Path, contents: list[dict[str, Any]]) -> None:
    """Whole or not at all."""
    part = path.with_name(path.name + ".part")
    with gzip.GzipFile(part, "wb", mtime=0) as file:
        for content in contents:
            file.write(json.dumps(content, separators=(",", ":")).encode() + b"\n")
    part.replace(path)


if __name__ == "__main__":
    main()
