"""Somebody else's physics, a dozen lines: it gets the sewn garment and returns it at rest.

python examples/engine_of_your_own.py
"""

import numpy as np

import swifttailor


class Lightweight:
    """Cloth without weight: every vertex goes to the middle of its neighbours, and out of the body."""

    def settle(self, sewn, progress):
        positions, edges = sewn.positions, sewn.cloth.arrays.edges
        both = np.concatenate([edges, edges[:, ::-1]])
        degree = np.bincount(both[:, 0], minlength=len(positions))[:, None]
        for step in range(10):
            total = np.zeros_like(positions)
            np.add.at(total, both[:, 0], positions[both[:, 1]])
            positions = 0.5 * positions + 0.5 * total / degree
            progress("draping", step / 10)
        distance, _ = sewn.body.signed_distance(positions)
        outward = positions * [1.0, 0.0, 1.0]
        outward /= np.linalg.norm(outward, axis=1, keepdims=True)
        positions += np.maximum(0.5 - distance, 0.0)[:, None] * outward
        return swifttailor.Settled(positions, frames=10, static=True)


swifttailor.register_engine("lightweight", Lightweight)
garment = swifttailor.drape(swifttailor.draft("fitted-skirt"), engine="lightweight", edge_length=4.0)
print(garment.report["quality"])
assert garment.report["engine"] == "lightweight"
assert np.isfinite(garment.vertices).all()
