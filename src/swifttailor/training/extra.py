"""Whether what training needs is installed."""

from __future__ import annotations

import importlib.util

from swifttailor.errors import MissingExtraError


def require_training_packages(purpose: str) -> None:
    """Makes sure that torch and transformers are installed; loads neither.

    Args:
        purpose: What needs them, to begin the message with.

    Raises:
        MissingExtraError: One of them is not.
    """
    for package in ("torch", "transformers"):
        if importlib.util.find_spec(package) is None:
            raise MissingExtraError(package, "train", purpose)
