"""Whether a token sequence is a pattern, read plainly: a second opinion on what the grammar promises."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import (
    CLOSING_COMMANDS,
    COMMANDS,
    PANEL_TOKENS,
    STITCH_TOKENS,
)


@dataclass(frozen=True)
class Validity:
    """Of what was written, before any repair."""

    closed: bool
    """Whether there are panels, and each ends where it began, once, after all its other edges."""
    paired: bool
    """Whether every stitch tag stands on exactly two edges, and every edge has at most one."""


def validity(sequence: TokenSequence) -> Validity:
    """Reads a sequence without the grammar."""
    panels: list[list[int]] = []
    """Commands of each."""
    edges: list[list[int]] = []
    """Tags of each."""
    in_place = True
    for token in sequence.tokens.tolist():
        if token in PANEL_TOKENS:
            panels.append([])
        elif token in COMMANDS or token in CLOSING_COMMANDS:
            if not panels:
                in_place = False
                continue
            panels[-1].append(token)
            edges.append([])
        elif token in STITCH_TOKENS:
            if not edges:
                in_place = False
                continue
            edges[-1].append(token)
    uses = Counter(tag for tags in edges for tag in tags)
    once = all(len(tags) <= 1 for tags in edges)
    return Validity(
        closed=in_place and bool(panels) and all(map(_closed, panels)),
        paired=in_place and once and all(count == 2 for count in uses.values()),
    )


def _closed(commands: list[int]) -> bool:
    closing = [command in CLOSING_COMMANDS for command in commands]
    return closing.count(True) == 1 and closing[-1]
