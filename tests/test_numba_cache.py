from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from swifttailor.numba_cache import provide_numba_cache

pytestmark = pytest.mark.skipif(os.name == "nt", reason="POSIX users and permissions")


@pytest.fixture
def nowhere(tmp_path, monkeypatch):
    """Neither the package nor the user's cache folder can be written; temporary files can."""
    monkeypatch.delenv("NUMBA_CACHE_DIR", raising=False)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setattr("swifttailor.numba_cache._can_write", lambda folder: False)
    return tmp_path


def test_nothing_is_set_where_numba_finds_a_folder(tmp_path, monkeypatch):
    monkeypatch.delenv("NUMBA_CACHE_DIR", raising=False)
    provide_numba_cache(tmp_path)
    assert "NUMBA_CACHE_DIR" not in os.environ


def test_the_users_choice_stays(nowhere, monkeypatch):
    monkeypatch.setenv("NUMBA_CACHE_DIR", "/chosen")
    provide_numba_cache(nowhere)
    assert os.environ["NUMBA_CACHE_DIR"] == "/chosen"


def test_a_private_folder_that_is_found_again(nowhere, monkeypatch):
    provide_numba_cache(nowhere)
    first = os.environ["NUMBA_CACHE_DIR"]
    assert Path(first).parent == nowhere and Path(first).stat().st_mode & 0o777 == 0o700
    monkeypatch.delenv("NUMBA_CACHE_DIR")
    provide_numba_cache(nowhere)
    assert os.environ["NUMBA_CACHE_DIR"] == first


@pytest.mark.parametrize("taken", ["open to all", "a link", "a file"])
def test_a_folder_of_somebody_else_is_not_used(taken, nowhere):
    name = nowhere / f"swifttailor-numba-{os.getuid()}"
    if taken == "open to all":
        name.mkdir()
        name.chmod(0o777)
    elif taken == "a link":
        (nowhere / "theirs").mkdir(mode=0o700)
        name.symlink_to(nowhere / "theirs")
    else:
        name.write_text("")
    provide_numba_cache(nowhere)
    chosen = Path(os.environ["NUMBA_CACHE_DIR"])
    assert chosen != name and chosen.stat().st_mode & 0o777 == 0o700


@pytest.mark.parametrize("module", ["swifttailor.body.surface_kernels", "swifttailor.draping.xpbd_kernels"])
def test_it_is_set_before_any_kernel_is_loaded(module, tmp_path):
    program = (
        "import sys, swifttailor.numba_cache as c, os\n"
        "c._can_write = lambda folder: False\n"
        f"import {module}, numba\n"
        "assert numba.config.CACHE_DIR == os.environ['NUMBA_CACHE_DIR'] != ''\n"
    )
    environment = {k: v for k, v in os.environ.items() if k != "NUMBA_CACHE_DIR"} | {"TMPDIR": str(tmp_path)}
    subprocess.run([sys.executable, "-c", program], check=True, env=environment)
