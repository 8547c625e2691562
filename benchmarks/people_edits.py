"""What becomes of people's instructions: expected statements that hold afterwards, by the path of `edit`.

python benchmarks/people_edits.py HALF [--misses] [--count N] [--only ID ...]; halves are those of `_FILES`

Each instruction is given to a garment of which what it presupposes is true, made by the path of `generate`.
Of the final half only counts are printed.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter

import swifttailor
from answer_doubts import doubts, is_unsure_alone
from part_changes import changed_elsewhere
from people_answers import met
from people_prompts import WORDS, ExpectedStep, PeopleEdit, read_people_edits
from swifttailor.describing import Claim
from swifttailor.describing.claims import claims_of
from swifttailor.describing.differences import Gain
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.tailor import Order
from swifttailor.wishes.descriptions.own_words import in_own_words

_FILES = {
    "building": WORDS / "building" / "edits.jsonl",
    "final": WORDS / "final" / "edits.jsonl",
    "fresh": WORDS / "fresh" / "edits.jsonl",
    "fresher": WORDS / "fresh" / "edits_after.jsonl",
    "cutting": WORDS / "fresh" / "edits_cutting.jsonl",
    "cutting_after": WORDS / "fresh" / "edits_cutting_after.jsonl",
    "voices": WORDS / "fresh" / "edits_voices.jsonl",
    "persons": WORDS / "fresh" / "edits_persons.jsonl",
    "persons_after": WORDS / "fresh" / "edits_persons_after.jsonl",
    "one": WORDS / "fresh" / "edits_of_one.jsonl",
    "rehearsal": WORDS / "rehearsal" / "edits.jsonl",
    "in_passing": WORDS / "fresh" / "edits_in_passing.jsonl",
}
_STAYS_CM = 2.0
"""What is to stay may move by so much."""


def base_garment(prompt: PeopleEdit, tailor: swifttailor.Tailor) -> Pattern:
    """A garment of which holds what the instruction presupposes, as far as it can be made."""
    (answer,) = tailor.write([Order(in_own_words([Gain(claim) for claim in prompt.base]))])
    if isinstance(answer, SwiftTailorError):
        raise answer
    return answer.pattern


def girth(name: str, facts: GarmentFacts) -> float | None:
    """A measure of the garment, girths of waist and hips included."""
    if name == "waist":
        band, torso = facts.waistband, facts.torso
        return band.lower if band and not band.at_hem else torso.waist if torso else None
    if name == "hips":
        part = facts.skirt or facts.trousers
        return part.hips if part else None
    return QUANTITIES[name].of(facts)


def stepped(step: ExpectedStep, before: GarmentFacts, after: GarmentFacts) -> bool:
    """Whether one of the measures moved as expected."""
    for name in step.measures:
        was, now = girth(name, before), girth(name, after)
        if was is None or now is None:
            continue
        least = QUANTITIES[name].least / 2 if name in QUANTITIES else 1.0
        if step.direction == "=":
            if abs(now - was) <= _STAYS_CM:
                return True
            continue
        moved = (now - was) * (1 if step.direction == "+" else -1)
        if step.cm is None:
            if moved >= least:
                return True
        elif abs(moved - step.cm) <= max(0.5, least if least < 1 else 1.0, 0.25 * step.cm):
            return True
    return False


def judge(prompt: PeopleEdit, tailor: swifttailor.Tailor, counts: Counter[str], misses: list[str]) -> None:
    """Carries out one instruction and counts what holds."""
    base = base_garment(prompt, tailor)
    before = measure_facts(base)
    counts["bases as described"] += all(claim.holds(before) for claim in prompt.base)
    (answer,) = tailor.write([Order(prompt.text, edit=base)])
    musts = [e for e in prompt.expect if e.sure == "must"]
    steps = [s for s in prompt.steps if s.sure == "must"]
    counts["statements"] += len(musts) + len(steps)
    if isinstance(answer, SwiftTailorError):
        counts["none made"] += 1
        misses.append(f"{prompt.id} none made: {prompt.text}: {answer}")
        return
    after = measure_facts(answer.pattern)
    open_ones = [e for e in musts if not met(e, after)]
    still = [s for s in steps if not stepped(s, before, after)]
    broken = [n.claim for n in prompt.never if any(Claim(n.claim, v).holds(after) for v in n.values)]
    counts["hold"] += len(musts) + len(steps) - len(open_ones) - len(still)
    whole = not (open_ones or still or broken)
    counts["in all"] += whole
    counts["wrong in silence"] += not whole and not doubts(answer)
    counts["unsure alone, right" if whole else "unsure alone, wrong"] += is_unsure_alone(answer)
    counts["left as it was"] += answer.is_given
    counts["written anew"] += not answer.of_edit
    elsewhere = changed_elsewhere(prompt, before, after)
    counts["changed elsewhere"] += bool(elsewhere)
    if whole and not elsewhere:
        return
    wanted = [f"{e.claim}={'/'.join(e.values) or e.number}" for e in open_ones]
    wanted += [f"{'/'.join(s.measures)} {s.direction}{s.cm or ''}" for s in still]
    seen = [f"{c.name}={c.value}" for c in claims_of(after) if c.name in {e.claim for e in open_ones}]
    heard = answer.wanted.heard if answer.wanted else None
    unread = heard.unread if heard else ()
    misses.append(
        f"{prompt.id} {prompt.text!r} ({prompt.base[0].value}): wanted {wanted}, never {broken}; is {seen}; "
        f"elsewhere {elsewhere}; unread {unread}; cuts {answer.cuts}; doubts {doubts(answer)}"
    )


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
    parser.add_argument("--only", nargs="*", default=(), help="only these ids (not of the final half)")
    args = parser.parse_args()
    prompts = read_people_edits(_FILES[args.half])[: args.count]
    if args.only and args.half != "final":
        prompts = tuple([p for p in prompts if p.id in args.only])
    tailor, counts, misses = swifttailor.Tailor.load(), Counter[str](), list[str]()
    begun = time.perf_counter()
    for number, prompt in enumerate(prompts, start=1):
        judge(prompt, tailor, counts, misses)
        if number % 25 == 0:
            print(f"  after {number}: {dict(counts)}", file=sys.stderr, flush=True)
    print(
        f"{args.half}: {len(prompts)} instructions, {(time.perf_counter() - begun) / len(prompts):.2f} s each"
    )
    print(f"  expected statements and steps that hold: {counts['hold']} of {counts['statements']}")
    print(f"  instructions of which all holds and nothing refused is so: {counts['in all']}")
    print(f"  something changed elsewhere: {counts['changed elsewhere']}")
    print(f"  wrong in silence: {counts['wrong in silence']}; none made: {counts['none made']}")
    print(
        f"  nothing said but that a wish is unsure: of those that are wrong {counts['unsure alone, wrong']}, "
        f"of those that hold {counts['unsure alone, right']}"
    )
    print(f"  left as they were: {counts['left as it was']}; written anew: {counts['written anew']}")
    print(f"  garments of which all holds that is presupposed: {counts['bases as described']}")
    if args.misses and args.half != "final":
        print("\n".join(misses))


if __name__ == "__main__":
    main()
