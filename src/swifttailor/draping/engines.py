"""Physics engines by name: our own, those registered in this process, those that installed packages offer."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from importlib import metadata

from swifttailor.draping.engine import Engine
from swifttailor.errors import InputError

ENTRY_POINTS = "swifttailor.engines"
"""Group under which installed packages offer engines: ``name = "package.module:make"``."""

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


def _entry_points() -> Iterator[metadata.EntryPoint]:
    yield from metadata.entry_points(group=ENTRY_POINTS)
