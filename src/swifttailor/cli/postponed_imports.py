"""Packages that every run would load and few need: they are loaded when something of them is asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.postponed_module import postponed

_OF_NUMPY = ("testing", "f2py")


def postpone_parts_of_numpy() -> None:
    """Has parts of numpy loaded when they are used: scipy takes hold of all of them, and runs none.

    They bring half the standard library with them.
    """
    for name in _OF_NUMPY:
        postponed(f"numpy.{name}")


if TYPE_CHECKING:
    import tyro
else:
    # An import statement would load it; options are annotated with it and rarely need it (`plain_options`).
    tyro = postponed("tyro")

__all__ = ["postpone_parts_of_numpy", "tyro"]
