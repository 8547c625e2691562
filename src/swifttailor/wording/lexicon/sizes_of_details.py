"""Words about the size of a detail, which say nothing of the garment: "a huge slit", "split to the knee"."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from swifttailor.wording.lexicon.meanings import Meaning

ADJECTIVES = frozenset(
    ["styles", "fits", "lengths", "occasions", "colors", "shades", "prints", "fabrics", "sizes"]
)
"""Categories of words that stand before nouns."""
_LITTLE = frozenset(
    {
        *("hood", "slit", "collar", "cuffs", "leg_cuffs", "waistband", "hem_band", "straps", "tiers"),
        *("shoulders", "yoke", "panels", "gores", "godets", "peplum", "darts", "seam"),
    }
)
"""Parts that may be of any size on a garment of any size."""
_BIG = frozenset("big huge giant enormous massive gigantic ginormous oversized oversize".split())
_SMALL = frozenset("small medium tiny teeny little mini".split())
_OPENINGS = frozenset({"zip", "buttons", "lacing", "back_lacing", "train", "ties"})
"""What lies along a garment without being as long: a zip to the waist."""
_ENDS_OPENINGS = frozenset(["garments", "accessories", "generic", "colors", "fabrics", "prints"])
_FACES = frozenset({"front", "back", "sides"})
_AT_NECKS = frozenset({"collar", "neckline", "hood"})
_WITH = frozenset("with mit avec con col com".split())
"""Before what is put on a garment in other languages: "felpa oversize col cappuccio" is a large one."""
_BEGINS = frozenset(
    "from starting start starts begin begins beginning flaring flares flare opening opens".split()
)
_CLOSE = frozenset(
    "tight fitted close slim narrow snug straight hugging close-fitting figure-hugging".split()
)
TURNS = _BEGINS | _CLOSE
"""Words before a level at which a skirt changes its shape."""
_FLARES = frozenset(
    {
        *("fishtail", "flare", "flared", "flares", "flaring", "flounce", "flounces", "godet", "godets"),
        *("trumpet", "mermaid", "kick", "kicks", "frill", "ruffle"),
    }
)
_FAR = 5
"""Words that may stand between a size and its noun, or a detail and how far it goes."""


def little_behind(words: Sequence[Meaning], k: int) -> int | None:
    """Which part behind a word has a size that says nothing of the garment: "a huge slit", "a big hood".

    Other adjectives may stand between: "a very wide turned-down collar".
    """
    for j in range(k + 1, min(k + _FAR, len(words))):
        if words[j - 1].found.gap not in ("space", "hyphen"):
            return None
        size = words[k].found.word.rpartition(" ")[2]
        if (size in _BIG or size in _SMALL) and _is_put_on(words, j):
            return j
        if size in _SMALL and (words[j].category == "prints" or any(e.cannot for e in words[j].entries)):
            own = words[j].category in ("prints", "styles") and not _goes_on_to_garment(words, j)
            return j if own else None
        if _lies_at_a_neck(words[j]) and not _goes_on_to_garment(words, j):
            return j
        if words[j].is_noun:
            name = words[j].found.word
            shaped = words[j].category == "styles" and not name.endswith(("ed", "y"))
            shaped = shaped and name.split()[0] not in _WITH and "sleeve" not in name
            return j if words[j].part in _LITTLE and (shaped or words[j].category == "parts") else None
        if words[j].category not in ADJECTIVES and "hyphen" not in (
            words[j - 1].found.gap,
            words[j].found.gap,
        ):
            return None
    return None


def _lies_at_a_neck(word: Meaning) -> bool:
    """Whether a word names lapels, a collar or folds of a neckline, and no shape: "a loose cowl"."""
    if word.category != "styles" or word.found.word.endswith(("ed", "y")) or word.holds_together:
        return False
    claims = [claim for entry in word.entries for claim in entry.claims("certain")]
    lapels = any(claim.name == "collar" and claim.value == "lapel" for claim in claims)
    return lapels or any("draped" in entry.cannot for entry in word.entries)


def tells_how_far(words: Sequence[Meaning], k: int) -> bool:
    """Whether it tells how far something goes that lies along a garment: "split up the front to the knee".

    So it does where a skirt is close so far and then flares, and where something begins there.
    """
    if _begins_there(words, k) or _is_close_so_far(words, k):
        return True
    for j in range(k - 1, max(k - _FAR, 0) - 1, -1):
        word = words[j]
        if word.found.gap in ("pause", "stop") or word.category in _ENDS_OPENINGS:
            return False
        if word.part == "slit" or any(_OPENINGS & set(entry.cannot) for entry in word.entries):
            return word.category in ("parts", "styles")
        if word.is_noun and word.part not in _FACES:
            return False
    return False


def _begins_there(words: Sequence[Meaning], k: int) -> bool:
    """Whether something begins at a level: "three flounces starting at the knee"."""
    return k > 0 and words[k].found.gap not in ("pause", "stop") and words[k - 1].found.word in _BEGINS


def _is_close_so_far(words: Sequence[Meaning], k: int) -> bool:
    """Whether a garment is close down to a level and flares below: "tight to the knee, then a fishtail"."""
    if k == 0 or words[k - 1].found.word not in _CLOSE:
        return False
    behind = words[k + 1 : k + 1 + _FAR]
    return any(not _FLARES.isdisjoint(word.found.word.split()) for word in behind)


def _is_put_on(words: Sequence[Meaning], k: int) -> bool:
    """Whether a word names what is put on a garment, and ends its phrase: a roll neck, patch pockets."""
    word = words[k]
    ends = k + 1 == len(words) or word.found.gap in ("pause", "stop") or words[k + 1].category == "function"
    if word.category != "styles" or not ends or word.found.word.endswith(("ed", "y")):
        return False
    if word.found.word.split()[0] in _WITH:
        return False
    collared = any(claim.name == "collar" for entry in word.entries for claim in entry.claims("certain"))
    trimmed = any(entry.cannot and not entry.implied for entry in word.entries)
    return collared or trimmed or word.part in _AT_NECKS


def _goes_on_to_garment(words: Sequence[Meaning], k: int) -> bool:
    if k + 1 >= len(words) or words[k].found.gap in ("pause", "stop"):
        return False
    return words[k + 1].category == "garments"
