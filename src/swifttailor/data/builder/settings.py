"""What all samples of a split are made with."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from swifttailor import __version__
from swifttailor.body import Body
from swifttailor.draping.batch import BatchSettings

SHARD_SIZE = 256
NETWORK = "network"
"""Engine of garments that GarmentSewer has sewn."""


@dataclass(frozen=True)
class BuildSettings:
    """Settings of a split."""

    drape: BatchSettings = field(default_factory=lambda: BatchSettings(preview=False))
    """How patterns are read and draped."""
    shard_size: int = SHARD_SIZE
    """Patterns to a shard, those included that are not accepted."""
    origin: str = ""
    """The data set that drapes were taken from, where they were not made here. Of `drape`, edge length and
    reading of the angles then count alone."""
    origin_body: str = ""
    """What those drapes hang on."""
    network: str = ""
    """Checksum of GarmentSewer's weights, where the garments are its own instead of drapes."""

    def identity(self) -> dict[str, Any]:
        """All that decides what the shards look like, as JSON values."""
        if self.origin:
            kept = {"edge_length": self.drape.edge_length, "rotation": self.drape.rotation}
            body = {"name": self.origin_body, "sha256": ""}
            origin = {"origin": self.origin, "body": body, "version": __version__}
            return kept | origin | {"shard_size": self.shard_size}
        values = self.drape.identity()
        values["body"] = body_identity(self.drape.load_body())
        if self.network:
            values |= {"engine": NETWORK, "weights": self.network}
        return values | {"shard_size": self.shard_size}


def body_identity(body: Body) -> dict[str, str]:
    """Name and checksum of a body: its surface and its measurements."""
    digest = hashlib.sha256()
    digest.update(np.ascontiguousarray(body.vertices, dtype="<f8").tobytes())
    digest.update(np.ascontiguousarray(body.faces, dtype="<i4").tobytes())
    digest.update(repr(body.measurements).encode())
    return {"name": body.name, "sha256": digest.hexdigest()}
