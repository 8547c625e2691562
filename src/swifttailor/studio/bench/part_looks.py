"""Colour, print and looks of parts of a garment, between requests, garments and documents."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, replace
from typing import Any

from swifttailor.garment.cloth_print import PRINT, ClothPrint, stated_print
from swifttailor.garment.garment import Garment
from swifttailor.garment.lace import mean_opacity
from swifttailor.garment.part_looks import (
    LOOKS,
    USUAL_LOOK,
    PanelLook,
    PartLook,
    has_part,
    looks_of_panels,
    stated_looks,
)


def looks_read(looks: Sequence[dict[str, Any]]) -> tuple[PartLook, ...]:
    """Looks as a request has them; those that cannot be drawn are left out."""
    return stated_looks({LOOKS: list(looks)})


def print_read(said: dict[str, Any] | None) -> ClothPrint | None:
    """A print as a request has it."""
    return stated_print({PRINT: said})


def print_shown(found: ClothPrint | None) -> dict[str, Any] | None:
    """A print as documents have it."""
    return None if found is None else found.to_json()


def in_cloth(
    garment: Garment,
    color: str | None,
    looks: Sequence[dict[str, Any]],
    print: dict[str, Any] | None = None,
) -> Garment:
    """A garment in the cloth that a client shows it in.

    Args:
        garment: As it was sewn.
        color: Of its cloth, ``#rrggbb``; its own when None.
        looks: Of its parts, as a request has them.
        print: On it, as a request has it; its own when None.
    """
    kept = tuple([look for look in looks_read(looks) if has_part(garment.pattern, look.part)])
    return replace(
        garment,
        color=color or garment.color,
        print=print_read(print) or garment.print,
        looks=kept or garment.looks,
    )


def looks_of(garment: Garment | None) -> dict[str, Any]:
    """Which parts of a garment look otherwise than the rest, and the panels that these are."""
    if garment is None or not garment.looks:
        return {"parts": [], "panels": {}}
    panels = zip(garment.pattern.panels, looks_of_panels(garment), strict=True)
    return {
        "parts": [asdict(look) for look in garment.looks],
        "panels": {
            panel.name: {
                "color": look.color,
                "opacity": round(_shown_opacity(look), 3),
                "printed": look.color is None and not look.lace,
            }
            for panel, look in panels
            if look != USUAL_LOOK
        },
    }


def _shown_opacity(look: PanelLook) -> float:
    return mean_opacity(look.opacity) if look.lace and look.is_sheer else look.opacity
