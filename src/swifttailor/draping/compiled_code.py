"""Whether the loops still have to be compiled on this machine."""

from __future__ import annotations

from typing import Any

COMPILE_NOTE = "compiling the solver (first time only, about 20 s)"
COARSE_COMPILE_NOTE = "compiling the coarse drape (first time only, about 8 s)"


def solver_is_compiled() -> bool:
    """Whether numba finds the solver's compiled code on disk, so that a drape starts at once."""
    from swifttailor.draping import xpbd_kernels

    return _is_compiled(xpbd_kernels.advance_frame)


def coarse_drape_is_compiled() -> bool:
    """The same of the coarse drape."""
    from swifttailor.draping import coarse_kernels

    return _is_compiled(coarse_kernels.sew_and_hang)


def _is_compiled(kernel: Any) -> bool:
    """Used only to say what the wait is for.

    numba has no public question for this; should its insides change, the answer is yes.
    """
    try:
        return bool(kernel._cache._cache_file._load_index())
    except Exception:
        return True
