"""Inputs that failed once, kept for good: every run feeds them again."""

from __future__ import annotations

from pathlib import Path

CORPUS = Path(__file__).parents[1] / "tests" / "fuzzing" / "corpus"


def corpus_of(target: str) -> list[Path]:
    """The kept inputs of a target."""
    return sorted(path for path in (CORPUS / target).glob("*") if path.is_file())
