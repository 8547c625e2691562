"""How many buttons a text asks for, and how many a garment usually has: "a two-button blazer"."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.pattern.trims.names import MOST_BUTTONS

_NUMBERS: Mapping[int, str] = {
    1: "one single ein eine einem einen einzigen een un une seul uno una um uma",
    2: "two zwei twee deux dos due dois duas",
    3: "three drei drie trois tres tre",
    4: "four vier quatre cuatro quattro quatro",
    5: "five funf vijf cinq cinco cinque",
    6: "six sechs zes seis sei",
    7: "seven sieben zeven sept siete sette sete",
    8: "eight acht huit ocho otto oito",
    9: "nine neun negen neuf nueve nove",
    10: "ten zehn tien dix diez dieci dez",
    11: "eleven elf onze",
    12: "twelve zwolf twaalf douze doce dodici doze",
    14: "fourteen",
    16: "sixteen",
    18: "eighteen",
    20: "twenty",
}
"""Of English and of the other languages that are read, without accents."""
_VALUES = {word: number for number, words in _NUMBERS.items() for word in words.split()}
_NUMBER = rf"(?:\d{{1,2}}|{'|'.join(sorted(_VALUES, key=len, reverse=True))})"
_ONE = r"(?:button|toggle|snap|knopf|knoop|bouton|boton|bottone|botao)"
_BUTTON = (
    r"(?:buttons?|toggles?|snaps?|knopfe?n?|knoop|knopen|knoopjes|boutons?|boton|botones|bottone|bottoni"
    r"|botao|botoes)"
)
_BETWEEN = (
    r"(?:(?!(?:rows?|of|and|with|without|or|no|by|to|in|the|pockets?|en|et|y|e|und|mit|ohne|reihen|rijen|con"
    r"|avec|sans|sin|senza|com|sem|met|zonder|de|des|du|da|do|a|al|au|aux)\b)\w+ )"
)
"""A word that may stand between a number and its buttons: "four small buttons"."""
_ELSEWHERE = (
    r"(?!(?<=button) (?:up|down|through|fly)\b)"
    r"(?! (?:(?:on|at|in|down|along|up|per) )?(?:(?:the|each|both|either|every|its|one) )?"
    r"(?:cuffs?|sleeves?|wrists?|shoulders?|back|waistband|pockets?|flys?|collar|neck|nape|sides?|hips?"
    r"|ankles?|straps?|tabs?)\b)"
)
"""Behind a number of buttons that do not close the front; a size may stand before a button-up shirt."""
_STATED = re.compile(rf"(?<!\w)({_NUMBER}) {_BETWEEN}{{0,2}}{_BUTTON}\b{_ELSEWHERE}")
_SINGLE = re.compile(rf"{_ONE}$|knopf|knoop")
_COMPOUND = re.compile(rf"\b({'|'.join(_VALUES)})kno(?:pf|op)s?")
"""German "Zweiknopf", Dutch "vierknoops"."""
_ROWS = re.compile(rf"({_NUMBER}) rows of (?:({_NUMBER}) )?{_BETWEEN}{{0,2}}{_BUTTON}\b")
_COLUMNS = 2
_USUAL: Mapping[str, int] = {"waistcoat": 5, "blazer": 2, "cardigan": 6, "denim-jacket": 6}
"""Buttons that garments have where no number is stated, by the name of their draft."""
_ONE_BUTTON_DEPTH = 33.0
"""Fall of the neckline of a jacket that one button closes, at the waist, cm."""


def buttons_stated(text: str) -> int | None:
    """The number of buttons that close the front, by a text; None where it states none from 1 to 20.

    Args:
        text: In English, German, French, Spanish, Italian, Dutch or Portuguese.
    """
    plain = _plain(text)
    rows = _ROWS.search(plain)
    if rows is not None:
        count, each = _value(rows[1]), rows[2]
        # Two rows of four have eight; three rows of a double-breasted front have six.
        count = count * _value(each) if each else count * _COLUMNS
        return count if (each or _value(rows[1]) > _COLUMNS) and 0 < count <= MOST_BUTTONS else None
    for found in (*_STATED.finditer(plain), *_COMPOUND.finditer(plain)):
        count = _value(found[1])
        # "Une robe, boutons" is one dress.
        if 1 < count <= MOST_BUTTONS or (count == 1 and _SINGLE.search(found[0])):
            return count
    return None


def usual_buttons(draft: str, *, to_the_neck: bool = False) -> int:
    """How many a garment has that is cut from a draft of that name; 0 where its length decides.

    Args:
        draft: Its name; empty where it is cut from none.
        to_the_neck: Whether the front is closed up to a close neck, as that of blazers is not.
    """
    return 0 if draft == "blazer" and to_the_neck else _USUAL.get(draft, 0)


def closed_as_counted(draft: NamedDraft, text: str) -> NamedDraft:
    """A named draft as it goes with a number of buttons: a blazer with one is closed at the waist alone."""
    if draft.name != "blazer" or buttons_stated(text) != 1 or "neck_depth" in dict(draft.options):
        return draft
    return replace(draft, options=(*draft.options, ("neck_depth", _ONE_BUTTON_DEPTH)))


def _value(word: str) -> int:
    return int(word) if word.isdigit() else _VALUES[word]


def _plain(text: str) -> str:
    """Lower case, without accents, with single spaces where hyphens and spaces are."""
    folded = unicodedata.normalize("NFD", text.casefold())
    folded = "".join(letter for letter in folded if not unicodedata.combining(letter))
    return re.sub(r"[\s\-‐-―_]+", " ", folded)
