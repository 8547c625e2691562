"""Garments against reference garments: distances of surfaces, and what a garment is like by itself."""

from __future__ import annotations
