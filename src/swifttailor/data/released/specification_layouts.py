"""Systems that write the pattern format of GarmentCode or its forerunner: how they name and nest their files.

Beside what a system has made lie copies of what it should have made (``_gt_``), templates, and other copies:
they are no outputs. Each rule was read off the code of that system that writes the files.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import PurePosixPath

from swifttailor.data.released.known_place import KnownPlace
from swifttailor.data.released.layout import Answer, Layout
from swifttailor.data.released.listing import Listing

_AROUND_THE_ORIGIN = KnownPlace(raised=112.0, arms_level=True)
"""The body of the data that DressCode is trained on (Garment-Pattern-Generator): in T-pose at the origin."""
_ENDING = "_specification.json"
_NOT_MADE = re.compile(r"(_gt__?|_template)_?specification\.json$|^_gt_")
_IMAGE = re.compile(r"\.(png|jpe?g|webp|bmp)$", re.IGNORECASE)


def _named(listing: Listing, pattern: str) -> Iterator[tuple[PurePosixPath, re.Match[str]]]:
    """Files whose whole name fits."""
    compiled = re.compile(pattern)
    for file in listing.files:
        match = compiled.fullmatch(file.name)
        if match is not None:
            yield file, match


def _aipparel(listing: Listing) -> list[Answer]:
    """``step_N/SUBSET/INPUT/NNSewingPattern_pred_specification.json``; the folder is made first."""
    made = [Answer(file.parent.name, file) for file, _ in _named(listing, r".*_pred_specification\.json")]
    sets = {a.file.parent.parent for a in made if a.file is not None}
    if not made:
        errored = [file for file, _ in _named(listing, r"errored_texts\d+\.txt")]
        sets = {file.parent for file in errored}
    why = (
        "AIpparel wrote no pattern for this input: its answer could not be decoded (see errored_texts*.txt)."
    )
    empty = [Answer(folder.name, None, error=why) for folder in listing.leaves() if folder.parent in sets]
    return made + empty


def _chatgarment(listing: Listing) -> list[Answer]:
    """``vis_new/valid_garment_INPUT/valid_garment_upper/valid_garment_upper_specification.json``.

    A simulation copies the file into a folder of the same name below. The program of its postprocessing
    writes ``INPUT/valid_garment_upper/valid_garment_best``.
    """
    made, answered = [], set()
    for file, match in _named(listing, r"valid_garment_(upper|lower|wholebody|best)_specification\.json"):
        folder = file.parent
        if folder.name == folder.parent.name or folder.name != f"valid_garment_{match[1]}":
            continue
        part, answer = match[1], folder.parent
        if part == "best":
            part, answer = folder.parent.name.removeprefix("valid_garment_"), folder.parent.parent
        answered.add(answer)
        made.append(Answer(_chatgarment_input(answer), file, "" if part == "wholebody" else part))
    why = "ChatGarment wrote no pattern for this input: its answer fits no garment program (see output.txt)."
    failed = [
        Answer(_chatgarment_input(folder), None, error=why)
        for folder, names in listing.names_in.items()
        if folder.name.startswith("valid_garment_") and "output.txt" in names and folder not in answered
    ]
    return made + failed


def _chatgarment_input(folder: PurePosixPath) -> str:
    return _IMAGE.sub("", folder.name.removeprefix("valid_garment_"))


def _sewingldm(listing: Listing) -> list[Answer]:
    """``DATE_..._seed0_use_text/outside_dataset_outside_dataset_/...``, or ``INPUT__predicted_/...``."""
    made = [
        Answer(file.parent.parent.name, file)
        for file, match in _named(listing, r"(outside_dataset)_\1__specification\.json")
    ]
    return made + [
        Answer(match[1], file)
        for file, match in _named(listing, r"(.+)__predicted(?:_[^_]+)?__specification\.json")
    ]


def _sewformer(listing: Listing) -> list[Answer]:
    """``INPUT/_predicted_single_specification.json``; of SewFactory ``_predicted_specification.json``."""
    return [
        Answer(file.parent.name, file)
        for file, _ in _named(listing, r"_predicted_(?:single_|[\d.e+-]+_)?specification\.json")
    ]


def _dresscode(listing: Listing) -> list[Answer]:
    """``STAMP/000/pred_0/specification.json``.

    Where several garments are worn together it moves each away from the body for its simulation, and keeps
    what the network wrote in ``specification_backup.json``.
    """
    made, answered = [], set()
    for file, _ in _named(listing, r"specification(_backup)?\.json"):
        number = re.fullmatch(r"pred_(\d+)", file.parent.name)
        moved = (
            file.name == "specification.json" and "specification_backup.json" in listing.names_in[file.parent]
        )
        if number is None or moved:
            continue
        several = any(
            f.parent != file.parent and f.parent.parent == file.parent.parent for f in listing.files
        )
        answered.add(file.parent.parent)
        made.append(
            Answer(
                file.parent.parent.name,
                file,
                number[1] if several and number[1] != "0" else "",
            )
        )
    if not made:
        return []
    why = "DressCode wrote no pattern for this input: the network wrote no panels or invalid stitches."
    return made + [
        Answer(folder.name, None, error=why)
        for folder, names in listing.names_in.items()
        if "caption.txt" in names and folder not in answered
    ]


def _design2garmentcode(listing: Listing) -> list[Answer]:
    """``INPUT/INPUT.json`` with ``caption.json`` and ``gpt_respond.txt`` beside it, written before."""
    why = "Design2GarmentCode wrote no pattern for this input: no garment program fits its design parameters."
    found = []
    for folder, names in listing.names_in.items():
        if {"caption.json", "gpt_respond.txt"} <= names:
            name = f"{folder.name}.json"
            specifications = sorted(n for n in names if n.endswith(_ENDING))
            if name in names or specifications:
                found.append(Answer(folder.name, folder / (name if name in names else specifications[0])))
            else:
                found.append(Answer(folder.name, None, error=why))
    return found


def _pattern_generator(listing: Listing) -> list[Answer]:
    """``DATA/NAME/specification.json``; or all in one folder, with ``*_template_specification.json``."""
    made = [
        Answer(file.parent.name, file)
        for file, _ in _named(listing, r"specification\.json")
        if not re.fullmatch(r"pred_\d+", file.parent.name)
        and not any(n.startswith("_predicted_") for n in listing.names_in[file.parent])
    ]
    flat = {file.parent for file, _ in _named(listing, r".+_template_specification\.json")}
    return made + [
        Answer(match[1], file)
        for file, match in _named(listing, r"(.+)_specification\.json")
        if file.parent in flat and not _NOT_MADE.search(file.name)
    ]


def _garmentcode(listing: Listing) -> list[Answer]:
    """``NAME_specification.json`` anywhere; simulations copy it into a folder ``NAME`` below."""
    found = []
    for file, match in _named(listing, r"(.+)_specification\.json"):
        copy = file.parent.name == match[1] and file.name in listing.names_in.get(file.parent.parent, ())
        if not copy and not _NOT_MADE.search(file.name):
            found.append(Answer(match[1], file))
    return found


SPECIFIC = (
    Layout("aipparel", "AIpparel", "*_pred_specification.json", "extrinsic", _aipparel),
    Layout("chatgarment", "ChatGarment", "valid_garment_upper_specification.json", "intrinsic", _chatgarment),
    Layout(
        "sewingldm",
        "SewingLDM",
        "outside_dataset_outside_dataset__specification.json",
        "extrinsic",
        _sewingldm,
    ),
    Layout("sewformer", "Sewformer", "_predicted_single_specification.json", "extrinsic", _sewformer),
    Layout(
        "dresscode",
        "DressCode",
        "pred_0/specification.json",
        "extrinsic",
        _dresscode,
        place=_AROUND_THE_ORIGIN,
    ),
    Layout(
        "design2garmentcode",
        "Design2GarmentCode",
        "caption.json with gpt_respond.txt",
        "intrinsic",
        _design2garmentcode,
    ),
    Layout(
        "garment-pattern-generator",
        "Garment-Pattern-Generator",
        "NAME/specification.json",
        "extrinsic",
        _pattern_generator,
    ),
)
"""Systems whose file names tell them apart."""
PLAIN = Layout("garmentcode", "GarmentCode", "*_specification.json", "intrinsic", _garmentcode)
"""What other folders of patterns are."""
