"""Types of the arrays that the package hands around; shapes and units stand where they are used."""

from __future__ import annotations

import tokenize
from typing import IO, Any, TypeVar

import numpy as np
from numpy.typing import NDArray

Array = np.ndarray[Any, np.dtype[Any]]
"""Of any kind."""
Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
"""What networks and images hold."""
Ints = NDArray[np.int32]
Longs = NDArray[np.int64]
Bools = NDArray[np.bool_]
Pixels = NDArray[np.uint8]

_Some = TypeVar("_Some", bound=np.ndarray[Any, Any])


def read_only(array: _Some) -> _Some:
    """The same array, no longer to be changed: for what is remembered and handed out again and again."""
    array.flags.writeable = False
    return array


def read_npy_header(stream: IO[bytes]) -> tuple[tuple[int, ...], bool, np.dtype[Any]]:
    """What a .npy file announces, before memory is given to it.

    Args:
        stream: The file, from its start; afterwards the values come next.

    Returns:
        Shape, whether the first axis runs fastest, and type.

    Raises:
        ValueError: It is not a header of version 1 or 2.
        OSError: The stream cannot be read.
    """
    version = np.lib.format.read_magic(stream)
    readers = {
        (1, 0): np.lib.format.read_array_header_1_0,
        (2, 0): np.lib.format.read_array_header_2_0,
    }
    if version not in readers:
        raise ValueError(f"unknown numpy version {version}")
    try:
        return readers[version](stream)
    except tokenize.TokenError as error:  # numpy looks for numbers that Python 2 has written
        raise ValueError(f"the header cannot be parsed: {error}") from error
