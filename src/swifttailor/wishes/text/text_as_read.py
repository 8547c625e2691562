"""Texts as they are read: with slips of the fingers put right, and what of them cannot be made."""

from __future__ import annotations

import re
from collections.abc import Sequence

from swifttailor.describing.differences import Change
from swifttailor.wishes.text.german_adjectives import adjectives_plainly
from swifttailor.wishes.text.joined_words import with_parts_apart
from swifttailor.wishes.text.lexicon_spelling import is_garment, lexicon_spelling
from swifttailor.wishes.text.names_turned import names_turned
from swifttailor.wishes.text.spelling import common_slip, put_right
from swifttailor.wishes.text.spoken_measures import SpokenMeasure
from swifttailor.wishes.text.unread import unread_numbers
from swifttailor.wording.lexicon import Lack, WordReading, read_words

ENGLISH = "en"
_DIGIT = re.compile(r"\d")
_COUNTED = frozenset({"buttons", "pockets"})
"""What has a number before it that is no size of its own: "three buttons"."""
_LEVELS = "knees?|ankles?|calf|calves|thighs?|mid-thigh|shins?|floor|ground|feet|elbows?|wrists?|hips?|waist"
_ABOUT = re.compile(r"(?<!\w)(ca|approx)\. ", re.IGNORECASE)
_SHORTENED = (
    (re.compile(r"(?<!\w)i\. ?e\.?(?!\w)", re.IGNORECASE), "that is"),
    (re.compile(r"(?<!\w)e\. ?g\.?(?!\w)", re.IGNORECASE), "for example"),
    (re.compile(r"(?<!\w)(?:resp|cf|viz|incl)\.(?!\w)", re.IGNORECASE), "with"),
)
"""What is written short, and what it stands for."""
_SAY = re.compile(r",?\s+(?:let['’]?s )?say,?\s+(?=\d)", re.IGNORECASE)
"""What stands before a number that is only a suggestion: "a broad band, say 7 cm"."""
_BODY = re.compile(rf"(?<!\w)(my|her|his|their|your) ({_LEVELS})(?!\w)", re.IGNORECASE)
_REACHES = re.compile(
    r"(?<!\w)(?:touch|touching|reach|reaching|hit|hitting|graze|skim|meet|go down to|come down to) "
    rf"(the|my|her|his|their|your) ({_LEVELS})(?!\w)",
    re.IGNORECASE,
)
_OF = re.compile(r"(?<!\w)([^\W\d_]+) (?:of|for)(?: the| an?)? ([^\W\d_]+)(?!\w)(?! (?:out|away|off)(?!\w))")
"""What a garment is of or for; a dress for a night out is no night dress."""

_GOES_ON = re.compile(
    r"[ -](?:plays?|productions?|shows?|trips?|runs?|gates?|concerts?|fairs?|f[eê]tes?|discos?|reunions?"
    r"|balls?|photos?|assembl(?:y|ies)|part(?:y|ies)|meals?|holidays?|camps?)(?!\w)",
    re.IGNORECASE,
)
"""What it is for goes on so: a skirt for the school play is no school skirt."""
_FROM = re.compile(
    r"(?<!\w)([^\W\d_]+) (?:from|in|out of|as in|like in|of)(?: the)?(?: (?:film|movie|show|series))?"
    r" ([A-Z][^\W\d_]+)(?!\w)"
)
"""A garment of a film: "the dress from Atonement"."""
_SEEN_BY_GUESTS = ("wedding", "weddings")
"""A dress for a wedding is one for its guests, and no wedding dress."""
_ITEM = re.compile(r"(?:^\s*|\s+)(\d{1,2})[.)]\s+(?=[^\W\d])")
"""Numbers before the items of a list."""

_NONE_OF = re.compile(
    r"(?<!\w)((?:waist |side |back |front |leg |shoulder )?[^\W\d_]{3,})\s*[:=]\s*"
    r"(?:none|nil|nothing|no|not any|without|n/a|keine?r?|aucune?|ning[uú]n[oa]?|nessun[oa]?"
    r"|geen)(?=\s*(?:[,.;\n/|]|$))",
    re.IGNORECASE,
)
"""What a list has none of: "collar: none"."""

_WITHDRAWN = re.compile(
    r"(?<!\w)(?:with |in )?(?:an? |some )?[\w'’-]+(?: [\w'’-]+)?\?\s*(?:no|nah|nope|nein|non)(?!\w)[,:]?\s*"
    r"(?=(?:just|only|nur)(?!\w))",
    re.IGNORECASE,
)
"""What is asked and answered with no: "with godets? no, just a full circle"."""

