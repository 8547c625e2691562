"""The task that takes in a body mesh: bounded before and while it is read, for it may come from anybody."""

from __future__ import annotations

import json
import struct
from collections import Counter
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from swifttailor.body import Body
from swifttailor.body.mesh_files import FORMATS
from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.studio.bench.documents import Work
from swifttailor.studio.bench.own_bodies import own_bodies
from swifttailor.studio.bench.wearer_options import measures_of_mesh
from swifttailor.studio.worker.link import Link

MOST_FACES = 200_000
_MOST_BYTES = 768 * 2**20
"""Of memory beyond what the process has, while a file is read."""
_MOST_JSON = 4 * 2**20
_MOST_NODES = 1000
_MOST_NUMBERS = 20_000_000
_FEWER = "Decimate it: 30,000 faces are plenty."


def take_in(link: Link, *, file_name: str, content: bytes) -> Work:
    """A body mesh, set upright on the floor, measured and kept.

    Args:
        link: To the server.
        file_name: Tells the format; what the body is called.
        content: Of the file.

    Raises:
        InputError: It is no body, or asks for more than a body needs.
    """
    place = Path(file_name.replace("\\", "/"))
    ending = place.suffix.lower()
    if ending not in FORMATS:
        raise InputError(f"A body mesh ends in {', '.join(FORMATS)}.")
    if ending == ".glb":
        require_plain_glb(content)
    with TemporaryDirectory(prefix="swifttailor-studio-") as folder:
        path = Path(folder) / f"{_plain_name(place.stem)}{ending}"
        path.write_bytes(content)
        try:
            with memory_bounded():
                body = Body.load(path)
        except SwiftTailorError as error:
            raise InputError(str(error).replace(f"'{path}'", "The file").replace(str(path), "it")) from None
        except MemoryError:
            raise InputError(f"Reading the file takes too much memory. {_FEWER}") from None
    if len(body.faces) > MOST_FACES:
        raise InputError(
            f"The body has {len(body.faces):,} faces; at most {MOST_FACES:,} are accepted. {_FEWER}"
        )
    name = own_bodies().add(body)
    return Work(
        {
            "body": name,
            "name": body.name,
            "vertices": len(body.vertices),
            "faces": len(body.faces),
            "measures": measures_of_mesh(body),
        }
    )


def require_plain_glb(content: bytes) -> None:
    """Refuses a binary glTF that refers to other files, or promises more than it holds.

    Raises:
        InputError: It does, or is no binary glTF.
    """
    try:
        magic, _, _, length, kind = struct.unpack_from("<4sIII4s", content)
        if magic != b"glTF" or kind != b"JSON" or length > min(_MOST_JSON, len(content)):
            raise ValueError("no glTF")
        told = json.loads(content[20 : 20 + length])
        accessors, buffers, views, nodes = (
            list(told.get(name, [])) for name in ("accessors", "buffers", "bufferViews", "nodes")
        )
        numbers = sum(int(each["count"]) for each in accessors)
        whole = all(int(each["count"]) >= 0 and "bufferView" in each for each in accessors)
        inside = not any("uri" in each for each in [*buffers, *told.get("images", [])])
        parents = Counter(child for node in nodes for child in node.get("children", []))
        sizes = sum(int(each["byteLength"]) for each in views)
    except (ValueError, KeyError, TypeError, AttributeError, struct.error, RecursionError) as error:
        raise InputError("The file is no binary glTF (GLB). Export the body again.") from error
    if not inside:
        raise InputError("The file refers to other files. Export the body as one GLB file, without textures.")
    if not whole or numbers > _MOST_NUMBERS or sizes > 4 * len(content):
        raise InputError(f"The file promises more than it holds. Export the body again. {_FEWER}")
    if len(nodes) > _MOST_NODES or any(count > 1 for count in parents.values()):
        raise InputError("The file has too many parts. Export the body alone, as one mesh.")


@contextmanager
def memory_bounded(more: int = _MOST_BYTES) -> Generator[None]:
    """Lets allocations fail that go so far beyond what the process has, where the system can do that.

    Args:
        more: Bytes.
    """
    try:
        import resource

        pages = int(Path("/proc/self/statm").read_text().split()[0])
    except (ImportError, OSError, ValueError):
        yield
        return
    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    most = pages * resource.getpagesize() + more
    if hard != resource.RLIM_INFINITY:
        most = min(most, hard)
    resource.setrlimit(resource.RLIMIT_AS, (most, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, (soft, hard))


def _plain_name(stem: str) -> str:
    """A file's name that is safe everywhere, and a body's for people."""
    kept = "".join(letter if letter.isalnum() or letter in "-_ " else "-" for letter in stem)
    return kept.strip("- ")[:60] or "body"
