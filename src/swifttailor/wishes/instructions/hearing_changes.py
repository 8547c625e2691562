"""How a text wants a garment to be changed, by words first and by the network where they leave some over."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, Step, subject_of
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.facts import GarmentFacts
from swifttailor.recutting.clearer import is_clear
from swifttailor.recutting.unasked import part_of
from swifttailor.wishes.corrections.one_arm import other_arm_kept
from swifttailor.wishes.corrections.one_slit import closed_alone
from swifttailor.wishes.corrections.sureness import likely_wishes, sure_wishes
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.instructions.change_words import (
    begins_with_change,
)
from swifttailor.wishes.instructions.changes_of_garment import (
    can_become,
    in_step_with_hems,
    in_usual_steps,
    made_where_lacking,
    named_kind,
    with_share,
    with_shares,
    with_slits_that_are,
    with_their_legs,
)
from swifttailor.wishes.instructions.described import with_their_names, without_described
from swifttailor.wishes.instructions.girth_targets import with_targets
from swifttailor.wishes.instructions.left_unread import (
    counts_elsewhere,
    not_answered,
    of_its_kind,
    other_garments,
)
from swifttailor.wishes.instructions.not_misspelt import with_plain_verbs
from swifttailor.wishes.instructions.one_meaning import in_one_meaning, still_in
from swifttailor.wishes.instructions.pointing_back import with_what_is_meant
from swifttailor.wishes.instructions.read_by_network import (
    by_network,
    is_chatter,
    is_named,
    is_read_otherwise,
    is_strange,
    still_unread,
)
from swifttailor.wishes.instructions.refusals import (
    compared_away,
    is_denied,
    is_moved_away,
    refused,
    without_gathers,
)
from swifttailor.wishes.instructions.said_plainly import (
    clear_changes,
    compared_plainly,
    is_all_plain,
    says_how_much,
    turned_round,
)
from swifttailor.wishes.instructions.sayings import plainly
from swifttailor.wishes.instructions.spoken_amounts import by_a_bit
from swifttailor.wishes.instructions.spoken_changes import SpokenChanges, spoken_changes
from swifttailor.wishes.instructions.spoken_clauses import other_than
from swifttailor.wishes.instructions.spoken_of import (
    HEM_CLAIMS,
    OF_LEGS,
    ONE_LEG,
    is_of_places,
    parts_spoken_of,
)
from swifttailor.wishes.instructions.spoken_targets import away
from swifttailor.wishes.instructions.stated_figures import (
    by_the_number,
    is_counted,
    is_stated,
    of_one_arm,
    to_the_number,
    to_the_word,
    without_steps_to,
    without_vague_depth,
)
from swifttailor.wishes.instructions.taken_back import without_taken_back
from swifttailor.wishes.instructions.to_for_too import with_too
from swifttailor.wishes.instructions.whole_instruction import (
    MEANT,
    go_together,
    is_disputed,
    uncertain,
    undisputed,
    with_the_whole,
    without_guesses,
)
from swifttailor.wishes.instructions.whole_of_kind import of_kind, with_hems_of_kind
from swifttailor.wishes.instructions.whole_sentences import is_letter, whole_of
from swifttailor.wishes.instructions.without_looks import without_looks
from swifttailor.wishes.reader import Wish, WishReader
from swifttailor.wishes.text.mentions import find_mentions
from swifttailor.wishes.text.spoken_measures import is_of_another, spoken_measures
from swifttailor.wishes.text.text_as_read import ENGLISH, lacks_of, text_as_read
from swifttailor.wishes.text.unread import says_nothing_else, unread_numbers
from swifttailor.wishes.trims.trims_spoken_of import speaks_of_trims_alone
from swifttailor.wording.claim_kinds import fits_kind
from swifttailor.wording.lexicon import SURENESS, WordMark, WordReading, exclude, glossed_change, read_words

SURE_IN_KNOWN_WORDS = 0.7
"""Enough for an edit whose words are all known ones for what was read: 147 of 162 such wishes
are meant (instructions between validation patterns, written as for the training)."""
SURE_BESIDE = 0.97
"""Enough in a clause of an instruction that words alone explain in part."""


_VAGUE = (Step("sleeve length", 1), Step("sleeve length", -1))
_ARMS = frozenset({"left_sleeve", "right_sleeve"})
_HIGH_SLIT, _SIDE_SLIT = Gain(Claim("slit_size", "high")), Gain(Claim("slit", "left"))
_NO_SLIT, _STRAPLESS = Claim("slit", "none"), Claim("shoulders", "strapless")
_OVERSIZED, _EASY = Claim("fit", "oversized"), Gain(Claim("fit", "easy"))


def hear_instruction(text: str, reader: WishReader, facts: GarmentFacts | None = None) -> Heard:
    """How a text wants a garment to be changed.

    How its parts are to look is heard first: that cuts nothing.

    Args:
        text: In English, or of another language that is read what the lexicon knows.
        reader: The network.
        facts: Of the garment; None where it cannot be measured.
    """
    text = with_too(with_plain_verbs(text), lambda claim: facts is not None and claim.holds(facts))
    text = glossed_change(with_what_is_meant(without_taken_back(text)))
    shown, words = text_as_read(text, None if facts is None else named_kind(facts))
    rest = without_looks(shown, words, facts)
    if rest == shown:
        return _heard_changes(text, reader, facts).with_looks(implied=False)
    if not rest:
        return Heard(shown, words=words).with_looks(implied=False)
    heard = _heard_changes(rest, reader, facts).with_looks(words, implied=False)
    return replace(heard, text=shown, rest=heard.text)


def _heard_changes(text: str, reader: WishReader, facts: GarmentFacts | None) -> Heard:
    """How a text wants a garment to be cut.

    Comparisons, details and removals are read by words (`spoken_changes`). Clauses in which these leave words
    over, the network reads; it is believed where it contradicts nothing that is said.
    """
    kind = None if facts is None else named_kind(facts)
    text, words = text_as_read(text, kind)

    def is_so(claim: Claim) -> bool:
        return facts is not None and claim.holds(facts)

    own = text
    plain = plainly(text, kind or "dress")
    by_saying = plain != text.lower()
    plain = in_one_meaning(plain, words.language)
    plain = plain if facts is None else with_targets(plain, kind or "dress", facts)
    named = with_their_names(plain.lower())
    shown = without_described(named, words if named == text.lower() else read_words(named, kind=kind), is_so)
    by_saying = by_saying or shown != plain.lower()
    plain = shown
    if plain != text.lower():
        text, words = plain, read_words(plain, kind=kind, language=still_in(words.language))
    spoken = spoken_changes(text, words, kind or "dress", is_so)
    put_plainly: list[Change] = []
    if by_saying:  # what somebody has written into a table is known better than guessed
        before = spoken_changes(own, text_as_read(own, kind)[1], kind or "dress", is_so).changes
        put_plainly = [c for c in clear_changes(spoken) if c not in before]
    if facts is not None:
        spoken = with_shares(text, spoken, facts)
    told = with_hems_of_kind(undisputed(spoken.changes, spoken.disputed, len(own.split())))
    stated = {}
    measures = spoken_measures(text, kind)
    for measure in measures:
        clause = next((c for c in spoken.clauses if c.start <= measure.mention.start < c.end), None)
        stepped = clause is not None and any(isinstance(c, Step) for c in clause.changes)
        if (
            measure.claim is not None
            and clause is not None
            and not stepped
            and not text[: measure.mention.start].rstrip().lower().endswith(" by")
            and not is_strange(clause, words)
            and not any(is_of_another(measure, change) for change in clause.changes)
        ):
            stated[clause.start] = measure
            told.append(Gain(measure.claim))
    told = without_steps_to(told if facts is None else by_the_number(told, facts))
    figures = [change for change in told if isinstance(change, Gain)]
    by_numbers = (
        [] if facts is None else to_the_number([Gain(m.claim) for m in stated.values() if m.claim], facts)
    )
    told = told if facts is None else to_the_number(told, facts)
    told = without_vague_depth(told if facts is None else [made_where_lacking(c, facts) for c in told])
    if facts is not None and _HIGH_SLIT in told and _NO_SLIT.holds(facts):
        told += [] if any(subject_of(change) == "slit" for change in told) else [_SIDE_SLIT]
    lengths = [m.value for m in find_mentions(text) if m.is_length]
    far = [] if facts is None else of_one_arm(told, lengths, facts)
    told = [change for change in told if change not in far]
    told += [] if facts is None else other_arm_kept(told, facts)
    covered = facts is not None and QUANTITIES["armholes"].of(facts) is None
    hidden = [c for c in told if covered and isinstance(c, Step) and c.quantity == "armholes"]
    told = [change for change in told if change not in hidden]  # nobody takes sleeves off for that
    sure = [Wish(change, SURENESS["certain"]) for change in told]
    said = tuple(told)
    likely: list[Wish] = []
    unread: list[str] = ["armholes (below sleeves they cannot be changed)"] if hidden else []
    unread += (
        ["one sleeve by so many cm (it is cut to an elbow, three-quarter or other length)"] if far else []
    )
    for clause in spoken.clauses:
        if not clause.left_over or clause.start in stated:
            continue
        if told and is_chatter(text, clause, words):
            unread += clause.left_over
            continue
        found = by_network(text, clause, reader, words, len(spoken.clauses) == 1)
        part = text[clause.start : clause.end]
        new = [w for w in found if _adds(w.change, told, spoken, words) and is_named(w.change, part)]
        new = [w for w in new if subject_of(w.change) not in spoken.disputed]
        if facts is not None:
            new = [w for w in new if isinstance(w.change, Step) or fits_kind(w.change.claim.name, kind or "")]
        if told and facts is not None:  # what is so already describes what is there
            new = [w for w in new if isinstance(w.change, Step) or not w.change.holds(facts, facts)]
        certain = [w for w in sure_wishes(tuple(new)) if not clause.changes or w.certainty >= SURE_BESIDE]
        plain = [w for w in likely_wishes(tuple(new)) if w.certainty >= SURE_IN_KNOWN_WORDS]
        if not clause.changes and plain and says_nothing_else(part, [w.change for w in (*certain, *plain)]):
            certain = [*certain, *plain]
        sure += certain
        told += [w.change for w in certain]
        likely += [w for w in likely_wishes(tuple(new)) if w not in certain]
        unread += still_unread(part, clause, certain, reader)
    never = refused(words)
    held = (
        [] if facts is None else [c for c in never if c.holds(facts) and c not in compared_away(text, words)]
    )
    others = other_than(never, held, [subject_of(change) for change in told])
    if _OVERSIZED in held and _EASY in others and is_moved_away(_EASY, told):
        others = tuple([g for g in others if g.claim.name != "fit"])
        sure.append(
            Wish(Gain(Claim("fit", "loose")), SURENESS["usual"] + 0.1)
        )  # "too baggy": less so at least
    sure += [Wish(g, SURENESS["usual"] + 0.1) for g in others if not is_moved_away(g, told)]
    said = (*said, *others, Gain(Claim("fit", "loose")))
    taken = spoken.taken
    unsure: tuple[Change, ...] = ()
    perhaps: tuple[Change, ...] = ()
    plain_words = speaks_of_trims_alone(words) or is_all_plain(text, spoken)
    if words.language == ENGLISH and not plain_words:
        whole, clear = whole_of(own, reader), clear_changes(spoken)
        whole = whole if facts is None or kind is None else of_kind(whole, kind, facts)
        firm = [change for _, some in taken for change in some] + put_plainly
        firm += [*compared_plainly(text, spoken), *turned_round(text, spoken, whole)]
        firm += [c for c in said if is_of_places(c) or (c in clear and says_how_much(own, c))]
        spoken_of = parts_spoken_of(own, kind)
        details = [Gain(i.claim) for i in words.implications if i.said]
        firm += [
            Gain(i.claim) for i in words.implications if i.said and i.mark.word.lower().endswith("length")
        ]
        firm += [*by_numbers, *[c for c in details if c in said and subject_of(c) == "slit_size"]]
        firm += [gain for gain in others if not is_read_otherwise(gain, whole)]
        firm += [c for c in clear if c in details and is_read_otherwise(c, whole)]
        names = [Gain(i.claim) for i in words.implications if not i.said and i.claim.name != "kind"]

        def is_said(change: Change) -> bool:
            if change in firm or change in details:
                return True
            if change not in said or change in names:
                return False
            if isinstance(change, Step) and begins_with_change(own):
                return True
            return (change in clear and not unread) or spoken_of.speaks_of(change)

        sure = [wish for wish in sure if not spoken_of.is_none_of(wish.change)]
        sure, alone = without_guesses(sure, whole, is_said)
        arms = any(subject_of(change) in _ARMS for change in firm)
        kinds = any(p >= MEANT for c, p in whole.items() if isinstance(c, Gain) and c.claim.name == "kind")
        if kinds or away(text.lower()):
            firm += [c for c in told if isinstance(c, Gain) and c.claim.name == "kind"]  # it knows no halves

        def accepts(change: Change, told: Sequence[Change]) -> bool:
            if arms and subject_of(change) in {"sleeves", *_ARMS}:
                return False
            if spoken_of.of_slits_alone and subject_of(change) in HEM_CLAIMS:
                return False  # a slit to the knee ends there, and no hem
            return (
                _adds(change, told, spoken, words)
                and not is_denied(change, never)
                and not is_disputed(change, spoken.disputed, whole, len(own.split()))
                and (facts is None or can_become(change, facts, clearly=spoken_of.speaks_of(change)))
            )

        before = [wish.change for wish in sure]
        sure, read = with_the_whole(
            sure,
            whole,
            left_over=bool(unread),
            accepts=accepts,
            holds=lambda change: (
                facts is not None
                and isinstance(change, Gain)
                and (
                    change.holds(facts, facts)
                    and not (spoken_of.speaks_of(change) and not is_clear(change, facts))
                )
            ),
            firm=firm,
            clear=clear if is_letter(own) else (),
        )
        guessed = [w for w in read if w.certainty < spoken_of.least(w.change)]
        sure = [wish for wish in sure if wish not in guessed]
        read = [wish for wish in read if wish not in guessed]
        taken = (*taken, (text.strip(), tuple(wish.change for wish in read))) if read else taken
        unsure, perhaps = uncertain(sure, read, whole, accepts, firm)
        parts = {part_of(subject_of(wish.change)) for wish in sure}
        guessed = [w for w in (*guessed, *alone) if part_of(subject_of(w.change)) not in parts]
        # What is said in so many words and let go all the same is told.
        let_go = [c for c in before if c in clear and c in details and part_of(subject_of(c)) not in parts]
        perhaps = tuple(dict.fromkeys([*perhaps, *[wish.change for wish in guessed], *let_go]))
    sure = sure if facts is None else closed_alone(sure, never, facts)
    slight = {
        change: by_a_bit(text[c.start : c.end].lower(), change)
        for c in spoken.clauses
        for change in c.changes
    }
    asked = [slight.get(wish.change, wish.change) for wish in sure]
    asked = in_step_with_hems(asked, lambda change: says_how_much(own, change))
    if facts is not None:
        asked = [in_usual_steps(with_share(own, change, facts), facts) for change in asked]
    sure = [replace(wish, change=change) for wish, change in zip(sure, asked, strict=True)]
    if facts is not None:
        legs = without_gathers([w.change for w in sure], held, facts)
        legs = with_their_legs(with_slits_that_are(legs, facts), facts)
        sure = [next((w for w in sure if w.change == c), Wish(c, SURENESS["certain"])) for c in legs]
        steps = to_the_word([w.change for w in sure], facts)
        sure = [w for w in sure if not steps or w.change not in _VAGUE] + [
            Wish(s, SURENESS["certain"]) for s in steps
        ]
    if one_leg := ONE_LEG.search(text):
        sure = [w for w in sure if subject_of(w.change) not in OF_LEGS]
        unsure, perhaps = (
            tuple([change for change in some if subject_of(change) not in OF_LEGS])
            for some in (unsure, perhaps)
        )
        unread.append(f"{one_leg[0]} (both legs are cut alike)")
    if far:  # nor are both cut instead
        sure = [w for w in sure if part_of(subject_of(w.change)) != "sleeves"]
    sure, unfit = of_its_kind(sure, kind)
    unread += unfit
    changes = [wish.change for wish in sure]
    unread += other_garments(text, words, kind, changes)
    unread += {m.word: None for m in words.marks if m.role == "astray" and not m.denied}
    unread += [
        n for n in unread_numbers(text, [*changes, *figures]) if not counts_elsewhere(n, text, changes)
    ]
    lacks = tuple([lack for lack in lacks_of(words, changes, measures) if lack.said])
    silent = tuple(dict.fromkeys(not_answered(unread, words)))
    return Heard(
        text,
        tuple(sure),
        tuple(likely),
        never,
        silent,
        lacks,
        words,
        clashes=spoken.clashes,
        kept=spoken.kept,
        taken=taken,
        unsure=unsure,
        perhaps=perhaps,
    )


def _adds(change: Change, told: Sequence[Change], spoken: SpokenChanges, words: WordReading) -> bool:
    """Whether something that the network reads is new, and contradicts nothing that is said."""
    subject = subject_of(change)
    if subject in spoken.kept or any(
        subject_of(other) == subject and not go_together(change, other) for other in told
    ):
        return False
    if is_stated(change, told) or is_counted(change, told):
        return False
    if isinstance(change, Gain):
        if change.claim == _STRAPLESS and any(_is_strap(mark) for mark in words.marks):
            return False
        if change.claim in words.never or change.claim.name == "kind":
            return change.claim.name == "kind" and not told and change.claim not in words.never
        return not any(isinstance(o, Gain) and exclude(change.claim, o.claim) for o in told)
    return True


def _is_strap(mark: WordMark) -> bool:
    """Whether straps are asked for, and not to go."""
    return mark.word.lower() in ("strap", "straps") and not mark.denied
