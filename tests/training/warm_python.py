"""An interpreter that has torch and its like loaded already: a stand-in for `$PYTHON` in recipes.

A rehearsal starts some fifty commands, most of which compute for less time than torch takes to load. One
process loads what is not ours, and forks for each command; our own modules are loaded anew in each, as usual.
"""

from __future__ import annotations

import atexit
import contextlib
import gc
import importlib
import json
import os
import runpy
import shlex
import socket
import struct
import subprocess
import sys
import time
import traceback
from collections.abc import Iterator
from pathlib import Path

LOADED = (
    *("torch", "torch._dynamo", "torch.onnx", "torch.export", "torch.utils.data", "torch.distributed"),
    *("onnx", "onnxscript", "onnxruntime", "numba", "safetensors.numpy", "scipy.spatial", "scipy.optimize"),
    *("scipy.sparse.linalg", "scipy.ndimage", "shapely", "trimesh", "PIL.Image", "PIL.ImageDraw", "tyro"),
    *("rich.progress", "rich.table", "yaml", "multiprocessing.spawn", "multiprocessing.resource_tracker"),
)
STARTING_S = 300
"""Within which it is loaded, on a machine that is shared by many."""
LENGTH = struct.Struct("!I")


@contextlib.contextmanager
def warm_python(folder: Path, environment: dict[str, str]) -> Iterator[str]:
    """Gives the path of a program that takes Python's arguments, in the environment of who calls it."""
    address, program = folder / "warm.socket", folder / "python"
    program.write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)} -ISu {__file__} {address} "$@"\n')
    program.chmod(0o755)
    server = subprocess.Popen([sys.executable, __file__, "--serve", str(address)], env=environment)
    try:
        end = time.monotonic() + STARTING_S
        while not address.exists():
            assert server.poll() is None and time.monotonic() < end, "it was not loaded"
            time.sleep(0.05)
        yield str(program)
    finally:
        server.kill()
        server.wait()


def ask(address: str, arguments: list[str]) -> int:
    """Has a command run, and gives its exit code."""
    with socket.socket(socket.AF_UNIX) as asking:
        asking.connect(address)
        asked = {"arguments": arguments, "folder": os.getcwd(), "environment": dict(os.environ)}
        text = json.dumps(asked).encode()
        socket.send_fds(asking, [LENGTH.pack(len(text))], [0, 1, 2])
        asking.sendall(text)
        (code,) = LENGTH.unpack(received(asking, LENGTH.size))
    return code


def received(sent: socket.socket, size: int) -> bytes:
    parts = b""
    while len(parts) < size:
        part = sent.recv(size - len(parts))
        if not part:
            raise ConnectionError("the other end is gone")
        parts += part
    return parts


def serve(address: str) -> None:
    for name in LOADED:
        importlib.import_module(name)
    gc.freeze()
    with socket.socket(socket.AF_UNIX) as listening:
        # Under its name only once it listens.
        listening.bind(f"{address}.new")
        listening.listen()
        os.rename(f"{address}.new", address)
        while True:
            asking, _ = listening.accept()
            with asking:
                head, descriptors, _, _ = socket.recv_fds(asking, LENGTH.size, 3)
                asked = json.loads(received(asking, *LENGTH.unpack(head)))
                child = os.fork()
                if child == 0:
                    listening.close()
                    asking.close()
                    for k, descriptor in enumerate(descriptors):
                        os.dup2(descriptor, k)
                        os.close(descriptor)
                    run(**asked)
                for descriptor in descriptors:
                    os.close(descriptor)
                _, status = os.waitpid(child, 0)
                code = os.waitstatus_to_exitcode(status)
                asking.sendall(LENGTH.pack(code if code >= 0 else 128 - code))


def run(arguments: list[str], folder: str, environment: dict[str, str]) -> None:
    """As Python does, and ends the process; never returns."""
    os.chdir(folder)
    os.environ.clear()
    os.environ.update(environment)
    # The streams that were inherited know what their files could do, not what these can.
    sys.stdin = open(0, closefd=False)
    sys.stdout = open(1, "w", closefd=False)
    sys.stderr = open(2, "w", buffering=1, closefd=False)
    code = 1
    try:
        if arguments[0] == "-m":
            sys.argv = arguments[1:]
            sys.path[0] = folder
            runpy.run_module(arguments[1], run_name="__main__", alter_sys=True)
        else:
            assert not arguments[0].startswith("-"), f"no stand-in for {arguments}"
            sys.argv = arguments
            sys.path[0] = str(Path(arguments[0]).resolve().parent)
            runpy.run_path(arguments[0], run_name="__main__")
        code = 0
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else int(end.code is not None)
        if isinstance(end.code, str):
            sys.stderr.write(f"{end.code}\n")
    except BaseException:
        traceback.print_exc()
    # As at the end of any process; that of a fork would otherwise return into the loop that answers.
    atexit._run_exitfuncs()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)


if __name__ == "__main__":
    if sys.argv[1] == "--serve":
        serve(sys.argv[2])
    else:
        sys.exit(ask(sys.argv[1], sys.argv[2:]))
