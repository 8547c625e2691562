"""Putting claims into words."""

from __future__ import annotations

from swifttailor.data.captions.writing.styles import STYLES
from swifttailor.data.captions.writing.writer import Caption, write_caption, write_captions, write_claims

__all__ = ["STYLES", "Caption", "write_caption", "write_captions", "write_claims"]
