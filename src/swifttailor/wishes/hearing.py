"""What a text asks for, by the lexicon of clothes and the network together.

What words mean by definition and what details say comes first, then what the network reads, then what the
names of garments usually imply. The network alone reads numbers, changes of measures, and how words hang
together.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from swifttailor.describing.claims import Claim, claims_of
from swifttailor.describing.differences import Change, Gain, Step, subject_of
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.facts import GarmentFacts
from swifttailor.garment.cloth_print import ClothPrint
from swifttailor.wishes.accounting import unaccounted
from swifttailor.wishes.heard_print import asks_for_plain, heard_print
from swifttailor.wishes.lexicon_spelling import guessed_name, is_garment, lexicon_spelling, near_names
from swifttailor.wishes.mentions import find_mentions
from swifttailor.wishes.reader import Wish, WishReader
from swifttailor.wishes.spelling import put_right
from swifttailor.wishes.spoken_hems import spoken_bounds, spoken_hem, spoken_slit
from swifttailor.wishes.spoken_measures import SpokenMeasure, same_number, spoken_measures
from swifttailor.wishes.spoken_changes import SpokenChanges, SpokenClause, other_than, spoken_changes
from swifttailor.wishes.sureness import likely_wishes, sure_wishes
from swifttailor.wishes.unread import not_understood, says_nothing_else, unread_numbers
from swifttailor.wording.claim_kinds import fits_kind, implied_kind
from swifttailor.wording.lexicon import (
    SURENESS,
    Entry,
    Lack,
    WordReading,
    cannot_texts,
    exclude,
    foreign_language,
    read_words,
)

SURE_IN_KNOWN_WORDS = 0.7
"""Enough for an edit whose words are all known ones for what was read: 147 of 162 such wishes
are meant (instructions between validation patterns, written as for the training)."""
SURE_BESIDE = 0.97
"""Enough in a clause of an instruction that words alone explain in part."""
SURE_OF_EVERY_WORD = 0.96
"""Enough for the network to come before the lexicon, where it leaves no word out."""
_PHRASE = 4
"""Words of an entry of the lexicon that is surer than anything the network reads in it."""
_DETAIL = {"certain": SURENESS["certain"], "usual": 0.92}
"""How sure what is said of a detail is: it is asked for, whatever is usual."""
_OF_BOTH_SIDES = {"neckline": "neckline", "sleeve": "sleeves"}
_ENGLISH = "en"
_DIGIT = re.compile(r"\d")


@dataclass(frozen=True)
class Heard:
    """What a text asks for."""

    text: str
    """As it was read: with slips of the fingers put right."""
    sure: tuple[Wish, ...] = ()
    likely: tuple[Wish, ...] = ()
    """What names of garments usually imply, and what may be meant."""
    never: tuple[Claim, ...] = ()
    """What it refuses."""
    unread: tuple[str, ...] = ()
    """What of it was not understood, in its own words."""
    lacks: tuple[Lack, ...] = ()
    """What it asks for and cannot be made."""
    words: WordReading | None = None
    """By the lexicon; None where there is no text."""
    guess: str = ""
    """The name that the garment was made by, where none was understood and this is spelt like a word of it."""
    clashes: tuple[tuple[str, str], ...] = ()
    """What of an instruction asks for opposite things, in words; none of it is done."""

    @property
    def color(self) -> str | None:
        """The first colour that it names, ``#rrggbb``, or that a name implies: a little black dress."""
        named = self.words.colors if self.words is not None else ()
        rgb = named[0].rgb if named else next((e.color for e in self._meant if e.color is not None), None)
        return None if rgb is None else f"#{rgb}"

    @cached_property
    def print(self) -> ClothPrint | None:
        """The print that it asks for."""
        return None if self.words is None else heard_print(self.text, self.words)

    @property
    def plain(self) -> bool:
        """Whether it asks for cloth without print."""
        return self.words is not None and asks_for_plain(self.words)

    @property
    def cloth(self) -> str | None:
        """The fabric that comes nearest to what it names, or to what a name implies: a denim skirt."""
        named = self.words.cloths if self.words is not None else ()
        return named[0] if named else next((e.cloth for e in self._meant if e.cloth is not None), None)

    @property
    def _meant(self) -> list[Entry]:
        marks = () if self.words is None else self.words.marks
        return [entry for mark in marks if not mark.denied for entry in mark.entries]

    @cached_property
    def cannot(self) -> tuple[str, ...]:
        """What it asks for and cannot be made, in words."""
        return tuple([cannot_texts()[lack.what] for lack in self.lacks if lack.said])

    @cached_property
    def left_out(self) -> tuple[str, ...]:
        """What the names of garments in it mean and cannot be made, in words."""
        return tuple([cannot_texts()[lack.what] for lack in self.lacks if not lack.said])

    @property
    def foreign(self) -> str | None:
        """The language that it is in, where that is none that is read."""
        return None if self.words is None else foreign_language(self.text, self.words.unknown)

    @property
    def contradictions(self) -> tuple[tuple[str, str], ...]:
        """Pairs of words in it that cannot both be true."""
        found = () if self.words is None else self.words.contradictions
        pairs = [(pair.first.word, pair.second.word) for pair in found]
        return tuple(dict.fromkeys([*pairs, *self.clashes]))

    @property
    def kind(self) -> str | None:
        """The kind of garment that is asked for, or that details tell; None where nothing does."""
        claims = [w.change.claim for w in (*self.sure, *self.likely) if isinstance(w.change, Gain)]
        named = next((str(claim.value) for claim in claims if claim.name == "kind"), None)
        return named or next(iter(implied_kind(claims)), None)

    @cached_property
    def near(self) -> tuple[str, ...]:
        """Names of garments that are spelt like words that were not understood."""
        return near_names(self.unread)


