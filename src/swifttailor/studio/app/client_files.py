"""The built client: read once, served from memory, so that no path of a request is one on the disk."""

from __future__ import annotations

import gzip
import hashlib
import mimetypes
from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).parents[1] / "client"
STAMP = "sources.sha256"
"""Holds the hash of the sources that the client was built from."""
_TYPES = {
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".html": "text/html; charset=utf-8",
}
_PACKED = (".js", ".css", ".html", ".svg", ".json")
NOT_BUILT = b"""<!doctype html><html lang="en"><meta charset="utf-8"><title>SwiftTailor studio</title>
<body><h1>The studio's page is not built</h1>
<p>This is a checkout without the built client. In its folder run:
<code>make studio</code> (needs Node 20), and start again.
The API is described at <a href="/api/openapi.json">/api/openapi.json</a>.</p></html>"""


@dataclass(frozen=True)
class ClientFile:
    """One file of the client."""

    content: bytes
    packed: bytes | None
    """By gzip, where that is worth it."""
    type: str
    tag: str
    """Changes with the content."""
    immutable: bool
    """Whether its name does, too."""


def read_client(folder: Path = FOLDER) -> dict[str, ClientFile]:
    """All files of the built client by their path in the address; empty where it is not built."""
    if not (folder / "index.html").is_file():
        return {}
    found = {}
    for path in sorted(p for p in folder.rglob("*") if p.is_file() and p.name != STAMP):
        name = path.relative_to(folder).as_posix()
        content = path.read_bytes()
        kind = _TYPES.get(path.suffix) or mimetypes.guess_type(path.name)[0] or "application/octet-stream"
        packed = gzip.compress(content, 6, mtime=0) if path.suffix in _PACKED else None
        tag = f'"{hashlib.blake2b(content, digest_size=12).hexdigest()}"'
        found[name] = ClientFile(content, packed, kind, tag, name.startswith("assets/"))
    return found
