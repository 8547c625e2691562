"""Who wears the garment of a folder."""

from __future__ import annotations

from pathlib import Path

from swifttailor.body import Body
from swifttailor.body.standing import POSES, carried_to
from swifttailor.body.wearer import body_of
from swifttailor.errors import InputError
from swifttailor.garment.folder import PATTERN, REPORT
from swifttailor.garment.folder_reader import read_report
from swifttailor.pattern import load_pattern


def wearer_of(folder: Path | str) -> Body:
    """The body that the garment of a folder was made on, in the pose in which it stands there.

    Args:
        folder: Written by `Garment.save`.

    Raises:
        InputError: The folder does not hold what the body is made from, or cannot be read.
        PatternError: The pattern is broken.
    """
    folder = Path(folder)
    body = body_of(load_pattern(folder / PATTERN).drafted_for)
    report = read_report(folder / REPORT)
    told = report.get("body", body.name)
    if told != body.name:
        raise InputError(
            f"The garment in '{folder}' is worn by '{told}', and its pattern was drafted for '{body.name}': "
            "the folder does not hold the measures of its wearer. Make it with --fit always, or leave the "
            "body out."
        )
    pose = report.get("pose", "A")
    if pose == "A":
        return body
    if pose not in POSES:
        raise InputError(
            f"'{folder / REPORT}': 'pose' is {pose!r}; {', '.join(map(repr, POSES))} are accepted."
        )
    return carried_to(pose, body)[0]
