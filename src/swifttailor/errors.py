"""The one error family of the package.

Every error a user can cause derives from `SwiftTailorError` and its text says what is wrong, the value
received, what is accepted and how to mend it. The command line prints that text without a traceback
(``--debug`` shows it) and exits with `SwiftTailorError.exit_code`.
"""

from __future__ import annotations

_LONGEST, _FIRST, _LAST = 1500, 1000, 400
"""Characters of a text: all of it, or those that are kept where it quotes a file at greater length."""


class SwiftTailorError(Exception):
    """Base of all errors that a user or a caller can cause and mend.

    Texts quote what they were given, which may be megabytes of a damaged file. Of long texts the start is
    kept, and the end, which says what to do.
    """

    exit_code = 2

    def __init__(self, text: str = "") -> None:
        if len(text) > _LONGEST:
            left_out = f" [... {len(text) - _FIRST - _LAST} characters ...] "
            text = text[:_FIRST] + left_out + text[-_LAST:]
        super().__init__(text)


class InputError(SwiftTailorError):
    """A file or an argument cannot be read, is of the wrong kind, or lies outside what is accepted."""


class DiskFullError(InputError):
    """There is no room left to write a file: no later one of the same work can be written either."""


class NothingSeenError(SwiftTailorError):
    """A picture shows no garment that could be made."""

    exit_code = 1


class NothingAskedError(SwiftTailorError):
    """A text asks for no garment that could be made."""

    exit_code = 1


class PatternError(SwiftTailorError):
    """A sewing pattern breaks the rules of the format or cannot be sewn."""


class GeometryError(SwiftTailorError):
    """A shape cannot be meshed, measured or joined."""


class SimulationError(SwiftTailorError):
    """The physics could not produce a usable garment."""


class TimeLimitError(SwiftTailorError):
    """Work was given up because it took longer than it may."""


class MissingExtraError(SwiftTailorError):
    """An optional package is needed and is not installed."""

    def __init__(self, package: str, extra: str, purpose: str) -> None:
        super().__init__(
            f"{purpose} needs the package '{package}', which is not installed. "
            f"Install it with: pip install 'swifttailor[{extra}]'"
        )
