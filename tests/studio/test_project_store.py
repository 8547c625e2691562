"""Projects on the disk: what is not the studio's stays, and a save is whole or not at all."""

from __future__ import annotations

import errno
import os

import pytest

from swifttailor import atomic_files
from swifttailor.draping.placement import place_vertices
from swifttailor.errors import DiskFullError, InputError
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.garmentcode_writer import to_specification
from swifttailor.studio.bench.files import save
from swifttailor.studio.bench.mesh_files import garment_record
from swifttailor.studio.project_store import TRASH, ProjectMissingError, ProjectStore

CONTENT = {"name": "My Dress", "prompt": "", "versions": []}


def contents(folder):
    return {p.relative_to(folder): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def test_folders_and_files_of_others_among_the_projects_stay(tmp_path):
    """Some of them with the very names that the studio would choose."""
    for name in ("my-dress", "my-dress-2", TRASH, "photos"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "mine.txt").write_text("my own work")
    (tmp_path / "my-dress-3").write_text("my own work")
    (tmp_path / "my-dress" / "studio.json").write_text('{"format": 1, "of": "another program"}')
    before = contents(tmp_path)
    store = ProjectStore(tmp_path)
    assert store.summaries() == []
    project = store.create(CONTENT)
    assert project.folder == tmp_path / "my-dress-4"
    saved = store.save(project.content["id"], 1, CONTENT | {"name": "Another"})
    store.save_draft(project.content["id"], saved.content["revision"], CONTENT)
    (project.folder / "notes.txt").write_text("my notes")
    store.delete(project.content["id"])
    kept = contents(tmp_path)
    assert {path: kept[path] for path in before} == before
    assert (tmp_path / TRASH / "my-dress-4" / "notes.txt").read_text() == "my notes"
    assert store.restore(project.content["id"]).folder == project.folder
    assert (project.folder / "notes.txt").read_text() == "my notes"
    with pytest.raises(ProjectMissingError):
        store.restore(project.content["id"])


@pytest.mark.parametrize("name", ["garment.obj", "garment.glb", "pattern.json", "report.json", "preview.png"])
def test_a_garment_of_others_in_a_project_stays(name, tmp_path):
    pattern = draft("fitted-skirt").canonical()
    mesh = mesh_pattern(pattern, edge_length=8.0)
    garment = Garment(mesh, place_vertices(mesh), {"edge_length_cm": 8.0, "rotation": "intrinsic"})
    given = {"pattern": to_specification(pattern), "mesh": garment_record(garment, 8.0), "facts": {}}
    (tmp_path / name).write_text("my own work")
    before = contents(tmp_path)
    with pytest.raises(InputError, match=rf"{name}' would be replaced"):
        save(None, folder=str(tmp_path), **given)
    assert contents(tmp_path) == before


def test_of_a_full_disk_nothing_is_left(tmp_path, monkeypatch):
    store = ProjectStore(tmp_path)
    project = store.create(CONTENT)
    before = contents(tmp_path)

    def full(path, target):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(atomic_files.os, "replace", full)
    monkeypatch.setattr(atomic_files.os, "link", full)
    with pytest.raises(DiskFullError, match="the disk is full"):
        store.create(CONTENT)
    with pytest.raises(DiskFullError, match="the disk is full"):
        store.save(project.content["id"], 1, CONTENT)
    assert contents(tmp_path) == before and [p.name for p in tmp_path.iterdir()] == ["my-dress"]
