"""What follows from people's words by the lexicon alone, by the network alone, and by both.

python benchmarks/word_readers.py [--misses] [--no-network]

Counts over the prompts of benchmarks/words/building how many expected statements follow, how many are
contradicted, and for how many prompts everything is named that cannot be made or that nobody knows. The final
half is not read.
"""

from __future__ import annotations

import argparse
import time
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field

from people_prompts import (
    WORDS,
    Expectation,
    PeopleEdit,
    PeoplePrompt,
    read_people_edits,
    read_people_prompts,
)
from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes import WishReader
from swifttailor.wishes.text.spelling import put_right
from swifttailor.wording.lexicon import WordReading, exclude, read_words

APART = frozenset({"sizes", "bodies", "prints"})
"""Answered by size and cloth of a prompt, not by what cannot be made."""
_WITHOUT_COLLAR = frozenset({"neckline", "left_neckline", "right_neckline", "back_neckline"})

Reader = Callable[[PeoplePrompt], frozenset[Claim]]


@dataclass
class Score:
    """Expected statements by what became of them."""

    counts: Counter[str] = field(default_factory=Counter)
    by_claim: Counter[tuple[str, str]] = field(default_factory=Counter)
    misses: list[str] = field(default_factory=list)

    def add(self, prompt: PeoplePrompt, claims: frozenset[Claim]) -> None:
        """Judges one prompt."""
        whole = with_consequences(claims)
        for expected in prompt.expect:
            values = [claim for claim in whole if claim.name == expected.claim]
            met = (
                "met" if any(_meets(expected, claim) for claim in values) else "wrong" if values else "silent"
            )
            self.counts[f"{expected.sure} {met}"] += 1
            self.by_claim[expected.claim, met] += 1
            if met != "met":
                said = "/".join(str(claim.value) for claim in values) or "nothing"
                wanted = "/".join(expected.values) or f"{expected.number:g}"
                line = f"{prompt.id} {expected.sure} {expected.claim}={wanted}, {said} follows"
                self.misses.append(f"{line}: {prompt.text}")
        for refused in prompt.never:
            broken = any(claim.name == refused.claim and claim.value in refused.values for claim in claims)
            self.counts["never broken" if broken else "never kept"] += 1
            if broken:
                self.misses.append(
                    f"{prompt.id} NEVER {refused.claim}={'/'.join(refused.values)}: {prompt.text}"
                )


def with_consequences(claims: Iterable[Claim]) -> frozenset[Claim]:
    """Claims with what is true wherever they are: a neckline is seen without collar and hood."""
    found = set(claims)
    names = {claim.name for claim in found}
    if names & _WITHOUT_COLLAR:
        found |= {Claim("collar", "none"), Claim("hood", "none")}
    if Claim("skirt_hem", "floor") in found:
        found.add(Claim("skirt_hem", "maxi"))
    if Claim("skirt", "gathered tiers") in found:
        found.add(Claim("skirt", "tiered"))
    if Claim("shoulders", "strapless") in found or "straps" in names:
        found.add(Claim("sleeves", "none"))
    return frozenset(found)


def _meets(expected: Expectation, claim: Claim) -> bool:
    if expected.number is not None:
        return abs(float(claim.value) - expected.number) <= expected.within
    return claim.value in expected.values


def lexicon_claims(reading: WordReading) -> frozenset[Claim]:
    """All that follows from the words."""
    return frozenset(implied.claim for implied in reading.implications)


def united(reading: WordReading, network: Iterable[Claim]) -> frozenset[Claim]:
    """Said details and definitions first, then what the network reads, then what else names imply."""
    sure = [
        i.claim
        for i in reading.implications
        if i.certainty == "certain" or (i.said and i.certainty != "likely")
    ]
    rest = [i.claim for i in reading.implications if i.claim not in sure]
    found = list(sure)
    for claim in [*network, *rest]:
        if claim not in reading.never and not any(exclude(claim, other) for other in found):
            found.append(claim)
    return frozenset(found)


