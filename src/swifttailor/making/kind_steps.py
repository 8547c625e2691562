"""The sewing steps of what certain garments are told by: jeans, dungarees, kilts, dirndls, swim dresses."""

from __future__ import annotations

from collections.abc import Mapping

OF_KINDS: Mapping[str, tuple[str, str]] = {
    "topstitching": (
        "Topstitching",
        "Sew along the marked lines from the right side with strong thread of another colour, two rows where "
        "cloth is felled, before what lies across their ends is sewn.",
    ),
    "belt loops": (
        "Belt loops",
        "Cut a strip of 3 cm, as long as all loops and their turnings, fold it in three and topstitch both "
        "edges. Cut it into loops, and sew them to the band at the marked pieces above and below.",
    ),
    "denim seams": (
        "Yoke and seams",
        "Cut the panels apart along the marks, with allowances on both sides, sew them together again, and "
        "topstitch the seams with thread of another colour.",
    ),
    "strap buckles": (
        "Buckles",
        "Draw the ends of the straps through sliding buckles where these are marked, and set buttons for "
        "them on the bib and at the hips.",
    ),
    "kilt edge": (
        "Edge of the apron",
        "Lay a second front, cut as far as the marked edge, over the front and catch it in the waistband. "
        "Fray its edge, put the pin through it, and sew the strap with its buckle to the waist.",
    ),
    "thumb holes": (
        "Holes for the thumbs",
        "Leave the seam open at the marked holes or cut them out, and sew around them.",
    ),
    "sash": (
        "Sash",
        "Cut a band of 280 by 13 cm, fold it lengthwise, sew around it but for a gap, and turn it. Catch it "
        "at the side seams, and tie it in a bow behind.",
    ),
    "bust gathers": (
        "Gathers below the bust",
        "Cut front and back apart along the marked seam, the part below half as wide again, with allowances. "
        "Gather its upper edge to the length of the other, and sew both together.",
    ),
    "nape bow": (
        "Bow at the nape",
        "Cut a band of 90 by 10 cm, fold it lengthwise, sew around it but for a gap, and turn it. Tie it, "
        "and fasten its knot to the middle of the back of the neck.",
    ),
    "box pleats": (
        "Box pleats",
        "Cut each front and the back apart along the middle of its marked folds, 8 cm farther apart, with "
        "cloth between. Fold along the marks towards each other, and stitch the pleat down along its folds.",
    ),
    "side tie": (
        "Band and bow at the side",
        "Cut a band of 240 by 8 cm, fold it lengthwise, sew around it but for a gap, and turn it. Sew its "
        "middle to the right side seam at the waist, and tie it in a bow at the left side.",
    ),
    "hip knot": (
        "Knot at the hip",
        "Cut two bands of 50 by 14 cm, hem them, catch one in each front edge at the waist, and tie them.",
    ),
    "blouse front": (
        "Blouse",
        "Cut the marked pieces of white cloth, with allowances. Sew them to the neck, and their lower edges "
        "behind the upper edge of the bodice.",
    ),
    "shoulder frills": (
        "Frills over the shoulders",
        "Cut two strips of 8 cm, half as long again as the armholes from chest to shoulder blade. Hem one "
        "edge, gather the other, taper the ends, and catch it in the seams of the armholes.",
    ),
    "illusion yoke": (
        "Net above the bodice",
        "Cut the panels apart along the marked edge. Cut what lies above it from fine net of the colour of "
        "the skin, and sew it on under the edge of the bodice.",
    ),
    "bustle": (
        "Bustle",
        "Cut a back breadth twice as long as marked. Gather it up with three rows of tapes inside, so that "
        "it puffs out between them, and catch it in the waist and both sides.",
    ),
    "hoops": (
        "Hoops",
        "Cut the skirt so wide that its hem is as marked. Sew tapes on inside at the marked heights, and "
        "draw steel or cane through them.",
    ),
}
"""Title and text of each step, by the name of the trim."""
