"""What texts tell of other clothes than the one wished for: complaints, and what others wear or advise.

"Every dress I try on rides up", "my old jacket makes me look like a sack", "everyone is getting a corset".
Their words say nothing of the cut, so they are left out where a wish is left without them.
"""

from __future__ import annotations

import re

from swifttailor.wording.lexicon import read_words

_I = r"(?:i|she|he|we|you)(?:['’](?:ve|d))?(?: have| had)?"
_OWNED = (
    r"(?:ever |already |just |currently |usually |once |normally )*"
    r"(?:own(?:ed)?|buy|bought|buying|tried|try|have|has|had|wear|wore|worn|see|saw|seen|find|found|get|got"
    r"|order(?:ed)?|put|come across|pick up)(?: on| up)?"
    r"(?: anywhere| in (?:the )?shops?| so far| online| already)?"
)
_ALL = (
    rf"(?:(?:everything|anything|all)(?: that)? {_I} {_OWNED}"
    r"|(?:every|each|any|all (?:of )?the|the only|most) (?:single |other |pairs? of |of the )*"
    rf"(?:[\w’'-]+ ){{0,3}}?(?:(?:that|which) )?{_I} {_OWNED}"
    r"|everything(?! (?:from|else|about|should|must|to|for)(?!\w))"
    r"(?: in the shops?| out there| these days)?)"
)
_SOLD = (
    r"(?:(?:in the (?:shops?|stores?|high street)|on the high street|out there|online|on sale|these days"
    r"|nowadays|this (?:year|season|summer|spring|autumn|winter)|at the moment"
    r"|right now|you (?:see|find|get|can buy)|they (?:sell|make|have)|for sale)(?: |,)*)+"
)
_OFFERED = (
    rf"(?:(?:every|each|all (?:of )?the|all|most|half the) (?:[\w’'-]+ ){{1,3}}?{_SOLD}"
    r"(?:(?:is|are|seems?|always|either|just|only|to|comes?|all) )*"
    r"(?:has|have|had|with|got|wants?|needs?|is|are|an?|so|too|made|cut|full|covered)(?!\w)"
    r"|(?:everything|all) (?:in (?:the )?(?:shops?|stores?)|out there|on sale|they sell"
    r"|this (?:year|season)) "
    r"(?:has|have|is|comes|seems)(?!\w))"
)
"""What shops have: "every dress in the shops this year has a frill on it"."""
_WRONG = (
    r"(?:(?:is|are|was|were|seems?|always|either|just|only|sort of|ends? up|ended up|keeps?) )*"
    r"(?:an?|like|looks?|looked|looking|makes?|made|feels?|felt|rid(?:es|e|ing|den)|rode|gapes?|gaping|digs?"
    r"|dug|cuts? (?:in|me)|itch\w*|clings?|clung|wraps?|rolls? (?:up|down)|twists?|bunch\w*|pulls?|strains?"
    r"|shows?|drags?|trails?|flaps?|hangs?|falls? (?:off|down|apart)|slips?|slid\w*|shr[ai]nks?|shrunk"
    r"|wore out|has (?:had it|shrunk|gone)|swallows?|drowns?|swamps?|stops?|comes up|came up|bags?|sags?)"
    r"(?!\w)"
)
_NO_WISH = r"(?!(?:[^.;!?]*?)(?<!\w)too (?:short|long|tight|loose|wide|narrow|low|high|big|small)(?!\w))"
"""What is too short tells how long the wish is to be."""
_STOP = r"(?!,? (?:so|but|and i|i['’]d|i want|i need|can i|could)(?!\w)|,? (?:please|something)(?!\w))"
_TO_END = rf"(?:{_STOP}[^.;,!?])*(?:,? (?:(?:and|or|it|they) )+{_WRONG}(?:{_STOP}[^.;,!?])*)*"
_JOINT = (
    r"[\s,.;!?–—-]*"
    r"(?:(?<!\w)(?:so|but|and|hence|therefore|that['’]s why|which is why)(?!\w)[\s,]*)*"
)
_KIN = (
    r"(?:mum|mom|mam|mother|dad|father|sister|brother|daughter|son|husband|wife|boyfriend|girlfriend|partner"
    r"|friends?|aunt(?:ie|y)?|nan|gran(?:ny|dma|dmother)?|mother-in-law|boss|colleagues?|teacher|doctor"
    r"|physio|stylist)"
)
_THEM = (
    r"(?:every(?:one|body)(?: else)?|all (?:of )?(?:the |my )?(?:other )?(?:girls|women|ladies|mums|moms|men"
    r"|boys|guests|bridesmaids|friends|colleagues)|(?:the )?other (?:people|girls|women|mums|moms|men|guests"
    r"|bridesmaids)|the others|most people|people)"
)
_WEARS = (
    r"(?:(?:is|are|will be|['’]s|['’]re|always|just|will|usually|all|seems to be|seem to be) )*"
    r"(?:wear(?:s|ing)?|getting|gets?|having|has|have|in|goes? in|going in|comes? in|coming in|turns? up in"
    r"|lives? in|buying|bought|wore|got|had)(?!\w)"
)
_KIN_WEAR = r"(?:is |always |usually |just )*(?:wear(?:s|ing)?|lives? in|goes in)(?!\w)"
_AT = r"(?: (?:at|in|on|from|round|around) (?:[\w’'-]+ ?){1,3}?)?"
_SAYS = (
    r"(?:always |keeps? )?(?:says?|said|saying|thinks?|thought|reckons?|reckoned|suggest(?:s|ed)|insists?"
    r"|insisted|wants? me|wanted me|tells me|told me|telling me|would like me|prefers?)"
)
_NOUNS = r" [\w’'-]+(?: (?:dress(?:es)?|coats?|skirts?|tops?|trousers|jackets?|shirts?|jeans))?"
_OLD = (
    r"my (?:old|current|last|usual|other|present|existing|previous|shop-bought|favou?rite old)"
    rf"{_NOUNS} {_WRONG}"
)
_MINE = (
    rf"my{_NOUNS} (?:always |just |all )?(?:rid(?:es?|ing)|rode|gapes?|digs?|dug|itch\w*|clings?|makes? me"
    r"|shrank|shrunk|drags?|swamps? me|falls? off me)(?!\w)"
)
_ALL_MINE = (
    r"(?:all |most )(?:of )?my [\w’'-]+ (?:(?:are|is|were|either|just|only) )+"
    r"(?:either )?[^.;,!?]*?(?<!\w)(?:or|and) (?:far |way |much )?too [\w’'-]+"
)
_USUALLY = r"(?:(?:usually|normally|always|mostly|basically|just|practically|pretty much) )*"
_I_WEAR = (
    rf"i {_USUALLY}(?:live in|(?:am|['’]m) always in"
    r"|(?:(?:usually|normally|always|mostly|only ever) )+wear)(?!\w)"
)
_OF_OTHERS = re.compile(
    rf"(?<![\w-])(?:{_THEM}{_AT} {_WEARS}|(?:my|her|his|our) {_KIN} {_KIN_WEAR}){_TO_END}{_JOINT}",
    re.IGNORECASE,
)
_BUT = r"(?:but|yet|however|though|although|only)"
_PATTERNS = (
    re.compile(rf"(?<![\w-]){_OFFERED}{_NO_WISH}{_TO_END}{_JOINT}", re.IGNORECASE),
    re.compile(rf"(?<![\w-]){_ALL} (?:[\w’'-]+ ){{0,3}}?{_WRONG}{_NO_WISH}{_TO_END}{_JOINT}", re.IGNORECASE),
    _OF_OTHERS,
    re.compile(rf"(?<![\w-])(?:{_OLD}|{_MINE}){_NO_WISH}{_TO_END}{_JOINT}", re.IGNORECASE),
    re.compile(rf"(?<![\w-]){_I_WEAR}{_TO_END}{_JOINT}", re.IGNORECASE),
    re.compile(rf"(?<![\w-]){_ALL_MINE}(?!\w){_JOINT}", re.IGNORECASE),
    re.compile(
        rf"(?<![\w-])(?:my|our|her|his) {_KIN} {_SAYS} (?:that )?(?:i|she|he) (?:always |just |only )*"
        rf"looks?(?!\w)[^.;!?]*?[,.;!?]?\s*(?=so(?!\w)){_JOINT}",
        re.IGNORECASE,
    ),
    re.compile(
        rf"(?<![\w-])(?:my|our|her|his|the) {_KIN} {_SAYS}(?!\w)[^.;!?]*?[,.;!?]?\s*"
        rf"(?={_BUT}(?!\w)){_BUT}[\s,]*",
        re.IGNORECASE,
    ),
)
_HATED = re.compile(
    r"(?<!\w)(?:(?:and|but|which) )?i(?:['’]d)? (?:really |just |absolutely )?(?:hate|loathe|can['’]?t stand"
    r"|don['’]?t (?:want|like)|dislike|refuse|am sick of)(?: (?:it|them|that|those|to))?(?!\w)[\s,.;:–—-]*",
    re.IGNORECASE,
)
"""What is said of what the others wear: it does not belong to the wish behind it."""
_BEGINS = re.compile(
    r"(?:^|[.,;:!?()–—-]|(?<!\w)(?:and|but|because|since|as|so|now|that|where|when|while|right|ok(?:ay)?"
    r"|off duty|at home|at work|days|usually|normally|the moment|weekends?))\s*$",
    re.IGNORECASE,
)
"""What stands before a clause of its own: none is "the skirt everyone has", nor "like my father had"."""
_ALIKE = re.compile(
    r"(?<!\w)(?:same|similar|like (?:that|those|hers|his|theirs|it)|copy|match\w*"
    r"|(?:too|as well)(?=[.,;!?]|$))(?!\w)",
    re.IGNORECASE,
)
_ONE = re.compile(
    r"(?<!\w)(?:one|ones)(?= (?:please|that|which|with|in|to|for|where|whose)(?!\w)|[,.;!?]|$)",
    re.IGNORECASE,
)
_NAMED_FIRST = 5
"""Words among which a complaint names its garment: "all the skirts in the shops are mini"."""
_SOMETHING = re.compile(r"(?<!\w)(?:something|anything|one)(?!\w)", re.IGNORECASE)


