"""Routes of quick work: live sewing, opening, checking, mending, describing, altering, exporting."""

from __future__ import annotations

import re
from typing import Annotated, Any

from fastapi import APIRouter, Query, Request
from fastapi.responses import Response

from swifttailor.studio.app.answers import ERRORS, Responses, StudioError, json_answer
from swifttailor.studio.app.studio_of import studio_of
from swifttailor.studio.app.tile_query import TileQuery
from swifttailor.studio.models.documents import Document
from swifttailor.studio.models.quick import (
    AlterRequest,
    BodyAnswer,
    CheckAnswer,
    CheckRequest,
    DescribeAnswer,
    DescribeRequest,
    ExportRequest,
    FitRequest,
    LiveAnswer,
    LiveRequest,
    MeasuresAnswer,
    MeasuresRequest,
    OpenRequest,
    RepairAnswer,
    RepairRequest,
    WearerAnswer,
    WearerRequest,
)
from swifttailor.studio.service import Studio

api = APIRouter(prefix="/api", responses=ERRORS)
_STALE: dict[str, Any] = {
    "status": "stale",
    "mesh": None,
    "findings": [],
    "seams": [],
    "trims": [],
    "error": None,
    "seconds": {},
}
_FILE: Responses = {200: {"content": {"application/octet-stream": {}}, "description": "The file."}}
_TILE: Responses = {
    200: {
        "content": {"image/png": {}},
        "description": "One repeat. X-Tile: the matrix, row by row, from cm of the cloth to repeats.",
    }
}
_AN_HOUR = "private, max-age=3600"
_MESH_BODY = {
    "requestBody": {
        "required": True,
        "content": {"application/octet-stream": {"schema": {"type": "string", "format": "binary"}}},
    }
}
_TYPES = {
    "json": "application/json",
    "svg": "image/svg+xml",
    "glb": "model/gltf-binary",
    "obj": "model/obj",
    "stl": "model/stl",
    "png": "image/png",
    "zip": "application/zip",
    "usdz": "model/vnd.usdz+zip",
    "pdf": "application/pdf",
    "dxf": "image/vnd.dxf",
    "md": "text/markdown; charset=utf-8",
    "clo": "application/zip",
}
_ENDINGS = {"clo": "clo.zip"}


@api.post("/live", response_model=LiveAnswer)
async def live(asked: LiveRequest, request: Request) -> Response:
    """The garment of a pattern while it is dragged; of each client the latest state wins."""
    studio = studio_of(request)
    arguments = {"pattern": asked.pattern, "edge_length": asked.edge_length, "dragging": asked.dragging}
    result = await studio.live.run(asked.client, asked.sequence, arguments)
    answer = _STALE if result is None else studio.keep(result).answer
    return json_answer({"client": asked.client, "sequence": asked.sequence} | answer)


@api.post("/open", response_model=Document)
async def open_pattern(asked: OpenRequest, request: Request) -> Response:
    """A GarmentCode file as a document."""
    return json_answer(
        await studio_of(request).do("open", pattern=asked.pattern, title=asked.title, sew=asked.sew)
    )


@api.post("/check", response_model=CheckAnswer)
async def check(asked: CheckRequest, request: Request) -> Response:
    """What is wrong with a pattern."""
    return json_answer(await studio_of(request).do("check", pattern=asked.pattern))


@api.post("/repair", response_model=RepairAnswer)
async def repair(asked: RepairRequest, request: Request) -> Response:
    """The pattern with everything mended that can safely be."""
    return json_answer(await studio_of(request).do("repair", pattern=asked.pattern))


@api.post("/describe", response_model=DescribeAnswer)
async def describe(asked: DescribeRequest, request: Request) -> Response:
    """What a pattern shows."""
    return json_answer(await studio_of(request).do("describe", pattern=asked.pattern))


@api.post("/fit", response_model=Document)
async def fit(asked: FitRequest, request: Request) -> Response:
    """A pattern refitted to a body."""
    return json_answer(await studio_of(request).do("fit", **asked.model_dump()))


@api.post("/wearer", response_model=WearerAnswer)
async def wearer(asked: WearerRequest, request: Request) -> Response:
    """Who wears a pattern; their mesh can be fetched then."""
    return json_answer(await studio_of(request).do("wearer", pattern=asked.pattern))


@api.post("/measures", response_model=MeasuresAnswer)
async def measures(asked: MeasuresRequest, request: Request) -> Response:
    """What a file of measures holds."""
    return json_answer(await studio_of(request).do("measures", **asked.model_dump()))


@api.post("/bodies", status_code=201, response_model=BodyAnswer, openapi_extra=_MESH_BODY)
async def body(request: Request, file_name: Annotated[str, Query(min_length=1, max_length=200)]) -> Response:
    """Takes a body mesh in; the ending of its name tells the format."""
    content = await request.body()
    if not content:
        raise StudioError(422, "no-body", "The file is empty.", "Send the bytes of a body mesh.")
    return json_answer(await studio_of(request).do("body", file_name=file_name, content=content), 201)


@api.post("/alter", response_model=Document)
async def alter(asked: AlterRequest, request: Request) -> Response:
    """A pattern recut to chips and sliders."""
    changes = [change.model_dump() for change in asked.changes]
    answer = await studio_of(request).do(
        "alter",
        pattern=asked.pattern,
        changes=changes,
        sew=asked.sew,
        color=asked.color,
        looks=[look.model_dump() for look in asked.looks],
        print=None if asked.print is None else asked.print.model_dump(),
    )
    return json_answer(answer)


@api.get("/prints/tile", response_class=Response, responses=_TILE)
async def tile(asked: Annotated[TileQuery, Query()], request: Request) -> Response:
    """One repeat of a print."""
    found = await studio_of(request).do("tile", print=asked.as_print().model_dump())
    headers = {"Cache-Control": _AN_HOUR, "X-Tile": " ".join(f"{number:.6g}" for number in found["matrix"])}
    return Response(found["png"], media_type="image/png", headers=headers)


@api.post("/export", response_class=Response, responses=_FILE)
async def export(asked: ExportRequest, request: Request) -> Response:
    """A pattern or garment as a file."""
    studio = studio_of(request)
    facts = asked.model_dump(include={"title", "prompt", "seed", "color", "looks", "print"})
    return await exported(studio, asked.pattern, asked.mesh, asked.format, facts)


async def exported(
    studio: Studio, pattern: dict[str, Any], mesh: str | None, format: str, facts: dict[str, Any]
) -> Response:
    """A file to keep.

    Args:
        studio: Makes it.
        pattern: What is shown.
        mesh: Name of its garment's mesh.
        format: Ending without the dot.
        facts: Title, prompt, seed, color, looks, print.
    """
    known = [one["name"] for one in studio.formats()]
    if format not in known:
        raise StudioError(
            422, "unknown-format", f"There is no format '{format}' here.", f"There are: {', '.join(known)}."
        )
    content = await studio.do("export", pattern=pattern, mesh=studio.mesh(mesh), format=format, facts=facts)
    name = re.sub(r"[^A-Za-z0-9]+", "-", facts.get("title") or "").strip("-").lower()[:60] or "garment"
    headers = {"Content-Disposition": f'attachment; filename="{name}.{_ENDINGS.get(format, format)}"'}
    return Response(content, media_type=_TYPES.get(format, "application/octet-stream"), headers=headers)
