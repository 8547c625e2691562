"""Where the trims of a pattern lie on its panels."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from swifttailor.pattern.pattern import Pattern
from swifttailor.pattern.trims import (
    across_front,
    across_middle,
    back_openings,
    belts,
    cut_outs,
    decorations,
    denim,
    elastic,
    fastenings,
    pockets,
    pressed_lines,
    quilting,
    ruching,
    seam_lines,
    top_pleats,
)
from swifttailor.pattern.trims.apron import apron
from swifttailor.pattern.trims.arm_slits import arm_slits
from swifttailor.pattern.trims.blouse_front import blouse_front
from swifttailor.pattern.trims.boning import boning
from swifttailor.pattern.trims.bust_gathers import bust_gathers
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.chest_motifs import chest_heart, chest_star
from swifttailor.pattern.trims.collar_buttons import collar_buttons
from swifttailor.pattern.trims.cowl import cowl_folds
from swifttailor.pattern.trims.cups import cups
from swifttailor.pattern.trims.diagonal_closing import diagonal_closing
from swifttailor.pattern.trims.elbow_patches import elbow_patches
from swifttailor.pattern.trims.epaulettes import epaulettes
from swifttailor.pattern.trims.fur_edges import fur_trim, neck_fur, sleeve_fur
from swifttailor.pattern.trims.illusion import illusion_yoke
from swifttailor.pattern.trims.keyholes import keyhole
from swifttailor.pattern.trims.kick_pleat import kick_pleat
from swifttailor.pattern.trims.kilt_edge import kilt_edge
from swifttailor.pattern.trims.knee_patches import knee_patches
from swifttailor.pattern.trims.knit_bands import KNIT_BANDS, knit_bands
from swifttailor.pattern.trims.layers import layer
from swifttailor.pattern.trims.nape_bow import nape_bow
from swifttailor.pattern.trims.neck_gathers import neck_gathers
from swifttailor.pattern.trims.petal_sleeves import sleeve_petals
from swifttailor.pattern.trims.reflecting_bands import reflecting_bands
from swifttailor.pattern.trims.rips import frayed_hem, rips
from swifttailor.pattern.trims.shapes import Trim
from swifttailor.pattern.trims.shoulder_drape import shoulder_drape
from swifttailor.pattern.trims.side_panels import side_panels
from swifttailor.pattern.trims.side_stripes import (
    side_stripes,
    sleeve_stripes,
    three_side_stripes,
    three_sleeve_stripes,
)
from swifttailor.pattern.trims.side_tie import side_tie
from swifttailor.pattern.trims.smocking import smocking
from swifttailor.pattern.trims.stirrups import stirrups
from swifttailor.pattern.trims.strap_buckles import strap_buckles
from swifttailor.pattern.trims.thumb_holes import thumb_holes
from swifttailor.pattern.trims.toggles import toggles
from swifttailor.pattern.trims.tucks import tucks
from swifttailor.pattern.trims.waist_frill import folded_band, waist_frill
from swifttailor.pattern.trims.yoke_frill import yoke_frill

_PLACES: Mapping[str, Callable[[Chalk, str], list[Trim]]] = {
    "buttons": fastenings.buttons,
    "big buttons": fastenings.buttons,
    "button placket": fastenings.buttons,
    "polo placket": fastenings.buttons,
    "waist placket": fastenings.buttons,
    "double-breasted buttons": fastenings.double_breasted,
    "zip": fastenings.front_zip,
    "half zip": fastenings.front_zip,
    "back zip": fastenings.back_zip,
    "side zip": fastenings.side_zip,
    "fly": fastenings.fly,
    "chest pocket": pockets.chest_pocket,
    "chest pockets": pockets.chest_pocket,
    "patch pockets": pockets.patch_pockets,
    "welt pockets": pockets.welt_pockets,
    "kangaroo pocket": pockets.kangaroo,
    "front pocket": across_middle.front_pocket,
    "lower back pockets": across_middle.lower_back_pockets,
    "bib pocket": pockets.bib_pocket,
    "side pockets": pockets.side_pockets,
    "slant pockets": pockets.slant_pockets,
    "back pockets": pockets.back_pockets,
    "back welt pockets": pockets.back_welts,
    "cargo pockets": pockets.cargo_pockets,
    "thigh pocket": pockets.thigh_pocket,
    "tie belt": belts.belt,
    "buckle belt": belts.belt,
    "quilting": quilting.quilted,
    "turn-ups": belts.turn_ups,
    "drawstring": belts.drawstring,
    "elastic waist": elastic.waist_elastic,
    "back elastic": elastic.back_elastic,
    "neck cord": decorations.neck_cord,
    "neck rib": decorations.neck_rib,
    "armhole ribs": decorations.armhole_ribs,
    "hem rib": decorations.hem_rib,
    KNIT_BANDS: knit_bands,
    "neck frill": decorations.neck_frill,
    "sleeve frills": decorations.sleeve_frills,
    "sleeve turn-ups": decorations.sleeve_turn_ups,
    "hem frill": decorations.hem_frill,
    "front frills": decorations.front_frills,
    "yoke frill": yoke_frill,
    "hem fringe": decorations.hem_frill,
    "edging": decorations.edging,
    "piping": decorations.edging,
    "bands": decorations.edging,
    "narrow bands": decorations.edging,
    "lace trim": decorations.edging,
    "neck lace": decorations.neck_lace,
    "fur trim": fur_trim,
    "neck fur": neck_fur,
    "sleeve fur": sleeve_fur,
    "side stripes": side_stripes,
    "satin stripes": side_stripes,
    "sleeve stripes": sleeve_stripes,
    "three side stripes": three_side_stripes,
    "three sleeve stripes": three_sleeve_stripes,
    "side panels": side_panels,
    "neck bow": decorations.neck_bow,
    "nape bow": nape_bow,
    "waist bow": decorations.waist_bow,
    "shoulder bows": decorations.shoulder_bows,
    "lacing": decorations.lacing,
    "boning": boning,
    "tucks": tucks,
    "apron": apron,
    "creases": pressed_lines.creases,
    "pleat lines": pressed_lines.pleat_lines,
    "front pleats": pressed_lines.front_pleats,
    "stirrups": stirrups,
    "keyhole": keyhole,
    "back keyhole": keyhole,
    "epaulettes": epaulettes,
    "arm slits": arm_slits,
    "diagonal closing": diagonal_closing,
    "rips": rips,
    "knee rips": rips,
    "left knee rip": rips,
    "right knee rip": rips,
    "frayed hem": frayed_hem,
    "knee patches": knee_patches,
    "back ties": back_openings.back_ties,
    "back buttons": back_openings.back_buttons,
    "back lacing": back_openings.back_lacing,
    "back bow": back_openings.back_bow,
    "reflecting bands": reflecting_bands,
    "asymmetric zip": across_front.asymmetric_zip,
    "storm flap": across_front.storm_flap,
    "smocking": smocking,
    "ruching": ruching.ruching,
    "cowl folds": cowl_folds,
    "shoulder drape": shoulder_drape,
    "shoulder cut-outs": cut_outs.shoulder_cut_outs,
    "waist cut-outs": cut_outs.waist_cut_outs,
    "back cut-out": cut_outs.back_cut_out,
    "elbow patches": elbow_patches,
    "draped folds": ruching.draped_folds,
    "princess seams": seam_lines.princess_seams,
    "princess panels": seam_lines.princess_panels,
    "yoke": seam_lines.yoke,
    "waist frill": waist_frill,
    "scalloped edge": decorations.scalloped_edge,
    "toggles": toggles,
    "chest heart": chest_heart,
    "chest star": chest_star,
    "pleated front": top_pleats.pleated_front,
    "fine pleats": top_pleats.fine_pleats,
    "neck pleats": top_pleats.neck_pleats,
    "shoulder pleats": top_pleats.shoulder_pleats,
    "back pleat": top_pleats.back_pleat,
    "box pleats": top_pleats.box_pleats,
    "sleeve petals": sleeve_petals,
    "neck gathers": neck_gathers,
    "shoulder gathers": top_pleats.shoulder_gathers,
    "train": layer,
    "long train": layer,
    "overskirt": layer,
    "tulle overskirt": layer,
    "tulle layers": layer,
    "cups": cups,
    "peplum": layer,
    "back cape": layer,
    "topstitching": denim.topstitching,
    "belt loops": denim.belt_loops,
    "denim seams": denim.denim_seams,
    "strap buckles": strap_buckles,
    "kilt edge": kilt_edge,
    "hem border": decorations.hem_border,
    "folded band": folded_band,
    "thumb holes": thumb_holes,
    "sash": belts.sash,
    "blouse front": blouse_front,
    "bust gathers": bust_gathers,
    "hip knot": belts.hip_knot,
    "outer skirt": layer,
    "shoulder frills": decorations.shoulder_frills,
    "illusion yoke": illusion_yoke,
    "bustle": layer,
    "hoops": layer,
    "side tie": side_tie,
    "kick pleat": kick_pleat,
    "collar buttons": collar_buttons,
    "back yoke": seam_lines.back_yoke,
}
"""How each of `names.TRIMS` is marked."""


def place_trims(pattern: Pattern) -> tuple[Trim, ...]:
    """Where the trims that a pattern names lie; those that find no place are left out.

    Everything is measured off on the panels as they stand before draping, so that it follows whatever they
    are cut to.
    """
    chalk = Chalk(pattern)
    return tuple([piece for name in pattern.trims for piece in _PLACES[name](chalk, name)])


def trims_that_fit(pattern: Pattern, names: Sequence[str]) -> tuple[str, ...]:
    """Those of the trims that find a place on a pattern, in their order."""
    chalk = Chalk(pattern)
    return tuple([name for name in names if _PLACES[name](chalk, name)])
