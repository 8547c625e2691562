"""The studio without the web: workers, queue, meshes, pictures, projects."""

from __future__ import annotations

import asyncio
import importlib.util
from pathlib import Path
from typing import Any, get_args

from swifttailor import __version__
from swifttailor.studio.app.limits import ServerLimits
from swifttailor.studio.jobs import JobQueue
from swifttailor.studio.mesh_record import MeshRecord
from swifttailor.studio.mesh_store import MeshStore
from swifttailor.studio.models.base import FabricName
from swifttailor.studio.pictures import PictureStore
from swifttailor.studio.project_store import BODIES, ProjectStore
from swifttailor.studio.shipped import shipped_examples, shipped_options
from swifttailor.studio.worker.handle import Result, Worker
from swifttailor.studio.worker.lane import LiveLane, QuickLane

_PATIENCE = {"fit": 3.0}
"""Times the usual limit: the first fit on a machine compiles, and each new body is measured."""
_FIRST_PAGE_SECONDS = 0.5
"""That a browser has the processors for itself, about."""
_FORMATS = (
    ("json", "GarmentCode pattern", "pattern"),
    ("svg", "pattern drawing in true size", "pattern"),
    ("pdf", "pattern to print on A4, with allowances and steps", "pattern"),
    ("dxf", "pattern for cutting rooms, ASTM D6673", "pattern"),
    ("md", "sewing steps", "pattern"),
    ("clo", "pattern for CLO and Style3D, zipped", "pattern"),
    ("glb", "garment, glTF binary", "garment"),
    ("obj", "garment, Wavefront OBJ", "garment"),
    ("ply", "garment, PLY", "garment"),
    ("stl", "garment, STL", "garment"),
    ("usdz", "garment, USD in one file", "garment"),
    ("usda", "garment, USD as text, without its print", "garment"),
    ("png", "picture of the garment: front, back and side", "garment"),
    ("zip", "everything in one file", "both"),
)

_EXTRAS = (("pdf", "PDF", "print"), ("usdz", "USD", "usd"))
"""Formats that need an extra."""


class Studio:
    """All that a server has; made and used on one event loop."""

    def __init__(self, projects: Path, limits: ServerLimits | None = None) -> None:
        """Nothing is started yet.

        Args:
            projects: Folder of the projects.
            limits: What is refused beyond.
        """
        self.limits = limits = limits or ServerLimits()
        self.meshes = MeshStore(limits.mesh_bytes)
        bodies = projects / BODIES
        self.live = LiveLane(
            Worker(bodies=bodies), most_clients=limits.live_clients, time_limit=limits.live_seconds
        )
        self.quick = QuickLane(
            Worker(warm=False, bodies=bodies),
            most_waiting=limits.quick_waiting,
            time_limit=limits.quick_seconds,
        )
        self.jobs = JobQueue(
            Worker(patient=True, bodies=bodies),
            self.meshes,
            most_waiting=limits.queue,
            time_limit=limits.job_seconds,
        )
        self.pictures = PictureStore(limits.files)
        self.projects = ProjectStore(projects)
        self.saving = asyncio.Lock()
        self._starting: asyncio.Future[None] | None = None
        self.streams = 0
        """Event streams that are open."""

    @property
    def workers(self) -> tuple[Worker, Worker, Worker]:
        """Of live sewing, quick work and jobs."""
        return self.live.worker, self.quick.worker, self.jobs.worker

    async def start(self) -> None:
        """Begins to start the workers, one after the other, when the first page is through."""
        self._starting = asyncio.ensure_future(self._start())

    async def _start(self) -> None:
        await asyncio.sleep(_FIRST_PAGE_SECONDS)
        for worker in self.workers:
            worker.start()
            await worker.wait_until_ready()

    async def close(self) -> None:
        """Ends the workers, once what is being saved is saved."""
        if self._starting is not None:
            self._starting.cancel()
        async with self.saving:
            for worker in self.workers:
                worker.close()

    async def do(self, name: str, **arguments: Any) -> Any:
        """Quick work: the answer, its meshes kept.

        Raises:
            BusyError: Too much waits.
            RefusedError: It was refused, or took too long.
        """
        patience = _PATIENCE.get(name, 1.0)
        return self.keep(await self.quick.run(name, arguments, patience=patience)).answer

    def keep(self, result: Result) -> Result:
        """Keeps the meshes of a result."""
        for record in result.meshes:
            self.meshes.add(record)
        return result

    def mesh(self, name: str | None) -> MeshRecord | None:
        """A mesh by its name, where it is there."""
        if name is None:
            return None
        found = self.meshes.find(name)
        if found is None:
            found = next((e.mesh for e in shipped_examples().values() if e.document["mesh"] == name), None)
        return found

    def formats(self) -> list[dict[str, str]]:
        """What can be exported here, `models.projects.FormatInfo`."""
        has_usd = importlib.util.find_spec("pxr") is not None
        has_pdf = importlib.util.find_spec("reportlab") is not None
        return [
            {"name": name, "about": about, "of": of}
            for name, about, of in _FORMATS
            if (has_usd or not name.startswith("usd")) and (has_pdf or name != "pdf")
        ]

    def state(self) -> dict[str, Any]:
        """What clients learn first, `models.projects.State`."""
        options, formats = shipped_options(), self.formats()
        written = {one["name"] for one in formats}
        missing = [(name, extra) for kind, name, extra in _EXTRAS if kind not in written]
        notices = []
        if missing:
            names, extras = " and ".join(name for name, _ in missing), ",".join(extra for _, extra in missing)
            notices.append(f"{names} files are off. To have them: pip install 'swifttailor[{extras}]'")
        return {
            "version": __version__,
            "limits": self.limits.to_json(options["of_patterns"]),
            "units": ["cm", "in"],
            "examples": [example.to_json() for example in shipped_examples().values()],
            "projects": self.projects.summaries(),
            "claims": options["claims"],
            "dimensions": options["dimensions"],
            "fabrics": list(get_args(FabricName)),
            "formats": formats,
            "body": options["body"],
            "wearers": options["wearers"],
            "ready": all(worker.ready for worker in self.workers),
            "notices": notices,
        }
