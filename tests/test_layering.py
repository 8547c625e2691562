"""The rooms of the package depend on each other one way only (see CONTRIBUTING.md), and stay small."""

from __future__ import annotations

import ast
import importlib.util
import subprocess
import sys
import tomllib
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import pytest

import swifttailor

ROOT = Path(swifttailor.__file__).parent

HOUSE = ROOT.parents[1]
TABLE = tomllib.loads((HOUSE / "docs" / "rooms.toml").read_text())
# A room may import those in lower rows, and itself; rooms in one row know nothing of each other. The lowest
# floor is of small files; of them, those that import each other are ordered here.
_SMALL = (
    {"errors", "first_use"},
    {"__init__"},
    {"arrays", "atomic_files", "clock", "inches", "numba_cache", "postponed_module", "progress"},
    {"compiled_loop", "output_folder"},
    {"workers"},
)
ROWS = (*_SMALL, *(set(floor["rooms"]) for floor in TABLE["floor"][1:]), {"__main__"})
RANK = {room: row for row, rooms in enumerate(ROWS) for room in rooms}

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
NUMBA_ROOMS = {"body", "draping", "render"}
MAX_LINES, HARD_MAX_LINES = 400, 600


@dataclass(frozen=True)
class Import:
    file: str
    room: str
    module: str
    names: tuple[str, ...]
    """What is imported from it; they may be modules themselves."""
    when_called: bool
    """In a function, not when the module is loaded."""
    for_types: bool


@cache
def imports() -> tuple[Import, ...]:
    found: list[Import] = []
    for path in sorted(ROOT.rglob("*.py")):
        file = path.relative_to(ROOT)
        room = file.parts[0].removesuffix(".py")
        found += _imports_of(ast.parse(path.read_text()), str(file), room)
    return tuple(found)


def _imports_of(tree: ast.AST, file: str, room: str, called=False, types=False) -> Iterator[Import]:
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield Import(file, room, alias.name, (), called, types)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{file}: imports are written in full, not relative"
            if node.module == "swifttailor":
                for alias in node.names:
                    yield Import(file, room, f"swifttailor.{alias.name}", (), called, types)
            else:
                names = tuple(alias.name for alias in node.names)
                yield Import(file, room, node.module or "", names, called, types)
        else:
            in_function = called or isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda)
            only_types = types or (
                isinstance(node, ast.If)
                and isinstance(node.test, ast.Name)
                and node.test.id == "TYPE_CHECKING"
            )
            yield from _imports_of(node, file, room, in_function, only_types)


def test_every_room_has_its_place():
    rooms = {
        p.name.removesuffix(".py")
        for p in ROOT.iterdir()
        if p.suffix == ".py" or (p / "__init__.py").exists()
    }
    assert rooms == set(RANK)


def test_the_lowest_floor_is_the_table_s():
    assert set().union(*_SMALL) - {"__init__"} == set(TABLE["floor"][0]["rooms"])


def test_the_picture_of_the_rooms_is_true():
    script = HOUSE / "scripts" / "draw_rooms.py"
    spec = importlib.util.spec_from_file_location("draw_rooms", script)
    drawing = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(drawing)
    assert drawing.PICTURE.read_text() == drawing.draw(TABLE), f"make it anew: python {script}"
    guide = (HOUSE / "docs" / "architecture.md").read_text()
    assert "images/rooms.svg" in guide
    missing = [room for room in RANK if f"`{room}`" not in guide and room not in ("__init__", "__main__")]
    assert not missing, f"docs/architecture.md does not speak of {missing}"


def test_rooms_import_one_way():
    wrong = []
    for found in imports():
        parts = found.module.split(".")
        if parts[0] != "swifttailor" or found.for_types:
            continue
        target = parts[1] if len(parts) > 1 and parts[1] in RANK else "__init__"
        if target != found.room and RANK[target] >= RANK[found.room]:
            wrong.append(f"{found.file} imports {found.module}")
    assert not wrong, "\n".join(wrong)


def test_no_file_imports_itself_in_a_circle():
    """Imports when called count, and so do the packages of other rooms that an import runs first."""
    circles = [sorted(circle) for circle in _circles(_file_graph())]
    assert not circles, "\n".join(map(str, circles))


def test_every_room_says_what_it_holds_and_what_it_may_import():
    silent = []
    for room in RANK:
        file = ROOT / room / "__init__.py"
        if file.is_file() and len((ast.get_docstring(ast.parse(file.read_text())) or "").split("\n\n")) < 2:
            silent.append(room)
    assert not silent, f"two paragraphs are wanted in __init__.py of {silent}"


