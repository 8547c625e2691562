"""Remarks about other garments that are worn with the one that is asked for: "to throw over a strappy dress".

They say nothing of its cut, and a network takes their garment for the one that is meant. So they are left out
where another garment is named beside them.
"""

from __future__ import annotations

import re

from swifttailor.wording.lexicon import read_words

_HEAD = (
    r"(?:dress(?:es)?|gowns?|frocks?|skirts?|minis?|tops?|t-?shirts?|tees?|shirts?|blouses?|jumpers?|sweaters?"
    r"|pullovers?|sweatshirts?|hoodies?|cardigans?|cardis?|vests?|waistcoats?|jackets?|blazers?|coats?|suits?"
    r"|trousers|pants|slacks|chinos|jeans|leggings|tights|joggers|shorts|culottes|jumpsuits?|playsuits?"
    r"|dungarees|overalls|pinafores?|swimsuits?|swimming costumes?|bikinis?|bodysuits?|leotards?|uniforms?"
    r"|saris?|sarees?|kilts?|tunics?|camis?|camisoles?|bras?|slips?|petticoats?|pyjamas|pajamas|nighties?"
    r"|robes?|nightdress(?:es)?|overcoats?|raincoats?|gilets?|turtlenecks?|polo necks?|roll ?necks?|bodices?)"
)
_NOT_ALONE = (
    rf"(?![\w-]|[ -](?:{_HEAD}|collars?|sleeves?|necks?|necklines?|length|style|cuffs?|straps)(?!\w))"
)
_WORDS_BEFORE = r"(?:[\w'’-]+ ){0,4}?"
_OVER = r"(?:over|on top of|under|underneath|beneath|below|inside|with|w|w/)"
_OWN = (
    r"(?: (?:that |which )?(?:i|she|he|we)(?:['’]ve)? (?:already |just )?"
    r"(?:own|have|has|got|bought|wear|am wearing)(?: already| got| on)?)?"
)
_WORN = (
    r"(?:throw|throwing|thrown|wear|wearing|worn|put|putting|slip|slipping|slipped|layer|layering|layered|pop"
    r"|fling|chuck|sling|drape|pull|pulled|go|goes|going|pair|pairs|pairing|paired|team|teams|teamed|style"
    r"|styled|match|matches|fit|fits|sit|sits|look|looks|looking)"
)
_LEADING = (
    r"(?:(?<![\w-])(?:that|which|and|so|im|i['’]?m|i|she|he|we|it|they|is|was|am|are|can|could|will|would|may"
    r"|want|wants|like|need|should|must|to|for|be|['’]ll)(?!\w)\s*)*"
)
_IT_NICELY = (
    r"(?: (?:it|them|this))?(?: (?:on|up|nicely|well|best|straight|loosely|easily"
    r"|ok|okay|good|nice|right|fine|smart|open))*"
)
_REMARKS = (
    re.compile(
        rf",?\s*{_LEADING}(?<![\w-]){_WORN}{_IT_NICELY} {_OVER} {_WORDS_BEFORE}{_HEAD}{_NOT_ALONE}{_OWN}",
        re.IGNORECASE,
    ),
    re.compile(
        r",?\s*(?<![\w-])for (?:(?:wearing|putting|layering|going|on|use)\s)?(?:over|on top of|under|"
        rf"underneath|beneath|inside) {_WORDS_BEFORE}{_HEAD}{_NOT_ALONE}{_OWN}",
        re.IGNORECASE,
    ),
    re.compile(
        r"\s*(?<![\w-])(?:over|on top of|under|underneath|beneath|inside|below|above|past|with) "
        rf"(?:my|her|his|their) {_WORDS_BEFORE}{_HEAD}{_NOT_ALONE}{_OWN}",
        re.IGNORECASE,
    ),
)
_NOUN = re.compile(r"\s*(?:fit|style|layer|drape|slip|wear|match)\s+with(?!\w)", re.IGNORECASE)
"""What is no verb behind another word: "slim fit with a turtleneck"."""
_OWNED = (
    re.compile(
        rf",?\s*(?<![\w-])(?:and |but |as |because |since )?(?:the|my|his|her) {_WORDS_BEFORE}{_HEAD} "
        r"(?:that |which )?(?:i|we|he|she)(?:['’]ve)? (?:already |just )?(?:have|own|got|bought|has)(?!\w)"
        r"(?: (?:already|got))?(?: (?:is|are|was|in)(?!\w)[^.,;]*)?",
        re.IGNORECASE,
    ),
    re.compile(
        r"(?<![\w-])(?:i|we|he|she)(?:['’]ve)? (?:already )(?:have|own|got|bought|has)(?: got)? "
        rf"(?:the|an?|my|that|this) {_WORDS_BEFORE}{_HEAD}{_NOT_ALONE}(?:,? (?:so|and|but|just)(?!\w))*,?\s*",
        re.IGNORECASE,
    ),
)
"""Garments that are there: "the jacket I have is grey", "I already have the jacket"."""
_PLACE_ON = re.compile(
    r"(?:(?<=cover )|(?<=covers )|(?<=over )|(?<=below )|(?<=past )|(?<=above )|(?<=reach )|(?<=hide ))"
    rf"(?:the )?(?:waistband|waist|hem|top|collar|sleeves|bottom|straps|neckline|back|seat) of "
    rf"(?:my|her|his|their) (?:[\w'’-]+ ){{0,2}}?{_HEAD}{_NOT_ALONE}",
    re.IGNORECASE,
)
"""A place on a garment that is there already: "long enough to cover the waistband of my leggings"."""


_BLANKS = re.compile(r"(\s)\s+")
"""Blanks in a row, which patterns would try at every one of them."""


def without_side_remarks(text: str) -> str:
    """The text without them, where it names another garment as well.

    Args:
        text: A description in any case.
    """
    text = _BLANKS.sub(r"\1", text)
    for pattern in (*_REMARKS, *_OWNED, _PLACE_ON):
        for found in reversed(list(pattern.finditer(text))):
            if _NOUN.match(found[0]) and text[: found.start()].rstrip()[-1:].isalnum():
                continue
            put = " it" if pattern is _PLACE_ON else ""
            rest = (text[: found.start()].rstrip() + put + text[found.end() :]).strip()
            if _names_a_garment(text[: found.start()]) or _names_a_garment(rest) or pattern is _PLACE_ON:
                text = rest
    return text


def _names_a_garment(text: str) -> bool:
    return any(mark.role == "garment" and not mark.denied for mark in read_words(text).marks)
