"""The pipeline (paper, Fig. 3): words, a picture or a pattern in, a pattern and its garment out.

May import both networks' rooms, wishes, recutting and what lies below them.
"""

from __future__ import annotations

from swifttailor.tailor.order import Order
from swifttailor.tailor.tailor import Tailor
from swifttailor.tailor.tailored import Tailored

__all__ = ["Order", "Tailor", "Tailored"]
