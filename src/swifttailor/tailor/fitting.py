"""What the network wrote, altered until what the text asks for holds, as far as can be cut."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from swifttailor.describing.differences import Change, Gain
from swifttailor.describing.facts import GarmentFacts
from swifttailor.pattern import Pattern
from swifttailor.pattern.names import OF_DRAFTS
from swifttailor.pattern_maker.maker import WrittenPattern
from swifttailor.recutting.alter import Alteration
from swifttailor.recutting.holes import has_holes
from swifttailor.recutting.level_hems import level_hem
from swifttailor.recutting.one_sided import (
    asks_for_one_side,
    is_of_one_side,
    made_of_one_side,
    one_sided_panels,
)
from swifttailor.recutting.unasked import spoken_parts, unasked
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.candidates import Candidate
from swifttailor.tailor.reading import Wanted, altered, checked, facts_of
from swifttailor.tailor.sitting import sits_badly
from swifttailor.tailor.verdict import Verdict
from swifttailor.wishes.assumed.unsaid import leaves_hem_unsaid, unsaid_wishes
from swifttailor.wishes.assumed.well_within import as_stated, off_the_floor, well_within
from swifttailor.wishes.assumed.within_usual import beyond_usual, within_usual
from swifttailor.wishes.corrections.loose_wholes import loosened

NARROWEST_SLEEVE_CM, NARROWEST_HEM_CM = 14.0, 60.0
"""No hand goes through less, and nobody walks in less; 16.6 cm around sleeves and 69.8 around skirts are the
least of GarmentCode's validation patterns."""
SHORTEST_SKIRT_CM = 12.0
"""Below a dropped waist; what is shorter is a strip at the hem."""
BARE_CM = 4.0
"""No skirt ends so far above the crotch; 0.5 cm is the highest of those."""
_LONGER, _SHORTER = re.compile(r"hem ([\d.]+) cm longer"), re.compile(r"hem ([\d.]+) cm shorter")


def from_edit(wanted: Wanted) -> Answer | None:
    """The answer that the pattern to edit gives by itself; None where a writer may do better.

    It is left as it is where nothing is understood of how to change it, or where nothing can be cut and
    nobody could write it (`OF_DRAFTS`). Where cutting does some of what is asked for, that is the answer:
    everything else stays exactly as it was, and what is missing is said.
    """
    edit = wanted.order.edit
    if edit is None:
        return None
    if wanted.leaves_cut:
        return _as_it_is(edit, wanted)
    recut = wanted.recut
    if recut is not None and not recut.cuts and not recut.open:
        return _as_it_is(edit, wanted, open=())
    written = not any(OF_DRAFTS.fullmatch(panel.name) for panel in edit.panels)
    if (
        recut is None
        or len(recut.open) == len(wanted.wishes)
        or (written and _is_remade(edit, recut, wanted.original))
    ):
        return None if written else _as_it_is(edit, wanted)
    verdict = judged(recut, wanted)
    if verdict.unsound:
        return None if written else _as_it_is(edit, wanted)
    return Answer(recut.pattern, verdict, wanted=wanted, cuts=recut.cuts, of_edit=True)


def judged(recut: Alteration, wanted: Wanted) -> Verdict:
    """What is wrong with a recut pattern."""
    return Verdict(
        checked(recut.pattern, wanted.order.edit),
        wanted.tolerated,
        senseless=_is_senseless(recut.facts),
        open=recut.open,
        refused=_refused(recut.facts, wanted),
    )


def _as_it_is(
    edit: Pattern,
    wanted: Wanted,
    written: WrittenPattern | None = None,
    open: tuple[Change, ...] | None = None,
) -> Answer:
    missing = tuple(wish.change for wish in wanted.wishes) if open is None else open
    verdict = Verdict(checked(edit, edit), wanted.tolerated, open=missing)
    return Answer(edit, verdict, wanted=wanted, written=written, of_edit=True)


