"""The client's types and the server's models say the same."""

from __future__ import annotations

import inspect
import re
import typing
from pathlib import Path

import pytest
from pydantic import BaseModel

from swifttailor.studio.models import base, documents, jobs, projects, quick

ROOT = Path(__file__).parents[2]
TYPES = (ROOT / "studio-ui" / "src" / "api" / "types.ts").read_text()
MODELS = {
    name: model
    for module in (base, documents, quick, jobs, projects)
    for name, model in inspect.getmembers(module, inspect.isclass)
    if issubclass(model, BaseModel) and model.__module__ == module.__name__ and name != "Model"
}
OF_FILES = {"MeshHeader", "MeshSeam", "MeshBlock", "MeshTrim"}
"""Of mesh files, which are no JSON bodies."""
OF_PATTERNS = {"Curvature", "EdgeJson", "PanelJson", "PatternJson"}


def _interfaces() -> dict[str, tuple[str | None, dict[str, bool]]]:
    """By name: what it extends, and its fields with whether they may be left out."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*", "", TYPES, flags=re.DOTALL)
    found = {}
    for name, parent, body in re.findall(r"interface (\w+)(?: extends (\w+))? \{(.*?)\n\}", text, re.DOTALL):
        flat = re.sub(r"\{[^{}]*\}", "object", body)
        fields = re.findall(r"^\s*(\w+)(\??):", flat, re.MULTILINE)
        found[name] = (parent or None, {field: bool(mark) for field, mark in fields})
    return found


INTERFACES = _interfaces()


def _fields(name: str) -> dict[str, bool]:
    parent, own = INTERFACES[name]
    return (_fields(parent) if parent else {}) | own


def test_every_interface_has_its_model():
    assert set(INTERFACES) - OF_FILES - OF_PATTERNS == set(MODELS)


@pytest.mark.parametrize("name", sorted(MODELS))
def test_fields(name):
    model = MODELS[name]
    ours = {info.alias or field: info for field, info in model.model_fields.items()}
    theirs = _fields(name)
    assert set(ours) == set(theirs)
    for field, may_be_left_out in theirs.items():
        if may_be_left_out:
            assert not ours[field].is_required(), f"{name}.{field} is required by the server"


@pytest.mark.parametrize(
    ("alias", "choices"),
    [
        ("Origin", documents.Origin),
        ("Severity", base.Severity),
        ("Part", base.Part),
        ("FabricName", base.FabricName),
        ("Unit", base.Unit),
        ("JobState", jobs.JobState),
    ],
)
def test_choices(alias, choices):
    declared = re.search(rf"export type {alias} =(.*?);", TYPES, re.DOTALL)
    assert declared
    assert set(re.findall(r'"([^"]*)"', declared[1])) == set(typing.get_args(choices))


def test_every_route_is_in_the_guide_of_the_api(tmp_path):
    from swifttailor.studio.app.application import make_application

    guide = (ROOT / "studio-ui" / "API.md").read_text()
    described = make_application(tmp_path)._app.openapi()["paths"]
    for path, methods in described.items():
        written = path.replace("{name}", "{id}")
        for method in methods:
            pattern = rf"`{method.upper()} {re.escape(written)}`"
            assert re.search(pattern.replace(r"\{id\}", r"\{(id|hash)\}"), guide), f"{method} {path}"
