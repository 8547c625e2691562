"""What an instruction says of a garment as a whole: its halves and sides, where it sits, what covers it."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain
from swifttailor.wishes.instructions.change_words import ChangeWord
from swifttailor.wishes.text.spoken_sides import one_sleeve

_IsSo = Callable[[Claim], bool]
_LOWER = frozenset({"skirt", "trousers", "shorts"})
_OF_TWO = frozenset({"dress", "jumpsuit", "playsuit"})

_PAIR = (
    r"(?:both|two|either|each)?\s?(?:of )?(?:the |my )?"
    r"(?:sleeves?|sides?|shoulders?|halves|arms?|legs?|straps?)"
)
_ALIKE = re.compile(
    r"(?<!\w)(?:left|right) (?:sleeve|arm|side) as (?:long|short|wide|full) as(?!\w)|"
    rf"(?<!\w)(?:{_PAIR}[^.,;]{{0,20}} (?:the same|match|matching|alike|equal|identical|even)"
    rf"|(?:matching|identical|equal|even|same) {_PAIR}"
    r"|lopsided|lop-sided|symmetric|symmetrical|even (?:it|them) (?:out|up)|mirror (?:it|the)"
    r"|beide (?:seiten|ärmel)|gleich lang|symmetrisch|symétrique|simétric[oa]|simmetric[oa]"
    r"|even lang)(?!\w)"
)
_SECOND = re.compile(
    r"(?<!\w)(?:both|two|the missing|the other|the second|a second|another|a matching) (?:\w+ )?"
    r"(?:sleeves?|arms?)(?!\w)"
    r"|(?<!\w)sleeves? on (?:both sides|both arms|the other (?:side|arm))(?!\w)"
)
"""Of what has one sleeve: that it is to have two."""
_ONE_SLEEVE = (Claim("sleeves", "left only"), Claim("sleeves", "right only"))
_REMOVED = re.compile(r"(?<!\w)(?:no|not|without|lose|remove|ditch|off|rid)(?!\w)")
_LEVEL = re.compile(
    r"(?<!\w)(?:straighten|level|even)(?: out| up| off)? (?:the|my|this) (?:hem|hemline|bottom)(?!\w)"
    r"|(?<!\w)(?:hem|hemline|bottom)(?: (?:to be|is|all))? (?:level|straight|even)(?!\w)"
    r"|(?<!\w)(?:level|even|straight) hem(?:line)?(?!\w)"
)
_SIDE = r"(?:the |my |her )?(?P<side>left|right)"
_NO_SLEEVE = re.compile(
    rf"(?<!\w)(?:remove|lose|ditch|take off|get rid of|without|no|off with|cut off|chop off|rip off)"
    rf" {_SIDE} (?:sleeve|arm)(?!s|\w| \w*er| (?:at|to|by)(?!\w))"
    rf"|(?<!\w)(?:drop|cut|take|leave) (?:the |my |her )?(?P<other>left|right) sleeve"
    r" (?:off|out|away|altogether|entirely|completely)(?!\w)"
    r"|(?<!\w)(?P<gone>left|right) (?:sleeve|arm) (?:off|gone|away|can go|should go|has to go)(?!\w)"
)
_BARED = re.compile(
    rf"(?<!\w)(?:bare|expose|uncover|show) {_SIDE} shoulder(?!\w)"
    r"|(?<!\w)(?:take|leave|drop|cut|have) (?:the |my |her )?(?P<other>left|right) shoulder"
    r" (?:off|out|away|bare|free|open)(?!\w)"
)
_COVERED = re.compile(
    r"(?<!\w)(?:cover\w*|second|both|other|two|add|adding|needs?|want|with|put|sew|give|had|has|have)(?!\w)"
    r"[^.,;]{0,30}(?<!\w)(?:shoulders?|straps?|träger|bretelles?|tirantes)(?!\w)"
)
_BARE = tuple(Claim("shoulders", value) for value in ("bare left", "bare right", "strapless"))
_ONLY = re.compile(
    r"^\W*(?:(?:please|so|maybe|can i have|could i have|i'd like|i would like|actually)\s+)*"
    r"(?:i (?:only|just) (?:want|need)|only|just|nothing but|keep only|only keep|nur|seulement|solo)\s+"
    r"(?:the |its |das |den |die |le |la |el )?"
    r"(?:(?P<top>top|upper|bodice|oberteil|haut)|(?P<skirt>skirt|rock|jupe|falda)"
    r"|(?P<lower>bottom|lower|trousers?|pants|shorts|hose|pantalon))"
    r"(?:\s+(?:half|part|bit|section|piece))?"
    r"(?:\s+(?:of|from) (?:this|it|the \w+|that))?(?=\W*$|,|\s+(?:as|please|on its own)(?!\w))"
)
_SITS = re.compile(
    r"(?<!\w)(?:sit|sits|sitting|rise|waist|waistline|sitzen|sitzt|leibhöhe|taille|vita|cós|cintura|talle|tiro)(?!\w)"
)
_WAIST_TO = r"(?<!\w)waist\w*[^.,;]*(?<!\w)"
_HIP = re.compile(rf"{_WAIST_TO}(?:to|at|on|onto|around)\s+(?:the |my |her )?(?:low )?hips?(?!\w)")
_BUST = re.compile(
    rf"{_WAIST_TO}(?:under|below|beneath|underneath|to)\s+(?:the |my |her )?(?:bust|breasts?)(?!\w)"
)
_NATURAL = re.compile(
    rf"{_WAIST_TO}(?:where (?:my|the|her) (?:\w+ )?waist"
    r"|(?:to|at|on) (?:the |my |her )?(?:natural|real|actual|own) waist|natural)"
)
_NO_DARTS = re.compile(
    r"(?<!\w)(?:no|without|lose|remove|ditch|drop|let|take|get rid of|undo|unpick|skip|ohne|sans|sin|senza"
    r"|zonder|sem)(?!\w)"
    r"[^.,;]{0,25}(?<!\w)(?:darts?|abnäher|pinces|pinzas|figuurnaden|coupenaden|pences)(?!\w)"
)

_HALVES = {
    "skirt": r"skirt|rock|jupe|falda",
    "trousers": r"trousers|pants|trouser legs|legs|hose|pantalon|pantalón",
    "shorts": r"shorts",
}
_SHAPES = ("pencil", "circle", "a-line", "gathered", "straight")
_NAMES = "|".join(_HALVES.values())
_A = r"(?:(?:the|its|a|an|some|my|wide|narrow|long|short|full|slim|pencil|circle|a-line|gathered|straight) )*"
_OTHER_HALF = (
    re.compile(
        rf"(?<!\w)(?P<new>{_NAMES})(?: \w+){{0,2}} "
        rf"(?:instead of|in place of|rather than|not|statt|au lieu de) {_A}(?P<old>{_NAMES})(?!\w)"
    ),
    re.compile(
        rf"(?<!\w)(?:no|not|lose the|without) (?P<old>{_NAMES}),? (?:just |only |but |make it |give me )*"
        rf"(?:an? )?{_A}(?P<new>{_NAMES})(?!\w)"
    ),
    re.compile(
        rf"(?<!\w)(?:swap|swop|replace|exchange|change|switch|turn|make) {_A}(?P<old>{_NAMES})"
        rf" (?:(?:for|with|by|to|into) )?{_A}(?P<new>{_NAMES})(?!\w)"
    ),
    re.compile(rf"(?<!\w)(?P<old>{_NAMES}) ?(?:->|=>|→) ?{_A}(?P<new>{_NAMES})(?!\w)"),
    re.compile(
        rf"(?<!\w)(?:instead of|in place of|rather than|remove|lose|drop|ditch) {_A}(?P<old>{_NAMES}),?"
        r" (?:(?:i want|i'd like|i'd prefer|can i have|could i have|give me|have|put(?: on)?|add|use) )?"
        rf"{_A}(?P<new>{_NAMES})(?!\w)"
    ),
)
"""One lower half for another: trousers for the skirt of a dress."""
_GIVEN = re.compile(
    r"(?<!\w)(?:with|add|adding|give it|gets?|needs?|wants?|put|sew|have|mit|avec|con|met|com)(?: on| in)?"
    r"(?: some| a| an| any| proper| the)?"
    r"(?: (?:little|small|thin|narrow|slim|wide|deep|broad|thick|high|plain|simple|nice|proper|short))?"
    r"\s(?:(?P<sleeves>sleeves?|ärmeln?|manches|mangas|maniche|mouwen)"
    r"|(?:waist ?band|bund|ceinture|pretina"
    r"|band (?:at|around|round|along|to|for|on) (?:the |my |its )?(?:waist|top))"
    r")(?!\w)"
)
_SOME = re.compile(r"(?<!\w)(?:some|a (?:bit|touch|hint|suggestion|little) of(?: a)?|any) sleeves?(?!\w)")
"""Asked of what has none: "a bit of sleeve"."""
_COLLAR = re.compile(r"(?<!\w)(?:an?|some|any|with|add|needs?|wants?) (?:\w+ )?collar(?!\w)|^\W*collar\W*$")
_SLEEVES_ALONE = re.compile(
    r"\W*(?:(?:but|and|with|i|want|please|yes|ok|with) )*sleeves?(?: (?:please|though))?\W*"
)
_NARROW, _WIDE = (
    re.compile(r"(?<!\w)(?:narrow|thin|slim)(?!\w)"),
    re.compile(r"(?<!\w)(?:wide|deep|broad|high|thick)(?!\w)"),
)


def of_wholes(said: str, grown: Sequence[ChangeWord], kind: str, is_so: _IsSo) -> tuple[Change, ...]:
    """What a clause asks of the whole garment; nothing where it does not.

    Args:
        said: The clause, in lower case.
        grown: Words of change in it.
        kind: Of the garment.
        is_so: Whether a claim is true of it.
    """
    if is_so(Claim("sides", "different")) and _ALIKE.search(said):
        return (Gain(Claim("sides", "alike")),)
    if any(map(is_so, _ONE_SLEEVE)) and not grown and _SECOND.search(said) and not _REMOVED.search(said):
        return (Gain(Claim("sides", "alike")),)
    if _LEVEL.search(said) and not is_so(Claim("hem_shape", "level")):
        return (Gain(Claim("hem_shape", "level")),)
    if kind not in _LOWER and (one := _one_side(said, grown, is_so)) is not None:
        return (one,)
    if any(map(is_so, _BARE)) and _COVERED.search(said):
        return (Gain(Claim("shoulders", "both")),)
    if is_so(Claim("bodice", "darted")) and _NO_DARTS.search(said):
        return (Gain(Claim("bodice", "undarted")),)
    if kind in _OF_TWO:
        return _other_half(said, kind) or _half(said, kind) or _seam(said)
    sign = next((word.sign for word in grown if word.what == "height"), 0)
    return _rise(sign, is_so) if kind in _LOWER and sign and _SITS.search(said) else ()


def _one_side(said: str, grown: Sequence[ChangeWord], is_so: _IsSo) -> Change | None:
    """A sleeve that goes or is to be longer or shorter, or a shoulder that is bared, on one side."""
    sign = next((word.sign for word in grown if word.what == "length"), 0)
    if sign and (sleeve := one_sleeve(said, sign, is_so)) is not None:
        return Gain(sleeve)
    for pattern in (_NO_SLEEVE, _BARED):
        if (found := pattern.search(said)) is not None:
            side = next(found[name] for name in found.re.groupindex if found[name])
            if pattern is _BARED:
                return Gain(Claim("shoulders", f"bare {side}"))
            return Gain(Claim("sleeves", f"{'left' if side == 'right' else 'right'} only"))
    return None


def lacking(said: str, is_so: _IsSo) -> tuple[Change, ...]:
    """Parts that a garment lacks and is to have, without a word of what they are like: "with sleeves"."""
    found = _GIVEN.search(said)
    if found is None:
        if _COLLAR.search(said) and is_so(Claim("collar", "none")):
            return (Gain(Claim("collar", "stand")),)
        some = _SOME.search(said) or _SLEEVES_ALONE.fullmatch(said)
        return (Gain(Claim("sleeves", "short")),) if some and is_so(Claim("sleeves", "none")) else ()
    without, made = ("sleeves", "short") if found["sleeves"] else ("waistband", "waist")
    if not is_so(Claim(without, "none")):
        return ()
    how = "narrow" if _NARROW.search(found[0]) else "wide" if _WIDE.search(found[0]) else ""
    more = (Gain(Claim("waistband", how)),) if how and without == "waistband" else ()
    return (Gain(Claim(without, made)), *more)


def _other_half(said: str, kind: str) -> tuple[Change, ...]:
    """Legs for the skirt of a dress, or a skirt for the legs: "trousers instead of the skirt"."""
    found = next((found for pattern in _OTHER_HALF if (found := pattern.search(said))), None)
    if found is None:
        return ()
    old, new = (
        next((name for name, words in _HALVES.items() if re.fullmatch(words, found[side])), None)
        for side in ("old", "new")
    )
    mine = {"dress": "skirt", "jumpsuit": "trousers", "playsuit": "shorts"}[kind]
    if old != mine or new in (None, mine):
        return ()
    made = {"skirt": "dress", "trousers": "jumpsuit", "shorts": "playsuit"}[str(new)]
    shapes = [name for name in _SHAPES if re.search(rf"(?<!\w){name.replace('-', '[- ]')}(?!\w)", said)]
    shape = [Gain(Claim("skirt", name)) for name in shapes[:1] if new == "skirt"]
    return (Gain(Claim("kind", made)), *shape)


def _half(said: str, kind: str) -> tuple[Change, ...]:
    only = _ONLY.search(said)
    if only is None:
        return ()
    if only["top"]:
        return (Gain(Claim("kind", "top")),)
    if only["skirt"] and kind != "dress":
        return ()
    lower = {"dress": "skirt", "jumpsuit": "trousers", "playsuit": "shorts"}
    return (Gain(Claim("kind", lower[kind])),)


def _seam(said: str) -> tuple[Change, ...]:
    for pattern, value in ((_HIP, "dropped"), (_BUST, "empire"), (_NATURAL, "natural")):
        if pattern.search(said):
            return (Gain(Claim("waist_seam", value)),)
    return ()


def _rise(sign: int, is_so: _IsSo) -> tuple[Change, ...]:
    """One step of the scale up or down; nothing at its ends."""
    scale = ("low", "mid", "high")
    now = next((k for k, value in enumerate(scale) if is_so(Claim("rise", value))), None)
    if now is None or not 0 <= now + sign < len(scale):
        return ()
    return (Gain(Claim("rise", scale[now + sign])),)
