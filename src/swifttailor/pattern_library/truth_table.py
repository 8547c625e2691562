"""What is true of many patterns, side by side."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import InputError
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.picture_reader.labels import BOX, measure_labels, statement_labels
from swifttailor.picture_reader.truth import TRUE, UNCLEAR, Truth
from swifttailor.picture_reader.units import MEASURE_CM

BOX_UNIT_CM = 0.05
"""Of boxes in packed arrays, 16-bit numbers: up to 16 m."""
_REACH = 2**15 - 1


@dataclass(frozen=True, eq=False)
class TruthTable:
    """`Truth` of N patterns; boxes only of the R panels that they have."""

    part: NDArray[np.uint8]
    """(N,) of `PARTS`."""
    statements: NDArray[np.uint8]
    """(N, S) `truth.FALSE`, `TRUE` or `UNCLEAR`."""
    measures: NDArray[np.float32]
    """(N, M) cm, pieces or ratios; NaN where there is no such thing."""
    panels: NDArray[np.uint8]
    """(N, P) 1 for panel names that the pattern has."""
    boxes: NDArray[np.float32]
    """(R, 5) `BOX` of each panel, pattern by pattern."""

    @staticmethod
    def of(truths: Sequence[Truth]) -> TruthTable:
        """Of some patterns, at least one."""
        return TruthTable(
            np.array([t.part for t in truths], np.uint8),
            np.stack([t.statements for t in truths]),
            np.stack([t.measures for t in truths]),
            np.stack([t.panels for t in truths]),
            np.concatenate([t.boxes[t.panels > 0] for t in truths]).astype(np.float32),
        )

    def __len__(self) -> int:
        return len(self.part)

    def __getitem__(self, k: int) -> Truth:
        boxes = np.zeros((len(PANEL_NAMES), len(BOX)), np.float32)
        boxes[self.panels[k] > 0] = self.boxes[self.owner == k]
        return Truth(int(self.part[k]), self.statements[k], self.measures[k], self.panels[k], boxes)

    def take(self, rows: Sequence[int] | NDArray[Any]) -> TruthTable:
        """Of some of them, in that order."""
        places = np.asarray(rows, np.intp)
        of_row = np.split(self.boxes, np.cumsum(self.panels.sum(axis=1, dtype=np.intp))[:-1])
        boxes = [of_row[k] for k in places] or [np.zeros((0, len(BOX)), np.float32)]
        return TruthTable(
            self.part[places],
            self.statements[places],
            self.measures[places],
            self.panels[places],
            np.concatenate(boxes),
        )

    @cached_property
    def owner(self) -> NDArray[np.intp]:
        """(R,) which pattern a panel belongs to."""
        return np.nonzero(self.panels)[0]

    @cached_property
    def name(self) -> NDArray[np.intp]:
        """(R,) number of a panel's name."""
        return np.nonzero(self.panels)[1]

    @cached_property
    def true(self) -> NDArray[np.float32]:
        """(N, S) 1 where a statement is true, a half on the border, 0 where it is false."""
        return np.array([0.0, 1.0, 0.5], np.float32)[self.statements]

    @cached_property
    def named(self) -> NDArray[np.float32]:
        """(N, P) `panels`, to multiply with."""
        return self.panels.astype(np.float32)

    @cached_property
    def has(self) -> NDArray[np.float32]:
        """(N, M) 1 where there is something to measure."""
        return np.isfinite(self.measures).astype(np.float32)

    @cached_property
    def scaled(self) -> NDArray[np.float32]:
        """(N, M) measures as the picture reader has them (`units.MEASURE_CM`); 0 where there are none."""
        return scaled(np.nan_to_num(self.measures, nan=0.0))

    def packed(self) -> dict[str, NDArray[Any]]:
        """As few bytes as will do; `unpacked` is the inverse, but for roundings."""
        whole = np.clip(np.round(self.boxes / BOX_UNIT_CM), -_REACH, _REACH)
        return {
            "part": self.part,
            "true": np.packbits(self.statements == TRUE, axis=1),
            "unclear": np.packbits(self.statements == UNCLEAR, axis=1),
            "measures": self.measures.astype(np.float16),
            "panels": np.packbits(self.panels > 0, axis=1),
            "boxes": whole.astype(np.int16),
        }

    @staticmethod
    def unpacked(arrays: dict[str, NDArray[Any]]) -> TruthTable:
        """From `packed` arrays.

        Raises:
            InputError: They are not those of a table.
        """
        statements, count = len(statement_labels()), len(arrays["part"])
        kinds = {
            "part": (np.uint8, (count,)),
            "true": (np.uint8, (count, -(-statements // 8))),
            "unclear": (np.uint8, (count, -(-statements // 8))),
            "measures": (np.float16, (count, len(measure_labels()))),
            "panels": (np.uint8, (count, -(-len(PANEL_NAMES) // 8))),
        }
        for name, (kind, shape) in kinds.items():
            if arrays[name].dtype != kind or arrays[name].shape != shape:
                found = f"{arrays[name].dtype} of shape {arrays[name].shape}"
                raise InputError(f"Its '{name}' is {found}; {np.dtype(kind)} of shape {shape} is expected.")
        panels = np.unpackbits(arrays["panels"], axis=1, count=len(PANEL_NAMES))
        boxes = arrays["boxes"]
        if boxes.dtype != np.int16 or boxes.shape != (int(panels.sum()), len(BOX)):
            raise InputError(f"It has {int(panels.sum())} panels and boxes of shape {boxes.shape}.")
        true, unclear = (np.unpackbits(arrays[n], axis=1, count=statements) for n in ("true", "unclear"))
        return TruthTable(
            arrays["part"],
            true * np.uint8(TRUE) + unclear * np.uint8(UNCLEAR),
            arrays["measures"].astype(np.float32),
            panels,
            boxes * np.float32(BOX_UNIT_CM),
        )


def scaled(measures: Any) -> Any:
    """Measures in the unit in which the picture reader is as wrong about small as about large ones."""
    return np.arcsinh(np.asarray(measures, np.float32) / MEASURE_CM)
