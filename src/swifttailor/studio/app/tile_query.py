"""A print as the query of an address, so that its tile can be kept by browsers."""

from __future__ import annotations

from pydantic import model_validator

from swifttailor.studio.models.base import ClothPrint, Model, PrintColors, PrintKind, PrintMotif, PrintSize


class TileQuery(Model):
    """What `models.base.ClothPrint` has, one value beside the other."""

    kind: PrintKind
    colors: PrintColors
    motif: PrintMotif = "shapes"
    width: float | None = None
    gap: float | None = None
    spacing: float | None = None
    radius: float | None = None
    repeat: float | None = None
    angle: float | None = None

    @model_validator(mode="after")
    def _can_be_drawn(self) -> TileQuery:
        self.as_print()
        return self

    def as_print(self) -> ClothPrint:
        """The print."""
        given: dict[PrintSize, float | None] = {
            "width": self.width,
            "gap": self.gap,
            "spacing": self.spacing,
            "radius": self.radius,
            "repeat": self.repeat,
            "angle": self.angle,
        }
        sizes = {name: value for name, value in given.items() if value is not None}
        return ClothPrint(kind=self.kind, colors=self.colors, motif=self.motif, sizes=sizes)
