"""The paper's Alg. 5 and 6 and dynamic time warping as they are written, one pixel at a time."""

from __future__ import annotations

import numpy as np


def remesh(panel, positions):
    """Faces as triples of pixels, anticlockwise with row 0 at the bottom (Alg. 5)."""
    rows, columns = panel.shape
    faces = []
    for row in range(rows - 1):
        for column in range(columns - 1):
            square = [(row, column), (row, column + 1), (row + 1, column + 1), (row + 1, column)]
            valid = [p for p in square if panel[p] >= 0]
            if len(valid) < 3:
                continue
            if len(valid) == 3:
                faces.append(tuple(valid))
                continue
            first = np.linalg.norm(positions[square[0]] - positions[square[2]])
            second = np.linalg.norm(positions[square[1]] - positions[square[3]])
            a, b, c, d = square
            faces += [(a, b, c), (a, c, d)] if first <= second else [(a, b, d), (b, c, d)]
    whole = [face for face in faces if len({int(panel[p]) for p in face}) == 1]
    return [tuple(r * columns + c for r, c in face) for face in whole]


def warp(first, second):
    """Best pairs of two ascending rows, by the table of all sums."""
    sums = np.full((len(first) + 1, len(second) + 1), np.inf)
    sums[0, 0] = 0.0
    for i, a in enumerate(first):
        for j, b in enumerate(second):
            sums[i + 1, j + 1] = abs(a - b) + min(sums[i, j], sums[i, j + 1], sums[i + 1, j])
    i, j, pairs = len(first), len(second), []
    while i and j:
        pairs.append((i - 1, j - 1))
        i, j = min(((i - 1, j - 1), (i - 1, j), (i, j - 1)), key=lambda at: (sums[at], -sum(at) % 2))
    return pairs[::-1]


def stitch(faces, pairs, positions):
    """The place of each pixel's vertex, and faces as triples of vertices (Alg. 6), from pairs of pixels."""
    parent = {p: p for p in [*(p for face in faces for p in face), *(p for pair in pairs for p in pair)]}

    def find(pixel):
        while parent[pixel] != pixel:
            pixel = parent[pixel]
        return pixel

    for one, other in pairs:
        parent[find(one)] = find(other)
    sets = {}
    for pixel in parent:
        sets.setdefault(find(pixel), set()).add(pixel)
    flat = positions.reshape(-1, 3).astype(float)
    place = {pixel: flat[sorted(sets[find(pixel)])].mean(axis=0) for pixel in parent}
    merged = [tuple(find(p) for p in face) for face in faces]
    return place, [face for face in merged if len(set(face)) == 3]
