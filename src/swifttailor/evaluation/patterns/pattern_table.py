"""Many predicted patterns against the true ones, as tables beside the paper's rows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

from swifttailor.errors import InputError
from swifttailor.evaluation.mean import Means, mean_in, means_of
from swifttailor.evaluation.paper_rows import PatternRow
from swifttailor.evaluation.patterns.aipparel import AipparelScore, aipparel_score
from swifttailor.evaluation.patterns.by_name import NameScore, name_score
from swifttailor.evaluation.text_table import Column, Row, text_table
from swifttailor.pattern import Pattern


@dataclass(frozen=True)
class PatternSummary:
    """Means over many patterns; every mean has the number of patterns it is over."""

    patterns: int
    missing: int
    """Of which nothing was decoded."""
    aipparel: Means
    """Of `AipparelScore`, by its names."""
    by_name: Means
    """Of `NameScore`: panels, edges, kinds, vertex_cm, translation_cm, rotation, stitch_precision,
    stitch_recall, stitch_f1, sides, structure_right."""


@dataclass(frozen=True)
class PatternScore:
    """One predicted pattern against the true one, by all metrics."""

    missing: bool
    """Whether nothing was decoded."""
    aipparel: AipparelScore
    by_name: NameScore

    def to_json(self) -> dict[str, Any]:
        """Plain JSON values, by the names that `PatternSummary` has."""
        return {
            "missing": self.missing,
            "aipparel": asdict(self.aipparel),
            "by_name": _values(self.by_name),
        }


def score_pattern(predicted: Pattern | None, truth: Pattern) -> PatternScore:
    """Compares a pattern, None where nothing was decoded, with the truth."""
    missing = predicted is None or not predicted.panels
    return PatternScore(missing, aipparel_score(predicted, truth), name_score(predicted, truth))


def summarize_patterns(predicted: Sequence[Pattern | None], truth: Sequence[Pattern]) -> PatternSummary:
    """Compares predictions with the truth and takes means.

    For edits, the truth is the edited pattern; a row of the patterns before the edit, as if they had been
    predicted, shows what copying the input is worth.

    Args:
        predicted: None where nothing was decoded.
        truth: As many.

    Raises:
        InputError: There are none, or not equally many.
    """
    if not truth or len(predicted) != len(truth):
        raise InputError(
            f"Got {len(predicted)} predictions and {len(truth)} true patterns; give equally many, and at "
            "least one, None for a prediction that could not be decoded."
        )
    return summarize_scores([score_pattern(p, t) for p, t in zip(predicted, truth, strict=True)])


def summarize_scores(scores: Sequence[PatternScore]) -> PatternSummary:
    """Takes the means of `score_pattern`; there must be at least one."""
    return PatternSummary(
        patterns=len(scores),
        missing=sum(s.missing for s in scores),
        aipparel=means_of([asdict(s.aipparel) for s in scores]),
        by_name=means_of([_values(s.by_name) for s in scores]),
    )


_AIPPAREL = {
    "vertex_cm": (Column("vertex cm"), 1),
    "panels_right": (Column("panel %", ".1f"), 100),
    "edges_by_name": (Column("edge % by name", ".1f"), 100),
    "edges_in_order": (Column("in order", ".1f"), 100),
    "rotation": (Column("rot", ".4f"), 1),
    "translation_cm": (Column("transl cm"), 1),
    "stitches": (Column("stitch %", ".1f"), 100),
}
_BY_NAME = {
    "panels": (Column("panel F1 %", ".1f"), 100),
    "edges": (Column("edges %", ".1f"), 100),
    "kinds": (Column("kinds %", ".1f"), 100),
    "vertex_cm": (Column("vertex cm"), 1),
    "rotation": (Column("rot", ".4f"), 1),
    "translation_cm": (Column("transl cm"), 1),
    "stitch_precision": (Column("stitch prec %", ".1f"), 100),
    "stitch_recall": (Column("recall %", ".1f"), 100),
    "stitch_f1": (Column("F1 %", ".1f"), 100),
    "sides": (Column("sides %", ".1f"), 100),
    "structure_right": (Column("all right %", ".1f"), 100),
}


def pattern_tables(rows: Sequence[tuple[str, PatternSummary]], paper: Sequence[PatternRow]) -> str:
    """AIpparel's metrics beside the paper's, and those without conditions.

    Args:
        rows: Name and summary of each method.
        paper: Rows of one of the paper's tables.
    """
    return (
        f"{AIPPAREL_NOTE}\n\n{text_table(*aipparel_rows(rows, paper))}\n"
        f"{BY_NAME_NOTE}\n\n{text_table(*by_name_rows(rows))}"
    )


AIPPAREL_NOTE = (
    "AIpparel's metrics. Vertex, rot, transl, stitch and edges in order: only patterns with the right\n"
    "number of panels. The paper does not say which of the edge accuracies it lists."
)
BY_NAME_NOTE = "Without conditions: panels paired by name, a panel that only one pattern has is a failure"


def aipparel_rows(
    rows: Sequence[tuple[str, PatternSummary]], paper: Sequence[PatternRow]
) -> tuple[list[Column], list[Row]]:
    """AIpparel's metrics beside the paper's, as a table; see `pattern_tables`."""
    columns = [
        *(column for column, _ in _AIPPAREL.values()),
        Column("edge % of paper", ".1f"),
        Column("n", "d"),
        Column("n of right count", "d"),
    ]
    lines: list[Row] = []
    for name, found in rows:
        right = found.aipparel["stitches"].count if "stitches" in found.aipparel else 0
        values = [mean_in(found.aipparel, key, factor) for key, (_, factor) in _AIPPAREL.items()]
        lines.append((name, [*values, None, found.patterns, right]))
    for r in paper:
        shape = (r.vertex_cm, r.panel_accuracy, None, None, r.rotation, r.translation_cm, r.stitch_accuracy)
        lines.append((f"paper: {r.name}", [*shape, r.edge_accuracy, None, None]))
    return columns, lines


def by_name_rows(rows: Sequence[tuple[str, PatternSummary]]) -> tuple[list[Column], list[Row]]:
    """The metrics without conditions, as a table; see `pattern_tables`."""
    columns = [*(column for column, _ in _BY_NAME.values()), Column("missing", "d"), Column("n", "d")]
    lines: list[Row] = []
    for name, found in rows:
        values = [mean_in(found.by_name, key, factor) for key, (_, factor) in _BY_NAME.items()]
        lines.append((name, [*values, found.missing, found.patterns]))
    return columns, lines


def _values(score: NameScore) -> dict[str, Any]:
    return {
        "panels": score.panels.f1,
        "edges": score.edges,
        "kinds": score.kinds,
        "vertex_cm": score.vertex_cm,
        "translation_cm": score.translation_cm,
        "rotation": score.rotation,
        "stitch_precision": score.stitches.precision,
        "stitch_recall": score.stitches.recall,
        "stitch_f1": score.stitches.f1,
        "sides": score.sides,
        "structure_right": score.structure_right,
    }
