"""Answers that are errors, all of one form."""

from __future__ import annotations

import json
from typing import Any

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse, Response
from starlette.exceptions import HTTPException

from swifttailor.errors import SwiftTailorError
from swifttailor.studio.jobs import QueueFullError
from swifttailor.studio.models.base import ErrorAnswer
from swifttailor.studio.worker.handle import RefusedError
from swifttailor.studio.worker.lane import BusyError
from swifttailor.studio.worker.refusal import refusal_of

Responses = dict[int | str, dict[str, Any]]
"""What a route may answer, for its description."""
_STATUS = {
    "too-long": 504,
    "worker-ended": 503,
    "no-memory": 503,
    "internal": 500,
    "disk-full": 507,
    "not-installed": 501,
}
"""Of errors of the pipeline that are not the fault of what was sent; those are 422."""
ERRORS: Responses = {
    code: {"model": ErrorAnswer, "description": text}
    for code, text in (
        (400, "The request cannot be read."),
        (401, "The token is missing or wrong."),
        (403, "The request comes from another site."),
        (404, "There is no such thing."),
        (408, "The request came too slowly."),
        (409, "It was changed meanwhile."),
        (413, "The request is too large."),
        (415, "The body is of another type."),
        (421, "The request was meant for another host."),
        (422, "The request is of the right form and cannot be answered."),
        (429, "The queue is full."),
        (500, "A fault of the server."),
        (501, "An optional package is not installed."),
        (503, "Too much is under way."),
        (504, "It took too long."),
        (507, "The disk is full."),
    )
}
"""For the description of every route."""


class StudioError(Exception):
    """An answer that is an error."""

    def __init__(
        self, status: int, code: str, message: str, hint: str = "", *, retry_after: int | None = None
    ) -> None:
        super().__init__(message)
        self.status, self.code, self.message, self.hint = status, code, message, hint
        self.retry_after = retry_after

    def response(self) -> JSONResponse:
        """As it is sent."""
        headers = {} if self.retry_after is None else {"Retry-After": str(self.retry_after)}
        content = {"error": {"code": self.code, "message": self.message, "hint": self.hint}}
        return JSONResponse(content, self.status, headers)


def json_answer(value: Any, status: int = 200) -> Response:
    """A plain value as JSON, without looking at it again."""
    content = json.dumps(value, separators=(",", ":"), allow_nan=False, ensure_ascii=False)
    return Response(content.encode("utf-8", "backslashreplace"), status, media_type="application/json")


def refused(error: dict[str, str]) -> JSONResponse:
    """The answer to work that was refused."""
    retry = 5 if _STATUS.get(error["code"]) == 503 else None
    status = _STATUS.get(error["code"], 422)
    return StudioError(status, error["code"], error["message"], error["hint"], retry_after=retry).response()


def add_handlers(app: FastAPI) -> None:
    """Makes all errors of an application answers of this form."""

    @app.exception_handler(StudioError)
    async def studio_error(request: Request, error: StudioError) -> Response:
        return error.response()

    @app.exception_handler(RefusedError)
    async def refused_work(request: Request, error: RefusedError) -> Response:
        return refused(error.error)

    @app.exception_handler(BusyError)
    async def busy(request: Request, error: BusyError) -> Response:
        message = "Too much quick work is under way."
        return StudioError(
            503, "busy", message, "Try again in a moment.", retry_after=error.retry_after
        ).response()

    @app.exception_handler(QueueFullError)
    async def queue_full(request: Request, error: QueueFullError) -> Response:
        message = "The queue is full."
        hint = f"Try again in {error.retry_after} s, or cancel a job."
        return StudioError(429, "queue-full", message, hint, retry_after=error.retry_after).response()

    @app.exception_handler(SwiftTailorError)
    async def pipeline_error(request: Request, error: SwiftTailorError) -> Response:
        return refused(refusal_of(error))

    @app.exception_handler(RequestValidationError)
    async def invalid(request: Request, error: RequestValidationError) -> Response:
        errors = error.errors()
        if any(one["type"].startswith("json") for one in errors):
            return StudioError(400, "not-json", "The body is not JSON.", "Send one JSON object.").response()
        return StudioError(422, "invalid-request", _said(errors), "See /api/openapi.json.").response()

    @app.exception_handler(HTTPException)
    async def http_error(request: Request, error: HTTPException) -> Response:
        codes = {400: "not-json", 404: "not-found", 405: "method-not-allowed"}
        messages = {
            400: "The body cannot be read as JSON.",
            404: "There is nothing at this address.",
            405: f"{request.method} is not possible here.",
        }
        code = codes.get(error.status_code, "refused")
        answer = StudioError(
            error.status_code, code, messages.get(error.status_code, str(error.detail))
        ).response()
        for name, value in (error.headers or {}).items():
            answer.headers[name] = value
        return answer

    @app.exception_handler(Exception)
    async def fault(request: Request, error: Exception) -> Response:
        return refused(refusal_of(error))


def _said(errors: Any) -> str:
    """The first things that are wrong with a request."""
    lines = []
    for one in list(errors)[:3]:
        place = ".".join(str(part) for part in one["loc"])[:120]
        received = repr(one.get("input"))
        shown = "" if len(received) > 60 else f"; received {received}"
        lines.append(f"{place}: {one['msg']}{shown}")
    more = f" (and {len(errors) - 3} more)" if len(errors) > 3 else ""
    return "; ".join(lines) + more
