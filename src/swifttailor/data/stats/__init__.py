"""What a data set holds: numbers, contact sheets, and a page to look through."""

from __future__ import annotations

from swifttailor.data.stats.numbers import SplitNumbers, count_split
from swifttailor.data.stats.page import write_page
from swifttailor.data.stats.sheets import Shown, choose, show_sample, write_sheets

__all__ = ["Shown", "SplitNumbers", "choose", "count_split", "show_sample", "write_page", "write_sheets"]
