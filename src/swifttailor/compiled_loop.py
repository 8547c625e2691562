"""Loops that numba has compiled once, run from their machine code: loading numba takes half a second.

The machine code is kept beside numba's own cache and linked by LLVM (llvmlite, which numba is built on).
A loop is called as numba calls it: each array as its data, shape and strides, each tuple as what it holds.
It returns nothing and allocates nothing; what it fills, and works with, is given to it.
"""

from __future__ import annotations

import ctypes
import hashlib
import os
import sys
from collections.abc import Callable
from contextlib import suppress
from functools import cache, cached_property
from importlib import import_module
from importlib.metadata import version
from importlib.util import find_spec
from itertools import count
from pathlib import Path
from threading import Lock
from typing import Any

import numpy as np

from swifttailor.atomic_files import write_atomically
from swifttailor.errors import SwiftTailorError
from swifttailor.postponed_module import postponed

ENDING = ".loop"
_FORMAT = b"1"
TESTED_NUMBA = (0, 68), (0, 69)
"""The first version of numba that this has been tested with, and the first that it has not: other versions
run their loops themselves."""
_DONE = (0, -2)
"""What numba's functions return that have nothing to return, when nothing went wrong."""
_CALLED_BY_PYTHON = (
    "NRT_Free",
    "NRT_MemInfo_alloc_aligned",
    "NRT_MemInfo_call_dtor",
    "NRT_adapt_ndarray_from_python",
    "numba_do_raise",
    "numba_gil_ensure",
    "numba_gil_release",
    "numba_runtime_build_excinfo_struct",
    "numba_unpickle",
)
"""Functions of numba's in the wrappers by which Python calls a loop, which are linked and never run."""
_libraries = count()
_linking = Lock()


class CompiledLoop:
    """A function of a module of kernels, compiled on first use and kept."""

    def __init__(self, module: str, function: str) -> None:
        """Names the function; nothing is loaded.

        Args:
            module: Full name. All files named ``*_kernels.py`` and ``compile_options.py`` beside it decide
                what its loops do.
            function: Compiled by ``numba.njit``.
        """
        self.module, self.function = module, function
        self._linked: dict[str, Callable[..., int] | None] = {}

    def __call__(self, *arguments: Any) -> None:
        """Runs the loop.

        Args:
            arguments: Arrays, int, float, bool, and tuples of them.
        """
        kinds: list[str] = []
        values: list[Any] = [ctypes.byref(ctypes.c_void_p()), ctypes.byref(ctypes.c_void_p())]
        for argument in arguments:
            _flatten(argument, kinds, values)
        signature = " ".join(kinds)
        if signature not in self._linked:
            with _linking:
                if signature not in self._linked:
                    self._linked[signature] = self._link(signature, arguments)
        run = self._linked[signature]
        status = run(*values) if run is not None else self._by_numba(*arguments)
        if status not in _DONE:
            raise RuntimeError(f"{self.module}.{self.function} ended with the status {status}.")

    def kept_in(self, folder: Path, signature: str) -> Path:
        """Where the machine code for a signature is kept in one of numba's folders."""
        name = hashlib.sha256(f"{self._state}\n{signature}".encode()).hexdigest()[:32]
        return folder / f"{self.module.rpartition('.')[2]}.{self.function}-{name}{ENDING}"

    def _link(self, signature: str, arguments: tuple[Any, ...]) -> Callable[..., int] | None:
        """What runs the loop; None where numba has to: its code cannot stand alone, or numba is untested."""
        if not _numba_is_tested():
            return None
        for folder in cache_folders(self._source):
            if code := _read(self.kept_in(folder, signature)):
                return _linked(*code)
        code = self._compiled(arguments)
        if code is None:
            return None
        try:
            run = _linked(*code)
        except RuntimeError:  # it calls for something that only numba has
            return None
        symbol, machine_code = code
        content = f"{hashlib.sha256(machine_code).hexdigest()}\n{symbol}\n".encode() + machine_code
        path = self.kept_in(Path(self._loop.stats.cache_path), signature)
        with suppress(SwiftTailorError):  # a full disk: the next program compiles it again
            write_atomically(path, lambda temporary: temporary.write_bytes(content), overwrite=True)
        return run

    def _compiled(self, arguments: tuple[Any, ...]) -> tuple[str, bytes] | None:
        """Symbol and machine code; None where this numba does not tell."""
        import numba

        types = tuple(numba.typeof(a) for a in arguments)
        loop = self._loop
        loop.compile(types)
        if sum(loop.stats.cache_hits.values()):
            # numba has handed on what it had kept, which may be older than the functions that it calls.
            loop = numba.jit(**loop.targetoptions)(loop.py_func)
            loop.compile(types)
        compiled = loop.overloads[types]
        tell = getattr(compiled.library, "serialize_using_object_code", None)
        if tell is None:
            return None
        _, _, (code, _) = tell()
        return compiled.fndesc.llvm_func_name, code

    def _by_numba(self, *arguments: Any) -> int:
        self._loop(*arguments)
        return _DONE[0]

    @property
    def _loop(self) -> Any:
        """As numba knows it."""
        return getattr(import_module(self.module), self.function)

    @cached_property
    def _source(self) -> Path:
        spec = find_spec(self.module)
        assert spec is not None and spec.origin is not None
        return Path(spec.origin)

    @cached_property
    def _state(self) -> str:
        """All that the machine code follows from, but for the arguments' types."""
        digest = hashlib.sha256(_FORMAT + _machine())
        folder = self._source.parent
        for path in sorted([*folder.glob("*_kernels.py"), *folder.glob("compile_options.py")]):
            digest.update(path.name.encode() + path.read_bytes())
        return digest.hexdigest()


