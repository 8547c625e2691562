"""Routes of the first page: the client itself, the state, examples, meshes, the session."""

from __future__ import annotations

from fastapi import APIRouter, Request
from fastapi.responses import Response

from swifttailor.studio.app.answers import ERRORS, Responses, StudioError, json_answer
from swifttailor.studio.app.client_files import NOT_BUILT, ClientFile
from swifttailor.studio.app.guard import COOKIE
from swifttailor.studio.app.studio_of import studio_of
from swifttailor.studio.models.documents import Document
from swifttailor.studio.models.projects import State
from swifttailor.studio.shipped import ShippedExample, shipped_body, shipped_examples, shipped_options

MESH_TYPE = "application/octet-stream"
_FOR_EVER = "private, max-age=31536000, immutable"
_BINARY: Responses = {200: {"content": {MESH_TYPE: {}}, "description": "The bytes of studio-ui/API.md."}}
_HALF_A_DAY = 12 * 3600

api = APIRouter(prefix="/api", responses=ERRORS)


@api.get("/state", response_model=State)
async def state(request: Request) -> Response:
    """What the client learns first."""
    return json_answer(studio_of(request).state())


@api.post("/session", status_code=204, response_class=Response)
async def session(request: Request) -> Response:
    """Turns the token, which the guard has looked at, into a cookie for images and event streams."""
    answer = Response(status_code=204)
    token = request.app.state.token
    if token is not None:
        answer.set_cookie(COOKIE, token, max_age=_HALF_A_DAY, httponly=True, samesite="strict", path="/api")
    return answer


@api.get("/examples/{name}", response_model=Document)
async def example(name: str, request: Request) -> Response:
    """A garment of the gallery, finished."""
    return json_answer(_example(name).document)


@api.get(
    "/examples/{name}/thumbnail", response_class=Response, responses={200: {"content": {"image/webp": {}}}}
)
async def thumbnail(name: str, request: Request) -> Response:
    """Its picture."""
    return Response(
        _example(name).thumbnail, media_type="image/webp", headers={"Cache-Control": "max-age=3600"}
    )


@api.get("/meshes/{name}", response_class=Response, responses=_BINARY)
async def mesh(name: str, request: Request) -> Response:
    """A garment's mesh; its name is the hash of its content, so that no cache ever shows another."""
    record = studio_of(request).mesh(name)
    if record is None:
        raise StudioError(
            404, "mesh-gone", "This garment is no longer kept.", "It can be sewn again from its pattern."
        )
    return Response(record.data, media_type=MESH_TYPE, headers={"Cache-Control": _FOR_EVER})


@api.get("/body/{name}", response_class=Response, responses=_BINARY)
async def body(name: str, request: Request) -> Response:
    """Who wears it."""
    record = shipped_body() if name == shipped_options()["body"] else studio_of(request).mesh(name)
    if record is None:
        raise StudioError(
            404,
            "body-gone",
            "This body is no longer kept.",
            "It can be made again from its pattern.",
        )
    return Response(record.data, media_type=MESH_TYPE, headers={"Cache-Control": _FOR_EVER})


def _example(name: str) -> ShippedExample:
    found = shipped_examples().get(name)
    if found is None:
        raise StudioError(404, "not-found", "There is no such example.", "GET /api/state lists them.")
    return found


def client_router(files: dict[str, ClientFile]) -> APIRouter:
    """Routes of the built client.

    Args:
        files: Of `client_files.read_client`.
    """
    router = APIRouter(include_in_schema=False)

    def answer(request: Request, name: str) -> Response:
        file = files.get(name)
        if file is None:
            if name == "index.html":
                return Response(NOT_BUILT, media_type="text/html; charset=utf-8")
            raise StudioError(404, "not-found", "There is nothing at this address.")
        caching = _FOR_EVER if file.immutable else "no-cache"
        headers = {"ETag": file.tag, "Cache-Control": caching, "Vary": "Accept-Encoding"}
        if request.headers.get("if-none-match") == file.tag:
            return Response(status_code=304, headers=headers)
        packed = file.packed if "gzip" in request.headers.get("accept-encoding", "") else None
        if packed is not None:
            headers["Content-Encoding"] = "gzip"
        return Response(file.content if packed is None else packed, media_type=file.type, headers=headers)

    @router.get("/")
    async def index(request: Request) -> Response:
        return answer(request, "index.html")

    @router.get("/{name:path}")
    async def file(name: str, request: Request) -> Response:
        return answer(request, name)

    return router
