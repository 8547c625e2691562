"""Pictures that were uploaded: the last ones, in memory, by ids that cannot be guessed."""

from __future__ import annotations

import secrets
from collections import OrderedDict
from dataclasses import dataclass, field
from typing import Any

from swifttailor.arrays import Pixels


@dataclass(eq=False)
class PictureRecord:
    """One picture."""

    pixels: Pixels
    """(h, w, 3) sRGB, upright, row 0 at the top."""
    png: bytes
    seen: bytes | None = None
    """PNG of what is looked at in it, once it was asked for."""
    id: str = field(default_factory=lambda: secrets.token_urlsafe(16))

    def to_json(self) -> dict[str, Any]:
        """As `models.projects.FileInfo`."""
        height, width = self.pixels.shape[:2]
        url = f"/api/files/{self.id}"
        return {"id": self.id, "width": width, "height": height, "url": url, "seen_url": f"{url}/seen"}


class PictureStore:
    """Keeps the pictures that were used last."""

    def __init__(self, most: int) -> None:
        """It is empty."""
        self._most = most
        self._records: OrderedDict[str, PictureRecord] = OrderedDict()

    def add(self, record: PictureRecord) -> None:
        """Keeps a picture, and drops the oldest where there are too many."""
        self._records[record.id] = record
        while len(self._records) > self._most:
            self._records.popitem(last=False)

    def find(self, name: str) -> PictureRecord | None:
        """A picture by its id."""
        if name in self._records:
            self._records.move_to_end(name)
        return self._records.get(name)
