"""What a photograph shows, in the words that somebody would use who asks for the same.

Of drawn pictures, whose garments are cut as those that the networks have learnt from, the very cut is read.
Of photographs little is but what words tell as well: a long-sleeved hooded top. So the garment is made from
these words, as any text's is.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType

from swifttailor.picture_reader.reading import PartReading
from swifttailor.picture_reader.worn_names import OUTER
from swifttailor.tailor.outer_words import outer_noun

_SURE, _RATHER = 0.5, 0.6
_SHORT, _OF_COATS = ("cap", "short", "elbow"), ("three-quarter", "long", "extra-long")
_SLEEVES: Mapping[str, str] = MappingProxyType(
    {
        "none": "sleeveless",
        "cap": "cap-sleeved",
        "short": "short-sleeved",
        "elbow": "elbow-length sleeves",
        "three-quarter": "three-quarter sleeves",
        "long": "long-sleeved",
        "extra-long": "long-sleeved",
    }
)
_NECKS: Mapping[str, str] = MappingProxyType(
    {"v": "V neck", "scoop": "scoop neck", "boat": "boat neck", "square": "square neck", "crew": "crew neck"}
)
_FITS: Mapping[str, str] = MappingProxyType({"close": "fitted", "loose": "loose", "oversized": "oversized"})
_TOP_HEMS: Mapping[str, str] = MappingProxyType(
    {"bra": "very short", "cropped": "cropped", "waist": "waist-length", "long": "long"}
)
_SKIRT_HEMS: Mapping[str, str] = MappingProxyType(
    {
        "micro": "micro mini",
        "mini": "mini",
        "above the knee": "above the knee",
        "knee": "knee-length",
        "below the knee": "below the knee",
        "midi": "midi",
        "maxi": "maxi",
        "ankle": "ankle-length",
        "floor": "floor-length",
    }
)
_LEG_HEMS: Mapping[str, str] = MappingProxyType(
    {
        "very short": "very short",
        "mid-thigh": "mid-thigh",
        "thigh": "thigh-length",
        "knee": "knee-length",
        "calf": "calf-length",
        "ankle": "ankle-length",
    }
)
_OF_SHORTS = ("very short", "mid-thigh", "thigh", "knee")
_LEGS: Mapping[str, str] = MappingProxyType(
    {"wide": "wide-leg", "tapered": "tapered", "slim": "slim", "flared": "flared"}
)
_SKIRTS: Mapping[str, str] = MappingProxyType(
    {
        "pencil": "pencil",
        "narrowing": "pencil",
        "straight": "straight",
        "a-line": "A-line",
        "flared": "flared",
        "half circle": "flared",
        "three-quarter circle": "full",
        "circle": "circle",
        "more than a circle": "circle",
        "gathered": "gathered",
        "tiered": "tiered",
    }
)
_CALLED: Mapping[str, tuple[str, frozenset[str]]] = MappingProxyType(
    {
        "Shirt": ("shirt", frozenset({"neckline"})),
        "Polo": ("polo shirt", frozenset({"neckline"})),
        "Blazer": ("blazer", frozenset({"neckline", "sleeves"})),
        "Hoodie": ("hoodie", frozenset({"neckline", "sleeves"})),
    }
)
"""What clothes are by what photographs of such are called, and which claims that says."""
_HEMS: Mapping[str, tuple[str, Mapping[str, str]]] = MappingProxyType(
    {
        "top": ("top_hem", _TOP_HEMS),
        "tunic": ("top_hem", _TOP_HEMS),
        "dress": ("skirt_hem", _SKIRT_HEMS),
        "jumpsuit": ("leg_hem", _LEG_HEMS),
        "playsuit": ("leg_hem", _LEG_HEMS),
    }
)
"""Of kinds of garments on the shoulders: the claim about the hem, and its words."""


def over_trousers(part: PartReading, worn: Iterable[PartReading]) -> bool:
    """Whether somebody wears trousers as well, beside a garment of all that they wear."""
    return any(
        other is not part and _likeliest(other).get("kind") in ("trousers", "shorts") for other in worn
    )


def in_words(
    part: PartReading,
    without: frozenset[str] = frozenset(),
    *,
    named: bool = False,
    over: bool = False,
) -> str:
    """What was read of a garment, as somebody would ask for it: "hoodie, long-sleeved".

    Args:
        part: Of which the likeliest words are taken.
        without: Names of claims to say nothing of, since other words do.
        named: Whether other words say which garment it is; only details are told then, which may be none.
        over: Whether it is worn over trousers: what looks like a dress with sleeves is a coat then.
    """
    said = {name: word for name, word in _likeliest(part).items() if name == "kind" or name not in without}
    kind = said.get("kind", "top" if part.part == "upper" else "trousers")
    if kind in ("trousers", "shorts"):
        hem = said.get("leg_hem")
        kind = kind if hem is None else "shorts" if hem in _OF_SHORTS else "trousers"
        words = [_LEG_HEMS.get(said.get("leg_hem", "")), _LEGS.get(said.get("legs", ""))]
        return _joined(words, "" if named else kind)
    if kind == "skirt":
        words = [_SKIRT_HEMS.get(said.get("skirt_hem", "")), _SKIRTS.get(said.get("skirt", ""))]
        return _joined(words, "" if named else kind)
    if over and kind in ("jumpsuit", "playsuit"):  # whose legs are the trousers'
        kind = "top"
    noun, told = _upper_noun(kind, said)
    outer = outer_noun(kind, said) if part.called == OUTER else None
    if outer is not None:
        noun, told = outer
    elif kind in ("top", "tunic"):
        noun, told = _CALLED.get(part.called, (noun, told))
    if over and outer is None and kind == "dress" and said.get("sleeves", "long") in _OF_COATS:
        noun, told = "coat", frozenset({"neckline", "sleeves"})
    hem_name, hems = _HEMS[kind]
    words = [_FITS.get(said.get("fit", "")), hems.get(said.get(hem_name, ""))]
    more = [] if "sleeves" in told and not named else [_SLEEVES.get(said.get("sleeves", ""))]
    more += [] if "neckline" in told else [_NECKS.get(said.get("neckline", ""))]
    return ", ".join(filter(None, [_joined(words, "" if named else noun), *more]))


def _upper_noun(kind: str, said: Mapping[str, str]) -> tuple[str, frozenset[str]]:
    """What a garment on the shoulders is called, and which claims that says, or takes away."""
    sleeves, collar = said.get("sleeves", ""), said.get("collar", "")
    if kind in ("dress", "jumpsuit", "playsuit"):
        skirt = _SKIRTS.get(said.get("skirt", ""), "") if kind == "dress" else ""
        noun, told = f"{skirt} {kind}".strip(), frozenset[str]()
        if said.get("shoulders") == "strapless":
            return f"strapless {noun}", frozenset({"sleeves", "neckline"})
        if sleeves == "none" and said.get("straps") == "narrow":
            return f"{noun} with thin straps", frozenset({"sleeves"})
        if collar == "lapel":
            return f"{noun} with a collar", frozenset({"neckline"})
        return noun, told
    if said.get("hood") == "hood":
        return ("hoodie" if sleeves != "none" else "sleeveless hoodie"), frozenset({"neckline", "sleeves"})
    if said.get("shoulders") == "strapless":
        return "strapless top", frozenset({"sleeves", "neckline"})
    if collar == "turtleneck":
        return "roll neck top", frozenset({"neckline"})
    if collar == "stand":
        return "top with a stand collar", frozenset({"neckline"})
    if collar == "lapel":
        return ("polo shirt" if sleeves in _SHORT else "shirt"), frozenset({"neckline"})
    if sleeves == "none":
        return ("camisole" if said.get("straps") == "narrow" else "tank top"), frozenset({"sleeves"})
    if kind == "tunic":
        return "tunic", frozenset()
    return ("T-shirt" if sleeves in _SHORT else "top"), frozenset()


def _likeliest(part: PartReading) -> dict[str, str]:
    """Of each claim the likeliest word, where it is sure enough."""
    found: dict[str, str] = {}
    for statement in part.statements:  # surest first
        name = statement.claim.name
        least = _RATHER if name in ("fit", "top_hem", "legs", "skirt") else _SURE
        if name not in found and (name == "kind" or statement.certainty >= least):
            found[name] = str(statement.claim.value)
    return found


def _joined(words: list[str | None], noun: str) -> str:
    """Before the noun; without one each for itself."""
    found = [word for word in words if word]
    return " ".join([*found, noun]) if noun else ", ".join(found)
