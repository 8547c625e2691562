"""Nothing that grows with what is asked is remembered without end."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import swifttailor
from swifttailor.tailor.provenance import versions

PACKAGE = Path(swifttailor.__file__).parent
MAY_GROW = {
    "wording/claim_marks.py:_claim": "marks are those of the package's tables",
    "describing/facts_file.py:_hints": "classes of facts",
    "describing/facts_file.py:_later": "classes of facts",
}
"""Unbounded caches of functions with arguments, and why there are few of these."""


def remembering() -> Iterator[tuple[str, ast.FunctionDef, bool]]:
    """Functions that `functools` remembers the results of: place, definition, whether without end."""
    for path in sorted(PACKAGE.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            for decorator in getattr(node, "decorator_list", []):
                text = ast.unparse(decorator).removeprefix("functools.")
                if text == "cache" or text.startswith("lru_cache"):
                    endless = text == "cache" or "maxsize=" not in text or "None" in text
                    yield f"{path.relative_to(PACKAGE).as_posix()}:{node.name}", node, endless


def test_unbounded_caches_have_no_arguments():
    found = list(remembering())
    assert len(found) > 20, "the search finds them"
    grow = {where for where, node, endless in found if endless and ast.unparse(node.args)}
    assert grow == set(MAY_GROW)


def test_versions_in_a_report_are_the_caller_s():
    expected = dict(versions())
    versions()["numpy"] = "0.0"
    versions().clear()
    assert versions() == expected and "numpy" in expected
