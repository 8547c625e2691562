"""A pattern maker whose patterns are altered until what the text asks for holds, as far as can be cut."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, replace

from swifttailor.describing.differences import Change, Gain
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Finding, Pattern, Severity, check_pattern
from swifttailor.pattern.check.repair import Change as Mended
from swifttailor.pattern_maker.asking.confidence import Confidence
from swifttailor.pattern_maker.maker import Generated, PatternMaker, Request
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.recutting.alter import Alteration, alter
from swifttailor.recutting.holes import has_holes
from swifttailor.recutting.level_hems import level_hem
from swifttailor.recutting.one_sided import (
    asks_for_one_side,
    is_of_one_side,
    made_of_one_side,
    one_sided_panels,
)
from swifttailor.wishes.own_words import in_own_words
from swifttailor.wishes.reader import Wish, WishReader
from swifttailor.wishes.spelling import put_right
from swifttailor.wishes.unsaid import leaves_hem_unsaid, unsaid_wishes

LEAST_CERTAINTY = 0.9
"""What the reader is less sure of is not asked for: what the network wrote may be as right."""
_NONE = "none"
_SENSELESS, _HOLES, _ONE_SIDED = 4, 3, 2
"""What a garment of no kind, open seams, and panels that lack their counterpart count for, where an open wish
or warning counts one."""
NARROWEST_SLEEVE_CM, NARROWEST_HEM_CM = 14.0, 60.0
"""No hand goes through less, and nobody walks in less; 16.6 cm around sleeves and 69.8 around skirts are the
least of GarmentCode's validation patterns."""
BARE_CM = 4.0
"""No skirt ends so far above the crotch; 0.5 cm is the highest of those."""


@dataclass(frozen=True, eq=False)
class Fitted:
    """A pattern, and what was done so that it is what was asked for."""

    generated: Generated
    """What the network wrote."""
    pattern: Pattern
    findings: tuple[Finding, ...]
    """What a check finds in it."""
    wishes: tuple[Wish, ...] = ()
    """What the text asks for, as far as it was understood."""
    open: tuple[Change, ...] = ()
    """Those that do not hold, or cannot be measured."""
    cuts: tuple[str, ...] = ()
    """What was altered, in words."""
    recut: bool = False
    """Whether it is the pattern to edit that was altered, and what the network wrote was left aside."""
    senseless: bool = False
    """Whether it is measured to be no kind of garment."""
    one_sided: tuple[str, ...] = ()
    """Panels without their counterpart on the other side, which nobody asked for."""
    holes: bool = False
    """Whether seams are open that no garment leaves open."""
    altering_seconds: float = 0.0

    @property
    def changes(self) -> tuple[Mended, ...]:
        """What was mended of what the network wrote."""
        return () if self.recut else self.generated.changes

    @property
    def sequence(self) -> TokenSequence:
        """What the network wrote."""
        return self.generated.sequence

    @property
    def log_likelihood(self) -> float:
        """Of what the network wrote."""
        return self.generated.log_likelihood

    @property
    def confidence(self) -> Confidence | None:
        """See `Generated`."""
        return self.generated.confidence

    @property
    def seconds(self) -> dict[str, float]:
        """By stage; requests that are answered together share theirs."""
        return self.generated.seconds | {"altering": round(self.altering_seconds, 4)}

    @property
    def rank(self) -> tuple[float, ...]:
        """Smaller is better: errors that a check finds; warnings, open wishes and the like; likelihood."""
        severities = [f.severity for f in self.findings]
        errors, warnings = (severities.count(s) for s in (Severity.ERROR, Severity.WARNING))
        doubts = warnings + len(self.open) + _SENSELESS * self.senseless + _HOLES * self.holes
        doubts += _ONE_SIDED * bool(self.one_sided)
        return errors, doubts, -self.log_likelihood


