"""What the server refuses beyond."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.render.picture_file import MOST_PIXELS
from swifttailor.studio.models.base import MOST_LETTERS
from swifttailor.studio.models.jobs import MOST_VARIANTS
from swifttailor.studio.models.projects import MOST_VERSIONS

MIB = 2**20


@dataclass(frozen=True)
class ServerLimits:
    """Numbers that keep the server's memory and time bounded."""

    upload_bytes: int = 16 * MIB
    pattern_bytes: int = 4 * MIB
    """Of a request with a pattern in it."""
    project_bytes: int = 32 * MIB
    """Of a request that saves a project."""
    queue: int = 8
    """Jobs that wait."""
    quick_waiting: int = 24
    live_clients: int = 32
    """That wait for live sewing at the same time."""
    job_seconds: float = 180.0
    quick_seconds: float = 30.0
    live_seconds: float = 10.0
    body_seconds: float = 20.0
    """Within which the whole body of a request has to come."""
    header_seconds: float = 10.0
    """Within which the head of a request has to come, and how long an idle connection is kept."""
    connections: int = 200
    streams: int = 64
    """Event streams at the same time."""
    files: int = 24
    """Uploaded pictures that are kept."""
    mesh_bytes: int = 192 * MIB

    def to_json(self, of_patterns: dict[str, int]) -> dict[str, int]:
        """What clients may know, `models.projects.Limits`.

        Args:
            of_patterns: Panels and edges that the reader of patterns accepts.
        """
        return of_patterns | {
            "upload_bytes": self.upload_bytes,
            "picture_pixels": MOST_PIXELS,
            "pattern_bytes": self.pattern_bytes,
            "prompt_letters": MOST_LETTERS,
            "variants": MOST_VARIANTS,
            "queue": self.queue,
            "job_seconds": int(self.job_seconds),
            "project_versions": MOST_VERSIONS,
        }
