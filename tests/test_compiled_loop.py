"""Machine code that numba has made, run without numba: the same result, kept, never trusted when damaged."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numba
import numpy as np
import pytest

from swifttailor.compiled_loop import ENDING, CompiledLoop

MODULE = "own_kernels"
SOURCE = '''
from numba import njit

@njit(cache=True, error_model="numpy")
def mix(result, table, pair, scale, turned):
    """Fills `result` from an array of any order, a tuple of array and number, a number and a truth value."""
    added, times = pair
    for i in range(table.shape[0]):
        for k in range(table.shape[1]):
            value = table[i, k] * scale + added[k] * times
            result[i, k] = -value if turned else value
'''


@pytest.fixture
def loop(tmp_path, monkeypatch) -> CompiledLoop:
    monkeypatch.delenv("NUMBA_CACHE_DIR", raising=False)
    monkeypatch.setattr(numba.config, "CACHE_DIR", "")  # beside the source
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, MODULE, raising=False)
    (tmp_path / f"{MODULE}.py").write_text(SOURCE)
    return CompiledLoop(MODULE, "mix")


def arguments(order: str = "C", dtype: type = np.float64) -> tuple:
    table = np.asarray(np.arange(6.0).reshape(2, 3), order=order, dtype=dtype)  # ty: ignore[no-matching-overload]
    return np.zeros((2, 3)), table, (np.array([1.0, 2.0, 4.0]), 3), 0.5, True


def wanted() -> np.ndarray:
    return -(np.arange(6.0).reshape(2, 3) * 0.5 + np.array([1.0, 2.0, 4.0]) * 3)


def kept(folder: Path) -> list[Path]:
    return sorted(folder.rglob(f"*{ENDING}"))


@pytest.mark.parametrize("order", ["C", "F"])
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_it_gives_what_numba_gives(loop, order, dtype):
    given = arguments(order, dtype)
    loop(*given)
    assert np.array_equal(given[0], wanted())


def test_each_kind_of_arguments_has_its_own_code(loop, tmp_path):
    for dtype in (np.float64, np.float32):
        for _ in range(2):
            given = arguments("C", dtype)
            loop(*given)
            assert np.array_equal(given[0], wanted())
    assert len(kept(tmp_path)) == 2


def test_what_is_kept_runs_without_numba(loop, tmp_path):
    loop(*arguments())
    program = f"""
import sys
import numpy as np
sys.path.insert(0, {str(tmp_path)!r})
from swifttailor.compiled_loop import CompiledLoop
result = np.zeros((2, 3))
CompiledLoop({MODULE!r}, "mix")(
    result, np.arange(6.0).reshape(2, 3), (np.array([1.0, 2.0, 4.0]), 3), 0.5, True
)
assert result.tolist() == {wanted().tolist()!r}
assert "numba" not in sys.modules and {MODULE!r} not in sys.modules
"""
    subprocess.run([sys.executable, "-c", program], check=True)


@pytest.mark.parametrize("damage", [b"", b"half", None])
def test_damaged_code_is_made_anew(loop, tmp_path, damage):
    loop(*arguments())
    (path,) = kept(tmp_path)
    whole = path.read_bytes()
    path.write_bytes(whole[:-1] + bytes([whole[-1] ^ 1]) if damage is None else damage)
    given = arguments()
    CompiledLoop(MODULE, "mix")(*given)
    assert np.array_equal(given[0], wanted())
    assert path.read_bytes() == whole


def test_changed_sources_are_compiled_anew(loop, tmp_path):
    loop(*arguments())
    (tmp_path / f"{MODULE}.py").write_text(SOURCE.replace("-value if turned", "value if turned"))
    sys.modules.pop(MODULE)
    given = arguments()
    CompiledLoop(MODULE, "mix")(*given)
    assert np.array_equal(given[0], -wanted())
    assert len(kept(tmp_path)) == 2


def test_a_folder_that_cannot_be_written_costs_only_time(loop, tmp_path, monkeypatch):
    def full(*_, **__):
        from swifttailor.errors import InputError

        raise InputError("The disk is full.")

    monkeypatch.setattr("swifttailor.compiled_loop.write_atomically", full)
    given = arguments()
    loop(*given)
    assert np.array_equal(given[0], wanted())
    assert not kept(tmp_path)


def test_code_that_needs_numba_is_run_by_numba(tmp_path, monkeypatch, loop):
    """One that allocates is refused by the linker or not; either way numba's own function is there."""
    monkeypatch.setattr("swifttailor.compiled_loop._linked", lambda *_: (_ for _ in ()).throw(RuntimeError()))
    given = arguments()
    loop(*given)
    assert np.array_equal(given[0], wanted())


def test_what_a_loop_cannot_take_is_refused(loop):
    with pytest.raises(TypeError, match="got str"):
        loop("a")
    with pytest.raises(TypeError, match="got float64"):
        loop(np.float64(1))


@pytest.mark.parametrize(
    ("told", "own"), [("0.67.9", False), ("0.68.0rc1", True), ("0.69.0", False), ("1.68.0", False)]
)
def test_only_versions_of_numba_that_are_known_hand_on_machine_code(loop, tmp_path, monkeypatch, told, own):
    from swifttailor import compiled_loop

    monkeypatch.setattr(compiled_loop, "version", lambda _: told)
    for remembered in (compiled_loop._numba_is_tested, compiled_loop._machine):
        remembered.cache_clear()
    given = arguments()
    loop(*given)
    assert np.array_equal(given[0], wanted())
    assert bool(kept(tmp_path)) == own
    for remembered in (compiled_loop._numba_is_tested, compiled_loop._machine):
        remembered.cache_clear()
