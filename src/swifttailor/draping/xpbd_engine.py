"""Our own solver as an engine: extended position-based dynamics in numba."""

from __future__ import annotations

from swifttailor.draping.engine import Settled, SewnGarment
from swifttailor.draping.untangle import settle_untangled
from swifttailor.progress import StageProgress


class XpbdEngine:
    """Lets the sewn garment fall, and untangles it where it crosses itself at rest."""

    def settle(self, sewn: SewnGarment, progress: StageProgress) -> Settled:
        """See `Engine`."""
        frames, static = settle_untangled(sewn.simulation, progress)
        return Settled(sewn.simulation.positions, frames, static)
