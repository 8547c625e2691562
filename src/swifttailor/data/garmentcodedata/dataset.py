"""The folders of GarmentCodeData: which samples there are, what failed, and the official splits.

``garments_5000_0/default_body/rand_XXXXXXXXXX/rand_XXXXXXXXXX_specification.json`` and so on; beside the
folder of each body ``dataset_properties_default_body.yaml`` with the names of what failed in the simulation.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Any, Literal

from swifttailor.data.garmentcodedata.yaml_file import read_yaml_mapping
from swifttailor.errors import InputError
from swifttailor.pattern.json_values import as_list, as_object, read_json_file

BodyKind = Literal["default", "random"]
BODIES: tuple[BodyKind, ...] = ("default", "random")
_SPLITS = {
    "train": "train", "training": "train",
    "validation": "validation", "valid": "validation", "val": "validation",
    "test": "test",
}  # fmt: skip
_MAX_SAMPLES = 1_000_000


@dataclass(frozen=True)
class SampleFolder:
    """One garment of the data set."""

    root: Path
    """Of the data set."""
    path: str
    """Relative to it: ``garments_5000_0/default_body/rand_0AYBT68CX6``."""
    failures: tuple[str, ...] = field(default=(), compare=False)
    """Under which failures of the simulation the data set lists it."""

    @property
    def name(self) -> str:
        """Name of the garment, and start of the names of its files."""
        return PurePosixPath(self.path).name

    @property
    def body(self) -> BodyKind:
        """What it is draped on: the default body, or one of 5,000 random ones."""
        return "random" if "random_body" in PurePosixPath(self.path).parts else "default"

    def file(self, ending: str) -> Path:
        """One of its files: `specification.json`, `sim.ply`, `render_front.png`, ..."""
        return self.root / self.path / f"{self.name}_{ending}"

    def design(self) -> dict[str, Any]:
        """GarmentCode's design parameters, as they are in `design_params.yaml`.

        Raises:
            InputError: The file is missing or damaged.
        """
        content = read_yaml_mapping(self.file("design_params.yaml"))
        return dict(content.get("design", content))

    def measurements(self) -> dict[str, float]:
        """The body's measurements, cm and degrees.

        Raises:
            InputError: The file is missing or damaged.
        """
        content = self._measurement_values()
        return {
            k: float(v) for k, v in content.items() if isinstance(v, int | float) and not isinstance(v, bool)
        }

    def body_mesh(self, bodies: Path) -> Path:
        """The mesh of the body that it was draped on, in metres.

        Args:
            bodies: The folder that holds `5000_body_shapes_and_measures` and `neutral_body`.

        Raises:
            InputError: The measurements do not name a body.
        """
        if self.body == "default":
            return bodies / "neutral_body" / "mean_all.obj"
        name = self._measurement_values().get("body_sample")
        if not isinstance(name, str) or not name or set(name) & set("/\\"):
            raise InputError(
                f"'{self.file('body_measurements.yaml')}' does not say which body was used (body_sample)."
            )
        return bodies / "5000_body_shapes_and_measures" / "meshes" / f"{name}.obj"

    def _measurement_values(self) -> Mapping[str, Any]:
        content = read_yaml_mapping(self.file("body_measurements.yaml"))
        inner = content.get("body", content)
        return inner if isinstance(inner, Mapping) else content


class GarmentCodeData:
    """A download of GarmentCodeData, or a part of one."""

    def __init__(self, root: Path | str) -> None:
        """Opens the data set.

        Args:
            root: The folder with `garments_5000_0` and so on, or one of those.

        Raises:
            InputError: It holds no such folder.
        """
        self.root = Path(root)
        if self.root.name.startswith("garments_5000") and self._bodies_in(self.root):
            self.root = self.root.parent
            self._batches = [Path(root).name]
        else:
            self._batches = sorted(
                (p.name for p in self.root.glob("garments_5000*") if p.is_dir()), key=_number
            )
        if not self._batches:
            raise InputError(
                f"'{self.root}' holds no GarmentCodeData: it has no folder garments_5000_0 or the like."
            )

    def samples(self, body: BodyKind = "default", *, with_failures: bool = False) -> Iterator[SampleFolder]:
        """Goes through the garments in the order of their folders.

        Args:
            body: What they are draped on.
            with_failures: Also those that the data set lists as failures of its simulation.

        Raises:
            InputError: A list of failures cannot be read.
        """
        for batch in self._batches:
            failures = self._failures(batch, body)
            folder = self.root / batch / f"{body}_body"
            for path in sorted(p.name for p in folder.iterdir() if p.is_dir()) if folder.is_dir() else ():
                found = tuple(failures.get(path, ()))
                if (self.root / batch / f"{body}_body" / path / f"{path}_specification.json").is_file() and (
                    with_failures or not found
                ):
                    yield SampleFolder(self.root, f"{batch}/{body}_body/{path}", found)

    def sample(self, path: str) -> SampleFolder:
        """The garment of a relative path, as in the official split lists.

        Raises:
            InputError: It is not there.
        """
        place = PurePosixPath(path)
        if place.is_absolute() or ".." in place.parts or not (self.root / place).is_dir():
            raise InputError(f"There is no garment '{path}' in '{self.root}'.")
        body: BodyKind = "random" if "random_body" in place.parts else "default"
        found = self._failures(place.parts[0], body).get(place.name, ())
        return SampleFolder(self.root, place.as_posix(), tuple(found))

    def _failures(self, batch: str, body: BodyKind) -> dict[str, list[str]]:
        """Kinds of failure by the garment's name; empty where the data set has no such list."""
        name = f"dataset_properties_{body}_body.yaml"
        path = next(
            (p for p in (self.root / batch / name, self.root / batch / f"{body}_body" / name) if p.is_file()),
            None,
        )
        if path is None:
            return {}
        fails = read_yaml_mapping(path)
        for key in ("sim", "stats", "fails"):
            fails = fails.get(key, {})
            if not isinstance(fails, Mapping):
                raise InputError(f"'{path}' is damaged: '{key}' is no mapping.")
        found: dict[str, list[str]] = {}
        for kind, names in fails.items():
            for name in names if isinstance(names, list) else ():
                found.setdefault(str(name), []).append(str(kind))
        return found

    @staticmethod
    def _bodies_in(folder: Path) -> list[Path]:
        return [folder / f"{b}_body" for b in BODIES if (folder / f"{b}_body").is_dir()]


