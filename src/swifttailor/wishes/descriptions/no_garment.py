"""Texts that ask for no garment: of which no word is known, or that name only what is not made."""

from __future__ import annotations

import re

from swifttailor.wishes.descriptions.other_errands import is_an_errand, is_for_an_animal
from swifttailor.wishes.heard import Heard
from swifttailor.wording.lexicon import WordMark, WordReading
from swifttailor.wording.lexicon.inflection import NAMES

_NOT_MADE = "accessories"
_GO_WITH = frozenset("something anything outfit look wear wearing with match matching goes go".split())
"""Words of who has such a thing already, and wants a garment beside it."""
_TELL_NO_GARMENT = frozenset({"function", "colors", "prints", "fabrics", "sizes", "occasions", "polite"})
_POLITE = "polite"
_CLOTHES = "separate_pieces"
"""What words for clothes in general, and for several at once, cannot be made as."""
_ASKING = (
    r"(?:(?:can|could|would|will|do) (?:you|u|somebody|anyone|they) (?:please |also |kindly )?"
    r"|where can i (?:get|have) |how (?:do|can|should|to) (?:i |you |we )?|i need to (?:get |have )?)?"
)
_MENDED = re.compile(
    rf"^\W*(?:(?:hi|hello|hey|please|kindly|pls)\W+)*{_ASKING}"
    r"(?:fix|mend|repair|re-?stitch|patch up|wash|dry[- ]clean|iron|press|bleach|refund|re-?sole|polish|unjam"
    r"|replace the zip)(?!\w)[^.;!?]{0,60}(?<!\w)(?:my|our|his|her|their|an? old|this|these)(?!\w)",
    re.IGNORECASE,
)
"""What is asked to be done to clothes that are there."""
_NO_GARMENT = (
    'No garment is asked for in "{text}". What can be made are tops, dresses, skirts, trousers and garments '
    "in one piece: name one{near}."
)
_FOR_ANIMALS = (
    'Clothes are made for people alone, and "{text}" asks for some for an animal or a doll. Say what a '
    "person is to wear{near}."
)
_WEARER_ALONE = 'Nothing but who wears it is said in "{text}". Say what is to be made, too{near}.'
_NOTHING_KNOWN = (
    'No garment is described in "{text}": no word of it is known. Name one in {languages}{near} (of '
    "Polish, Russian, Japanese and others some words are known); or let the network guess, with "
    "--source writer."
)
_LIKE = ', for example "a knee-length dress with short sleeves"'
_SHOWN = 80
"""Characters of a text that are quoted."""


def asks_for_none(heard: Heard, text: str) -> str:
    """Why nothing is made of a description; empty where something is.

    Args:
        heard: What was understood of it.
        text: As it was given.
    """
    words = heard.words
    quoted = text if len(text) <= _SHOWN else f"{text[: _SHOWN - 4]} ..."
    if any(map(str.isalnum, text)) and not any(map(str.isalnum, heard.text)):  # "size 14"
        return _WEARER_ALONE.format(text=quoted, near=_LIKE)
    if words is None:
        return ""
    if is_for_an_animal(text):
        return _FOR_ANIMALS.format(text=quoted, near=_LIKE)
    if is_an_errand(text, names_a_garment=_names_a_garment(words, text)):
        return _NO_GARMENT.format(text=quoted, near=_LIKE)
    told = bool(words.colors or words.cloths or heard.print or heard.cannot)
    known = [mark for mark in words.marks if _category(mark) not in (None, "function")]
    polite = {_category(mark) for mark in words.marks}
    if _POLITE in polite <= {_POLITE, "function"} and not (told or heard.sure):
        # A network guesses of "hello", too.
        return _NO_GARMENT.format(text=quoted, near=_LIKE)
    guessed = bool(heard.sure or heard.likely)
    speaks = told or known or heard.unread or any(m.word.lower() in _GO_WITH for m in words.marks)
    if guessed and not speaks:
        # And of "a chair", of which all words are known from what people tell beside their wishes.
        return _NO_GARMENT.format(text=quoted, near=_LIKE)
    if not (told or guessed) and heard.unread and not any(map(_is_of_garments, known)):
        known = []  # "a refund on this": what is known of it tells nothing of clothes
    if not (told or known or guessed):
        near = f". Names that are spelt alike: {', '.join(heard.near)}" if heard.near else _LIKE
        *first, last = NAMES.values()
        languages = f"{', '.join(first)} or {last}"
        return _NOTHING_KNOWN.format(text=quoted, languages=languages, near=near)
    named = [m for m in known if _category(m) == _NOT_MADE and not any(e.worn for e in m.entries)]
    if heard.guess:  # "a Ghostbusters costume": clothes in general, of a person whose clothes are known
        named = [m for m in named if not any(_CLOTHES in e.cannot for e in m.entries)]
    others = [mark for mark in known if mark not in named and _category(mark) not in _TELL_NO_GARMENT]
    # A garment that an occasion stands for is written before the text, and is none of its words.
    others = [mark for mark in others if any(w in text.lower() for w in mark.word.lower().split())]
    if named and "household" in {what for e in named[0].entries for what in e.cannot}:
        others = [mark for mark in others if _is_of_garments(mark)]  # "curtains, lined, 2 m long"
    others = [mark for mark in others if not (named and _is_put_on(mark))]  # the zip of boots
    if named and not guessed and not _names_a_garment(words, text):  # "a necklace with a heart"
        others = []
    go_with = _GO_WITH if guessed else _GO_WITH - {"with"}
    beside = any(mark.word.lower() in go_with for mark in words.marks)
    if _MENDED.search(text):
        return _NO_GARMENT.format(text=quoted, near=_LIKE)
    return _NO_GARMENT.format(text=quoted, near=_LIKE) if named and not others and not beside else ""


def _names_a_garment(words: WordReading, text: str) -> bool:
    """Whether a text itself does; what an occasion stands for is written before it."""
    named = [mark for mark in words.marks if mark.role == "garment" and not mark.denied]
    return any(mark.word.lower() in text.lower() for mark in named)


def _is_put_on(mark: WordMark) -> bool:
    """Whether a word names what is put on anything sewn, and tells nothing of how that is cut."""
    return _category(mark) == "styles" and all(
        e.cannot and not e.implied and not e.drafts for e in mark.entries
    )


def _is_of_garments(mark: WordMark) -> bool:
    """Whether a word names a garment or a part of one, and no more than what anything sewn may have."""
    category = _category(mark)
    return category in ("garments", "generic", "parts") or any(entry.drafts for entry in mark.entries)


def _category(mark: WordMark) -> str | None:
    return mark.entries[0].category if mark.entries else None
