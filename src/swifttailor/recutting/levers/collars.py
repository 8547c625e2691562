"""Levers of collars and hoods: sewn on, and hoods of another size."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.describing.facts import Collar, CollarKind, GarmentFacts, Hood
from swifttailor.describing.facts_paths import imagine_at
from swifttailor.recutting.amounts import neck_cuts
from swifttailor.recutting.levers.lever import Lever, fixed, of_dimension
from swifttailor.recutting.levers.necks import plain_neck

_HOOD_HEIGHT_CM, _HOOD_DEPTH_CM = 52.0, 32.0
"""Of a new hood: what GarmentCode's have on average."""


def _has_neck(facts: GarmentFacts) -> bool:
    """Whether there is a neckline of two shoulders that nothing is sewn to."""
    if facts.collar is not None or facts.hood is not None:
        return False
    return plain_neck(facts, "front") is not None and plain_neck(facts, "back") is not None


def _collar_added(kind: CollarKind, name: str, natural: float) -> Lever:
    return Lever(
        name=name,
        serves=("collar height",),
        stage=5,
        of=of_dimension("collar height"),
        imagine=lambda f, height: replace(f, collar=Collar(kind, height)) if _has_neck(f) else f,
        cut=lambda cutter, amount: neck_cuts.sew_collar(cutter, kind, amount),
        span=fixed(2.0, 12.0),
        step=0.5,
        moves=False,
        natural=natural,
        only_for=("collar", "collar_cm"),
    )


COLLAR_LEVERS: tuple[Lever, ...] = (
    _collar_added("stand", "stand collar sewn on", 5.0),
    _collar_added("lapel", "lapels sewn on", 6.0),
    Lever(
        name="hood sewn on, its depth",
        serves=("hood depth",),
        stage=5,
        of=of_dimension("hood depth"),
        imagine=lambda f, depth: replace(f, hood=Hood(_HOOD_HEIGHT_CM, depth)) if _has_neck(f) else f,
        cut=lambda cutter, depth: neck_cuts.sew_hood(cutter, _HOOD_HEIGHT_CM, depth),
        span=fixed(24.0, 44.0),
        moves=False,
        natural=_HOOD_DEPTH_CM,
        only_for=("hood",),
    ),
    Lever(
        name="hood",
        serves=("hood depth",),
        stage=5,
        of=of_dimension("hood depth"),
        imagine=imagine_at("hood.depth"),
        cut=lambda cutter, amount: neck_cuts.resize_hood(cutter, 0.0, amount),
        span=fixed(22.0, 48.0),
        words=("deeper", "shallower"),
        only_for=("hood depth",),
    ),
    Lever(
        name="hood",
        serves=("hood height",),
        stage=6,
        of=of_dimension("hood height"),
        imagine=imagine_at("hood.height"),
        cut=lambda cutter, amount: neck_cuts.resize_hood(cutter, amount, 0.0),
        span=fixed(42.0, 70.0),
        words=("taller", "lower"),
        only_for=("hood height",),
    ),
)
