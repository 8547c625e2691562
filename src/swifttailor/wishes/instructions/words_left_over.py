"""Words of a clause of an instruction that nothing accounts for."""

from __future__ import annotations

import re
from collections.abc import Iterable

from swifttailor.wishes.text.unread import is_function_word
from swifttailor.wording.lexicon import WordReading

_WORD = re.compile(r"[^\W\d_]+(?:['’-][^\W\d_]+)*")
_SILENT = frozenset(["function", "polite", "degrees", "numbers", "negations", "generic"])

_ARTICLE = re.compile(r"\s+(?:the|my|her|his)(?!\w)")

_YEAR = re.compile(r"(?<!\w)(?:1[5-9]\d\d|\d0)s(?!\w)|(?<!\w)1[5-9]\d\d(?!\w)")


def left_over(
    text: str, bounds: tuple[int, int], used: Iterable[tuple[int, int]], words: WordReading
) -> tuple[str, ...]:
    """Words of a clause that nothing accounts for, those that stand side by side together."""
    start, end = bounds
    taken = list(used)
    answered = [(lack.mark.start, lack.mark.end) for lack in words.lacks if lack.said]
    taken += answered
    free = []
    for mark in words.marks:
        silent = bool(mark.entries) and mark.entries[0].category in _SILENT
        sheer = any(e.looks and e.category == "fabrics" for e in mark.entries)
        clothed = sheer or any(e.color or e.cloth or e.print or e.shade for e in mark.entries)
        if silent or clothed or mark.denied:
            free.append((mark.start, mark.end))
    taken += free
    missed = []
    for match in _WORD.finditer(text, start, end):
        if is_function_word(match[0]) or any(a <= match.start() < b for a, b in taken):
            continue
        if match[0] == "round" and _ARTICLE.match(text, match.end()):
            continue  # "looser round the tummy": no neckline
        missed.append(match)
    joined: list[list[re.Match[str]]] = []
    for match in missed:
        if joined and text[joined[-1][-1].end() : match.start()].strip(" -") == "":
            joined[-1].append(match)
        else:
            joined.append([match])
    years = [match[0] for match in _YEAR.finditer(text, start, end)]
    phrases = [text[group[0].start() : group[-1].end()] for group in joined]
    return (*phrases, *years)
