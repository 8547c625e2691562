"""With what a garment was made: versions of the program, facts about the weights."""

from __future__ import annotations

import platform
from functools import cache
from importlib import import_module, metadata
from typing import Any

from swifttailor import __version__

_PACKAGES = ("numpy", "scipy", "onnxruntime")
_FACTS = ("model", "parameters", "data", "training", "validation")
"""What a card says that is told with every garment; how the network was configured is in its file."""


def versions() -> dict[str, str]:
    """Of what a garment depends on."""
    return dict(_versions())


@cache
def _versions() -> dict[str, str]:
    found = {"swifttailor": __version__, "python": platform.python_version()}
    for name in _PACKAGES:
        try:
            found[name] = metadata.version(name)
        except metadata.PackageNotFoundError:  # some builds of onnxruntime have other names
            found[name] = str(getattr(import_module(name), "__version__", "unknown"))
    return found


def weights(**networks: Any) -> dict[str, Any]:
    """What the cards of networks say of them, by name; None is left out."""
    cards = {name: _card(network) for name, network in networks.items() if network is not None}
    return {name: {fact: card[fact] for fact in _FACTS if fact in card} for name, card in cards.items()}


def _card(network: Any) -> dict[str, Any]:
    card = getattr(network, "card", None)
    return card if isinstance(card, dict) else {"model": type(network).__name__}
