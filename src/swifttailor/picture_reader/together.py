"""What several pictures of one garment show together."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import TypeVar

from swifttailor.picture_reader.reading import PartReading, SeenPanel, Statement
from swifttailor.picture_reader.seen_design import SeenDesign

T = TypeVar("T")


def together(parts: Sequence[PartReading]) -> PartReading:
    """Of each subject what the picture says that is surest of it: a front shows the neckline, a back the zip.

    Whether there is a panel, all pictures say, each as much as the others.

    Args:
        parts: Of the same part of the body, one a picture; at least one. The mask is that of the first.
    """
    first = parts[0]
    if len(parts) == 1:
        return first
    said: list[Statement] = []
    for name in dict.fromkeys(s.claim.name for part in parts for s in part.statements):
        of_each = [[s for s in part.statements if s.claim.name == name] for part in parts]
        said += max(of_each, key=lambda found: max((s.certainty for s in found), default=0.0))
    return replace(
        first,
        certainty=max(part.certainty for part in parts),
        statements=tuple(sorted(said, key=lambda s: -s.certainty)),
        measures=_best((m for part in parts for m in part.measures), lambda m: m.name, lambda m: -m.off),
        panels=_panels(parts),
        design=_design([part.design for part in parts]),
    )


def _design(seen: Sequence[SeenDesign | None]) -> SeenDesign | None:
    """None where one did not read the same parameters."""
    found = [one for one in seen if one is not None]
    if len(found) < len(seen) or any(one.parameters != found[0].parameters for one in found):
        return None
    return SeenDesign.together(found)


def _panels(parts: Sequence[PartReading]) -> tuple[SeenPanel, ...]:
    """The box of the surest, and the mean of how sure all are."""
    best = _best((p for part in parts for p in part.panels), lambda p: p.name, lambda p: p.certainty)
    sure: dict[str, float] = {}
    for part in parts:
        for panel in part.panels:
            sure[panel.name] = sure.get(panel.name, 0.0) + panel.certainty / len(parts)
    found = (replace(panel, certainty=sure[panel.name]) for panel in best)
    return tuple(sorted(found, key=lambda panel: -panel.certainty))


def _best(found: Iterable[T], name: Callable[[T], str], worth: Callable[[T], float]) -> tuple[T, ...]:
    """The best of each name."""
    best: dict[str, T] = {}
    for one in found:
        known = best.get(name(one))
        if known is None or worth(one) > worth(known):
            best[name(one)] = one
    return tuple(best.values())
