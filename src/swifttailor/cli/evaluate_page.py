"""``swifttailor evaluate page``: one page of the tables of recorded runs."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from swifttailor.cli.postponed_imports import tyro
from swifttailor.errors import InputError


@dataclass(frozen=True, kw_only=True)
class EvaluatePage:
    """Write one page (Markdown) with the tables of recorded runs of evaluate systems or pattern-maker.

    Exit code 0: done; 2: not done.
    """

    runs: Annotated[tuple[Path, ...], tyro.conf.Positional, tyro.conf.arg(metavar="SUMMARY...")]
    """Files summary.json of evaluate systems or pattern-maker; the headings are their names."""
    out: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """File to write; prints the page without it."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace FILE where it is there already."""

    def run(self) -> int:
        """Reads, writes and returns the exit code.

        Raises:
            InputError: A run cannot be read, or the file not be written.
        """
        from swifttailor.evaluation.results_page import results_page

        if not self.runs:
            raise InputError(
                "No runs were given. Give the summary.json of at least one evaluate systems or pattern-maker."
            )
        page = results_page(self.runs)
        if self.out is None:
            sys.stdout.write(page)
        else:
            from swifttailor.atomic_files import write_text

            write_text(self.out, page, overwrite=self.overwrite)
        return 0
