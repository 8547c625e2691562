"""One table as text, as CSV and as LaTeX."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from dataclasses import dataclass

from swifttailor.evaluation.text_table import Column, Row, text_table

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


def _latex(text: str) -> str:
    return "".join(_SPECIAL.get(letter, letter) for letter in text)
