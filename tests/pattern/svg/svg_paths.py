"""An independent reading of SVG path data, after the SVG 1.1 specification (appendix F.6 for arcs)."""

from __future__ import annotations

import math
import re

import numpy as np

_TOKEN = re.compile(r"[MLQCAZ]|-?\d+\.?\d*(?:[eE][-+]?\d+)?")
_ARITY = {"M": 2, "L": 2, "Q": 4, "C": 6, "A": 7, "Z": 0}


class Piece:
    """One drawing command from its start point on."""

    def __init__(self, kind: str, start: np.ndarray, values: list[float]) -> None:
        self.kind, self.start, self.values = kind, start, values
        self.end = np.array(values[-2:])

    def points(self, t: np.ndarray) -> np.ndarray:
        """Points (n, 2) at curve parameters (n,)."""
        if self.kind == "A":
            center, radius, angle, sweep = self._arc()
            return center + radius * np.stack([np.cos(angle + t * sweep), np.sin(angle + t * sweep)], axis=1)
        control = np.concatenate([[self.start], np.reshape(self.values, (-1, 2))])
        degree = len(control) - 1
        basis = np.stack([math.comb(degree, k) * t**k * (1 - t) ** (degree - k) for k in range(degree + 1)])
        return basis.T @ control

    def length(self) -> float:
        if self.kind == "A":
            _, radius, _, sweep = self._arc()
            return radius * abs(sweep)
        if self.kind == "L":
            return float(np.hypot(*(self.end - self.start)))
        control = np.concatenate([[self.start], np.reshape(self.values, (-1, 2))])
        degree = len(control) - 1
        nodes, weights = np.polynomial.legendre.leggauss(12)
        total = 0.0
        for k in range(200):
            t = (k + (nodes + 1) / 2) / 200
            hodograph = degree * np.diff(control, axis=0)
            basis = np.stack(
                [math.comb(degree - 1, i) * t**i * (1 - t) ** (degree - 1 - i) for i in range(degree)]
            )
            total += float(weights @ np.hypot(*(basis.T @ hodograph).T)) / 400
        return total

    def _arc(self) -> tuple[np.ndarray, float, float, float]:
        radius, other, turn, large, sweep_flag = self.values[:5]
        assert radius == other and turn == 0 and {large, sweep_flag} <= {0.0, 1.0}
        half = (self.start - self.end) / 2
        radius = max(radius, float(np.hypot(*half)))
        root = math.sqrt(max(radius**2 / float(half @ half) - 1.0, 0.0))
        sign = 1.0 if large != sweep_flag else -1.0
        center = sign * root * np.array([half[1], -half[0]])
        one, two = half - center, -half - center
        angle = math.atan2(one[1], one[0])
        sweep = (math.atan2(two[1], two[0]) - angle) % (2 * math.pi)
        if not sweep_flag:
            sweep -= 2 * math.pi
        return center + (self.start + self.end) / 2, radius, angle, sweep


def pieces(data: str) -> list[Piece]:
    """The drawing commands of path data; the closing line of Z is left out when it has no length."""
    tokens = _TOKEN.findall(data)
    assert "".join(tokens) == re.sub(r"[\s,]", "", data), "nothing in the path may go unread"
    found, at, first, k = [], np.zeros(2), np.zeros(2), 0
    while k < len(tokens):
        kind = tokens[k]
        values = [float(v) for v in tokens[k + 1 : k + 1 + _ARITY[kind]]]
        k += 1 + _ARITY[kind]
        if kind == "M":
            at = first = np.array(values)
        elif kind == "Z":
            if not np.array_equal(at, first):
                found.append(Piece("L", at, list(first)))
        else:
            found.append(Piece(kind, at, values))
            at = found[-1].end
    return found
