"""YAML files of the data set; nothing in them is ever executed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from swifttailor.errors import InputError

MAX_FILE_BYTES = 64_000_000


def read_yaml_mapping(path: Path) -> dict[str, Any]:
    """Reads a YAML file whose top is a mapping.

    Raises:
        InputError: It is missing, too large, damaged, or holds something else.
    """
    import yaml

    try:
        if path.stat().st_size > MAX_FILE_BYTES:
            raise InputError(f"'{path}' has more than {MAX_FILE_BYTES // 10**6} MB; is it the right file?")
        # The C loader is ten times faster and may be missing.
        value = yaml.load(path.read_bytes(), Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    except OSError as error:
        raise InputError(f"Cannot read '{path}': {error.strerror or error}.") from error
    except (yaml.YAMLError, UnicodeDecodeError, ValueError, RecursionError) as error:
        where = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise InputError(f"'{path}' is no YAML that can be read: {where}.") from error
    if not isinstance(value, dict):
        raise InputError(f"'{path}' holds no mapping.")
    return value
