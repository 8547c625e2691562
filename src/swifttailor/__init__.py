"""SwiftTailor: from words or a picture to a sewing pattern and its stitched 3D garment.

All public names are here, each with this one import path. They are loaded on first use, so that
``import swifttailor`` and ``swifttailor --help`` stay fast.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.first_use import loaded_on_first_use

if TYPE_CHECKING:
    from swifttailor.body import Body, body_for
    from swifttailor.describing import Claim
    from swifttailor.draping import Engine, Fabric, Settled, SewnGarment, drape, register_engine
    from swifttailor.errors import SwiftTailorError
    from swifttailor.garment import Garment
    from swifttailor.garment_sewer.sewer import GarmentSewer
    from swifttailor.pattern import (
        Arc,
        Cubic,
        Edge,
        EdgeRef,
        Finding,
        Line,
        Panel,
        Pattern,
        Placement,
        Quadratic,
        Stitch,
        load_pattern,
    )
    from swifttailor.pattern import check_pattern as check
    from swifttailor.pattern import repair_pattern as repair
    from swifttailor.pattern.drafts import draft
    from swifttailor.pattern_maker.maker import PatternMaker, WrittenPattern
    from swifttailor.recutting import alter
    from swifttailor.refitting import draft_design, fit
    from swifttailor.tailor import Tailor
    from swifttailor.tailor.one_pattern import sew
    from swifttailor.tailor.protocols import PatternWriter, Sewer
    from swifttailor.wording.description import describe

__version__ = "0.1.0"

_PUBLIC = {
    "Arc": "pattern",
    "Body": "body",
    "Claim": "describing",
    "Cubic": "pattern",
    "Edge": "pattern",
    "EdgeRef": "pattern",
    "Engine": "draping",
    "Fabric": "draping",
    "Finding": "pattern",
    "Garment": "garment",
    "GarmentSewer": "garment_sewer.sewer",
    "Line": "pattern",
    "Panel": "pattern",
    "Pattern": "pattern",
    "PatternMaker": "pattern_maker.maker",
    "PatternWriter": "tailor.protocols",
    "Placement": "pattern",
    "Quadratic": "pattern",
    "Settled": "draping",
    "Sewer": "tailor.protocols",
    "SewnGarment": "draping",
    "Stitch": "pattern",
    "SwiftTailorError": "errors",
    "Tailor": "tailor",
    "WrittenPattern": "pattern_maker.maker",
    "alter": "recutting",
    "body_for": "body",
    "check": "pattern:check_pattern",
    "describe": "wording.description",
    "draft": "pattern.drafts",
    "draft_design": "refitting",
    "drape": "draping",
    "fit": "refitting",
    "load_pattern": "pattern",
    "register_engine": "draping",
    "repair": "pattern:repair_pattern",
    "sew": "tailor.one_pattern",
}
"""Where each name is found, and what it is called there where that differs."""

__all__ = [
    "Arc",
    "Body",
    "Claim",
    "Cubic",
    "Edge",
    "EdgeRef",
    "Engine",
    "Fabric",
    "Finding",
    "Garment",
    "GarmentSewer",
    "Line",
    "Panel",
    "Pattern",
    "PatternMaker",
    "PatternWriter",
    "Placement",
    "Quadratic",
    "Settled",
    "Sewer",
    "SewnGarment",
    "Stitch",
    "SwiftTailorError",
    "Tailor",
    "WrittenPattern",
    "__version__",
    "alter",
    "body_for",
    "check",
    "describe",
    "draft",
    "draft_design",
    "drape",
    "fit",
    "load_pattern",
    "register_engine",
    "repair",
    "sew",
]


__getattr__ = loaded_on_first_use(__name__, _PUBLIC)


def __dir__() -> list[str]:
    return __all__