HEARD_NOTHING = Heard("")
"""Where there is no text."""


def hear_description(text: str, reader: WishReader) -> Heard:
    """What garment a text describes.

    Where nothing tells which garment is meant, a name that is spelt like a word that nobody knows is taken as a
    guess, and said to be one.

    Args:
        text: In English, or of German, French and Spanish what the lexicon knows.
        reader: The network.
    """
    if not text.strip():
        return HEARD_NOTHING
    heard = _heard_description(text, reader)
    near = guessed_name(heard.unread) if heard.kind is None else None
    if near is None:
        return heard
    word, name = near
    again = _heard_description(heard.text.replace(word, name), reader)
    if again.kind is None:
        return heard
    return replace(again, text=heard.text, unread=tuple(dict.fromkeys([word, *again.unread])), guess=name)


def _heard_description(text: str, reader: WishReader) -> Heard:
    text, words = _put_right(text)
    network = reader.read(text, instruction=False) if words.language == _ENGLISH else ()
    named = next((str(i.claim.value) for i in words.implications if i.claim.name == "kind"), None)
    measures = spoken_measures(text, named)
    hem = spoken_hem(text, named)
    said = [m.claim for m in measures if m.claim is not None] + ([] if hem is None else [hem])
    said += spoken_bounds(text, words)
    if (slit := spoken_slit(text, words)) is not None:
        said.append(slit)
    network = [w for w in network if not _is_against_phrase(w, words)]
    never = (*words.never, *_with_parts(words))
    network = [w for w in network if not _is_measured(w, measures) and not _is_outdone(w, said, never)]
    found = _explained(text, words, network) or united(text, words, network)
    stated = [Wish(Gain(claim), SURENESS["certain"]) for claim in said]
    found = (*stated, *[w for w in found if not _is_outdone(w, said, never) and w.change not in _changes(stated)])
    if any(claim == _BARE_ARMS for claim in never) and not any(
        isinstance(w.change, Gain) and w.change.claim.name in ("sleeves", "left_sleeve") for w in found
    ):
        found = (*found, Wish(Gain(Claim("sleeves", "short")), SURENESS["usual"]))
    changes = _changes(found)
    known = " ".join([*words.sizes, *[text[m.mention.start : m.mention.end] for m in measures if m.claim]])
    unread = *words.unknown, *[n for n in unread_numbers(text, changes) if n not in known]
    sure, likely = sure_wishes(found), likely_wishes(found)
    silent = unaccounted(words, _changes((*sure, *likely)), never, [m.mention.end for m in measures])
    return Heard(
        text, sure, likely, never, (*unread, *silent), _lacks(words, changes, measures), words
    )