@dataclass(frozen=True, eq=False)
class FittingMaker:
    """Writes patterns as its pattern maker does, and alters them to what the texts ask for.

    Of an edit, the pattern to edit is altered first, since that leaves everything else exactly as it is. What
    the network writes is taken where more of the wishes hold of it, or none was understood.
    """

    maker: PatternMaker
    reader: WishReader | None
    """None where nothing is to be altered."""

    def generate_all(
        self,
        requests: Sequence[Request],
        *,
        seed: int | Sequence[int] = 0,
        temperature: float = 0.0,
        attempts: int = 1,
        first_attempt: int = 0,
    ) -> list[Fitted]:
        """Writes and alters a pattern for each request.

        Args:
            requests: See `PatternMaker.generate_all`.
            seed: See there.
            temperature: See there.
            attempts: Of each at most, until a check doubts nothing and all wishes hold; the best is taken.
            first_attempt: See there.

        Raises:
            SwiftTailorError: See there.
        """
        seeds = [seed] * len(requests) if isinstance(seed, int) else list(seed)
        if self.reader is not None:
            requests = [replace(request, text=put_right(request.text)) for request in requests]
        read = [self._read(request) for request in requests]
        best: list[Fitted | None] = [None] * len(requests)
        recuts: list[Recut | None] = [None] * len(requests)
        for attempt in range(first_attempt, first_attempt + attempts):
            wanting = [k for k, one in enumerate(best) if one is None or any(one.rank[:2])]
            if not wanting:
                break
            made = self.maker.generate_all(
                [_worded(requests[k], read[k], attempt) for k in wanting],
                seed=[seeds[k] for k in wanting],
                temperature=temperature,
                first_attempt=attempt,
            )
            for k, one in zip(wanting, made, strict=True):
                said, edit = read[k], requests[k].edit
                wishes, unsaid = sure_wishes(said), edit is None and requests[k].image is None
                started = time.perf_counter()
                recuts[k] = recuts[k] or recut_edit(edit, wishes)
                seconds = time.perf_counter() - started
                fitted = fit(
                    one,
                    wishes,
                    edit,
                    likely_wishes(said),
                    edited=recuts[k],
                    unsaid=unsaid and self.reader is not None,
                )
                fitted = replace(fitted, altering_seconds=fitted.altering_seconds + seconds)
                before = best[k]
                best[k] = fitted if before is None or fitted.rank < before.rank else before
        fitted = [one for one in best if one is not None]
        altering = sum(one.altering_seconds for one in fitted)
        return [replace(one, altering_seconds=altering) for one in fitted]

    def wishes(self, request: Request) -> tuple[Wish, ...]:
        """What the text of a request asks for, as far as it is understood."""
        return sure_wishes(self._read(replace(request, text=put_right(request.text))))

    def _read(self, request: Request) -> tuple[Wish, ...]:
        if self.reader is None:
            return ()
        return self.reader.read(request.text, instruction=request.edit is not None)


def _worded(request: Request, read: Sequence[Wish], attempt: int) -> Request:
    """The request as it is, and every second time in words that the network was taught."""
    if request.edit is not None or request.image is not None or attempt % 2 == 0:
        return request
    changes = [wish.change for wish in (*sure_wishes(read), *likely_wishes(read))]
    if asks_for_one_side(changes):
        return request  # easily mistaken for each other
    return replace(request, text=in_own_words(changes, attempt) or request.text)


def likely_wishes(found: Sequence[Wish]) -> tuple[Wish, ...]:
    """Wishes that are not sure, only likelier than not, where nothing else is read of the same thing.

    They are cut last, where that costs nothing that is asked for; left undone they are no fault.
    """
    spoken = [w.change.claim.name for w in found if isinstance(w.change, Gain)]
    likely = [
        w
        for w in found
        if w.certainty < LEAST_CERTAINTY
        and isinstance(w.change, Gain)
        and isinstance(w.change.claim.value, str)
    ]
    return tuple(w for w in likely if isinstance(w.change, Gain) and spoken.count(w.change.claim.name) == 1)


def sure_wishes(found: Sequence[Wish]) -> tuple[Wish, ...]:
    """Wishes that are certain enough to cut for, without those that contradict themselves.

    Who reads both that there is to be none of something and how it is to be has misunderstood.
    """
    values: dict[str, set[object]] = {}
    for wish in found:
        if isinstance(wish.change, Gain):
            values.setdefault(wish.change.claim.name, set()).add(wish.change.claim.value)
    confused = {name for name, said in values.items() if _NONE in said and len(said) > 1}
    return tuple(
        wish
        for wish in found
        if wish.certainty >= LEAST_CERTAINTY
        and not (isinstance(wish.change, Gain) and wish.change.claim.name in confused)
    )


@dataclass(frozen=True, eq=False)
class Recut:
    """A pattern to edit, altered to what was asked for; the same whatever the network writes."""

    original: GarmentFacts | None
    """What it showed; None where it cannot be measured, or there is none."""
    altered: Alteration | None


def recut_edit(edit: Pattern | None, wishes: Sequence[Wish]) -> Recut:
    """Alters the pattern to edit, if there is one."""
    if edit is None or not wishes:
        return Recut(None, None)
    original = _facts(edit)
    changes = tuple(wish.change for wish in wishes)
    return Recut(original, None if original is None else _altered(edit, changes, original))


