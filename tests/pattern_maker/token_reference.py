"""A second, plain reading of token sequences, to hold the state machine and the decoder against."""

from __future__ import annotations

from collections import Counter

from swifttailor.pattern import PANEL_NAMES, body_region
from swifttailor.pattern_maker.tokens.vocabulary import TOKENS

CURVED = ("quadratic", "cubic", "arc")


def faults(tokens: list[int], max_tokens: int, max_edges: int) -> list[str]:
    """What is wrong with a finished sequence, read as text."""
    words = [TOKENS[t][1:-1] for t in tokens]
    found = []
    if len(words) > max_tokens:
        found.append("too long")
    if words[:1] != ["pattern_start"] or words[-1:] != ["pattern_end"] or len(words) < 3:
        return [*found, "no start or end"]
    panels: list[list[str]] = []
    for word in words[1:-1]:
        if word.startswith("panel:"):
            panels.append([])
        if not panels:
            return [*found, "begins without a panel"]
        panels[-1].append(word)
    names = [PANEL_NAMES.index(p[0].removeprefix("panel:")) for p in panels]
    if names != sorted(set(names)):
        found.append("names twice or out of order")
    tags: Counter[str] = Counter()
    for panel in panels:
        found += _panel_faults(panel, max_edges, tags)
    if any(count != 2 for count in tags.values()):
        found.append("a tag not exactly twice")
    return found


def _panel_faults(panel: list[str], max_edges: int, tags: Counter[str]) -> list[str]:
    name, rest = panel[0].removeprefix("panel:"), panel[1:]
    found = []
    if rest and rest[0].startswith("covers:"):
        if rest[0] == f"covers:{body_region(name)}":
            found.append("the usual label written")
        rest = rest[1:]
    if rest[:1] != ["move"]:
        return ["no placement"]
    edges: list[list[str]] = []
    for word in rest[1:]:
        if word.removeprefix("closing_") in ("line", *CURVED):
            edges.append([])
        if not edges:
            return ["no command"]
        edges[-1].append(word)
    closing = [e[0].startswith("closing_") for e in edges]
    if not edges or closing != [False] * (len(edges) - 1) + [True]:
        found.append("not closed once, at the end")
    if len(edges) > max_edges:
        found.append("too many edges")
    curved = any(e[0].removeprefix("closing_") in CURVED for e in edges)
    if len(edges) < (2 if curved else 3):
        found.append("too few edges")
    for _, *marks in edges:
        if marks and marks[0].startswith("edge:"):
            marks = marks[1:]
        right_wrong = marks[:1] == ["right_wrong"]
        marks = marks[right_wrong:]
        if len(marks) != 1 or not marks[0].startswith(("stitch:", "not_stitched")):
            found.append("an edge without one tag")
        elif marks[0].startswith("stitch:"):
            tags[marks[0]] += 1
        if right_wrong and (not marks or tags[marks[0]] != 2):
            found.append("right_wrong not at the second side")
    return found
