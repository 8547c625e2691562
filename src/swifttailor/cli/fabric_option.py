"""What garments are made of: the option of all commands that make them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.cli.postponed_imports import tyro


@dataclass(frozen=True, kw_only=True)
class FabricOption:
    """A fabric by its name."""

    fabric: Annotated[str | None, tyro.conf.arg(metavar="NAME")] = None
    """cotton (the default), linen, twill, denim, silk, chiffon, wool, leather, polyester, jersey, rib-knit,
    sweatshirt, ponte, fleece or swimwear; swifttailor fabrics shows what they are. Physics hangs it (drape,
    --finish); the network knows no fabrics, and without physics it decides weight and shine alone."""

    def require_fabric(self) -> None:
        """Refuses a fabric that is not known.

        Raises:
            InputError: There is no such fabric.
        """
        if self.fabric is not None:
            from swifttailor.draping.known_fabrics import get_fabric

            get_fabric(self.fabric)
