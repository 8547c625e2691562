"""An apron that is named behind a skirt is put on it, and is no garment of its own."""

from __future__ import annotations

import re

_APRON = re.compile(
    r"(?<!\w)(?P<skirt>skirt|dress|gown)(?: and| \+| &|,(?: and)?| plus) (?:an? |the |her )?(?:\w+ )?apron"
    r"(?= *(?:$|[.;]))",
    re.IGNORECASE,
)


def with_apron_put_on(text: str) -> str:
    """The text, in which "a blouse, a skirt and an apron" are a blouse and a skirt with one in front.

    Args:
        text: As it was given.
    """
    return _APRON.sub(r"\g<skirt> with an apron front", text)
