"""From orders to patterns: the one loop of attempts, with one verdict."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from swifttailor.clock import Clock
from swifttailor.errors import InputError, PatternError, SwiftTailorError
from swifttailor.garment_sewer.bare_bust import bares_bust
from swifttailor.garment_sewer.sewer import GarmentSewer, Prepared
from swifttailor.garment_sewer.tightness import is_too_tight
from swifttailor.parameter_reader.reader import ParameterReader
from swifttailor.pattern_library.known import PatternLibrary
from swifttailor.pattern_maker.maker import WrittenPattern
from swifttailor.pattern_maker.temperatures import HIGHEST_TEMPERATURE
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.candidates import Candidate, CandidateList
from swifttailor.tailor.drafted import draft_candidates
from swifttailor.tailor.fitting import cut_from, fit, from_edit
from swifttailor.tailor.keeping_kinds import keeps_its_kind
from swifttailor.tailor.looking import ReadsPictures
from swifttailor.tailor.made_anew import anew_from_known
from swifttailor.tailor.offers import Offers, Sample
from swifttailor.tailor.order import Order
from swifttailor.tailor.protocols import PatternWriter, Sewer
from swifttailor.tailor.reading import Wanted
from swifttailor.tailor.refining import refined
from swifttailor.tailor.second_reading import SecondReading
from swifttailor.tailor.sewing import SewingOptions, prepare
from swifttailor.tailor.slits_seen import with_slit_seen
from swifttailor.tailor.trimming import trimmed, with_looks_that_fit

WARMER = 0.15
"""How much higher the temperature of each attempt is than that of the one before: the likely has failed."""
TIGHT = "it would be too tight"
BARE = "it would leave the bust bare"


def write_patterns(
    writer: Callable[[], PatternWriter],
    sewer: Sewer,
    samples: Sequence[Sample],
    clock: Clock,
    library: PatternLibrary | None = None,
    known_to_edit: Callable[[], PatternLibrary | None] | None = None,
    designer: ParameterReader | None = None,
    eyes: ReadsPictures | None = None,
) -> list[Answer | SwiftTailorError]:
    """Finds a pattern for each sample, all together, until each is sound or had its attempts.

    The first attempt is with a draft where words name a garment that one shows; the next is with a draft of
    the design parameters that are read in what is wanted, and then come known patterns, where anything is
    known of it; the others are written. A draft of what nothing else knows is kept where it lacks no more
    than details (`keeping_kinds`).

    Sound are those of which a check doubts nothing but what it doubted of the pattern to edit before, which
    can be sewn, and of which everything holds that was asked for. Where none is, the best is taken that can
    be sewn.

    Args:
        writer: Gives who writes them; called when that is first needed.
        sewer: Says whether one can be sewn.
        samples: At least one; their orders have one temperature and number of attempts.
        clock: Takes the seconds of the stages.
        library: Known patterns; None where all are to be written.
        known_to_edit: Gives those that edits may be made anew from, where cutting does not lead to what is
            asked; None where they may not.
        designer: Reads design parameters to draft from; None where nothing is to be drafted so.
        eyes: Reads drafts again as the pictures were read (`SecondReading`); None where nobody does.

    Returns:
        For each sample its pattern, prepared to be sewn, or why there is none.

    Raises:
        SwiftTailorError: The orders cannot be answered at all.
    """
    manners = {(wanted.order.temperature, wanted.order.most_attempts) for wanted, _ in samples}
    if len(manners) != 1:
        raise InputError("Orders that are written together need one temperature and number of attempts.")
    ((temperature, attempts),) = manners
    clock.restart()
    drafts = draft_candidates(samples)
    begun = [len(some) for some in drafts]
    only_drafts = [wanted.order.source in ("drafts", "designs") for wanted, _ in samples]
    second = None if eyes is None else SecondReading(sewer, eyes)
    offered = Offers(samples, library, designer, second)
    tried: list[list[Answer]] = [[] for _ in samples]
    kept = {
        k: [replace(one, seed=seed) for one in found]
        for k, (w, seed) in enumerate(samples)
        if (found := _edited(w, known_to_edit))
    }
    for attempt in range(attempts):
        waiting = [
            k
            for k, answers in enumerate(tried)
            if k not in kept
            and (not answers or (answers[-1].verdict.fault and not only_drafts[k]))
            and not (attempt >= begun[k] and any(map(keeps_its_kind, answers)))
            and not (
                answers
                and answers[-1].verdict.is_merely_odd
                and attempt >= begun[k]
                and attempt >= begun[k] + offered[k].count
            )
        ]
        if not waiting:
            break
        clock.restart()
        found: dict[int, Candidate] = {}
        for k in waiting:
            if attempt < begun[k]:
                found[k] = Candidate(drafts[k][attempt].take())
            elif attempt - begun[k] < offered[k].count:
                found[k] = offered[k].listed.take(attempt - begun[k])
        if found:
            clock.stop("searching")
        draws = {k: attempt - begun[k] - offered[k].count for k in waiting if k not in found}
        for draw in sorted(set(draws.values())):
            asked = [k for k in draws if draws[k] == draw]
            written = writer().generate_all(
                [samples[k][0].request(draw) for k in asked],
                seed=[samples[k][1] for k in asked],
                temperature=min(temperature + WARMER * draw, HIGHEST_TEMPERATURE),
                draw=draw,
            )
            _take_time(written, clock)
            found |= {k: Candidate(one) for k, one in zip(asked, written, strict=True)}
        for k in waiting:
            wanted, seed = samples[k]
            begins = drafts[k][attempt] if attempt < begun[k] else None
            if begins is not None:
                answer = fit(found[k].written, wanted.begun_from(begins.draft), drafted=True)
                answer = replace(answer, seed=seed, draft=begins.name, drafted=begins)
            else:
                answer = cut_from(found[k], wanted, seed)
            clock.stop("altering")
            if not answer.verdict.unsound:
                answer = _prepared(answer, sewer, samples[k][0].order)
                clock.stop("drawing")
            tried[k].append(answer)
    clock.restart()
    chosen = [_chosen(tried[k] or kept[k], sewer, wanted.order) for k, (wanted, _) in enumerate(samples)]
    clock.stop("drawing")
    if any(wanted.part is not None and wanted.order.most_refined for wanted, _ in samples):
        chosen = [
            _refined(answer, tried[k], offered[k].listed, samples[k], sewer)
            for k, answer in enumerate(chosen)
        ]
        clock.stop("refining")
    return chosen


def _edited(wanted: Wanted, library: Callable[[], PatternLibrary | None] | None) -> list[Answer]:
    """The pattern to edit, recut; and made anew from a known one where that does all that is asked."""
    cut = from_edit(wanted)
    found = [] if cut is None else [cut]
    if library is None or wanted.order.edit is None or (cut is not None and not cut.verdict.open):
        return found
    anew = anew_from_known(wanted, library)
    return found if anew is None else [*found, anew]


def _refined(
    answer: Answer | SwiftTailorError,
    tried: Sequence[Answer],
    candidates: CandidateList,
    sample: Sample,
    sewer: Sewer,
) -> Answer | SwiftTailorError:
    """After looking again; of several samples of one order each is another of those that are most alike."""
    if not isinstance(answer, Answer):
        return answer
    wanted, seed = sample
    found = refined(answer, tried, candidates, wanted, sewer, place=seed - wanted.order.seed)
    if found.prepared is None:
        found = _prepared(found, sewer, wanted.order)
    return found if found.prepared is not None else answer


def _take_time(written: Sequence[WrittenPattern], clock: Clock) -> None:
    """By the writer's own stages, where it tells them."""
    if written and written[0].seconds:
        clock.add(written[0].seconds)
        clock.restart()
    else:
        clock.stop("writing")


