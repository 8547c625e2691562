"""Times drapes of three drafts, stage by stage, in one process: ``make bench``.

The first drape is left out of the table: it loads (or compiles) the solver and the body's distances.
"""

from __future__ import annotations

import argparse
import time

import swifttailor

DRAFTS = ("t-shirt", "fitted-dress", "circle-skirt")
STAGES = ("meshing", "preparing", "sewing", "draping", "measuring")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--edge-length", type=float, default=2.0, help="cm")
    parser.add_argument("--repeat", type=int, default=3, help="the fastest of so many is shown")
    options = parser.parse_args()
    started = time.perf_counter()
    swifttailor.drape(swifttailor.draft(DRAFTS[0]), edge_length=8.0)
    print(f"first drape: {time.perf_counter() - started:.1f} s")
    print(f"{'draft':<14}{'vertices':>9}{'frames':>8}" + "".join(f"{s:>11}" for s in (*STAGES, "total")))
    for name in DRAFTS:
        pattern = swifttailor.draft(name)
        reports = [
            swifttailor.drape(pattern, edge_length=options.edge_length).report for _ in range(options.repeat)
        ]
        best = min(reports, key=lambda r: sum(r["seconds"].values()))
        seconds = best["seconds"]
        cells = [seconds.get(s, 0.0) for s in STAGES] + [sum(seconds.values())]
        frames = best["quality"]["frames"]
        print(f"{name:<14}{best['vertices']:>9}{frames:>8}" + "".join(f"{c:>9.2f} s" for c in cells))


if __name__ == "__main__":
    main()
