"""Training of the networks: one loop each, checkpoints, run records.

May import evaluation, data and everything below them.
"""

from __future__ import annotations
