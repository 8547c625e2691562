"""Ways from a pattern to a garment: GarmentSewer, with or without physics in the end, and physics alone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Protocol

from swifttailor.clock import Clock
from swifttailor.data.builder.code_version import code_version
from swifttailor.draping import drape
from swifttailor.draping.finish import finish as hang_to_rest
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.relaxing import relaxed
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.pattern import Pattern


class Constructor(Protocol):
    """Makes garments of patterns. Bring your own: `run_systems` takes anything with these three."""

    @property
    def name(self) -> str:
        """In tables and file names, as that of a `Generator`."""
        ...

    def identity(self) -> dict[str, Any]:
        """What decides its garments, as JSON values."""
        ...

    def make(self, pattern: Pattern) -> Garment:
        """The garment of a pattern, on the default body.

        Its report has ``seconds`` by stage, and ``quality`` where it came to rest by physics (`drape`,
        `finish`): with ``accepted`` and ``reasons``.

        Raises:
            SwiftTailorError: None can be made of it.
        """
        ...


@dataclass(frozen=True, eq=False)
class NetworkConstructor:
    """GarmentSewer, as `sew` ships it; `finish` lets its garments hang to rest."""

    sewer: GarmentSewer
    weights: Mapping[str, Any]
    finish: bool = False
    edge_length: float = 2.0

    @property
    def name(self) -> str:
        """See `Constructor`."""
        return "network+finish" if self.finish else "network"

    def identity(self) -> dict[str, Any]:
        """See `Constructor`."""
        physics = {"relaxed": True} | ({"code": code_version()["code"]} if self.finish else {})
        return {
            "weights": dict(self.weights),
            "finish": self.finish,
            "edge_length": self.edge_length,
        } | physics

    def make(self, pattern: Pattern) -> Garment:
        """See `Constructor`."""
        clock = Clock()
        garment = self.sewer.sew(pattern, edge_length=self.edge_length)
        clock.stop("sewing")
        if self.finish:
            garment = hang_to_rest(relaxed(garment))
            clock.stop("finishing")
        else:
            garment = relaxed(garment)
            clock.stop("relaxing")
        return replace(garment, report=garment.report | {"seconds": clock.seconds})


@dataclass(frozen=True, eq=False)
class PhysicsConstructor:
    """The drape by simulation that GarmentSewer replaces."""

    engine: str = "xpbd"
    edge_length: float = 2.0

    @property
    def name(self) -> str:
        """See `Constructor`."""
        return "physics" if self.engine == "xpbd" else f"physics-{self.engine}"

    def identity(self) -> dict[str, Any]:
        """See `Constructor`."""
        return {"engine": self.engine, "edge_length": self.edge_length, "code": code_version()["code"]}

    def make(self, pattern: Pattern) -> Garment:
        """See `Constructor`."""
        clock = Clock()
        garment = drape(pattern, engine=self.engine, edge_length=self.edge_length)
        clock.stop("draping")
        return replace(garment, report=garment.report | {"seconds": clock.seconds})
