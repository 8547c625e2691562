"""A pattern whose draft is drawn again for the body that wears it."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.body import Body
from swifttailor.pattern import Pattern


def redrafted(pattern: Pattern, drawn: Pattern, body: Body) -> Pattern | None:
    """A pattern with the panels of its draft as they are drawn for a body; None where they are others.

    Args:
        pattern: Of the draft, for another body; keeps its name, colours and trims.
        drawn: The draft for the body.
        body: Who wears it.
    """
    if [panel.name for panel in drawn.panels] != [panel.name for panel in pattern.panels]:
        return None
    return replace(pattern, panels=drawn.panels, stitches=drawn.stitches, drafted_for=body.made_for)
