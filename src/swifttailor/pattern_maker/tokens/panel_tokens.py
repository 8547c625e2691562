"""The panels of a sequence of tokens, one by one; and the mirrored panel as GarmentCode would write it."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Singles
from swifttailor.pattern_maker.tokens.normalization import (
    POINT_SCALE,
    POINT_SHIFT,
    TRANSLATION_SCALE,
    TRANSLATION_SHIFT,
)
from swifttailor.pattern_maker.tokens.token_sequence import NUMBER_MASK, TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import (
    CLOSING_COMMANDS,
    COMMANDS,
    CONTROL_1,
    CONTROL_2,
    EDGE_LABEL_TOKENS,
    EDGE_LABELS,
    END,
    MID,
    MOVE,
    NOT_STITCHED,
    NUMBERS,
    PANEL_LABEL_TOKENS,
    PANEL_TOKENS,
    QUATERNION,
    RIGHT_WRONG,
    STITCH_TOKENS,
)

SAME = 0.02
"""Normalised units (0.5 cm): panels that differ by less from each other's reflection are symmetric."""
_CUBIC = 2


@dataclass(frozen=True, eq=False)
class EdgeTokens:
    """An edge as it is written."""

    kind: int
    """Of its curve, 0 to 3 in the order of `COMMANDS`."""
    numbers: Singles
    """(8,), its end included where it does not close the panel."""
    label: int | None
    right_wrong: bool
    stitch: int
    """Its tag's token, or `NOT_STITCHED`."""


@dataclass(frozen=True, eq=False)
class PanelTokens:
    """A panel as it is written."""

    name: int
    """Class id."""
    label: int | None
    """Token, where it is not the usual one."""
    placement: Singles
    """(8,)."""
    edges: tuple[EdgeTokens, ...]


@dataclass(eq=False)
class PanelCollector:
    """Puts panels together while their tokens come."""

    panels: dict[int, PanelTokens] = field(default_factory=dict)
    """The finished ones, by class id."""
    name: int = -1
    label: int | None = None
    placement: Singles = field(default_factory=lambda: np.zeros(NUMBERS, np.float32))
    edges: list[EdgeTokens] = field(default_factory=list)
    """Of the panel that is being written, the one that is being written included."""
    _closing: bool = False

    def add(self, token: int, numbers: NDArray[np.floating]) -> None:
        """Takes in a token that the grammar allows, and its numbers (8,)."""
        if token in PANEL_TOKENS:
            self.name, self.label, self.edges = token - PANEL_TOKENS.start, None, []
            self._closing = False
        elif token in PANEL_LABEL_TOKENS:
            self.label = token
        elif token == MOVE:
            self.placement = np.array(numbers, np.float32)
        elif token in COMMANDS or token in CLOSING_COMMANDS:
            self._closing = token in CLOSING_COMMANDS
            kind = (token - COMMANDS.start) % len(COMMANDS)
            self.edges.append(EdgeTokens(kind, np.array(numbers, np.float32), None, False, NOT_STITCHED))
        elif token in EDGE_LABEL_TOKENS:
            self.edges[-1] = replace(self.edges[-1], label=token)
        elif token == RIGHT_WRONG:
            self.edges[-1] = replace(self.edges[-1], right_wrong=True)
        elif token == NOT_STITCHED or token in STITCH_TOKENS:
            self.edges[-1] = replace(self.edges[-1], stitch=token)
            if self._closing:
                self.panels[self.name] = PanelTokens(self.name, self.label, self.placement, tuple(self.edges))


def panels_of(sequence: TokenSequence) -> dict[int, PanelTokens]:
    """The panels of a sequence that the grammar allows, by class id."""
    collector = PanelCollector()
    for token, numbers in zip(sequence.tokens.tolist(), sequence.numbers, strict=True):
        collector.add(token, numbers)
    return collector.panels


def mirrored(panel: PanelTokens, name: int) -> PanelTokens:
    """The panel on the other side of the body.

    GarmentCode makes it by reflection, which turns the loop around: it begins at the same corner, and the
    edge that was the last is the first.

    Args:
        panel: On one side.
        name: Class id of the other.
    """
    count = len(panel.edges)
    edges = []
    for k in range(count):
        old = panel.edges[count - 1 - k]
        numbers = np.zeros(NUMBERS, np.float32)
        if k < count - 1:
            numbers[END] = panel.edges[count - 2 - k].numbers[END]
        first, second = (CONTROL_2, CONTROL_1) if old.kind == _CUBIC else (CONTROL_1, CONTROL_2)
        numbers[CONTROL_1], numbers[CONTROL_2] = old.numbers[first], old.numbers[second]
        numbers[MID] = old.numbers[MID]
        for part in (END, CONTROL_1, CONTROL_2, MID):
            numbers[part] = _reflected(numbers[part], POINT_SHIFT, POINT_SCALE)
        token = (CLOSING_COMMANDS if k == count - 1 else COMMANDS)[old.kind]
        label = None if old.label is None else _OTHER_LABEL[old.label]
        edges.append(replace(old, numbers=numbers * NUMBER_MASK[token], label=label, right_wrong=False))
    placement = np.array(panel.placement)
    placement[:3] = _reflected(placement[:3], TRANSLATION_SHIFT, TRANSLATION_SCALE)
    placement[QUATERNION] *= [1, -1, -1, 1]
    return PanelTokens(name, panel.label, placement, tuple(edges))


def are_alike(one: PanelTokens, other: PanelTokens, tolerance: float) -> bool:
    """Whether two panels have the same edges with numbers that differ by less, placement included."""
    return [e.kind for e in one.edges] == [e.kind for e in other.edges] and all(
        np.abs(a - b).max() < tolerance
        for a, b in [
            (one.placement, other.placement),
            *((a.numbers, b.numbers) for a, b in zip(one.edges, other.edges, strict=True)),
        ]
    )


def _reflected(
    values: NDArray[np.floating], shift: NDArray[np.floating], scale: NDArray[np.floating]
) -> Singles:
    """Normalised coordinates (d,) with the first one's sign changed in cm."""
    values = np.array(values, np.float32)
    values[0] = -values[0] - 2 * shift[0] / scale[0]
    return values


def _other_label(label: str) -> str:
    for one, other in (("left", "right"), ("right", "left")):
        if label.startswith(one):
            return label.replace(one, other)
    return label


_OTHER_LABEL = {
    token: EDGE_LABEL_TOKENS[EDGE_LABELS.index(_other_label(label))]
    for token, label in zip(EDGE_LABEL_TOKENS, EDGE_LABELS, strict=True)
}
