"""Predicted patterns against true ones: structure, shape, placement, stitches, and what was asked for."""

from __future__ import annotations

from swifttailor.evaluation.patterns.adherence import Adherence, judge_claims, judge_instructions
from swifttailor.evaluation.patterns.aipparel import AipparelScore, aipparel_score
from swifttailor.evaluation.patterns.attempts import Attempts, attempts_of, first_fault
from swifttailor.evaluation.patterns.by_name import NameScore, name_score
from swifttailor.evaluation.patterns.pattern_table import PatternSummary, pattern_tables, summarize_patterns

__all__ = [
    "Adherence",
    "AipparelScore",
    "Attempts",
    "NameScore",
    "PatternSummary",
    "aipparel_score",
    "attempts_of",
    "first_fault",
    "judge_claims",
    "judge_instructions",
    "name_score",
    "pattern_tables",
    "summarize_patterns",
]
