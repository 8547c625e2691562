"""The garment of any GarmentCode pattern, without physics, in a fraction of a second.

python examples/sew_a_pattern.py [PATTERN.json]
"""

import sys

import numpy as np

import swifttailor

files = [name for name in sys.argv[1:] if name.endswith(".json")]
pattern = swifttailor.load_pattern(files[0]) if files else swifttailor.draft("hoodie")
made = swifttailor.sew(pattern)
made.save("sewn")

garment = made.garment
print(f"{len(garment.vertices)} vertices, {len(garment.seams)} seams, {sum(made.seconds.values()):.2f} s")
edges = np.sort(garment.faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
_, faces_at_edge = np.unique(edges, axis=0, return_counts=True)
assert faces_at_edge.max() == 2, "a manifold mesh: the seams are closed"
distance, _ = swifttailor.Body.default().signed_distance(garment.vertices)
assert (distance < -0.5).mean() < 0.01, "the cloth lies outside the body"
