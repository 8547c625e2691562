"""What a text asks for, by the lexicon of clothes and the network together.

What words mean by definition and what details say comes first, then what the network reads, then what the
names of garments usually imply. The network alone reads numbers, changes of measures, and how words hang
together.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain
from swifttailor.networks.beside import beside
from swifttailor.wishes.corrections.closed_behind import without_opposites
from swifttailor.wishes.corrections.deep_cuffs import without_deep_cuffs
from swifttailor.wishes.corrections.full_hems import shapes_by_figures
from swifttailor.wishes.corrections.long_names import (
    against_names,
    against_phrases,
    hangs_so,
    is_against_phrase,
    is_long_name,
)
from swifttailor.wishes.corrections.one_arm import (
    of_one_arm,
    of_two_arms,
    with_both_arms,
    without_guessed_length,
)
from swifttailor.wishes.corrections.sureness import likely_wishes, sure_wishes
from swifttailor.wishes.corrections.told_leg_ends import with_told_leg_ends
from swifttailor.wishes.corrections.told_sleeves import as_long_as_told, of_the_only_arm, with_named_sleeves
from swifttailor.wishes.corrections.weighed_together import (
    of_both_faces,
    other_slits,
    weighed_all,
    without_flare,
    without_flared_legs,
)
from swifttailor.wishes.descriptions.closeness_given_up import closeness_refused
from swifttailor.wishes.descriptions.coats_by_length import coats_by_length
from swifttailor.wishes.descriptions.kind_of_details import (
    fitting_the_name,
    skirts_of_dresses,
    with_one_band,
    within_the_name,
    without_wrong_kind,
)
from swifttailor.wishes.descriptions.made_into import made_into_a_dress
from swifttailor.wishes.descriptions.named_alone import kind_named_alone
from swifttailor.wishes.descriptions.sayings_of_wishes import plainly_wished, without_asides
from swifttailor.wishes.descriptions.united import explained, united
from swifttailor.wishes.descriptions.unmeant_guesses import without_guesses
from swifttailor.wishes.descriptions.whole_wish import described_as_a_whole
from swifttailor.wishes.descriptions.worn_for import worn_for
from swifttailor.wishes.drafts.refused_looks import refused_frills
from swifttailor.wishes.drafts.set_in_refused import refused_sleeve_heads
from swifttailor.wishes.heard import HEARD_NOTHING, Heard
from swifttailor.wishes.instructions.spoken_of import is_of_places
from swifttailor.wishes.looks.words_of_looks import spans_of_looks
from swifttailor.wishes.outfits.first_piece import first_piece
from swifttailor.wishes.outfits.side_remarks import without_side_remarks
from swifttailor.wishes.reader import Wish, WishReader
from swifttailor.wishes.text.accounting import subjects_spoken_of, unaccounted
from swifttailor.wishes.text.complaints import without_complaints
from swifttailor.wishes.text.figures_plainly import figures_plainly
from swifttailor.wishes.text.leg_figures import (
    not_of_legs,
    spans_of_told_shapes,
    told_rises,
    without_told_shapes,
)
from swifttailor.wishes.text.lexicon_spelling import guessed_name
from swifttailor.wishes.text.one_half import of_one_half
from swifttailor.wishes.text.slit_levels import slit_levels
from swifttailor.wishes.text.spoken_faces import spoken_faces
from swifttailor.wishes.text.spoken_hems import spoken_bounds, spoken_hem, spoken_slit
from swifttailor.wishes.text.spoken_levels import clashing_levels, spoken_levels
from swifttailor.wishes.text.spoken_measures import SpokenMeasure, can_measure, same_number, spoken_measures
from swifttailor.wishes.text.spoken_sides import spoken_sides, without_spans
from swifttailor.wishes.text.text_as_read import ENGLISH, lacks_of, text_as_read
from swifttailor.wishes.text.unread import unread_numbers
from swifttailor.wishes.trims.big_buttons import not_of_buttons, spans_of_big_buttons
from swifttailor.wishes.trims.button_counts import buttons_stated
from swifttailor.wording.claim_kinds import fits_kind
from swifttailor.wording.lexicon import SURENESS, WordReading, exclude, glossed, read_words
from swifttailor.wording.lexicon.conflicts import SCALES
from swifttailor.wording.lexicon.long_tops import kinds_outgrown


def hear_description(text: str, reader: WishReader, *, alone: bool = True) -> Heard:
    """What garment a text describes.

    Where nothing tells which garment is meant, a name that is spelt like a word that nobody knows is taken as
    a guess, and said to be one.

    Args:
        text: In English, or of another language that is read what the lexicon knows.
        reader: The network.
        alone: Whether there is no picture that shows which garment is meant.
    """
    return _described(text, reader, alone=alone).with_looks() if text.strip() else HEARD_NOTHING


def _described(text: str, reader: WishReader, *, alone: bool) -> Heard:
    """The same without looks of parts."""
    text = of_one_half(without_complaints(glossed(figures_plainly(text))))
    heard = _heard_description(text, reader)
    meant = worn_for(heard) if alone else None
    if meant is not None:
        again = _in_its_language(_heard_description(f"{meant}, {heard.text}", reader), heard)
        return replace(again, text=heard.text, guess=meant)
    near = None if _is_named(heard) else guessed_name(heard.unread)
    if near is None:
        return heard
    word, name = near
    again = _heard_description(heard.text.replace(word, name), reader)
    if again.kind is None:
        return heard
    return replace(again, text=heard.text, unread=tuple(dict.fromkeys([word, *again.unread])), guess=name)


def _in_its_language(again: Heard, heard: Heard) -> Heard:
    """What was heard behind an English name, without what its own language understood or did not lack."""
    if heard.words is None or heard.words.language == ENGLISH:
        return again
    said = {lack.what for lack in heard.lacks}
    return replace(
        again,
        unread=tuple([word for word in again.unread if word in heard.unread]),
        lacks=tuple([lack for lack in again.lacks if not lack.said or lack.what in said]),
    )


def _is_named(heard: Heard) -> bool:
    """Whether it is heard which garment is meant; what the network only takes for likely may be a guess."""
    claims = [w.change.claim for w in heard.sure if isinstance(w.change, Gain)]
    claims += [] if heard.words is None else [i.claim for i in heard.words.implications]
    return any(c.name == "kind" for c in claims) or (heard.kind is not None and bool(claims))


def _heard_description(text: str, reader: WishReader) -> Heard:
    typed = text
    whole = beside(reader.whole, typed, instruction=False)  # nine texts in ten are read as they are typed
    text, words = text_as_read(made_into_a_dress(without_side_remarks(without_asides(first_piece(text)))))
    own, before = text, words
    if own != typed and before.language == ENGLISH:
        whole = beside(reader.whole, own, instruction=False)
    if (plain := coats_by_length(plainly_wished(text))) != text:
        text, words = plain, read_words(plain)
    if words.language == ENGLISH and (dress := skirts_of_dresses(text, words)) != text:
        text, words = dress, read_words(dress)
    plainly = {i.claim for i in words.implications if i.said} - {i.claim for i in before.implications}
    network = reader.read(text, instruction=False) if words.language == ENGLISH else ()
    named = next((str(i.claim.value) for i in words.implications if i.claim.name == "kind"), None)
    measures = spoken_measures(text, named)
    hem = spoken_hem(text, named)
    sides = spoken_sides(text).beside(spoken_faces(text))
    words = without_spans(words, sides.spans)
    said = [m.claim for m in measures if m.claim is not None] + ([] if hem is None else [hem])
    said += [*sides.claims, *told_rises(text, named), *(bounds := spoken_bounds(text, words, named))]
    known = {claim.name for claim in said}
    levels = spoken_levels(text, words, named).beside(slit_levels(text, words, said))
    said += [claim for claim in levels.claims if claim.name not in known]
    slit = spoken_slit(text, words)
    if slit is not None and (named is None or fits_kind(slit.name, named)):
        said.append(slit)
    network = [w for w in network if not is_against_phrase(w, words) and can_measure(w.change)]
    against = against_names(words)
    refused = (*words.never, *_with_parts(words), *refused_frills(words), *against.values())
    refused = (*refused, *kinds_outgrown(words))
    never = tuple([claim for claim in refused if claim not in said and not hangs_so(claim, words)])
    never = (*never, *other_slits(text, [*said, *[i.claim for i in words.implications]]))
    refused_heads = refused_sleeve_heads(words)
    unsaid = (*never, *before.never, *against_phrases(words), *refused_heads, *closeness_refused(words))
    network = [w for w in network if not _is_measured(w, measures) and not _is_outdone(w, said, unsaid)]
    network = _within_names(network, words)
    found = explained(text, words, network) or united(text, words, network)
    stated = [Wish(Gain(claim), SURENESS["certain"]) for claim in said]
    found = (
        *stated,
        *[w for w in found if not _is_outdone(w, said, never) and w.change not in _changes(stated)],
    )
    if before.language == words.language == ENGLISH:
        alone = kind_named_alone(text, words)
        found = described_as_a_whole(
            found,
            whole(),
            stated=[
                *_changes(stated),
                *[
                    Gain(i.claim)
                    for i in words.implications
                    if i.mark.denied
                    or i.claim in plainly
                    or i.claim in against
                    or is_long_name(i)
                    or i in alone
                    or (i.said and is_of_places(Gain(i.claim)))
                ],
            ],
            named=[Gain(i.claim) for i in words.implications if not i.said],
            said=[Gain(i.claim) for i in words.implications if i.said],
            outdone=_outdone(words),
            never=unsaid,
            subjects=_only_subjects(words),
        )
    implied = [i.claim for i in words.implications if i.said or i.certainty == "certain"]
    found = [w for w in found if _is_implied(w, implied) or not _is_told_in_figures(w, said)]
    found = shapes_by_figures(found)
    found = within_the_name(without_wrong_kind(found, said, words), words, said)
    found = weighed_all(with_one_band(found, words), {i.claim for i in words.implications if not i.said})
    found = without_flared_legs(found, [e for m in words.marks if not m.denied for e in m.entries])
    found = (*without_deep_cuffs(text, words, without_flare(found)), *of_both_faces(text, found))
    found = with_named_sleeves(as_long_as_told(found, words), never, words)
    if words.language == ENGLISH:
        found = without_guesses(text, with_both_arms(text, found), words)
    found = of_the_only_arm(of_one_arm(without_guessed_length(found, words)))
    found = without_opposites(of_two_arms(found), words)
    found = without_told_shapes(text, with_told_leg_ends(fitting_the_name(found, words), words))
    changes = _changes(found)
    slits = sum(isinstance(c, Gain) and c.claim.name == "slit" for c in changes)
    heard = [m.mention for m in measures if m.claim or (not m.mention.is_length and m.mention.value <= slits)]
    counted = " ".join(
        [*words.sizes, f"{buttons_stated(text) or ''}", *[text[m.start : m.end] for m in heard]]
    )
    names = [m.words for m in measures if m.claim is not None]
    unknown = _unknown_elsewhere(words.unknown, text, names)
    unread = (
        *not_of_buttons(text, not_of_legs(text, unknown)),
        *[n for n in unread_numbers(text, changes) if n not in counted],
    )
    sure, likely = sure_wishes(found), likely_wishes(found)
    silent = unaccounted(
        words,
        _changes((*sure, *likely)),
        (*never, *refused_heads),
        [m.mention.end for m in measures],
        compared=hem is not None or bool(bounds),
        told=[
            *[*names, *sides.spans, *levels.spans, *spans_of_looks(text, words), *spans_of_big_buttons(text)],
            *spans_of_told_shapes(text, words, [c.claim.name for c in changes if isinstance(c, Gain)]),
        ],
    )
    unread, lacks = (*unread, *silent), lacks_of(words, changes, measures)
    return Heard(text, sure, likely, never, unread, lacks, words, clashes=clashing_levels(text, words, named))


def _unknown_elsewhere(unknown: Sequence[str], text: str, spans: Sequence[tuple[int, int]]) -> list[str]:
    """Words that stand anywhere but in what figures are said of."""
    inside = " ".join(text[start:end] for start, end in spans)
    found = {word: _starts(word, text) for word in set(unknown) if word in inside}
    within = {
        word
        for word, starts in found.items()
        if starts and all(any(start <= at < end for start, end in spans) for at in starts)
    }
    return [word for word in unknown if word not in within]


def _starts(word: str, text: str) -> list[int]:
    return [m.start() for m in re.finditer(rf"(?<!\w){re.escape(word)}(?!\w)", text)]


def _outdone(words: WordReading) -> list[Gain]:
    """What names usually stand for and a detail contradicts, and what words for fits speak against."""
    meant = {i.claim for i in words.implications}
    fits = [mark for mark in words.marks if mark.role == "word" and not mark.denied]
    against = [c for mark in fits for e in mark.entries if e.category == "fits" for c in e.against]
    marks = [mark for mark in words.marks if mark.role == "garment" and not mark.denied]
    usual = [each.claim for mark in marks for entry in mark.entries for each in entry.implied]
    return [Gain(claim) for claim in (*usual, *against) if claim not in meant]


def _only_subjects(words: WordReading) -> frozenset[str] | None:
    """What a text of few words is about, all of which are known; None of longer ones, which tell a story."""
    return None if words.unknown or len(words.marks) > _FEW_WORDS else subjects_spoken_of(words)


def _changes(wishes: Iterable[Wish]) -> list[Change]:
    return [wish.change for wish in wishes]


def _with_parts(words: WordReading) -> tuple[Claim, ...]:
    """What is refused by naming a part: a dress with sleeves is not sleeveless."""
    told = {i.claim.name for i in words.implications if i.said and i.claim != _BARE_SHOULDERS}
    told |= {i.claim.name for i in words.implications if i.said and i.certainty == "certain"}
    named = any(
        mark.entries and mark.entries[0].part == "sleeves" and not mark.denied and mark.role != "theirs"
        for mark in words.marks
        if mark.entries and mark.entries[0].category == "parts"
    )
    return (_BARE_ARMS,) if named and "sleeves" not in told and "shoulders" not in told else ()


def _within_names(network: Sequence[Wish], words: WordReading) -> list[Wish]:
    """What the network reads, no surer of what the name of a draft implies than the lexicon is.

    So the draft stays as it is named. Where all words are known, what no detail is about is no more than
    likely: that a tee has no sleeves, since so many captions of round necklines go on like this. What
    garments of the kind cannot have, as the bodice of "tailored trousers", is left out.
    """
    implied = [i for i in words.implications if not i.said]
    drafted = [i for i in implied if any(e.drafts and not e.is_mere_kind for e in i.mark.entries)]
    most = {i.claim: SURENESS[i.certainty] for i in drafted}
    told = {i.claim.name for i in words.implications} if most and not words.unknown else None
    kind = next((i.claim for i in implied if i.claim.name == "kind" and i.certainty == "certain"), None)
    spoken = None if words.unknown else subjects_spoken_of(words)
    named = [i.claim for i in implied]
    found = []
    for wish in network:
        claim = wish.change.claim if isinstance(wish.change, Gain) else None
        if claim is not None and kind is not None and kind.value in _LOWER_KINDS:
            if not fits_kind(claim.name, str(kind.value)):
                continue
        bound = 1.0 if claim is None else most.get(claim, 1.0)
        if claim is not None and spoken is not None and isinstance(claim.value, str):
            agreed = claim in named or (
                claim.name in SCALES
                and any(one.name == claim.name and not exclude(one, claim) for one in named)
            )
            if claim.name not in spoken and not agreed:
                if drafted:  # whose own shape is likelier
                    continue
                bound = SURENESS["likely"]
        if claim is not None and told is not None and claim.name not in told and isinstance(claim.value, str):
            bound = SURENESS["likely"]
        found.append(replace(wish, certainty=min(wish.certainty, bound)))
    return found


_BARE_ARMS = Claim("sleeves", "none")
_FEW_WORDS = 5
_LOWER_KINDS = frozenset({"skirt", "trousers", "shorts"})
_BARE_SHOULDERS = Claim("shoulders", "strapless")
"""Where a word makes this no more than usual, as a heart does, sleeves that are named cover them."""
_TOPICS = {
    "leg_width_cm": ("legs",),
    "sleeve_width_cm": ("sleeve_shape",),
    "neck_depth_cm": ("neck_depth",),
    "skirt_length_cm": ("skirt_hem",),
    "length_cm": ("skirt_hem", "top_hem"),
    "inseam_cm": ("leg_hem",),
}
"""What measures speak of in figures."""


def _is_outdone(wish: Wish, said: Sequence[Claim], never: Sequence[Claim]) -> bool:
    """Whether a wish is about what is stated in figures, or is refused, or says otherwise."""
    if not isinstance(wish.change, Gain):
        return False
    claim = wish.change.claim
    if claim in never or any(exclude(claim, other) for other in said):
        return True
    return _is_told_in_figures(wish, said) and wish.certainty < SURENESS["certain"]


def _is_told_in_figures(wish: Wish, said: Sequence[Claim]) -> bool:
    """Whether it says in words what figures say."""
    topics = {topic for other in said for topic in _TOPICS.get(other.name, ())}
    return isinstance(wish.change, Gain) and wish.change.claim.name in topics


def _is_implied(wish: Wish, implied: Sequence[Claim]) -> bool:
    return not isinstance(wish.change, Gain) or wish.change.claim in implied


def _is_measured(wish: Wish, measures: Sequence[SpokenMeasure]) -> bool:
    """Whether a number that the network reads is said of something else, or of the same thing."""
    claim = wish.change.claim if isinstance(wish.change, Gain) else None
    if claim is None or isinstance(claim.value, str):
        return False
    stated = {m.claim.name for m in measures if m.claim is not None}
    return claim.name in stated or any(same_number(measure, claim.value) for measure in measures)
