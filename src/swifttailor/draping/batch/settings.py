"""What all garments of a batch are made with."""

from __future__ import annotations

import hashlib
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from swifttailor import __version__
from swifttailor.body import Body
from swifttailor.draping.engines import find_engine
from swifttailor.draping.known_fabrics import get_fabric
from swifttailor.errors import InputError
from swifttailor.pattern.panel import RotationReading


@dataclass(frozen=True)
class BatchSettings:
    """Settings of a batch; the arguments of `swifttailor.drape` and how patterns are read."""

    fabric: str = "cotton"
    edge_length: float = 2.0
    engine: str = "xpbd"
    seed: int = 0
    body: Path | None = None
    """Body mesh; the default body when None."""
    rotation: RotationReading = "intrinsic"
    repair: bool = False
    preview: bool = True
    """Whether to draw preview.png. Does not change the garments, so it may differ between runs."""

    def load_body(self) -> Body:
        """The body all garments are draped on."""
        return Body.default() if self.body is None else Body.load(self.body)

    def require_usable(self) -> None:
        """Finds out before the first worker starts what would fail in each of them.

        Raises:
            SwiftTailorError: The fabric, the engine or the body is not usable.
        """
        get_fabric(self.fabric)
        find_engine(self.engine)
        self.load_body()

    def identity(self) -> dict[str, Any]:
        """All that decides what the garments look like, as JSON values.

        Garments of two runs may lie in one folder only where these agree.
        """
        values = asdict(self)
        del values["preview"]
        values["body"] = "default" if self.body is None else _content_name(self.body)
        return values | {"version": __version__}


def _content_name(path: Path) -> str:
    try:
        digest = hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError as error:
        raise InputError(f"Cannot read the body '{path}': {error.strerror or error}.") from error
    return f"{path.name} (sha256 {digest[:16]})"
