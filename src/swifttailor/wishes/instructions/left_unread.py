"""Words and numbers of an instruction that nothing came of, and those that are answered otherwise."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.differences import Change, Gain, Step, subject_of
from swifttailor.wishes.instructions.spoken_amounts import share_of
from swifttailor.wishes.reader import Wish
from swifttailor.wishes.text.mentions import find_mentions
from swifttailor.wording.claim_kinds import fits_kind
from swifttailor.wording.lexicon import Entry, WordReading


def other_garments(text: str, words: WordReading, kind: str | None, changes: Sequence[Change]) -> list[str]:
    """Names of garments behind "with", where nothing came of them: "in one piece with trousers"."""
    if any(isinstance(c, Gain) and c.claim.name in ("kind", "skirt") for c in changes):
        return []
    found = []
    for mark in words.marks:
        named = {i.claim.value for e in mark.entries for i in e.implied if i.claim.name == "kind"}
        joined = (
            text[: mark.start].lower().rstrip().endswith(("with", "mit", "avec", "con", "met", "com", "and"))
        )
        if not mark.denied and mark.entries and mark.entries[0].category == "garments" and joined:
            found += [] if kind in named else [mark.word]
    return found


_WITHOUT_SOME = frozenset({"skirt", "trousers", "shorts", "jumpsuit", "playsuit"})


def of_its_kind(wishes: Sequence[Wish], kind: str | None) -> tuple[list[Wish], list[str]]:
    """Without what garments of a kind cannot have, which would make another garment of it: slits in trousers.

    Args:
        wishes: What is asked for.
        kind: Of the garment; None where that is not known.

    Returns:
        The others, and in words what is left out.
    """
    kinds = [
        w.change for w in wishes if isinstance(w.change, Gain) and w.change.claim.name in ("kind", "skirt")
    ]
    if kind not in _WITHOUT_SOME or kinds:
        return list(wishes), []
    unfit = [
        w
        for w in wishes
        if isinstance(w.change, Gain)
        and w.change.claim.name != "sides"
        and not fits_kind(w.change.claim.name, kind)
    ]
    names = dict.fromkeys([subject_of(w.change).replace("_", " ") for w in unfit])
    return [w for w in wishes if w not in unfit], [f"{name} (not of {kind})" for name in names]


def counts_elsewhere(number: str, text: str, changes: Sequence[Change]) -> bool:
    """Whether a number is in no wish as it stands and yet counts: as a share, on both sides."""
    if share_of(text.lower()) is not None:
        return True
    value = next((m.value for m in find_mentions(number)), None)
    amounts = [c.amount for c in changes if isinstance(c, Step) and c.amount is not None]
    return value is not None and any(abs(amount - 2 * value) < 0.1 for amount in amounts)


def not_answered(unread: Sequence[str], words: WordReading) -> tuple[str, ...]:
    """What was not understood, without what the lexicon answers: colours, fabrics, what cannot be made."""
    answered = [color.words for color in words.colors] + [lack.mark.word for lack in words.lacks if lack.said]
    answered += [mark.word for mark in words.marks if any(_is_fabric(entry) for entry in mark.entries)]
    known = {part.lower() for word in answered for part in word.split()}
    return tuple([text for text in unread if not {part.lower() for part in text.split()} <= known])


def _is_fabric(entry: Entry) -> bool:
    return entry.category == "fabrics" and entry.cloth is not None
