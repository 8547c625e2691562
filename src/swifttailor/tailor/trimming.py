"""Puts on a pattern what its text asks for and no panel is cut for: pockets, buttons, zips, belts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.garment.part_looks import has_part
from swifttailor.pattern import Pattern
from swifttailor.pattern.trims import LIKE_EACH_OTHER, trims_that_fit
from swifttailor.pattern.trims.front_view import is_closed_to_the_neck
from swifttailor.pattern.trims.names import CLOSES_FRONT, COUNTED
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.reading import facts_of
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.instructions.changes_of_garment import named_kind
from swifttailor.wishes.looks.heard_looks import look_refused
from swifttailor.wishes.looks.ribs import RIBBED
from swifttailor.wishes.looks.second_colors import second_where_it_fits
from swifttailor.wishes.trims.button_counts import buttons_stated, usual_buttons
from swifttailor.wishes.trims.trims_of import TRIMS_OF
from swifttailor.wishes.trims.trims_spoken_of import refused_trims
from swifttailor.wishes.trims.trims_wanted import WITHOUT_FLY, is_of_lace, trims_wanted
from swifttailor.wording.lexicon.look_words import MOTIF

_CLOSES_NECKS = ("polo placket", "half zip", "waist placket")
_CLOSED_BY_IT = ("open_front", "hooks")
"""What a front that is buttoned or zipped no longer lacks, where only a name means it."""


def trimmed(answer: Answer) -> Answer:
    """The answer with the trims that its text asks for and those that names of garments mean.

    What found a place is no longer lacking. A pattern to edit keeps its own, and of what its instruction
    speaks of only what it says is put on. What was trimmed already stays so.
    """
    wanted = answer.wanted
    if wanted is None or answer.put_on or answer.taken_off:
        return answer
    edit = wanted.order.edit
    facts = None if edit is None or not wanted.heard.lacks else facts_of(edit)
    kind = "" if facts is None else named_kind(facts)
    own = () if edit is None else edit.trims
    anew = edit is None
    trims, said, heard = _put_on(answer.pattern, wanted.heard, answer.draft, kind, own, anew=anew)
    before = answer.pattern.trims if edit is None else own
    count = _count(trims, wanted.heard.text, answer, own)
    counted = count != answer.pattern.button_count
    if trims == answer.pattern.trims and heard is wanted.heard and not counted:
        return answer
    put_on = tuple([name for name in trims if name not in before])
    taken_off = tuple([name for name in before if name not in trims])
    # Of an edit a stated number of buttons that were there already is what was put on.
    counts = tuple([name for name in trims if name in COUNTED and name in before]) if counted and edit else ()
    put_on = (*put_on, *counts)
    pattern = replace(answer.pattern, trims=trims, button_count=count)
    wanted = replace(wanted, heard=heard)
    meant = tuple([name for name in put_on if name not in said])
    return replace(answer, pattern=pattern, wanted=wanted, put_on=put_on, meant=meant, taken_off=taken_off)


def _count(trims: Sequence[str], text: str, answer: Answer, own: Sequence[str]) -> int:
    """How many buttons close the front: what the text states, what the pattern to edit has, what is usual."""
    if not any(name in COUNTED for name in trims):
        return 0
    edit = None if answer.wanted is None else answer.wanted.order.edit
    kept = edit is not None and any(name in own for name in trims if name in COUNTED)
    to_the_neck = is_closed_to_the_neck(answer.pattern)
    usual = (
        edit.button_count
        if edit is not None and kept
        else usual_buttons(answer.draft, to_the_neck=to_the_neck)
    )
    return buttons_stated(text) or ("buttons" in trims or kept) * usual


def with_looks_that_fit(answer: Answer) -> Answer:
    """The answer, where looks of parts that its pattern has not are said to be impossible."""
    wanted = answer.wanted
    if wanted is None or not wanted.heard.looks.looks:
        return answer
    heard = wanted.heard.looks
    heard = second_where_it_fits(heard, lambda part: has_part(answer.pattern, part))
    missing = [look for look in heard.looks if not has_part(answer.pattern, look.part)]
    if not missing and heard is wanted.heard.looks:
        return answer
    kept = tuple([look for look in heard.looks if look not in missing])
    missed = [
        look for look in missing if look.part in heard.said and look.part != MOTIF
    ]  # that is said anyway
    refused = [look_refused(look) for look in missed]
    looks = replace(heard, looks=kept, refused=(*heard.refused, *refused))
    return replace(answer, wanted=replace(wanted, heard=replace(wanted.heard, looks=looks)))


def _go_together(names: Sequence[str]) -> bool:
    """Whether no two of them are like each other."""
    return all(len(set(names).intersection(group)) <= 1 for group in LIKE_EACH_OTHER)


def _put_on(
    pattern: Pattern, heard: Heard, draft: str, kind: str, own: tuple[str, ...], *, anew: bool
) -> tuple[tuple[str, ...], set[str], Heard]:
    """The trims, those of them that the text says, and what it still lacks."""
    refused = refused_trims(heard)
    trims = [name for name in own if name not in refused]
    new: list[str] = []
    made = set()
    said = set[str]()
    for wish in sorted(trims_wanted(heard, draft, kind, anew=anew), key=lambda wish: not wish.said):
        has = any(name in trims for name in TRIMS_OF[wish.what])
        if has and not wish.named and wish.what != "pockets":
            made.add(wish.what)
            continue
        choices = wish.choices
        if not wish.said and not refused.isdisjoint(TRIMS_OF[wish.what]):  # no others in place of these
            choices = (tuple([name for name in choices[0] if name not in refused]),)
        for choice in choices:
            # What a text asks for takes the place of what is like it on a pattern to edit.
            if (
                refused.isdisjoint(choice)
                and _go_together([*(new if wish.said else trims), *choice])
                and set(trims_that_fit(pattern, choice)) == set(choice)
            ):
                trims = [name for name in trims if name in choice or _go_together([name, *choice])]
                trims += [name for name in choice if name not in trims]
                new += choice
                made.add(wish.what)
                said.update(choice if wish.said else ())
                break
        else:
            made |= {wish.what} if has and not wish.named else set()
    made |= {what for what, names in TRIMS_OF.items() if refused and refused.issuperset(names)}
    made |= set(RIBBED) if heard.ribs is not None else set()
    made |= {"lace"} if is_of_lace(heard) else set()
    closed = any(name in (*CLOSES_FRONT, *_CLOSES_NECKS) for name in trims)
    lacks = tuple(
        [
            lack
            for lack in heard.lacks
            if lack.what not in made
            and (lack.said or not (closed and lack.what in _CLOSED_BY_IT))
            and (lack.said or draft not in WITHOUT_FLY or lack.what != "zip")
        ]
    )
    return tuple(trims), said, heard if lacks == heard.lacks else replace(heard, lacks=lacks)