def read_split_lists(path: Path | str) -> dict[str, tuple[str, ...]]:
    """Reads an official list of splits: train, validation and test as relative paths of sample folders.

    Raises:
        InputError: The file cannot be read, names an unknown split, or lists a garment in two of them.
    """
    content = as_object(read_json_file(path), str(path))
    splits: dict[str, tuple[str, ...]] = {}
    first: dict[str, str] = {}
    for key, names in content.items():
        split = _SPLITS.get(key.lower())
        if split is None:
            raise InputError(f"'{path}' has a split named '{key}'; train, validation and test are known.")
        listed = []
        for name in as_list(names, f"{path}: {key}", limit=_MAX_SAMPLES):
            place = PurePosixPath(str(name))
            if place.is_absolute() or ".." in place.parts or not place.parts:
                raise InputError(f"'{path}' lists {name!r}, which is no path of a sample folder.")
            listed.append(place.as_posix())
            other = first.setdefault(place.as_posix(), split)
            if other != split:
                raise InputError(f"'{path}' lists '{name}' in the splits '{other}' and '{split}'.")
        splits[split] = tuple(listed)
    return splits


def _number(name: str) -> tuple[int, str]:
    last = name.rsplit("_", 1)[-1]
    return int(last) if last.isdecimal() else -1, name
