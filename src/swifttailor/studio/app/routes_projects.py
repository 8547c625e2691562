"""Routes of projects: list, create, open, save, autosave, delete, restore, export."""

from __future__ import annotations

import asyncio
import json
from typing import Any, TypeVar

from fastapi import APIRouter, Request
from fastapi.responses import Response
from pydantic import BaseModel, ValidationError

from swifttailor.studio.app.answers import ERRORS, Responses, StudioError, json_answer
from swifttailor.studio.app.routes_quick import exported
from swifttailor.studio.app.studio_of import studio_of
from swifttailor.studio.models.projects import (
    CreateProjectRequest,
    Project,
    ProjectSummary,
    SavedAnswer,
    SaveProjectRequest,
)
from swifttailor.studio.project_store import PREVIEW, ProjectChangedError, ProjectMissingError, StoredProject
from swifttailor.studio.service import Studio
from swifttailor.studio.worker.handle import RefusedError
from swifttailor.studio.worker.lane import BusyError

api = APIRouter(prefix="/api", responses=ERRORS)
_PNG: Responses = {200: {"content": {"image/png": {}}, "description": "The picture."}}
_FILE: Responses = {200: {"content": {"application/octet-stream": {}}, "description": "The file."}}
_Model = TypeVar("_Model", bound=BaseModel)
_MOST_VIEW = 64 * 2**10


def _body_of(model: type[BaseModel]) -> dict[str, Any]:
    """For the description of a route that reads its body itself."""
    reference = {"$ref": f"#/components/schemas/{model.__name__}"}
    return {"requestBody": {"required": True, "content": {"application/json": {"schema": reference}}}}


@api.get("/projects", response_model=list[ProjectSummary])
async def projects(request: Request) -> Response:
    """All projects, the latest first."""
    return json_answer(await asyncio.to_thread(studio_of(request).projects.summaries))


@api.post("/projects", status_code=201, response_model=Project, openapi_extra=_body_of(CreateProjectRequest))
async def create(request: Request) -> Response:
    """A new project."""
    studio = studio_of(request)
    asked = await _read(request, CreateProjectRequest)
    content = _content(asked)
    async with studio.saving:
        project = await asyncio.to_thread(studio.projects.create, content)
        await _write_garment(studio, project)
    return json_answer(project.to_json(), 201)


@api.get("/projects/{name}", response_model=Project)
async def open_project(name: str, request: Request) -> Response:
    """A project."""
    return json_answer((await _open(studio_of(request), name)).to_json())


@api.put("/projects/{name}", response_model=SavedAnswer, openapi_extra=_body_of(SaveProjectRequest))
async def save(name: str, request: Request) -> Response:
    """Saves a project: studio.json at once and whole, then the files that the command line reads."""
    studio = studio_of(request)
    asked = await _read(request, SaveProjectRequest)
    content = _content(asked)
    async with studio.saving:
        project = await _store(studio.projects.save, name, asked.revision, content)
        notes = await _write_garment(studio, project)
    return json_answer(_saved(project) | {"notes": notes})


@api.put("/projects/{name}/draft", response_model=SavedAnswer, openapi_extra=_body_of(SaveProjectRequest))
async def autosave(name: str, request: Request) -> Response:
    """Keeps what is not saved yet beside what is."""
    studio = studio_of(request)
    asked = await _read(request, SaveProjectRequest)
    content = _content(asked)
    async with studio.saving:
        project = await _store(studio.projects.save_draft, name, asked.revision, content)
    return json_answer(_saved(project) | {"notes": []})


@api.delete("/projects/{name}", status_code=204, response_class=Response)
async def delete(name: str, request: Request) -> Response:
    """Moves a project to the trash."""
    studio = studio_of(request)
    async with studio.saving:
        await _store(studio.projects.delete, name)
    return Response(status_code=204)


@api.post("/trash/{name}/restore", response_model=ProjectSummary)
async def restore(name: str, request: Request) -> Response:
    """Takes a project out of the trash."""
    studio = studio_of(request)
    async with studio.saving:
        project = await _store(studio.projects.restore, name)
    return json_answer(project.summary())


