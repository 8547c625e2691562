"""What a picture shows, of the answers of a picture reader's network."""

from __future__ import annotations

from typing import Any

import numpy as np

from swifttailor.picture_reader.figures import FIGURES
from swifttailor.picture_reader.labels import PARTS
from swifttailor.picture_reader.reading import PartReading, PictureReading, SeenCells
from swifttailor.picture_reader.said import (
    LEAST_PRESENT,
    certainties,
    measures_said,
    panels_said,
    share_of,
    statements_said,
)
from swifttailor.picture_reader.seen_design import SeenDesign
from swifttailor.picture_reader.squares import box_of, mask_of
from swifttailor.picture_reader.view import Square, camera_of
from swifttailor.programs.read_parameter import ReadParameter

DESIGNS = "designs"
"""Said besides by a network that has learnt to read design parameters."""
_CM = 100.0


def reading_of(
    first: dict[str, Any],
    whole: Square,
    seen: dict[int, tuple[Square, dict[str, Any]]],
    shape: tuple[int, int],
    parameters: tuple[ReadParameter, ...],
) -> PictureReading:
    """What a picture shows, of what is said of it.

    Args:
        first: Answers of a network that tell the camera and how many people there are, by name.
        whole: The square that it looked at.
        seen: By number of the part of the body: a square, and what is said of what is worn there.
        shape: Of the picture, (h, w).
        parameters: Whose designs are said; none where they are not.
    """
    parts = [
        _part(k, square, answers, shape, parameters)
        for k, (square, answers) in seen.items()
        if share_of(answers["present"][k]) >= LEAST_PRESENT
    ]
    parts.sort(key=lambda part: -part.certainty)
    square, view = whole, first["camera_view"]
    if parts:
        square, answers = seen[PARTS.index(parts[0].part)]
        view = answers["camera_view"]
    figures = certainties(first["figures"])
    return PictureReading(
        tuple(parts),
        camera_of(view),
        box_of(square),
        FIGURES[int(figures.argmax())],
        float(figures.max()),
    )


def _part(
    number: int,
    square: Square,
    answers: dict[str, Any],
    shape: tuple[int, int],
    parameters: tuple[ReadParameter, ...],
) -> PartReading:
    mask = share_of(answers["masks"][number])
    return PartReading(
        PARTS[number],
        float(share_of(answers["present"][number])),
        statements_said(answers["statements"][number]),
        measures_said(answers["has"][number], answers["measures"][number]),
        panels_said(answers["panels"][number], answers["boxes"][number]),
        mask_of(mask, square, shape),
        SeenCells(
            box_of(square),
            mask.astype(np.float32),
            answers["worn_places"].transpose(1, 2, 0) * _CM,
            answers["panel_kinds"].argmax(axis=0).astype(np.uint8),
        ),
        SeenDesign.of_logits(parameters, answers[DESIGNS][number]) if parameters else None,
    )