def without_complaints(text: str) -> str:
    """The text without them, where it names a garment or "something" as well.

    "One" that stands for the garment of a complaint is called by its name: of "my coat drags, I want one with
    a hood" a coat is left. Where nothing else names it, so is the garment of the complaint itself.

    Args:
        text: A description in any case, in English.
    """
    for pattern in _PATTERNS:
        for found in reversed([f for f in pattern.finditer(text) if _BEGINS.search(text, 0, f.start())]):
            text = _without(text, found, of_others=pattern is _OF_OTHERS)
    return text


def _without(text: str, found: re.Match[str], *, of_others: bool) -> str:
    """The text without one of them; the text itself where no wish is left."""
    behind = text[found.end() :]
    wish = _HATED.sub("", behind, count=1) if _HATED.match(behind) else behind
    before = text[: found.start()].rstrip()
    rest = f"{before} {wish.lstrip()}".strip()
    if _ALIKE.search(rest):
        return text
    if _garment(rest) is not None:
        return rest
    what = _garment(" ".join(found[0].split()[:_NAMED_FIRST])) or _garment(found[0])
    if what is not None and _ONE.search(rest):
        return _ONE.sub(what, rest, count=1)
    if what is not None and not of_others:
        return f"{before} {what}, {wish.lstrip()}".strip()
    return rest if wish != behind and _SOMETHING.search(rest) else text


def _garment(text: str) -> str | None:
    """The garment that a text asks for; None where it names none."""
    marks = [m for m in read_words(text).marks if m.role in ("garment", "theirs", "second") and not m.denied]
    named = [m for m in marks if m.entries and m.entries[0].category == "garments"]
    return named[0].word if named else None
