"""What is read without tyro is what tyro reads; everything else is left to it."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
import tyro
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.cli.check import Check
from swifttailor.cli.convert import Convert
from swifttailor.cli.drape import Drape
from swifttailor.cli.edit import Edit
from swifttailor.cli.generate import Generate
from swifttailor.cli.ggi import Ggi
from swifttailor.cli.plain_options import read_plain
from swifttailor.cli.sew import Sew

KINDS = [Sew, Generate, Edit, Drape, Check, Convert, Ggi]
PLAIN = [
    (Sew, ["p.json", "--out", "d"]),
    (Sew, ["p.json", "--open", "--overwrite", "--no-preview"]),
    (Sew, ["--out", "d", "a.json", "b/c.json"]),
    (Sew, ["a", "--out", "d", "--json", "--repair", "--edge-length", "3", "--rotation", "extrinsic"]),
    (Generate, ["a long dress", "--out", "d"]),
    (Generate, ["--out", "d", "--no-crop", "--seed", "7", "--temperature", "0.5"]),
    (Generate, ["a dress", "--out", "d", "--preview", "--samples", "3"]),
    (Edit, ["p.json", "make it longer", "--out", "d", "--no-alter"]),
]
WORDS = [
    *("--out", "d", "a b", "p.json", "--seed", "7", "07", "-1", "1e3", "2.5", "--json", "--no-json"),
    *(
        "--preview",
        "--no-preview",
        "--overwrite",
        "--no-overwrite",
        "--open",
        "--edge-length",
        "--edge_length",
        "--out=d",
        "--rotation",
        "extrinsic",
    ),
    *(
        "other",
        "--help",
        "-h",
        "--",
        "--image",
        "--samples",
        "--threads",
        "--repair",
        "",
        "--no-crop",
        "--crop",
    ),
    *("None", "-"),
]


def by_tyro(kind, arguments):
    """What tyro makes of a command line; None where it prints something instead."""
    try:
        return tyro.cli(kind, args=list(arguments), prog="it", console_outputs=False)
    except SystemExit:
        return None


@pytest.mark.parametrize(("kind", "arguments"), PLAIN)
def test_plain_command_lines_are_read(kind, arguments):
    read = read_plain(kind, arguments)
    assert read is not None
    assert read == by_tyro(kind, arguments)


@given(st.sampled_from(KINDS), st.lists(st.sampled_from(WORDS), max_size=8))
def test_what_is_read_is_what_tyro_reads(kind, arguments):
    read = read_plain(kind, arguments)
    if read is not None:
        assert read == by_tyro(kind, arguments)


@pytest.mark.parametrize("arguments", [["--help"], ["--out", "d", "--nonsense"], ["p", "--out", ""]])
def test_mistakes_and_help_are_left_to_tyro(arguments):
    assert read_plain(Sew, arguments) is None


def test_a_plain_sew_without_physics_loads_neither_tyro_nor_numba(tmp_path: Path):
    program = f"""
import sys
from swifttailor.cli.main import run
pattern, out = {str(tmp_path / "shirt.json")!r}, {str(tmp_path / "out")!r}
run(["draft", "t-shirt", "--out", pattern])
sys.exit(run(["sew", pattern, "--out", out]))
"""
    subprocess.run([sys.executable, "-c", program], check=True)  # compiles what is not compiled yet
    program = f"""
import sys
from swifttailor.cli.main import run
assert run(["sew", {str(tmp_path / "shirt.json")!r}, "--no-relax", "--out", {str(tmp_path / "again")!r}]) == 0
assert not [name for name in ("numba", "tyro.conf", "unittest") if name in sys.modules]
"""
    subprocess.run([sys.executable, "-c", program], check=True)
