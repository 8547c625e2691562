"""Packages that every run would load and few need: they are loaded when something of them is asked for."""

from __future__ import annotations

import sys
from importlib.util import LazyLoader, find_spec, module_from_spec
from types import ModuleType
from typing import TYPE_CHECKING

_OF_NUMPY = ("testing", "f2py")


def postpone_parts_of_numpy() -> None:
    """Has parts of numpy loaded when they are used: scipy takes hold of all of them, and runs none.

    They bring half the standard library with them.
    """
    import numpy

    for name in _OF_NUMPY:
        setattr(numpy, name, _postponed(f"numpy.{name}"))


def _postponed(name: str) -> ModuleType:
    """A module that is loaded, for the whole process, when something in it is asked for."""
    if name in sys.modules:
        return sys.modules[name]
    spec = find_spec(name)
    if spec is None or spec.loader is None:
        raise ModuleNotFoundError(f"No module named {name!r}", name=name)
    spec.loader = LazyLoader(spec.loader)
    sys.modules[name] = module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


if TYPE_CHECKING:
    import tyro
else:
    # An import statement would load it; options are annotated with it and rarely need it (`plain_options`).
    tyro = _postponed("tyro")

__all__ = ["postpone_parts_of_numpy", "tyro"]
