"""How much of what people say is heard, before anything is cut: words and networks together.

``python benchmarks/heard_words.py FILE... [--wishes] [--held-out] [--weights FILE | --tables]
    [--misses N]``

FILES hold texts with what they ask for (`runs/spoken`). An instruction is heard as `edit` hears it, about a
draft of its kind, and with --wishes a wish as `generate` hears it. What is heard for sure is compared with
what is asked for, amounts left out.

in all
    everything that is asked for is heard, and nothing else
asked and heard, heard and asked
    recall and precision of what is asked for
silent
    something is wrong, and neither is a word said not to be understood nor a wish said to be unsure
doubted
    all is right, and a wish is said to be unsure
"""

from __future__ import annotations

import argparse
import time
from collections import Counter
from dataclasses import replace
from functools import cache
from pathlib import Path

import swifttailor
from machine import describe
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring import measure_facts
from swifttailor.training.spoken_texts import SpokenText, read_spoken_texts
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.instructions.hearing_changes import hear_instruction
from swifttailor.wishes.labels import label_of
from swifttailor.wishes.reader import WishReader

DRAFTS: dict[str, tuple[str, dict[str, float]]] = {
    "dress": ("shirt-dress", {}),
    "top": ("t-shirt", {}),
    "tunic": ("kaftan", {"length": 40.0, "chest_ease": 20.0}),
    "skirt": ("fitted-skirt", {}),
    "trousers": ("trousers", {}),
    "shorts": ("trousers", {"length": 45.0}),
    "jumpsuit": ("jumpsuit", {}),
    "playsuit": ("jumpsuit", {"length": 45.0}),
}


@cache
def facts_of(kind: str) -> GarmentFacts:
    """Of the draft that an instruction about a garment of this kind is given to."""
    name, options = DRAFTS[kind]
    return measure_facts(swifttailor.draft(name, **options))


def heard_of(spoken: SpokenText, reader: WishReader) -> Heard:
    """What is heard of an instruction or a wish."""
    if spoken.kind is None:
        return hear_description(spoken.text, reader)
    return hear_instruction(spoken.text, reader, facts_of(spoken.kind))


def hear(spoken: SpokenText, reader: WishReader, counts: Counter[str]) -> str:
    """Hears one text; returns what went wrong with it, or nothing."""
    heard = heard_of(spoken, reader)
    found = {label_of(wish.change) for wish in heard.sure}
    meant = {label_of(change) for change in spoken.changes}
    counts["texts"] += 1
    counts["meant"] += len(meant)
    counts["heard"] += len(found)
    counts["right"] += len(meant & found)
    counts["in all"] += meant == found
    counts["all and more"] += meant < found
    said = bool(heard.unread or heard.clashes or heard.unsure or heard.perhaps)
    silent = meant != found and not said
    counts["doubted"] += meant == found and bool(heard.unsure or heard.perhaps)
    counts["silent"] += silent
    if meant == found:
        return ""
    lost, more = sorted(meant - found), sorted(found - meant)
    return f"{spoken.text!r} ({spoken.kind}): lost {lost}, more {more}, unread {list(heard.unread)}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("files", type=Path, nargs="+")
    parser.add_argument("--wishes", action="store_true", help="these instead of instructions")
    parser.add_argument("--held-out", action="store_true", help="only what the network does not learn from")
    parser.add_argument("--weights", type=Path, help="of the reader of people's own words")
    parser.add_argument("--tables", action="store_true", help="without that reader")
    parser.add_argument("--misses", type=int, default=0)
    options = parser.parse_args()
    reader = WishReader.load()
    if options.weights is not None or options.tables:
        reader = replace(reader, own_words=options.weights)
    counts: Counter[str] = Counter()
    texts = [t for t in read_spoken_texts(options.files) if t.held_out or not options.held_out]
    texts = [text for text in texts if (text.kind is None) == options.wishes]
    heard_of(texts[0], reader)  # opens the networks and tables
    begun = time.process_time()
    wrong = [miss for t in texts if (miss := hear(t, reader, counts))]
    spent = time.process_time() - begun
    print(describe())
    total, right = counts["texts"], counts["right"]
    print(
        f"{total} {'wishes' if options.wishes else 'instructions'}: {counts['in all']} in all "
        f"({counts['in all'] / total:.1%}), "
        f"{counts['all and more']} with something more; asked and heard {right / counts['meant']:.1%}, "
        f"heard and asked {right / max(counts['heard'], 1):.1%}; silent {counts['silent']}, "
        f"doubted {counts['doubted']}; {1000 * spent / total:.1f} ms of processor time each"
    )
    print("\n".join(wrong[: options.misses]))


if __name__ == "__main__":
    main()
