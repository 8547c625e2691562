"""Routes of jobs: submitting, following, cancelling; and of the pictures that they are about."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator
from typing import Annotated, Any

from fastapi import APIRouter, Body, Request
from fastapi.responses import Response, StreamingResponse
from starlette.types import Receive, Scope, Send

from swifttailor.studio.app.answers import ERRORS, Responses, StudioError, json_answer
from swifttailor.studio.app.studio_of import studio_of
from swifttailor.studio.jobs import JobRecord
from swifttailor.studio.models.jobs import AlterJob, DrapeJob, EditJob, GenerateJob, Job, JobRequest, SewJob
from swifttailor.studio.models.projects import FileInfo
from swifttailor.studio.pictures import PictureRecord
from swifttailor.studio.service import Studio

api = APIRouter(prefix="/api", responses=ERRORS)
_PNG: Responses = {200: {"content": {"image/png": {}}, "description": "The picture."}}
_FRAME: Responses = {
    200: {"content": {"application/octet-stream": {}}, "description": "float32 (welded, 3) cm."}
}
_EVENTS: Responses = {200: {"content": {"text/event-stream": {}}, "description": "Server-sent events."}}
_PICTURE_BODY = {
    "requestBody": {
        "required": True,
        "content": {
            kind: {"schema": {"type": "string", "format": "binary"}}
            for kind in ("image/png", "image/jpeg", "image/webp")
        },
    }
}


@api.post("/jobs", status_code=202, response_model=Job)
async def submit(asked: Annotated[JobRequest, Body()], request: Request) -> Response:
    """Takes a job on."""
    studio = studio_of(request)
    job = studio.jobs.submit(asked.kind, _arguments(asked, studio))
    return json_answer(studio.jobs.view(job), 202)


@api.get("/jobs/{name}", response_model=Job)
async def look(name: str, request: Request) -> Response:
    """How far a job is."""
    studio = studio_of(request)
    return json_answer(studio.jobs.view(_job(studio, name)))


@api.delete("/jobs/{name}", response_model=Job)
async def cancel(name: str, request: Request) -> Response:
    """Cancels a job, or stops a drape."""
    studio = studio_of(request)
    job = _job(studio, name)
    studio.jobs.cancel(job)
    return json_answer(studio.jobs.view(job))


@api.get("/jobs/{name}/frame", response_class=Response, responses=_FRAME)
async def frame(name: str, request: Request) -> Response:
    """The latest frame of a drape."""
    job = _job(studio_of(request), name)
    if not job.frame or job.frame_mesh is None:
        raise StudioError(404, "no-frame", "There is no frame yet, or no longer.")
    headers = {"X-Frame": str(job.frame_number), "X-Mesh": job.frame_mesh}
    return Response(job.frame, media_type="application/octet-stream", headers=headers)


@api.get("/jobs/{name}/events", response_class=Response, responses=_EVENTS)
async def events(name: str, request: Request) -> Response:
    """What happens to a job, as it happens."""
    studio = studio_of(request)
    job = _job(studio, name)
    if studio.streams >= studio.limits.streams:
        raise StudioError(
            503, "busy", "Too many event streams are open.", "Ask for the job itself.", retry_after=2
        )
    studio.streams += 1  # here, so that many that come at once are counted before the first begins
    return _Counted(_stream(studio, job), studio)


class _Counted(StreamingResponse):
    """A stream of events that is counted until it ends."""

    def __init__(self, content: AsyncIterator[bytes], studio: Studio) -> None:
        super().__init__(content, media_type="text/event-stream")
        self._studio = studio

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        try:
            await super().__call__(scope, receive, send)
        finally:
            self._studio.streams -= 1


async def _stream(studio: Studio, job: JobRecord) -> AsyncIterator[bytes]:
    async for happened in studio.jobs.events(job):
        if happened is None:
            yield b": still there\n\n"
            continue
        event, view = happened
        text = json.dumps(view, separators=(",", ":"), allow_nan=False)
        yield f"event: {event}\ndata: {text}\n\n".encode()
        await asyncio.sleep(0.03)  # what comes faster is told together


@api.post("/files", status_code=201, response_model=FileInfo, openapi_extra=_PICTURE_BODY)
async def upload(request: Request) -> Response:
    """Takes a picture in."""
    studio = studio_of(request)
    content = await request.body()
    if not content:
        raise StudioError(422, "no-picture", "The body is empty.", "Send the bytes of a picture.")
    pixels, png = await studio.do("picture", content=content)
    record = PictureRecord(pixels, png)
    studio.pictures.add(record)
    return json_answer(record.to_json(), 201)


@api.get("/files/{name}", response_class=Response, responses=_PNG)
async def picture(name: str, request: Request) -> Response:
    """A picture that was uploaded."""
    return Response(_picture(studio_of(request), name).png, media_type="image/png")


@api.get("/files/{name}/seen", response_class=Response, responses=_PNG)
async def seen(name: str, request: Request) -> Response:
    """What is looked at in it."""
    studio = studio_of(request)
    record = _picture(studio, name)
    if record.seen is None:
        record.seen = await studio.do("seen", pixels=record.pixels)
    return Response(record.seen, media_type="image/png")


def _job(studio: Studio, name: str) -> JobRecord:
    job = studio.jobs.find(name)
    if job is None:
        raise StudioError(404, "no-job", "There is no such job, or it ended long ago.", "Start it again.")
    return job


def _picture(studio: Studio, name: str) -> PictureRecord:
    record = studio.pictures.find(name)
    if record is None:
        raise StudioError(404, "no-picture", "This picture is no longer kept.", "Send it again.")
    return record


def _arguments(asked: Any, studio: Studio) -> dict[str, Any]:
    """What the task of a job is given."""
    values = asked.model_dump(exclude={"kind"})
    if isinstance(asked, GenerateJob):
        return values | {"pictures": [_picture(studio, name).pixels for name in asked.pictures]}
    if isinstance(asked, DrapeJob):
        return values | {"mesh": studio.mesh(asked.mesh)}
    assert isinstance(asked, EditJob | SewJob | AlterJob)
    return values
