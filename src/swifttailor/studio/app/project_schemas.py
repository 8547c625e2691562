"""The description of the API, with the bodies that some routes read themselves."""

from __future__ import annotations

from typing import Any, Literal

from fastapi import FastAPI
from fastapi.openapi.utils import get_openapi
from pydantic import BaseModel
from pydantic.json_schema import models_json_schema

from swifttailor.studio.models.projects import CreateProjectRequest, SaveProjectRequest

_MODELS: list[tuple[type[BaseModel], Literal["validation"]]] = [
    (CreateProjectRequest, "validation"),
    (SaveProjectRequest, "validation"),
]
_PLACE = "#/components/schemas/{model}"


def add_project_schemas(app: FastAPI) -> None:
    """Completes what `app.openapi` gives."""

    def description() -> dict[str, Any]:
        if app.openapi_schema is None:
            found = get_openapi(title=app.title, version=app.version, routes=app.routes)
            _, definitions = models_json_schema(_MODELS, ref_template=_PLACE)
            schemas = found["components"]["schemas"]
            for name, schema in definitions["$defs"].items():
                schemas.setdefault(name, schema)
            app.openapi_schema = found
        return app.openapi_schema

    app.openapi = description
