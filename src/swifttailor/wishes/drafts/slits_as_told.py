"""Slits that a text asks a draft for, and how long those of side seams are."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.claims import Claim

_HIGH = Claim("slit_size", "high")
_USUAL_CM, _HIGH_CM = 14.0, 30.0
_SHORTEST_CM, _LONGEST_CM = 4.0, 40.0
"""Figures beyond these are not drafted in side seams."""


def is_slit(claims: Sequence[Claim]) -> bool:
    """Whether a slit is asked for."""
    return any(claim.name == "slit" and claim.value != "none" for claim in claims)


def side_slits_cm(claims: Sequence[Claim]) -> float:
    """How long slits in the side seams of what hangs from the shoulders are, cm: as told, if at all."""
    told = [float(claim.value) for claim in claims if claim.name == "slit_cm"]
    if told and _SHORTEST_CM <= told[0] <= _LONGEST_CM:
        return told[0]
    return _HIGH_CM if _HIGH in claims else _USUAL_CM
