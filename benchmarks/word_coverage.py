"""How many words of a list the lexicon knows: python benchmarks/word_coverage.py FILE, one word a line."""

from __future__ import annotations

import argparse
from pathlib import Path

from swifttailor.wording.lexicon import read_words

WORN = frozenset({"garments", "accessories"})


def main() -> None:
    """Counts and prints what is not known."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file", type=Path)
    lines = parser.parse_args().file.read_text(encoding="utf-8").splitlines()
    words = list(dict.fromkeys(line.strip() for line in lines if line.strip()))
    readings = {word: read_words(word, language="en") for word in words}
    unknown = [word for word, reading in readings.items() if reading.unknown]
    worn = [w for w, r in readings.items() if any(e.category in WORN for m in r.marks for e in m.entries)]
    known = len(words) - len(unknown)
    print(f"{known} of {len(words)} known ({known / max(len(words), 1):.0%}), {len(worn)} as something worn")
    print("not known: " + ", ".join(unknown))


if __name__ == "__main__":
    main()
