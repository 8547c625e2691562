"""What a text asks for: its statements about a garment, read by a small network of its own."""

from __future__ import annotations
