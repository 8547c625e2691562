"""What was read of words and pictures as chips that a person can correct; sliders for what is measured."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from swifttailor.describing import Claim, GarmentFacts, claims_of
from swifttailor.describing.claims import CLAIM_TYPES
from swifttailor.describing.differences import QUANTITIES, Change, Gain
from swifttailor.pattern import Pattern
from swifttailor.pattern.trims import trims_that_fit
from swifttailor.pattern.trims.names import trim_said
from swifttailor.recutting.set_dimension import Span, dimension_spans
from swifttailor.studio.bench.claim_labels import claim_label, claim_unit, dimension_group
from swifttailor.tailor.order import one_line
from swifttailor.wishes.reader import Wish

if TYPE_CHECKING:
    from swifttailor.tailor.tailored import Tailored

MOST_CHIPS = 40
"""Of each list."""
EMPTY_READING: dict[str, Any] = {
    "made": [],
    "assumed": [],
    "cannot": [],
    "unknown": [],
    "shown": [],
    "language": None,
    "color": None,
    "fabric": None,
}


def change_chip(
    change: Change, *, certainty: float | None, source: str, holds: bool | None, spans: dict[str, Span]
) -> dict[str, Any]:
    """A chip for a wish.

    Args:
        change: What is wished for, or so.
        certainty: 0 to 1; None where it was measured.
        source: ``text``, ``picture`` or ``pattern``.
        holds: Whether it is so; None where that cannot be told.
        spans: Of the sliders of the garment, for numbers.
    """
    common = {"certainty": None if certainty is None else round(certainty, 3), "from": source, "holds": holds}
    if isinstance(change, Gain):
        claim, kind = change.claim, CLAIM_TYPES[change.claim.name]
        unit = claim_unit(claim.name)
        value = claim.value if isinstance(claim.value, str) else round(claim.value, 1)
        shown = value if isinstance(value, str) else f"{value:g}{' cm' if unit == 'cm' else ''}"
        label = claim_label(claim.name)
        return {
            "id": f"{claim.name}:{value}",
            "claim": claim.name,
            "dimension": None,
            "about": kind.about,
            "label": label,
            "value": value,
            "text": f"{label}: {shown}",
            "unit": unit,
            "choices": list(kind.words),
            "range": _range(kind.measure.name if kind.measure else "", spans),
        } | common
    quantity = QUANTITIES[change.quantity]
    how = "more" if change.direction > 0 else "less"
    by = "" if change.amount is None else f" by {change.amount:g}{' cm' if quantity.in_cm else ''}"
    return {
        "id": f"{change.quantity}:{change.direction}",
        "claim": None,
        "dimension": change.quantity,
        "about": quantity.about,
        "label": change.quantity,
        "value": None if change.amount is None else change.amount * change.direction,
        "text": f"{change.quantity}: {how}{by}",
        "unit": quantity.unit,
        "choices": [],
        "range": _range(change.quantity, spans),
    } | common


def change_line(change: Change) -> str:
    """A change that was made, as short as a chip: ``hem: mini``, ``length: −19.9 cm``."""
    if isinstance(change, Gain) or change.amount is None:
        return change_chip(change, certainty=None, source="pattern", holds=True, spans={})["text"]
    quantity, sign = QUANTITIES[change.quantity], "+" if change.direction > 0 else "\N{MINUS SIGN}"
    return f"{change.quantity}: {sign}{change.amount:g}{' cm' if quantity.in_cm else ''}"


def text_chip(text: str, *, list_name: str, number: int | str) -> dict[str, Any]:
    """A chip that cannot be corrected: words that were not understood, or what cannot be made."""
    shown = one_line(text, 120)
    return {
        "id": f"{list_name}:{number}",
        "claim": None,
        "dimension": None,
        "about": "",
        "label": shown,
        "value": None,
        "text": shown,
        "unit": "",
        "certainty": None,
        "from": "text",
        "holds": False if list_name == "cannot" else None,
        "choices": [],
        "range": None,
    }


def trim_chips(pattern: Pattern, names: Sequence[str], *, source: str) -> list[dict[str, Any]]:
    """Chips for pockets, buttons and the like that are put on a pattern; they `hold` where they find a place.

    Args:
        pattern: Names them among its trims.
        names: Of `TRIMS`.
        source: ``text`` or ``pattern``.
    """
    if not names:
        return []
    fit = trims_that_fit(pattern, names)
    about = "put on for the eye and the sewist: it holds no panels together"
    return [
        text_chip(trim_said(name, pattern.button_count), list_name="trim", number=name)
        | {"about": about, "from": source, "holds": name in fit}
        for name in names
    ]


def shown_chips(
    facts: GarmentFacts | None, said: Sequence[dict[str, Any]] = (), *, pattern: Pattern
) -> list[dict[str, Any]]:
    """What a pattern shows in words, besides what was said of it.

    Args:
        facts: Of the pattern; None where it cannot be measured.
        said: Chips that there are already.
        pattern: Names its trims.
    """
    spoken = {chip["claim"] for chip in said}
    claims = [] if facts is None else claims_of(facts)
    measured = [_measured(c) for c in claims if isinstance(c.value, str) and c.name not in spoken]
    known = {chip["id"] for chip in said}
    trims = [c for c in trim_chips(pattern, pattern.trims, source="pattern") if c["id"] not in known]
    return [*trims, *measured][:MOST_CHIPS]


def reading_of(made: Tailored, facts: GarmentFacts | None) -> dict[str, Any]:
    """The four lists of an order that was carried out, and what the pattern shows besides."""
    wanted, verdict = made.answer.wanted, made.answer.verdict
    if wanted is None:
        return EMPTY_READING | {"shown": shown_chips(facts, pattern=made.pattern)}
    heard = wanted.heard
    spans = {} if facts is None else dimension_spans(facts)

    def chip(wish: Wish, holds: bool) -> dict[str, Any]:
        source = "picture" if wanted.is_shown(wish) else "text"
        return change_chip(wish.change, certainty=wish.certainty, source=source, holds=holds, spans=spans)

    done = [chip(w, True) for w in wanted.wishes if w.change not in verdict.open]
    missed = [chip(w, False) for w in wanted.wishes if w.change in verdict.open]
    likely = [w for w in wanted.likely if facts is not None and w.change.holds(facts, facts)]
    assumed = [chip(w, True) for w in likely]
    put_on, meant = made.answer.put_on, made.answer.meant
    done += trim_chips(made.pattern, [name for name in put_on if name not in meant], source="text")
    assumed += trim_chips(made.pattern, meant, source="text")
    done += [text_chip(t, list_name="look", number=k) for k, t in enumerate(heard.looks.lines)]
    assumed += [text_chip(t, list_name="assumed", number=k) for k, t in enumerate(heard.looks.assumed)]
    texts = [*heard.cannot, *heard.left_out]
    cannot = [*missed, *(text_chip(t, list_name="cannot", number=k) for k, t in enumerate(texts))]
    unknown = [text_chip(t, list_name="unknown", number=k) for k, t in enumerate(heard.unread)]
    return {
        "made": _once(done),
        "assumed": _once(assumed),
        "cannot": _once(cannot),
        "unknown": _once(unknown),
        "shown": shown_chips(facts, [*done, *assumed, *missed], pattern=made.pattern),
        "language": None if heard.words is None else heard.words.language,
        "color": wanted.color,
        "fabric": heard.cloth,
    }


def sliders(facts: GarmentFacts | None) -> list[dict[str, Any]]:
    """The dimensions of a garment that can be moved."""
    if facts is None:
        return []
    return [
        {
            "name": name,
            "about": QUANTITIES[name].about,
            "unit": QUANTITIES[name].unit,
            "value": round(span.value, 2),
            "min": round(span.low, 2),
            "max": round(span.high, 2),
            "step": span.step,
            "group": dimension_group(name),
        }
        for name, span in dimension_spans(facts).items()
    ]


def _measured(claim: Claim) -> dict[str, Any]:
    return change_chip(Gain(claim), certainty=None, source="pattern", holds=True, spans={})


def _range(name: str, spans: dict[str, Span]) -> dict[str, float] | None:
    span = spans.get(name)
    return (
        None if span is None else {"min": round(span.low, 2), "max": round(span.high, 2), "step": span.step}
    )


def _once(chips: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """Each chip once."""
    return list({chip["id"]: chip for chip in chips}.values())[:MOST_CHIPS]
