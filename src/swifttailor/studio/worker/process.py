"""The life of a worker process: it takes tasks by name, and says what becomes of them."""

from __future__ import annotations

import logging
import os
import signal
import threading
from multiprocessing import parent_process
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

READY = "ready"
_PATIENCE = 8


def live(connection: Connection, warm: bool, patient: bool, bodies: Path | None = None) -> None:
    """Works until the server goes.

    Args:
        connection: To the server. Tasks come as (name, arguments), a request to stop as None; what is said of
            them are tuples: ("stage", name, share), ("meshes", records), ("frame", mesh, bytes), and last
            ("done", answer, records), ("stopped", answer, records) or ("refused", error).
        warm: Whether networks are loaded before the first task.
        patient: Whether it gives way to others where processors are short.
        bodies: Folder of the body meshes that people have loaded.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the server decides what Ctrl-C means
    threading.Thread(target=_end_with_parent, daemon=True).start()
    _die_first_without_memory()
    if patient and hasattr(os, "nice"):
        os.nice(_PATIENCE)
    logging.basicConfig(level=logging.WARNING)
    from swifttailor.studio.bench.own_bodies import keep_in
    from swifttailor.studio.bench.tasks import TASKS, warm_up

    keep_in(bodies)
    if warm:
        warm_up()
    connection.send((READY,))
    while True:
        try:
            task = connection.recv()
        except (EOFError, OSError):
            return
        if task is None:  # the task that was to be stopped had ended already
            continue
        name, arguments = task
        try:
            connection.send(_outcome(TASKS[name], arguments, connection))
        except (BrokenPipeError, OSError):
            return


def _outcome(function: Any, arguments: dict[str, Any], connection: Connection) -> tuple[Any, ...]:
    from swifttailor.studio.worker.link import Link, StoppedError
    from swifttailor.studio.worker.refusal import refusal_of

    def stop_asked() -> bool:
        if not connection.poll():
            return False
        return connection.recv() is None

    link = Link(connection.send, stop_asked)
    try:
        work = function(link, **arguments)
    except StoppedError:
        return ("stopped", None, ())
    except Exception as error:
        refusal = refusal_of(error)
        if refusal["code"] == "internal":
            logging.exception("A task of the studio failed.")
        return ("refused", refusal)
    return ("stopped" if work.stopped else "done", work.answer, work.meshes)


def _end_with_parent() -> None:
    parent = parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _die_first_without_memory() -> None:
    """Where memory runs out, Linux ends a worker and not the server."""
    try:
        Path("/proc/self/oom_score_adj").write_text("1000")
    except OSError:
        pass
