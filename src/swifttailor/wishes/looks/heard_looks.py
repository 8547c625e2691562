"""How parts of a garment are to look by a text: which colour, sheer or not, and what is assumed of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType

from swifttailor.garment.cloth_print import ClothPrint
from swifttailor.garment.part_looks import OPACITIES, PARTS, SEVERAL_LAYERS, PartLook, merged
from swifttailor.wishes.looks.printed_parts import ON_ALL, PrintedParts
from swifttailor.wording.lexicon import NamedColor, SaidLook
from swifttailor.wording.lexicon.color_names import color_name

_LINED = frozenset({"lace", "tulle", "chiffon", "organza"})
"""Sheer cloths that whole garments of some kinds are made of on a lining."""
_LINED_KINDS = frozenset({"dress", "skirt", "trousers", "shorts", "jumpsuit", "playsuit"})
_OF_NET = frozenset({"tulle", "net", "organza", "chiffon"})
"""Cloths that skirts have several layers of."""
_SKIRTED = frozenset({"dress", "skirt"})
_LINED_BEFORE = "lined_"
_ARE_ALL = (("skirt", "skirt"), ("trousers", "legs"), ("shorts", "legs"))
"""Kinds of garments that are nothing but a part of others."""
_CONTRAST, _OTHER = "contrast", "other"
_ON_LIGHT, _ON_DARK = NamedColor("navy", "1f2a44"), NamedColor("off-white", "f4f1e8")
_LIGHT_FROM = 150.0
"""Brightness from which cloth counts as light, 0 to 255."""


@dataclass(frozen=True)
class HeardLooks:
    """What is to look otherwise than the rest."""

    looks: tuple[PartLook, ...] = ()
    refused: tuple[str, ...] = ()
    """What of it no garment can have, in words."""
    assumed: tuple[str, ...] = ()
    """What of it nobody said, in words."""
    said: frozenset[str] = frozenset()
    """The parts that the text itself speaks of."""
    names: tuple[tuple[str, str], ...] = ()
    """Colours, ``#rrggbb``, and what the text calls them."""
    second: str = ""
    """The part that the second colour of the garment was put on, where the text says none."""

    @property
    def lines(self) -> tuple[str, ...]:
        """The looks in words: "collar in white (#ffffff)", "sleeves of lace, sheer"."""
        return tuple([look_line(look, dict(self.names)) for look in self.looks])

    def __bool__(self) -> bool:
        return bool(self.looks or self.refused)


_IN_ANOTHER_CLOTH = ("collar", "cuffs", "sleeves", "hood", "waistband", "hem_band")
"""Parts of which another cloth is seen as another shade."""
_DARK_CLOTH, _DARK_TO = "#35353c", 60.0
"""Of a garment that has no known colour; and what is darker than this is too dark for a deeper shade."""
NO_LOOKS = HeardLooks()


