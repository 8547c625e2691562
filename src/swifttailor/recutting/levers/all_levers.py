"""All levers and tricks, and which of them cut each dimension."""

from __future__ import annotations

from collections.abc import Mapping

from swifttailor.describing.dimensions import DIMENSIONS
from swifttailor.recutting.levers.armholes import ARMHOLE_LEVERS, ARMHOLE_TRICKS
from swifttailor.recutting.levers.bodice_darts import BODICE_DART_TRICKS
from swifttailor.recutting.levers.collars import COLLAR_LEVERS
from swifttailor.recutting.levers.exchanges import CURVED_LEVERS, EXCHANGE_LEVERS, EXCHANGE_TRICKS
from swifttailor.recutting.levers.fit import FIT_LEVERS
from swifttailor.recutting.levers.godets import GODET_LEVERS, GODET_TRICKS
from swifttailor.recutting.levers.hem_shapes import HEM_SHAPE_LEVERS
from swifttailor.recutting.levers.leg_room import LEG_ROOM_LEVERS
from swifttailor.recutting.levers.lengths import LENGTH_LEVERS
from swifttailor.recutting.levers.lever import Lever, Trick
from swifttailor.recutting.levers.necks import NECK_LEVERS, NECK_TRICKS
from swifttailor.recutting.levers.parts import ADDED_PARTS, PART_TRICKS
from swifttailor.recutting.levers.peplum import PEPLUM_TRICKS
from swifttailor.recutting.levers.sides import SIDE_TRICKS
from swifttailor.recutting.levers.sleeve_widths import SLEEVE_WIDTH_LEVERS
from swifttailor.recutting.levers.slits import SLIT_LEVERS, SLIT_TRICKS
from swifttailor.recutting.levers.tiers import TIER_LEVERS, TIER_TRICKS
from swifttailor.recutting.levers.waist_girth import WAIST_GIRTH_LEVERS
from swifttailor.recutting.levers.widths import WIDTH_LEVERS, WIDTH_TRICKS

LEVERS: tuple[Lever, ...] = (
    *LENGTH_LEVERS,
    *ARMHOLE_LEVERS,
    *NECK_LEVERS,
    *HEM_SHAPE_LEVERS,
    *CURVED_LEVERS,
    *WIDTH_LEVERS,
    *WAIST_GIRTH_LEVERS,
    *LEG_ROOM_LEVERS,
    *SLEEVE_WIDTH_LEVERS,
    *SLIT_LEVERS,
    *ADDED_PARTS,
    *FIT_LEVERS,
    *COLLAR_LEVERS,
    *GODET_LEVERS,
    *TIER_LEVERS,
    *EXCHANGE_LEVERS,
)
"""In order of preference."""
TRICKS: tuple[Trick, ...] = (
    *NECK_TRICKS,
    *ARMHOLE_TRICKS,
    *SIDE_TRICKS,
    *BODICE_DART_TRICKS,
    *SLIT_TRICKS,
    *TIER_TRICKS,
    *GODET_TRICKS,
    *WIDTH_TRICKS,
    *PART_TRICKS,
    *EXCHANGE_TRICKS,
    *PEPLUM_TRICKS,
)

LEVERS_OF: Mapping[str, tuple[Lever, ...]] = {
    name: tuple(lever for lever in LEVERS if name in lever.serves) for name in DIMENSIONS
}
"""What cuts each dimension; nothing for those of `NOT_CUT`."""
NOT_CUT: Mapping[str, str] = {
    "gores": "a skirt of other panels would have to be drafted",
    "tier gathers": "lower rows are sewn to upper ones, so all of them would have to be drafted",
}
"""Dimensions that no lever cuts, and why."""