def cache_folders(source: Path) -> list[Path]:
    """Where numba may keep what it compiles of a source file; what it would use first comes first."""
    folder = os.path.abspath(source.parent)
    own = f"{source.parent.name}_{hashlib.sha1(folder.encode(), usedforsecurity=False).hexdigest()}"
    if chosen := os.environ.get("NUMBA_CACHE_DIR"):
        return [Path(chosen) / own]
    shared = Path(os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache"))
    return [source.parent / "__pycache__", shared / "numba" / own]


def _flatten(value: Any, kinds: list[str], values: list[Any]) -> None:
    """Appends what a loop is told of a value, and how numba tells such values apart."""
    if isinstance(value, np.ndarray):
        order = "C" if value.flags.c_contiguous else "F" if value.flags.f_contiguous else "A"
        state = f"{'' if value.flags.writeable else 'r'}{'' if value.flags.aligned else 'u'}"
        kinds.append(f"{value.dtype.str}{value.ndim}{order}{state}")
        values += [None, None, ctypes.c_int64(value.size), ctypes.c_int64(value.itemsize)]
        values.append(ctypes.c_void_p(value.ctypes.data))
        values += [ctypes.c_int64(n) for n in (*value.shape, *value.strides)]
    elif isinstance(value, tuple):
        kinds.append(f"{type(value).__name__}{len(value)}")
        for one in value:
            _flatten(one, kinds, values)
    elif isinstance(value, bool):
        kinds.append("b")
        values.append(ctypes.c_bool(value))
    elif isinstance(value, int):
        kinds.append("i")
        values.append(ctypes.c_int64(value))
    elif type(value) is float:
        kinds.append("f")
        values.append(ctypes.c_double(value))
    else:
        raise TypeError(
            f"A compiled loop takes arrays, int, float, bool and tuples, got {type(value).__name__}."
        )


def _read(path: Path) -> tuple[str, bytes] | None:
    """Symbol and machine code, unless there is no such file or it is damaged."""
    try:
        digest, symbol, code = path.read_bytes().split(b"\n", 2)
    except (OSError, ValueError):
        return None
    return (symbol.decode(), code) if hashlib.sha256(code).hexdigest().encode() == digest else None


@cache
def _numba_is_tested() -> bool:
    major, minor = (int(n) for n in version("numba").split(".")[:2])
    first, beyond = TESTED_NUMBA
    return first <= (major, minor) < beyond


@cache
def _llvm() -> Any:
    """What links; the classes for writing programs, which take longer to load, only if used."""
    postponed("llvmlite.ir")
    return import_module("llvmlite.binding")


@cache
def _machine() -> bytes:
    llvm = _llvm()

    features = llvm.get_host_cpu_features().flatten()
    parts = (version("numba"), version("llvmlite"), sys.platform, llvm.get_host_cpu_name(), features)
    return "\n".join(parts).encode()


@cache
def _linker() -> Any:
    llvm = _llvm()

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    return llvm.create_lljit_compiler(suppress_errors=True)


def _linked(symbol: str, code: bytes) -> Callable[..., int]:
    """What runs machine code; Python's lock is free meanwhile.

    Raises:
        RuntimeError: It calls for something that is not there.
    """
    llvm = _llvm()

    linker = _linker()
    stop = ctypes.cast(ctypes.pythonapi.Py_FatalError, ctypes.c_void_p).value
    library = llvm.JITLibraryBuilder().add_object_img(code).add_current_process().export_symbol(symbol)
    for name in _CALLED_BY_PYTHON:
        library = library.import_symbol(name, stop)
    tracker = library.link(linker, f"loop-{next(_libraries)}")
    function = ctypes.CFUNCTYPE(ctypes.c_int32)(tracker[symbol])
    _kept_loaded.append(tracker)
    return function


_kept_loaded: list[Any] = []
"""What keeps the machine code in memory."""
