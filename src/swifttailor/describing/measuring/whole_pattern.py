"""All measures of a pattern together."""

from __future__ import annotations

from functools import lru_cache

from swifttailor.body import BodyMeasurements
from swifttailor.body.wearer import body_of
from swifttailor.describing.facts import GarmentFacts, HemFacts, Kind, LandmarkFacts
from swifttailor.describing.measuring.anatomy import Anatomy
from swifttailor.describing.measuring.hems import find_hem, measure_hem
from swifttailor.describing.measuring.legs import measure_trousers
from swifttailor.describing.measuring.neckline import measure_neckline
from swifttailor.describing.measuring.parts import Part
from swifttailor.describing.measuring.skirts import measure_skirt
from swifttailor.describing.measuring.sleeves import measure_sleeve
from swifttailor.describing.measuring.torso import measure_band, measure_collar, measure_hood, measure_torso
from swifttailor.describing.measuring.wear import wear
from swifttailor.errors import PatternError
from swifttailor.pattern import Pattern
from swifttailor.pattern.drafts.figure import Figure

DRESS_BELOW_CROTCH_CM = 5.0
"""An upper garment whose hem hangs lower than this below the crotch is a dress."""


def measure_facts(pattern: Pattern, body: BodyMeasurements | None = None) -> GarmentFacts:
    """Measures what a pattern shows of the garment.

    Args:
        pattern: A pattern placed around the body, of any maker.
        body: Who it is made for; the body that the pattern names, else the default body, when None.

    Raises:
        PatternError: The pattern has no panels.
        InputError: No body has the measures that the pattern names.
    """
    if not pattern.panels:
        raise PatternError(
            "A pattern without panels shows no garment. Give a pattern with at least one panel."
        )
    body = body_of(pattern.drafted_for).measurements if body is None else body
    return measure_anatomy(Anatomy.of(pattern.canonical(), body))


@lru_cache(maxsize=32)
def measure_anatomy(anatomy: Anatomy) -> GarmentFacts:
    """Measures a garment that has been looked at already; remembers the latest."""
    worn = wear(anatomy)
    line = find_hem(anatomy, worn)
    hem = measure_hem(anatomy, worn, line)
    covered = (worn.shoulders[0] is not None, worn.shoulders[1] is not None)
    return GarmentFacts(
        kind=_kind(anatomy, hem),
        panels=len(anatomy.pattern.panels),
        body=landmarks_of(anatomy.figure),
        top_level=worn.top,
        length=worn.top - hem.level if hem else 0.0,
        hem=hem,
        torso=measure_torso(anatomy, worn),
        front_neck=measure_neckline(anatomy, "front", covered),
        back_neck=measure_neckline(anatomy, "back", covered),
        collar=measure_collar(anatomy),
        hood=measure_hood(anatomy),
        left_sleeve=measure_sleeve(anatomy, "left"),
        right_sleeve=measure_sleeve(anatomy, "right"),
        waistband=measure_band(anatomy, worn),
        skirt=measure_skirt(anatomy, worn, line),
        trousers=measure_trousers(anatomy, worn),
    )


def _kind(anatomy: Anatomy, hem: HemFacts | None) -> Kind:
    upper, legs, skirt = (anatomy.has(p) for p in (Part.TORSO, Part.TROUSER, Part.SKIRT))
    if legs:
        return "jumpsuit" if upper else "trousers"
    if upper:
        low = hem is not None and hem.level < anatomy.figure.crotch_y - DRESS_BELOW_CROTCH_CM
        return "dress" if low else "top"
    return "skirt" if skirt else "other"


def landmarks_of(figure: Figure) -> LandmarkFacts:
    """What lengths on a body are compared with."""
    return LandmarkFacts(
        neck=figure.neck_y,
        bust=figure.bust_y,
        waist=figure.waist_y,
        hips=figure.hip_y,
        crotch=figure.crotch_y,
        knee=figure.knee_y,
        waist_girth=figure.waist.girth,
        hip_girth=figure.hips.girth,
        arm_length=figure.arm_length,
        upper_arm_girth=figure.upper_arm,
        thigh_girth=figure.thigh,
    )
