"""What a sewing pattern is (paper, Sec. 3.1): panels, edges, placements, stitches; reading and writing.

May import the lowest floors (errors, files) only, and of other packages numpy, scipy and shapely.
"""

from __future__ import annotations

from swifttailor.pattern.check import check_pattern, repair_pattern
from swifttailor.pattern.curve import Arc, Cubic, Curve, Line, Quadratic
from swifttailor.pattern.finding import Finding, Severity
from swifttailor.pattern.garmentcode_reader import (
    Reading,
    load_pattern,
    read_pattern_file,
    read_specification,
)
from swifttailor.pattern.garmentcode_writer import to_specification, write_pattern
from swifttailor.pattern.names import PANEL_NAMES, body_region
from swifttailor.pattern.panel import Edge, Panel, Placement
from swifttailor.pattern.pattern import EdgeRef, Pattern, Stitch

__all__ = [
    "PANEL_NAMES",
    "Arc",
    "Cubic",
    "Curve",
    "Edge",
    "EdgeRef",
    "Finding",
    "Line",
    "Panel",
    "Pattern",
    "Placement",
    "Quadratic",
    "Reading",
    "Severity",
    "Stitch",
    "body_region",
    "check_pattern",
    "load_pattern",
    "read_pattern_file",
    "read_specification",
    "repair_pattern",
    "to_specification",
    "write_pattern",
]
