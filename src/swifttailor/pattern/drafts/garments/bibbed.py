"""Garments with a bib held by straps: dungarees, pinafore, apron."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import lay_body_waist_band
from swifttailor.pattern.drafts.bib_bodice import Bib, lay_bib, sew_bib
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.fitted_skirt import SKIRT_FRONT_Z, FittedSkirt, lay_fitted_skirt
from swifttailor.pattern.drafts.joins import SKIRT_HALVES, sew_skirt_to_band, sew_trousers_to_band
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.outline import Outline
from swifttailor.pattern.drafts.pleated_skirt import LEAST_PLEATS, sew_pleats_to_band
from swifttailor.pattern.drafts.round_skirt import lay_dress_pleats
from swifttailor.pattern.drafts.trousers import Trousers, lay_trousers, legs_of_bodice, sew_legs
from swifttailor.pattern.pattern import Pattern


@dataclass(frozen=True)
class BibOptions:
    """What both have."""

    strap_width: Annotated[float, Option("Width of the straps.", "cm", 2.0, 6.0)] = 3.5
    bib_height: Annotated[
        float, Option("Height of the bib over the fullest part of the bust.", "cm", 2.0, 9.0)
    ] = 6.0
    waist_ease: Annotated[
        float, Option("Room of the waistband on top of the waist girth.", "cm", 0.0, 12.0)
    ] = 4.0
    band_height: declared.BandHeight = 4.0
    crossed: Annotated[bool, Option("Cross the straps behind.")] = False
    bib: Annotated[
        bool, Option("A bib in front; without it straps alone, as braces, and of aprons none.")
    ] = True


@dataclass(frozen=True)
class DungareesOptions(BibOptions):
    """Options of the dungarees."""

    length: declared.TrouserLength = 101.0
    hip_ease: declared.HipEase = 7.0
    leg_ease: declared.LegEase = 16.0
    flare: declared.LegFlare = 0.0
    crotch_drop: Annotated[float, Option("Crotch of the trousers below the body's.", "cm", 0.5, 8.0)] = 2.5
    stretch: declared.ClothStretch = 0.0


def draft_dungarees(options: DungareesOptions, measurements: Measurements) -> Pattern:
    """Drafts dungarees for a body: trousers on a waistband, a bib in front, straps over bare shoulders."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("dungarees", options.stretch / 100)
    lower = lay_bib(table, figure, _bib(options))
    cut = legs_of_bodice if options.stretch else Trousers
    legs = cut(options.length, options.hip_ease, options.leg_ease, options.flare, options.crotch_drop)
    lay_trousers(table, figure, legs, lower, figure.waist_y - options.band_height)
    table.mirror()
    sew_legs(table)
    sew_trousers_to_band(table)
    sew_bib(table, crossed=options.crossed, bib=options.bib)
    return table.finish()


@dataclass(frozen=True)
class PinaforeOptions(BibOptions):
    """Options of the pinafore."""

    length: declared.SkirtLength = 50.0
    flare: declared.SkirtFlare = 6.0
    hip_ease: declared.HipEase = 6.0
    pleats: declared.SkirtPleats = 0


def draft_pinafore(options: PinaforeOptions, measurements: Measurements) -> Pattern:
    """Drafts the pinafore for a body: a skirt on a waistband, a bib in front, straps over bare shoulders."""
    figure = Figure.of(measurements)
    table = CuttingTable("pinafore")
    lower = lay_bib(table, figure, _bib(options))
    table.mirror()
    top = figure.waist_y - options.band_height
    if options.pleats >= LEAST_PLEATS:
        length = options.length - options.band_height
        lay_dress_pleats(table, figure, lower, options.pleats, length, top - 3.0)
        sew_pleats_to_band(table, options.pleats)
    else:
        skirt = FittedSkirt(options.length, options.hip_ease, options.flare)
        lay_fitted_skirt(table, figure, skirt, lower, top)
        sew_skirt_to_band(table, SKIRT_HALVES)
    sew_bib(table, crossed=options.crossed, bib=options.bib)
    return table.finish()


@dataclass(frozen=True)
class ApronOptions(BibOptions):
    """Options of the apron."""

    length: Annotated[float, Option("Body's waist to the hem, down the middle.", "cm", 62.0, 100.0)] = 66.0
    wider: Annotated[
        float, Option("How much wider than the waistband in front the hem is, on each side.", "cm", 2.0, 25.0)
    ] = 14.0


def draft_apron(options: ApronOptions, measurements: Measurements) -> Pattern:
    """Drafts the apron for a body: a bib, straps, a band all around, and cloth in front alone."""
    figure = Figure.of(measurements)
    table = CuttingTable("apron")
    if options.bib:
        lower = lay_bib(table, figure, _bib(options))
    else:
        lower = lay_body_waist_band(table, figure, options.band_height, options.waist_ease)
    table.mirror()
    top, low = figure.waist_y - options.band_height, figure.waist_y - options.length
    half = lower.front
    outline = Outline(-half - options.wider, low).line("hem", half + options.wider, low)
    outline.line("left_edge", half, top).line("waist", -half, top)
    outline.line("right_edge", -half - options.wider, low)
    table.lay("skirt_front", outline.closed(), label="leg", at=(0.0, 0.0, SKIRT_FRONT_Z))
    table.seam("wb_front.bottom", "skirt_front.waist")
    if options.bib:
        sew_bib(table, crossed=options.crossed)
    return table.finish()


def _bib(options: BibOptions) -> Bib:
    return Bib(
        strap=options.strap_width,
        over_bust=options.bib_height,
        waist_ease=options.waist_ease,
        band_height=options.band_height,
        crossed=options.crossed,
        bib=options.bib,
    )
