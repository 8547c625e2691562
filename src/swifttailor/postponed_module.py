"""Modules that are loaded when something of them is asked for, not where they are imported."""

from __future__ import annotations

import sys
from importlib import import_module
from importlib.util import LazyLoader, find_spec, module_from_spec
from types import ModuleType


def postponed(name: str) -> ModuleType:
    """A module that is loaded, for the whole process, when something in it is asked for.

    Args:
        name: Full name. The package that it lies in is loaded at once.

    Raises:
        ModuleNotFoundError: There is no such module.
    """
    if name in sys.modules:
        return sys.modules[name]
    spec = find_spec(name)
    if spec is None or spec.loader is None:
        raise ModuleNotFoundError(f"No module named {name!r}", name=name)
    spec.loader = LazyLoader(spec.loader)
    sys.modules[name] = module = module_from_spec(spec)
    spec.loader.exec_module(module)
    package, _, last = name.rpartition(".")
    if package:
        # What the package has already, `from package import module` takes as it is.
        setattr(import_module(package), last, module)
    return module
