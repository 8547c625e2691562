"""Work that is answered at once."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, StringConstraints, model_validator

from swifttailor.studio.models.base import (
    BodyName,
    ClothPrint,
    Color,
    ErrorInfo,
    Figure,
    Identifier,
    Measures,
    MeshName,
    Model,
    PartLooks,
    PatternJson,
    Prompt,
    Seed,
    Title,
)
from swifttailor.studio.models.documents import DimensionInfo, FindingInfo, Reading, SeamInfo, TrimMark

MOST_CHANGES = 20
Name = Annotated[str, StringConstraints(min_length=1, max_length=40)]


class OpenRequest(Model):
    """A GarmentCode file that is opened."""

    pattern: PatternJson
    title: Title = ""
    sew: bool = True


class CheckRequest(Model):
    """A pattern to check."""

    pattern: PatternJson


class CheckAnswer(Model):
    """What was found in it."""

    findings: list[FindingInfo]
    seams: list[SeamInfo]
    trims: list[TrimMark]


class RepairRequest(Model):
    """A pattern to mend."""

    pattern: PatternJson


class RepairAnswer(Model):
    """The mended pattern."""

    pattern: PatternJson
    changes: list[str]
    findings: list[FindingInfo]
    seams: list[SeamInfo]
    trims: list[TrimMark]


class DescribeRequest(Model):
    """A pattern to describe."""

    pattern: PatternJson


class DescribeAnswer(Model):
    """What it shows."""

    description: str
    reading: Reading
    dimensions: list[DimensionInfo]


class ChangeRequest(Model):
    """A chip that was corrected, or a slider that was moved."""

    claim: Name | None = None
    dimension: Name | None = None
    value: Annotated[str, StringConstraints(max_length=40)] | float | None = None
    by: float | None = None

    @model_validator(mode="after")
    def _one_of_three(self) -> ChangeRequest:
        if (self.claim is None) == (self.dimension is None):
            raise ValueError("give either claim or dimension")
        if (self.value is None) == (self.by is None) or (self.claim is not None and self.value is None):
            raise ValueError("give a value, or by how much a dimension changes (by)")
        if self.dimension is not None and isinstance(self.value, str):
            raise ValueError("the value of a dimension is a number")
        return self


class AlterRequest(Model):
    """A pattern to recut."""

    pattern: PatternJson
    changes: Annotated[list[ChangeRequest], Field(min_length=1, max_length=MOST_CHANGES)]
    sew: bool = True
    color: Color | None = None
    looks: PartLooks = Field(default_factory=list)
    print: ClothPrint | None = None


class LiveRequest(Model):
    """A pattern that is being dragged."""

    client: Identifier
    sequence: Annotated[int, Field(ge=1, le=2**53)]
    pattern: PatternJson
    edge_length: Annotated[float, Field(ge=2.0, le=5.0)] = 2.5
    dragging: bool = False
    """Whether another state follows: sewn in less time, and less finely."""


class LiveAnswer(Model):
    """Its garment, unless a later state has arrived."""

    client: str
    sequence: int
    status: Literal["sewn", "unsewable", "stale"]
    mesh: str | None
    findings: list[FindingInfo]
    seams: list[SeamInfo]
    trims: list[TrimMark]
    error: ErrorInfo | None
    seconds: dict[str, float]


class FitRequest(Model):
    """A pattern to refit to a body; to the default body without size, figure and measures."""

    pattern: PatternJson
    size: Annotated[str, StringConstraints(min_length=1, max_length=40)] | None = None
    figure: Figure | None = None
    measures: Measures = Field(default_factory=dict)
    called: BodyName = ""
    """What the body is called; made up of size and measures where it is empty."""
    body: MeshName | None = None
    """A mesh that was loaded (`BodyAnswer`), in place of size, figure and measures."""
    color: Color | None = None
    looks: PartLooks = Field(default_factory=list)
    print: ClothPrint | None = None

    @model_validator(mode="after")
    def _one_body(self) -> FitRequest:
        if self.body is not None and (self.size or self.figure or self.measures):
            raise ValueError("give either a body mesh, or a size, a figure and measures")
        return self


class WearerRequest(Model):
    """A pattern that names who wears it."""

    pattern: PatternJson


class WearerAnswer(Model):
    """Who wears it."""

    body: str
    name: str
    figure: Figure | None
    given: dict[str, float]
    """What the body was made to, cm."""
    measures: dict[str, float]
    """As they are on the body, cm."""
    mesh: str | None = None
    """Of a body that was loaded as a mesh."""
    stands_in: bool = False
    """Whether that mesh is not kept here, and a body of the same measures wears the pattern."""


class BodyAnswer(Model):
    """A body mesh that was loaded."""

    body: str
    """For `FitRequest.body`."""
    name: str
    vertices: int
    faces: int
    measures: dict[str, float]
    """As they are on it, cm."""


class MeasuresRequest(Model):
    """A file of measures."""

    file_name: Annotated[str, StringConstraints(min_length=1, max_length=200)]
    text: Annotated[str, StringConstraints(max_length=100_000)]


class MeasuresAnswer(Model):
    """What it holds."""

    measures: dict[str, float]


class ExportRequest(Model):
    """A pattern or garment that is wanted as a file."""

    pattern: PatternJson
    mesh: MeshName | None = None
    format: Annotated[str, StringConstraints(pattern="^[a-z]{2,5}$")]
    title: Title = ""
    color: Color | None = None
    looks: PartLooks = Field(default_factory=list)
    print: ClothPrint | None = None
    prompt: Prompt = ""
    seed: Seed | None = None
