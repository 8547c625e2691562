"""How long an inch is."""

from __future__ import annotations

CM_PER_INCH = 2.54
"""By definition since 1959."""
