"""What the face of cloth looks like where nothing is printed on it: curls, plaits, pile, sequins, metal."""

from __future__ import annotations

import re
from collections.abc import Mapping

from swifttailor.garment.cloth_print import ClothPrint
from swifttailor.render.drawn_naps import CHANNELS
from swifttailor.wishes.looks.print_inks import shades
from swifttailor.wording.lexicon import WordReading

_CURLED = re.compile(
    r"teddy|sherpa|borg\b|fleece|fluffy|fuzzy|minky|plüsch|peluche|boucl[eé]|terry|towelling|frottee|sheepskin|shearling"
    r"|flausch|astrakhan|furry|borreguito|orsetto",
    re.IGNORECASE,
)
_VELVET = re.compile(
    r"velvet|velour|velluto|terciopelo|(?<!ge)samt|fluweel|veludo|plush|devor|chenille|panne(?!a)|nicki",
    re.IGNORECASE,
)
_NOT_VELVET = re.compile(r"cord|côtelé|ribbed", re.IGNORECASE)
_GLITTER = re.compile(r"sequin|glitt?er|sparkl|pailletten|lentejuela|paillette|spangl", re.IGNORECASE)
_METAL = re.compile(
    r"metallic|metallics|\blam[eé]\b|foil|liquid (?:gold|silver)|chrome|holographic|iridescent|metallisch"
    r"|métallisé|hologram",
    re.IGNORECASE,
)
_MARL = re.compile(
    r"(?<!\w)(?:marle?d?|melange|mélange|meliert\w*|heather(?:ed)? gr[ea]y|heathered|chiné|jaspeado"
    r"|gemêleerd|mescla)(?!\w)",
    re.IGNORECASE,
)
_LINEN = re.compile(r"(?<!\w)(?:linen|leinen\w*|lin|lino|linho|linnen|flax)(?!\w)", re.IGNORECASE)
_EDGED = frozenset({"neck fur", "fur trim", "sleeve fur"})
_REPEATS_CM: Mapping[str, float] = {
    "curls": 42,
    "cables": 26,
    "sequins": 11,
    "pile": 34,
    "foil": 40,
    "fur": 30,
    "marl": 34,
    "linen": 40,
}


def nap_of(words: WordReading) -> str | None:
    """Which face cloth has, as a motif of `cloth_print`; None where words name none.

    Args:
        words: Of a text, by the lexicon.
    """
    of_parts = {id(m) for look in words.looks if look.part not in ("", "all") for m in look.marks}
    marks = [mark for mark in words.marks if not mark.denied and id(mark) not in of_parts]
    # Fur along a hood or a collar is no fur of the whole.
    marks = [mark for mark in marks if not any(_EDGED.intersection(entry.trims) for entry in mark.entries)]
    lacking = {what for mark in marks for entry in mark.entries for what in entry.cannot}
    said = " ".join([mark.word for mark in marks])
    if "cables" in lacking:
        return "cables"
    if _GLITTER.search(said):
        return "sequins"
    if "fur" in lacking and not _CURLED.search(said):
        return "fur"
    if _CURLED.search(said):
        return "curls"
    if _VELVET.search(said) and not _NOT_VELVET.search(said):
        return "pile"
    if _METAL.search(said):
        return "foil"
    if _MARL.search(said):
        return "marl"
    return "linen" if _LINEN.search(said) else None


def puffed(color: str, apart: float) -> ClothPrint:
    """Cloth with cushions between lines of quilting.

    Args:
        color: ``#rrggbb``.
        apart: Distance of the lines, cm.
    """
    return ClothPrint("motif", shades("channels", color), {"repeat": CHANNELS * apart}, "channels")


def napped(color: str, nap: str) -> ClothPrint:
    """Cloth of a colour with such a face.

    Args:
        color: ``#rrggbb``.
        nap: See `nap_of`.
    """
    return ClothPrint("motif", shades(nap, color), {"repeat": _REPEATS_CM[nap]}, nap)
