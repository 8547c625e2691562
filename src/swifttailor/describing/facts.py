"""What a pattern shows of the garment: measured facts, in cm unless said otherwise.

Every number comes from the panels and stitches (`measure.measure_facts`), none from design parameters.
"Left" and "right" are the wearer's. How each is measured: docs/captions.md.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Kind = Literal["top", "dress", "skirt", "trousers", "jumpsuit", "other"]
NeckShape = Literal["round", "v", "square", "trapezoid", "s-curve", "pointed", "straight", "other"]
ArmholeShape = Literal["round", "square", "angled", "other"]
CuffKind = Literal["band", "flounce", "band and flounce"]
CollarKind = Literal["stand", "lapel"]
Place = Literal["front", "back", "left", "right"]


@dataclass(frozen=True)
class LandmarkFacts:
    """Heights on the body above the floor that lengths are compared with, and some of its girths."""

    neck: float
    bust: float
    waist: float
    hips: float
    crotch: float
    knee: float
    waist_girth: float
    hip_girth: float
    arm_length: float
    upper_arm_girth: float
    thigh_girth: float


@dataclass(frozen=True)
class HemFacts:
    """The lower border of a garment as worn."""

    level: float
    """Mean height above the floor."""
    front: float
    """Height in the middle of the front."""
    back: float
    left: float
    right: float
    length: float
    """Along the border, slits left out."""
    dip: float
    """How far the corners between panels hang below the middles of their hems; negative when above."""
    arcs: int = 0
    """Scallops: edges that hang below their ends, of panels with three or more of them."""


@dataclass(frozen=True)
class NeckHalf:
    """Half of a neckline, from the middle to one shoulder."""

    shape: NeckShape
    depth: float
    """Fall from the shoulder end to the lowest point."""
    width: float
    """From the middle to the shoulder end."""


@dataclass(frozen=True)
class Neckline:
    """The neckline of the front or of the back; a half is None where that shoulder is bare."""

    left: NeckHalf | None
    right: NeckHalf | None

    @property
    def depth(self) -> float:
        """Of the deeper half."""
        return max(h.depth for h in (self.left, self.right) if h)

    @property
    def width(self) -> float:
        """Of the wider half."""
        return max(h.width for h in (self.left, self.right) if h)

    @property
    def shape(self) -> NeckShape | None:
        """Of both halves; None where they differ or one is missing."""
        same = self.left and self.right and self.left.shape == self.right.shape
        return self.left.shape if self.left and same else None


@dataclass(frozen=True)
class Armhole:
    """The armhole of a sleeveless side."""

    shape: ArmholeShape
    depth: float
    """Fall from the shoulder to the underarm."""


@dataclass(frozen=True)
class Cuff:
    """What is sewn to the end of a sleeve or leg."""

    kind: CuffKind
    length: float
    opening: float
    """Around its free end."""
    flare: float
    """Free end over sewn end of its last panel."""


@dataclass(frozen=True)
class Sleeve:
    """One sleeve."""

    length: float
    """From the shoulder tip along the arm to the end of sleeve or cuff."""
    upper_width: float
    """Around, at the underarm."""
    end_width: float
    """Around, at the lower end without cuff, before it is gathered."""
    opening: float
    """Around, at the free end."""
    head_gather: float
    """Length of the sleeve's head over that of the armhole."""
    end_gather: float
    """Length of its lower end over that of the cuff; 1 without one."""
    cuff: Cuff | None


@dataclass(frozen=True)
class Torso:
    """The upper part of a garment."""

    left_shoulder: float | None
    """Length of the shoulder seam; None where that side is bare."""
    right_shoulder: float | None
    chest: float
    """Girth at the underarm."""
    chest_ease: float
    """Over the body's bust girth."""
    waist: float | None
    """Girth at the body's waist, before it is gathered; None where it ends above."""
    lower_edge: float
    """Girth of its lower edge, before it is gathered."""
    lower_level: float
    """Mean height of its lower edge."""
    gather: float
    """Its lower edge over what it is sewn to; 1 where that is nothing."""
    darts: int
    blouson: float
    """By how much it is longer than the way down to the seam that holds it."""
    left_armhole: Armhole | None
    """None on sides with a sleeve and on bare sides."""
    right_armhole: Armhole | None
    hips: float | None = None
    """Girth at the height of the hips; None where it ends above, or a skirt or legs hang from it."""


