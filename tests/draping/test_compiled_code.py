"""The coarse drape is loaded beside other work, and what still has to be compiled is known without numba."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from pathlib import Path

import pytest
from numba.core.caching import _CacheLocator

from swifttailor.draping import coarse_kernels, compiled_code, xpbd_kernels
from swifttailor.draping.compiled_code import (
    coarse_drape_is_compiled,
    load_coarse_drape,
    solver_is_compiled,
)

KERNELS = Path(coarse_kernels.__file__)
QUESTIONS = {
    "coarse": (coarse_drape_is_compiled, coarse_kernels.sew_and_hang),
    "solver": (solver_is_compiled, xpbd_kernels.advance_frame),
}
LATER, LONG_AGO = 4_000_000_000, 1_000_000_000
"""Seconds since 1970: after any source was written, and before."""
BEGIN = """
import sys, time
from swifttailor.draping import compiled_code
compiled_code._drape_two_squares = lambda *args: time.sleep(1000)
loading = compiled_code.load_coarse_drape(None, None, None)
"""


def index(place: Path, name: str, *, when: float = LATER) -> Path:
    """A file where numba would keep what it has compiled."""
    place.mkdir(parents=True, exist_ok=True)
    path = place / name
    path.write_bytes(b"")
    os.utime(path, (when, when))
    return path


def index_name(loops) -> str:
    return loops._cache._cache_file._index_name


@pytest.fixture
def cache(tmp_path, monkeypatch) -> Path:
    """The folder in which numba keeps what it compiles of the draping room, empty."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    return tmp_path / _CacheLocator.get_suitable_cache_subpath(str(KERNELS))


@pytest.mark.parametrize("which", QUESTIONS)
def test_an_empty_cache_has_nothing_compiled(which, cache):
    compiled, loops = QUESTIONS[which]
    assert not compiled()
    cache.mkdir()
    assert not compiled()
    index(cache, index_name(loops))
    assert compiled()


@pytest.mark.parametrize("which", QUESTIONS)
def test_one_is_not_the_other(which, cache):
    for other, (compiled, loops) in QUESTIONS.items():
        if other != which:
            index(cache, index_name(loops))
            assert compiled() and not QUESTIONS[which][0]()


def test_what_is_older_than_the_source_does_not_count(cache):
    index(cache, index_name(coarse_kernels.sew_and_hang), when=LONG_AGO)
    assert not coarse_drape_is_compiled()


def test_what_another_python_has_compiled_does_not_count(cache):
    name = index_name(coarse_kernels.sew_and_hang)
    own = f"py{sys.version_info.major}{sys.version_info.minor}"
    assert own in name
    index(cache, name.replace(own, "py27"))
    assert not coarse_drape_is_compiled()


def test_what_another_copy_of_the_package_has_compiled_does_not_count(cache):
    other = _CacheLocator.get_suitable_cache_subpath("/elsewhere/swifttailor/draping/coarse_kernels.py")
    assert other.startswith("draping_") and other != cache.name
    index(cache.parent / other, index_name(coarse_kernels.sew_and_hang))
    assert not coarse_drape_is_compiled()


def test_other_loops_of_the_same_file_do_not_count(cache):
    index(cache, index_name(coarse_kernels.sew_and_hang).replace("sew_and_hang", "sew_and_hang_not"))
    assert not coarse_drape_is_compiled()


@pytest.mark.parametrize("place", ["beside the source", "the user's folder", "the folder XDG names"])
def test_without_a_folder_of_ones_own(place, tmp_path, monkeypatch):
    """A copy of the room, so that what lies beside the true one does not matter."""
    room = tmp_path / "draping"
    room.mkdir()
    source = room / KERNELS.name
    source.write_text("")
    monkeypatch.setattr(compiled_code, "__file__", str(room / "compiled_code.py"))
    monkeypatch.delenv("NUMBA_CACHE_DIR", raising=False)
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    own = _CacheLocator.get_suitable_cache_subpath(str(source))
    if place == "the folder XDG names":
        monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "xdg"))
    found = {
        "beside the source": room / "__pycache__",
        "the user's folder": tmp_path / "home" / ".cache" / "numba" / own,
        "the folder XDG names": tmp_path / "xdg" / "numba" / own,
    }[place]
    assert not coarse_drape_is_compiled()
    name = index_name(coarse_kernels.sew_and_hang)
    index(found, name)
    assert coarse_drape_is_compiled()
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "chosen"))  # numba looks nowhere else then
    assert not coarse_drape_is_compiled()


def test_asking_does_not_load_numba():
    program = (
        "import sys\n"
        "from swifttailor.draping.compiled_code import coarse_drape_is_compiled, solver_is_compiled\n"
        "coarse_drape_is_compiled(), solver_is_compiled()\n"
        "assert 'numba' not in sys.modules\n"
    )
    subprocess.run([sys.executable, "-c", program], check=True)


def test_an_error_is_told_to_everybody_who_waits(monkeypatch, capfd):
    monkeypatch.setattr(compiled_code, "_drape_two_squares", lambda *args: 1 / 0)
    loading = load_coarse_drape(None, None, None)
    for _ in range(2):
        with pytest.raises(ZeroDivisionError):
            loading.wait()
    assert capfd.readouterr() == ("", ""), "and to nobody else"


def test_waiting_ends_when_it_is_done(monkeypatch):
    go_on, done = threading.Event(), []

    def load(*args):
        go_on.wait()
        done.append(args)

    monkeypatch.setattr(compiled_code, "_drape_two_squares", load)
    loading = load_coarse_drape("full", "armless", "measurements")
    assert not done, "it is begun in the background"
    threading.Timer(0.05, go_on.set).start()
    loading.wait()
    loading.wait()
    assert done == [("full", "armless", "measurements")]


def test_the_program_ends_without_it():
    """An error elsewhere is not held up by a compiler at work."""
    ended = subprocess.run(
        [sys.executable, "-c", BEGIN + "raise RuntimeError('elsewhere')"], capture_output=True, timeout=120
    )
    assert ended.returncode == 1 and b"RuntimeError: elsewhere" in ended.stderr


@pytest.mark.skipif(os.name == "nt", reason="POSIX signals")
def test_ctrl_c_ends_the_program_while_it_waits():
    heard = "import signal\nsignal.signal(signal.SIGINT, signal.default_int_handler)\n"  # jobs ignore it
    program = heard + BEGIN + "print('waiting', flush=True)\nloading.wait()"
    with subprocess.Popen(
        [sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as run:
        assert run.stdout.readline() == b"waiting\n"
        run.send_signal(signal.SIGINT)
        _, said = run.communicate(timeout=120)
    assert run.returncode != 0 and b"KeyboardInterrupt" in said


def test_nothing_is_left_to_compile_afterwards():
    """What two squares were draped with is what garments are draped with."""
    program = """
from swifttailor.body import Body
from swifttailor.draping.compiled_code import load_coarse_drape
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.garment_sewer.pixels.pixel_table import tabulate
from swifttailor.ggi import lay_out
from swifttailor.pattern.drafts import draft
body = BodyDistance.of(Body.default())
load_coarse_drape(body.full, body.without_arms, body.measurements).wait()
from swifttailor.draping import coarse
before = set(coarse._sew_and_hang._linked)
assert len(before) == 1
tabulate(lay_out(draft("t-shirt"), 64), "hung", body)
assert before == set(coarse._sew_and_hang._linked)
"""
    subprocess.run([sys.executable, "-c", program], check=True)
