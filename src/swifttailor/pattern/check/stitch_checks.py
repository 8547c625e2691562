"""Findings about the stitches: whether each can be sewn, and what they do to the panels together."""

from __future__ import annotations

from collections import Counter
from typing import Literal

from swifttailor.pattern.check.outline import Outline
from swifttailor.pattern.check.seam_direction import Directions
from swifttailor.pattern.check.seam_topology import SeamTopology
from swifttailor.pattern.finding import Finding, Severity
from swifttailor.pattern.finding_kinds import found
from swifttailor.pattern.pattern import EdgeRef, Pattern, Stitch

EASE_RATIO = 1.05
GATHER_RATIO = 1.2
UNEVEN_RATIO = 4.0
ABSURD_RATIO = 20.0
EQUAL_CM = 0.1
UNEVEN_CM = 2.0
ABSURD_CM = 10.0
COLLAPSED_CM = 3.0

SeamFit = Literal["equal", "ease", "gather", "uneven", "absurd"]


def judge_lengths(first: float, second: float) -> SeamFit:
    """How two edges of these lengths in cm go together.

    The bounds come from real patterns: two thirds of all stitches are within 1 %, gathers reach a ratio of
    about 3, and only edges below a centimetre differ by more.

    Returns:
        ``equal`` (ratio to 1.05 or within 1 mm), ``ease`` (to 1.2), ``gather`` (to 4, or any ratio within
        2 cm), ``uneven`` (to 20), ``absurd`` (beyond, where they also differ by over 10 cm).
    """
    short, long = sorted((first, second))
    ratio = long / short if short > 0 else float("inf")
    if ratio <= EASE_RATIO or long - short <= EQUAL_CM:
        return "equal"
    if ratio <= GATHER_RATIO:
        return "ease"
    if ratio <= UNEVEN_RATIO or long - short <= UNEVEN_CM:
        return "gather"
    return "absurd" if ratio > ABSURD_RATIO and long - short > ABSURD_CM else "uneven"


def stitch_key(stitch: Stitch) -> tuple[EdgeRef, EdgeRef, bool]:
    """Equal for stitches that join the same edges the same way, whichever is named first."""
    first, second = sorted(stitch.sides)
    return first, second, stitch.right_wrong


def usable_stitches(pattern: Pattern) -> list[int]:
    """Indices of the stitches that join two different edges, both of which exist; repeats left out."""
    usable, seen = [], set()
    for k, s in enumerate(pattern.stitches):
        known = pattern.has_edge(s.first) and pattern.has_edge(s.second) and s.first != s.second
        if known and stitch_key(s) not in seen:
            seen.add(stitch_key(s))
            usable.append(k)
    return usable


def single_stitches(pattern: Pattern, usable: list[int]) -> list[int]:
    """Those of the usable stitches whose two edges are in no other stitch.

    Only these say anything about directions: where an edge is stitched twice, one of the stitches is wrong.
    """
    uses = Counter(ref for k in usable for ref in pattern.stitches[k].sides)
    return [k for k in usable if all(uses[ref] == 1 for ref in pattern.stitches[k].sides)]


def check_stitches(
    pattern: Pattern, outlines: dict[str, Outline], usable: list[int], directions: Directions
) -> list[Finding]:
    """All findings about stitches."""
    return [
        *_broken(pattern, usable),
        *_used_twice(pattern, usable),
        *_uneven(pattern, outlines, usable),
        *_twisted(pattern, directions),
        *_collapsed(pattern, outlines, usable, directions),
        *_disconnected(pattern),
    ]


def _broken(pattern: Pattern, usable: list[int]) -> list[Finding]:
    findings = []
    good = set(usable)
    for k, s in enumerate(pattern.stitches):
        if k in good:
            continue
        missing = next((ref for ref in s.sides if not pattern.has_edge(ref)), None)
        if missing is not None:
            code, text, place = "dangling-stitch", f"'{missing.panel}' has no edge {missing.edge}", missing
        elif s.first == s.second:
            code, text, place = "self-stitched-edge", "the edge is stitched to itself", s.first
        else:
            code, text, place = "duplicate-stitch", f"repeats an earlier stitch of {_name(s)}", s.first
        findings.append(found(code, text, panel=place.panel, edge=place.edge, stitch=k))
    return findings


