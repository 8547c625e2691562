"""How long it takes to read what people type.

``python benchmarks/hearing_speed.py [--rounds 3] [--limit N]``

The building half's wishes are read as ``generate`` reads them, and nothing is made. Prints the median and the
slowest in milliseconds, of each round.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import time

from machine import describe
from people_prompts import WORDS, read_people_prompts
from swifttailor.errors import SwiftTailorError
from swifttailor.tailor import Order, Tailor


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--limit", type=int, help="so many wishes; all without it")
    options = parser.parse_args()
    texts = [one.text for one in read_people_prompts(WORDS / "building" / "prompts.jsonl")][: options.limit]
    tailor = Tailor.load()
    milliseconds(tailor, texts[0])  # networks and tables are opened with the first
    sys.stdout.write(f"{describe()}; {len(texts)} texts\n")
    for _ in range(options.rounds):
        # Another text between two readings of one: what was read last is remembered.
        taken = [milliseconds(tailor, text) for text in texts]
        sys.stdout.write(f"median {statistics.median(taken):.2f} ms, slowest {max(taken):.1f}\n")


def milliseconds(tailor: Tailor, text: str) -> float:
    """Reads a text."""
    begun = time.perf_counter()
    try:
        tailor.read(Order(text))
    except SwiftTailorError:  # it asks for no garment: that has been read, too
        pass
    return 1000 * (time.perf_counter() - begun)


if __name__ == "__main__":
    main()
