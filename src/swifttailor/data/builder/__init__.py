"""Building a data set: patterns in, shards of drapes out; resumable, on many processes or machines."""

from __future__ import annotations

from swifttailor.data.builder.run import build_split
from swifttailor.data.builder.settings import BuildSettings

__all__ = ["BuildSettings", "build_split"]
