"""The losses written plainly, pixel by pixel, from their descriptions in `LossWeights`."""

from __future__ import annotations

import numpy as np


def mean_error(predicted, target, chosen):
    """Mean over chosen pixels (B, H, W) of the absolute error summed over x, y and z of (B, 3, H, W)."""
    values = []
    for b, r, c in zip(*np.nonzero(chosen), strict=True):
        values.append(sum(abs(float(predicted[b, k, r, c] - target[b, k, r, c])) for k in range(3)))
    return float(np.mean(values))


def points(image, index):
    """(n, 3) values of an image at flat indices into (B, H, W)."""
    _, _, height, width = image.shape
    return np.array([image[i // (height * width), :, i // width % height, i % width] for i in index])


def chamfer(image, sides):
    """Mean over stitches of the squared Chamfer distance."""
    totals = []
    for a, b in sides:
        p, q = points(image, a[a >= 0]), points(image, b[b >= 0])
        there = np.mean([min(((x - y) ** 2).sum() for y in q) for x in p])
        back = np.mean([min(((x - y) ** 2).sum() for y in p) for x in q])
        totals.append(there + back)
    return float(np.mean(totals))


def seam_pairs(predicted, target, pairs):
    """Mean over pairs of the absolute error of the vector between them."""
    p, q = (points(predicted, pairs[:, k]) for k in (0, 1))
    s, t = (points(target, pairs[:, k]) for k in (0, 1))
    return float(np.abs((p - q) - (s - t)).sum(axis=1).mean())


def normals(image, panel):
    """Total variation of the unit normals of cells of four pixels of one panel."""
    batch, _, height, width = image.shape
    normal = {}
    for b in range(batch):
        for r in range(height - 1):
            for c in range(width - 1):
                corners = {int(panel[b, r + i, c + j]) for i in (0, 1) for j in (0, 1)}
                if len(corners) == 1 and min(corners) >= 0:
                    first = image[b, :, r + 1, c + 1] - image[b, :, r, c]
                    second = image[b, :, r + 1, c] - image[b, :, r, c + 1]
                    n = np.cross(first, second)
                    normal[b, r, c] = n / np.linalg.norm(n)
    differences = []
    for (b, r, c), n in normal.items():
        for other in ((b, r + 1, c), (b, r, c + 1)):
            if other in normal:
                differences.append(np.abs(n - normal[other]).sum())
    return float(np.mean(differences))


def neighbours(panel, contour):
    """Pairs of pixels ((b, r, c), (b, r', c')) with cloth between them, in the four directions."""
    batch, height, width = panel.shape
    for b in range(batch):
        for r in range(height):
            for c in range(width):
                for i, j in ((0, 1), (1, 0), (1, 1), (1, -1)):
                    if r + i < height and 0 <= c + j < width:
                        same = panel[b, r, c] == panel[b, r + i, c + j] >= 0
                        if same and not (contour[b, r, c] and contour[b, r + i, c + j]):
                            yield (b, r, c), (b, r + i, c + j)


def gradient(predicted, target, panel, contour):
    """Mean absolute error of the steps between neighbours, per pixel apart."""
    values = []
    for (b, r, c), (_, s, d) in neighbours(panel, contour):
        step = (predicted[b, :, s, d] - predicted[b, :, r, c]) - (target[b, :, s, d] - target[b, :, r, c])
        values.append(np.abs(step).sum() / np.hypot(s - r, d - c))
    return float(np.mean(values))


def stretch(image, local, panel, contour, tolerance):
    """Length beyond (1 + tolerance) of the flat distance, over the sum of the flat distances."""
    excess = whole = 0.0
    for (b, r, c), (_, s, d) in neighbours(panel, contour):
        flat = np.linalg.norm(local[b, :, s, d] - local[b, :, r, c])
        length = np.linalg.norm(image[b, :, s, d] - image[b, :, r, c])
        excess += max(0.0, length - (1 + tolerance) * flat)
        whole += flat
    return float(excess / whole)
