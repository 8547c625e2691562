"""Many drapes: worker processes, results that survive a crash, a summary and sheets of previews."""

from __future__ import annotations

from swifttailor.draping.batch.run import run_batch
from swifttailor.draping.batch.settings import BatchSettings

__all__ = ["BatchSettings", "run_batch"]
