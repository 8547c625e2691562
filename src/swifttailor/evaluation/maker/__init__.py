"""A PatternMaker is asked for patterns that are known, and its answers are measured (paper, Sec. 5)."""

from __future__ import annotations
