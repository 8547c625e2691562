"""The numbers of the paper's tables, to stand beside ours. What they leave unsaid: docs/evaluation.md."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class GarmentRow:
    """A row of the tables on garments; None where a table lacks the column."""

    name: str
    chamfer: float | None
    """The paper gives no unit. cm^2 is the one that fits its numbers."""
    emd: float | None
    """Likewise cm."""
    mmd: float
    coverage: float
    """Share, 0 to 1."""
    attempts: float | None = None
    """#Sampling: mean number of patterns that were generated until one could be made into a garment."""


@dataclass(frozen=True)
class PatternRow:
    """A row of the tables on patterns; the rates are percentages."""

    name: str
    vertex_cm: float
    panel_accuracy: float
    edge_accuracy: float
    rotation: float
    translation_cm: float
    stitch_accuracy: float


ABLATION = (
    GarmentRow("GarmentSewer without semantic image", 35.77, 9.90, 11.96, 0.49),
    GarmentRow("GarmentSewer, L_reg", 9.84, 5.95, 7.38, 0.58),
    GarmentRow("GarmentSewer, L_reg + L_stitch", 3.40, 4.48, 3.36, 0.88),
)
"""Table "Ablation on semantic UV map and auxiliary losses". Whose patterns were sewn is not said; MMD below
the 5.31 of generated patterns suggests the true ones."""

FROM_IMAGE_AND_TEXT = (
    GarmentRow("AIpparel + GarmentCode", None, None, 6.94, 0.52, 4.27),
    GarmentRow("AIpparel + GarmentSewer", None, None, 6.03, 0.63, 4.27),
    GarmentRow("ChatGarment + GarmentCode", None, None, 12.27, 0.22, 1.20),
    GarmentRow("ChatGarment + GarmentSewer", None, None, 12.56, 0.23, 1.20),
    GarmentRow("SewingLDM + GarmentCode", None, None, 11.33, 0.34, 5.87),
    GarmentRow("SewingLDM + GarmentSewer", None, None, 10.96, 0.41, 5.87),
    GarmentRow("PatternMaker + GarmentCode", None, None, 6.82, 0.54, 2.98),
    GarmentRow("PatternMaker + GarmentSewer", None, None, 5.31, 0.68, 2.98),
)
"""Garments generated from a picture and a text: all combinations of generator and constructor."""

FROM_IMAGE = (
    GarmentRow("AIpparel + GarmentCode", None, None, 6.95, 0.52, 3.93),
    GarmentRow("ChatGarment + GarmentCode", None, None, 11.64, 0.22, 1.31),
    GarmentRow("SewingLDM + GarmentCode", None, None, 10.56, 0.37, 2.07),
    GarmentRow("PatternMaker + GarmentCode", None, None, 6.82, 0.56, 2.93),
    GarmentRow("PatternMaker + GarmentSewer", None, None, 5.23, 0.68, 2.93),
)
"""Garments generated from a picture alone."""

FROM_TEXT = (
    GarmentRow("AIpparel + GarmentCode", None, None, 8.59, 0.39, 3.76),
    GarmentRow("ChatGarment + GarmentCode", None, None, 12.89, 0.20, 1.15),
    GarmentRow("SewingLDM + GarmentCode", None, None, 19.97, 0.26, 4.80),
    GarmentRow("PatternMaker + GarmentCode", None, None, 8.58, 0.43, 2.70),
    GarmentRow("PatternMaker + GarmentSewer", None, None, 7.80, 0.42, 2.70),
)
"""Garments generated from a text alone."""

PATTERNS_FROM_IMAGE_AND_TEXT = (
    PatternRow("AIpparel", 4.8, 93.7, 79.0, 0.007, 2.5, 73.0),
    PatternRow("ChatGarment", 14.9, 16.4, 49.7, 0.038, 15.4, 38.2),
    PatternRow("SewingLDM", 15.6, 18.0, 49.0, 0.052, 16.6, 30.6),
    PatternRow("PatternMaker", 3.5, 94.8, 92.3, 0.006, 1.9, 85.1),
)
"""Patterns generated from a picture and a text."""

EDITED_PATTERNS = (
    PatternRow("AIpparel", 2.5, 82.9, 88.2, 0.002, 1.7, 86.3),
    PatternRow("ChatGarment", 13.5, 19.6, 60.3, 0.036, 10.1, 55.2),
    PatternRow("PatternMaker", 1.5, 85.0, 98.0, 0.002, 1.3, 97.8),
)
"""Patterns edited after an instruction."""

PATTERNS_FROM_IMAGE = (
    PatternRow("AIpparel", 5.18, 89.94, 75.76, 0.007, 2.51, 71.04),
    PatternRow("ChatGarment", 16.47, 14.05, 39.08, 0.057, 19.99, 30.58),
    PatternRow("SewingLDM", 19.41, 15.42, 42.77, 0.107, 25.04, 28.17),
    PatternRow("PatternMaker", 3.70, 91.04, 88.96, 0.006, 1.91, 83.69),
)
"""Patterns generated from a picture alone."""
