"""What is known of each pixel before anything is predicted: the pattern, a prior in space, the body."""

from __future__ import annotations
