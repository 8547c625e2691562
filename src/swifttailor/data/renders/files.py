"""The pictures of a split in files: drawn once, several of each garment, as WebP."""

from __future__ import annotations

import hashlib
import io
import json
import zlib
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.arrays import Pixels
from swifttailor.atomic_files import write_text
from swifttailor.body import Body
from swifttailor.data.array_cache import ArrayCache, Arrays
from swifttailor.data.reader import SplitReader
from swifttailor.data.sample import Sample
from swifttailor.data.shard_file import require_checksum
from swifttailor.errors import InputError
from swifttailor.looks.draw import draw_look
from swifttailor.looks.look import VIEWS, random_look
from swifttailor.looks.plain_look import plain_look
from swifttailor.output_folder import LOCK, FolderLock

FOLDER, INDEX = "renders", "renders.json"
FORMAT = "swifttailor renders 1"
MAX_FREE = 64


@dataclass(frozen=True)
class RenderSettings:
    """Which pictures are drawn of each garment."""

    size: int = 256
    """Pixels along each side."""
    random: int = 4
    """Pictures of random looks: front, back, and the others from anywhere."""
    plain: bool = True
    """Whether front and back like those of GarmentCodeData come before them."""
    seed: int = 0
    quality: int = 90
    """Of the compression, 1 to 100."""

    def __post_init__(self) -> None:
        for name, low, high in (("size", 16, 2048), ("random", 0, MAX_FREE), ("quality", 1, 100)):
            value = getattr(self, name)
            if not low <= value <= high:
                raise InputError(f"The {name} of renders must lie between {low} and {high}, got {value}.")
        if not self.random and not self.plain:
            raise InputError("No pictures were asked for: give random looks, plain ones or both.")

    def names(self) -> list[str]:
        """Of the pictures of each garment, in order: plain-front, plain-back, front, back, free-1, ..."""
        views = [*VIEWS[:2], *(f"free-{k}" for k in range(1, self.random - 1))][: self.random]
        return (["plain-front", "plain-back"] if self.plain else []) + views


@dataclass(frozen=True, eq=False)
class Render:
    """One picture of a garment."""

    name: str
    """See `RenderSettings.names`."""
    webp: bytes

    def pixels(self) -> Pixels:
        """(size, size, 3) uint8 sRGB, row 0 at the top."""
        from PIL import Image

        with Image.open(io.BytesIO(self.webp), formats=["WEBP"]) as image:
            return np.array(image.convert("RGB"))


def draw_renders(sample: Sample, settings: RenderSettings) -> list[Render]:
    """Draws the pictures of a sample; the same sample and settings give the same ones."""
    return [draw_render(sample, name, settings) for name in settings.names()]


def draw_render(sample: Sample, name: str, settings: RenderSettings) -> Render:
    """Draws one picture of a sample, as `draw_renders` does.

    Args:
        sample: What to draw.
        name: One of `RenderSettings.names`.
        settings: Their size, seed and quality count.
    """
    from PIL import Image

    if name.startswith("plain-"):
        look = plain_look(name.removeprefix("plain-"))
    else:
        words = zlib.crc32(f"{sample.id}/{name}".encode())
        look = random_look(np.random.default_rng([settings.seed, words]), name.partition("-")[0])
    file = io.BytesIO()
    picture = draw_look(sample.garment, _body(), look, settings.size)
    Image.fromarray(picture).save(file, "WEBP", quality=settings.quality, method=4)
    return Render(name, file.getvalue())