@dataclass(frozen=True)
class Collar:
    """A collar."""

    kind: CollarKind
    height: float
    """Width of the collar behind the neck."""


@dataclass(frozen=True)
class Hood:
    """A hood."""

    height: float
    """From the neckline to the crown."""
    depth: float
    """From the face to the back."""


@dataclass(frozen=True)
class Band:
    """A waistband, or a band at the hem of a top."""

    height: float
    upper: float
    """Girth of its upper edge."""
    lower: float
    """Girth of its lower edge."""
    at_hem: bool
    """Whether nothing hangs from it."""
    level: float
    """Mean height of its upper edge."""


@dataclass(frozen=True)
class Slit:
    """A cut in the hem that stays open."""

    place: Place
    height: float
    width: float
    """Distance of its two lower ends in the flat panel; large where a wedge is cut out."""
    over: Literal["left", "right"] | None = None
    """The leg that one in front or behind is over; None of one in the middle, or at a side."""


@dataclass(frozen=True)
class Skirt:
    """A skirt, or the skirt of a dress."""

    length: float
    """From its upper edge to the hem, waistband left out; mean around."""
    upper: float
    """Girth that its upper edge is sewn to (or of that edge)."""
    gather: float
    """Upper edge over what it is sewn to."""
    hips: float
    """Girth at the height of the hips; of the hem where it ends above."""
    hem: float
    """Length of the hem, slits left out."""
    circle: float
    """Part of a full circle that it flares like: 0 for a tube, 1 for a circle skirt."""
    gores: int
    """Panels side by side around the body."""
    tiers: int
    """Rows of panels one below the other."""
    tier_gather: float
    """Upper edge of the lower rows over what they are sewn to; 1 with one row."""
    base_length: float
    """Of the first row; `length` with one row."""
    base_hem: float
    """Girth of the lower edge of the first row; that of the hem with one row."""
    godets: int
    godet_width: float
    godet_height: float
    darts: int
    slits: tuple[Slit, ...]


@dataclass(frozen=True)
class Trousers:
    """The legs of trousers or of a jumpsuit; left and right leg alike, else their mean."""

    inseam: float
    """From the crotch to the end, cuff included."""
    thigh: float
    """Around one leg below the crotch."""
    hem: float
    """Around the end of the leg without cuff, before it is gathered."""
    opening: float
    """Around its free end."""
    end_gather: float
    """Lower end over cuff; 1 without one."""
    gather: float
    """Upper edge over what it is sewn to."""
    hips: float
    """Girth at the height of the hips."""
    cuff: Cuff | None
    darts: int


@dataclass(frozen=True)
class GarmentFacts:
    """All that is measured on one pattern."""

    kind: Kind
    panels: int
    body: LandmarkFacts
    top_level: float
    """Height of the shoulders, or of the upper border."""
    length: float
    """From there to the mean hem."""
    hem: HemFacts | None
    """Of the legs, for trousers."""
    torso: Torso | None
    front_neck: Neckline | None
    back_neck: Neckline | None
    collar: Collar | None
    hood: Hood | None
    left_sleeve: Sleeve | None
    right_sleeve: Sleeve | None
    waistband: Band | None
    skirt: Skirt | None
    trousers: Trousers | None

    @property
    def strapless(self) -> bool:
        """Whether both shoulders are bare."""
        return (
            self.torso is not None and self.torso.left_shoulder is None and self.torso.right_shoulder is None
        )

    @property
    def one_shoulder(self) -> bool:
        """Whether just one shoulder is bare."""
        torso = self.torso
        return torso is not None and (torso.left_shoulder is None) != (torso.right_shoulder is None)
