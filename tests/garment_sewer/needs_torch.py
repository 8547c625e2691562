"""Marks tests that need the extra `train`."""

from __future__ import annotations

import importlib.util

import pytest

HAS_TORCH = all(importlib.util.find_spec(name) for name in ("torch", "transformers"))

needs_torch = pytest.mark.skipif(
    not HAS_TORCH, reason="torch and transformers are not installed: pip install 'swifttailor[train]'"
)
