"""The guides' Python uses public names alone, and those of guides without commands runs as it stands."""

from __future__ import annotations

import ast
import re
from importlib import import_module
from pathlib import Path

import pytest

from swifttailor.draping import engines

ROOT = Path(__file__).parents[1]
GUIDES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
_BLOCK = re.compile(r"```python\n(.*?)```", re.DOTALL)


def _blocks(guide: Path) -> list[str]:
    return _BLOCK.findall(guide.read_text())


@pytest.mark.parametrize("guide", GUIDES, ids=lambda path: path.stem)
def test_only_public_names(guide):
    """Those of the package itself, or what one of its rooms lists in `__all__`."""
    for block in _blocks(guide):
        for node in ast.walk(ast.parse(block)):
            if isinstance(node, ast.Import):
                assert all(alias.name != "swifttailor" or alias.asname is None for alias in node.names)
                assert not any(alias.name.startswith("swifttailor.") for alias in node.names), guide.name
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("swifttailor"):
                assert node.module.count(".") <= 1, f"{guide.name}: {node.module} is no room"
                offered = import_module(node.module).__all__
                assert {alias.name for alias in node.names} <= set(offered), f"{guide.name}: {node.module}"


@pytest.mark.parametrize("name", ["engines", "extending", "garment-programs", "trims"])
def test_guides_to_extending(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(engines, "_MAKERS", dict(engines._MAKERS))
    blocks = _blocks(ROOT / "docs" / f"{name}.md")
    assert blocks
    for block in blocks:
        exec(compile(block, f"{name}.md", "exec"), {})
