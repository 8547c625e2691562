"""Garments to draw, packed for a journey: 9 kB each in place of 170.

What a `PictureBank` keeps of garments, without what can be computed again (who carries a vertex) and with
vertices and triangles in an order in which neighbours differ little. Positions are rounded to half a
millimetre. Meshing cannot be left to the other end: another scipy makes other triangles of the same panel.
"""

from __future__ import annotations

import json
import lzma
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.body.rig import Rig
from swifttailor.body.worn import garment_weights
from swifttailor.data.array_cache import ENDS, Arrays
from swifttailor.data.pictures.bank import UNIT_CM
from swifttailor.errors import InputError

COARSER = 5
"""Units of `bank.UNIT_CM` that positions are rounded to."""
_ROW = 250 // COARSER
"""Height of the rows in which the vertices of a panel are numbered, in rounded units: about an edge."""
_MESH = (
    *("vertices", "faces", "face_panel", "flat", "flat_faces"),
    *("seams", "borders", "carrier", "share"),
)
_COUNTS = ("vertices", "faces", "flat", "seams", "borders")
_SIZE_BYTES = 4
_Ints = NDArray[np.int64]


def pack(arrays: Mapping[str, NDArray[Any]]) -> bytes:
    """Packs garments.

    Args:
        arrays: Columns of some garments joined, and their ends, as `ArrayCache` writes them.
    """
    from safetensors.numpy import save

    count = len(arrays["digest" + ENDS])
    rows: dict[str, list[_Ints]] = {}
    for k in range(count):
        for name, value in _differences({name: _of(arrays, name, k) for name in _MESH}).items():
            rows.setdefault(name, []).append(value)
    columns = {name: _planes(np.concatenate(values)) for name, values in rows.items()}
    small = save({name: v for name, v in arrays.items() if name.removesuffix(ENDS) not in _MESH})
    about = json.dumps({"garments": count, "columns": {name: len(v) for name, v in columns.items()}}).encode()
    head = b"".join(len(part).to_bytes(_SIZE_BYTES, "little") for part in (about, small))
    return lzma.compress(head + about + small + b"".join(columns.values()), preset=6)


def unpack(data: bytes) -> Arrays:
    """What was packed, as `ArrayCache` writes it.

    Raises:
        InputError: These are no packed garments.
    """
    from safetensors import SafetensorError
    from safetensors.numpy import load

    try:
        raw = lzma.decompress(data)
        sizes = [int.from_bytes(raw[_SIZE_BYTES * k :][:_SIZE_BYTES], "little") for k in range(2)]
        at = 2 * _SIZE_BYTES
        about = json.loads(raw[at : at + sizes[0]])
        found: Arrays = dict(load(raw[at + sizes[0] : at + sum(sizes)]))
        at += sum(sizes)
        columns = {}
        for name, size in about["columns"].items():
            columns[name] = _from_planes(raw[at : at + size])
            at += size
    except (lzma.LZMAError, SafetensorError, ValueError, KeyError, TypeError) as error:
        raise InputError(
            f"These are no packed garments: {error}. Pack them again: scripts/pack_worn_garments.py"
        ) from error
    counts = columns.pop("counts").reshape(-1, len(_COUNTS))
    rig, made = Rig.default(), {name: [] for name in _MESH}
    starts = dict.fromkeys(columns, 0)
    for row in counts:
        part = {}
        for name in columns:
            size = int(row[_COUNTS.index(name.split(" ")[0])]) * _WIDTHS.get(name, 1)
            part[name] = columns[name][starts[name] : starts[name] + size]
            starts[name] += size
        for name, value in _meshes(part, rig).items():
            made[name].append(value)
    for name, values in made.items():
        found[name] = np.concatenate(values)
        found[name + ENDS] = np.cumsum([len(v) for v in values])
    return found


_WIDTHS = {"vertices": 3, "flat": 2, "seams": 2, "borders": 2}
"""Of the columns that are tables."""


def _of(arrays: Mapping[str, NDArray[Any]], name: str, k: int) -> NDArray[Any]:
    ends = arrays[name + ENDS]
    return arrays[name][int(ends[k - 1]) if k else 0 : int(ends[k])]


