"""What a PatternMaker foresees of its answers to texts, and what of that it writes.

``python benchmarks/plan_and_answer.py PATTERNS.jsonl.gz [--limit N] [--weights FILE]``

Captions are written for the patterns and answered at temperature 0. Printed are how often the panels are
those of the pattern, in the plan and as written; and for panels that there are often, how far their height is
off (cm, mean and median): in the plan, as written, and if always the median of these patterns were said.
"""

from __future__ import annotations

import argparse
from collections import defaultdict
from itertools import islice
from pathlib import Path

import numpy as np

from machine import describe
from swifttailor.data.pattern_source import patterns_of
from swifttailor.describing import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.pattern_maker.asking.foresight import BOX, Foresight, foresight_of
from swifttailor.pattern_maker.asking.generation import Asked, write_answers
from swifttailor.pattern_maker.asking.plan import PatternPlan
from swifttailor.pattern_maker.asking.prompt import make_prompt
from swifttailor.pattern_maker.maker import PatternMaker
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.normalization import POINT_SCALE
from swifttailor.pattern_maker.tokens.vocabulary import PANEL_TOKENS
from swifttailor.wording.captions import write_caption

BATCH = 16
SHOWN = 12


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("patterns", type=Path)
    parser.add_argument("--limit", type=int)
    parser.add_argument("--weights", type=Path)
    options = parser.parse_args()
    model = PatternMaker.load(options.weights).model
    patterns = [p for _, p in patterns_of(options.patterns) if not isinstance(p, SwiftTailorError)]
    patterns = patterns[: options.limit]
    truths = [foresight_of(encode(p)) for p in patterns]
    plans, answers = [], []
    texts = iter(write_caption(measure_facts(p), seed).text for seed, p in enumerate(patterns))
    while part := list(islice(texts, BATCH)):
        prompts = [
            make_prompt(model.text.encode(t, model.longest_text).tokens, model.text.size) for t in part
        ]
        for prompt in prompts:
            embedded = model.runtime.embed(prompt.tokens[None], prompt.numbers[None])
            known = np.ones((1, len(prompt)), np.float32)
            plans.append(PatternPlan.from_foresight(model.runtime.foresee(embedded, known)[0]))
        written = write_answers(model.runtime, [Asked(p) for p in prompts], model.grammar, model.text.size)
        answers += [foresight_of(one.sequence) for (one,) in written]
    print(describe())
    print(f"{options.patterns.name}: n = {len(patterns)}")
    right = [set(plan.panels) == _panels(truth) for plan, truth in zip(plans, truths, strict=True)]
    as_written = [_panels(one) == _panels(truth) for one, truth in zip(answers, truths, strict=True)]
    print(f"panels right: foreseen {np.mean(right):.1%}, written {np.mean(as_written):.1%}")
    report_heights(truths, plans, answers)


def report_heights(truths: list[Foresight], plans: list[PatternPlan], answers: list[Foresight]) -> None:
    """Of panels that both the pattern and the answer have."""
    heights = defaultdict(list)
    for truth in truths:
        for panel in _panels(truth):
            heights[panel].append(_height(truth.numbers[panel]))
    errors = defaultdict(list)
    for truth, plan, answer in zip(truths, plans, answers, strict=True):
        for panel in _panels(truth) & _panels(answer):
            true = _height(truth.numbers[panel])
            said = plan.numbers[panel], answer.numbers[panel]
            usual = float(np.median(heights[panel]))
            errors[panel].append([abs(h - true) for h in (*map(_height, said), usual)])
    print(f"{'height off by, cm':20s} {'n':>4s} {'foreseen':>14s} {'written':>14s} {'the median':>14s}")
    for panel in sorted(errors, key=lambda p: -len(errors[p]))[:SHOWN]:
        off = np.array(errors[panel])
        columns = "".join(f"{m:8.1f} {d:5.1f}" for m, d in zip(off.mean(0), np.median(off, 0), strict=True))
        print(f"{PANEL_NAMES[panel]:20s} {len(off):4d} {columns}")


def _panels(one: Foresight) -> set[int]:
    return set(np.flatnonzero(one.present[PANEL_TOKENS.start : PANEL_TOKENS.stop]).tolist())


def _height(numbers: np.ndarray) -> float:
    low, high = numbers[BOX][[1, 3]]
    return float(high - low) * float(POINT_SCALE[1])


if __name__ == "__main__":
    main()
