"""A folder for numba's compiled code where numba finds none, as in containers without a home folder.

numba keeps what it compiles beside the source, else in the user's cache folder; where it may write neither,
importing a kernel fails. Then a private folder among the temporary files is used.
"""

from __future__ import annotations

import os
import stat
import tempfile
from pathlib import Path

_SETTING = "NUMBA_CACHE_DIR"


def provide_numba_cache(source_folder: Path) -> None:
    """Sets NUMBA_CACHE_DIR unless numba can do without; to be called before numba is imported.

    Args:
        source_folder: A folder with kernels, as far as writing is concerned like all others of the package.
    """
    if os.environ.get(_SETTING):
        return
    user_cache = Path(os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache"))
    if not (_can_write(source_folder / "__pycache__") or _can_write(user_cache)):
        os.environ[_SETTING] = str(_private_folder())


def _can_write(folder: Path) -> bool:
    """Whether files can be made in a folder, or the folder itself."""
    while not folder.exists() and folder != folder.parent:
        folder = folder.parent
    return folder.is_dir() and os.access(folder, os.W_OK | os.X_OK)


def _private_folder() -> Path:
    """Kept between runs; a new one each time where the name is taken by somebody else.

    What lies in it is executed, so nobody else may be able to put anything there.
    """
    user = os.getuid() if hasattr(os, "getuid") else 0
    folder = Path(tempfile.gettempdir()) / f"swifttailor-numba-{user}"
    try:
        folder.mkdir(mode=0o700, exist_ok=True)
        found = folder.lstat()
    except OSError:
        return Path(tempfile.mkdtemp(prefix="swifttailor-numba-"))
    is_mine = stat.S_ISDIR(found.st_mode) and found.st_uid == user and not found.st_mode & 0o077
    return folder if is_mine or os.name == "nt" else Path(tempfile.mkdtemp(prefix="swifttailor-numba-"))