@api.get("/projects/{name}/preview", response_class=Response, responses=_PNG)
async def preview(name: str, request: Request) -> Response:
    """The picture of a project's garment."""
    project = await _open(studio_of(request), name)
    try:
        content = await asyncio.to_thread((project.folder / PREVIEW).read_bytes)
    except OSError:
        raise StudioError(404, "no-preview", "This project has no picture yet.") from None
    return Response(content, media_type="image/png", headers={"Cache-Control": "no-cache"})


@api.get("/projects/{name}/export/{format}", response_class=Response, responses=_FILE)
async def export(name: str, format: str, request: Request) -> Response:
    """A project as a file."""
    studio = studio_of(request)
    content = (await _open(studio, name)).content["content"]
    shown = content["document"]
    facts = {
        "title": content["name"],
        "prompt": content["prompt"],
        "seed": content["seed"],
        "color": shown["color"],
        "looks": shown.get("looks", {}).get("parts", []),
        "print": shown.get("print"),
    }
    return await exported(studio, shown["pattern"], shown["mesh"], format, facts)


async def _read(request: Request, model: type[_Model]) -> _Model:
    """The body of a request, read beside the event loop since it may be large."""
    body = await request.body()
    try:
        return await asyncio.to_thread(model.model_validate_json, body)
    except ValidationError as error:
        found = error.errors(include_url=False, include_input=False)
        if found[0]["type"] == "json_invalid":
            raise StudioError(400, "not-json", "The body is not JSON.", "Send one JSON object.") from None
        lines = [f"{'.'.join(map(str, one['loc']))[:120]}: {one['msg']}" for one in found[:3]]
        raise StudioError(422, "invalid-request", "; ".join(lines), "See /api/openapi.json.") from None
    except (ValueError, RecursionError):
        raise StudioError(400, "not-json", "The body is not JSON.", "Send one JSON object.") from None


def _content(asked: CreateProjectRequest | SaveProjectRequest) -> dict[str, Any]:
    content = asked.content.model_dump(mode="json", by_alias=True)
    if len(json.dumps(content["view"])) > _MOST_VIEW:
        raise StudioError(
            422, "view-too-large", f"content.view is larger than {_MOST_VIEW // 1024} kB of JSON."
        )
    try:
        json.dumps(content, allow_nan=False)
    except (ValueError, RecursionError):
        raise StudioError(422, "not-finite", "content has numbers that are not finite.") from None
    return content


async def _open(studio: Studio, name: str) -> StoredProject:
    return await _store(studio.projects.open, name)


async def _store(function: Any, *arguments: Any) -> Any:
    """Something of the store, its errors as answers."""
    try:
        return await asyncio.to_thread(function, *arguments)
    except ProjectMissingError:
        raise StudioError(
            404, "no-project", "There is no such project.", "It may be in the trash, or its folder was moved."
        ) from None
    except ProjectChangedError:
        raise StudioError(
            409,
            "project-changed",
            "The project was saved in another window meanwhile.",
            "Open it again, or save this as a new project.",
        ) from None


async def _write_garment(studio: Studio, project: StoredProject) -> list[str]:
    """Writes the files that the command line reads; what is in the way of that is told, and loses nothing."""
    content = project.content["content"]
    shown = content["document"]
    facts = {
        "title": content["name"],
        "prompt": content["prompt"],
        "seed": content["seed"],
        "color": shown["color"],
        "looks": shown.get("looks", {}).get("parts", []),
        "print": shown.get("print"),
    }
    try:
        await studio.do(
            "save",
            folder=str(project.folder),
            pattern=shown["pattern"],
            mesh=studio.mesh(shown["mesh"]),
            facts=facts,
        )
    except RefusedError as error:
        return [f"Saved, but not as files for the command line: {error.error['message']}"]
    except BusyError:
        return ["Saved; the files for the command line follow with the next save."]
    return []


def _saved(project: StoredProject) -> dict[str, Any]:
    return {name: project.content[name] for name in ("id", "revision", "saved")}
