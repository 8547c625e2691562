"""The built client ships, and is built from the sources that are there."""

from __future__ import annotations

import hashlib
import re
from pathlib import Path

from swifttailor.studio.app.client_files import FOLDER, STAMP, read_client

ROOT = Path(__file__).parents[2]
SOURCES = ROOT / "studio-ui"
SINGLE = ("index.html", "package-lock.json", "package.json", "tsconfig.json", "vite.config.ts")
LARGEST_GZIPPED = 400_000


def hash_of_sources(folder: Path) -> str:
    """As studio-ui/scripts/stamp.mjs computes it; studio-ui/API.md says how."""
    paths = [folder / name for name in SINGLE]
    paths += [p for part in ("src", "public") for p in (folder / part).rglob("*") if p.is_file()]
    names = sorted((p.relative_to(folder).as_posix() for p in paths), key=str.encode)
    total = hashlib.sha256()
    for name in names:
        content = hashlib.sha256((folder / name).read_bytes()).hexdigest()
        total.update(f"{name}\n{content}\n".encode())
    return total.hexdigest()


def test_it_is_built_from_these_sources():
    stamped = (FOLDER / STAMP).read_text().strip()
    assert stamped == hash_of_sources(SOURCES), "the client is stale: make studio"


def test_it_asks_no_other_host():
    for name, file in read_client().items():
        if name.endswith((".html", ".css")):
            assert not re.search(rb"https?://", file.content), name
        if name.endswith(".html"):
            assert not re.search(rb"<script(?![^>]*\ssrc=)", file.content), f"{name} has an inline script"


def test_everything_the_page_needs_is_there_and_small():
    files = read_client()
    index = files["index.html"].content.decode()
    needed = re.findall(r'(?:src|href)="\./([^"]+)"', index)
    assert needed and all(name in files for name in needed)
    packed = sum(len(file.packed) for file in files.values() if file.packed is not None)
    assert packed <= LARGEST_GZIPPED


def test_a_checkout_without_it_serves_a_page_that_says_so(tmp_path):
    assert read_client(tmp_path) == {}
