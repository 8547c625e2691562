"""Outputs of released systems (AIpparel, ChatGarment, SewingLDM, ...), read from the folders that they write.

What of each system's files is read, and what is lost: docs/released-outputs.md.
"""

from __future__ import annotations

from swifttailor.data.released.output import Output
from swifttailor.data.released.reading import LAYOUTS, read_outputs

__all__ = ["LAYOUTS", "Output", "read_outputs"]