def _prepared(answer: Answer, sewer: Sewer, order: Order) -> Answer:
    """The pattern with its trims and name, prepared to be sewn or with the reason why it cannot be."""
    answer = with_slit_seen(with_looks_that_fit(trimmed(answer)))
    if not answer.is_given:
        answer = replace(answer, pattern=replace(answer.pattern, name=order.title))
    try:
        answer = prepare(sewer, answer, SewingOptions(order.edge_length))
    except SwiftTailorError as error:
        return replace(answer, verdict=replace(answer.verdict, unsewable=str(error)))
    # Pictures and patterns to edit show how a garment is meant to sit.
    odd = () if order.images or order.edit is not None else _worn_badly(answer, sewer)
    beyond = (*answer.verdict.beyond_usual, *odd)
    return replace(answer, verdict=replace(answer.verdict, beyond_usual=beyond)) if odd else answer


def _worn_badly(answer: Answer, sewer: Sewer) -> tuple[str, ...]:
    """What the coarse drape shows, where the sewer has one."""
    if not isinstance(sewer, GarmentSewer) or sewer.model.conditioning.prior != "hung":
        return ()
    if not isinstance(answer.prepared, Prepared):
        return ()
    tight = (TIGHT,) if is_too_tight(answer.prepared) else ()
    if answer.drafted is not None and answer.drafted.draft.without_bib:  # braces are worn over a shirt
        return tight
    return (*tight, BARE) if bares_bust(answer.prepared, sewer.body) else tight


def _chosen(tried: Sequence[Answer], sewer: Sewer, order: Order) -> Answer | SwiftTailorError:
    """The last of the answers to a sample if that is sound, else the best of those that can be sewn.

    What is merely odd comes before what lacks as much of what names usually mean.
    """
    best_first = sorted(range(len(tried)), key=lambda k: tried[k].rank)
    last = [] if tried[-1].verdict.fault else [len(tried) - 1]
    odd = [k for k, one in enumerate(tried) if one.verdict.is_merely_odd] if last else []
    if odd:
        last = [min(*odd, *last, key=lambda k: tried[k].oddness)]
    for taken in dict.fromkeys([*last, *best_first]):
        answer = tried[taken]
        if answer.prepared is None and not answer.verdict.unsewable:
            answer = _prepared(answer, sewer, order)
        if answer.prepared is not None:
            failures = tuple(one.verdict.fault for k, one in enumerate(tried) if k != taken)
            made = tuple(one.pattern for one in tried)
            return replace(answer, attempt=taken, failures=failures, tried=made)
    return _refusal(tried[best_first[0]], len(tried))


def _refusal(best: Answer, count: int) -> PatternError:
    fault = best.verdict.fault.rstrip(".")
    said = f"None of the {count} patterns that were tried can be sewn; the best has {fault}"
    if best.is_given:
        return PatternError(f"The pattern to edit cannot be sewn, and nothing was altered in it: {fault}.")
    if count == 1:
        said = f"The pattern that was {'found' if best.found else 'written'} cannot be sewn: {fault}"
    hints = f"Try another seed than {best.seed}, more attempts, or other words."
    return PatternError(" ".join([f"{said}.", *best.doubts, hints]))
