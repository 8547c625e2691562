"""What relaxing brings by how crumpled garments came out.

``python benchmarks/relaxing_limit.py DRAPES/validation --limit 150``

Every garment is sewn and relaxed as `generate` does, and compared with its drape before and after:
mean distance of vertices, Chamfer distance, and crossings of edges and faces. Means over the garments of
each range of crumpled cloth.
"""

from __future__ import annotations

import argparse
import itertools
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from machine import describe
from swifttailor.arrays import Floats
from swifttailor.data.reader import SplitReader
from swifttailor.draping.intersections import self_intersections
from swifttailor.errors import SwiftTailorError
from swifttailor.evaluation.garments.cloud_distances import chamfer
from swifttailor.evaluation.garments.score import draw_clouds
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.relaxing import relaxed
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.panel_mesh.topology import edge_faces

LIMITS = (0.0, 0.02, 0.05, 0.12, 0.25, 0.35, 0.5, 1.0)


@dataclass(frozen=True)
class Compared:
    """A garment beside its drape."""

    vertex_cm: float
    chamfer_cm2: float
    crossings: int

    @staticmethod
    def of(vertices: Floats, drape: Garment, number: int) -> Compared:
        """Compares positions of the drape's own mesh."""
        clouds = draw_clouds(vertices, drape, seed=0, number=number)
        faces = drape.mesh.faces
        return Compared(
            float(np.linalg.norm(vertices - drape.vertices, axis=1).mean()),
            chamfer(clouds.points, clouds.reference),
            self_intersections(vertices, edge_faces(faces)[0], faces),
        )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("data", type=Path, help="a split of drapes")
    parser.add_argument("--limit", type=int, default=150, help="garments, from all over the split")
    options = parser.parse_args()
    reader, sewer = SplitReader(options.data), GarmentSewer.load()
    found = []
    for number in range(0, len(reader.ids), max(1, len(reader.ids) // options.limit)):
        sample = reader[number]
        try:
            made = sewer.sew(sample.pattern, edge_length=sample.edge_length)
            fallen = relaxed(made)
        except SwiftTailorError:
            continue
        shapes = (made.vertices, fallen.vertices, sample.garment.vertices)
        compared = [Compared.of(vertices, sample.garment, number) for vertices in shapes]
        found.append((made.report["sewing"]["crumpled"], compared))
    print(describe())
    print(f"{len(found)} garments; as sewn / relaxed (/ the drape)")
    for low, high in itertools.pairwise(LIMITS):
        rows = [compared for share, compared in found if low <= share < high or share == high == 1.0]
        if rows:
            print(f"{low:.0%} to {high:.0%}, {len(rows)}: {_means(rows)}")


def _means(rows: list[list[Compared]]) -> str:
    columns = list(zip(*rows, strict=True))
    vertex = " / ".join(f"{np.mean([c.vertex_cm for c in column]):.2f}" for column in columns[:2])
    area = " / ".join(f"{np.mean([c.chamfer_cm2 for c in column]):.2f}" for column in columns[:2])
    crossings = " / ".join(f"{np.mean([c.crossings for c in column]):.0f}" for column in columns)
    return f"vertices {vertex} cm, CD {area} cm2, crossings {crossings}"


if __name__ == "__main__":
    main()
