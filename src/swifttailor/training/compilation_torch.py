"""Layers translated into machine code that does in one go what single operations do one by one.

On a CPU most of the time goes to reading and writing what lies between two products of matrices. Import this
in the function that needs it: it loads torch.
"""

from __future__ import annotations

import contextlib
import shutil
from collections.abc import Generator, Iterable
from typing import Any

import torch
from torch import nn

from swifttailor.errors import InputError

_COMPILERS = ("g++", "clang++", "c++")
_VARIANTS = 128
"""Translations of the same line of code, of which each layer has its own; torch gives up after 8."""


def compile_layers(layers: Iterable[nn.Module], device: torch.device) -> None:
    """Has layers translated when they are first used, once for inputs of all lengths.

    Args:
        layers: Keep their weights and the names of these.
        device: Where they compute.

    Raises:
        InputError: There is no C++ compiler, which processors need.
    """
    if device.type == "cpu" and not any(map(shutil.which, _COMPILERS)):
        raise InputError(
            f"compiled=true needs a C++ compiler, and none of {', '.join(_COMPILERS)} was found. Install "
            "one, or train with compiled=false."
        )
    settings: Any = torch._dynamo.config
    settings.recompile_limit = max(settings.recompile_limit, _VARIANTS)
    for layer in layers:
        object.__setattr__(layer, "forward", torch.compile(layer.forward, dynamic=True))


@contextlib.contextmanager
def not_compiled() -> Generator[None]:
    """Runs what was compiled operation by operation: for what is too rare to be worth translating."""
    with torch.compiler.set_stance("force_eager"):
        yield
