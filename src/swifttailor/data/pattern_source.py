"""Patterns one by one, wherever they are: a data set, a split, JSON lines, a folder, a single file."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from swifttailor.data.index import INDEX, split_folders
from swifttailor.data.reader import SplitReader
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern, read_pattern_file
from swifttailor.pattern.pattern_list import LINE_ENDINGS, BatchPattern, count_patterns, read_patterns

PatternOrError = Pattern | SwiftTailorError


def is_data_set(source: Path) -> bool:
    """Whether a folder is a data set or a split, and not one of pattern files."""
    return source.is_dir() and ((source / INDEX).is_file() or any(source.glob(f"*/{INDEX}")))


def count_source(source: Path) -> int:
    """About how many patterns there are (exact unless a file is damaged)."""
    if is_data_set(source):
        return sum(len(SplitReader(folder)) for folder in split_folders(source).values())
    return count_patterns(source) if _many(source) else 1


def patterns_of(source: Path) -> Iterator[tuple[str, PatternOrError]]:
    """Goes through the patterns of a source.

    Args:
        source: A data set or split of ``swifttailor data build``, a .jsonl or .jsonl.gz file with one
            ``{"id": ..., "pattern": ...}`` a line, a folder of .json files, or a single .json file.

    Yields:
        Id and pattern, or id and what is wrong with it.

    Raises:
        InputError: There is no such source, or a shard of a data set is damaged.
    """
    if is_data_set(source):
        for folder in split_folders(source).values():
            for sample in SplitReader(folder):
                yield sample.id, sample.pattern
    elif _many(source):
        for entry in read_patterns(source):
            yield entry.id, parsed_pattern(entry)
    else:
        yield source.stem, _attempt(lambda: read_pattern_file(source).pattern)


def _many(source: Path) -> bool:
    return source.is_dir() or source.name.lower().endswith(LINE_ENDINGS) or not source.exists()


def parsed_pattern(entry: BatchPattern) -> PatternOrError:
    """The pattern of an entry, or what is wrong with it."""
    return _attempt(lambda: entry.read().pattern)


def _attempt(read: Callable[[], Pattern]) -> PatternOrError:
    try:
        return read()
    except SwiftTailorError as error:
        return error
