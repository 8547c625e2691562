"""What stands where in a panel tensor: (panel slots, edge slots, numbers)."""

from __future__ import annotations

from swifttailor.pattern.curve import Arc, Cubic, Line, Quadratic
from swifttailor.pattern.names import EDGE_LABELS, PANEL_NAMES

SLOTS = PANEL_NAMES
"""One slot for each name of GarmentCode. No two panels of a pattern share a name, so names are kept.
SewingLDM has 39 slots, of which skirts and trousers share some, and their names are lost."""
EDGES = 37
"""Edge slots of a panel, taken from its first edge on."""
STEP = slice(0, 2)
"""From the start of the edge to its end, panel-local cm."""
QUADRATIC = slice(2, 4)
CUBIC = slice(4, 8)
"""Control points relative to the chord."""
BEND = 8
"""Of an arc: the chord by the diameter, 0 to 1. SewingLDM has the radius, which for nearly straight arcs is
metres long."""
TAG = slice(9, 12)
"""Of a stitched edge: the mean of the end points of both stitched edges, world cm; the same on both."""
TURN = slice(12, 16)
"""Rotation of the panel as a quaternion x, y, z, w; the same on each of its edges."""
PLACE = slice(16, 19)
"""World position of the mean of the panel's corners, cm; the same on each of its edges."""
LARGE, RIGHT = 19, 20
"""Flags of an arc."""
KIND = slice(21, 23)
LABEL = slice(23, 26)
"""Which of `KINDS` and `LABELS`, in bits, the lowest first."""
FREE = 26
"""Whether the edge is not stitched."""
REVERSED = 27
"""Whether its stitch is ``right_wrong``."""
THERE = 28
"""Whether there is such an edge; all else is 0 where there is none."""
NUMBERS = 29
CONTINUOUS = slice(0, 19)
BITS = slice(19, 29)
SHAPE = len(SLOTS), EDGES, NUMBERS
KINDS = Line, Quadratic, Cubic, Arc
LABELS = "", *EDGE_LABELS
