"""From an order to patterns that can be sewn: written, checked, and written again where that finds faults."""

from __future__ import annotations

from collections.abc import Set
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np

from swifttailor.clock import Clock
from swifttailor.errors import InputError, PatternError, SwiftTailorError
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.pattern import Severity, check_pattern
from swifttailor.pattern_maker.asking.framing import Framing, frame_figure
from swifttailor.pattern_maker.asking.pictures import read_picture
from swifttailor.pattern_maker.maker import HIGHEST_TEMPERATURE, MOST_ATTEMPTS, Request
from swifttailor.tailor.order import Order
from swifttailor.tailor.sewing import Checked, Ready, SewingOptions, make_ready

if TYPE_CHECKING:
    from swifttailor.tailor.fitted import Fitted, FittingMaker


WARMER = 0.15
"""How much higher the temperature of each attempt is than that of the one before: the likely has failed."""


@dataclass(frozen=True, eq=False)
class WrittenPattern:
    """A pattern that can be sewn."""

    ready: Ready
    fitted: Fitted
    attempt: int
    """Which of the attempts it is, from 0."""
    failures: tuple[str, ...]
    """What is wrong with the attempts that were not taken, in order."""


@dataclass(frozen=True, eq=False)
class Asked:
    """An order as the network is asked."""

    request: Request
    notes: tuple[str, ...] = ()
    """What was done to it."""


@dataclass(frozen=True, eq=False)
class _Try:
    """One attempt."""

    fitted: Fitted
    fault: str
    """What is wrong with it."""
    ready: Ready | None = None
    """Where nothing is wrong but that it may not be all that was asked for."""


@dataclass(eq=False)
class _Sample:
    """One of the garments of an order, on its way."""

    seed: int
    tried: list[_Try] = field(default_factory=list)

    @property
    def found(self) -> bool:
        """Whether nothing is wrong with the last attempt."""
        return bool(self.tried) and not self.tried[-1].fault


def ask(order: Order) -> Asked:
    """Reads and frames the picture of an order.

    Raises:
        InputError: It cannot be read.
    """
    if order.image is None:
        return Asked(Request(order.text, None, order.edit))
    pixels = order.image if isinstance(order.image, np.ndarray) else read_picture(order.image)
    if not order.crop:
        return Asked(Request(order.text, pixels, order.edit))
    framed = frame_figure(pixels)
    return Asked(Request(order.text, framed.pixels, order.edit), tuple(_about_framing(framed.framing)))


def _about_framing(framing: Framing) -> list[str]:
    return {
        Framing.KEPT: [],
        Framing.CROPPED: ["The picture was cropped to what stands before its plain background."],
        Framing.BUSY: [
            "The background of the picture is not plain, so it was used whole; the network knows people and "
            "garments before plain backgrounds."
        ],
        Framing.EMPTY: ["Nothing stands out from the background of the picture; it was used whole."],
    }[framing]


def write_patterns(
    maker: FittingMaker, sewer: GarmentSewer, order: Order, request: Request, clock: Clock
) -> list[WrittenPattern | SwiftTailorError]:
    """Writes the patterns of an order, all samples together, until each is sound or had its attempts.

    Sound are those that can be sewn, of which a check doubts nothing but what it doubted of the pattern to
    edit before, and of which everything holds that was asked for.

    Args:
        maker: Writes and alters them.
        sewer: Says whether one can be sewn.
        order: What is wanted.
        request: The same as the network is asked (`ask`).
        clock: Takes the seconds of the stages.

    Raises:
        SwiftTailorError: The request cannot be answered at all.
    """
    if not 1 <= order.most_attempts <= MOST_ATTEMPTS:
        raise InputError(f"attempts is {order.most_attempts}; 1 to {MOST_ATTEMPTS} is accepted.")
    options = SewingOptions(order.edge_length, finish=order.finish)
    samples = [_Sample(order.seed + k) for k in range(order.samples)]
    tolerated = set() if request.edit is None else {f.code for f in check_pattern(request.edit)}
    for attempt in range(order.most_attempts):
        wanting = [s for s in samples if not s.found]
        if not wanting:
            break
        made = maker.generate_all(
            [request] * len(wanting),
            seed=[s.seed for s in wanting],
            temperature=min(order.temperature + WARMER * attempt, HIGHEST_TEMPERATURE),
            first_attempt=attempt,
        )
        clock.add(made[0].seconds)
        for sample, one in zip(wanting, made, strict=True):
            fault, ready = _first_fault(one, tolerated), None
            if not fault:
                try:
                    ready = _ready(sewer, one, order, options, clock)
                    fault = _not_so(one)
                except SwiftTailorError as error:
                    fault = str(error)
            sample.tried.append(_Try(one, fault, ready))
    return [_taken(sample, sewer, order, options, clock) for sample in samples]


