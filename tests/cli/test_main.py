from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from swifttailor import __version__
from swifttailor.cli import main
from swifttailor.cli.main import COMMANDS, Command, run
from swifttailor.errors import InputError

ERROR_TEXTS = Path(__file__).with_name("error_texts.txt")


def swifttailor(*arguments: str, **more) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "swifttailor", *arguments]
    return subprocess.run(command, capture_output=True, text=True, **more)


@pytest.mark.parametrize("arguments", [["--help"], ["-h"], ["help"], ["--version"], [], ["chekc"]])
def test_help_and_mistakes_load_no_heavy_package(arguments):
    heavy = ["numpy", "scipy", "shapely", "numba", "trimesh", "torch", "PIL", "tyro", "rich", "yaml"]
    program = (
        "import sys; from swifttailor.cli.main import run; run(sys.argv[1:]);"
        f"sys.exit(repr([m for m in {heavy} if m in sys.modules] or ''))"
    )
    done = subprocess.run([sys.executable, "-c", program, *arguments], capture_output=True, text=True)
    assert done.stderr.splitlines()[-1] == "''"


def test_help_shows_every_command_with_an_example(capsys):
    assert run(["--help"]) == 0
    shown = capsys.readouterr().out
    for name, command in COMMANDS.items():
        assert f"  {name}" in shown and command.summary in shown and command.usage in shown
    assert max(len(line) for line in shown.splitlines()) <= 100


def test_the_version(capsys):
    assert run(["--version"]) == 0
    assert capsys.readouterr().out == f"swifttailor {__version__}\n"


def test_nothing_asked_for_shows_the_help_as_an_error(capsys):
    assert run([]) == 2
    captured = capsys.readouterr()
    assert captured.out == "" and "usage: swifttailor COMMAND" in captured.err


@pytest.mark.parametrize("name", list(COMMANDS))
@pytest.mark.parametrize("ask", [lambda n: [n, "--help"], lambda n: ["help", n]], ids=["--help", "help"])
def test_every_command_has_help(name, ask, capsys):
    assert run(ask(name)) == 0
    assert f"usage: swifttailor {name}" in capsys.readouterr().out


def test_wrong_options_are_usage_errors(capsys):
    for name in COMMANDS:
        assert run([name, "--no-such-option"]) == 2
        assert capsys.readouterr().err


def texts(folder: Path, capsys: pytest.CaptureFixture[str]) -> str:
    """Every error a user meets soon, as the terminal shows it."""
    (folder / "shirt.json").write_text("{}")
    (folder / "broken.json").write_text('{"pattern": {"panels"')
    (folder / "photo.json").write_bytes(b"\x89PNG\r\n\x1a\n\0\0\xff")
    (folder / "folder").mkdir()
    (folder / "folder" / "note.txt").write_text("mine")
    blocks = []
    for line in """
        sew
        drap shirt.json
        shirt.json
        --fabric silk
        check none.json
        check shirt.json
        check broken.json
        check photo.json
        check folder
        drape --out new
        drape shirt.json --batch shirt.json --out new
        drape shirt.json --out new --workers 2
        drape shirt.json --out new --edge-length 0
        drape shirt.json --out new --edge-length nan
        drape shirt.json --out new --seed -1
        drape shirt.json --out shirt.json
        drape shirt.json --out new
        drape none.json --out new
        drape --batch none.jsonl --out new
        drape --batch shirt.json --out new
        drape --batch folder --out new
        drape --batch shirt.json --out new --workers 0
        drape --batch shirt.json --out new --limit 0
        drape --batch shirt.json --out new --time-limit 0
        generate --out new
        generate photo.png --out new
        generate dress --samples 0 --out new
        generate dress --temperature -1 --out new
        generate dress --out shirt.json
        edit shirt.json --out new
        edit none.json shorter --out new
        edit broken.json shorter --out new
        draft
        draft t-shrt --out new.json
        draft t-shirt --sleeve-length 400 --out new.json
        convert shirt.json shirt.json
        convert shirt.json shirt.glb
        convert shirt.json shirt.pdf
        convert shirt.json shirt
        convert none.glb new.obj
        convert shirt.txt new.obj
        ggi --out new
        ggi shirt.json --out new
        ggi none.json --out new
        ggi folder --out new
        ggi shirt.json --out shirt.json
        ggi shirt.json --out new --method grid
        ggi image.npz --out new
        ggi --decode none.npz --out new
        ggi --decode photo.json --out new
        ggi --decode photo.json --out new --resolution 64
    """.strip().splitlines():
        arguments = line.split()
        code = run(arguments)
        captured = capsys.readouterr()
        assert code == 2 and captured.out == "" and "Traceback" not in captured.err, line
        blocks.append(f"$ swifttailor {line.strip()}\n{captured.err}")
    names = {"shirt.json", "broken.json", "photo.json", "folder"}
    assert {p.name for p in folder.iterdir()} == names, "an error left a file behind"
    return "\n".join(blocks)


