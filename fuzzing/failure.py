"""Telling failures apart."""

from __future__ import annotations

import re
import traceback
from pathlib import Path

_PACKAGE = "/src/swifttailor/"
_FRAME = re.compile(r'File "([^"]+)", line \d+ in (\S+)')


def signature_of(error: BaseException) -> str:
    """The kind of an error and the last place in SwiftTailor on its way: the same fault, the same text."""
    frames = traceback.extract_tb(error.__traceback__)
    ours = [f for f in frames if _PACKAGE in Path(f.filename).as_posix()]
    place = f"{_inside(ours[-1].filename)}:{ours[-1].name}" if ours else "fuzzing"
    text = f" {str(error)[:60]}" if isinstance(error, AssertionError) else ""
    return f"{type(error).__name__} in {place}{text}"


def signature_of_dump(kind: str, dump: str) -> str:
    """The same of what Python's faulthandler has printed, innermost frame first, before the process ended."""
    ours = [(path, name) for path, name in _FRAME.findall(dump) if _PACKAGE in path]
    return f"{kind} in {_inside(ours[0][0])}:{ours[0][1]}" if ours else kind


def folder_of(signature: str) -> str:
    """A name for the folder where the inputs of a failure are kept."""
    return re.sub(r"[^A-Za-z0-9_.]+", "-", signature).strip("-")[:100]


def _inside(path: str) -> str:
    return Path(path).as_posix().rpartition(_PACKAGE)[2].removesuffix(".py")
