"""The application: routes, guard, errors, and the studio behind them."""

from __future__ import annotations

from collections.abc import AsyncGenerator
from contextlib import asynccontextmanager
from pathlib import Path

from fastapi import FastAPI

from swifttailor import __version__
from swifttailor.studio.app import routes_jobs, routes_projects, routes_quick, routes_start
from swifttailor.studio.app.answers import add_handlers
from swifttailor.studio.app.client_files import read_client
from swifttailor.studio.app.guard import LOOPBACK, App, Guard
from swifttailor.studio.app.limits import ServerLimits
from swifttailor.studio.app.project_schemas import add_project_schemas
from swifttailor.studio.service import Studio


def make_application(
    projects: Path,
    *,
    token: str | None = None,
    hosts: frozenset[str] | None = LOOPBACK,
    limits: ServerLimits | None = None,
) -> App:
    """The studio as an ASGI application.

    Args:
        projects: Folder of the projects.
        token: That requests must carry; None where only this machine can ask.
        hosts: Names it answers to; None where any address of this machine will do.
        limits: What is refused beyond.
    """
    limits = limits or ServerLimits()
    return Guard(_inner(projects, token, limits), hosts=hosts, token=token, limits=limits)


def _inner(projects: Path, token: str | None, limits: ServerLimits) -> FastAPI:
    @asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncGenerator[None]:
        app.state.studio = studio = Studio(projects, limits)
        await studio.start()
        try:
            yield
        finally:
            await studio.close()

    app = FastAPI(
        title="SwiftTailor studio",
        version=__version__,
        lifespan=lifespan,
        openapi_url="/api/openapi.json",
        docs_url=None,
        redoc_url=None,
    )
    app.state.token = token
    add_handlers(app)
    for part in (routes_start, routes_quick, routes_jobs, routes_projects):
        app.include_router(part.api)
    add_project_schemas(app)
    app.include_router(routes_start.client_router(read_client()))
    return app
