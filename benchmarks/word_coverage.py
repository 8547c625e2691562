"""How many words the lexicon knows.

python benchmarks/word_coverage.py [FILE]

Of FILE, one word a line; without it, of the English texts of benchmarks/words/building, each word with its
neighbours. The final half is not read.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from people_prompts import WORDS, read_people_edits, read_people_prompts
from swifttailor.wording.lexicon import read_words

WORN = frozenset({"garments", "accessories"})


def of_list(path: Path) -> None:
    """Counts the words of a file and prints what is not known."""
    lines = path.read_text(encoding="utf-8").splitlines()
    words = list(dict.fromkeys(line.strip() for line in lines if line.strip()))
    readings = {word: read_words(word, language="en") for word in words}
    unknown = [word for word, reading in readings.items() if reading.unknown]
    worn = [w for w, r in readings.items() if any(e.category in WORN for m in r.marks for e in m.entries)]
    known = len(words) - len(unknown)
    print(f"{known} of {len(words)} known ({known / max(len(words), 1):.0%}), {len(worn)} as something worn")
    print("not known: " + ", ".join(unknown))


def of_people() -> None:
    """Counts the words of people's texts, what stands together as one, and prints what is not known."""
    prompts = read_people_prompts(WORDS / "building" / "prompts.jsonl")
    edits = read_people_edits(WORDS / "building" / "edits.jsonl")
    marks = [
        mark
        for prompt in (*prompts, *edits)
        if prompt.language == "en"
        for mark in read_words(prompt.text, language="en").marks
    ]
    unknown = [mark.word.lower() for mark in marks if not mark.entries]
    known = len(marks) - len(unknown)
    print(f"{known} of {len(marks)} known ({known / len(marks):.1%})")
    print("not known: " + ", ".join(dict.fromkeys(unknown)))


def main() -> None:
    """Counts and prints."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("file", type=Path, nargs="?")
    path = parser.parse_args().file
    if path is None:
        of_people()
    else:
        of_list(path)


if __name__ == "__main__":
    main()