def lacks_right(prompt: PeoplePrompt, reading: WordReading, *, strictly: bool) -> tuple[bool, str]:
    """Whether all is named that cannot be made or nobody knows, and nothing else where judged strictly."""
    wanted = {text: {lack.what for lack in read_words(text).lacks} - APART for text in prompt.cannot}
    named = {lack.what for lack in reading.lacks} - APART
    said = {lack.what for lack in reading.lacks if lack.said} - APART
    unknown = {word.lower() for word in reading.unknown}
    missing = [text for text, keys in wanted.items() if not keys & named]
    missing += [word for word in prompt.unknown if word.lower() not in unknown]
    if not strictly:
        return not missing, f"misses {', '.join(missing)}"
    extra = said - {key for keys in wanted.values() for key in keys}
    extra |= unknown - {word.lower() for word in prompt.unknown}
    return (
        not missing and not extra,
        f"misses {', '.join(missing) or 'nothing'}; adds {', '.join(sorted(extra))}",
    )


def main() -> None:
    """Measures and prints."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--misses", action="store_true", help="name what does not follow from the lexicon")
    parser.add_argument("--no-network", action="store_true", help="measure the lexicon alone")
    args = parser.parse_args()
    half = WORDS / "building"
    wishes, edits = read_people_prompts(half / "prompts.jsonl"), read_people_edits(half / "edits.jsonl")
    _report("wishes", wishes, args.misses, not args.no_network)
    _report("instructions", edits, args.misses, not args.no_network)
    _times([prompt.text for prompt in (*wishes, *edits)])


def _report(title: str, prompts: Sequence[PeoplePrompt], misses: bool, network: bool) -> None:
    scores = {"lexicon": Score()} | ({"network": Score(), "union": Score()} if network else {})
    reader = WishReader.load() if network else None
    right, alarms, unknown = Counter[str](), Counter[str](), Counter[str]()
    lines = []
    for prompt in prompts:
        instruction = isinstance(prompt, PeopleEdit)
        kind = str(prompt.base[0].value) if isinstance(prompt, PeopleEdit) else None
        reading = read_words(prompt.text, kind=kind)
        scores["lexicon"].add(prompt, lexicon_claims(reading))
        if reader is not None:
            read = reader.read(put_right(prompt.text), instruction=instruction)
            gains = [wish.change.claim for wish in read if isinstance(wish.change, Gain)]
            scores["network"].add(prompt, frozenset(gains))
            scores["union"].add(prompt, united(reading, gains))
        for strictly in (False, True):
            good, why = lacks_right(prompt, reading, strictly=strictly)
            right["strictly" if strictly else "named"] += good
            if not good:
                lines.append(f"{prompt.id} {'strictly ' if strictly else ''}{why}: {prompt.text}")
        expected = "expected" if prompt.contradiction else "not expected"
        alarms[f"{expected}, {'named' if reading.contradictions else 'not named'}"] += 1
        if prompt.contradiction != bool(reading.contradictions):
            pairs = [(pair.first.word, pair.second.word) for pair in reading.contradictions]
            lines.append(f"{prompt.id} contradiction {pairs}: {prompt.text}")
        if prompt.size is not None:
            right["with a size"] += 1
            right["size named"] += bool(reading.sizes)
        unknown.update(word.lower() for word in reading.unknown)
    print(f"\n{len(prompts)} {title}")
    for name, score in scores.items():
        print(f"  {name}: " + ", ".join(f"{key} {score.counts[key]}" for key in sorted(score.counts)))
    print(f"  all named that cannot be made or nobody knows: {right['named']}", end="")
    print(f"; and nothing else: {right['strictly']}")
    print(f"  sizes named: {right['size named']} of {right['with a size']}")
    print("  contradictions: " + ", ".join(f"{key} {count}" for key, count in sorted(alarms.items())))
    listed = ", ".join([f"{word} {n}" if n > 1 else word for word, n in unknown.most_common()])
    print(f"  unknown words: {sum(unknown.values())}: {listed}")
    if misses:
        print("\n".join(["", *scores["lexicon"].misses, "", *lines]))


def _times(texts: Sequence[str]) -> None:
    begun = time.perf_counter()
    for text in texts:
        read_words(text)
    spent = time.perf_counter() - begun
    print(f"\n{1000 * spent / len(texts):.2f} ms a text")


if __name__ == "__main__":
    main()
