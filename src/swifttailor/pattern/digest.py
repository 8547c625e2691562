"""What tells patterns apart, whatever they are called and in whatever order they were written."""

from __future__ import annotations

import hashlib
import json

from swifttailor.pattern import Pattern, to_specification


def pattern_digest(pattern: Pattern) -> str:
    """SHA-256 of panels and stitches in canonical order, without the pattern's name."""
    content = to_specification(pattern.canonical())["pattern"]
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()
