"""Changes written down briefly, as people give them to `alter`: ``sleeves=long``, ``length +10``."""

from __future__ import annotations

import re

from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.describing.differences import Change, Gain, Step
from swifttailor.errors import InputError

_STEP = re.compile(r"(?P<quantity>[^=+-]+?)\s*(?P<sign>[+-])\s*(?P<amount>\d+(\.\d+)?)?")
_ACCEPTED = "'claim=value' such as 'sleeves=long', or 'quantity +' or 'quantity -8' such as 'length +10'"


def read_change(wanted: Change | Claim | str) -> Change:
    """What is wanted of a garment, as `alter` needs it.

    Args:
        wanted: A change; a claim that is to hold; or one of these as text: ``claim=value``, with a name of
            `CLAIM_TYPES` and a word or a number, or ``quantity +``, ``quantity -``, ``quantity +10`` (cm,
            pieces or a ratio), with a name of `QUANTITIES`.

    Raises:
        InputError: The text is neither, or a name or value is not known.
    """
    if isinstance(wanted, Gain | Step):
        return wanted
    if isinstance(wanted, Claim):
        return Gain(wanted)
    name, equals, value = (part.strip() for part in wanted.partition("="))
    if equals:
        kind = CLAIM_TYPES.get(name)
        return Gain(Claim(name, value if kind is None or kind.words else _number(value, wanted)))
    step = _STEP.fullmatch(wanted.strip())
    if step is None:
        raise InputError(f"'{wanted}' is no change of a garment. Accepted: {_ACCEPTED}.")
    amount = step["amount"]
    return Step(step["quantity"], 1 if step["sign"] == "+" else -1, None if amount is None else float(amount))


def _number(value: str, text: str) -> float:
    try:
        return float(value)
    except ValueError:
        raise InputError(f"'{text}': a number is expected after '=', received '{value}'.") from None
