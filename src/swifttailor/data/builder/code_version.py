"""Which code made a data set: version, commit and a checksum of what decides a drape."""

from __future__ import annotations

import hashlib
import subprocess
from pathlib import Path

import swifttailor

ROOMS = ("pattern", "body", "garment/garment.py", "panel_mesh", "draping")
"""What a drape depends on; the folder draping/batch only runs it."""
_RUNS_ONLY = ("draping", "batch")


def code_version() -> dict[str, str]:
    """Version, commit (empty outside a checkout; with a + where files were changed) and code checksum."""
    root = Path(swifttailor.__file__).parent
    return {"version": swifttailor.__version__, "commit": _commit(root), "code": _checksum(root)}


def _checksum(root: Path) -> str:
    digest = hashlib.sha256()
    for room in ROOMS:
        files = [root / room] if room.endswith(".py") else sorted((root / room).rglob("*"))
        for path in files:
            name = path.relative_to(root)
            if path.suffix in (".py", ".npz") and name.parts[:2] != _RUNS_ONLY:
                digest.update(f"{name.as_posix()}\0".encode() + path.read_bytes() + b"\0")
    return digest.hexdigest()[:16]


def _commit(root: Path) -> str:
    checkout = root.parents[1]
    if not (checkout / ".git").exists():
        return ""
    try:
        head, changed = (
            subprocess.run(
                ["git", "-C", str(checkout), *command], capture_output=True, text=True, check=True, timeout=20
            ).stdout.strip()
            for command in (["rev-parse", "HEAD"], ["status", "--porcelain", "--", "src"])
        )
    except (OSError, subprocess.SubprocessError):
        return ""
    return head + ("+" if changed else "")