def _used_twice(pattern: Pattern, usable: list[int]) -> list[Finding]:
    uses: dict[EdgeRef, list[int]] = {}
    for k in usable:
        for ref in pattern.stitches[k].sides:
            uses.setdefault(ref, []).append(k)
    return [
        found(
            "edge-stitched-twice",
            f"the edge is in {len(at)} stitches ({', '.join(map(str, at[:6]))})",
            panel=ref.panel,
            edge=ref.edge,
            stitch=at[1],
            value=len(at),
        )
        for ref, at in uses.items()
        if len(at) > 1
    ]


def _uneven(pattern: Pattern, outlines: dict[str, Outline], usable: list[int]) -> list[Finding]:
    findings = []
    for k in usable:
        s = pattern.stitches[k]
        a, b = (float(outlines[ref.panel].lengths[ref.edge]) for ref in s.sides)
        fit = judge_lengths(a, b)
        if fit not in ("uneven", "absurd"):
            continue
        ratio = max(a, b) / max(min(a, b), 1e-9)
        findings.append(
            found(
                "uneven-seam",
                f"{_name(s)}: {a:.1f} cm meet {b:.1f} cm (ratio {ratio:.3g})",
                panel=s.first.panel,
                edge=s.first.edge,
                stitch=k,
                value=ratio,
                severity=Severity.ERROR if fit == "absurd" else Severity.WARNING,
            )
        )
    return findings


def _twisted(pattern: Pattern, directions: Directions) -> list[Finding]:
    findings = []
    for t in directions.twisted:
        s = pattern.stitches[t.stitch]
        now, then = (
            ("start to start", "start to end") if s.right_wrong else ("start to end", "start to start")
        )
        reasons = [f"its neighbours would glue {t.collapses} corners together"] if t.collapses else []
        reasons += ["the placed edges run the other way"] if t.agreement < -0.2 else []
        mend = "adding 'right_wrong'" if not s.right_wrong else "removing 'right_wrong'"
        findings.append(
            found(
                "twisted-seam",
                f"{_name(s)} is sewn {now}, but should be {then}: {' and '.join(reasons)}",
                panel=s.first.panel,
                edge=s.first.edge,
                stitch=t.stitch,
                value=round(t.agreement, 3),
                repair=f"--repair turns it by {mend}"
                if t.certain
                else f"turn it by {mend}, unless its partner is wrong (not certain enough for --repair)",
            )
        )
    return findings


def _collapsed(
    pattern: Pattern, outlines: dict[str, Outline], usable: list[int], directions: Directions
) -> list[Finding]:
    topology = SeamTopology(pattern, single_stitches(pattern, usable))
    topology.flip([t.stitch for t in directions.twisted])
    return [
        found(
            "collapsed-edge",
            f"the stitches join both ends of the edge ({outlines[ref.panel].lengths[ref.edge]:.2g} cm)",
            panel=ref.panel,
            edge=ref.edge,
            value=float(outlines[ref.panel].lengths[ref.edge]),
        )
        for ref in topology.collapsed_edges()
        if outlines[ref.panel].lengths[ref.edge] < COLLAPSED_CM
    ]


def _disconnected(pattern: Pattern) -> list[Finding]:
    groups = pattern.components()
    if len(groups) < 2:
        return []
    loose = Counter(len(g) for g in groups)[1]
    listed = "; ".join(", ".join(g[:3]) + (", ..." if len(g) > 3 else "") for g in groups[:4])
    return [
        found(
            "disconnected",
            f"the stitches leave {len(groups)} separate pieces ({loose} of a single panel): {listed}"
            + ("; ..." if len(groups) > 4 else ""),
            value=len(groups),
        )
    ]


def _name(stitch: Stitch) -> str:
    return " - ".join(f"{ref.panel}.{ref.edge}" for ref in stitch.sides)
