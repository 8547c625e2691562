"""In what order to sew, in sentences."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import groupby

import numpy as np

from swifttailor.making.allowances import EdgeKind
from swifttailor.making.finished_measures import finished_column, in_inches
from swifttailor.making.made_for import made_for
from swifttailor.making.notions import notions
from swifttailor.making.piece import Piece
from swifttailor.making.pieces import CuttingPlan
from swifttailor.making.seams import Seam, SeamRole, gather
from swifttailor.making.trim_steps import FINISHES, has_closing, stays_open, trim_steps
from swifttailor.pattern import EdgeRef


@dataclass(frozen=True)
class SewingStep:
    """One step: a heading and what to do."""

    title: str
    sentences: tuple[str, ...]
    numbers: tuple[int, ...] = ()
    """Of the seams that it closes, as printed on the pieces."""
    stitches: tuple[int, ...] = ()
    """Positions in `Pattern.stitches` that it closes."""


_HOW = {
    SeamRole.DART: "Fold each dart right sides together so that its two lines meet. Sew from the edge to "
    "the point "
    "and press it towards the centre, or down.",
    SeamRole.ARMHOLE: "The garment still lies flat: sew the sleeve in before the side seams are closed.",
    SeamRole.UNDERARM: "Close each sleeve along the arm, right sides together.",
    SeamRole.TIER: "Close each tier to a ring first, then sew the rings together, side seams on side seams.",
    SeamRole.BAND_ENDS: "Sew the ends together to a ring.",
    SeamRole.WAIST: "Slip one part into the other, right sides together, and match side seams, centres "
    "and notches.",
    SeamRole.CROTCH: "Turn one leg right side out, slip it into the other, and sew the crotch in one go.",
    SeamRole.CUFF: "Slip the cuff over the end, right sides together, seams on seams.",
    SeamRole.NECKLINE: "Match the centre back and the shoulder seams first, then the notches.",
    SeamRole.GODET: "Sew one side of each godet from the hem to the point, then the other.",
}
_FINISHES = {
    EdgeKind.NECKLINE: (
        "Neckline",
        "Face or bind the neckline, or turn its allowance under and stitch it down.",
    ),
    EdgeKind.ARMHOLE: (
        "Armholes",
        "Face or bind the armholes, or turn their allowance under and stitch it down.",
    ),
    EdgeKind.TOP: (
        "Upper edge",
        "Finish the upper edge: face it, or turn it under to make a casing for elastic.",
    ),
    EdgeKind.SLIT: ("Slits", "Press the allowances of the slits to the inside and stitch them down."),
    EdgeKind.OPENING: (
        "Open edges",
        "Turn the allowances of the remaining open edges under and stitch them down.",
    ),
    EdgeKind.HEM: (
        "Hems",
        "Press the hem allowance up, turn its edge in, and stitch it down by hand or machine.",
    ),
    EdgeKind.CURVED_HEM: (
        "Hems",
        "Press the narrow allowance of the curved hem up bit by bit, and stitch it down.",
    ),
}


def sewing_steps(plan: CuttingPlan) -> tuple[SewingStep, ...]:
    """The steps from cut pieces to a garment; each stitch of the pattern is closed in exactly one of them."""
    ranked: list[tuple[float, SewingStep]] = [
        (step.rank, SewingStep(step.title, step.sentences)) for step in trim_steps(plan)
    ]
    both = {SeamRole.SIDE, SeamRole.UNDERARM}
    in_one_go = both <= {seam.role for seam in plan.seams}
    for role, group in groupby(
        plan.seams, key=lambda s: SeamRole.SIDE if in_one_go and s.role in both else s.role
    ):
        seams = list(group)
        title, lines = role.words, [_HOW[role]] if role in _HOW else []
        if in_one_go and role is SeamRole.SIDE:
            title = "side and underarm seams"
            lines = ["Sew each in one go, from the lower edge over the armpit to the end of the sleeve."]
        if role is SeamRole.CENTRE_FRONT and plan.closing is not None:
            title = "centre front, which stays open"
        lines += _darts(plan, seams) if role is SeamRole.DART else _joins(plan, seams)
        lines += stays_open(plan, role)
        numbers = tuple(dict.fromkeys(seam.number for seam in seams))
        stitches = tuple(k for seam in seams for k in seam.stitches)
        step = SewingStep(title[0].upper() + title[1:], tuple(lines), numbers, stitches)
        ranked.append((role.rank, step))
    for kind, (title, text) in _FINISHES.items():
        # Pockets and the like are finished in steps of their own.
        pieces = [p for p in plan.pieces if not p.trim and any(r.kind is kind for r in p.runs)]
        if pieces:
            width = plan.allowances.of(kind)
            allowance = (
                f" The allowance is {width:g} cm." if width > 0 else " It is cut without an allowance."
            )
            names = _listed(piece.name for piece in pieces)
            ranked.append((FINISHES, SewingStep(title, (f"{text}{allowance} ({names}.)",))))
    return tuple([step for _, step in sorted(ranked, key=lambda each: each[0])])


def steps_markdown(plan: CuttingPlan, *, cloth: Sequence[str] = ()) -> str:
    """The steps as Markdown, with the list of pieces before them.

    Args:
        plan: What is sewn.
        cloth: Lines about how much cloth is needed.
    """
    lines = [
        f"# {plan.name}: how to sew it",
        "",
        f"Made for {made_for(plan.sewn.pattern)}.",
        "",
        *_finished(plan),
        "## Pieces",
        "",
    ]
    lines += [f"- **{piece.name}**: {in_list(piece)}" for piece in plan.pieces]
    needed = notions(plan)
    if needed:
        lines += ["", "## Also needed", "", *(f"- {line}" for line in needed)]
    lines += ["", "## Before you sew", ""]
    lines += [f"- {line}" for line in (*cloth, *preparation(plan))]
    lines += ["", "## Steps", ""]
    for number, step in enumerate(sewing_steps(plan), start=1):
        lines.append(f"{number}. **{step.title}.** {' '.join(step.sentences)}")
    if plan.findings:
        lines += ["", "## Look at", ""]
        lines += [f"- {finding.message}." for finding in plan.findings]
    return "\n".join(lines) + "\n"


def in_list(piece: Piece) -> str:
    """How a piece is cut, for the list of pieces; of what is put on, also its size and its grain."""
    if not piece.trim:
        return piece.instruction.lower()
    width, height = np.ptp(piece.sew_line, axis=0)
    return f"{piece.instruction.lower()}; sewn {width:.1f} x {height:.1f} cm, grain along the {height:.1f} cm"


def _finished(plan: CuttingPlan) -> list[str]:
    """The measurements of the finished garment, as a table."""
    column = finished_column(plan.sewn.pattern)
    if column is None:
        return []
    rows = [f"| {name} | {cm:.1f} | {in_inches(cm)} |" for name, cm in column.cm.items()]
    return ["## Finished garment", "", "| | cm | in |", "|---|---|---|", *rows, ""]


def preparation(plan: CuttingPlan) -> list[str]:
    """What holds for all steps."""
    widths = plan.allowances
    curved = min(widths.curved_hem, widths.hem)
    return [
        f"Seam allowance {widths.seam:g} cm, hems {widths.hem:g} cm (curved ones {curved:g} cm), other edges "
        f"{widths.edge:g} cm. The outer line is cut, the dashed line is sewn.",
        "Lay the grain line along the selvedge. Transfer notches, darts and the points of slits before "
        "the paper "
        "comes off.",
        "Seams are sewn right sides together. Single notches meet single ones, double notches (back) "
        "double ones; "
        "equal numbers beside two edges mean that these edges are sewn together.",
        "To gather an edge, sew two rows of long stitches within its allowance, draw them up, and spread the "
        "fullness evenly between the notches.",
        "Press every seam before another one crosses it.",
        *_about_openings(plan),
    ]


def _about_openings(plan: CuttingPlan) -> list[str]:
    """How what is put on is marked, and what to do where nothing opens the garment."""
    marked = [
        "Pockets, buttons, zips and openings are drawn with thin dashed lines, buttons as a cross in a "
        "circle with the buttonhole across it. Transfer them too."
    ]
    if has_closing(plan):
        return marked
    return [
        *(marked if plan.trims else []),
        "The pattern has no zip and no buttons. In cloth that does not stretch, try before you close the "
        "last seams "
        "whether you can slip it on; leave an opening for a zip in the centre back seam or, where there "
        "is none, in "
        "the left side seam.",
    ]


def _darts(plan: CuttingPlan, seams: Sequence[Seam]) -> list[str]:
    counts = Counter(plan.piece_of(seam.panels[0]).name for seam in seams)
    numbers: dict[str, list[int]] = {}
    for seam in seams:
        numbers.setdefault(plan.piece_of(seam.panels[0]).name, []).append(seam.number)
    return [
        f"{name}: {'1 dart' if count == 1 else f'{count} darts in all'} ({_number_list(numbers[name])})."
        for name, count in counts.items()
    ]


def _joins(plan: CuttingPlan, seams: Sequence[Seam]) -> list[str]:
    lines = []
    by_number: dict[int, list[Seam]] = {}
    for seam in seams:
        by_number.setdefault(seam.number, []).append(seam)
    for number, alike in by_number.items():
        seam = alike[0]
        first, second = (plan.piece_of(name) for name in seam.panels)
        times = (
            "" if len(alike) == 1 else " (left and right)" if len(alike) == 2 else f" ({len(alike)} times)"
        )
        lines.append(f"Seam {number}: {_pair(first, second, seam)}{times}.{_fit(plan, seam)}")
    return lines


def _pair(first: Piece, second: Piece, seam: Seam) -> str:
    if first is second:
        return (
            f"{first.name} to itself" if seam.panels[0] == seam.panels[1] else f"{first.name} to {first.name}"
        )
    return f"{first.name} to {second.name}"


def _fit(plan: CuttingPlan, seam: Seam) -> str:
    """What to do where one side of a seam is longer."""
    sewn = plan.sewn
    own: list[EdgeRef] = []
    other: list[EdgeRef] = []
    for k in seam.stitches:
        a, b = sewn.pattern.stitches[k].sides
        a, b = (a, b) if a.panel == seam.panels[0] else (b, a)
        own.append(a)
        other.append(b)
    lengths = [sum(map(sewn.length, refs)) for refs in (own, other)]
    text = ""
    for (length, to), panel in zip((lengths, lengths[::-1]), seam.panels, strict=True):
        kind = gather(length, to)
        name = plan.piece_of(panel).name
        if kind == "gather":
            text += f" Gather {name} first, from {length:.1f} to {to:.1f} cm."
        elif kind == "ease":
            text += f" {name} is {length - to:.1f} cm longer; ease it in between the notches."
    if sewn.pattern.stitches[seam.stitches[0]].right_wrong:
        text += " Here the right side of one lies on the wrong side of the other."
    return text


def _number_list(numbers: Iterable[int]) -> str:
    unique = sorted(set(numbers))
    return f"number {unique[0]}" if len(unique) == 1 else f"numbers {_listed(map(str, unique))}"


def _listed(words: Iterable[str]) -> str:
    words = list(words)
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"
