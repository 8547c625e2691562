"""All targets by name."""

from __future__ import annotations

from importlib import import_module

from fuzzing.target import Target

MODULES = ("patterns", "pictures", "networks", "geometry_images", "shards", "meshes", "style3d", "designs")


def all_targets() -> dict[str, Target]:
    """Every target, by name."""
    found: dict[str, Target] = {}
    for module in MODULES:
        found |= targets_in(f"fuzzing.targets.{module}")
    return found


def targets_in(module: str) -> dict[str, Target]:
    """The targets of a module, by name."""
    return {target.name: target for target in import_module(module).TARGETS}


def module_of(name: str) -> str:
    """The module that has a target."""
    return next(m for m in (f"fuzzing.targets.{module}" for module in MODULES) if name in targets_in(m))
