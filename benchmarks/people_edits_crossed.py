"""Instructions in people's own words given to garments that they were not written for.

python benchmarks/people_edits_crossed.py [--seed N] [--misses]

Of each instruction the garment has, besides what it presupposes, what another instruction about the same
kind of garment presupposes, chosen by lot. What is expected stays as it is, so some pairs contradict
themselves ("shorten the inside leg to 70 cm" of legs that are shorter); what counts is what changed
elsewhere, and what is wrong in silence.
"""

from __future__ import annotations

import argparse
import random
from collections import Counter
from dataclasses import replace

import swifttailor
from people_edits import _FILES, judge
from people_prompts import read_people_edits

_SETS = ("building", "fresh", "voices", "cutting", "persons")
"""None of the final half."""


def main() -> None:
    """Measures and prints."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--misses", action="store_true", help="name what does not hold")
    args = parser.parse_args()
    lot = random.Random(args.seed)
    edits = [edit for name in _SETS for edit in read_people_edits(_FILES[name])]
    tailor, counts, misses = swifttailor.Tailor.load(), Counter[str](), list[str]()
    for edit in edits:
        others = [other for other in edits if other is not edit and other.base[0] == edit.base[0]]
        if not others:
            continue
        other = lot.choice(others)
        spoken = {claim.name for claim in edit.base} | {each.claim for each in edit.expect}
        more = [claim for claim in other.base[1:] if claim.name not in spoken]
        if more:
            counts["pairs"] += 1
            crossed = replace(edit, id=f"{edit.id}+{other.id}", base=(*edit.base, *more))
            judge(crossed, tailor, counts, misses)
    print(dict(counts))
    if args.misses:
        print("\n".join(misses))


if __name__ == "__main__":
    main()
