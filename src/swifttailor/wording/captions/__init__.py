"""Putting claims into words."""

from __future__ import annotations

from swifttailor.wording.captions.styles import STYLES
from swifttailor.wording.captions.writer import Caption, write_caption, write_captions, write_claims

__all__ = ["STYLES", "Caption", "write_caption", "write_captions", "write_claims"]
