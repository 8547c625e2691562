"""What sounds like the wearer and is not: a daughter's wedding, petite flowers, the chest of a shirt."""

from __future__ import annotations

import re
from dataclasses import dataclass

_FIRST = 0xE000
"""Of the letters that stand for hidden words; texts of people have none of these."""
_OTHERS = r"(?:(?:grand)?(?:daughter|son|child(?:ren)?)|kid|girl|boy)"
_EVENTS = (
    r"weddings?|graduation|birthday|part(?:y|ies)|christening|baptism|prom|play|school|concert|marriage"
    r"|engagement|recital|match|night|day|weekend|trip|choir|room|game|communion|bar mitzvah|bat mitzvah"
)
_DETAILS = (
    r"collars?|sleeves?|flowers?|floral|prints?|bows?|ruffles?|frills?|pockets?|buttons?|hems?|seams?|neck(?:line)?s?"
    r"|lines?|hoods?|cuffs?|straps?|dots?|spots?|checks?|stripes?|patterns?|details?|shapes?|edges?|waistbands?"
)
_YOUNG = (
    r"(?<!\w)(?:\d{1,2}(?! ?cm)|aged?|ages|years?|yrs?|twins?|kids?|child\w*|little|toddlers?|class"
    r"|pupils?)(?!\w)"
)
_HIDDEN = tuple(
    [
        re.compile(pattern, re.IGNORECASE)
        for pattern in (
            rf"(?<![\w-]){_OTHERS}(?:'?s'?|s')? (?:\w+ )?(?:{_EVENTS})(?!\w)",
            rf"(?<![\w-]){_OTHERS}s? (?:gets?|is getting|are getting|getting|marr(?:y|ies)|graduates?)(?!\w)",
            rf"(?<![\w-])(?:my|our|her|his|the) {_OTHERS}s? (?:always |keeps? |just )?(?:says?|said|saying"
            r"|thinks?|thought|reckons?|wants? me|would like me|tells? me|told me|suggest\w*|insists?|picked"
            r"|chose|recommend\w*)(?!\w)",
            r"(?<![\w-])(?:principal|lead|altar|ball|cow) ?boys?(?!\w)(?! (?:aged?|of|size))",
            r"(?<![\w-])(?:with|after) (?:the |my |our )?(?:\w+ )?(?:toddlers?|kids|children|babies)"
            r"(?![\w'’-])",
            rf"(?<![\w-]){_OTHERS} (?:shorts?|boss|energy|power|next door|band|scout leader)(?!\w)",
            r"(?<![\w-])(?:mean|spice|gossip|golden|gilmore|clean|vsco|cottage|that|e|it|bond|calendar"
            r"|pin[- ]?up|riot|surfer|skater|valley|material|rich|cool)"
            r" ?(?:girls?|boys?)(?='?s?(?!\w))(?! (?:aged?|of|size))",
            r"(?<![\w-])(?:baby|toddler|child|kid|infant|little one)s? (?:on|at|in|under|strapped to)"
            r" (?:my|her|the) (?:hips?|arms?|back|chest|lap|shoulders?|breast)(?!\w)",
            # Who is spoken of so, and not as one's own or by an age, is grown: colleagues, a band, friends.
            rf"(?<![\w-])(?:the|all the) (?:girls|boys|lads)(?!\w)(?![^.;]*?{_YOUNG})",
            r"(?<![\w-])(?:land|factory|shop|call|dream|cover|career|party|city) ?girls?(?!\w)",
            r"(?<!\w)(?:une?|la|le|ma|mon|cette|ce) petite?(?!\w)",
            rf"(?<![\w-])(?:the|that|this) {_OTHERS}s? (?:in|from|on|of|with)(?!\w)",
            rf"(?<![\w-])(?:petite|curvy|plus[- ]sized?|XXS|XS|XL|XXL|2XL) (?:{_DETAILS})(?!\w)",
            r"(?<![\w-])size \d{1,3} (?:buttons?|needles?|hooks?|zips?|snaps?|yarn|thread)(?!\w)",
            r"(?<![\w-])(?:magical|anime|manga|flapper|Gibson|chorus|saloon|cigarette|goth|emo|punk|farm|disco"
            r"|jazz|go-?go|show|dancing|harem|slave|pop) ?girls?(?='?s?(?!\w))(?! (?:aged?|of|size))",
            r"(?<![\w-])(?:like|as|as if) (?:(?:it|they) (?:is|are|was|were) )?(?:for|from|on) (?:the |an? )?"
            r"(?:boys?|girls?|children|kids?)(?!\w)",
            r"(?<![\w-])(?:give|for|of|with|to|lets?|help|make|send|show|both|all|like) us(?!\w)(?! size)",
        )
    ]
)
_GIRTH = (
    r"(?:(?P<first>\d{2,3}(?:\.\d)?)\s*(?:cm\s+)?(?P<name>chest|bust)"
    r"|(?P<name2>chest|bust)(?:\s+(?:circumference|girth|width))?\s*(?:of|is|:|=|-)?\s*(?P<second>\d{2,3}(?:\.\d)?))"
)
_CHEST = re.compile(rf"(?<![\w-]){_GIRTH}(?P<unit>\s*cm)?(?!\w)", re.IGNORECASE)
_OF_THE_GARMENT = re.compile(
    r"(?<!\w)(?:finished|garment measure\w*|measures? of the garment|laid flat|made[- ]up)(?!\w)",
    re.IGNORECASE,
)
_OTHER_MEASURES = re.compile(
    r"(?<!\w)(?:(?:body |back |total |full |sleeves?|shoulder|hem|sweep|cuffs?) ?)?"
    r"(?:length|sleeves?|shoulder|hem|sweep|cuffs?|width)\s*(?:of|is|:|=|-)?\s*\d{1,3}(?!\d)"
    r"|(?<![\w.])\d{1,3} ?(?:cm )?(?:length|long|sleeves?|shoulder|cuffs?)(?!\w)",
    re.IGNORECASE,
)
_OTHER_GIRTHS = re.compile(r"(?<!\w)(?:waist|hips?)\s*(?:of|is|:|=|-)?\s*\d{2,3}(?!\d)", re.IGNORECASE)
_SOMEBODY = re.compile(
    r"(?<!\w)(?:i am|i'm|my|s?he is|s?he's|her|his|for an?|who has|client|customer|wearer|body|size)(?!\w)",
    re.IGNORECASE,
)


