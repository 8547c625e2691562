"""What is made for an occasion or a mood where no garment is named: a sundress for the beach."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.heard import Heard
from swifttailor.wording.claim_kinds import fits_kind, implied_kind
from swifttailor.wording.lexicon import Entry, WordMark, read_words
from swifttailor.wording.lexicon.tokens import words_of
from swifttailor.wording.lexicon.vocabulary import vocabulary

_FIRST = ("accessories", "occasions")
"""A tuxedo says more of what is worn than the evening does, and that more than "comfy"; persons say most."""
_NAMES = ("garment", "like")
"""Roles of words that name the garment."""
_MERE_DRESSES = ("dress", "gown", "frock", "costume", "outfit")
_OF_THE_CUT = frozenset({"garments", "parts", "styles", "lengths", "fits", "numbers", "sizes"})
"""Categories of words of which one at least stands in a text that tells of the cut."""
_MERE_KINDS = {
    **{"top": "top", "tops": "top", "dress": "dress", "frock": "dress", "skirt": "skirt", "shorts": "shorts"},
    **dict.fromkeys(("trousers", "trouser", "pants", "pant", "bottoms"), "trousers"),
}
"""Names that say no more than what kind of garment it is."""
_PERSONS = "persons.txt"
"""Of whom the looks are known."""
_OF_LOWER = frozenset(
    {"rise", "waistband", "waistband_cm", "skirt", "skirt_length_cm", "legs", "inseam_cm", "hips"}
)
_INSTEAD = {"dress": "dress", "jumpsuit": "navy satin wide-leg jumpsuit", "top": "top"}
"""What suits most occasions, by its kind, where what is usual for one is refused."""
_LONG_SLEEVED = "long sleeved dress"
"""What a dress for cold days is; nothing is to be guessed where sleeves are spoken of."""
_KNITS = frozenset({"jumper", "T-shirt", "sweatshirt"})
_BUTTONED, _SHIRT = frozenset({"buttons"}), "shirt"
_LOOKS = frozenset({"colors", "shades", "prints", "fabrics"})
_PARTY_DRESS = "party dress"
_FINE = frozenset(
    {
        "velvet",
        "satin",
        "silk",
        "lace",
        "chiffon",
        "tulle",
        "sequins",
        "sequin",
        "sequined",
        "taffeta",
        "organza",
    }
)
"""Cloth of festive clothes, of which no jumper is made."""
_DETAILS = 2
"""So many different things have to be said before they tell what a garment is."""
_SHORTEST_DRESS_CM = 75.0
"""From the shoulder to the hem; what is shorter is a top."""
_HIGH_LOW = Claim("hem_shape", "high-low")
_DRESS = Claim("kind", "dress")
_BESIDE_LENGTHS = frozenset(
    "lengths function polite negations degrees generic colors shades prints fabrics".split()
)
_SEAMS = frozenset({Claim("waist_seam", "empire"), Claim("waist_seam", "dropped")})
"""Seams that tops seldom have, so that who names nothing else means a dress."""
_DRESS_LENGTHS = frozenset({"midi", "maxi", "ankle", "floor"})
"""What belongs to skirts and trousers alone, and lengths that tell of a dress where none of it is named."""


def worn_for(heard: Heard) -> str | None:
    """The name of a garment that suits what a text says, where it names none; None where nothing tells.

    Of several occasions the one that stands first in `occasions.txt` decides. What contradicts a detail that
    is asked for is not suggested: no dress where legs are spoken of. What reaches the calves or beyond,
    without legs or a waistband, is a dress, and what details tell by themselves is that kind.
    """
    return _undyed(_as_told(_worn_for(heard), heard), heard) or (
        "dress" if _is_likely_a_dress(heard) or _is_seamed(heard) else _told_by_details(heard)
    )


def _as_told(worn: str | None, heard: Heard) -> str | None:
    """A suggestion that suits what is said of cloth and closings: no jumper of velvet or with buttons."""
    if worn is None or worn.split()[-1] not in _KNITS or heard.words is None:
        return worn
    if any(lack.what in _BUTTONED and lack.said for lack in heard.lacks):
        return _SHIRT
    said = {m.word.lower() for m in heard.words.marks if not m.denied and m.entries}
    fine = any(word in _FINE for words in said for word in words.split())
    return _PARTY_DRESS if fine else worn


def _undyed(worn: str | None, heard: Heard) -> str | None:
    """A suggestion without the colour and the cloth that it is usually of, where the text names its own."""
    if worn is None or heard.words is None:
        return worn
    said = {entry.category for mark in heard.words.marks if not mark.denied for entry in mark.entries}
    said |= {"shades", "prints"} if "colors" in said else set()
    refused = {e.color for m in heard.words.marks if m.denied for e in m.entries if e.color is not None}
    for mark in reversed(read_words(worn).marks):
        own = {e.category for e in mark.entries} & said & _LOOKS if mark.role == "word" else set()
        if own or any(entry.color in refused for entry in mark.entries):
            worn = f"{worn[: mark.start]}{worn[mark.end :].lstrip()}"
    return worn


def _told_by_details(heard: Heard) -> str | None:
    """The kind that several details tell: what has sleeves and a neckline, and no skirt, is a top."""
    words = heard.words
    if words is None or any(mark.role in (*_NAMES, "second", "theirs") for mark in words.marks):
        return None
    said = {i.claim for i in words.implications if i.said and i.certainty == "certain"}
    asked = [w.change.claim for w in heard.sure if isinstance(w.change, Gain)]
    details = [claim for claim in asked if claim in said or claim.name.endswith("_cm")]
    kind = next(iter(implied_kind(details)), None)
    return kind if heard.kind in (None, kind) and len({claim.name for claim in details}) >= _DETAILS else None


def _worn_for(heard: Heard) -> str | None:
    marks = () if heard.words is None else [mark for mark in heard.words.marks if not mark.denied]
    entries = [entry for mark in marks for entry in mark.entries if entry.worn]
    names = {_english(mark) for mark in marks if mark.role in _NAMES}
    if names and (kind := _mere_kind(names)) is not None:
        first = min(entries, key=_order, default=None)
        worn_as = first.worn_as if first is not None else ()
        chosen = [name for name in worn_as if name.endswith(kind)] or _of_kind(worn_as[1:], kind)
        told = {w.change.claim.name for w in heard.sure if isinstance(w.change, Gain)}
        if chosen and not ("sleeves" in told and chosen[0] == _LONG_SLEEVED):  # "a top for Christmas"
            return chosen[0]
    if names:  # "a dress like Mary Poppins", "Clueless skirt"
        known = [entry for entry in entries if entry.place[0] == _PERSONS]
        entries = [e for e in known if names <= {*_MERE_DRESSES, str(e.worn).split()[-1]}]
    named = () if heard.words is None else [i.claim for i in heard.words.implications]
    details = [w.change.claim for w in heard.sure if isinstance(w.change, Gain)]
    guessed = not any(mark.entries and mark.entries[0].category in _OF_THE_CUT for mark in marks)
    details = [c for c in details if c in named or not (guessed or c.name == "kind")]  # a network guesses
    refused = _refused_kinds(heard)
    for entry in sorted(entries, key=_order):
        assert entry.worn is not None
        if entry.category == "fabrics" and not guessed:
            continue  # what tells of the cut tells more than cloth does
        kinds = [str(i.claim.value) for i in read_words(entry.worn).implications if i.claim.name == "kind"]
        if refused.intersection(kinds):
            return next((name for kind, name in _INSTEAD.items() if kind not in refused), None)
        if all(_may_have(kind, claim.name, claim.value) for kind in kinds for claim in details):
            return entry.worn
    return None


def _of_kind(names: Sequence[str], kind: str) -> list[str]:
    """Those that are of a kind, whatever they are called: joggers are trousers."""
    return [
        name for name in names if any(i.claim == Claim("kind", kind) for i in read_words(name).implications)
    ]


def _english(mark: WordMark) -> str:
    """The name of a garment; that of the entry that a word of another language stands for."""
    named = next((entry.english for entry in mark.entries if entry.english), None)
    return (named or mark.word).lower()


def _mere_kind(names: Collection[str]) -> str | None:
    """The kind that a text names and nothing more of; None where it says which one of that kind."""
    kinds = {_MERE_KINDS.get(name) for name in names}
    return next(iter(kinds)) if len(kinds) == 1 else None


def _refused_kinds(heard: Heard) -> frozenset[str]:
    """Kinds that are not wanted; who wants no skirts wants no dresses."""
    refused = {str(claim.value) for claim in heard.never if claim.name == "kind"}
    denied = [m for m in (() if heard.words is None else heard.words.marks) if m.denied]
    styles = [e for mark in denied for e in mark.entries if e.kinds and not e.is_mere_kind]
    named = {kind for mark in denied for e in mark.entries if e.is_mere_kind for kind in e.kinds}
    refused -= frozenset().union(*[e.kinds for e in styles]) - named  # "but not a bodycon": another dress
    return frozenset(refused | ({"dress"} if "skirt" in refused else set()))


def _is_likely_a_dress(heard: Heard) -> bool:
    marks = () if heard.words is None else heard.words.marks
    claims = [w.change.claim for w in heard.sure if isinstance(w.change, Gain)]
    guessed = [w.change.claim for w in heard.likely if isinstance(w.change, Gain)]
    if any(mark.role in (*_NAMES, "second") for mark in marks) or _DRESS in guessed:
        return False
    if any(claim.name in ("kind", *_OF_LOWER) for claim in claims) or (heard.unread and not claims):
        return False
    if any(claim.name == "length_cm" and float(claim.value) < _SHORTEST_DRESS_CM for claim in claims):
        return False
    hems = [claim for claim in (*claims, *guessed, *heard.never) if claim.name == "skirt_hem"]
    if any(claim == _HIGH_LOW for claim in claims) and not any(c.name == "top_hem" for c in claims):
        return True
    alone = all(m.entries and m.entries[0].category in _BESIDE_LENGTHS for m in marks)  # "knee length"
    return any(claim.value in _DRESS_LENGTHS for claim in hems) or (alone and bool(hems))


def _is_seamed(heard: Heard) -> bool:
    """Whether a seam at the waist is all that tells of a garment: "drop waist", "empire, with sleeves"."""
    words = heard.words
    if words is None or any(mark.role in (*_NAMES, "second") for mark in words.marks):
        return False
    said = {i.claim for i in words.implications if i.said and i.certainty == "certain"}
    legs = any(claim.name in _OF_LOWER - {"skirt", "skirt_length_cm", "hips"} for claim in said)
    return not (legs or said.isdisjoint(_SEAMS))


def _may_have(kind: str, name: str, value: object) -> bool:
    return value == kind if name == "kind" else fits_kind(name, kind)


def _order(entry: Entry) -> tuple[int, int, int]:
    if entry.english:  # of another language: where the word that it stands for has its row
        named = vocabulary("en").find(words_of(entry.english.lower(), "en"))
        entry = next((sense.entry for sense in named if sense.entry.worn), entry)
    category, (file, line) = entry.category, entry.place
    return int(file != _PERSONS), _FIRST.index(category) if category in _FIRST else len(_FIRST), line