def fit(written: WrittenPattern, wanted: Wanted, *, drafted: bool = False) -> Answer:
    """Alters a pattern to what is wanted and judges it; whether it can be sewn is left open.

    One that cannot be measured is left as it is, its wishes open. Of an edit, the pattern to edit is altered,
    since that leaves everything else exactly as it is. What the network wrote is taken where more of the
    wishes hold of it; where none does of either, the pattern to edit stays as it is.

    Args:
        written: The pattern.
        wanted: What is wanted.
        drafted: Whether it is a draft that the words name: what nobody speaks of is as that shows it.
    """
    edit, unsaid = wanted.order.edit, wanted.unsaid and not drafted
    changes = tuple(wish.change for wish in wanted.wishes)
    maybe = wanted.maybe
    pattern, level = written.pattern, ""
    if unsaid and not asks_for_one_side((*changes, *maybe)):
        pattern = made_of_one_side(pattern, written.unsewn > 0)
    findings = written.findings if pattern is written.pattern else None
    if unsaid and leaves_hem_unsaid((*changes, *maybe)):
        pattern, level = level_hem(pattern, below_waist=True)  # what is lengthened next stays level
    alters = bool(changes) or wanted.unsaid or wanted.part is not None
    taken, of_edit = _best_alteration(pattern, level, wanted, unsaid=unsaid) if alters else (None, False)
    if edit is not None and changes and not of_edit and (taken is None or set(taken.open) == set(changes)):
        return _as_it_is(edit, wanted, written)
    if taken is not None and (taken.cuts or of_edit):
        pattern, findings = taken.pattern, None
    verdict = Verdict(
        checked(pattern, edit) if findings is None else tuple(findings),
        wanted.tolerated,
        senseless=taken is not None and _is_senseless(taken.facts),
        sits_badly=()
        if taken is None or not wanted.unsaid
        else sits_badly(taken.facts, (*changes, *maybe), cloth_stretch=pattern.cloth_stretch),
        beyond_usual=() if taken is None or not unsaid else beyond_usual((*changes, *maybe), taken.facts),
        holes=not of_edit and _is_torn(pattern, edit),
        one_sided=() if of_edit else _unasked(pattern, (*changes, *maybe) if alters else (), edit),
        open=changes if taken is None else (*taken.open, *_unseen(taken, changes)),
        seen=tuple(wish.change for wish in wanted.seen),
        refused=() if taken is None else _refused(taken.facts, wanted),
    )
    return Answer(
        pattern,
        verdict,
        () if of_edit else tuple(written.changes),
        wanted=wanted,
        written=written,
        cuts=() if taken is None else taken.cuts,
        of_edit=of_edit,
    )


def cut_from(candidate: Candidate, wanted: Wanted, seed: int) -> Answer:
    """A candidate altered to what is wanted, and judged; see `fit`."""
    answer = fit(candidate.written, wanted if candidate.design is None else wanted.of_draft())
    return replace(answer, seed=seed, known=candidate.known, design=candidate.design)


def _best_alteration(
    pattern: Pattern, level: str, wanted: Wanted, *, unsaid: bool
) -> tuple[Alteration | None, bool]:
    """What is altered, None where nothing can be measured; and whether it is the pattern to edit."""
    edit, recut = wanted.order.edit, wanted.recut
    changes = tuple(wish.change for wish in wanted.wishes)
    remade = edit is not None and recut is not None and _is_remade(edit, recut, wanted.original)
    written = None
    if recut is None or recut.open or remade:
        written = altered(pattern, changes, wanted.original)
        if written is not None and edit is not None and _changes_others(written, wanted):
            written = None
        if written is not None and (wanted.unsaid or wanted.part is not None):
            written = replace(written, cuts=(*filter(None, [level]), *written.cuts))
            described = wanted.unsaid
            written = _finished(written, changes, wanted.maybe, unsaid=unsaid, described=described)
            said = (*changes, *wanted.maybe)
            written = _levelled(written, said, pattern, unsaid=unsaid, described=described)
    # Of two that do as much, the one that leaves the rest as it was; but for another kind of garment.
    if recut is not None and (written is None or len(recut.open) + remade <= len(written.open)):
        return recut, True
    return written, False


def _finished(
    before: Alteration,
    changes: tuple[Change, ...],
    maybe: tuple[Change, ...],
    *,
    unsaid: bool,
    described: bool,
) -> Alteration:
    """Does what is likely meant and what goes without saying, where that costs nothing asked for."""
    said = (*changes, *maybe)
    maybe = tuple(wish for wish in maybe if not is_of_one_side(wish))  # easily mistaken for each other
    level = unsaid and leaves_hem_unsaid(said)
    pattern, level = level_hem(before.pattern, below_waist=True) if level else (before.pattern, "")
    more = (*maybe, *(unsaid_wishes(said, before.facts) if unsaid else ()))
    if unsaid:
        more = (*more, *well_within((*said, *more), before.facts), *within_usual(said, before.facts))
        more = (*more, *loosened(said, before.facts))
    asked = (*said, *more)
    if described and not unsaid:
        more = (*more, *well_within(said, before.facts))
    after = altered(pattern, (*changes, *more))
    if not _costs_nothing(after, before, changes):
        # One of them spoils it: as many as can be had, one after the other.
        after = None
        for one in more:
            next_to = altered(pattern if after is None else after.pattern, (*changes, one))
            if next_to is not None and next_to.cuts and _costs_nothing(next_to, before, changes):
                cuts = () if after is None else after.cuts
                after = replace(next_to, cuts=(*cuts, *next_to.cuts))
    done = before
    if after is not None and (after.cuts or level):
        missing = tuple(wish for wish in after.open if wish in changes)
        cuts = (*before.cuts, *filter(None, [level]), *after.cuts)
        done = replace(after, open=missing, done=before.done, cuts=cuts)
    return _walked_in(done, changes, asked) if described else done


