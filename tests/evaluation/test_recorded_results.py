"""The page of results is that of the recorded runs beside it."""

from __future__ import annotations

from pathlib import Path

from swifttailor.evaluation.results_page import results_page

DOCS = Path(__file__).parents[2] / "docs"


def test_the_page_is_made_of_the_recorded_runs():
    runs = sorted((DOCS / "results").glob("*.json"))
    assert len(runs) >= 3
    assert (DOCS / "results.md").read_text(encoding="utf-8") == results_page(runs)
