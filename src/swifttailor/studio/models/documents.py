"""What is known of a pattern and its garment."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from swifttailor.studio.models.base import (
    ClothPrint,
    ErrorInfo,
    FabricName,
    Model,
    Part,
    PartLooks,
    PatternJson,
    Severity,
    Source,
    Unit,
    UnitOrNone,
)

Origin = Literal[
    "example", "generate", "edit", "sew", "finish", "drape", "alter", "repair", "open", "live", "fit"
]
GarmentState = Literal["none", "sewn", "finished", "draped", "stopped"]


class EdgePlace(Model):
    """An edge of a pattern."""

    panel: str
    edge: int


class FindingInfo(Model):
    """What a check has to say, and where."""

    code: str
    severity: Severity
    message: str
    why: str
    repair: str
    panel: str
    edge: int | None
    stitch: int | None
    edges: list[EdgePlace]
    points: list[tuple[float, float]]
    """Panel-local cm."""
    mendable: bool


class SeamSide(EdgePlace):
    """One side of a seam."""

    length: float
    """cm."""


class SeamInfo(Model):
    """Two edges that are sewn together."""

    stitch: int
    first: SeamSide
    second: SeamSide
    right_wrong: bool
    mismatch: float
    """Length of the first less that of the second, cm."""
    ratio: float
    """The longer over the shorter."""
    uneven: bool


class TrimMark(Model):
    """A pocket, a button, a zip or a line of stitches on a panel."""

    trim: str
    """Its name in ``properties.trims``."""
    panel: str
    kind: Literal["outline", "line", "zip", "button"]
    points: list[tuple[float, float]]
    """Panel-local cm: of outlines and lines in order, of a button its middle."""
    radius: float
    """Of a button, cm; else 0."""


class DimensionInfo(Model):
    """A measure that a slider moves."""

    name: str
    about: str
    unit: Unit
    value: float
    min: float
    max: float
    step: float
    group: str


class RangeInfo(Model):
    """Numbers that may be chosen."""

    min: float
    max: float
    step: float


class Chip(Model):
    """One statement about a garment, as a person can see and correct it."""

    id: str
    claim: str | None
    dimension: str | None
    about: str
    label: str
    value: str | float | None
    text: str
    unit: UnitOrNone
    certainty: float | None
    from_: Source = Field(alias="from")
    holds: bool | None
    choices: list[str]
    range: RangeInfo | None


class Reading(Model):
    """What was read of text and pictures."""

    made: list[Chip] = Field(default_factory=list)
    assumed: list[Chip] = Field(default_factory=list)
    cannot: list[Chip] = Field(default_factory=list)
    unknown: list[Chip] = Field(default_factory=list)
    shown: list[Chip] = Field(default_factory=list)
    language: str | None = None
    color: str | None = None
    fabric: FabricName | None = None


class QualityInfo(Model):
    """Whether a drape is within the limits."""

    accepted: bool
    reasons: list[str]


class PanelLook(Model):
    """How a panel looks."""

    color: str | None
    """None: as the garment."""
    opacity: float
    """Share of what lies beneath that it hides."""
    printed: bool = True
    """Whether the garment's print is on it."""


class Looks(Model):
    """Which parts look otherwise than the rest."""

    parts: PartLooks = Field(default_factory=list)
    """As requests take them."""
    panels: dict[str, PanelLook] = Field(default_factory=dict)
    """The panels that these are, by name."""


class Document(Model):
    """A pattern and its garment: what all work answers with."""

    origin: Origin
    title: str
    pattern: PatternJson
    findings: list[FindingInfo]
    seams: list[SeamInfo]
    trims: list[TrimMark] = Field(default_factory=list)
    mesh: str | None
    unsewable: ErrorInfo | None
    body: str
    reading: Reading
    dimensions: list[DimensionInfo]
    description: str
    notes: list[str]
    warnings: list[str]
    changes: list[str]
    open: list[str]
    quality: QualityInfo | None
    garment: GarmentState
    color: str | None
    looks: Looks = Field(default_factory=Looks)
    print: ClothPrint | None = None
    fabric: FabricName
    edge_length: float
    seed: int | None
    prompt: str
    part: Part | None = None
    """Where it is worn, of the two garments that a text asked for."""
    seconds: dict[str, float]
