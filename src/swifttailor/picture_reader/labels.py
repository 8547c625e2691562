"""What can be read of a picture, in the order of the network's outputs."""

from __future__ import annotations

import hashlib
import json
from functools import cache

from swifttailor.describing.claims import CLAIM_TYPES
from swifttailor.describing.dimensions import DIMENSIONS
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.picture_reader.panel_kinds import PANEL_KINDS

PARTS: tuple[str, ...] = ("upper", "lower")
"""What a person wears: a garment that covers the upper body, whole dresses and jumpsuits included; and skirts
and trousers."""
VIEW: tuple[str, ...] = ("sine", "cosine", "elevation", "scale", "right", "down")
"""How the camera looks at the wearer; see `picture_reader.view`."""
GUESS: tuple[str, ...] = (*VIEW, "known")
"""What the network is told of the camera before it looks: where it was seen to be and 1, or zeros."""
MASK_STRIDE = 4
"""Pixels of a picture to a cell of the masks."""
BOX: tuple[str, ...] = ("x", "y", "z", "width", "height")
"""Middle of a placed panel and the sides of its flat outline, cm."""


@cache
def statement_labels() -> tuple[tuple[str, str], ...]:
    """Claim and word of everything that can be said without a number."""
    return tuple((kind.name, word) for kind in CLAIM_TYPES.values() for word in kind.words)


@cache
def measure_labels() -> tuple[str, ...]:
    """Names of the dimensions that are measured."""
    return tuple(DIMENSIONS)


@cache
def topics() -> tuple[str, ...]:
    """What is looked at together: each claim, dimension and kind of panels, and the garment itself."""
    claims = (claim for claim, _ in statement_labels())
    kinds = map(panel_topic, PANEL_KINDS)
    return tuple(dict.fromkeys([*claims, *measure_labels(), *kinds, "garment"]))


def panel_topic(kind: str) -> str:
    """The topic of a kind of panels."""
    return f"panels: {kind}"


def labels_checksum() -> str:
    """Of all labels in their order."""
    said = [PARTS, statement_labels(), measure_labels(), PANEL_NAMES, BOX, VIEW]
    return hashlib.sha256(json.dumps(said).encode()).hexdigest()
