"""Work spread over processes of this machine or over a Ray cluster, and folders it can be resumed in.

May import errors and files of the lowest floor.
"""

from __future__ import annotations

from swifttailor.workers.interruption import sigterm_as_interrupt
from swifttailor.workers.process_pool import Outcome, run_tasks

__all__ = ["Outcome", "run_tasks", "sigterm_as_interrupt"]
