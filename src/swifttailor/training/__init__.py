"""Training of the networks: one loop each, checkpoints, run records."""

from __future__ import annotations
