"""Whether the solver still has to be compiled on this machine."""

from __future__ import annotations

COMPILE_NOTE = "compiling the solver (first time only, about 20 s)"


def solver_is_compiled() -> bool:
    """Whether numba finds the solver's compiled code on disk, so that a drape starts at once.

    Used only to say what the wait is for. numba has no public question for this; should its insides change,
    the answer is yes.
    """
    from swifttailor.draping import xpbd_kernels

    try:
        return bool(xpbd_kernels.advance_frame._cache._cache_file._load_index())
    except Exception:
        return True
