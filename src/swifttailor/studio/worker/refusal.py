"""Errors as clients get them: a code, what is wrong, what to do next."""

from __future__ import annotations

import re

from swifttailor import errors

_KINDS: tuple[tuple[type[Exception], str, str], ...] = (
    (
        errors.NothingSeenError,
        "nothing-seen",
        "Take another picture, crop it to one person, or describe the garment.",
    ),
    (errors.NothingAskedError, "nothing-asked", "Name a garment, and what it is like."),
    (errors.DiskFullError, "disk-full", "Make room on the disk; what was saved before is whole."),
    (errors.TimeLimitError, "too-long", "Try a simpler pattern, or a longer edge length."),
    (errors.PatternError, "pattern-unusable", "Look at the findings; what can be mended has a button there."),
    (
        errors.GeometryError,
        "pattern-unusable",
        "Look at the findings; what can be mended has a button there.",
    ),
    (errors.SimulationError, "drape-failed", "Finish the sewn garment instead, or mend the pattern first."),
    (errors.MissingExtraError, "not-installed", ""),
    (errors.InputError, "input-refused", ""),
)
_FOR_TERMINALS = re.compile(
    r"\s*(Run|Repair it with|What may be wrong with the pattern|Drape the pattern instead|To [a-z ]+)"
    r": swifttailor [^.]*\.?"
    r"|\s*\([^()]*--[a-z][^()]*\)|,? with --overwrite|\s*\(in Python:[^)]*\)"
)


def refusal_of(error: BaseException) -> dict[str, str]:
    """An error of the package as `ErrorInfo`; any other is a fault of the program."""
    for kind, code, hint in _KINDS:
        if isinstance(error, kind):
            return {"code": code, "message": for_people(str(error)), "hint": hint}
    if isinstance(error, MemoryError):
        return {
            "code": "no-memory",
            "message": "There is not enough memory for this.",
            "hint": "Choose a longer edge length, or close other programs.",
        }
    if isinstance(error, errors.SwiftTailorError):
        return {"code": "refused", "message": for_people(str(error)), "hint": ""}
    return {
        "code": "internal",
        "message": f"A fault inside SwiftTailor: {type(error).__name__}.",
        "hint": "Nothing of your project is lost. Please report it with the pattern, if you can.",
    }


def for_people(text: str) -> str:
    """A message without the commands that it tells users of the command line to type."""
    return _FOR_TERMINALS.sub("", text).strip()
