"""Sleeves of the shapes that people name: puffed, balloon and bell beside plain ones."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Annotated, Literal

from swifttailor.pattern.drafts.band import lay_sleeve_cuff
from swifttailor.pattern.drafts.cut_in_one import CutInOne, cut_sleeve_in_one
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.raglan import lay_raglan_sleeve
from swifttailor.pattern.drafts.sleeve import Sleeve, lay_sleeve

SleeveShape = Literal["plain", "puffed", "balloon", "bell", "wide", "flounced", "trailing"]
SleeveShapeOption = Annotated[
    SleeveShape,
    Option(
        "Puffed: gathered at the shoulder. Balloon: full, gathered into a cuff. Bell: widens to the end. "
        "Wide: widens a little. Flounced: plain, with a frill at its end. "
        "Trailing: hangs in a point below the wrist."
    ),
]
TrailingOption = Annotated[
    Literal["plain", "trailing"], Option("Trailing: hangs in a point below the wrist.")
]
BalloonOption = Annotated[
    Literal["plain", "balloon"], Option("Balloon: full, gathered into the cuff where there is one.")
]
KnittedSleeveOption = Annotated[
    Literal["plain", "balloon", "bell", "wide"],
    Option(
        "Balloon: full, gathered into the cuff where there is one. Bell: widens to the end, without a cuff. "
        "Wide: widens a little, without a cuff."
    ),
]
ArmholeCut = Literal["set-in", "raglan", "cut-in-one"]
ArmholeCutOption = Annotated[
    ArmholeCut,
    Option(
        "Set-in: sewn to an armhole, as puffed ones always are. Raglan: the seams run on to the neckline. "
        "Cut-in-one: of the same cloth as front and back."
    ),
]
RaglanOption = Annotated[
    Literal["set-in", "raglan"],
    Option("Set-in: sewn to an armhole, as puffed ones always are. Raglan: the seams run to the neckline."),
]
WingOption = Annotated[
    float,
    Option("How far below the underarm sleeves that are cut in one begin, at the side.", "cm", 2.0, 30.0),
]
LONG_CM = 45.0
"""Longer puffed sleeves are close below their heads; shorter ones are gathered into a band."""
SHORTEST_CM = 16.0
"""Puffs are no shorter, band included."""
PUFF_EASE, PUFF_CAP = 30.0, 0.6
"""Room around the arm, cm, and by which part the cap of a puffed sleeve is longer than the armhole."""
LEG_OF_MUTTON_EASE, LEG_OF_MUTTON_CAP = 38.0, 0.95
"""The same of long ones, which end as plain ones do."""
BALLOON_EASE, BALLOON_CAP = 26.0, 0.12
BALLOON_FLARE = 14.0
"""How much wider long balloon sleeves are above the cuff than at the underarm, as bishop
sleeves are, cm around."""
BANDED_FLARE = 22.0
"""The same of those of sweatshirts and the like, whose cloth is heavy."""
BAND_CM, BAND_EASE = 3.0, 3.0
"""Height of the band of a short sleeve and its room around the arm, cm."""
CUFF_CM, CUFF_EASE = 6.0, 4.0
"""The same of the cuff of a long one."""
FLOUNCE_CM, FLOUNCE_SHARE, FLOUNCE_EASE, FLOUNCE_FLARE_CM = 10.0, 0.45, 30.0, 7.0
"""Height of the frill of a sleeve, cm, and at most which part of its length; its room at most where it is
sewn on, and its flare, cm."""
TRAILS_SHARE = 0.85
"""By which part of its length a trailing sleeve hangs down below the wrist."""
LEAST_END_EASE = 4.0
"""Room around the arm at the ends of sleeves that are cut in one, cm at least."""
BELL_SHARE, LARGEST_BELL_CM = 0.5, 26.0
"""By which part of its length a bell sleeve is wider at its end than at the underarm, and the most."""
WIDE_FLARE = 16.0
"""The same of wide sleeves, cm around: as wide all the way as at the underarm they turn around the wrists."""
FLUTTERING_CM, FLUTTER_CM, FLUTTER_FAN_CM = 26.0, 10.0, 12.0
"""Length up to which they flutter; how much wider they are then below and, of each half, above the arm."""


def lay_shaped_sleeve(
    table: CuttingTable,
    figure: Figure,
    shape: SleeveShape,
    plain: Sleeve,
    armhole: ArmholeCut = "set-in",
    wing: float = 8.0,
) -> None:
    """Lays the left sleeve and sews it to the left torso, which must already lie on the table.

    Args:
        table: Where it goes. Before raglan sleeves, what is sewn to the neckline must lie there too.
        figure: Gives the arm's direction and girths.
        shape: Of the sleeve.
        plain: What a plain one would be; its length counts, and its widths where the shape says nothing else.
        armhole: How it is joined to the torso.
        wing: How far below the underarm a sleeve that is cut in one begins, cm.
    """
    if armhole == "cut-in-one" and shape != "puffed":
        bell = min(BELL_SHARE * plain.length, LARGEST_BELL_CM) if shape in ("bell", "trailing") else 0.0
        width = max(plain.end_width, figure.arm_girth(plain.length) + LEAST_END_EASE) + bell
        cut_sleeve_in_one(table, figure, CutInOne(plain.length, width, wing, plain.shoulder_extension))
        return
    lay = lay_raglan_sleeve if armhole == "raglan" and shape != "puffed" else lay_sleeve
    if shape == "plain":
        lay(table, figure, plain)
    elif shape == "trailing" and lay is lay_sleeve:
        lay_sleeve(table, figure, replace(plain, trails=TRAILS_SHARE * plain.length))
    elif shape == "bell" and lay is lay_sleeve and plain.length <= FLUTTERING_CM:
        lay(table, figure, replace(plain, flare=FLUTTER_CM, fan=FLUTTER_FAN_CM))
    elif shape == "flounced":
        _lay_flounced(table, figure, plain, lay)
    elif shape == "wide":
        lay(table, figure, replace(plain, flare=WIDE_FLARE))
    elif shape in ("bell", "trailing"):
        lay(table, figure, replace(plain, flare=min(BELL_SHARE * plain.length, LARGEST_BELL_CM)))
    elif shape == "puffed" and plain.length >= LONG_CM:
        full = replace(plain, arm_ease=LEG_OF_MUTTON_EASE, cap_ease=LEG_OF_MUTTON_CAP, close_below_elbow=True)
        lay(table, figure, full)
    else:
        _lay_gathered(table, figure, shape, plain, lay)


def ballooning(plain: Sleeve) -> Sleeve:
    """A sleeve as full as balloon sleeves are above their cuffs.

    Args:
        plain: What a plain one would be; without its cuff.
    """
    ease = max(plain.arm_ease, BALLOON_EASE)
    return replace(plain, arm_ease=ease, cap_ease=BALLOON_CAP, flare=BANDED_FLARE)


def _lay_flounced(
    table: CuttingTable, figure: Figure, plain: Sleeve, lay: Callable[[CuttingTable, Figure, Sleeve], None]
) -> None:
    """Lays a plain sleeve that ends in a frill cut nearly from a circle."""
    height = min(FLOUNCE_CM, FLOUNCE_SHARE * plain.length)
    at = plain.length - height
    lay(table, figure, replace(plain, length=at))
    flare = FLOUNCE_FLARE_CM * height / FLOUNCE_CM
    lay_sleeve_cuff(table, figure, at, FLOUNCE_EASE, height, flare=flare)


def _lay_gathered(
    table: CuttingTable,
    figure: Figure,
    shape: SleeveShape,
    plain: Sleeve,
    lay: Callable[[CuttingTable, Figure, Sleeve], None],
) -> None:
    """Lays a sleeve that is as wide at its end as at the underarm, and gathered into a band or cuff."""
    length = max(plain.length, SHORTEST_CM)
    height, ease = (CUFF_CM, CUFF_EASE) if length >= LONG_CM else (BAND_CM, BAND_EASE)
    room, cap = (PUFF_EASE, PUFF_CAP) if shape == "puffed" else (BALLOON_EASE, BALLOON_CAP)
    wide = figure.upper_arm + room
    flare = BALLOON_FLARE if shape == "balloon" and length >= LONG_CM else 0.0
    full = replace(plain, length=length - height, arm_ease=room, cap_ease=cap, end_width=wide, flare=flare)
    lay(table, figure, full)
    lay_sleeve_cuff(table, figure, length - height, ease, height)