def _changes(wishes: Iterable[Wish]) -> list[Change]:
    return [wish.change for wish in wishes]


def _is_against_phrase(wish: Wish, words: WordReading) -> bool:
    """Whether the network takes a part of a phrase for all of it: in "one and a half circles" a half circle."""
    if not isinstance(wish.change, Gain):
        return False
    claim = wish.change.claim
    long = [i.claim for i in words.implications if i.said and len(i.mark.word.split()) >= _PHRASE]
    return claim not in long and any(claim.name == other.name for other in long)


def _with_parts(words: WordReading) -> tuple[Claim, ...]:
    """What is refused by naming a part: a dress with sleeves is not sleeveless."""
    told = {i.claim.name for i in words.implications if i.said}
    named = any(
        mark.entries and mark.entries[0].part == "sleeves" and not mark.denied and mark.role != "theirs"
        for mark in words.marks
        if mark.entries and mark.entries[0].category == "parts"
    )
    return (_BARE_ARMS,) if named and "sleeves" not in told and "shoulders" not in told else ()


_BARE_ARMS = Claim("sleeves", "none")
_TOPICS = {
    "leg_width_cm": "legs",
    "sleeve_width_cm": "sleeve_shape",
    "neck_depth_cm": "neck_depth",
    "skirt_length_cm": "skirt_hem",
    "inseam_cm": "leg_hem",
}
"""What measures speak of in figures."""


def _is_outdone(wish: Wish, said: Sequence[Claim], never: Sequence[Claim]) -> bool:
    """Whether a wish is about what is stated in figures, or is refused, or says otherwise."""
    if not isinstance(wish.change, Gain):
        return False
    claim = wish.change.claim
    if claim in never or any(exclude(claim, other) for other in said):
        return True
    topics = {_TOPICS.get(other.name) for other in said}
    return claim.name in topics and wish.certainty < SURENESS["certain"]


def hear_instruction(text: str, reader: WishReader, facts: GarmentFacts | None = None) -> Heard:
    """How a text wants a garment to be changed.

    Comparisons, details and removals are read by words (`spoken_changes`). Clauses in which these leave words
    over, the network reads; it is believed where it contradicts nothing that is said.

    Args:
        text: In English, or of German, French and Spanish what the lexicon knows.
        reader: The network.
        facts: Of the garment; None where it cannot be measured.
    """
    kind = None if facts is None else named_kind(facts)
    text, words = _put_right(text, kind)
    spoken = spoken_changes(
        text, words, kind or "dress", lambda claim: facts is not None and claim.holds(facts)
    )
    told = list(spoken.changes)
    stated = {}
    for measure in spoken_measures(text, kind):
        clause = next((c for c in spoken.clauses if c.start <= measure.mention.start < c.end), None)
        stepped = clause is not None and any(isinstance(c, Step) for c in clause.changes)
        if measure.claim is not None and clause is not None and not stepped:
            stated[clause.start] = measure
            told.append(Gain(measure.claim))
    covered = facts is not None and QUANTITIES["armholes"].of(facts) is None
    hidden = [c for c in told if covered and isinstance(c, Step) and c.quantity == "armholes"]
    told = [change for change in told if change not in hidden]  # nobody takes sleeves off for that
    sure = [Wish(change, SURENESS["certain"]) for change in told]
    likely: list[Wish] = []
    unread: list[str] = ["armholes (below sleeves they cannot be changed)"] if hidden else []
    for clause in spoken.clauses:
        if not clause.left_over or clause.start in stated:
            continue
        found = _by_network(text, clause, reader, words, len(spoken.clauses) == 1)
        new = [w for w in found if _adds(w.change, told, spoken, words)]
        certain = [w for w in sure_wishes(tuple(new)) if not clause.changes or w.certainty >= SURE_BESIDE]
        plain = [w for w in likely_wishes(tuple(new)) if w.certainty >= SURE_IN_KNOWN_WORDS]
        part = text[clause.start : clause.end]
        if not clause.changes and plain and says_nothing_else(part, [w.change for w in (*certain, *plain)]):
            certain = [*certain, *plain]
        sure += certain
        told += [w.change for w in certain]
        likely += [w for w in likely_wishes(tuple(new)) if w not in certain]
        unread += _still_unread(part, clause, certain, reader)
    held = [] if facts is None else [c for c in words.never if c.holds(facts)]
    sure += [
        Wish(gain, SURENESS["usual"] + 0.1)
        for gain in other_than(words.never, held, [subject_of(change) for change in told])
        if not _is_moved_away(gain, told)
    ]
    changes = [wish.change for wish in sure]
    lacks = tuple([lack for lack in _lacks(words, changes) if lack.said])
    silent = _not_answered(unread, words)
    return Heard(
        text, tuple(sure), tuple(likely), words.never, silent, lacks, words, clashes=spoken.clashes
    )


