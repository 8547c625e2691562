"""Work that takes seconds: jobs in a queue."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from swifttailor.studio.models.base import (
    BodyName,
    ClothPrint,
    Color,
    EdgeLength,
    ErrorInfo,
    FabricName,
    Figure,
    Identifier,
    Measures,
    MeshName,
    Model,
    Part,
    PartLooks,
    PatternJson,
    Prompt,
    Seed,
)
from swifttailor.studio.models.documents import Document
from swifttailor.studio.models.quick import MOST_CHANGES, ChangeRequest

MOST_VARIANTS = 4
JobState = Literal["queued", "running", "done", "failed", "cancelled", "stopped"]


class WearerRef(Model):
    """A body by what it is made to."""

    name: BodyName = ""
    figure: Figure | None = None
    measures: Measures = Field(default_factory=dict)
    mesh: MeshName | None = None


class GenerateJob(Model):
    """Words, pictures or both to garments."""

    kind: Literal["generate"]
    text: Prompt = ""
    pictures: Annotated[list[Identifier], Field(max_length=2, default_factory=list)]
    part: Part | None = None
    seed: Seed = 0
    variants: Annotated[int, Field(ge=1, le=MOST_VARIANTS)] = 1
    finish: bool = False
    wearer: WearerRef | None = None
    """Who wears it, unless the text says so; as in the properties of a pattern (``drafted_for``)."""

    @model_validator(mode="after")
    def _asks_for_something(self) -> GenerateJob:
        if not self.text.strip() and not self.pictures:
            raise ValueError("give a text, a picture, or both")
        if self.part is not None and not self.pictures:
            raise ValueError("part is about a picture, and there is none")
        return self


class EditJob(Model):
    """A pattern, changed as words say."""

    kind: Literal["edit"]
    pattern: PatternJson
    instruction: Annotated[Prompt, Field(min_length=1)]
    color: Color | None = None
    looks: PartLooks = Field(default_factory=list)
    print: ClothPrint | None = None
    seed: Seed = 0
    finish: bool = False


class SewJob(Model):
    """A pattern to be sewn with care."""

    kind: Literal["sew"]
    pattern: PatternJson
    edge_length: EdgeLength = 2.0
    repair: bool = False
    color: Color | None = None
    looks: PartLooks = Field(default_factory=list)
    print: ClothPrint | None = None


class DrapeJob(Model):
    """A garment to be hung by physics."""

    kind: Literal["finish", "drape"]
    pattern: PatternJson
    mesh: MeshName | None = None
    fabric: FabricName = "cotton"
    edge_length: EdgeLength | None = None
    """Of the mesh, cm; to finish a garment, that of its mesh when None, else 2."""
    color: Color | None = None
    looks: PartLooks = Field(default_factory=list)
    print: ClothPrint | None = None


class AlterJob(Model):
    """A pattern to be recut, with time for it."""

    kind: Literal["alter"]
    pattern: PatternJson
    changes: Annotated[list[ChangeRequest], Field(min_length=1, max_length=MOST_CHANGES)]
    color: Color | None = None
    looks: PartLooks = Field(default_factory=list)
    print: ClothPrint | None = None


JobRequest = Annotated[GenerateJob | EditJob | SewJob | DrapeJob | AlterJob, Field(discriminator="kind")]


class StageInfo(Model):
    """A stage of the work."""

    name: str
    share: float
    seconds: float


class FailureInfo(Model):
    """A variant that could not be made."""

    seed: int
    error: ErrorInfo


class Job(Model):
    """How far the work is, and what came of it."""

    id: str
    kind: Literal["generate", "edit", "sew", "finish", "drape", "alter"]
    state: JobState
    place: int
    stages: list[StageInfo]
    frame: int
    frame_mesh: str | None
    documents: list[Document]
    failures: list[FailureInfo]
    error: ErrorInfo | None
    seconds: float