def test_error_texts(tmp_path, monkeypatch, capsys):
    """Wording is part of the interface. To accept new wording: UPDATE_ERROR_TEXTS=1 pytest tests/cli"""
    monkeypatch.chdir(tmp_path)
    shown = texts(tmp_path, capsys)
    if os.environ.get("UPDATE_ERROR_TEXTS"):
        ERROR_TEXTS.write_text(shown)
    assert shown == ERROR_TEXTS.read_text()


def fails_with(error: BaseException, monkeypatch: pytest.MonkeyPatch) -> None:
    def load():
        def runner(arguments):
            raise error

        return runner

    monkeypatch.setitem(main.COMMANDS, "fail", Command("", "", load))


@pytest.mark.parametrize(
    ("error", "code", "said"),
    [
        (InputError("too short"), 2, "Error: too short\n"),
        (KeyboardInterrupt(), 130, "Interrupted."),
        (MemoryError(), 70, "not enough memory"),
        (PermissionError(13, "Permission denied", "a.json"), 2, "'a.json': Permission denied"),
        (ZeroDivisionError("division"), 70, "ZeroDivisionError: division"),
    ],
)
def test_how_errors_end(error, code, said, monkeypatch, capsys):
    fails_with(error, monkeypatch)
    assert run(["fail"]) == code
    shown = capsys.readouterr().err
    assert said in shown and "Traceback" not in shown
    if code == 70:
        assert "--debug" in shown


@pytest.mark.parametrize("place", [["--debug", "fail"], ["fail", "--debug"]])
def test_debug_shows_where(place, monkeypatch):
    fails_with(InputError("too short"), monkeypatch)
    with pytest.raises(InputError):
        run(place)


def test_debug_after_two_dashes_is_an_argument(monkeypatch, capsys):
    fails_with(InputError("too short"), monkeypatch)
    assert run(["fail", "--", "--debug"]) == 2


def test_debug_as_a_process(tmp_path):
    done = swifttailor("check", "none.json", cwd=tmp_path)
    assert done.returncode == 2 and "Traceback" not in done.stderr
    done = swifttailor("check", "none.json", "--debug", cwd=tmp_path)
    assert done.returncode != 0 and "Traceback" in done.stderr and "InputError" in done.stderr


@pytest.mark.skipif(os.name == "nt", reason="POSIX pipes")
def test_a_reader_that_leaves_is_no_error(tmp_path):
    reading, writing = os.pipe()
    os.close(reading)
    with os.fdopen(writing, "w") as closed:
        done = subprocess.run(
            [sys.executable, "-m", "swifttailor", "--help"], stdout=closed, stderr=subprocess.PIPE, text=True
        )
    assert done.returncode == 141 and done.stderr == ""


def test_names_the_terminal_cannot_show(tmp_path):
    environment = {**os.environ, "PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0"}
    done = swifttailor("check", "kleid-ß-服.json", cwd=tmp_path, env=environment)
    assert done.returncode == 2 and "kleid-" in done.stderr and "Traceback" not in done.stderr
