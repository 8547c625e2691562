"""Tests that use torch say so: `make test-networks` runs those that do, and no others."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

FILES = sorted(Path(__file__).parent.rglob("test_*.py"))


def imports_torch(tree: ast.AST) -> bool:
    names = [a.name for node in ast.walk(tree) if isinstance(node, ast.Import) for a in node.names]
    names += [node.module or "" for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
    return any(name.split(".")[0] == "torch" or name.endswith("_torch") for name in names)


@pytest.mark.parametrize("file", FILES, ids=lambda p: p.stem)
def test_a_function_that_imports_torch_is_marked(file):
    tree = ast.parse(file.read_text())
    whole = "pytestmark = pytest.mark.needs_torch" in file.read_text()
    for function in tree.body:
        if isinstance(function, ast.FunctionDef) and function.name.startswith("test_"):
            marked = any("needs_torch" in ast.unparse(d) for d in function.decorator_list)
            assert whole or marked or not imports_torch(function), function.name


def test_an_unmarked_function_is_seen():
    assert imports_torch(ast.parse("def test_it():\n    import torch"))
    assert imports_torch(ast.parse("from swifttailor.training.muon_torch import Muon"))
    assert not imports_torch(ast.parse("from swifttailor.training import extra\nimport json"))
