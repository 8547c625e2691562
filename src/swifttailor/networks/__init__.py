"""ONNX, for both networks: running them without torch, and writing what torch has trained."""

from __future__ import annotations