def _differences(mesh: Mapping[str, NDArray[Any]]) -> dict[str, _Ints]:
    """A garment in numbers that are mostly small."""
    flat = np.round(mesh["flat"] / COARSER).astype(np.int64)
    flat_faces, panels = mesh["flat_faces"].astype(np.int64), mesh["face_panel"].astype(np.int64)
    welded, panel_of = np.zeros((2, len(flat)), np.int64)
    welded[flat_faces.ravel()] = mesh["faces"].ravel()
    panel_of[flat_faces.ravel()] = np.repeat(panels, 3)
    # Panel by panel, row by row, from left to right.
    order = np.lexsort((flat[:, 0], np.round(flat[:, 1] / _ROW), panel_of))
    flat, flat_faces, welded = flat[order], _places(order)[flat_faces], welded[order]
    # Sewn vertices are numbered as the flat ones first come to them.
    firsts = np.sort(np.unique(welded, return_index=True)[1])
    sewn = welded[firsts]
    number = np.zeros(len(mesh["vertices"]), np.int64)
    number[sewn] = np.arange(len(sewn))
    welded = number[welded]
    first = flat_faces.argmin(axis=1)[:, None]
    flat_faces = np.take_along_axis(flat_faces, (first + np.arange(3)) % 3, axis=1)
    order = np.lexsort((flat_faces[:, 1], flat_faces[:, 0], panels))
    flat_faces, panels = flat_faces[order], panels[order]
    highest = np.maximum.accumulate(welded)
    is_new = np.diff(highest, prepend=-1) > 0
    vertices = np.round(mesh["vertices"][sewn] / COARSER).astype(np.int64)
    lines = {name: number[mesh[name].astype(np.int64)].reshape(-1, 2) for name in ("seams", "borders")}
    return {
        "counts": np.array([len(vertices), len(flat_faces), len(flat), *(len(v) for v in lines.values())]),
        "vertices": np.diff(vertices, axis=0, prepend=0).ravel(),
        "faces first": np.diff(flat_faces[:, 0], prepend=0),
        "faces second": flat_faces[:, 1] - flat_faces[:, 0],
        "faces third": flat_faces[:, 2] - flat_faces[:, 1],
        "faces panel": np.diff(panels, prepend=0),
        "flat": np.diff(flat, axis=0, prepend=0).ravel(),
        "flat welded": np.where(is_new, 0, highest - welded + 1),
        **{
            name: np.stack([np.diff(v[:, 0], prepend=0), v[:, 1] - v[:, 0]], axis=1).ravel()
            for name, v in lines.items()
        },
    }


def _meshes(part: Mapping[str, _Ints], rig: Rig) -> Arrays:
    """What `_differences` was told, and who carries it."""
    first = np.cumsum(part["faces first"])
    second = first + part["faces second"]
    flat_faces = np.stack([first, second, second + part["faces third"]], axis=1)
    is_new = part["flat welded"] == 0
    highest = np.cumsum(is_new) - 1
    welded = np.where(is_new, highest, highest - part["flat welded"] + 1)
    faces = welded[flat_faces]
    vertices = COARSER * np.cumsum(part["vertices"].reshape(-1, 3), axis=0)
    carried = garment_weights(rig, vertices * UNIT_CM, faces)
    lines = {}
    for name in ("seams", "borders"):
        step, length = part[name].reshape(-1, 2).T
        start = np.cumsum(step)
        lines[name] = np.stack([start, start + length], axis=1).astype(np.int32)
    return {
        "vertices": vertices.astype(np.int16),
        "faces": faces.astype(np.int32),
        "face_panel": np.cumsum(part["faces panel"]).astype(np.int16),
        "flat": (COARSER * np.cumsum(part["flat"].reshape(-1, 2), axis=0)).astype(np.int16),
        "flat_faces": flat_faces.astype(np.int32),
        **lines,
        "carrier": carried.carrier,
        "share": carried.share.astype(np.float16),
    }


def _places(order: _Ints) -> _Ints:
    """Where each thing lies in an order."""
    places = np.empty_like(order)
    places[order] = np.arange(len(order))
    return places


def _planes(values: _Ints) -> bytes:
    """Low bytes, then high bytes, of numbers whose sign is their lowest bit."""
    folded = (values << 1) ^ (values >> 63)
    if folded.max(initial=0) > np.iinfo(np.uint16).max:
        raise InputError(f"A garment has a difference of {values[folded.argmax()]}; 16 bits are accepted.")
    return folded.astype("<u2").view(np.uint8).reshape(-1, 2).T.tobytes()


def _from_planes(data: bytes) -> _Ints:
    folded = np.frombuffer(data, np.uint8).reshape(2, -1).T.copy().view("<u2")[:, 0].astype(np.int64)
    return (folded >> 1) ^ -(folded & 1)
