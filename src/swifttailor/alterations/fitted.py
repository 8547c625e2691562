"""A pattern maker whose patterns are altered until what the text asks for holds, as far as can be cut."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, replace

from swifttailor.alterations.alter import Alteration, alter
from swifttailor.alterations.one_sided import asks_for_one_side, one_sided_panels
from swifttailor.data.captions.facts import GarmentFacts
from swifttailor.data.captions.measure import measure_facts
from swifttailor.data.edits.differences import Change, Gain
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Finding, Pattern, Severity, check_pattern
from swifttailor.pattern.check.repair import Change as Mended
from swifttailor.pattern_maker.confidence import Confidence
from swifttailor.pattern_maker.maker import Generated, PatternMaker, Request
from swifttailor.pattern_maker.token_sequence import TokenSequence
from swifttailor.wishes.reader import Wish, WishReader

LEAST_CERTAINTY = 0.9
"""What the reader is less sure of is not cut: what the network wrote may be as right."""
_NONE = "none"
_SENSELESS, _UNSEWN, _ONE_SIDED = 3, 2, 2
"""What a garment of no kind, edges that lack what they are sewn to, and panels that lack their counterpart
count for, where an open wish or warning counts one."""


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
    altering_seconds: float = 0.0

    @property
    def changes(self) -> tuple[Mended, ...]:
        """What was mended of what the network wrote."""
        return () if self.recut else self.generated.changes

    @property
    def unsewn(self) -> int:
        """Edges that the network left without what they are sewn to."""
        return 0 if self.recut else self.generated.unsewn

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
        doubts = warnings + len(self.open) + _SENSELESS * self.senseless + _UNSEWN * (self.unsewn > 0)
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
        wishes = [self.wishes(request) for request in requests]
        best: list[Fitted | None] = [None] * len(requests)
        recuts: list[Recut | None] = [None] * len(requests)
        for attempt in range(first_attempt, first_attempt + attempts):
            wanting = [k for k, one in enumerate(best) if one is None or any(one.rank[:2])]
            if not wanting:
                break
            made = self.maker.generate_all(
                [requests[k] for k in wanting],
                seed=[seeds[k] for k in wanting],
                temperature=temperature,
                first_attempt=attempt,
            )
            for k, one in zip(wanting, made, strict=True):
                started = time.perf_counter()
                recuts[k] = recuts[k] or recut_edit(requests[k].edit, wishes[k])
                seconds = time.perf_counter() - started
                fitted, before = fit(one, wishes[k], requests[k].edit, recuts[k]), best[k]
                fitted = replace(fitted, altering_seconds=fitted.altering_seconds + seconds)
                best[k] = fitted if before is None or fitted.rank < before.rank else before
        fitted = [one for one in best if one is not None]
        altering = sum(one.altering_seconds for one in fitted)
        return [replace(one, altering_seconds=altering) for one in fitted]

    def wishes(self, request: Request) -> tuple[Wish, ...]:
        """What the text of a request asks for, as far as it is understood."""
        if self.reader is None:
            return ()
        return sure_wishes(self.reader.read(request.text, instruction=request.edit is not None))


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
    generated: Generated, wishes: Sequence[Wish], edit: Pattern | None = None, edited: Recut | None = None
) -> Fitted:
    """Alters a pattern to what was asked for; one that cannot be measured is left as it is, its wishes open.

    Args:
        generated: What the network wrote.
        wishes: What the text asks for.
        edit: The pattern to edit, if there is one.
        edited: What has come of altering that; it is altered when None.
    """
    started = time.perf_counter()
    changes = tuple(wish.change for wish in wishes)
    if not changes:
        lonely = _unasked(generated.pattern, changes, edit)
        return Fitted(generated, generated.pattern, generated.findings, one_sided=lonely)
    edited = edited or recut_edit(edit, wishes)
    original, recut = edited.original, edited.altered
    written = None
    remade = edit is not None and recut is not None and _is_remade(edit, recut)
    if recut is None or recut.open or remade:
        written = _altered(generated.pattern, changes, original)
    taken, of_edit = written, False
    if recut is not None and len(recut.open) < len(changes):
        # Of two that do as much, the one that leaves the rest as it was; but for another kind of garment.
        if written is None or len(recut.open) + remade <= len(written.open):
            taken, of_edit = recut, True
    seconds = time.perf_counter() - started
    pattern, findings = generated.pattern, tuple(generated.findings)
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
        one_sided=() if of_edit else _unasked(pattern, changes, edit),
        altering_seconds=seconds,
    )


def _unasked(pattern: Pattern, changes: Sequence[Change], edit: Pattern | None) -> tuple[str, ...]:
    """Panels without their counterpart, where no wish and no pattern to edit has sides that differ."""
    if asks_for_one_side(changes) or (edit is not None and one_sided_panels(edit)):
        return ()
    return one_sided_panels(pattern)


def _is_senseless(facts: GarmentFacts) -> bool:
    """Whether it is no kind of garment, or a waistband alone."""
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