def heard_looks(
    told: Sequence[SaidLook],
    kind: str | None,
    color: str | None,
    printed: ClothPrint | None,
    printed_parts: PrintedParts = ON_ALL,
) -> HeardLooks:
    """The looks that a text asks for.

    Args:
        told: By the lexicon.
        kind: Of the garment; None where it is not known.
        color: Of the garment, ``#rrggbb``; None where nothing tells it.
        printed: On its cloth.
        printed_parts: What alone it is on, where that is not all of it.
    """
    found: list[PartLook] = []
    refused: list[str] = []
    assumed: list[str] = []
    said = [look for look in told if look.said]
    spoken = frozenset([look.part for look in said])
    said += [look for look in told if not look.said and look.part not in spoken]
    general = [look for look in said if look.part == "all" and look.cloth is not None]
    for look in (*general, *[look for look in said if look not in general]):
        if (kind, look.part) in _ARE_ALL:
            look = replace(look, part="all")
        if not look.part:
            continue  # a thing of its own: that it cannot be made is said anyway
        if look.cloth == _OTHER and look.part in _IN_ANOTHER_CLOTH:
            refused.append(f"another cloth of the {look.noun.lower()} (another shade is drawn)")
            if any(one.part == look.part and one.color is not None for one in said):
                continue  # what has a colour of its own is seen by that
            found = _with(found, PartLook(look.part, _another_shade(color, gleams=_is_satin(look))))
            continue
        if look.cloth == _OTHER:
            refused.append(f"another cloth of the {look.noun.lower()}")
            continue
        if look.part not in PARTS and look.color is not None and f"#{look.color.rgb}" == color:
            continue  # the whole is of it
        if look.part not in PARTS:
            refused.append(f"another {'look' if look.color is None else 'colour'} of the {look.noun.lower()}")
            continue
        if look.cloth == _CONTRAST:
            shown = _contrast(printed.colors[0] if printed is not None else color)
            assumed.append(f"{look.part.replace('_', ' ')} in {shown.words}")
            found = _with(found, PartLook(look.part, f"#{shown.rgb}"))
        elif look.part == "all" and look.cloth is not None:
            found, lining = _of_whole(found, look.cloth or "", kind, said)
            assumed += lining
        else:
            found, lining = _of_part(found, look, general)
            assumed += lining
            if not look.said and look.color is not None:
                assumed.append(f"{look.part.replace('_', ' ')} in {color_name(look.color.rgb)}")
    for part in printed_parts.parts:
        # The colour that is said of them is one of the print's.
        found = [replace(look, color=None) if look.part == part else look for look in found]
        found = _with(found, PartLook(part, printed=True))
    refused += [f"another print of the {noun}" for noun in printed_parts.unmade]
    spoken = spoken | frozenset(printed_parts.parts)
    names = {
        f"#{look.color.rgb}": look.color.words.lower()
        for look in said
        if look.color is not None and look.color.words
    }
    return HeardLooks(
        tuple(found),
        tuple(dict.fromkeys(refused)),
        tuple(dict.fromkeys(assumed)),
        spoken,
        tuple(names.items()),
    )


def look_refused(look: PartLook) -> str:
    """What is said of a look that a garment cannot have, as it has no such part of its own."""
    return f"another {'look' if look.color is None else 'colour'} of the {look.part.replace('_', ' ')}"


def look_line(look: PartLook, names: Mapping[str, str] = MappingProxyType({})) -> str:
    """A look in words.

    Args:
        look: Of a part.
        names: What colours, ``#rrggbb``, are called.
    """
    part = "all of it" if look.part == "all" else look.part.replace("_", " ")
    color = "" if look.color is None else f" in {look.color}"
    if look.color is not None and look.color in names:
        color = f" in {names[look.color]} ({look.color})"
    if look.printed:
        return f"{part} in the print" + ("" if look.cloth is None else f", {look.cloth}")
    if look.cloth is None:
        return f"{part}{color}"
    if look.cloth == "opaque":
        return f"{part}{color} opaque"
    how = "sheer" if look.cloth == "sheer" else f"of {look.cloth}, sheer"
    if look.opacity is not None:
        how = f"of {look.cloth}, " + ("lined" if look.opacity >= 1.0 else "in several layers")
    return f"{part}{color} {how}"


def _of_whole(
    found: list[PartLook], cloth: str, kind: str | None, said: Sequence[SaidLook]
) -> tuple[list[PartLook], list[str]]:
    """All of the garment in a sheer cloth: on a lining where that is usual, but for sleeves."""
    if cloth == "opaque":
        return [*[look for look in found if look.part != "all"], PartLook("all", None, cloth)], []
    if cloth.startswith(_LINED_BEFORE):
        return _with(found, PartLook("all", None, cloth.removeprefix(_LINED_BEFORE), 1.0)), []
    own = [look for look in found if look.part == "all" and look.cloth is not None]
    if own:
        # "Sheer mesh" is one cloth, named twice, and "a sheer chiffon dress" has no lining.
        named = own[0].cloth if own[0].cloth != "sheer" else cloth
        bare = cloth in _LINED and own[0].cloth in _LINED
        return (found if bare else [PartLook("all", None, named)]), []
    sheer = any(look.part == "all" and look.cloth not in (*_LINED, None) for look in said)
    if cloth not in _LINED or kind not in _LINED_KINDS or sheer:
        return _with(found, PartLook("all", None, cloth)), []
    lined = [PartLook("all", None, cloth, 1.0)]
    assumed = "lined, so that nothing shows through"
    if cloth in _OF_NET and kind in _SKIRTED:
        lined.append(PartLook("skirt", None, cloth, SEVERAL_LAYERS))
        assumed = "a skirt of several layers" + ("" if kind == "skirt" else "; the rest lined")
    if kind in ("dress", "jumpsuit", "playsuit"):
        lined.append(PartLook("sleeves", None, cloth))
        assumed += "; sleeves, if it has any, without lining"
    return [*found, *lined], [assumed]


