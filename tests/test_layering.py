"""The rooms of the package depend on each other one way only (see CONTRIBUTING.md), and stay small."""

from __future__ import annotations

import ast
import subprocess
import sys
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

import swifttailor

ROOT = Path(swifttailor.__file__).parent

# A room may import those in lower rows, and itself; rooms in one row know nothing of each other.
ROWS = (
    {"errors", "__init__"},
    {"atomic_files", "numba_cache", "networks", "workers"},
    {"pattern"},
    {"body", "garment"},
    {"panel_mesh", "render"},
    {"ggi"},
    {"garment_files"},
    {"draping"},
    {"garment_sewer", "pattern_maker"},
    {"data"},
    {"wishes"},
    {"alterations"},
    {"tailor"},
    {"evaluation"},
    {"training"},
    {"cli"},
    {"__main__"},
)
RANK = {room: row for row, rooms in enumerate(ROWS) for room in rooms}

# Conveniences of `Garment` (save, uv) that import upwards, when called.
UPWARD_WHEN_CALLED = {("garment", "garment_files")}

HEAVY = {
    *(
        "torch",
        "transformers",
        "accelerate",
        "trimesh",
        "newton",
        "warp",
        "anny",
        "pxr",
        "PIL",
        "rich",
        "yaml",
    ),
    *("tyro", "onnx", "onnxruntime"),
}
# Modules of this name are made of torch: they load it at once, and are themselves imported when used.
TORCH_MODULE = "_torch"
TORCH_PACKAGES = {"torch", "transformers"}
NUMBA_ROOMS = {"body", "draping"}
MAX_LINES, HARD_MAX_LINES = 400, 600


@dataclass(frozen=True)
class Import:
    file: str
    room: str
    module: str
    when_called: bool
    """In a function, not when the module is loaded."""
    for_types: bool


def imports() -> Iterator[Import]:
    for path in sorted(ROOT.rglob("*.py")):
        file = path.relative_to(ROOT)
        room = file.parts[0].removesuffix(".py")
        yield from _imports_of(ast.parse(path.read_text()), str(file), room)


def _imports_of(tree: ast.AST, file: str, room: str, called=False, types=False) -> Iterator[Import]:
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield Import(file, room, alias.name, called, types)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{file}: imports are written in full, not relative"
            if node.module == "swifttailor":
                for alias in node.names:
                    yield Import(file, room, f"swifttailor.{alias.name}", called, types)
            else:
                yield Import(file, room, node.module or "", called, types)
        else:
            in_function = called or isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda)
            only_types = types or (isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING")
            yield from _imports_of(node, file, room, in_function, only_types)


def test_every_room_has_its_place():
    rooms = {
        p.name.removesuffix(".py")
        for p in ROOT.iterdir()
        if p.suffix == ".py" or (p / "__init__.py").exists()
    }
    assert rooms == set(RANK)


def test_rooms_import_one_way():
    wrong = []
    for found in imports():
        parts = found.module.split(".")
        if parts[0] != "swifttailor" or found.for_types:
            continue
        target = parts[1] if len(parts) > 1 and parts[1] in RANK else "__init__"
        allowed = target == found.room or RANK[target] < RANK[found.room]
        if not allowed and not (found.when_called and (found.room, target) in UPWARD_WHEN_CALLED):
            wrong.append(f"{found.file} imports {found.module}")
    assert not wrong, "\n".join(wrong)


def test_patterns_need_only_numpy_scipy_and_shapely():
    wrong = [
        f"{found.file} imports {found.module}"
        for found in imports()
        if found.room == "pattern"
        and found.module.split(".")[0]
        not in {"swifttailor", "numpy", "scipy", "shapely", *sys.stdlib_module_names}
    ]
    assert not wrong, "\n".join(wrong)


def test_heavy_packages_are_imported_when_used():
    wrong = []
    for found in imports():
        package = found.module.split(".")[0]
        if found.when_called or found.for_types:
            continue
        of_torch = found.file.endswith(f"{TORCH_MODULE}.py")
        if found.module.startswith("swifttailor.") and found.module.endswith(TORCH_MODULE) and not of_torch:
            wrong.append(f"{found.file} imports {found.module} when loaded, and with it torch")
        if of_torch and package in TORCH_PACKAGES:
            continue
        if package in HEAVY and not (package == "tyro" and found.room == "cli"):
            wrong.append(
                f"{found.file} imports {package} when loaded; import it in the function that needs it"
            )
        if package == "numba" and found.room not in NUMBA_ROOMS:
            wrong.append(f"{found.file} imports numba; only {sorted(NUMBA_ROOMS)} do")
    assert not wrong, "\n".join(wrong)


@pytest.mark.parametrize(
    ("module", "unwanted"),
    [
        ("swifttailor", {"numpy", "numba", "scipy", "tyro", "rich", "torch"}),
        ("swifttailor.pattern", {"numba", "trimesh", "torch", "PIL", "rich", "tyro"}),
        ("swifttailor.ggi", {"numba", "trimesh", "torch", "PIL", "rich", "tyro"}),
        ("swifttailor.garment_files", {"numba", "trimesh", "torch", "PIL", "pxr"}),
        ("swifttailor.render", {"numba", "trimesh", "torch", "PIL"}),
        ("swifttailor.draping", {"trimesh", "torch", "PIL", "newton", "warp"}),
        ("swifttailor.garment_sewer.conditioning", {"trimesh", "torch", "PIL", "rich", "tyro"}),
        ("swifttailor.pattern_maker.encode", {"trimesh", "numba", "torch", "PIL", "rich", "tyro"}),
        (
            "swifttailor.tailor",
            {"trimesh", "torch", "PIL", "rich", "tyro", "onnxruntime", "swifttailor.data.captions"},
        ),
        ("swifttailor.training.sewer_config", {"trimesh", "torch", "PIL", "rich", "tyro"}),
    ],
)
def test_what_importing_a_room_loads(module, unwanted):
    program = f"import sys, {module}; print(*sorted(set({sorted(unwanted)!r}) & sys.modules.keys()))"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.split() == []


def test_modules_stay_small():
    lines = {str(p.relative_to(ROOT)): len(p.read_text().splitlines()) for p in ROOT.rglob("*.py")}
    too_long = {name: n for name, n in lines.items() if n > HARD_MAX_LINES}
    assert not too_long, f"above {HARD_MAX_LINES} lines; one idea per file, split them: {too_long}"
    long = {name: n for name, n in lines.items() if n > MAX_LINES}
    if long:
        with warnings.catch_warnings():
            warnings.simplefilter("always")
            warnings.warn(f"above {MAX_LINES} lines, time to split: {long}", stacklevel=1)


def test_public_names():
    """Adding or removing one is a decision: change this list with it, and CHANGELOG.md."""
    assert swifttailor.__all__ == [
        "__version__",
        "Body",
        "Garment",
        "Pattern",
        "SwiftTailorError",
        "Tailor",
        "check_pattern",
        "draft",
        "drape",
        "load_pattern",
    ]
    for name in swifttailor.__all__:
        assert getattr(swifttailor, name) is not None
