"""Word tables: text files of phrases, one meaning on a line, for anybody to read and to extend.

::

    # A comment.
    [features]
    neckline=boat           2 : a boat neck | a bateau neckline
                              | a wide, shallow neckline

Marks stand on the left of `` : ``, texts that mean the same on its right, with ``|`` between them. What the
marks mean is up to whoever reads the table. docs/captions.md describes the format.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Literal, NamedTuple, NoReturn

from swifttailor.errors import InputError

Dialect = Literal["uk", "us"]
_List = dict[str, tuple[str, ...]]
"""What an entry stands for on the left, and its words."""


_NO_OPTIONS: Mapping[str, tuple[str, ...]] = {}


class Row(NamedTuple):
    """One line of a table, lists filled in."""

    place: tuple[str, int]
    """File and line, for messages."""
    section: str
    claims: tuple[str, ...]
    """Marks such as ``kind=dress``."""
    numbers: tuple[str, ...]
    """What takes a number, such as ``sleeve_cm`` of the mark ``sleeve_cm=?``."""
    options: Mapping[str, tuple[str, ...]]
    """Marks such as ``about:length,fit``, by what stands before the colon."""
    words: tuple[str, ...]
    """All other marks but the number."""
    number: float | None
    texts: tuple[str, ...]
    """At least one; a dialect's are marked at their ends: ``trousers @uk``."""

    def wrong(self, what: str) -> NoReturn:
        """Refuses the row.

        Raises:
            InputError: Always; it names file and line.
        """
        raise InputError(f"{self.place[0]}, line {self.place[1]}: {what}")

    def check_options(self, *known: str) -> None:
        """Refuses options that are not among those known."""
        for name in self.options:
            if name not in known:
                self.wrong(f"there is no mark '{name}:'. Known: {', '.join(f'{each}:' for each in known)}.")


