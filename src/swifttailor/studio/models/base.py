"""What all models have in common, and the numbers that bound them."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, StringConstraints, model_validator

from swifttailor.garment.cloth_print import PRINT, stated_print

Severity = Literal["error", "warning", "info"]
Part = Literal["upper", "lower", "whole"]
FabricName = Literal[
    "cotton",
    "linen",
    "twill",
    "denim",
    "silk",
    "chiffon",
    "wool",
    "leather",
    "polyester",
    "jersey",
    "rib-knit",
    "sweatshirt",
    "ponte",
    "fleece",
    "swimwear",
]
"""Those of `draping.known_fabrics`."""
Unit = Literal["cm", "pieces", "times"]
UnitOrNone = Literal["", "cm", "pieces", "times"]
Source = Literal["text", "picture", "pattern"]

MOST_LETTERS = 2000
"""Of a prompt or an instruction."""
LARGEST_SEED = 2**31 - 1
Seed = Annotated[int, Field(ge=0, le=LARGEST_SEED)]
Prompt = Annotated[str, StringConstraints(max_length=MOST_LETTERS)]
Title = Annotated[str, StringConstraints(max_length=200)]
Color = Annotated[str, StringConstraints(pattern="^#[0-9a-f]{6}$")]
Identifier = Annotated[str, StringConstraints(pattern="^[A-Za-z0-9_-]{8,64}$")]
MeshName = Annotated[str, StringConstraints(pattern="^[0-9a-f]{32}$")]
EdgeLength = Annotated[float, Field(ge=1.0, le=5.0)]
"""Of a mesh, cm."""
Figure = Literal["women", "men", "children"]
BodyName = Annotated[str, StringConstraints(max_length=200)]
MeasureName = Annotated[str, StringConstraints(pattern="^[a-z_]{2,40}$")]
Measures = Annotated[dict[MeasureName, Annotated[float, Field(ge=0, le=1000)]], Field(max_length=60)]
"""Of a body, by name, cm; which there are, and what is accepted, the body says."""
PatternJson = dict[str, Any]
"""GarmentCode's specification; the reader of patterns looks into it."""


class Model(BaseModel):
    """A body: numbers are finite, and unknown fields are refused so that slips are noticed."""

    model_config = ConfigDict(allow_inf_nan=False, extra="forbid", populate_by_name=True)


class PartLook(Model):
    """How a part of a garment looks, where that is otherwise than the rest: `garment.part_looks`."""

    part: Annotated[str, StringConstraints(pattern="^[a-z_]{2,20}$")]
    color: Color | None = None
    cloth: Annotated[str, StringConstraints(pattern="^[a-z]{2,20}$")] | None = None
    opacity: Annotated[float, Field(ge=0.0, le=1.0)] | None = None
    printed: bool | None = None


PartLooks = Annotated[list[PartLook], Field(max_length=64)]

PrintKind = Literal["stripes", "checks", "plaid", "dots", "motif"]
"""Those of `garment.cloth_print`, as what follows."""
PrintMotif = Literal[
    "flowers",
    "leaves",
    "blotches",
    "spots",
    "shapes",
    "bands",
    "hearts",
    "stars",
    "moons",
    "bolts",
    "cherries",
    "strawberries",
    "lemons",
    "mushrooms",
    "foxes",
    "cats",
    "bears",
    "rabbits",
    "birds",
    "butterflies",
    "bees",
    "fishes",
    "dinosaurs",
    "anchors",
    "boats",
    "splatters",
    "cranes",
    "elephants",
    "dogs",
    "horses",
    "flamingos",
    "owls",
    "turtles",
    "pineapples",
    "skulls",
    "snowflakes",
    "crosses",
    "leopard",
    "zebra",
    "tiger",
    "giraffe",
    "cowhide",
    "dalmatian",
    "scales",
    "crocodile",
    "tie_dye",
    "batik",
    "marble",
    "clouds",
    "bleach",
    "ikat",
    "palms",
    "paisley",
    "lozenges",
    "argyle",
    "patchwork",
    "serape",
    "medallions",
    "waves",
    "triangles",
    "curls",
    "cables",
    "sequins",
    "pile",
    "foil",
    "channels",
    "fur",
    "marl",
    "linen",
    "sprigs",
    "penguins",
    "pandas",
    "sharks",
    "whales",
    "unicorns",
    "parrots",
    "tigers",
    "rockets",
    "cacti",
    "daisies",
    "sunflowers",
    "galaxy",
    "camouflage",
    "zigzag",
    "herringbone",
    "rainbow",
    "ombre",
    "blocks",
    "aztec",
    "wax_print",
    "two_blocks",
    "four_blocks",
    "houndstooth",
    "granny_squares",
    "palm_trees",
]
PrintSize = Literal["width", "gap", "spacing", "radius", "repeat", "angle"]
PrintColors = Annotated[list[Color], Field(min_length=2, max_length=6)]


class ClothPrint(Model):
    """What is printed on the cloth: `garment.cloth_print`."""

    kind: PrintKind
    colors: PrintColors
    motif: PrintMotif = "shapes"
    sizes: dict[PrintSize, float] = Field(default_factory=dict)
    """Cm, the angle in degrees."""

    @model_validator(mode="after")
    def _can_be_drawn(self) -> ClothPrint:
        if stated_print({PRINT: self.model_dump()}) is None:
            raise ValueError("sizes of a print are 0.05 to 200 cm, its angle -360 to 360 degrees")
        return self


class ErrorInfo(Model):
    """What went wrong, for people."""

    code: str
    """Stable kebab-case name."""
    message: str
    hint: str = ""
    """What to do next."""


class ErrorAnswer(Model):
    """The body of every answer that is an error."""

    error: ErrorInfo