def named_kind(facts: GarmentFacts) -> str:
    """What a garment is called: shorts are told from trousers."""
    return next((str(c.value) for c in claims_of(facts) if c.name == "kind"), facts.kind)


def _by_network(
    text: str, clause: SpokenClause, reader: WishReader, words: WordReading, alone: bool
) -> tuple[Wish, ...]:
    if words.language != _ENGLISH:
        return ()
    return reader.read(text if alone else text[clause.start : clause.end], instruction=True)


def _adds(change: Change, told: Sequence[Change], spoken: SpokenChanges, words: WordReading) -> bool:
    """Whether something that the network reads is new, and contradicts nothing that is said."""
    subject = subject_of(change)
    if subject in spoken.kept or any(subject_of(other) == subject for other in told):
        return False
    if isinstance(change, Gain):
        if change.claim in words.never or change.claim.name == "kind":
            return change.claim.name == "kind" and not told and change.claim not in words.never
        return not any(isinstance(o, Gain) and exclude(change.claim, o.claim) for o in told)
    return True


def _is_moved_away(gain: Gain, told: Sequence[Change]) -> bool:
    """Whether a step leads away from what is refused already."""
    moved = {
        "fit": ("chest",), "neckline": ("neck depth", "neck width"), "skirt_hem": ("length",),
        "sleeve_shape": ("sleeve width", "sleeve end", "sleeve head"),
    }  # fmt: skip
    steps = {change.quantity for change in told if isinstance(change, Step)}
    return bool(steps.intersection(moved.get(gain.claim.name, ())))


def _still_unread(
    part: str, clause: SpokenClause, wishes: Sequence[Wish], reader: WishReader
) -> tuple[str, ...]:
    """Of the words that nothing accounts for, those that the network made nothing of either."""
    if not wishes:
        return clause.left_over
    changes = [wish.change for wish in wishes]

    def read(other: str) -> list[Change]:
        return [w.change for w in sure_wishes(reader.read(other, instruction=True))]

    missed = " ".join(not_understood(part, changes, read)).lower().split()
    return tuple([words for words in clause.left_over if set(words.split()) & set(missed)])


def united(text: str, words: WordReading, network: Iterable[Wish]) -> tuple[Wish, ...]:
    """What lexicon and network say together, surest first.

    Args:
        text: In which "long" behind a length is no claim: "60 cm long".
        words: By the lexicon.
        network: What the network reads of the same text, surest first.
    """
    lengths = {mention.end for mention in find_mentions(text) if mention.is_length}
    implied = [i for i in words.implications if len(text[: i.mark.start].rstrip(" -")) not in lengths]
    found = [
        Wish(Gain(each.claim), _DETAIL[each.certainty])
        for each in implied
        if each.certainty == "certain" or (each.said and each.certainty == "usual")
    ]
    told = [wish.change.claim for wish in found if isinstance(wish.change, Gain)]
    kind = next((str(claim.value) for claim in told if claim.name == "kind"), None)
    if kind == "skirt":  # "a skirt, no darts" asks for nothing of a bodice
        found = [w for w in found if not (isinstance(w.change, Gain) and w.change.claim.name == "bodice")]
    names = [Wish(Gain(each.claim), SURENESS[each.certainty]) for each in implied if each.claim not in told]
    for wish in (*network, *names):
        if not isinstance(wish.change, Gain):
            continue
        claim = wish.change.claim
        if claim in told or claim in words.never or any(exclude(claim, other) for other in told):
            continue
        if kind is not None and not fits_kind(claim.name, kind):
            continue
        found.append(wish)
        told.append(claim)
    return tuple(sorted(found, key=lambda wish: -wish.certainty))


