"""Option declarations that several garments share."""

from __future__ import annotations

from typing import Annotated

from swifttailor.pattern.drafts.neckline import NeckShape
from swifttailor.pattern.drafts.options import Option

NeckShapeOption = Annotated[NeckShape, Option("Shape of the front neckline; the back is round.")]
NeckWidening = Annotated[
    float,
    Option(
        "Distance of the neckline from the neck, along the shoulder; crew necks have less than 0.",
        "cm",
        -2.0,
        6.0,
    ),
]
CloseNeckWidening = Annotated[
    float, Option("Distance of the neckline from the neck, along the shoulder.", "cm", 0.0, 3.0)
]
NeckDepth = Annotated[
    float, Option("Fall of the front neckline below the neck-shoulder point.", "cm", 6.0, 22.0)
]
PlungingNeckDepth = Annotated[
    float,
    Option(
        "Fall of the front neckline below the neck-shoulder point; only a V is deeper than 22.",
        "cm",
        6.0,
        32.0,
    ),
]
BackNeckDepth = Annotated[
    float, Option("Fall of the back neckline below the neck-shoulder point.", "cm", 1.0, 16.0)
]
BareBackDepth = Annotated[
    float,
    Option(
        "Fall of the back neckline below the neck-shoulder point; beyond 18 it bares the back.",
        "cm",
        1.0,
        42.0,
    ),
]
ChestEase = Annotated[float, Option("Room on top of the bust girth, all around.", "cm", 2.0, 36.0)]
BustEase = Annotated[float, Option("Room on top of the bust girth, all around.", "cm", 1.0, 16.0)]
WaistEase = Annotated[float, Option("Room on top of the waist girth, all around.", "cm", 0.0, 16.0)]
HipEase = Annotated[float, Option("Room on top of the hip girth, all around.", "cm", 0.5, 20.0)]
ClothStretch = Annotated[
    float,
    Option("By how much the cloth is to stretch all around: it is cut so much smaller.", "%", 0.0, 20.0),
]
ArmholeDrop = Annotated[float, Option("How far the underarm lies below the armpit.", "cm", 0.5, 8.0)]
LongLength = Annotated[float, Option("Hem below the waist.", "cm", 25.0, 100.0)]
TopLength = Annotated[float, Option("Hem below the waist; negative ends above it.", "cm", -12.0, 60.0)]
HemFlare = Annotated[float, Option("Extra width of the hem, all around.", "cm", 0.0, 40.0)]
DressFlare = Annotated[float, Option("Extra width of the hem, all around.", "cm", 0.0, 80.0)]
SleeveLength = Annotated[
    float, Option("Shoulder tip to the sleeve's end along the arm, cuff included.", "cm", 12.0, 74.0)
]
ArmEase = Annotated[float, Option("Room on top of the upper arm girth, all around.", "cm", 3.0, 18.0)]
SleeveEnd = Annotated[
    float,
    Option("Width around at the sleeve's end; at most that at the underarm.", "cm", 18.0, 50.0),
]
ShoulderExtension = Annotated[
    float,
    Option(
        "How far the shoulder seam reaches over the shoulder tip: 6 and more is dropped.", "cm", 0.0, 10.0
    ),
]
Sleeves = Annotated[bool, Option("Set in sleeves.")]
WaistShaping = Annotated[float, Option("How far each side seam bends inward at the waist.", "cm", 0.0, 4.0)]
CapEase = Annotated[float, Option("Fullness of the sleeve cap over the armhole.", "%", 0.0, 6.0)]
CuffHeight = Annotated[float, Option("Height of the cuffs.", "cm", 3.0, 10.0)]
SleeveCuffHeight = Annotated[float, Option("Height of the cuffs.", "cm", 3.0, 16.0)]
CuffWidth = Annotated[float, Option("Room of the cuff on top of the wrist girth.", "cm", 2.0, 10.0)]
SkirtLength = Annotated[float, Option("Body's waist to the hem, down the middle.", "cm", 36.0, 100.0)]
SkirtFlare = Annotated[
    float, Option("Slant of the side seams below the hips; negative narrows the hem.", "degrees", -8.0, 18.0)
]
BandHeight = Annotated[float, Option("Height of the waistband.", "cm", 2.0, 11.0)]
SkirtYoke = Annotated[
    float,
    Option(
        "Height of a yoke shaped to the hips, instead of the waistband; less than 6: none.", "cm", 0.0, 20.0
    ),
]
TrouserLength = Annotated[float, Option("Body's waist to the hem, down the side.", "cm", 36.0, 106.0)]
LongTrouserLength = Annotated[
    float, Option("Body's waist to the hem, down the side; longer ones drag.", "cm", 36.0, 130.0)
]
LegEase = Annotated[float, Option("Room on top of the leg's girth at knee and hem.", "cm", 0.5, 60.0)]
LegFlare = Annotated[
    float, Option("Extra width of the hem over the knee; negative narrows it.", "cm", -26.0, 30.0)
]
GatheringLegCuff = Annotated[
    float,
    Option("Height of cuffs that the legs are gathered into below their length; 0: none.", "cm", 0.0, 8.0),
]
TopHemDip = Annotated[
    float, Option("How much lower the hem is in the middle of the back than at the sides.", "cm", 0.0, 14.0)
]
HemDip = Annotated[
    float, Option("How much lower the hem is behind than in front, without gathers.", "cm", 0.0, 60.0)
]
ScallopWidth = Annotated[
    float, Option("Width of the arcs that the hem is cut in; none when 0. Not with a dip.", "cm", 0.0, 16.0)
]
HemPoints = Annotated[
    float,
    Option(
        "How far the hem hangs down in points, as of handkerchief skirts; less than 4: none. Not with a dip.",
        "cm",
        0.0,
        30.0,
    ),
]
HemBand = Annotated[
    float,
    Option("Height of a band that a gathered hem is drawn into, as of bubble skirts.", "cm", 0.0, 6.0),
]
SkirtGathers = Annotated[
    float,
    Option("Width of a gathered skirt over the waist's; 1 cuts it from a circle.", "times", 1.0, 2.6),
]
SkirtPleats = Annotated[
    int,
    Option(
        "Strips seen between knife pleats of the skirt in front, and as many behind; less than 2: none. "
        "Not with gathers.",
        "strips",
        0,
        8,
    ),
]
ShortSkirtLength = Annotated[float, Option("Body's waist to the hem, down the middle.", "cm", 28.0, 100.0)]
CircleFraction = Annotated[
    float, Option("Part of a full circle that the skirt is cut from.", "circles", 0.3, 1.5)
]
BandedLength = Annotated[
    float, Option("Hem below the waist, band included; negative ends above it.", "cm", -6.0, 50.0)
]
HighNeckWidening = Annotated[
    float, Option("Distance of the neckline from the neck, along the shoulder.", "cm", -1.5, 5.0)
]
HighNeckDepth = Annotated[
    float, Option("Fall of the front neckline below the neck-shoulder point.", "cm", 7.0, 14.0)
]
HoodHeight = Annotated[float, Option("Height of the hood over the head length.", "cm", 4.0, 18.0)]
HoodDepth = Annotated[float, Option("Depth of the hood on top of the head's own.", "cm", 2.0, 14.0)]
CollarWidth = Annotated[float, Option("Width of the collar on the shoulder.", "cm", 3.0, 10.0)]
CollarNeckDepth = Annotated[
    float, Option("Fall of the front neckline below the neck-shoulder point.", "cm", 7.0, 16.0)
]
FlounceSeam = Annotated[float, Option("Body's waist to the seam of the flounce.", "cm", 30.0, 75.0)]
FlounceFraction = Annotated[
    float, Option("Part of a full circle that the flounce is cut from.", "circles", 0.2, 1.0)
]
ClosedTo = Annotated[
    float,
    Option(
        "Where a front that opens is sewn together to: below the waist; negative ends above it.",
        "cm",
        -30.0,
        40.0,
    ),
]
HemRise = Annotated[
    float,
    Option("How far the hem rises in curves to the side seams, as a shirt's; 0 is straight.", "cm", 0.0, 9.0),
]
HemOpening = Annotated[
    float,
    Option("Length of the front that is open from the hem up, as below the last button.", "cm", 0.0, 30.0),
]
Opening = Annotated[
    float,
    Option(
        "How far each front edge has moved back from the middle at the hem; 0 sews the front together.",
        "cm",
        0.0,
        14.0,
    ),
]
OverlapOrOpening = Annotated[
    float,
    Option(
        "How far each front edge has moved back from the middle at the hem; 0 sews the front together, and "
        "with less than 0 the right front overlaps the left one there by as much.",
        "cm",
        -30.0,
        14.0,
    ),
]
Crossing = Annotated[
    float,
    Option(
        "How far beside the middle, on the wearer's left, fronts that overlap meet where they are sewn last; "
        "the seam above runs there from the neck.",
        "cm",
        0.0,
        10.0,
    ),
]
LapelDepth = Annotated[
    float, Option("Fall of the front neckline below the neck-shoulder point.", "cm", 18.0, 34.0)
]
LapelCollarWidth = Annotated[float, Option("Width of the collar on the shoulder.", "cm", 3.0, 12.0)]
LapelWidth = Annotated[float, Option("Width of the lapels where they are widest.", "cm", 4.0, 14.0)]
SideSlits = Annotated[float, Option("Length of the side seams left open above the hem.", "cm", 0.0, 85.0)]
BackSlit = Annotated[
    float, Option("Length of the seam in the middle of the back left open above the hem.", "cm", 0.0, 50.0)
]
LegSlits = Annotated[
    float, Option("Length of the side seams of the legs left open above the hem.", "cm", 0.0, 30.0)
]
BackRise = Annotated[
    float, Option("How much higher the waistband is in the middle of the back.", "cm", 0.0, 6.0)
]
BelowWaist = Annotated[
    float, Option("Upper edge below the body's waist; above it below 0.", "cm", -5.0, 16.0)
]
BandEase = Annotated[float, Option("Room of the waistband on top of the waist girth.", "cm", -2.0, 4.0)]
