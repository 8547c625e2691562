"""Types of the arrays that the package hands around; shapes and units stand where they are used."""

from __future__ import annotations

from typing import Any, TypeVar

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
