"""What is told of a garment: its report, what was done, what is doubtful."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from swifttailor.garment.garment import Garment
from swifttailor.pattern import Finding
from swifttailor.pattern.check import Change
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.order import one_line

if TYPE_CHECKING:
    from swifttailor.tailor.reading import Wanted

LONGEST_NOTE = 200
"""Letters of a text that a note says again."""
NOTHING_UNDERSTOOD = "Nothing measurable was understood from the text with certainty, so nothing was altered."


def order_report(answer: Answer, wanted: Wanted) -> dict[str, Any]:
    """What a report says of an order and how it was answered: JSON values."""
    from swifttailor.wording.wish_lines import wish_line

    written = answer.written
    writing = (
        {}
        if written is None
        else {
            "tokens": written.tokens,
            "log_likelihood": written.log_likelihood,
            "certainty": written.certainty,
        }
    )
    return {
        "order": wanted.order.to_json() | {"seed": answer.seed},
        "writing": writing
        | {
            "attempt": answer.attempt + 1,
            "failed_attempts": list(answer.failures),
        },
        "wishes": [
            {
                "wish": wish_line(w.change),
                "certainty": round(w.certainty, 3),
                "holds": w.change not in answer.verdict.open,
            }
            for w in wanted.wishes
        ],
        "alterations": {"of_the_pattern_to_edit": answer.of_edit, "cuts": list(answer.cuts)},
        "confidence": answer.confidence.to_json() if answer.confidence is not None else None,
    }


def order_notes(answer: Answer, wanted: Wanted) -> list[str]:
    """What was done for an order, for a person."""
    from swifttailor.wording.wish_lines import wish_line

    order, found = wanted.order, list(wanted.notes)
    if answer.failures:
        count = len(answer.failures) + 1
        found.append(f"{count} patterns were written; number {answer.attempt + 1} was taken.")
    if order.image is not None and answer.confidence is None:
        found.append(
            "Whether the picture shows a garment was not judged: these weights have no measure for that."
        )
    found += [f"Look at the pattern: {oddity}." for oddity in answer.verdict.oddities]
    if wanted.text != order.text:
        found.append(f"Read as: {one_line(wanted.text, LONGEST_NOTE)}")
    if order.alter and order.text.strip() and not wanted.wishes:
        found.append(NOTHING_UNDERSTOOD)
    if answer.cuts:
        found.append(f"Altered: {'; '.join(answer.cuts)}.")
    if answer.verdict.open:
        found.append(f"Requested but not met: {'; '.join(map(wish_line, answer.verdict.open))}.")
    return found


def order_warnings(answer: Answer) -> list[str]:
    """What of an order was not used or understood, or is doubtful."""
    return [*answer.doubts, *(() if answer.written is None else answer.written.notes)]


def finishing_notes(garment: Garment) -> list[str]:
    """What a person should know of how a garment was finished; nothing where it hung from where it was."""
    about = garment.report.get("finishing", {"from": "garment"})
    if about["from"] == "garment":
        return []
    return [f"Draped from the pattern: the sewn garment did not come to rest well ({about['reasons'][0]})."]


def finding_entry(finding: Finding) -> dict[str, Any]:
    """A finding for a report."""
    return {
        "code": finding.code,
        "severity": finding.severity.value,
        "where": finding.where(),
        "message": finding.message,
    }


def finding_line(finding: Finding) -> str:
    """A finding for a person."""
    place = f" ({finding.where()})" if finding.where() else ""
    return f"{finding.severity.value}: {finding.code}{place}: {finding.message}"


def change_line(change: Change) -> str:
    """What was mended, for a person."""
    place = f" ({change.where()})" if change.where() else ""
    return f"{change.code}{place}: {change.message}"
