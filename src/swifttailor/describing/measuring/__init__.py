"""Measuring a pattern: from panels and stitches to `GarmentFacts`."""

from __future__ import annotations

from swifttailor.describing.measuring.whole_pattern import measure_facts

__all__ = ["measure_facts"]
