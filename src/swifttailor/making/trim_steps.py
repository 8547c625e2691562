"""When and how what is put on a garment is sewn."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from swifttailor.describing.measuring.parts import Part
from swifttailor.making.closings import Closing
from swifttailor.making.decoration_steps import decorations
from swifttailor.making.notions import buttons
from swifttailor.making.pieces import CuttingPlan
from swifttailor.making.seams import SeamRole
from swifttailor.making.trim_words import ACROSS, BANDS, POCKETS
from swifttailor.pattern.trims import Patch

FINISHES = 30.0
"""Place of hems and other edges in the order of sewing, after all seams (`SeamRole.rank`)."""
_CLOSE = 90.0
_UPPER = "The right front lies above the left one; in clothes for men, the left one."


@dataclass(frozen=True)
class TrimStep:
    """One step and its place among the seams."""

    rank: float
    title: str
    sentences: tuple[str, ...]


def trim_steps(plan: CuttingPlan) -> list[TrimStep]:
    """The steps of all that is put on a garment, in the order of sewing."""
    found = [*_pockets(plan), *_openings(plan), *_others(plan), *_zips(plan), *_fronts(plan), *_waist(plan)]
    found += [TrimStep(FINISHES + 0.7, title, (text,)) for title, text in decorations(plan)]
    return sorted(found, key=lambda step: step.rank)


def stays_open(plan: CuttingPlan, role: SeamRole) -> list[str]:
    """What to do where all of a seam or a part of it stays open for what is put on."""
    if role is SeamRole.CENTRE_FRONT and plan.closing is not None:
        return _open_front(plan, plan.closing)
    names = {trim.trim for trim in plan.trims}
    partly = {
        SeamRole.CENTRE_FRONT: ("half zip", "polo placket", "waist placket"),
        SeamRole.CENTRE_BACK: ("back zip", "back ties", "back buttons", "back lacing"),
    }
    for name in ("side zip", "side pockets"):
        if name in names:
            side = _side_role(plan, name)
            partly[side] = (*partly.get(side, ()), name)
    return ["It stays open along the mark."] if names & set(partly.get(role, ())) else []


def _open_front(plan: CuttingPlan, closing: Closing) -> list[str]:
    lines = ["Do not sew this seam: the front stays open, and is closed by what is put on below."]
    if closing.extension > 0:
        lines = [
            "Do not sew this seam: each front reaches beyond its centre front line by "
            f"{closing.extension:.1f} cm, so that they lap. Lay centre front on centre front. {_UPPER}"
        ]
    opened = [p.name for p in plan.pieces if any(m.words == "cut open here" for m in p.marks)]
    for name in opened:
        more = closing.extension + plan.allowances.seam
        lines.append(
            f"{name} is open in the middle, too: cut it in two there, with {more:.1f} cm more at both ends."
        )
    return lines


def has_closing(plan: CuttingPlan) -> bool:
    """Whether something put on opens the garment."""
    words = ("zip", "button", "fly", "placket")
    return any(word in trim.trim for trim in plan.trims for word in words)


def _pockets(plan: CuttingPlan) -> Iterator[TrimStep]:
    for name in dict.fromkeys(trim.trim for trim in plan.trims if trim.trim in POCKETS):
        own = [piece for piece in plan.pieces if piece.trim == name]
        count = sum(piece.count for piece in own if "flap" not in piece.name)
        title = POCKETS[name].capitalize() + ("s" if count > 1 else "")
        sides = "the slanted edges" if name == "kangaroo pocket" else "the upper edge"
        lines = [
            f"Press the facing of 3 cm at {sides} to the inside and stitch it down; press the other "
            "allowances under. Lay the pocket on its outline and topstitch the edges that stay closed."
        ]
        if any("flap" in piece.name for piece in own):
            lines.append(
                "Sew flaps in pairs, right sides together, and leave the upper edge open. Turn, press, "
                "topstitch, and work the buttonhole. Sew the upper edge on above the pocket, where the flap "
                "is marked, and press the flap down."
            )
        # Halves of a front are one before a pocket lies across them.
        across = name in ACROSS and plan.closing is None
        yield TrimStep(SeamRole.CENTRE_FRONT.rank + 0.5 if across else 2.5, title, tuple(lines))


def _openings(plan: CuttingPlan) -> Iterator[TrimStep]:
    names = {trim.trim for trim in plan.trims}
    if "slant pockets" in names:
        yield TrimStep(
            2.6,
            "Slanted pockets",
            (
                "Cut the front off 1 cm outside the marked opening. Sew the front of the pocket bag to it "
                "there, right sides together, turn it to the inside and topstitch the edge.",
                "Lay the back of the bag under it, so that it fills the corner, and sew the bags together "
                "around the inner and lower sides. Baste them to the waist and the side seam.",
            ),
        )
    if "side pockets" in names:
        yield TrimStep(
            _side_role(plan, "side pockets").rank - 0.1,
            "Pockets in the side seams",
            (
                "Sew one bag to the front and one to the back, right sides together, along the marked "
                "opening. Then sew the side seam down to the opening, around both bags, and on below it.",
            ),
        )


def _others(plan: CuttingPlan) -> Iterator[TrimStep]:
    names = {trim.trim for trim in plan.trims}
    if "quilting" in names:
        yield TrimStep(
            2.4,
            "Quilting",
            (
                "Baste wadding and a backing under the cloth, and stitch along the marked lines before "
                "seams are sewn.",
            ),
        )
    if not names.isdisjoint(("welt pockets", "back welt pockets")):
        yield TrimStep(
            2.6,
            "Welt pockets",
            (
                "For each, cut a welt of 17 by 6 cm and two pocket bags of 17 by 18 cm. Fold the welt "
                "lengthwise, sew it and one bag on below the marked outline and the other bag above it, cut "
                "the cloth open between them, and slant the cut to the corners. Turn the bags inside, sew "
                "down the ends of the welt, and close the bags.",
            ),
        )
    if "turn-ups" in names:
        yield TrimStep(
            FINISHES + 0.5,
            "Turn-ups",
            (
                "Cut the legs longer by twice the height of the marked bands and 2 cm. Turn that to the "
                "inside, hem it, turn the band up to the outside, and fix it at the seams.",
            ),
        )


def _zips(plan: CuttingPlan) -> Iterator[TrimStep]:
    names = {trim.trim for trim in plan.trims}
    if "zip" in names and plan.closing is not None:
        yield TrimStep(
            FINISHES - 2,
            "Zip",
            (
                "Press the allowances of the open front under. Set the separating zip between them, its "
                "teeth at the edges, and topstitch along the marked lines. Facings and bindings come after "
                "it.",
            ),
        )
    if "half zip" in names:
        yield TrimStep(
            SeamRole.CENTRE_FRONT.rank + 0.6,
            "Zip at the neck",
            (
                "Leave the centre front open along the mark, or cut it open where the front is on the fold. "
                "Set the zip in and topstitch along the marked lines.",
            ),
        )
    if "back zip" in names:
        on_skirt = any(t.trim == "back zip" and "skirt" in getattr(t, "panel", "") for t in plan.trims)
        role = SeamRole.SKIRT if on_skirt else SeamRole.CENTRE_BACK
        cut = "Cut the skirt's back open along the mark. " if on_skirt else ""
        text = f"{cut}Leave the middle of the back open along the mark, and set the zip in."
        yield TrimStep(role.rank + 0.5, "Zip at the back", (text,))
    if "side zip" in names:
        text = "Leave the left side seam open along the mark, and set the zip in."
        yield TrimStep(_side_role(plan, "side zip").rank + 0.5, "Zip in the side seam", (text,))
    if "fly" in names:
        yield TrimStep(
            SeamRole.CROTCH.rank - 0.5,
            "Fly",
            (
                "Sew the crotch seam of the fronts from the lower end of the fly to the inner legs. Sew the "
                "fly facing to the left front and the folded fly shield, with the zip between, to the right "
                "one.",
                "Sew the other half of the zip to the facing, and topstitch the left front along the marked "
                "line. Cut the waistband open in the middle of its front, with 5 cm more at the right end.",
            ),
        )


def _fronts(plan: CuttingPlan) -> Iterator[TrimStep]:
    closing = plan.closing
    banded = [p for p in plan.pieces if not p.trim and any(m.words.startswith("front band") for m in p.marks)]
    if banded and any(t.trim in BANDS for t in plan.trims):
        on_skirt = [p.name for p in banded if plan.sewn.panel(p.panels[0]).placed.part is Part.SKIRT]
        lines = [f"Cut {name} open along its middle." for name in on_skirt]
        lines.append(
            f"Cut the fronts off {plan.allowances.seam:g} cm outside the inner line of the band, on the side "
            "of the edge, as far as it is marked. Sew one long edge of a band to each along that line, "
            "right sides together, fold it in the middle, and stitch the other edge down on the inside; "
            f"close its ends. The bands lap, middle on middle. {_UPPER}"
        )
        rank = SeamRole.WAIST.rank + 0.5 if on_skirt else SeamRole.CENTRE_FRONT.rank + 0.7
        yield TrimStep(rank, "Front bands", tuple(lines))
    if closing is not None and closing.extension > 0:
        yield TrimStep(
            FINISHES - 1,
            "Front facings",
            (
                "Lay each facing on its front, right sides together, and sew along the front edge and the "
                "end at the neck. Turn it to the inside, press, and fasten its inner edge by hand.",
            ),
        )
    count = sum(buttons(plan).values())
    if count:
        yield TrimStep(
            _CLOSE,
            "Buttonholes and buttons",
            (
                "Work the buttonholes where they are marked, on the front that lies above and on flaps. "
                f"Sew on the {'button' if count == 1 else f'{count} buttons'}.",
            ),
        )


def _waist(plan: CuttingPlan) -> Iterator[TrimStep]:
    names = {trim.trim for trim in plan.trims}
    fold = "Fold the belt along its middle, right sides together. Sew around it, but for a gap, and turn it."
    loops = "Make loops of leftover cloth and sew them on at the waist."
    if "tie belt" in names:
        yield TrimStep(_CLOSE - 2, "Belt", (f"{fold} Topstitch the edges. {loops}",))
    if "buckle belt" in names:
        text = f"{fold} Fasten the buckle to one end, and set eyelets or holes into the other. {loops}"
        yield TrimStep(_CLOSE - 2, "Belt", (text,))
    if "elastic waist" in names:
        text = (
            "Leave a gap in the inner edge of the waistband, draw elastic as long as the waist less 5 cm "
            "through it, sew its ends together, and close the gap. Stretch the band while you sew its rows."
        )
        yield TrimStep(_CLOSE - 2, "Elastic", (text,))
    if "back elastic" in names:
        text = (
            "Lay elastic three quarters as long as the back of the waistband inside it, sew its ends to the "
            "side seams, and stretch it while you sew its row."
        )
        yield TrimStep(_CLOSE - 2, "Elastic", (text,))
    if "drawstring" in names:
        text = (
            "Set two eyelets at the marks of the cord before the upper edge is folded to a casing, "
            "and draw the cord in last."
        )
        yield TrimStep(SeamRole.BAND_ENDS.rank - 0.5, "Eyelets for the cord", (text,))


def _side_role(plan: CuttingPlan, name: str) -> SeamRole:
    """The seam beside which something lies."""
    panel = next(t.panel for t in plan.trims if isinstance(t, Patch) and t.trim == name)
    part = plan.sewn.panel(panel).placed.part
    return {Part.TROUSER: SeamRole.OUTSEAM, Part.SKIRT: SeamRole.SKIRT}.get(part, SeamRole.SIDE)
