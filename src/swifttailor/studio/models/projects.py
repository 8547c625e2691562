"""Projects, uploaded pictures, and what the client learns first."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, StringConstraints

from swifttailor.studio.models.base import (
    ClothPrint,
    Color,
    FabricName,
    Figure,
    MeshName,
    Model,
    PatternJson,
    Prompt,
    Seed,
    Title,
    Unit,
    UnitOrNone,
)
from swifttailor.studio.models.documents import Document, Looks

MOST_VERSIONS = 200


class FileInfo(Model):
    """A picture that was uploaded."""

    id: str
    width: int
    height: int
    url: str
    seen_url: str


class ProjectSummary(Model):
    """A project in the list."""

    id: str
    name: str
    saved: str
    versions: int
    thumbnail: str | None
    folder: str
    draft: bool


class ProjectVersion(Model):
    """A pattern that it was."""

    number: Annotated[int, Field(ge=1, le=10**6)]
    label: Title
    saved: Annotated[str, StringConstraints(max_length=40)] = ""
    pattern: PatternJson
    mesh: MeshName | None = None
    color: Color | None = None
    looks: Looks = Field(default_factory=Looks)
    print: ClothPrint | None = None
    seed: Seed | None = None


class ProjectContent(Model):
    """What the client saves."""

    name: Annotated[str, StringConstraints(max_length=100)]
    prompt: Prompt
    seed: Seed | None
    document: Document
    versions: Annotated[list[ProjectVersion], Field(max_length=MOST_VERSIONS)]
    view: dict[str, Any]


class Project(ProjectContent):
    """A project that is open."""

    id: str
    folder: str
    revision: int
    saved: str
    draft: ProjectContent | None


class CreateProjectRequest(Model):
    """A project to begin."""

    content: ProjectContent


class SaveProjectRequest(Model):
    """A project to save."""

    revision: Annotated[int, Field(ge=0, le=2**53)]
    content: ProjectContent


class SavedAnswer(Model):
    """That it is saved."""

    id: str
    revision: int
    saved: str
    notes: list[str] = Field(default_factory=list)
    """What a person should know of how it was saved."""


class Example(Model):
    """A garment that is there from the start."""

    id: str
    title: str
    prompt: str
    thumbnail: str


class ClaimOption(Model):
    """Something that chips can say."""

    name: str
    label: str
    about: str
    choices: list[str]
    unit: UnitOrNone
    kinds: list[str]


class DimensionOption(Model):
    """Something that sliders can move."""

    name: str
    about: str
    unit: Unit
    step: float
    group: str


class Limits(Model):
    """What is refused beyond."""

    upload_bytes: int
    picture_pixels: int
    pattern_bytes: int
    panels: int
    edges: int
    prompt_letters: int
    variants: int
    queue: int
    job_seconds: int
    project_versions: int


class FormatInfo(Model):
    """A kind of file that can be exported."""

    name: str
    about: str
    of: Literal["pattern", "garment", "both"]


class SizeChart(Model):
    """Sizes that can be chosen."""

    figure: Figure
    region: str
    labels: list[str]


class MeasureOption(Model):
    """A measure of a body."""

    name: str
    label: str
    about: str
    min: float
    max: float
    default: float
    """Of the default body, cm."""


class WearerOptions(Model):
    """Whom garments can be made for."""

    figures: list[Figure]
    sizes: list[SizeChart]
    measures: list[MeasureOption]


class State(Model):
    """What the client learns first."""

    version: str
    limits: Limits
    units: list[Literal["cm", "in"]]
    examples: list[Example]
    projects: list[ProjectSummary]
    claims: list[ClaimOption]
    dimensions: list[DimensionOption]
    fabrics: list[FabricName]
    formats: list[FormatInfo]
    wearers: WearerOptions
    body: str
    ready: bool
    notices: list[str]
