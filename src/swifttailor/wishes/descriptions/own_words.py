"""What a text asks for, in the words that the pattern maker was trained on.

People make typing errors, name colours and use words that it has never read; one such word can be enough to
make it leave out half of a garment. The wish reader is less easily misled, so what it has read is said again.
"""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain
from swifttailor.wording.captions import write_claims
from swifttailor.wording.claim_kinds import implied_kind


def in_own_words(wishes: Sequence[Change], seed: int = 0) -> str:
    """Writes a text that asks for the same; empty if there is nothing to say.

    Args:
        wishes: Of a description.
        seed: Decides the words.
    """
    claims = [wish.claim for wish in wishes if isinstance(wish, Gain)]
    if not claims:
        return ""
    if all(claim.name != "kind" for claim in claims):
        claims += [Claim("kind", kind) for kind in implied_kind(claims)]
    return write_claims(claims, seed).text