def _file_graph() -> dict[str, set[str]]:
    """Which modules of the package each module imports; imports for types do not count."""
    modules = {_module(path) for path in ROOT.rglob("*.py")}
    graph: dict[str, set[str]] = {module: set() for module in modules}
    for found in imports():
        importer = _module(ROOT / found.file)
        if found.for_types or not found.module.startswith("swifttailor"):
            continue
        parts = found.module.split(".")
        run_first = {".".join(parts[:k]) for k in range(1, len(parts))}
        for target in {
            found.module,
            *run_first,
            *(f"{found.module}.{name}" for name in found.names),
        } & modules:
            if target != importer and not importer.startswith(f"{target}."):
                graph[importer].add(target)
    return graph


def _module(path: Path) -> str:
    return ".".join(path.relative_to(ROOT.parent).with_suffix("").parts).removesuffix(".__init__")


def _circles(graph: dict[str, set[str]]) -> Iterator[set[str]]:
    """What is left when everything is taken away, again and again, that imports or is imported by nothing."""
    left = {module: set(targets) for module, targets in graph.items()}
    while True:
        imported = set().union(*left.values()) if left else set()
        ends = {module for module, targets in left.items() if not targets or module not in imported}
        if not ends:
            break
        left = {module: targets - ends for module, targets in left.items() if module not in ends}
    while left:
        start = min(left)
        circle = _reached(left, start)
        yield circle
        left = {module: targets - circle for module, targets in left.items() if module not in circle}


def _reached(graph: dict[str, set[str]], start: str) -> set[str]:
    reached, waiting = {start}, [start]
    while waiting:
        new = graph.get(waiting.pop(), set()) - reached
        reached |= new
        waiting += new
    return reached


def test_circles_are_found():
    graph = {"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": {"a"}, "e": set()}
    assert list(_circles(graph)) == [{"b", "c"}]


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
        ("swifttailor.garment", {"numba", "trimesh", "torch", "PIL", "pxr"}),
        ("swifttailor.render", {"numba", "trimesh", "torch", "PIL"}),
        ("swifttailor.draping", {"trimesh", "torch", "PIL", "newton", "warp"}),
        ("swifttailor.garment_sewer.conditioning", {"trimesh", "torch", "PIL", "rich", "tyro"}),
        ("swifttailor.pattern_maker.tokens.encode", {"trimesh", "numba", "torch", "PIL", "rich", "tyro"}),
        (
            "swifttailor.tailor",
            {"trimesh", "torch", "PIL", "rich", "tyro", "onnxruntime", "swifttailor.wording.captions"},
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
    classes = (
        "Arc Body Claim Cubic Edge EdgeRef Engine Fabric Finding Garment GarmentSewer Line Panel Pattern"
    )
    more = "PatternMaker PatternWriter Placement Quadratic Settled Sewer SewnGarment Stitch"
    errors = "SwiftTailorError Tailor WrittenPattern"
    functions = "alter body_for check describe draft draft_design drape fit load_pattern register_engine"
    names = f"{classes} {more} {errors} {functions} repair sew".split()
    assert sorted(swifttailor.__all__) == sorted(["__version__", *names])
    assert list(swifttailor._PUBLIC) == names
    for name in swifttailor.__all__:
        assert getattr(swifttailor, name) is not None
    assert set(swifttailor.__all__) <= set(dir(swifttailor))


def test_what_type_checkers_see_is_what_is_loaded():
    tree = ast.parse((ROOT / "__init__.py").read_text())
    (block,) = (n for n in tree.body if isinstance(n, ast.If) and ast.unparse(n.test) == "TYPE_CHECKING")
    seen = {
        alias.asname or alias.name: (statement.module, alias.name)
        for statement in block.body
        if isinstance(statement, ast.ImportFrom)
        for alias in statement.names
    }
    loaded = {}
    for name, where in swifttailor._PUBLIC.items():
        room, _, inside = where.partition(":")
        loaded[name] = (f"swifttailor.{room}", inside or name)
    assert seen == loaded
    assert (ROOT / "py.typed").is_file()


def test_type_checkers_know_the_public_names(tmp_path):
    """In a package that uses this one, which py.typed lets them look into."""
    wrong = tmp_path / "wrong.py"
    wrong.write_text(
        "import swifttailor\n"
        "pattern: swifttailor.Pattern = swifttailor.load_pattern('p.json')\n"
        "garment: int = swifttailor.drape(pattern)\n"
        "findings: str = swifttailor.check(pattern)\n"
    )
    command = [
        sys.executable,
        "-m",
        "ty",
        "check",
        "--python",
        sys.prefix,
        "--output-format",
        "concise",
        str(wrong),
    ]
    done = subprocess.run(command, capture_output=True, text=True)
    lines = [int(line.split(":")[1]) for line in done.stdout.splitlines() if "invalid-assignment" in line]
    assert lines == [3, 4], done.stdout + done.stderr