def doubts(made: Fitted) -> list[str]:
    """What to tell a person of whose picture the network is not sure."""
    confidence = made.confidence
    if confidence is None or not confidence.doubtful:
        return []
    return [
        "The picture may show no garment, or one unlike any that the network knows: it is less sure of it "
        f"than of {1 - confidence.value:.1%} of the pictures that it was validated with (confidence "
        f"{confidence.value:.3f})."
    ]


def _first_fault(one: Fitted, tolerated: Set[str]) -> str:
    """The worst that a check finds, in words: any error, or a warning of a code that is not tolerated."""
    found = [f for f in one.findings if f.severity is Severity.ERROR]
    found = found or [f for f in one.findings if f.severity is Severity.WARNING and f.code not in tolerated]
    if not found:
        return "; ".join(oddities(one))
    place = f" ({found[0].where()})" if found[0].where() else ""
    more = f", and {len(found) - 1} more" if len(found) > 1 else ""
    return f"{found[0].code}{place}: {found[0].message}{more}"


def oddities(one: Fitted) -> list[str]:
    """What a check does not see, in words: what was never written."""
    found = ["it is not a garment that can be worn"] if one.senseless else []
    if one.holes:
        found.append("seams are open that ought to be sewn")
    if one.one_sided:
        found.append(f"{', '.join(one.one_sided)}: nothing like it on the other side")
    return found


def _not_so(one: Fitted) -> str:
    """What was asked for and does not hold, in words."""
    from swifttailor.wording.wish_lines import wish_line

    return f"asked for, and not so: {'; '.join(map(wish_line, one.open))}" if one.open else ""


def _ready(sewer: GarmentSewer, one: Fitted, order: Order, options: SewingOptions, clock: Clock) -> Ready:
    clock.restart()
    try:
        pattern = replace(one.pattern, name=order.title)
        return make_ready(sewer, Checked(pattern, one.findings, one.changes), options)
    finally:
        clock.stop("drawing")


def _taken(
    sample: _Sample, sewer: GarmentSewer, order: Order, options: SewingOptions, clock: Clock
) -> WrittenPattern | SwiftTailorError:
    """The sound pattern of a sample; where there is none the best of those that can be sewn."""
    places = range(len(sample.tried))
    best_first = sorted(places, key=lambda k: (sample.tried[k].ready is None, *sample.tried[k].fitted.rank))
    for taken in [places[-1]] if sample.found else best_first:
        ready = sample.tried[taken].ready
        try:
            ready = ready or _ready(sewer, sample.tried[taken].fitted, order, options, clock)
        except SwiftTailorError:
            continue
        failures = tuple(one.fault for k, one in enumerate(sample.tried) if k != taken)
        return WrittenPattern(ready, sample.tried[taken].fitted, taken, failures)
    best = sample.tried[best_first[0]]
    return _refusal(sample, best.fitted, best.fault)


def _refusal(sample: _Sample, best: Fitted, fault: str) -> PatternError:
    count, fault = len(sample.tried), fault.rstrip(".")
    said = f"None of the {count} patterns that were written can be sewn; the best has {fault}"
    if count == 1:
        said = f"The pattern that was written cannot be sewn: {fault}"
    hints = f"Try another seed than {sample.seed}, more attempts, or other words."
    return PatternError(" ".join([f"{said}.", *doubts(best), hints]))
