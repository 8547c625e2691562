"""What a physics engine is: a sewn garment in, the garment at rest out (docs/engines.md)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib import metadata
from typing import TYPE_CHECKING, Protocol, runtime_checkable

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.errors import InputError, SimulationError
from swifttailor.progress import StageProgress

if TYPE_CHECKING:
    from swifttailor.body import Body
    from swifttailor.draping.cloth import ClothModel
    from swifttailor.draping.fabric import Fabric
    from swifttailor.draping.simulation import Simulation
    from swifttailor.panel_mesh.pattern_mesh import PatternMesh

ENTRY_POINTS = "swifttailor.engines"
"""Group under which installed packages offer engines: ``name = "package.module:make"``."""


@dataclass(frozen=True, eq=False)
class SewnGarment:
    """A garment whose seams are closed around the body, before it hangs to rest."""

    mesh: PatternMesh
    """Faces, seams and the flat panels: the rest shape of the cloth."""
    body: Body
    fabric: Fabric
    cloth: ClothModel
    """Masses in kg, and springs with their rest lengths in cm."""
    simulation: Simulation
    """Our own solver, in the state that sewing left it in; an engine may let it go on."""

    @property
    def positions(self) -> Floats:
        """(v, 3) cm, of the welded vertices; a copy."""
        return self.simulation.positions.copy()


@dataclass(frozen=True, eq=False)
class Settled:
    """Where an engine leaves a garment."""

    positions: Floats
    """(v, 3) cm, of the welded vertices."""
    frames: int
    """Of 1/60 s that were simulated."""
    static: bool
    """Whether the garment came to rest."""


@runtime_checkable
class Engine(Protocol):
    """Lets a garment hang to rest."""

    def settle(self, sewn: SewnGarment, progress: StageProgress) -> Settled:
        """Lets a garment hang to rest.

        Args:
            sewn: What it begins with.
            progress: To be called with "draping" and the share that is done.
        """
        ...


EngineMaker = Callable[[], Engine]


def _xpbd() -> Engine:
    from swifttailor.draping.xpbd_engine import XpbdEngine

    return XpbdEngine()


def _newton() -> Engine:
    from swifttailor.draping.newton_engine import NewtonEngine

    return NewtonEngine()


_MAKERS: dict[str, EngineMaker] = {"xpbd": _xpbd, "newton": _newton}


def register_engine(name: str, make: EngineMaker) -> None:
    """Makes an engine known by a name, for this process.

    Worker processes and the command line know those that installed packages offer as entry points of the
    group `ENTRY_POINTS`.

    Args:
        name: What ``drape(engine=...)`` calls it.
        make: Called without arguments for each garment.

    Raises:
        InputError: The name is taken.
    """
    if name in engine_names():
        raise InputError(f"There is an engine '{name}' already. Known engines: {', '.join(engine_names())}.")
    _MAKERS[name] = make


def engine_names() -> tuple[str, ...]:
    """All names that `find_engine` accepts."""
    return tuple(dict.fromkeys((*_MAKERS, *(point.name for point in _entry_points()))))


def find_engine(name: str) -> Engine:
    """The engine of a name.

    Raises:
        InputError: There is none, or what a package offers is none.
        MissingExtraError: It needs a package that is not installed.
    """
    if name in _MAKERS:
        return _MAKERS[name]()
    for point in _entry_points():
        if point.name == name:
            engine = point.load()()
            if not isinstance(engine, Engine):
                raise InputError(
                    f"'{point.value}' is offered as the engine '{name}' and makes a {type(engine).__name__} "
                    "without a method 'settle'. See swifttailor.draping.engine.Engine."
                )
            return engine
    raise InputError(f"There is no engine '{name}'. Known engines: {', '.join(engine_names())}.")


def require_settled(settled: Settled, sewn: SewnGarment) -> Settled:
    """What an engine returned, if it can be the same garment.

    Raises:
        SimulationError: Positions are missing or not finite.
    """
    positions = np.asarray(settled.positions)
    if positions.shape != (sewn.mesh.vertex_count, 3):
        raise SimulationError(
            f"The engine returned positions of shape {positions.shape}; ({sewn.mesh.vertex_count}, 3) is "
            "expected: one for each welded vertex, in cm."
        )
    if not np.isfinite(positions).all():
        raise SimulationError(
            "The cloth moved to infinity. Check the pattern for degenerate panels with "
            "'swifttailor check', or use a longer edge length or a softer fabric."
        )
    return settled


def _entry_points() -> Iterator[metadata.EntryPoint]:
    yield from metadata.entry_points(group=ENTRY_POINTS)
