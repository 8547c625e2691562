"""Names that a package loads when they are first used (PEP 562), so that importing it costs nothing."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any


def loaded_on_first_use(package: str, where: Mapping[str, str]) -> Callable[[str], Any]:
    """Makes the `__getattr__` of a package.

    Args:
        package: Its name.
        where: For each name it offers the module below the package that holds it, and after a colon what it
            is called there where that differs: ``{"check": "pattern:check_pattern"}``.
    """

    def find(name: str) -> Any:
        if name not in where:
            raise AttributeError(f"module '{package}' has no attribute '{name}'")
        module, _, inside = where[name].partition(":")
        return getattr(import_module(f"{package}.{module}"), inside or name)

    return find
