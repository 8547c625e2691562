"""Files to sew from: pieces with allowance and notches; PDF, DXF, markers and sewing steps.

May import describing, garment and what lies below them.
"""

from __future__ import annotations

from swifttailor.making.allowances import Allowances
from swifttailor.making.piece import Piece
from swifttailor.making.pieces import CuttingPlan, cutting_plan

__all__ = ["Allowances", "CuttingPlan", "Piece", "cutting_plan"]
