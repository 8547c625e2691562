"""What ships with the studio, so that its first page needs no computing: examples, body, options.

Made by scripts/make_studio_examples.py.
"""

from __future__ import annotations

import gzip
import json
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from typing import Any

from swifttailor.studio.compact_mesh import expand
from swifttailor.studio.mesh_record import MeshRecord

FOLDER = Path(__file__).with_name("shipped_data")
OPTIONS, BODY = "options.json.gz", "body.mesh.gz"
DOCUMENT, MESH, THUMBNAIL = ".json.gz", ".mesh.gz", ".webp"


@dataclass(frozen=True, eq=False)
class ShippedExample:
    """A garment that is there from the start."""

    id: str
    document: dict[str, Any]
    """`models.documents.Document`."""

    @cached_property
    def mesh(self) -> MeshRecord:
        """Its garment."""
        document, data = self.document, expand((FOLDER / f"{self.id}{MESH}").read_bytes())
        pattern = json.dumps(document["pattern"], separators=(",", ":"))
        return MeshRecord(document["mesh"], data, pattern, document["edge_length"], {}, document["color"])

    @cached_property
    def thumbnail(self) -> bytes:
        """Its picture, image/webp."""
        return (FOLDER / f"{self.id}{THUMBNAIL}").read_bytes()

    def to_json(self) -> dict[str, str]:
        """As `models.projects.Example`."""
        about = {"id": self.id, "title": self.document["title"], "prompt": self.document["prompt"]}
        return about | {"thumbnail": f"/api/examples/{self.id}/thumbnail"}


@cache
def shipped_options() -> dict[str, Any]:
    """Ids of the ``examples``, name of the ``body``; ``claims`` and ``dimensions`` that can be chosen.

    Also ``of_patterns``: how many panels and edges their reader accepts.
    """
    return json.loads(gzip.decompress((FOLDER / OPTIONS).read_bytes()))


@cache
def shipped_body() -> MeshRecord:
    """The default body."""
    return MeshRecord(shipped_options()["body"], expand((FOLDER / BODY).read_bytes()))


@cache
def shipped_examples() -> dict[str, ShippedExample]:
    """All examples by id, in the order of the gallery."""
    return {
        name: ShippedExample(name, json.loads(gzip.decompress((FOLDER / f"{name}{DOCUMENT}").read_bytes())))
        for name in shipped_options()["examples"]
    }
