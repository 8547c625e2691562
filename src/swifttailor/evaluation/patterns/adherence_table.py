"""What held of prompts, as a table."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.evaluation.patterns.adherence import Adherence, Share
from swifttailor.evaluation.text_table import Column, Row, text_table


def adherence_table(rows: Sequence[tuple[str, Adherence]]) -> str:
    """Share of the statements that hold, kind by kind.

    Args:
        rows: Name and result of each method, all of the same prompts: the true patterns, ours, by chance, ...
    """
    columns = [Column("n", "d"), *(Column(f"{name} %", ".1f") for name, _ in rows)]
    found = [result for _, result in rows]
    kinds = list(dict.fromkeys(name for result in found for name in result.kinds))
    lines = [_line("all statements", [r.claims for r in found])]
    lines.append(_line("prompts of which all hold", [r.whole for r in found]))
    lines += [_line(kind, [r.kinds.get(kind, Share()) for r in found]) for kind in kinds]
    not_measured = "".join(
        f"{name}: {r.unmeasured} patterns are missing or cannot be measured\n"
        for name, r in rows
        if r.unmeasured
    )
    return text_table(columns, lines) + not_measured


def _line(name: str, shares: Sequence[Share]) -> Row:
    percent = [None if s.share is None else 100 * s.share for s in shares]
    return name, [max((s.made for s in shares), default=0), *percent]
