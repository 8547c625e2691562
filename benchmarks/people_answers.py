"""What is made of people's wishes: expected statements that hold of the patterns, by the path of `generate`.

python benchmarks/people_answers.py HALF [--misses] [--count N]; halves are those of `_FILES`

Patterns are written as `generate` writes them, and measured; of two garments a statement holds if it does of
one of them, and what is refused is so if it is of both. Of the final half only counts are printed.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter

import swifttailor
from answer_doubts import doubts
from people_prompts import WORDS, Expectation, PeoplePrompt, read_people_prompts
from swifttailor.describing import Claim
from swifttailor.describing.claims import CLAIM_TYPES, claims_of
from swifttailor.describing.facts import GarmentFacts, Slit
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.tailor import Order
from swifttailor.tailor.all_parts import orders_of_parts

_FILES = {
    "building": WORDS / "building" / "prompts.jsonl",
    "final": WORDS / "final" / "prompts.jsonl",
    "fresh": WORDS / "fresh" / "prompts.jsonl",
    "fresh_after": WORDS / "fresh" / "prompts_after.jsonl",
    "voices": WORDS / "fresh" / "prompts_voices.jsonl",
    "persons": WORDS / "fresh" / "prompts_persons.jsonl",
    "persons_after": WORDS / "fresh" / "prompts_persons_after.jsonl",
    "five": WORDS / "fresh" / "prompts_of_five.jsonl",
    "three": WORDS / "fresh" / "prompts_of_three.jsonl",
    "rehearsal": WORDS / "rehearsal" / "prompts.jsonl",
}


def met(expected: Expectation, facts: GarmentFacts) -> bool:
    """Whether one of the values holds of a garment."""
    if expected.number is not None:
        measured = CLAIM_TYPES[expected.claim].measure
        assert measured is not None
        value = measured.of(facts)
        return value is not None and abs(value - expected.number) <= expected.within
    return any(Claim(expected.claim, value).holds(facts) for value in expected.values) or (
        expected.claim == "slit" and any(slit.over in expected.values for slit in _slits(facts))
    )


def _slits(facts: GarmentFacts) -> tuple[Slit, ...]:
    """Who asks for a slit on the left may get it over the left leg, as in front in GarmentCode's skirts."""
    return () if facts.skirt is None else facts.skirt.slits


def judge(prompt: PeoplePrompt, tailor: swifttailor.Tailor, counts: Counter[str], misses: list[str]) -> None:
    """Makes the pattern of one prompt and counts what holds."""
    answers = tailor.write(list(orders_of_parts(Order(prompt.text), tailor).values()))
    musts = [e for e in prompt.expect if e.sure == "must"]
    made = [one for one in answers if not isinstance(one, SwiftTailorError)]
    if not made:
        counts["none made"] += 1
        counts["statements"] += len(musts)
        misses.append(f"{prompt.id} none made: {prompt.text}: {answers[0]}")
        return
    counts["two made"] += len(made) > 1
    garments = [measure_facts(one.pattern) for one in made]
    open_ones = [e for e in musts if not any(met(e, facts) for facts in garments)]
    broken = [
        n.claim
        for n in prompt.never
        if all(any(Claim(n.claim, v).holds(facts) for v in n.values) for facts in garments)
    ]
    said = [doubt for one in made for doubt in doubts(one)]
    counts["statements"] += len(musts)
    counts["hold"] += len(musts) - len(open_ones)
    counts["refused, and so"] += len(broken)
    whole = not open_ones and not broken
    counts["prompts in all"] += whole
    counts["wrong in silence"] += not whole and not said
    if not whole:
        wanted = [f"{e.claim}={'/'.join(e.values) or e.number}" for e in open_ones]
        names = {e.claim for e in open_ones}
        seen = [f"{c.name}={c.value}" for facts in garments for c in claims_of(facts) if c.name in names]
        misses.append(f"{prompt.id} {prompt.text!r}: wanted {wanted}, never {broken}; is {seen}; {said}")


def main() -> None:
    """Measures and prints."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("half", choices=tuple(_FILES))
    parser.add_argument(
        "--misses", action="store_true", help="name what does not hold (not of the final half)"
    )
    parser.add_argument("--count", type=int, help="only the first so many")
    args = parser.parse_args()
    prompts = [p for p in read_people_prompts(_FILES[args.half]) if p.garment][: args.count]
    tailor, counts, misses = swifttailor.Tailor.load(), Counter[str](), list[str]()
    begun = time.perf_counter()
    for number, prompt in enumerate(prompts, start=1):
        judge(prompt, tailor, counts, misses)
        if number % 25 == 0:
            print(f"  after {number}: {dict(counts)}", file=sys.stderr, flush=True)
    print(f"{args.half}: {len(prompts)} wishes, {(time.perf_counter() - begun) / len(prompts):.2f} s each")
    print(f"  expected statements that hold: {counts['hold']} of {counts['statements']}")
    print(f"  wishes of which all holds and nothing refused is so: {counts['prompts in all']}")
    print(f"  wrong in silence: {counts['wrong in silence']}; none made: {counts['none made']}")
    print(f"  refused, and so: {counts['refused, and so']}; wishes for two garments: {counts['two made']}")
    if args.misses and args.half != "final":
        print("\n".join(misses))


if __name__ == "__main__":
    main()
