"""Walks through what is remembered and handed out, to see that no caller can change it for the next."""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cached_property
from types import MappingProxyType

import numpy as np
from scipy.sparse import issparse

PLAIN = (str, bytes, int, float, bool, complex, type(None), Enum, frozenset)


def changeable(value: object, where: str = "it") -> list[str]:
    """Where something can be changed in place, computed properties included; frozen all the way is empty."""
    if isinstance(value, PLAIN):
        return []
    if isinstance(value, np.ndarray):
        return [where] if value.flags.writeable else []
    if issparse(value):
        return [f"{where}.{n}" for n in ("data", "indices", "indptr") if getattr(value, n).flags.writeable]
    if isinstance(value, tuple):
        return [w for k, each in enumerate(value) for w in changeable(each, f"{where}[{k}]")]
    if isinstance(value, MappingProxyType):
        return [w for k, each in value.items() for w in changeable(each, f"{where}[{k!r}]")]
    if is_dataclass(value) and value.__dataclass_params__.frozen:
        own = [f.name for f in fields(value)]
        own += [n for n, p in vars(type(value)).items() if isinstance(p, cached_property)]
        own = [n for n in own if n != "_index"]  # of a pattern, which hands it to nobody
        return [w for n in own for w in changeable(getattr(value, n), f"{where}.{n}")]
    return [f"{where}: {type(value).__name__}"]
