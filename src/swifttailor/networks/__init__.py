"""ONNX, for both networks: running them without torch, and writing what torch has trained.

May import errors and what lies beside it on the lowest floors.
"""

from __future__ import annotations
