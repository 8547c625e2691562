"""Lists of photographs of clothes, and what is known of each."""

from __future__ import annotations

import csv
import hashlib
import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from types import MappingProxyType
from typing import Any

from swifttailor.arrays import Pixels
from swifttailor.data.pictures.photograph_labels import KINDS, NOTHING, PhotographKind
from swifttailor.describing.claims import CLAIM_TYPES
from swifttailor.errors import InputError
from swifttailor.picture_reader.labels import PARTS
from swifttailor.render.picture_file import read_picture

SPLITS = ("train", "validation", "test")
_TENTHS = {8: "validation", 9: "test"}
_LABELS = {*KINDS, *NOTHING}
OF_LABELS, OF_GARMENTS = "images.csv", "garments.jsonl"
"""A folder's list of photographs of which the kind is known, and the one of photographs of dressed people."""
LISTS = (
    f"It needs {OF_LABELS}, with the columns image and label (one of {', '.join(sorted(_LABELS))}), and "
    f"images/IMAGE.jpg for each; or {OF_GARMENTS}, of which each line is like "
    '{"image": "FILE", "side": "front", "upper": {"kind": ["top"]}, "lower": null}.'
)
"""What a folder of photographs is, in a message."""
SIDES: Mapping[str, float] = MappingProxyType({"front": 0.0, "back": 180.0})
"""From where a person is photographed: degrees around."""
_WHOLE = (92.0, 185.0)
"""Level of the middle and height of what a photograph of a whole person shows, cm."""


@dataclass(frozen=True)
class Photograph:
    """One of them."""

    path: Path
    label: str
    """Its kind; of people what the garment on it is, in a word or two."""
    kinds: tuple[PhotographKind | None, ...]
    """Of each of `PARTS` what is worn there; None for nothing."""
    told: tuple[bool, ...] = (True, True)
    """Of each of `PARTS` whether that is known."""
    azimuth: float = 0.0
    """From where the wearer is seen, degrees; of clothes that nobody wears the front is."""
    is_worn: bool = False
    """Whether somebody wears it."""

    @property
    def main(self) -> PhotographKind | None:
        """What most is known of; None where there is nothing to read."""
        known = [kind for kind in self.kinds if kind]
        return max(known, key=lambda kind: len(kind.are) + len(kind.may_be), default=None)

    def pixels(self) -> Pixels:
        """(h, w, 3), as pictures are read that a user gives.

        Raises:
            InputError: It cannot be read.
        """
        return read_picture(self.path)


def listed(folder: Path, split: str) -> Iterator[Photograph]:
    """The photographs of a split of a folder.

    Args:
        folder: Has ``images.csv``, with the columns ``image`` and ``label``, and ``images/IMAGE.jpg``; or
            ``garments.jsonl``, an object a line: ``image``, a file in the folder; ``side``, ``front`` or
            ``back``; ``upper`` and ``lower``, what is worn there: claims with the words that may be true, all
            others being false, null for nothing, and left out where it is not known; ``middle`` and ``seen``,
            see `PhotographKind`; ``group``, a name that photographs of the same garment share.
        split: One of `SPLITS`: by a hash of the image's or group's name, so that the same photographs are
            always kept apart.

    Raises:
        InputError: Neither list can be read, or a line is no such object.
    """
    assert split in SPLITS
    if (folder / OF_GARMENTS).is_file():
        yield from _of_garments(folder, split)
        return
    for row in csv.DictReader(_lines(folder / OF_LABELS)):
        image, label = row.get("image") or "", row.get("label") or ""
        path = folder / "images" / f"{image}.jpg"
        known = label in _LABELS and Path(image).name == image and split_of(image) == split
        if known and path.is_file():
            kind = KINDS.get(label)
            yield Photograph(path, label, tuple(kind if kind and kind.part == one else None for one in PARTS))


def split_of(image: str) -> str:
    """One of `SPLITS`, by the name of an image or a group."""
    tenth = int(hashlib.sha256(image.encode()).hexdigest()[:8], 16) % 10
    return _TENTHS.get(tenth, "train")


def _of_garments(folder: Path, split: str) -> Iterator[Photograph]:
    within = folder.resolve()
    for number, line in enumerate(_lines(folder / OF_GARMENTS), 1):
        try:
            row = json.loads(line)
            image = str(row["image"])
            if split_of(str(row.get("group", image))) != split:
                continue
            middle, seen = (float(row.get(name, usual)) for name, usual in zip(_SEEN, _WHOLE, strict=True))
            kinds = tuple(_kind(part, row.get(part), middle, seen) for part in PARTS)
            azimuth = SIDES[row.get("side", "front")]
        except (ValueError, TypeError, KeyError, AttributeError, AssertionError) as error:
            raise InputError(
                f"Line {number} of '{folder / OF_GARMENTS}' cannot be used: {error}. {LISTS}"
            ) from error
        path = folder / image
        if path.resolve().is_relative_to(within) and path.is_file():
            told = tuple(part in row for part in PARTS)
            yield Photograph(path, _label(kinds), kinds, told, azimuth, is_worn=True)


_SEEN = ("middle", "seen")


def _kind(part: str, claims: Any, middle: float, seen: float) -> PhotographKind | None:
    if claims is None:
        return None
    if not isinstance(claims, dict):
        raise ValueError(f"{claims} says no claims")
    return _kind_of(part, json.dumps({name: list(claims[name]) for name in sorted(claims)}), middle, seen)


@lru_cache(maxsize=4096)
def _kind_of(part: str, claims: str, middle: float, seen: float) -> PhotographKind:
    """The same object for the same claims, as photographs of one garment have them."""
    words = {name: tuple(map(str, some)) for name, some in json.loads(claims).items()}
    for name, some in words.items():
        if name not in CLAIM_TYPES or not set(some) <= set(CLAIM_TYPES[name].words):
            raise ValueError(f"'{name}' is none of {', '.join(some)}")
    are = {name: some for name, some in words.items() if len(some) == 1}
    may_be = {name: some for name, some in words.items() if len(some) > 1}
    return PhotographKind(part, are, may_be, middle, seen)


def _label(kinds: tuple[PhotographKind | None, ...]) -> str:
    named = [*(kind.are.get("kind", ("garment",))[0] for kind in kinds if kind), "nothing"]
    return f"worn {named[0]}"


def _lines(table: Path) -> list[str]:
    try:
        return table.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"The list of photographs '{table}' cannot be read: {error}.") from error
