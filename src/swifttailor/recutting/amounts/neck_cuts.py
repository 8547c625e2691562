"""Cuts at the neckline: collars and hoods sewn on, and what lies under them recut."""

from __future__ import annotations

from collections.abc import Callable

from swifttailor.describing.facts import CollarKind
from swifttailor.describing.measuring.parts import Part
from swifttailor.pattern import Pattern
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.collars import add_collar, add_hood, neck_quarters
from swifttailor.recutting.ways.ends import move_ends
from swifttailor.recutting.ways.removal import remove_panels

_DEEPER_CM = (0.0, 2.0, 4.0, 6.0)
"""By how much a hood that is sewn on anew may get deeper, where the neckline has become longer."""


def sew_collar(cutter: Cutter, kind: CollarKind, height: float) -> Pattern | None:
    """Sews a collar to a free neckline of two shoulders, cm high behind."""
    quarters = neck_quarters(cutter.pattern, cutter.neckline("front"), cutter.neckline("back"))
    if quarters is None:
        return None
    return add_collar(cutter.pattern, quarters, cutter.anatomy.figure, kind, height)


def sew_hood(cutter: Cutter, height: float, depth: float) -> Pattern | None:
    """Sews a hood to a free neckline of two shoulders; its panels measure what is given, cm."""
    quarters = neck_quarters(cutter.pattern, cutter.neckline("front"), cutter.neckline("back"))
    if quarters is None:
        return None
    return add_hood(cutter.pattern, quarters, cutter.anatomy.figure, height, depth)


def bare_neck(cutter: Cutter) -> Cutter | None:
    """The garment without collar and hood; itself where it has none."""
    names = cutter.names(Part.COLLAR, Part.HOOD)
    if not names:
        return cutter
    bare = remove_panels(cutter.pattern, names)
    return None if bare is None else cutter.with_pattern(bare)


def recut_under(cutter: Cutter, recut: Callable[[Cutter], Pattern | None]) -> Pattern | None:
    """Recuts a neckline; a collar or hood that is on it is sewn on anew, as long as the neckline then is."""
    collar, hood = cutter.facts.collar, cutter.facts.hood
    bare = bare_neck(cutter)
    edited = None if bare is None else recut(bare)
    if edited is None or (collar is None and hood is None):
        return edited
    after = cutter.with_pattern(edited)
    if collar is not None:
        return sew_collar(after, collar.kind, collar.height) if hood is None else None
    if hood is None:
        return None
    hoods = (sew_hood(after, hood.height, hood.depth + more) for more in _DEEPER_CM)
    return next((hooded for hooded in hoods if hooded is not None), None)


def raise_collar(cutter: Cutter, distance: float) -> Pattern | None:
    """Makes a collar wider, cm; lapels are sewn on anew."""
    collar = cutter.facts.collar
    if collar is None or collar.kind != "lapel":
        ends = cutter.anatomy.free_edges(Part.COLLAR)
        return move_ends(cutter.pattern, ends, distance) if ends else None
    bare = None if cutter.facts.hood is not None else bare_neck(cutter)
    return None if bare is None else sew_collar(bare, collar.kind, collar.height + distance)


def resize_hood(cutter: Cutter, height: float, depth: float) -> Pattern | None:
    """Cuts a hood anew, higher and deeper by cm."""
    hood, bare = cutter.facts.hood, bare_neck(cutter)
    if hood is None or bare is None or cutter.facts.collar is not None:
        return None
    return sew_hood(bare, hood.height + height, hood.depth + depth)
