"""The colours of a print in a photograph, and how much of the cloth has each."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Array
from swifttailor.picture_reader.flat_cloth import FlatCloth
from swifttailor.picture_reader.lit_cloth import hex_of, lit

_SAMPLE, _SEED, _GROUPS, _ROUNDS = 2500, 0, 4, 15
_APART = 14.0
"""In Lab; what is nearer is one colour."""
_BETWEEN = 0.35
"""What lies nearer to the line between two other colours, in its lengths, is where they meet."""
_PURE = 0.5
"""Share of the pixels of a colour that are least like the others: thin lines are blurred."""
_FAINTEST = 5.0
"""In Lab: how far apart two colours are at least where one is blurred into the other."""


def print_colors(cloth: FlatCloth, most: int, least: float) -> list[tuple[str, float]]:
    """Colours of a print and their shares, that of most cloth first; none where there is but one.

    Args:
        cloth: That has it.
        most: Colours that are told.
        least: Share of the cloth that each has to have.
    """
    flat = cloth.flat[cloth.inside] + np.median(cloth.lab[cloth.inside], axis=0)
    middles = _middles(flat)
    shares = np.bincount(_nearest(flat, middles), minlength=len(middles)) / len(flat)
    kept = [int(k) for k in np.argsort(-shares, kind="stable") if shares[k] >= least]
    kept = [k for k in kept if not _is_between(k, kept, middles)][:most]
    return _lit_colors(cloth, flat, middles[kept]) if len(kept) > 1 else []


def blurred_colors(cloth: FlatCloth) -> list[tuple[str, float]]:
    """The same of a print so fine that its two colours are blurred into each other."""
    flat = cloth.flat[cloth.inside] + np.median(cloth.lab[cloth.inside], axis=0)
    ends = _both_ends(flat, cloth.main[cloth.inside])
    return _lit_colors(cloth, flat, ends) if len(ends) else []


def _lit_colors(cloth: FlatCloth, flat: Array, middles: Array) -> list[tuple[str, float]]:
    """Colours as they are in full light, of those (k, 3) of the evenly lit cloth (n, 3)."""
    numbers, lab, found = _nearest(flat, middles), cloth.lab[cloth.inside], []
    for k in range(len(middles)):
        here = numbers == k
        others = np.delete(middles, k, axis=0)
        away = np.linalg.norm(flat[here][:, None] - others, axis=2).min(axis=1)
        pure = lab[here][away >= np.quantile(away, 1 - _PURE)]
        found.append((hex_of(lit(pure)), float(here.mean())))
    return sorted(found, key=lambda one: -one[1])


def _both_ends(flat: Array, main: Array) -> Array:
    """Two colours (2, 3) that are blurred into each other; none (0, 3) where they are hardly two."""
    low, high = main <= np.quantile(main, 0.25), main >= np.quantile(main, 0.75)
    ends = np.array([flat[low].mean(axis=0), flat[high].mean(axis=0)])
    return ends if np.linalg.norm(ends[1] - ends[0]) >= _FAINTEST else ends[:0]


def _middles(flat: Array) -> Array:
    """Colours (k, 3) of evenly lit cloth (n, 3), by k-means; those that are alike are one."""
    from scipy.cluster.hierarchy import fcluster, linkage

    rng = np.random.default_rng(_SEED)
    drawn = flat[rng.choice(len(flat), min(_SAMPLE, len(flat)), replace=False)]
    middles = drawn[:1]
    while len(middles) < 2 * _GROUPS:
        apart = ((drawn[:, None] - middles) ** 2).sum(axis=2).min(axis=1)
        if apart.sum() <= 0.0:
            break
        middles = np.vstack([middles, drawn[rng.choice(len(drawn), p=apart / apart.sum())]])
    for _ in range(_ROUNDS):
        numbers = _nearest(drawn, middles)
        middles = np.array([drawn[numbers == k].mean(axis=0) for k in np.unique(numbers)])
    if len(middles) < 2:
        return middles
    numbers, joined = _nearest(drawn, middles), fcluster(linkage(middles, "average"), _APART, "distance")
    of_each = joined[numbers]
    return np.array([drawn[of_each == k].mean(axis=0) for k in np.unique(of_each)])


def _nearest(colors: Array, middles: Array) -> NDArray[np.intp]:
    from scipy.cluster.vq import vq

    return np.asarray(vq(colors, middles)[0], np.intp)


def _is_between(k: int, kept: list[int], middles: Array) -> bool:
    """Whether a colour lies between two others, as where threads cross or edges are blurred."""
    for a in kept:
        for b in kept:
            if a < b and k not in (a, b):
                line = middles[b] - middles[a]
                along = float((middles[k] - middles[a]) @ line / (line @ line))
                off = float(np.linalg.norm(middles[k] - middles[a] - along * line))
                if 0.1 < along < 0.9 and off < _BETWEEN * float(np.linalg.norm(line)):
                    return True
    return False
