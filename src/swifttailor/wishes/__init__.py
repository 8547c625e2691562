"""What a text asks for: its statements about a garment, read by a small network of its own.

May import wording, describing, networks and what lies below them.
"""

from __future__ import annotations
