"""What ships with the studio, so that its first page needs no computing: examples, body, options.

Made by scripts/make_studio_examples.py.
"""

from __future__ import annotations

import gzip
import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from swifttailor.studio.compact_mesh import expand
from swifttailor.studio.mesh_record import MeshRecord, name_of

FOLDER = Path(__file__).with_name("shipped_data")
OPTIONS, BODY = "options.json.gz", "body.mesh.gz"
DOCUMENT, MESH, THUMBNAIL = ".json.gz", ".mesh.gz", ".webp"


@dataclass(frozen=True, eq=False)
class ShippedExample:
    """A garment that is there from the start."""

    id: str
    document: dict[str, Any]
    """`models.documents.Document`."""
    mesh: MeshRecord
    thumbnail: bytes
    """image/webp."""

    def to_json(self) -> dict[str, str]:
        """As `models.projects.Example`."""
        about = {"id": self.id, "title": self.document["title"], "prompt": self.document["prompt"]}
        return about | {"thumbnail": f"/api/examples/{self.id}/thumbnail"}


@cache
def shipped_options() -> dict[str, Any]:
    """``claims`` and ``dimensions`` of `bench.claim_labels`; ``of_patterns``, limits of their reader."""
    return json.loads(gzip.decompress((FOLDER / OPTIONS).read_bytes()))


@cache
def shipped_body() -> MeshRecord:
    """The default body."""
    data = expand((FOLDER / BODY).read_bytes())
    return MeshRecord(name_of(data), data)


@cache
def shipped_examples() -> dict[str, ShippedExample]:
    """All examples by id, in the order of the gallery."""
    found = {}
    for name in shipped_options()["examples"]:
        document = json.loads(gzip.decompress((FOLDER / f"{name}{DOCUMENT}").read_bytes()))
        data = expand((FOLDER / f"{name}{MESH}").read_bytes())
        pattern = json.dumps(document["pattern"], separators=(",", ":"))
        mesh = MeshRecord(name_of(data), data, pattern, document["edge_length"], {}, document["color"])
        document |= {"mesh": mesh.name, "body": shipped_body().name, "origin": "example"}
        thumbnail = (FOLDER / f"{name}{THUMBNAIL}").read_bytes()
        found[name] = ShippedExample(name, document, mesh, thumbnail)
    return found
