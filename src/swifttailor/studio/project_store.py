"""Projects: folders that the command line reads too, with studio.json for what it does not know of."""

from __future__ import annotations

import json
import os
import re
import secrets
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from swifttailor.atomic_files import write_text
from swifttailor.errors import InputError

STUDIO, DRAFT, PREVIEW = "studio.json", "studio-draft.json", "preview.png"
TRASH = ".trash"
BODIES = ".bodies"
"""Of body meshes that people have loaded; for all projects."""
FORMAT = 1
_LARGEST = 64 * 2**20
_NAME = re.compile(r"[^A-Za-z0-9]+")
_ID = re.compile(r"[A-Za-z0-9_-]{16,64}")


class ProjectMissingError(Exception):
    """There is no project of this id."""


class ProjectChangedError(Exception):
    """It was saved by somebody else meanwhile."""


@dataclass(frozen=True)
class StoredProject:
    """A project as it lies on the disk."""

    folder: Path
    content: dict[str, Any]
    """Of studio.json."""
    draft: dict[str, Any] | None
    """Content of an autosave that is newer."""

    def to_json(self) -> dict[str, Any]:
        """As `models.projects.Project`."""
        about = {name: self.content[name] for name in ("id", "revision", "saved")}
        return self.content["content"] | about | {"folder": self.folder.name, "draft": self.draft}

    def summary(self) -> dict[str, Any]:
        """As `models.projects.ProjectSummary`."""
        content = self.content["content"]
        name = self.content["id"]
        has_preview = (self.folder / PREVIEW).is_file()
        return {
            "id": name,
            "name": str(content.get("name", ""))[:100],
            "saved": self.content["saved"],
            "versions": len(content.get("versions", ())),
            "thumbnail": f"/api/projects/{name}/preview" if has_preview else None,
            "folder": self.folder.name,
            "draft": self.draft is not None,
        }


class ProjectStore:
    """The folder of all projects. Only names that it finds there itself become paths."""

    def __init__(self, folder: Path) -> None:
        """Nothing is made before the first project is."""
        self.folder = folder

    def summaries(self) -> list[dict[str, Any]]:
        """All projects, the latest first."""
        found = [project.summary() for project in self._all(self.folder)]
        return sorted(found, key=lambda summary: summary["saved"], reverse=True)

    def open(self, name: str) -> StoredProject:
        """A project by its id.

        Raises:
            ProjectMissingError: There is none.
        """
        for project in self._all(self.folder):
            if project.content["id"] == name:
                return project
        raise ProjectMissingError

    def create(self, content: dict[str, Any]) -> StoredProject:
        """A new project.

        Args:
            content: As `models.projects.ProjectContent`.

        Raises:
            InputError: The folder cannot be written.
        """
        name = secrets.token_urlsafe(16)
        slug = _NAME.sub("-", content["name"]).strip("-").lower()[:40] or "project"
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            folder = self._new_folder(slug)
        except OSError as error:
            raise InputError(
                f"Cannot make a project in '{self.folder}': {error.strerror or error}."
            ) from error
        try:
            return self._write(folder, name, 1, content)
        except BaseException:  # a full disk: nothing is left that would look like a project
            with suppress(OSError):
                folder.rmdir()
            raise

    def save(self, name: str, revision: int, content: dict[str, Any]) -> StoredProject:
        """Replaces what was saved before; an autosave before it goes.

        Raises:
            ProjectMissingError: There is no such project.
            ProjectChangedError: `revision` is not its latest.
            InputError: The folder cannot be written.
        """
        project = self._unchanged(name, revision)
        saved = self._write(project.folder, name, revision + 1, content)
        (project.folder / DRAFT).unlink(missing_ok=True)
        return saved

    def save_draft(self, name: str, revision: int, content: dict[str, Any]) -> StoredProject:
        """Keeps an autosave beside what was saved.

        Raises:
            ProjectMissingError: There is no such project.
            ProjectChangedError: `revision` is not its latest.
            InputError: The folder cannot be written.
        """
        project = self._unchanged(name, revision)
        draft = {"format": FORMAT, "revision": revision, "content": content}
        write_text(project.folder / DRAFT, _text(draft), overwrite=True)
        return project

    def delete(self, name: str) -> None:
        """Moves a project to the trash folder.

        Raises:
            ProjectMissingError: There is none.
        """
        project = self.open(name)
        trash = self.folder / TRASH
        trash.mkdir(exist_ok=True)
        os.replace(project.folder, self._free(trash, project.folder.name))

    def restore(self, name: str) -> StoredProject:
        """Takes a project out of the trash folder.

        Raises:
            ProjectMissingError: It is not there.
        """
        for project in self._all(self.folder / TRASH):
            if project.content["id"] == name:
                place = self._free(self.folder, project.folder.name)
                os.replace(project.folder, place)
                return StoredProject(place, project.content, project.draft)
        raise ProjectMissingError

    def _write(self, folder: Path, name: str, revision: int, content: dict[str, Any]) -> StoredProject:
        stored = {
            "format": FORMAT,
            "id": name,
            "revision": revision,
            "saved": now(),
            "content": content,
        }
        write_text(folder / STUDIO, _text(stored), overwrite=True)
        return StoredProject(folder, stored, None)

    def _unchanged(self, name: str, revision: int) -> StoredProject:
        project = self.open(name)
        if project.content["revision"] != revision:
            raise ProjectChangedError
        return project

    def _new_folder(self, slug: str) -> Path:
        for number in range(1, 10_000):
            folder = self.folder / (slug if number == 1 else f"{slug}-{number}")
            try:
                folder.mkdir()
            except FileExistsError:
                continue
            return folder
        raise InputError(f"There are 10,000 projects of the name '{slug}'. Choose another name.")

    def _free(self, parent: Path, name: str) -> Path:
        """A name in a folder that nothing has; of the form name-2 where it has to be another."""
        place, number = parent / name, 1
        while os.path.lexists(place):
            number += 1
            place = parent / f"{name}-{number}"
        return place

    def _all(self, parent: Path) -> Iterator[StoredProject]:
        try:
            folders = sorted(p for p in parent.iterdir() if p.is_dir() and not p.is_symlink())
        except OSError:
            return
        for folder in folders:
            project = _read(folder)
            if project is not None:
                yield project


def now() -> str:
    """The time, ISO 8601, UTC."""
    return datetime.now(UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")


def _read(folder: Path) -> StoredProject | None:
    content = _json(folder / STUDIO)
    if content is None or content.get("format") != FORMAT:
        return None
    parts = (content.get("id"), content.get("revision"), content.get("saved"), content.get("content"))
    if [type(part) for part in parts] != [str, int, str, dict] or not _ID.fullmatch(content["id"]):
        return None
    draft = _json(folder / DRAFT)
    newer = draft is not None and draft.get("revision") == content["revision"]
    kept = draft.get("content") if newer and draft is not None else None
    return StoredProject(folder, content, kept if isinstance(kept, dict) else None)


def _json(path: Path) -> dict[str, Any] | None:
    try:
        if path.stat().st_size > _LARGEST:
            return None
        value = json.loads(path.read_bytes())
    except (OSError, ValueError, RecursionError):
        return None
    return value if isinstance(value, dict) else None


def _text(value: dict[str, Any]) -> str:
    return json.dumps(value, separators=(",", ":"), allow_nan=False, ensure_ascii=True) + "\n"
