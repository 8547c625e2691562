"""How the cost of a drape grows with the mesh, from 1,000 to 50,000 vertices, for a fixed number of frames.

``python benchmarks/drape_scaling.py``
"""

from __future__ import annotations

import argparse

import swifttailor
from machine import describe
from swifttailor.draping.simulation import SimulationSettings


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--draft", default="fitted-dress")
    parser.add_argument("--edge-lengths", type=float, nargs="+", default=[3.2, 2.0, 1.4, 1.0, 0.65, 0.46])
    options = parser.parse_args()
    swifttailor.drape(swifttailor.draft("tank-top"), edge_length=8.0)
    print(describe())
    print(
        f"{options.draft}: {'edge, cm':>9}{'vertices':>10}{'mesh, s':>9}{'frames, s':>11}"
        f"{'us/vertex/frame':>17}"
    )
    # A share of moving vertices that cannot be reached keeps the number of frames the same.
    settings = SimulationSettings(max_frames=100, still_share=-1.0)
    total = settings.sewing_frames + settings.settling_frames + settings.max_frames
    pattern = swifttailor.draft(options.draft)
    for edge_length in options.edge_lengths:
        garment = swifttailor.drape(pattern, edge_length=edge_length, settings=settings)
        seconds = garment.report["seconds"]
        moving = seconds["sewing"] + seconds["draping"]
        count = len(garment.vertices)
        print(
            f"{'':<{len(options.draft) + 2}}{edge_length:>9.2f}{count:>10}{seconds['meshing']:>9.2f}"
            f"{moving:>11.2f}{moving / total / count * 1e6:>17.2f}"
        )


if __name__ == "__main__":
    main()
