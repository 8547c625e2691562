"""Networks as files: ONNX graphs run without torch, model files read and written, texts as tokens.

May import errors and what lies beside it on the lowest floors.
"""

from __future__ import annotations
