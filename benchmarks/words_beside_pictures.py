"""What words beside a picture change in the design that is read in it, and what cutting to them costs.

``python benchmarks/words_beside_pictures.py DRAPES/validation validation.jsonl.gz --limit 150``

One plain front of each garment is read together with its caption, and the part of the body that it covers is
drafted. Rows: the draft as it is read; cut to the words alone; changed until it does what they ask
(`tailor.heeded`); changed, and then cut, as `generate` does. Metrics as in `drafts_of_pictures.py`, and the
statements of the captions that hold.
"""

from __future__ import annotations

import argparse
import statistics
import time
from contextlib import nullcontext
from pathlib import Path
from unittest import mock

from drafts_of_pictures import row
from machine import describe
from swifttailor.evaluation.maker.ask import picture_of
from swifttailor.evaluation.maker.questions import PatternSet, Question
from swifttailor.evaluation.maker.run import Plan, pictures_of, questions_of
from swifttailor.pattern import Pattern
from swifttailor.picture_reader.labels import PARTS
from swifttailor.picture_reader.truth import Truth
from swifttailor.tailor import Order, Tailor, designed
from swifttailor.tailor.candidates import Candidate
from swifttailor.tailor.designed import DesignedCandidate
from swifttailor.tailor.fitting import cut_from
from swifttailor.tailor.heeded import heeded
from swifttailor.tailor.reading import Wanted, facts_of
from swifttailor.tailor.second_reading import SecondReading


class _Uncounted:
    def add(self, count: int) -> None:
        """Nothing is shown."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("data", type=Path, help="a split of sewn or draped garments")
    parser.add_argument("patterns", type=Path, help="its patterns")
    parser.add_argument("--limit", type=int, default=150, help="garments")
    options = parser.parse_args()
    tailor = Tailor.load()
    parameters, eyes = tailor.parameter_reader, tailor.picture_reader
    assert parameters is not None and eyes is not None
    second = SecondReading(tailor.garment_sewer, eyes)
    asked = read(tailor, options)
    print(describe())
    print(f"{len(asked)} plain fronts with captions", flush=True)
    drafted: list[tuple[Question, Wanted, Candidate, Candidate]] = []
    seconds = []
    for question, wanted in asked:
        with mock.patch.object(designed, "heeded", lambda design, pattern, *_: (design, pattern)):
            made = DesignedCandidate(parameters, wanted, wanted.order.seed, second)
        if not len(made):
            continue
        before = made.take(0)
        assert before.design is not None
        began = time.process_time()
        design, pattern = heeded(before.design, before.written.pattern, wanted, parameters)
        if still_open(before.written.pattern, wanted):
            seconds.append(time.process_time() - began)
        after = Candidate(type(before.written)(pattern), design=design)
        drafted.append((question, wanted, before, after))
    truth = [question.truth for question, *_ in drafted]
    for name, candidates in (("as read", [d[2] for d in drafted]), ("changed", [d[3] for d in drafted])):
        patterns = [one.written.pattern for one in candidates]
        cut = [
            cut_from(one, d[1], d[1].order.seed).pattern for one, d in zip(candidates, drafted, strict=True)
        ]
        left = sum(still_open(pattern, d[1]) for pattern, d in zip(patterns, drafted, strict=True))
        print(f"{name}: {row(patterns, truth)}; {held(patterns, drafted)}; {left} with something open")
        print(f"{name}, then cut: {row(cut, truth)}; {held(cut, drafted)}", flush=True)
    if seconds:
        middle, most = statistics.median(seconds), max(seconds)
        print(f"changing takes {middle:.2f} s of a core (median), {most:.1f} at most")


def read(tailor: Tailor, options: argparse.Namespace) -> list[tuple[Question, Wanted]]:
    """Questions with a picture and a caption, and what is wanted of who asks them."""
    plan = Plan(
        (options.patterns,), options.data.parent, tasks=("text+image",), limit=options.limit, look="plain"
    )
    patterns, pictures = PatternSet.read(plan.patterns), pictures_of(plan)
    found = []
    for question in questions_of(
        plan, plan.tasks, patterns, pictures, None, lambda *_: nullcontext(_Uncounted())
    ):
        shown = picture_of(question, pictures)
        assert shown is not None
        covers = PARTS[Truth.of(question.truth, question.facts).part]
        found.append((question, tailor.read(Order(question.text, shown[1], part=covers))))
    return found


def still_open(pattern: Pattern, wanted: Wanted) -> bool:
    """Whether something does not hold that the words ask for."""
    facts = facts_of(pattern)
    return any(facts is None or not wish.change.holds(facts, facts) for wish in wanted.said)


def held(patterns: list[Pattern], drafted: list[tuple[Question, Wanted, Candidate, Candidate]]) -> str:
    """Of the statements of captions those that hold, and of captions those of which all do."""
    each = []
    for pattern, (question, *_) in zip(patterns, drafted, strict=True):
        facts = facts_of(pattern)
        each.append([facts is not None and claim.holds(facts) for claim in question.claims])
    count = sum(map(len, each))
    holding, whole = 100 * sum(map(sum, each)) / count, 100 * sum(map(all, each)) / len(each)
    return f"statements {holding:.1f} %, all {whole:.1f} %"


if __name__ == "__main__":
    main()