@dataclass(frozen=True)
class HiddenWords:
    """A text with words hidden that are not about who wears it."""

    text: str
    words: tuple[str, ...]

    def shown(self, text: str) -> str:
        """A text with the words in their places again."""
        for k, word in enumerate(self.words):
            text = text.replace(chr(_FIRST + k), word)
        return text


def hide_others(text: str) -> HiddenWords:
    """Hides what names others than the wearer, or sizes of other things than the wearer."""
    words: list[str] = []

    def hidden(match: re.Match[str]) -> str:
        words.append(match[0])
        return chr(_FIRST + len(words) - 1)

    for pattern in _HIDDEN:
        text = pattern.sub(hidden, text)
    return HiddenWords(text, tuple(words))


def with_finished_chest(text: str) -> str:
    """A description in which the chest of the garment is called so, where a figure is meant of it.

    It is where the text calls measures finished, and among other measures of the garment, unless somebody is
    spoken of, or the girths of a body are given together.
    """
    match = _CHEST.search(text)
    if match is None:
        return text
    finished = _OF_THE_GARMENT.search(text) is not None
    listed = _OTHER_MEASURES.search(text) is not None and _OTHER_GIRTHS.search(text) is None
    if not finished and (not listed or _SOMEBODY.search(text) is not None):
        return text
    figure = match["first"] or match["second"]
    before = _OF_THE_GARMENT.sub("", text[: match.start()]) if finished else text[: match.start()]
    behind = re.sub(r"^\s*finished(?!\w)", "", text[match.end() :], flags=re.IGNORECASE)
    return f"{before.rstrip()} finished chest {figure} cm{behind}".strip()
