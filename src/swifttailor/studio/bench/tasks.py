"""All tasks by name, and the tailor that carries them out."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from swifttailor.studio.bench.documents import Work
    from swifttailor.tailor import Tailor

Task = Callable[..., "Work"]


@functools.cache
def tailor() -> Tailor:
    """The one tailor of a process; its networks are opened when they are first needed."""
    from swifttailor.tailor import Tailor

    return Tailor.load()


def warm_up() -> None:
    """Sews a small garment, so that the first that a person waits for takes no longer than others."""
    from swifttailor.errors import SwiftTailorError
    from swifttailor.pattern.drafts import draft

    try:
        tailor().sew(draft("t-shirt"), edge_length=5.0)
    except SwiftTailorError:  # weights are missing: tasks that need them say so
        pass


def _task(module: str, name: str) -> Task:
    """A task whose module is loaded when it is first asked for."""

    def run(*arguments: Any, **named: Any) -> Work:
        from importlib import import_module

        function: Task = getattr(import_module(f"swifttailor.studio.bench.{module}"), name)
        return function(*arguments, **named)

    return run


TASKS: dict[str, Task] = {
    "live": _task("quick", "live"),
    "open": _task("quick", "open_pattern"),
    "check": _task("quick", "check_only"),
    "repair": _task("quick", "repair"),
    "describe": _task("quick", "describe"),
    "alter": _task("quick", "alter"),
    "fit": _task("fitting", "fit"),
    "wearer": _task("fitting", "wearer"),
    "measures": _task("fitting", "measures_file"),
    "body": _task("body_upload", "take_in"),
    "generate": _task("making", "generate"),
    "edit": _task("making", "edit"),
    "sew": _task("making", "sew"),
    "finish": _task("physics", "finish"),
    "drape": _task("physics", "drape"),
    "picture": _task("pictures", "take_in"),
    "seen": _task("pictures", "seen"),
    "tile": _task("print_tiles", "tile"),
    "export": _task("files", "export"),
    "save": _task("files", "save"),
}
"""Each is given a `Link` and plain values, and gives a `Work`."""
