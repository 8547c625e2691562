"""Strips of fur: around a collar or a hood, and along neck, hem and ends of sleeves."""

from __future__ import annotations

from swifttailor.pattern.pattern import EdgeRef
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.free_edges import hem_edges, hood_edges, neck_edges, sleeve_ends
from swifttailor.pattern.trims.shapes import Frill, Trim

_WIDE_CM = 5.0
"""Width of a strip, cm."""


def neck_fur(chalk: Chalk, name: str) -> list[Trim]:
    """A strip around the face on a hood, else along the collar or the neck."""
    return _along(chalk, name, hood_edges(chalk.pattern) or neck_edges(chalk.pattern))


def sleeve_fur(chalk: Chalk, name: str) -> list[Trim]:
    """A strip around the end of each sleeve."""
    return _along(chalk, name, sleeve_ends(chalk.pattern))


def fur_trim(chalk: Chalk, name: str) -> list[Trim]:
    """A strip along neck or hood, hem and ends of sleeves."""
    pattern = chalk.pattern
    top = hood_edges(pattern) or neck_edges(pattern)
    edges = dict.fromkeys([*top, *hem_edges(pattern), *sleeve_ends(pattern)])
    return _along(chalk, name, tuple(edges))


def _along(chalk: Chalk, name: str, edges: tuple[EdgeRef, ...]) -> list[Trim]:
    if not edges:
        return []
    length = sum(chalk.pattern.edge_length(ref) for ref in edges)
    return [Frill(name, edges, _WIDE_CM * chalk.size, length, "flat")]
