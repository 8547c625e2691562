"""The process that feeds inputs to a reader, and may die of it: ``python -m fuzzing.worker JOB``.

Each input has so much processor time and memory. Processor time is kept by the kernel's own timer, whose
signal ends the process also inside compiled code; memory by a limit on the address space and by looking at
what was used after each input. What ends the process is told by its parent (`fuzzing.campaign`).
"""

from __future__ import annotations

import base64
import faulthandler
import json
import os
import resource
import signal
import sys
import tempfile
import traceback
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from fuzzing.failure import signature_of
from fuzzing.registry import targets_in
from fuzzing.shrinking import shrunk
from fuzzing.tally import SharedTally, Tally
from fuzzing.target import Feed, File, Target

_LONGEST_MESSAGE = 2000
_WARM_UPS = 3
_KIB = 1 if sys.platform != "darwin" else 1 / 1024


@dataclass(frozen=True)
class Job:
    """What a worker does: the numbers of a seed, or files."""

    module: str
    target: str
    tally: str
    first: int
    end: int
    seed: int = 0
    files: tuple[str, ...] = ()
    """Kept inputs, in place of fresh ones; numbers are places in this list."""
    known: tuple[str, ...] = ()
    """Signatures of which there are enough small inputs."""

    def to_json(self) -> str:
        """For the command line."""
        return json.dumps(asdict(self))


def main() -> None:
    """Does the job in the only argument, and tells of failures on standard output, one JSON object a line."""
    job = Job(**json.loads(sys.argv[1]))
    events = os.fdopen(os.dup(1), "w", buffering=1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    faulthandler.enable()

    def tell(event: dict[str, Any]) -> None:
        events.write(json.dumps(event) + "\n")

    target = targets_in(job.module)[job.target]
    with tempfile.TemporaryDirectory(prefix="fuzzing-", dir=_memory_disk()) as folder:
        _work(job, target, Path(folder), tell)


def _memory_disk() -> str | None:
    return "/dev/shm" if os.access("/dev/shm", os.W_OK) else None


def _work(job: Job, target: Target, folder: Path, tell: Callable[[dict[str, Any]], None]) -> None:
    parent = os.getppid()
    feed = target.load_feed()
    for file in target.seeds[:_WARM_UPS]:
        feed(_placed(file, folder))
    faulthandler.register(signal.SIGPROF, chain=True)  # says where the time went, then ends the process
    _limit_memory(target.megabytes)
    tally = SharedTally(Path(job.tally))
    accepted = refused = failed = 0
    known = set(job.known)
    for number in range(job.first, job.end):
        if os.getppid() != parent:
            return  # nobody is left to count
        tally.write(Tally(number, accepted, refused, failed))
        file = target.kept(Path(job.files[number])) if job.files else target.input(job.seed, number)
        outcome = _fed(feed, target, _placed(file, folder))
        if outcome is None or outcome is True:
            accepted, refused = accepted + (outcome is None), refused + (outcome is True)
            continue
        failed += 1
        tell({"number": number, **outcome})
        signature = outcome["signature"]
        if signature not in known and not job.files:
            known.add(signature)

            def fails_alike(data: bytes, ending: str = file.ending, wanted: str = signature) -> bool:
                found = _fed(feed, target, _placed(File(data, ending), folder))
                return isinstance(found, dict) and found["signature"] == wanted

            small = shrunk(file.data, fails_alike)
            tell({"number": number, "signature": signature, "shrunk": base64.b64encode(small).decode()})
    tally.write(Tally(job.end, accepted, refused, failed))


def _placed(file: File, folder: Path) -> Path:
    path = folder / f"input{file.ending}"
    path.unlink(missing_ok=True)  # whatever still has the last one mapped into memory keeps that
    path.write_bytes(file.data)
    return path


def _fed(feed: Feed, target: Target, path: Path) -> dict[str, str] | bool | None:
    """None: accepted; True: refused; otherwise what went wrong."""
    from swifttailor.errors import SwiftTailorError

    before = _most_memory()
    signal.setitimer(signal.ITIMER_PROF, target.seconds)
    try:
        feed(path)
        refused = None
    except SwiftTailorError as error:
        refused = error
    except BaseException as error:
        return {
            "signature": signature_of(error),
            "detail": "".join(traceback.format_exception(error))[-8000:],
        }
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
    if (grown := _most_memory() - before) > target.megabytes:
        return {"signature": "memory", "detail": f"{grown:.0f} MB; {target.megabytes} are allowed"}
    if refused is None:
        return None
    text = str(refused)
    if not text or len(text) > _LONGEST_MESSAGE:
        return {"signature": "message", "detail": f"{len(text)} characters: {text[:300]}"}
    return True


def _most_memory() -> float:
    """The most memory that this process has used so far, MB."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * _KIB / 1024


def _limit_memory(megabytes: int) -> None:
    """Refuses this process more address space than it has now and twice what one input may take."""
    status = Path("/proc/self/status")
    if not status.exists():
        return  # elsewhere than on Linux, what was used is looked at after each input
    line = next(line for line in status.read_text().splitlines() if line.startswith("VmSize:"))
    now = int(line.split()[1]) * 1024
    resource.setrlimit(resource.RLIMIT_AS, (now + 2 * megabytes * 2**20,) * 2)


if __name__ == "__main__":
    main()