def _of_part(
    found: list[PartLook], look: SaidLook, general: Sequence[SaidLook]
) -> tuple[list[PartLook], list[str]]:
    color = None if look.color is None else f"#{look.color.rgb}"
    cloth, opacity = look.cloth, None
    old = next((one for one in found if one.part == look.part), None)
    if color is not None and old is not None and old.color is not None:
        color = old.color  # of several colours the first is used
    if cloth is None:
        return _with(found, PartLook(look.part, color)), []
    if cloth.startswith(_LINED_BEFORE):
        cloth, opacity = cloth.removeprefix(_LINED_BEFORE), 1.0
    if cloth == "sheer":  # "chiffon dress with a sheer skirt"; "sheer lace sleeves"
        whole = [one.cloth for one in general if one.cloth in OPACITIES and one.cloth != "opaque"]
        before = old.cloth if old is not None and old.opacity is None else None
        cloth = before or next((one for one in whole if one is not None), cloth)
        if before is not None:
            return found, []
    assumed = []
    if cloth in _OF_NET and look.part == "skirt" and not _is_sheer(look, general):
        opacity, assumed = SEVERAL_LAYERS, ["a skirt of several layers"]
    if cloth == "lace" and look.part in ("bodice", "skirt"):
        opacity, assumed = 1.0, [f"the {look.part} lined, so that nothing shows through"]
    return _with(found, PartLook(look.part, color, cloth, opacity)), assumed


def _is_sheer(look: SaidLook, general: Sequence[SaidLook]) -> bool:
    return look.cloth == "sheer"


def _with(found: list[PartLook], look: PartLook) -> list[PartLook]:
    return list(merged(found, [look]))


def _is_satin(look: SaidLook) -> bool:
    return any(entry.cloth == "silk" for mark in look.marks for entry in mark.entries)


def _another_shade(color: str | None, *, gleams: bool) -> str:
    """The colour of another cloth beside a garment's: satin gleams on dark cloth, a pile is deeper."""
    if color is None:
        return _DARK_CLOTH
    channels = [int(color[k : k + 2], 16) for k in (1, 3, 5)]
    brightness = 0.3 * channels[0] + 0.59 * channels[1] + 0.11 * channels[2]
    if brightness < _DARK_TO or (gleams and brightness < _LIGHT_FROM):
        mixed = [round(c + 0.16 * (255 - c)) for c in channels]
    else:
        mixed = [round((0.86 if gleams else 0.6) * c) for c in channels]
    return "#" + "".join(f"{c:02x}" for c in mixed)


def with_look(found: Sequence[PartLook], part: str, color: str) -> list[PartLook]:
    """Some looks, and a colour of one part more.

    Args:
        found: Of other parts.
        part: One of `PARTS`.
        color: ``#rrggbb``.
    """
    return _with([look for look in found if look != PartLook(part)], PartLook(part, color))


def _contrast(color: str | None) -> NamedColor:
    """A colour that is told from another at a glance; most that nobody names are dark."""
    if color is None:
        return _ON_DARK
    red, green, blue = (int(color[k : k + 2], 16) for k in (1, 3, 5))
    return _ON_LIGHT if 0.3 * red + 0.59 * green + 0.11 * blue >= _LIGHT_FROM else _ON_DARK