def read_table(path: Path) -> list[Row]:
    """Reads a table from a file.

    Raises:
        InputError: The file cannot be read, or a line is wrong; the message names file and line.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"Cannot read the word table '{path}': {error}.") from error
    return parse_table(text, path.name)


def parse_table(text: str, name: str) -> list[Row]:
    """Reads a table.

    Args:
        text: Its lines.
        name: What messages call it.

    Raises:
        InputError: A line is wrong; the message names it.
    """
    return _Parser(name).rows(text)


def by_dialect(texts: tuple[str, ...]) -> dict[Dialect, tuple[str, ...]]:
    """The texts that are said in each dialect, their marks left out."""
    if "@" not in "".join(texts):
        return {"uk": texts, "us": texts}
    parted = [text.partition(" @") for text in texts]
    uk, us = (tuple([bare for bare, _, mark in parted if mark in ("", each)]) for each in ("uk", "us"))
    return {"uk": uk, "us": us}


class _Parser:
    def __init__(self, name: str) -> None:
        self.name = name
        self.line = 0
        self.section, self.shared = "", ""
        self.lists: dict[str, _List] = {}
        self.found: list[Row] = []

    def rows(self, text: str) -> list[Row]:
        opened, begun, inside = "", 0, []
        for number, indented, line in [*_statements(text), (0, False, "")]:
            if indented and opened:
                inside.append((number, line))
                continue
            self.line = begun
            self._close(opened, inside)
            self.line, opened, inside = number, "", []
            if indented:
                self._wrong("the line is indented, but stands under no 'list' and no 'for each'.")
            if line.startswith("["):
                self.section, closed, self.shared = line[1:].partition("]")
                if not closed:
                    self._wrong(f"'{line}' has no closing bracket.")
            elif line.startswith(("list ", "for each ")):
                opened, begun = line, number
            elif line:
                self._fill(line, {})
        return self.found

    def _close(self, opened: str, inside: list[tuple[int, str]]) -> None:
        """Ends a ``list`` or ``for each``."""
        if not opened:
            return
        if not inside:
            self._wrong(f"nothing stands under '{opened}'; indent what belongs there.")
        if opened.startswith("list "):
            self._add_list(opened.removeprefix("list "), inside)
            return
        names = opened.removeprefix("for each ").split(" and ")
        keys = list(self._list(names[0]))
        if any(list(self._list(name)) != keys for name in names):
            self._wrong(f"the lists {' and '.join(names)} do not have the same entries in the same order.")
        for key in keys:
            for self.line, line in inside:
                self._fill(line, dict.fromkeys(names, key))

    def _add_list(self, name: str, inside: list[tuple[int, str]]) -> None:
        if not name.isidentifier() or name in self.lists:
            self._wrong(f"a list needs a name of one word that no other list has, not '{name}'.")
        entries = self.lists[name] = {}
        for self.line, line in inside:
            key, words = self._parted(line)
            key = " ".join(key.split())
            if key in entries:
                self._wrong(f"'{key}' is in the list '{name}' already.")
            entries[key] = words

    def _fill(self, line: str, bound: dict[str, str]) -> None:
        """Adds the rows of a line, one for each way to fill in the lists that it names."""
        left, texts = self._parted(line)
        if "<" not in line:
            self._add_row(left, texts)
            return
        slots, ways = [], [bound]
        for slot in dict.fromkeys([part.partition(">")[0] for part in line.split("<")[1:]]):
            which, _, name = slot.rpartition(" ")
            if which not in ("", "other", "first") or (which == "first" and f"<{slot}>" in left):
                self._wrong(f"'<{slot}>' is none of <list>, <other list> and, in texts, <first list>.")
            if which == "other" and name not in ways[0]:
                self._wrong(f"<other {name}> needs a <{name}> before it.")
            entries, free = self._list(name), slot if which == "other" else name
            if free not in ways[0]:
                ways = [w | {free: k} for w in ways for k in entries if which != "other" or k != w[name]]
            if which == "first":
                entries = {key: words[:1] for key, words in entries.items()}
            slots.append((f"<{slot}>", free, entries))
        for way in ways:
            marks, said = left, texts
            for place, name, entries in slots:
                key = way[name]
                words = entries[key]
                marks = marks.replace(place, key)
                said = [t.replace(place, w) for t in said for w in (words if place in t else words[:1])]
            self._add_row(marks, tuple(said))

    def _parted(self, line: str) -> tuple[str, tuple[str, ...]]:
        """Marks and texts."""
        left, colon, right = line.partition(" : ")
        if not colon:
            self._wrong("' : ' is missing, with a space on either side, between the marks and the texts.")
        if "|" not in right:
            texts = (right.strip(),)
        else:
            texts = tuple([text.strip() for text in right.split("|")])
        if "" in texts or len(set(texts)) < len(texts):
            self._wrong("a text is empty, or stands there twice.")
        if "@" in line and not all("@" not in text or text.endswith((" @uk", " @us")) for text in texts):
            self._wrong("'@' stands in no text but at its end, in ' @uk' or ' @us'.")
        return left, texts

    def _add_row(self, left: str, texts: tuple[str, ...]) -> None:
        claims, numbers, words, options, number = [], (), (), _NO_OPTIONS, None
        for mark in (f"{self.shared} {left}" if self.shared else left).split():
            if ":" in mark:
                name, _, values = mark.partition(":")
                listed = tuple(values.split(","))
                if name in options or "" in listed:
                    self._wrong(
                        f"'{mark}' is not NAME:VALUE or NAME:VALUE,VALUE, or '{name}:' is there twice."
                    )
                options = {**options, name: listed}
            elif "=" in mark:
                if mark[-1] == "?":
                    numbers = (*numbers, mark[:-2])
                else:
                    claims.append(mark)
            elif mark[0].isdigit():
                if number is not None:
                    self._wrong(f"two numbers, {number:g} and {mark}.")
                number = self._number(mark)
            elif mark != "any":
                words = (*words, mark)
        place = self.name, self.line
        self.found.append(Row(place, self.section, tuple(claims), numbers, options, words, number, texts))

    def _number(self, mark: str) -> float:
        try:
            number = float(mark)
        except ValueError:
            self._wrong(f"'{mark}' begins like a number and is none.")
        if not 0.0 < number <= 10.0:
            self._wrong(f"the number is {mark}; it is to be above 0 and not above 10.")
        return number

    def _list(self, name: str) -> _List:
        if name not in self.lists:
            self._wrong(f"there is no list '{name}' above. Known: {', '.join(self.lists) or 'none'}.")
        return self.lists[name]

    def _wrong(self, what: str) -> NoReturn:
        raise InputError(f"{self.name}, line {self.line}: {what}")


def _statements(text: str) -> list[tuple[int, bool, str]]:
    """Lines with what continues them: number, whether indented, text."""
    found: list[tuple[int, bool, str]] = []
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.strip()
        if not bare or bare[0] == "#":
            continue
        if bare[0] in "|:" and found:
            first, indented, begun = found[-1]
            found[-1] = first, indented, f"{begun} {bare}"
        else:
            found.append((number, line[0].isspace(), bare))
    return found