class SplitRenders:
    """The pictures of a split, in the folder renders/ of it."""

    def __init__(self, reader: SplitReader, settings: RenderSettings | None = None) -> None:
        """Opens the pictures of a split, or prepares to draw them.

        Args:
            reader: The split.
            settings: Which pictures to draw; those that were drawn before when None.

        Raises:
            InputError: There are none, or others were drawn before.
        """
        self.folder = reader.folder / FOLDER
        before = _read_index(self.folder / INDEX)
        if settings is None:
            if before is None:
                raise InputError(
                    f"'{reader.folder}' has no renders. Draw them: swifttailor data render {reader.folder}"
                )
            settings = RenderSettings(**before["settings"])
        elif before is not None and before["settings"] != asdict(settings):
            raise InputError(
                f"Other renders were drawn in '{self.folder}': {before['settings']}, now {asdict(settings)}. "
                "Use the same settings, or delete the folder to draw them again."
            )
        self.settings = settings
        self.reader = reader
        self._cache = ArrayCache(reader, self.folder, "renders", partial(_arrays, settings=settings))

    def __len__(self) -> int:
        return len(self.reader)

    def __getitem__(self, k: int) -> list[Render]:
        """The pictures of sample number k.

        Raises:
            InputError: They were not drawn, or their file is damaged.
        """
        path = self._cache.path(self.reader.place(k)[0])
        if not path.is_file():
            raise InputError(
                f"There is no file '{path}'. Draw the missing renders: swifttailor data render DIR"
            )
        arrays = self._cache[k]
        ends = [0, *np.cumsum(arrays["sizes"]).tolist()]
        data = arrays["webp"].tobytes()
        names = self.settings.names()
        return [Render(name, data[a:b]) for name, a, b in zip(names, ends[:-1], ends[1:], strict=True)]

    def draw(self, *, workers: int = 1) -> Iterator[tuple[int, int]]:
        """Draws what is missing; may be stopped and started again.

        Args:
            workers: Processes.

        Yields:
            How many shards are done, and of how many.

        Raises:
            InputError: A sample cannot be read, or a file not written.
        """
        try:
            lock = FolderLock(self.folder, "drawing")
        except OSError as error:
            raise InputError(f"Cannot write to '{self.folder}': {error.strerror or error}.") from error
        with lock:
            before = _read_index(self.folder / INDEX)
            if before is None and any(path.name != LOCK for path in self.folder.iterdir()):
                raise InputError(
                    f"'{self.folder}' is not empty and holds no renders ({INDEX} is missing). "
                    "Move what is in it to another place."
                )
            known = set(before["files"]) if before is not None else set()
            self._save_index(dict.fromkeys(known, ""))
            yield from self._cache.prepare(workers=workers)
            drawn = self._paths()
            for name in known - {path.name for path in drawn}:  # of shards that have been built anew
                (self.folder / name).unlink(missing_ok=True)
            self._save_index({path.name: _sha256(path) for path in drawn})

    def verify(self) -> Iterator[str]:
        """Yields what is wrong with the files."""
        index = _read_index(self.folder / INDEX)
        checksums = {} if index is None else index["files"]
        for path in self._paths():
            try:
                if not checksums.get(path.name):
                    yield f"'{path}' is not in {INDEX}; draw the renders to the end"
                else:
                    require_checksum(path, checksums[path.name])
            except InputError as error:
                yield str(error)
            except OSError as error:
                yield f"Cannot read '{path}': {error.strerror or error}"

    def _paths(self) -> list[Path]:
        shards = self.reader.index.shards
        return [self._cache.path(number) for number, shard in enumerate(shards) if shard.file]

    def _save_index(self, files: dict[str, str]) -> None:
        content = {"format": FORMAT, "settings": asdict(self.settings), "files": files}
        write_text(self.folder / INDEX, json.dumps(content, indent=1) + "\n", overwrite=True)


def _arrays(sample: Sample, settings: RenderSettings) -> Arrays:
    renders = draw_renders(sample, settings)
    return {
        "webp": np.frombuffer(b"".join(r.webp for r in renders), np.uint8),
        "sizes": np.array([len(r.webp) for r in renders], np.int64),
    }


@cache
def _body() -> Body:
    return Body.default()


def _sha256(path: Path) -> str:
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def _read_index(path: Path) -> dict[str, Any] | None:
    if not path.exists():
        return None
    try:
        value = json.loads(path.read_text(encoding="utf-8"))
        if value["format"] != FORMAT or not isinstance(value["files"], dict):
            raise ValueError("another format")
        RenderSettings(**value["settings"])
        return value
    except (OSError, ValueError, KeyError, TypeError, RecursionError) as error:
        raise InputError(
            f"'{path}' is damaged: {error}. Delete its folder to draw the renders again."
        ) from error
