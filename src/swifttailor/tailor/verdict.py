"""Whether a pattern is what was ordered: the one verdict that all attempts are compared by."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from swifttailor.pattern import Finding, Severity
from swifttailor.tailor.sitting import FALLS_OFF

if TYPE_CHECKING:
    from swifttailor.describing.differences import Change

_SENSELESS, _HOLES, _ONE_SIDED = 4, 3, 2
"""What a garment of no kind, open seams, and panels that lack their counterpart count for, where an open wish
or warning counts one."""
_FALLS_OFF = 3
"""What it counts that a waistband goes over the hips."""
_BARE = 2
"""How much more shoulders count that were to be bare and are covered."""
_SAID = 2
"""How much more an open wish of the words counts than one that was read in a picture beside them."""


@dataclass(frozen=True)
class Verdict:
    """What is wrong with a pattern, gravest first."""

    findings: tuple[Finding, ...] = ()
    """What a check finds."""
    tolerated: frozenset[str] = frozenset()
    """Codes of warnings that are no fault: the pattern to edit had them before."""
    senseless: bool = False
    """Whether it is measured to be no kind of garment."""
    sits_badly: tuple[str, ...] = ()
    """What will stand off or not go over the body, in words; another attempt may be better."""
    beyond_usual: tuple[str, ...] = ()
    """What nobody asked for and is odd, in words; another that is known already may be better."""
    holes: bool = False
    """Whether seams are open that no garment leaves open."""
    one_sided: tuple[str, ...] = ()
    """Panels without their counterpart on the other side, which nobody asked for."""
    unsewable: str = ""
    """Why it cannot be sewn, where that was tried."""
    open: tuple[Change, ...] = ()
    """What was asked for and does not hold, or cannot be measured."""
    seen: tuple[Change, ...] = ()
    """What a picture alone asked for."""
    refused: tuple[Change, ...] = ()
    """What was refused and holds nevertheless."""

    @property
    def oddities(self) -> list[str]:
        """What a check does not see, in words: what was never written."""
        found = ["nobody could wear it"] if self.senseless else []
        if self.holes:
            found.append("seams are open that should be sewn")
        if self.one_sided:
            found.append(f"{', '.join(self.one_sided)}: no counterpart on the other side")
        return found

    @property
    def unsound(self) -> str:
        """What is wrong with the pattern itself, in words; empty where it is worth sewing."""
        found = [f for f in self.findings if f.severity is Severity.ERROR]
        found = found or [
            f for f in self.findings if f.severity is Severity.WARNING and f.code not in self.tolerated
        ]
        if not found:
            return "; ".join(self.oddities)
        place = f" ({found[0].where()})" if found[0].where() else ""
        more = f", and {len(found) - 1} more" if len(found) > 1 else ""
        return f"{found[0].code}{place}: {found[0].message}{more}"

    @property
    def fault(self) -> str:
        """The gravest that is wrong, in words; empty where nothing is, and no other attempt is made."""
        from swifttailor.wording.wish_lines import wish_line

        if self.unsound or self.unsewable:
            return self.unsound or self.unsewable
        if self.open:
            return f"requested but not met: {'; '.join(map(wish_line, self.open))}"
        if self.refused:
            return f"refused, and so nevertheless: {'; '.join(map(wish_line, self.refused))}"
        complaints = (*self.sits_badly, *self.beyond_usual)
        return f"sits badly: {'; '.join(complaints)}" if complaints else ""

    @property
    def is_merely_odd(self) -> bool:
        """Whether nothing is wrong but what is beyond the usual: nothing is written anew for that."""
        return bool(self.beyond_usual) and not replace(self, beyond_usual=()).fault

    @property
    def _open_wishes(self) -> int:
        """How many wishes are open; shoulders that should be bare and are covered count more."""
        from swifttailor.describing.claims import Claim
        from swifttailor.describing.differences import Gain

        return len(self.open) + _BARE * (Gain(Claim("shoulders", "strapless")) in self.open)

    @property
    def rank(self) -> tuple[int, int, int]:
        """Smaller is better: errors; warnings, open wishes and the like; what sits badly."""
        severities = [f.severity for f in self.findings]
        errors, warnings = (severities.count(s) for s in (Severity.ERROR, Severity.WARNING))
        doubts = (
            warnings
            + self._open_wishes
            + len(self.refused)
            + _FALLS_OFF * (FALLS_OFF in self.sits_badly)
            + _SENSELESS * self.senseless
            + _HOLES * self.holes
        )
        said = sum(change not in self.seen for change in self.open) if self.seen else 0
        return (
            errors,
            doubts + _SAID * said + _ONE_SIDED * bool(self.one_sided),
            len(self.sits_badly) + len(self.beyond_usual),
        )
