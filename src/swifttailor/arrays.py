"""Types of the arrays that the package hands around; shapes and units stand where they are used."""

from __future__ import annotations

from typing import Any

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
