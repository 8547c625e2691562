"""The body of the package with a quarter of its faces, for pictures whose pixels show more than they do.

``python scripts/make_coarse_body.py [--faces 6000]`` writes ``body/coarse_body.npz``.

Edges are collapsed onto one of their ends, the least harm first (quadric errors, Garland and Heckbert 1997),
on the default body. As vertices are only left out, every body of the same mesh has its coarse one by the same
numbers.
"""

from __future__ import annotations

import argparse
import heapq

import numpy as np

from swifttailor.body import Body
from swifttailor.body.coarse_body import COARSE_FILE

_BOUNDARY = 1e-3
"""Weight of the length of an edge beside its quadric error, so that flat places are thinned evenly."""


class Thinning:
    """A closed mesh that loses vertices one by one."""

    def __init__(self, vertices: np.ndarray, faces: np.ndarray) -> None:
        self.at = vertices
        self.faces = [tuple(int(v) for v in face) for face in faces]
        self.alive = len(self.faces)
        self.of = [set() for _ in vertices]
        self.quadrics = np.zeros((len(vertices), 4, 4))
        for t, (a, b, c) in enumerate(self.faces):
            plane = self._plane(a, b, c)
            for v in (a, b, c):
                self.of[v].add(t)
                self.quadrics[v] += np.outer(plane, plane)
        self.turn = [0] * len(vertices)
        self.queue: list[tuple[float, int, int, int, int]] = []
        for a in range(len(vertices)):
            for b in self._around(a):
                self._offer(a, b)

    def run(self, faces: int) -> tuple[np.ndarray, np.ndarray]:
        """Numbers (n,) of the vertices that are left, and faces (m, 3) by their places among these."""
        while self.alive > faces and self.queue:
            _, gone, kept, turn, other = heapq.heappop(self.queue)
            if turn == self.turn[gone] and other == self.turn[kept] and self._sound(gone, kept):
                self._collapse(gone, kept)
        left = np.array([f for f in self.faces if f is not None])
        used = np.unique(left)
        return used, np.searchsorted(used, left)

    def _plane(self, a: int, b: int, c: int) -> np.ndarray:
        """(4,) unit normal and offset, times the root of the area: large faces weigh more."""
        normal = np.cross(self.at[b] - self.at[a], self.at[c] - self.at[a])
        area = float(np.linalg.norm(normal))
        if area < 1e-12:
            return np.zeros(4)
        normal /= area
        return np.append(normal, -normal @ self.at[a]) * np.sqrt(area / 2)

    def _around(self, vertex: int) -> set[int]:
        return {v for t in self.of[vertex] for v in self.faces[t]} - {vertex}

    def _offer(self, gone: int, kept: int) -> None:
        point = np.append(self.at[kept], 1.0)
        harm = point @ (self.quadrics[gone] + self.quadrics[kept]) @ point
        harm += _BOUNDARY * float(((self.at[gone] - self.at[kept]) ** 2).sum())
        heapq.heappush(self.queue, (float(harm), gone, kept, self.turn[gone], self.turn[kept]))

    def _sound(self, gone: int, kept: int) -> bool:
        """Whether the mesh stays a surface and no face turns over."""
        if not self.of[gone] or not self.of[kept]:
            return False
        shared = self.of[gone] & self.of[kept]
        if len(shared) != 2 or len(self._around(gone) & self._around(kept)) != 2:
            return False
        for t in self.of[gone] - shared:
            before = self._plane(*self.faces[t])[:3]
            after = self._plane(*(kept if v == gone else v for v in self.faces[t]))[:3]
            if before @ after <= 0.3 * np.linalg.norm(before) * np.linalg.norm(after):
                return False
        return True

    def _collapse(self, gone: int, kept: int) -> None:
        around = self._around(gone) | self._around(kept)
        for t in list(self.of[gone]):
            face = self.faces[t]
            if kept in face:
                for v in face:
                    self.of[v].discard(t)
                self.faces[t] = None
                self.alive -= 1
            else:
                self.faces[t] = tuple(kept if v == gone else v for v in face)
                self.of[kept].add(t)
        self.of[gone] = set()
        self.quadrics[kept] += self.quadrics[gone]
        self.turn[gone] += 1
        self.turn[kept] += 1
        for v in around - {gone, kept}:
            self._offer(v, kept)
            self._offer(kept, v)


def main() -> None:
    """Thins and writes."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--faces", type=int, default=6000)
    options = parser.parse_args()
    body = Body.default()
    vertices, faces = Thinning(body.vertices, body.faces).run(options.faces)
    np.savez_compressed(COARSE_FILE, vertices=vertices.astype(np.uint16), faces=faces.astype(np.uint16))
    print(f"{len(vertices)} vertices, {len(faces)} faces, {COARSE_FILE.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
