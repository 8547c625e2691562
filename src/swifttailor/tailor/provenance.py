"""With what a garment was made: versions of the program, facts about the weights."""

from __future__ import annotations

import platform
from functools import cache
from importlib import import_module, metadata
from typing import TYPE_CHECKING, Any

from swifttailor import __version__
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.pattern_maker.maker import PatternMaker

if TYPE_CHECKING:
    from swifttailor.wishes.reader import WishReader

_PACKAGES = ("numpy", "scipy", "onnxruntime")
_FACTS = ("model", "parameters", "data", "training", "validation")
"""What a card says that is told with every garment; how the network was configured is in its file."""


@cache
def versions() -> dict[str, str]:
    """Of what a garment depends on."""
    found = {"swifttailor": __version__, "python": platform.python_version()}
    for name in _PACKAGES:
        try:
            found[name] = metadata.version(name)
        except metadata.PackageNotFoundError:  # some builds of onnxruntime have other names
            found[name] = str(getattr(import_module(name), "__version__", "unknown"))
    return found


def weights(
    maker: PatternMaker | None, sewer: GarmentSewer, reader: WishReader | None = None
) -> dict[str, Any]:
    """What the cards of the networks say of them."""
    cards = {"garment_sewer": sewer.model.card}
    if reader is not None:
        cards = {"wish_reader": reader.card} | cards
    if maker is not None:
        cards = {"pattern_maker": maker.model.card} | cards
    return {name: {fact: card[fact] for fact in _FACTS if fact in card} for name, card in cards.items()}