def _walked_in(before: Alteration, changes: tuple[Change, ...], said: tuple[Change, ...]) -> Alteration:
    """Made as long as was stated, and gowns to clear the floor, where that costs nothing asked for."""
    steps = (*off_the_floor(said, before.facts), *as_stated(said, before.facts))
    after = altered(before.pattern, (*changes, *steps)) if steps else None
    if after is None or not after.cuts or not _costs_nothing(after, before, changes):
        return before
    return replace(after, open=before.open, done=before.done, cuts=_added_up([*before.cuts, *after.cuts]))


def _added_up(cuts: list[str]) -> tuple[str, ...]:
    """Lengthening that is partly taken back as one: "hem 14.4 cm longer", "hem 5.5 cm shorter"."""
    longer = next((k for k, cut in enumerate(cuts) if _LONGER.fullmatch(cut)), None)
    shorter = _SHORTER.fullmatch(cuts[-1])
    if longer is None or shorter is None:
        return tuple(cuts)
    by = float(cuts[longer].split()[1]) - float(shorter[1])
    whole = f"hem {abs(by):.1f} cm {'longer' if by > 0 else 'shorter'}"
    return (*cuts[:longer], whole, *cuts[longer + 1 : -1])


def _costs_nothing(after: Alteration | None, before: Alteration, changes: tuple[Change, ...]) -> bool:
    """Whether what was asked for still holds."""
    if after is None or set(after.open) & set(changes) - set(before.open):
        return False
    return not _is_senseless(after.facts) or _is_senseless(before.facts)


def _levelled(
    taken: Alteration, said: Sequence[Change], before: Pattern, *, unsaid: bool, described: bool
) -> Alteration:
    """Makes a hem level that cutting has made uneven, or that is, where that costs nothing asked for."""
    if not (taken.cuts or unsaid) or not leaves_hem_unsaid(said):
        return taken
    if not unsaid and level_hem(before, below_waist=described)[1]:
        return taken  # a draft whose hem is meant to be as it is
    pattern, level = level_hem(taken.pattern, below_waist=described)
    facts = facts_of(pattern) if level else None
    kept = [wish for wish in said if isinstance(wish, Gain) and wish.holds(taken.facts, taken.facts)]
    if facts is None or not all(wish.holds(facts, facts) for wish in kept):
        return taken
    return replace(taken, pattern=pattern, facts=facts, cuts=(*taken.cuts, level))


def _refused(facts: GarmentFacts, wanted: Wanted) -> tuple[Gain, ...]:
    return tuple(gain for gain in map(Gain, wanted.heard.never) if gain.holds(facts, facts))


def _unseen(taken: Alteration, changes: Sequence[Change]) -> tuple[Change, ...]:
    """What is asked of the skirt of a dress and true of a strip at its hem alone, where nobody sees it."""
    skirt = taken.facts.skirt
    if taken.facts.kind != "dress" or skirt is None or skirt.length >= SHORTEST_SKIRT_CM:
        return ()
    return tuple(
        [c for c in changes if isinstance(c, Gain) and c.claim.name == "skirt" and c not in taken.open]
    )


def _unasked(pattern: Pattern, changes: Sequence[Change], edit: Pattern | None) -> tuple[str, ...]:
    """Panels without their counterpart, where no wish and no pattern to edit has sides that differ."""
    if asks_for_one_side(changes) or (edit is not None and one_sided_panels(edit)):
        return ()
    return one_sided_panels(pattern)


def _is_torn(pattern: Pattern, edit: Pattern | None) -> bool:
    """Whether it has holes that the pattern to edit had not."""
    return has_holes(pattern) and (edit is None or not has_holes(edit))


def _is_senseless(facts: GarmentFacts) -> bool:
    """Whether it is no kind of garment, a waistband alone, or has sleeves that no arm goes through."""
    sleeves = [sleeve for sleeve in (facts.left_sleeve, facts.right_sleeve) if sleeve]
    if any(sleeve.length <= 0 or sleeve.opening < NARROWEST_SLEEVE_CM for sleeve in sleeves):
        return True  # without length: sewn to something else than an armhole all around
    if facts.kind in ("skirt", "dress") and facts.hem and facts.hem.length < NARROWEST_HEM_CM:
        return True
    if facts.kind == "skirt" and facts.hem and facts.hem.level > facts.body.crotch + BARE_CM:
        return True
    return facts.kind == "other" or not (facts.torso or facts.skirt or facts.trousers)


def _changes_others(written: Alteration, wanted: Wanted) -> bool:
    """Whether what was written in place of the pattern to edit changes what nobody spoke of."""
    if wanted.original is None:
        return False
    parts = spoken_parts([wish.change for wish in wanted.wishes])
    return bool(unasked(parts, wanted.original, written.facts, wanted.heard.kept))


def _is_remade(edit: Pattern, recut: Alteration, before: GarmentFacts | None) -> bool:
    """Whether it has become another kind, and not by what was taken off, nor by legs sewn to its bodice."""
    if before is not None and before.torso and recut.facts.torso and recut.facts.trousers:
        return False
    is_other = any(isinstance(c, Gain) and c.claim.name == "kind" for c in recut.done)
    return is_other and len(recut.pattern.panels) >= len(edit.panels)
