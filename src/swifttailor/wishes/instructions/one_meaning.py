"""Words of instructions that say different things in different languages, as words that say one.

"Largo" is long in Spanish, and wide in Italian and Portuguese; "langer" is longer in Dutch, and long in
German. The tables of changes hold for all languages, so these words are replaced before they are looked up,
by English ones or by others of the tables.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from swifttailor.wording.lexicon.inflection import Language

_PLAIN: Mapping[Language, Mapping[str, str]] = {
    "it": {"largo": "ampio", "larga": "ampia", "larghi": "ampi", "larghe": "ampie"},
    "nl": {
        **{"langer": "longer", "te": "al te", "los": "ruim", "losse": "ruime"},
        **{"zoom": "hem", "hem": "het", "hals": "halslijn", "capuchon": "hood"},
    },
    "pt": {
        **{"largo": "amplo", "larga": "ampla", "largos": "amplos", "largas": "amplas"},
        **{"alarga": "allarga", "alargar": "allarga", "alargue": "allarga"},
    },
}


def in_one_meaning(text: str, language: Language) -> str:
    """A text with such words replaced.

    Args:
        text: An instruction in lower case.
        language: That it is in.
    """
    plain = _PLAIN.get(language)
    if plain is None:
        return text
    return re.sub(rf"(?<!\w)(?:{'|'.join(plain)})(?!\w)", lambda found: plain[found[0]], text)


def still_in(language: Language) -> Language | None:
    """The language of a text in which words may have been replaced; None where it can be found out again."""
    return language if language in _PLAIN else None
