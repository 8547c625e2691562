"""What is told of a garment: its report, what was done, what is doubtful."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from swifttailor.clock import DIGITS, Clock
from swifttailor.garment.cloth_color import COLOR
from swifttailor.garment.cloth_print import PRINT
from swifttailor.garment.garment import Garment
from swifttailor.garment.part_looks import LOOKS
from swifttailor.garment_sewer.crumpling import CRUMPLED
from swifttailor.pattern.check import Change as Mending
from swifttailor.pattern.drafts.draft_names import STANDS_IN
from swifttailor.pattern.trims.names import TRIMS, trim_said
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.fabric_asked import fabric_unmet, fabric_warning
from swifttailor.tailor.heard_notes import heard_notes, heard_report
from swifttailor.tailor.order import Order, one_line
from swifttailor.tailor.picture_color import color_line, color_report
from swifttailor.tailor.picture_print import print_line, print_report
from swifttailor.tailor.provenance import versions, weights

if TYPE_CHECKING:
    from swifttailor.body import Body
    from swifttailor.describing.differences import Change
    from swifttailor.tailor.reading import Wanted
    from swifttailor.tailor.tailor import Tailor
    from swifttailor.tailor.tailored import Tailored
    from swifttailor.wishes.reader import Wish

LONGEST_NOTE = 200
"""Letters of a text that a note says again."""
NOTHING_UNDERSTOOD = "Nothing measurable was understood from the text with certainty, so nothing was altered."
ONE_OF_TWO = (
    "The text asks for two garments, and this is a single one of the whole text: Tailor.generate_all makes "
    "both, and part='upper' or part='lower' one of them."
)
AS_IT_WAS = (
    "Nothing was understood of what to change, so the pattern is the one that was given. Lengths, widths, "
    "necklines, sleeves, collars, hoods, waistbands, slits and tiers can be changed (docs/edits.md)."
)


def described(sewn: Tailored, tailor: Tailor, clock: Clock | None) -> Tailored:
    """A garment with all that is known of it in its report, its notes and its warnings.

    Args:
        sewn: As the sewer made it.
        tailor: Who made it.
        clock: The seconds of what was done for all garments of an order together.
    """
    answer, garment = sewn.answer, sewn.garment
    wanted = answer.wanted
    seconds = ({} if clock is None else clock.seconds) | garment.report["seconds"]
    facts: dict[str, Any] = {} if wanted is None else order_report(answer, wanted)
    notes = [] if wanted is None else order_notes(answer, wanted)
    notes += finishing_notes(garment)
    report = garment.report | {
        "seconds": {name: round(value, DIGITS) for name, value in seconds.items()},
        **facts,
        "findings": [f.entry() for f in sewn.findings],
        "versions": versions(),
        "weights": weights(
            pattern_maker=tailor.pattern_maker if answer.is_written else None,
            pattern_library=tailor.pattern_library if answer.known else None,
            parameter_reader=tailor.parameter_reader if _read_design(answer) else None,
            wish_reader=tailor.wish_reader if wanted is not None and wanted.said else None,
            picture_reader=tailor.picture_reader if wanted is not None and wanted.pictures else None,
            garment_sewer=tailor.garment_sewer,
        ),
    }
    if garment.color is not None:
        report[COLOR] = garment.color
    if garment.print is not None:
        report[PRINT] = garment.print.to_json()
    if garment.looks:
        report[LOOKS] = [look.to_json() for look in garment.looks]
    if tailor.body is not None:
        report["body"] = tailor.body.name
        if answer.fitted_to:
            report["fitted_to"] = fitted_report(tailor.body)
            notes.append(fitted_note(tailor.body))
    if sewn.changes:
        report["mended"] = [change_line(c) for c in sewn.changes]
    warnings = order_warnings(answer)
    if wanted is not None:
        report["warnings"] = warnings
    if wanted is not None or notes:
        report["notes"] = notes
    garment = replace(garment, report=report)
    return replace(sewn, garment=garment, notes=tuple(notes), warnings=tuple(warnings))


def _read_design(answer: Answer) -> bool:
    """Whether the network read the design parameters; of skirts of so many gores they follow from words."""
    wanted = answer.wanted
    asked = wanted is not None and (wanted.part is not None or wanted.order.source == "designs")
    return answer.design is not None and asked


def fitted_report(body: Body) -> dict[str, Any]:
    """Whom a pattern was refitted to: JSON values, cm."""
    m = body.measurements
    main = {name: round(getattr(m, name), 1) for name in ("height", "bust", "waist", "hips")}
    return {"name": body.name, "measures": main}


def fitted_note(body: Body) -> str:
    """The same for a person."""
    measures = fitted_report(body)["measures"]
    shown = ", ".join(f"{name} {value:g}" for name, value in measures.items())
    return f"Refitted to {body.name} ({shown} cm)."


def order_report(answer: Answer, wanted: Wanted) -> dict[str, Any]:
    """What a report says of an order and how it was answered: JSON values."""
    from swifttailor.parameter_reader.which_matter import matters
    from swifttailor.programs import complete_design
    from swifttailor.wording.wish_lines import wish_line

    written = answer.written
    writing: dict[str, Any] = {}
    if answer.known:
        writing = {"source": "library", "known_pattern": answer.known}
        if answer.anew:
            writing["made_anew"] = answer.anew
    elif answer.design is not None:
        design = complete_design(answer.design)
        writing = {"source": "design", "design": {name: design[name] for name in sorted(matters(design))}}
    elif answer.draft:
        writing = {"source": "draft", "draft": answer.draft}
    elif written is not None:
        writing = {
            "source": "writer",
            "tokens": written.tokens,
            "log_likelihood": written.log_likelihood,
            "certainty": written.certainty,
        }
    return {
        "order": wanted.order.to_json() | {"seed": answer.seed},
        "writing": writing
        | {
            "attempt": answer.attempt + 1,
            "failed_attempts": list(answer.failures),
            **({} if answer.refinement is None else {"refinement": vars(answer.refinement)}),
        },
        "wishes": [
            {
                "wish": wish_line(w.change),
                "certainty": round(w.certainty, 3),
                "from": "picture" if wanted.is_shown(w) else "text",
                "holds": w.change not in answer.verdict.open,
            }
            for w in wanted.wishes
        ],
        **({"pictures": _pictures(wanted)} if wanted.pictures else {}),
        "heard": heard_report(wanted),
        "not_understood": list(wanted.heard.unread),
        "said_and_not_so": {word: wish_line(change) for word, change in answer.not_so},
        "changed_unasked": [wish_line(change) for change in answer.unasked],
        "trims": list(answer.pattern.trims),
        **({"button_count": answer.pattern.button_count} if answer.pattern.button_count else {}),
        "alterations": {"of_the_pattern_to_edit": answer.of_edit, "cuts": list(answer.cuts)}
        | ({} if answer.seen is None else {"changes": [wish_line(change) for change in answer.seen]}),
        "confidence": answer.confidence.to_json() if answer.confidence is not None else None,
    }


def _pictures(wanted: Wanted) -> dict[str, Any]:
    """What was read of pictures, and what came of it."""
    from swifttailor.wording.wish_lines import wish_line

    def lines(wishes: Sequence[Wish]) -> list[dict[str, Any]]:
        return [{"wish": wish_line(w.change), "certainty": round(w.certainty, 3)} for w in wishes]

    return {
        "read": [{"name": one.name} | one.reading.to_json() for one in wanted.pictures],
        "part": None if (part := wanted.part or wanted.in_words) is None else part.part,
        "color": None if wanted.seen_color is None else color_report(wanted.seen_color),
        **({} if wanted.seen_print is None else {"print": print_report(wanted.seen_print)}),
        "likely": lines([w for w in wanted.likely if w in wanted.seen]),
        "overruled_by_text": lines(wanted.overruled),
    }


def order_notes(answer: Answer, wanted: Wanted) -> list[str]:
    """What was done for an order, for a person."""
    from swifttailor.wording.wish_lines import wish_line

    order = wanted.order
    # How the picture was framed for PatternMaker is of no interest where that wrote nothing.
    found = [] if answer.found and wanted.part is not None else list(wanted.notes)
    if answer.failures:
        count = len(answer.failures) + 1
        found.append(f"{count} patterns were tried; number {answer.attempt + 1} was taken.")
    if answer.refinement is not None:
        again = answer.refinement
        found.append(
            f"{again.compared} garments were compared with the picture; the one that was taken lies "
            f"{again.distance_cm:.1f} cm from it on average."
        )
    if answer.known:
        found.append(f"Cut from a known pattern: {answer.known}.")
    if answer.design is not None:
        found.append(
            "Drafted by GarmentCode's programs from design parameters"
            f"{' that were read' if _read_design(answer) else ''}; see report.json."
        )
    if answer.draft:
        found.append(f"Begun from a draft of ours: {answer.draft}.")
        if answer.draft in STANDS_IN:
            found.append(STANDS_IN[answer.draft])
    if answer.pattern.cloth_stretch:
        found.append(
            f"Cut smaller than the body, for cloth that stretches by {answer.pattern.cloth_stretch:.0%} "
            "or more."
        )
    found += trim_notes(answer)
    if wanted.part is not None:
        found.append(_read_line(wanted))
    if wanted.seen_print is not None:
        found.append(f"Seen in the picture: {print_line(wanted.seen_print)}.")
    elif wanted.seen_color is not None:
        found.append(f"Seen in the picture: {color_line(wanted.seen_color)}.")
    if answer.not_followed:
        said = "; ".join(wish_line(w.change) for w in answer.not_followed)
        found.append(f"The rest of the picture spoke against this, and the draft has it otherwise: {said}.")
    if wanted.overruled:
        said = "; ".join(wish_line(w.change) for w in wanted.overruled)
        found.append(f"The text overruled what the picture shows: {said}.")
    if wanted.image is not None and wanted.part is None and answer.confidence is None:
        found.append(
            "Whether the picture shows a garment was not judged: these weights have no measure for that."
        )
    found += [f"Look at the pattern: {oddity}." for oddity in answer.verdict.oddities]
    if order.is_of_two:
        guess = ", which is a guess" if order.outfit and order.outfit.guessed else ""
        found.append(f'{_which_of_them(order)}: "{one_line(order.words, LONGEST_NOTE)}"{guess}.')
        besides = order.outfit.besides if order.outfit else ()
        if besides:
            found.append(f"Named besides, and not made: {', '.join(besides)}. Ask for each on its own.")
    elif order.part is None and not order.images and order.outfit is not None:
        found.append(ONE_OF_TWO)
    if wanted.text != order.words:
        found.append(f"Read as: {one_line(wanted.text, LONGEST_NOTE)}")
    if wanted.misses and not (answer.put_on or answer.taken_off):
        found.append(NOTHING_UNDERSTOOD if order.edit is None else AS_IT_WAS)
    found += heard_notes(wanted)
    unsure = [wish.change for wish in answer.not_done]
    if unsure:
        found.append(f"Perhaps asked for, and not done: {'; '.join(map(wish_line, unsure))}.")
    found += [f'"{one_line(word)}" is said, and this is not so: {wish_line(c)}.' for word, c in answer.not_so]
    assumed = _assumed(wanted, unsure)
    if assumed:
        found.append(f"Assumed: {'; '.join(map(wish_line, assumed))}.")
    if order.edit is None and answer.cuts:
        found.append(f"Altered: {'; '.join(answer.cuts)}.")
    if order.edit is not None and not wanted.leaves_cut:
        found += _changed_notes(answer)
    if answer.verdict.open:
        found.append(f"Requested but not met: {'; '.join(map(wish_line, answer.verdict.open))}.")
    if answer.verdict.sits_badly or answer.verdict.beyond_usual:
        said = "; ".join((*answer.verdict.sits_badly, *answer.verdict.beyond_usual))
        found.append(f"It may sit badly: {said}.")
    if answer.verdict.refused:
        found.append(f"Refused, and so nevertheless: {'; '.join(map(wish_line, answer.verdict.refused))}.")
    return found


def _which_of_them(order: Order) -> str:
    """Which of several garments of a text an order is about."""
    outfit = order.outfit
    if order.part == "beside":
        return "Of the three garments, the one that is worn with both others"
    many = "three" if outfit is not None and outfit.third else "two"
    if outfit is None or not outfit.layered:
        return f"Of the {many} garments, the {order.part} one"
    return f"Of the {many} garments, the one {'on top' if order.part == 'upper' else 'beneath'}"


def trim_notes(answer: Answer) -> list[str]:
    """Pockets, buttons and the like that were put on or taken off, for a person."""
    found = []
    if answer.put_on:
        count = answer.pattern.button_count
        said = "; ".join(trim_said(name, count) for name in answer.put_on)
        found.append(f"Put on, for the eye and the sewist, since it holds no panels together: {said}.")
    if answer.taken_off:
        found.append(f"Taken off: {'; '.join(TRIMS[name] for name in answer.taken_off)}.")
    return found


def _assumed(wanted: Wanted, not_done: Sequence[Change]) -> list[Change]:
    """What was not said for certain, and is so: names of garments imply it."""
    return [w.change for w in wanted.likely if w not in wanted.seen and w.change not in not_done]


def _changed_notes(answer: Answer) -> list[str]:
    """What an edit has changed, seen in the patterns."""
    from swifttailor.wording.wish_lines import wish_line

    if answer.is_given:
        return ["Nothing was changed." if answer.verdict.open else "Nothing was changed: it was so already."]
    found = []
    if answer.anew:
        what = "The half that was spoken of was made anew" if answer.anew == "half" else "Made anew"
        found.append(f"{what}, since cutting the pattern does not lead there; compare the two.")
    elif not answer.of_edit:
        found.append(
            "Written anew by PatternMaker, since that meets more than cutting does; compare the two."
        )
    if answer.unasked:
        found.append(f"Changed, though nobody asked for it: {'; '.join(map(wish_line, answer.unasked))}.")
    if answer.moved_waist is not None:
        wider = "wider" if answer.moved_waist > 0 else "narrower"
        found.append(f"The waist was to stay, and is {abs(answer.moved_waist):.1f} cm {wider}.")
    if answer.seen:
        return [*found, f"Changed: {'; '.join(map(wish_line, answer.seen))}."]
    what = "less than there are words for" if answer.seen is not None else "the patterns cannot be measured"
    return [*found, f"What has changed cannot be told: {what}."]


def order_warnings(answer: Answer) -> list[str]:
    """What of an order was not used or understood, or is doubtful."""
    wanted = answer.wanted
    seen = () if wanted is None else wanted.warnings
    fabric = None if wanted is None else fabric_unmet(wanted)
    unmet = [] if fabric is None else [fabric_warning(fabric)]
    return [*seen, *unmet, *answer.doubts, *(() if answer.written is None else answer.written.notes)]


def _read_line(wanted: Wanted) -> str:
    """What was read of a picture, on one line."""
    from swifttailor.wording.wish_lines import wish_line

    assert wanted.part is not None
    sides = " and ".join(one.reading.shown for one in wanted.pictures)
    said = "; ".join(f"{wish_line(w.change)} ({w.certainty:.0%})" for w in wanted.seen)
    return f"Read in the picture ({sides}, {wanted.part.part} garment): {said or 'nothing for certain'}."


def finishing_notes(garment: Garment) -> list[str]:
    """What a person should know of how a garment was finished; nothing where it hung from where it was."""
    fallen = "finishing" not in garment.report
    if fallen and "relaxed_frames" in garment.report and garment.report["sewing"]["crumpled"] > CRUMPLED:
        fell = garment.report["relaxed_frames"] / 60
        return [f"Its cloth came out crumpled, and fell for {fell:.1f} s of physics (--no-relax: not)."]
    if fallen and "not_relaxed" in garment.report:
        return [f"Left as the network made it. {garment.report['not_relaxed']}"]
    about = garment.report.get("finishing", {"from": "garment"})
    if about["from"] == "garment":
        return []
    return [f"Draped from the pattern: the sewn garment did not come to rest well ({about['reasons'][0]})."]


def change_line(change: Mending) -> str:
    """What was mended, for a person."""
    place = f" ({change.where()})" if change.where() else ""
    return f"{change.code}{place}: {change.message}"