def fit(
    generated: Generated,
    wishes: Sequence[Wish],
    edit: Pattern | None = None,
    likely: Sequence[Wish] = (),
    *,
    edited: Recut | None = None,
    unsaid: bool = False,
) -> Fitted:
    """Alters a pattern to what was asked for; one that cannot be measured is left as it is, its wishes open.

    Args:
        generated: What the network wrote.
        wishes: What the text asks for.
        edit: The pattern to edit, if there is one.
        likely: What it may ask for, to be done last, where that costs nothing else.
        edited: What has come of altering the pattern to edit; it is altered when None.
        unsaid: Whether the text is all that there is to go by, so that what it does not speak of is to be as
            usual: both sides alike, no hood, a level hem (`unsaid_wishes`).
    """
    started = time.perf_counter()
    changes = tuple(wish.change for wish in wishes)
    maybe = tuple(wish.change for wish in likely)
    pattern, findings = generated.pattern, tuple(generated.findings)
    if unsaid and not asks_for_one_side((*changes, *maybe)):
        pattern = made_of_one_side(pattern, generated.unsewn > 0)
        if pattern is not generated.pattern:
            findings = tuple(check_pattern(pattern))
    level = ""
    if unsaid and leaves_hem_unsaid((*changes, *maybe)):
        pattern, level = level_hem(pattern)  # what is lengthened next stays level
    if not changes and not unsaid:
        lonely, torn = _unasked(pattern, changes, edit), _is_torn(pattern, edit)
        return Fitted(generated, pattern, findings, one_sided=lonely, holes=torn)
    edited = edited or recut_edit(edit, wishes)
    original, recut = edited.original, edited.altered
    written = None
    remade = edit is not None and recut is not None and _is_remade(edit, recut)
    if recut is None or recut.open or remade:
        written = _altered(pattern, changes, original)
        if written is not None and unsaid:
            written = replace(written, cuts=(*filter(None, [level]), *written.cuts))
            written = _finished(written, changes, maybe)
    taken, of_edit = written, False
    if recut is not None and len(recut.open) < len(changes):
        # Of two that do as much, the one that leaves the rest as it was; but for another kind of garment.
        if written is None or len(recut.open) + remade <= len(written.open):
            taken, of_edit = recut, True
    seconds = time.perf_counter() - started
    if taken is not None and (taken.cuts or of_edit):
        pattern, findings = taken.pattern, tuple(check_pattern(taken.pattern))
    return Fitted(
        generated,
        pattern,
        findings,
        tuple(wishes),
        changes if taken is None else taken.open,
        () if taken is None else taken.cuts,
        of_edit,
        senseless=taken is not None and _is_senseless(taken.facts),
        one_sided=() if of_edit else _unasked(pattern, (*changes, *maybe), edit),
        holes=not of_edit and _is_torn(pattern, edit),
        altering_seconds=seconds,
    )


def _finished(altered: Alteration, changes: tuple[Change, ...], maybe: tuple[Change, ...]) -> Alteration:
    """Does what is likely meant and what goes without saying, where that costs nothing asked for."""
    said = (*changes, *maybe)
    maybe = tuple(wish for wish in maybe if not is_of_one_side(wish))  # easily mistaken for each other
    pattern, level = level_hem(altered.pattern) if leaves_hem_unsaid(said) else (altered.pattern, "")
    more = (*maybe, *unsaid_wishes(said, altered.facts))
    after = _altered(pattern, (*changes, *more), None)
    if after is None or not (after.cuts or level) or set(after.open) & set(changes) - set(altered.open):
        return altered
    if _is_senseless(after.facts) and not _is_senseless(altered.facts):
        return altered
    missing = tuple(wish for wish in after.open if wish in changes)
    return replace(
        after, open=missing, done=altered.done, cuts=(*altered.cuts, *filter(None, [level]), *after.cuts)
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


def _is_remade(edit: Pattern, recut: Alteration) -> bool:
    """Whether it has become another kind of garment, and not by what was taken off."""
    is_other = any(isinstance(c, Gain) and c.claim.name == "kind" for c in recut.done)
    return is_other and len(recut.pattern.panels) >= len(edit.panels)


def _facts(pattern: Pattern) -> GarmentFacts | None:
    try:
        return measure_facts(pattern)
    except SwiftTailorError:
        return None


def _altered(pattern: Pattern, changes: Sequence[Change], original: GarmentFacts | None) -> Alteration | None:
    """The pattern altered; None where it cannot be measured."""
    try:
        return alter(pattern, changes, original=original)
    except SwiftTailorError:
        return None
