"""One table as text, as CSV, as LaTeX, as Markdown, and as JSON values."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from swifttailor.errors import InputError
from swifttailor.evaluation.text_table import NOTHING, Column, Row, text_table

_SPECIAL = {
    "\\": r"\textbackslash{}",
    "&": r"\&",
    "%": r"\%",
    "#": r"\#",
    "_": r"\_",
    "$": r"\$",
    "{": r"\{",
    "}": r"\}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
}


@dataclass(frozen=True)
class Table:
    """Rows of numbers under a title."""

    title: str
    note: str
    """What has to be known to read it."""
    columns: Sequence[Column]
    rows: Sequence[Row]

    def text(self) -> str:
        """For people."""
        return f"== {self.title} ==\n\n{self.note}\n\n{text_table(self.columns, self.rows)}"

    def csv(self) -> str:
        """One line for each row, the table's title first; numbers in full."""
        stream = io.StringIO()
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(["table", "row", *(c.heading for c in self.columns)])
        for name, values in self.rows:
            writer.writerow([self.title, name.strip(), *("" if v is None else v for v in values)])
        return stream.getvalue()

    def latex(self) -> str:
        """A ``table`` with a ``tabular`` in it; needs the package booktabs."""
        heads = " & ".join(["", *(_latex(c.heading) for c in self.columns)])
        lines = []
        for name, values in self.rows:
            cells = [
                "--" if v is None else format(v, c.format) for v, c in zip(values, self.columns, strict=True)
            ]
            indent = r"\quad " if name.startswith(" ") else ""
            lines.append(" & ".join([indent + _latex(name.strip()), *cells]) + r" \\")
        body = "\n".join(lines)
        return (
            "\\begin{table}\n\\centering\n"
            f"\\caption{{{_latex(self.title)}. {_latex(' '.join(self.note.split()))}}}\n"
            f"\\begin{{tabular}}{{l{'r' * len(self.columns)}}}\n\\toprule\n{heads} \\\\\n\\midrule\n{body}\n"
            "\\bottomrule\n\\end{tabular}\n\\end{table}\n"
        )

    def markdown(self) -> str:
        """A section of a page."""
        heads = ["", *(_markdown(c.heading) for c in self.columns)]
        lines = [_line(heads), _line(["---", *["---:"] * len(self.columns)])]
        for name, values in self.rows:
            cells = [
                NOTHING if v is None else format(v, c.format)
                for v, c in zip(values, self.columns, strict=True)
            ]
            lines.append(_line([_markdown(name.strip()), *cells]))
        note = " ".join(self.note.split())
        return f"### {self.title}\n\n{note}\n\n" + "\n".join(lines) + "\n"

    def to_json(self) -> dict[str, Any]:
        """Plain JSON values."""
        return {
            "title": self.title,
            "note": self.note,
            "columns": [[c.heading, c.format] for c in self.columns],
            "rows": [[name, list(values)] for name, values in self.rows],
        }

    @staticmethod
    def of_json(value: Any) -> Table:
        """Reads what `to_json` gives.

        Raises:
            InputError: It is something else.
        """
        try:
            columns = [Column(str(heading), str(form)) for heading, form in value["columns"]]
            rows: list[Row] = []
            for name, values in value["rows"]:
                numbers = [_number(v) for v in values]
                if len(numbers) != len(columns):
                    raise ValueError(
                        f"the row {name!r} has {len(numbers)} numbers for {len(columns)} columns"
                    )
                rows.append((str(name), numbers))
            table = Table(str(value["title"]), str(value["note"]), columns, rows)
            table.text()  # formats that are none
        except (KeyError, TypeError, ValueError) as error:
            raise InputError(f"A recorded table is damaged: {error!r}.") from error
        return table


def _number(value: Any) -> float | int | None:
    if value is not None and (isinstance(value, bool) or not isinstance(value, int | float)):
        raise TypeError(f"{value!r} is no number")
    return value


def _line(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"


def _markdown(text: str) -> str:
    return text.replace("\\", "\\\\").replace("|", "\\|").replace("*", "\\*").replace("_", "\\_")


def _latex(text: str) -> str:
    return "".join(_SPECIAL.get(letter, letter) for letter in text)