_CORRECTED = re.compile(
    r"^\W*(?:[\w'’-]+\s+){0,3}[\w'’-]+[\s,.;–—-]+(?:no,? wait|wait,? no|scratch that|actually,? no|or rather"
    r"|(?:sorry,? )?i meant?|no,? sorry)(?!\w)[\s,:–—-]*(?=\D+$)",
    re.IGNORECASE,
)
"""A few words that are taken back: "a dress, no wait, a jumpsuit"."""


def text_as_read(text: str, kind: str | None = None) -> tuple[str, WordReading]:
    """The text with typing errors put right, and its words.

    They are so in words that nobody knows, where the first letter stays, and in those that the lexicon has as
    another spelling. What is not English stays as it is, but typing errors look foreign.
    """
    text = _turned(text)
    pieces, end, slips = [], 0, []
    for mark in read_words(text, language=ENGLISH, kind=kind).marks:
        meant = None if mark.entries else common_slip(mark.word)
        better = meant or put_right(mark.word)
        if not mark.entries and better == mark.word:
            better = lexicon_spelling(mark.word) or mark.word
        if better == mark.word:
            continue
        known = any(better.lower() == word.lower() for entry in mark.entries for word in entry.words)
        same = better[:1].lower() == mark.word[:1].lower() or meant is not None
        if same and (known or not mark.entries):
            pieces += [text[end : mark.start], better]
            slips.append(meant is not None)
            end = mark.end
    shown = "".join([*pieces, text[end:]])
    own = read_words(text, kind=kind)
    foreign = own.language != ENGLISH and not own.unknown
    if shown == text or (foreign and not all(slips)):
        return text, own
    words = read_words(shown, kind=kind)
    if foreign and words.unknown:
        return text, own
    return (shown, words) if words.language == ENGLISH else (text, own)


def _turned(text: str) -> str:
    """The text as its tables have it: "hospital gown" for "gown for hospital"."""

    def turned(found: re.Match[str]) -> str:
        if _GOES_ON.match(found.string, found.end()):
            return found[0]
        name = f"{found[2]} {found[1]}"
        before = found.string[: found.start()].split()[-1:]
        longer = is_garment(" ".join([*before, found[1]]).lower()) if before else False
        if longer or not is_garment(name.lower()) or found[2].lower() in _SEEN_BY_GUESTS:
            return found[0]
        return name

    text = adjectives_plainly(_NONE_OF.sub(r"no \1", text))
    text = _without_list_numbers(_corrected(_WITHDRAWN.sub("", text)))
    text = _SAY.sub(" ", text)
    text = _ABOUT.sub(r"\1 ", text)
    for short, long in _SHORTENED:
        text = short.sub(long, text)
    text = with_parts_apart(names_turned(_FROM.sub(turned, _OF.sub(turned, text))))
    return _BODY.sub(r"the \2", _REACHES.sub(r"to the \2", text))


def _corrected(text: str) -> str:
    """The text without what it takes back, but for the garment where that alone is not corrected."""
    found = _CORRECTED.search(text)
    if found is None:
        return text
    before, behind = found[0], text[found.end() :].strip(" .!")
    if any(mark.role == "garment" for mark in read_words(behind).marks):
        return text[found.end() :]
    named = [mark.word for mark in read_words(before).marks if mark.role == "garment"]
    return f"{behind} {named[-1]}" if named else text[found.end() :]


def _without_list_numbers(text: str) -> str:
    """A numbered list as its items: "1. no hood 2. high collar" asks for no number of anything."""
    numbers = list(_ITEM.finditer(text))
    if len(numbers) < 2 or [int(found[1]) for found in numbers] != list(range(1, len(numbers) + 1)):
        return text
    return _ITEM.sub("; ", text).removeprefix("; ")


def lacks_of(
    words: WordReading, changes: Sequence[Change], measures: Sequence[SpokenMeasure] = ()
) -> tuple[Lack, ...]:
    """What cannot be made; a number that was read is no size."""
    return tuple(
        [
            lack
            for lack in words.lacks
            if lack.what in _COUNTED
            or not any(m.mention.start < lack.mark.end and lack.mark.start < m.mention.end for m in measures)
            if lack.what != "sizes"
            or not _DIGIT.search(lack.mark.word)
            or unread_numbers(lack.mark.word, changes)
        ]
    )
