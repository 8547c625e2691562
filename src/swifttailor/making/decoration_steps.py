"""The sewing steps of what is put on for its looks: frills, fringe, edging, bows, lacing, cords, aprons."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from swifttailor.making.frill_steps import frill_step
from swifttailor.making.kind_steps import OF_KINDS
from swifttailor.making.pieces import CuttingPlan
from swifttailor.pattern.trims import Frill

_RIPS = (
    "Rips",
    "Cut across each mark of a rip with a few cuts from side to side, and draw out the threads that run up "
    "and down between them. Leave those that run across. Sew around the marks, so that they tear no further.",
)
_KEYHOLE = (
    "Keyhole",
    "Face the marked drop before the neck is finished: sew a piece of cloth to it along the mark, cut the "
    "drop out, turn the facing in, and close the neck above it with a button and a loop.",
)
_TRAIN = (
    "Train",
    "Cut the back of the skirt once more, its hem drawn on by the length of the train in the middle and by "
    "nothing at the sides. Hem it, lay it over the back, and catch its upper edge in the seam of the waist "
    "and its sides in the side seams.",
)
_OVERSKIRT = (
    "Overskirt",
    "Cut a skirt as long as the other and half as wide again, open in front. Hem its front edges and its "
    "hem, gather it to a band for the waist that closes in front with hooks, and wear it over the other.",
)
_CUT_OUT = (
    "Cut-outs",
    "Sew the seams that cross the marked openings up to their ends. Face each opening along the mark before "
    "it is cut out, and turn the facing in.",
)
_OTHERS: Mapping[str, tuple[str, str]] = {
    "neck cord": (
        "Cord at the neck",
        "Set two eyelets where the cord is marked, and draw it through the edge of the hood or the neckline.",
    ),
    "neck bow": (
        "Bow at the neck",
        "Cut a band of 140 by 12 cm, fold it lengthwise, sew around it but for a gap, turn it, and sew its "
        "middle to the back of the neck. Tie it in front.",
    ),
    "waist bow": (
        "Bow at the waist",
        "Cut a band of 120 by 12 cm, fold it lengthwise, sew around it but for a gap, and turn it. Tie it, "
        "and fasten its knot to the middle of the waist.",
    ),
    "shoulder bows": (
        "Bows on the shoulders",
        "Cut two bands of 60 by 6 cm, fold each lengthwise, sew around it but for a gap, and turn it. Tie "
        "each, and fasten its knot to the front of a shoulder or strap.",
    ),
    "stirrups": (
        "Straps under the feet",
        "Cut two bands of 24 by 8 cm, fold each lengthwise, sew along it and turn it. Sew its ends under the "
        "end of each leg, at the inner and the outer seam.",
    ),
    "rips": _RIPS,
    "knee rips": _RIPS,
    "left knee rip": _RIPS,
    "right knee rip": _RIPS,
    "back ties": (
        "Ties at the back",
        "Leave the seam in the middle of the back open from the neck down, and hem both of its edges. Cut "
        "two bands of 30 by 4 cm for each tie, fold them lengthwise, sew and turn them, one for each edge.",
    ),
    "back buttons": (
        "Buttons at the back",
        "Leave the seam in the middle of the back open as far as the buttons go. Sew a strip of 5 cm to each "
        "edge, fold it in the middle, and lap the halves. Work the buttonholes in the upper one.",
    ),
    "back lacing": (
        "Lacing at the back",
        "Leave the seam in the middle of the back open as far as it is laced, and face its edges. Set "
        "eyelets at the outer ends of the marked lines, and lace a cord of 3 m through them.",
    ),
    "back bow": (
        "Bow at the back",
        "Cut two bands of 90 by 14 cm, fold them lengthwise, sew and turn them. Catch them in the side seams "
        "at the waist, and tie them behind.",
    ),
    "keyhole": _KEYHOLE,
    "back keyhole": _KEYHOLE,
    "arm slits": (
        "Slits for the arms",
        "Cut two welts twice as wide as the marked pieces, with allowances. Fold them lengthwise, sew them "
        "to the inner sides of the marked lines, cut these open and hem their other sides.",
    ),
    "front frills": (
        "Frills down the front",
        "Cut two strips of 6 cm, twice as long as the front seam, hem their outer edges, gather the inner "
        "ones to the length of the seam, and sew them on beside it.",
    ),
    "yoke frill": (
        "Frill around the yoke",
        "Cut a strip of 7 cm, twice as long as the marked piece all around, hem one edge, gather the other "
        "to its length, and sew it on along the upper marked line.",
    ),
    "neck lace": (
        "Lace at the neck",
        "Sew lace of 4 cm along the neckline or the edge of the collar, its straight edge to the seam.",
    ),
    "collar buttons": (
        "Buttons at the points of the collar",
        "Sew a buttonhole of 1.2 cm at each point of the collar, and small buttons on the fronts below them.",
    ),
    "epaulettes": (
        "Epaulettes",
        "Cut four tabs of the marked halves, laid together along the shoulder, with allowances. Sew two and "
        "two together but for their straight ends, turn them, catch these in the seams of the armholes, and "
        "button the others beside the neck.",
    ),
    "lacing": (
        "Lacing",
        "Set eyelets at the outer ends of the marked lines, and lace a cord of 2 m through them.",
    ),
    "boning": (
        "Boning",
        "Before the lining or facing is sewn in, sew tape of 1.5 cm behind each marked line, along both "
        "of its edges. Cut bones 1 cm shorter than the channels, round their ends, and push them in.",
    ),
    "tucks": (
        "Tucks",
        "Cut the fronts 0.6 cm wider for each marked line. Fold the cloth on each line, sew 0.3 cm beside "
        "the fold, and press all folds towards the armholes.",
    ),
    "pleated front": (
        "Pleats down the front",
        "Cut the fronts 3 cm wider for each marked line, fold the cloth on it towards the side by half of "
        "that, press the folds from end to end, and baste them above and below.",
    ),
    "fine pleats": (
        "Narrow pleats",
        "Have the cloth pleated before it is cut, or cut the panels twice as wide, fold 0.7 cm on each "
        "marked line, press the folds, and baste them above and below.",
    ),
    "neck pleats": (
        "Pleats below the neck",
        "Spread the front along the marked lines, 2 cm at the neckline for each, lay this in folds "
        "towards the middle, and baste them to the length that the neckline had.",
    ),
    "shoulder pleats": (
        "Pleats below the shoulders",
        "Spread the fronts along the marked lines, 2 cm at the shoulder for each, lay this in folds "
        "towards the neck, and baste them to the length of the seam.",
    ),
    "back pleat": (
        "Pleat in the back",
        "Cut the back 8 cm wider in the middle, fold both marked lines to the middle behind it, and baste "
        "the pleat at its upper end.",
    ),
    "kick pleat": (
        "Kick pleat",
        "Cut the back of the skirt 12 cm wider in the middle, from the upper end of the marked pleat down, "
        "fold both marked lines to the middle over it, and stitch it along the slanting lines.",
    ),
    "neck gathers": (
        "Gathers below the neck",
        "Spread the front along the marked lines, 1.5 cm at the neckline for each, and gather this to the "
        "length that it had.",
    ),
    "shoulder gathers": (
        "Gathers below the shoulders",
        "Spread the fronts along the marked lines, 1.5 cm at the shoulder for each, and gather these "
        "edges to the length of the seam.",
    ),
    "sleeve petals": (
        "Petal sleeves",
        "Cut each sleeve in two halves that reach 5 cm beyond the seam on top, along the marked edge and "
        "its mirror image, finish these edges and the hems, lay the halves over each other, and baste "
        "them at the armhole.",
    ),
    "reflecting bands": (
        "Reflecting bands",
        "Lay reflecting tape of 5 cm on the marks, and topstitch both of its edges before the side seams are "
        "sewn.",
    ),
    "three side stripes": (
        "Three stripes down the sides",
        "Sew the seams first. Lay a ribbon of 0.9 cm over each, one on either side of it as far away "
        "as it is wide, and topstitch both edges of all three.",
    ),
    "three sleeve stripes": (
        "Three stripes down the sleeves",
        "Sew the seams on top of the sleeves first. Lay a ribbon of 0.9 cm over each, one on either side of "
        "it as far away as it is wide, and topstitch both edges of all three.",
    ),
    "asymmetric zip": (
        "Zip across the front",
        "Sew the fronts together in the middle, cut them along the marked strip, and set the zip in from the "
        "neck to the hem.",
    ),
    "toggles": (
        "Toggles",
        "Knot a loop of cord on one front and a peg on a cord on the other at every mark, and sew a patch of "
        "leather or cloth over the ends of each.",
    ),
    "smocking": (
        "Smocking",
        "Cut the panels of the bodice twice as wide, their height as it is. Wind elastic thread on the "
        "bobbin, sew along every marked row with the longest stitch, and steam the cloth until it is as wide "
        "as the panel was.",
    ),
    "ruching": (
        "Ruching",
        "Cut the panels one and a half times as long below the marked folds, gather their side edges to the "
        "length that they had, and sew the side seams over narrow elastic.",
    ),
    "cowl folds": (
        "Cowl",
        "Cut the front on the bias, spread along the marked folds by 3 cm each so that the neckline is "
        "longer than it was, face its edge, and let the cloth between the shoulders hang in folds.",
    ),
    "storm flap": (
        "Storm flap",
        "Cut the marked piece twice, with allowances. Sew both together but for shoulder and armhole, turn "
        "them, and catch these edges in the seams there.",
    ),
    "shoulder drape": (
        "Cloth over the shoulder",
        "Cut a length of cloth as wide as the marked piece at the waist and as long as it reaches, and hem "
        "it. Catch it in the seam of the waist at the right side, lay it in folds up to the left shoulder, "
        "pin it there, and let the rest hang down the back.",
    ),
    "shoulder cut-outs": _CUT_OUT,
    "waist cut-outs": _CUT_OUT,
    "back cut-out": _CUT_OUT,
    "elbow patches": (
        "Patches on the elbows",
        "Cut the marked pieces of the other cloth, with allowances. Press these under, lay the pieces on the "
        "sleeves while these are flat, and topstitch all around.",
    ),
    **dict.fromkeys(
        ("chest heart", "chest star"),
        (
            "Figure on the chest",
            "Cut the marked figure of the other cloth in one piece, without allowances, iron it onto the "
            "fronts when these are joined, and sew closely around it.",
        ),
    ),
    "side panels": (
        "Side panels",
        "Cut the marked pieces from the other cloth, with allowances, and the panels so much narrower; "
        "sew them to each other before the side seams.",
    ),
    "draped folds": (
        "Draped folds",
        "Cut the front wider where the marked folds meet, lay it in folds along the marks, and baste them at "
        "the side seam before it is sewn.",
    ),
    "princess panels": (
        "Princess panels",
        "Lay bodice and skirt edge to edge at the waist, cut both apart along the marked lines, and cut each "
        "upper piece and the lower one in one, so that no seam runs around the waist; darts end in the "
        "seams between the panels.",
    ),
    "princess seams": (
        "Princess seams",
        "Cut the panels apart along the marks, with allowances on both sides, and sew them together again "
        "before the side seams; darts on the way are taken up by the seam.",
    ),
    "yoke": (
        "Yoke",
        "Cut the panels apart along the mark, with allowances on both sides, sew them together again, and "
        "topstitch the seam.",
    ),
    "back yoke": (
        "Yoke of the back",
        "Cut the backs apart along the mark, with allowances on both sides, cut the yoke twice, and sew the "
        "lower back in between both layers.",
    ),
    "scalloped edge": (
        "Scallops along the hem",
        "Cut a facing of 7 cm along the hem, draw arcs of 5 cm below the hem line, sew the facing on along "
        "them, right sides together, clip the corners, and turn it.",
    ),
    "waist frill": (
        "Frill above the waistband",
        "Cut the waistband 12 cm higher. Fold its upper edge in by 4 cm, and sew it down where the frill "
        "begins.",
    ),
    "train": _TRAIN,
    "long train": _TRAIN,
    "overskirt": _OVERSKIRT,
    "tulle overskirt": _OVERSKIRT,
    "tulle layers": (
        "Layers of tulle",
        "Cut three layers of tulle as long as the skirt, each three times as wide as its hem. Gather their "
        "upper edges to the waist, and catch all three in its seam. Tulle needs no hem.",
    ),
    "peplum": (
        "Peplum",
        "Cut a half ring of 18 cm whose inner edge is as long as the waist, hem it, and catch it in the seam "
        "of the waist.",
    ),
    "outer skirt": (
        "Skirt over the legs",
        "Cut two pieces that reach from the waist to 4 cm above the ends of the legs, as wide as the waist "
        "above and half as wide again below. Sew their sides, hem them, and catch the upper edge in the seam "
        "of the waist.",
    ),
    "back cape": (
        "Cape behind",
        "Cut a piece as wide as the back and half as much again, as long as from the shoulders to the hem. "
        "Hem it but for its upper edge, gather this to the width of the back, and catch it in the seams of "
        "the shoulders.",
    ),
    "cups": (
        "Cups",
        "Cut the fronts apart along the marks, with allowances on both sides, take what the dart takes away "
        "off the seams, sew them together again, and sew a moulded cup behind each breast.",
    ),
    "apron": (
        "Apron",
        "Cut the marked piece once more, with allowances. Hem its sides and lower edge, and catch its upper "
        "edge in the seam of the waist. Where a band is marked, sew it to that edge instead, and tie it "
        "behind.",
    ),
    **OF_KINDS,
}


def decorations(plan: CuttingPlan) -> Iterator[tuple[str, str]]:
    """Title and text of each step, in the order in which the pattern names what is put on."""
    seen = set()
    for trim in plan.trims:
        if trim.trim in seen:
            continue
        seen.add(trim.trim)
        if isinstance(trim, Frill):
            yield frill_step(trim)
        elif trim.trim in _OTHERS:
            yield _OTHERS[trim.trim]
