"""How much lower than measured on their patterns the hems of dresses and skirts hang once they are draped.

``python benchmarks/hem_levels.py SPLIT``, a folder that `swifttailor data build` has made
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from machine import describe
from swifttailor.data.reader import SplitReader
from swifttailor.describing.measuring import measure_facts

LEVELS = ((-np.inf, 15.0), (15.0, 50.0), (50.0, np.inf))
"""Heights of hems above the floor, cm."""


def main() -> None:
    """Prints by how much the lowest hundredth of the vertices lies above the measured level of the hem."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("split", type=Path)
    split = SplitReader(parser.parse_args().split)
    measured: list[tuple[bool, float, float]] = []
    for k in range(len(split)):
        garment = split[k].garment
        facts = measure_facts(garment.pattern)
        if facts.hem is not None and facts.kind in ("dress", "skirt"):
            low = float(np.percentile(garment.vertices[:, 1], 1))
            measured.append((facts.kind == "dress", facts.hem.level, low - facts.hem.level))
    print(describe())
    for dress in (True, False):
        for low, high in LEVELS:
            found = [by for is_dress, level, by in measured if is_dress == dress and low <= level < high]
            if found:
                quantiles = ", ".join(f"{q:.1f}" for q in np.percentile(found, (10, 50, 90)))
                print(f"{'dresses' if dress else 'skirts'} {low} to {high} cm, {len(found)}: {quantiles} cm")


if __name__ == "__main__":
    main()