def _explained(text: str, words: WordReading, network: Iterable[Wish]) -> tuple[Wish, ...]:
    """What both say where the network is sure of something for every word: it knows how they hang together.

    Returns:
        Surest first: what it is sure of, and of the rest what does not contradict that; nothing where there
        are words that it has no wish for.
    """
    sure = [w for w in network if isinstance(w.change, Gain) and w.certainty >= SURE_OF_EVERY_WORD]
    if not sure or not says_nothing_else(text, [wish.change for wish in sure]):
        return ()
    told = [wish.change.claim for wish in sure if isinstance(wish.change, Gain)]
    if any(claim in words.never for claim in told):
        return ()
    names = {claim.name for claim in told}
    for side in ("left_", "right_"):  # who tells one side has told of both
        names |= {plural for one, plural in _OF_BOTH_SIDES.items() if side + one in names}
    for wish in united(text, words, network):
        claim = wish.change.claim if isinstance(wish.change, Gain) else None
        if claim is None or claim.name in names or any(exclude(claim, other) for other in told):
            continue
        sure.append(wish)
    return tuple(sorted(sure, key=lambda wish: -wish.certainty))


def _put_right(text: str, kind: str | None = None) -> tuple[str, WordReading]:
    """The text with typing errors put right, and its words.

    They are so in words that nobody knows, where the first letter stays, and in those that the lexicon has as
    another spelling. What is not English stays as it is, but typing errors look foreign.
    """
    text = _turned(text)
    pieces, end = [], 0
    for mark in read_words(text, language=_ENGLISH, kind=kind).marks:
        better = put_right(mark.word)
        if not mark.entries and better == mark.word:
            better = lexicon_spelling(mark.word) or mark.word
        known = any(better.lower() == word.lower() for entry in mark.entries for word in entry.words)
        if better[:1].lower() == mark.word[:1].lower() and (known or not mark.entries):
            pieces += [text[end : mark.start], better]
            end = mark.end
    shown = "".join([*pieces, text[end:]])
    words = read_words(shown, kind=kind)
    if shown == text or words.language == _ENGLISH:
        return shown, words
    return text, read_words(text, kind=kind)


_OF = re.compile(r"(?<!\w)([^\W\d_]+) (?:of|for)(?: the| an?)? ([^\W\d_]+)(?!\w)")


def _turned(text: str) -> str:
    """The text with "gown for hospital" turned into "hospital gown", where that is the name of a garment."""

    def turned(found: re.Match[str]) -> str:
        name = f"{found[2]} {found[1]}"
        return name if is_garment(name.lower()) else found[0]

    return _OF.sub(turned, text)


def _is_measured(wish: Wish, measures: Sequence[SpokenMeasure]) -> bool:
    """Whether a number that the network reads is said of something else, or of the same thing."""
    claim = wish.change.claim if isinstance(wish.change, Gain) else None
    if claim is None or isinstance(claim.value, str):
        return False
    stated = {m.claim.name for m in measures if m.claim is not None}
    return claim.name in stated or any(same_number(measure, claim.value) for measure in measures)


def _lacks(
    words: WordReading, changes: Sequence[Change], measures: Sequence[SpokenMeasure] = ()
) -> tuple[Lack, ...]:
    """What cannot be made; a number that was read is no size."""
    return tuple(
        [
            lack
            for lack in words.lacks
            if not any(m.mention.start <= lack.mark.start < m.mention.end for m in measures)
            if lack.what != "sizes"
            or not _DIGIT.search(lack.mark.word)
            or unread_numbers(lack.mark.word, changes)
        ]
    )


def _not_answered(unread: Sequence[str], words: WordReading) -> tuple[str, ...]:
    """What was not understood, without what the lexicon answers: colours, fabrics, and what cannot be made."""
    answered = [color.words for color in words.colors] + [lack.mark.word for lack in words.lacks if lack.said]
    answered += [mark.word for mark in words.marks if any(_is_fabric(entry) for entry in mark.entries)]
    known = {part.lower() for word in answered for part in word.split()}
    return tuple([text for text in unread if not {part.lower() for part in text.split()} <= known])


def _is_fabric(entry: Entry) -> bool:
    return entry.category == "fabrics" and entry.cloth is not None
