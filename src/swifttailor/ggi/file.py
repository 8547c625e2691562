"""The file ``ggi.npz``: a Garment Geometry Image that any numpy can read, without pickle.

Positions are stored in 16 bits: the range of each axis in 65535 steps, so that the error is half a step, at
most 0.002 cm for a garment of two metres. What is empty is stored as 0 and means nothing. The arrays:

======================  =====================  ==========================================================
``about``               bytes of JSON          format, version, resolution, error; pattern and scale
``occupancy``           (N, N) bool            row 0 at the bottom
``panel``               (N, N) int16           panel index, -1 outside
``semantic``            (N, N) uint8           panel type
``stitch``              (N, N) uint16          stitch number + 1, 0 elsewhere
``seam_pixels``         (n,) int32             `StitchingImage.pixels`
``seam_fraction``       (n,) float32           `StitchingImage.fraction`
``seam_start``          (2 s + 1,) int32       `StitchingImage.start`
``geometry``            (N, N, 3) uint16       only with a drape; cm = low + step * value
``geometry_low_step``   (2, 3) float64         only with a drape
``origins``             (p, 2) float64         only with a layout
``mirrored``            (p,) bool              only with a layout
======================  =====================  ==========================================================
"""

from __future__ import annotations

import io
import json
import struct
import zipfile
import zlib
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor import __version__
from swifttailor.arrays import read_npy_header
from swifttailor.atomic_files import write_bytes
from swifttailor.errors import InputError, PatternError, SwiftTailorError
from swifttailor.garment.folder import GGI
from swifttailor.ggi.images import GarmentGeometryImage
from swifttailor.ggi.layout import MAX_RESOLUTION, MIN_RESOLUTION, Layout
from swifttailor.ggi.raster import MAX_CROSSINGS
from swifttailor.ggi.semantic import PANEL_TYPES
from swifttailor.ggi.stitching import StitchingImage
from swifttailor.pattern import Severity, read_specification, to_specification
from swifttailor.pattern.json_values import MAX_FILE_BYTES, parse_json

GGI_FILE = GGI
FORMAT, VERSION = "swifttailor garment geometry image", 1
STEPS = 65535

# RuntimeError and NotImplementedError: a compression or encryption that zipfile lacks.
_UNREADABLE = (
    OSError,
    ValueError,
    KeyError,
    EOFError,
    RuntimeError,
    zipfile.BadZipFile,
    zlib.error,
    struct.error,
)
_MAX_PANELS = 500
_MAX_SIDES = 40_001
_SEAMS_PER_PIXEL = 8
"""Most times that all pixels may be sewn, on average."""
_LAYOUT = ("origins", "mirrored")
_GEOMETRY = ("geometry", "geometry_low_step")


def write_ggi(images: GarmentGeometryImage, path: Path | str, *, overwrite: bool = False) -> Path:
    """Writes the file, whole or not at all, and returns its path. Equal images give equal bytes.

    Raises:
        InputError: The file cannot be written, there is another and not `overwrite`, the geometry is not
            finite, the panels are stretched, or the pattern's placements are not all read the same way.
    """
    about: dict[str, Any] = {
        "format": FORMAT,
        "version": VERSION,
        "swifttailor": __version__,
        "resolution": images.resolution,
    }
    arrays: dict[str, NDArray[Any]] = {
        "occupancy": images.occupancy,
        "panel": images.panel,
        "semantic": images.semantic,
        "stitch": images.stitching.ids,
        "seam_pixels": images.stitching.pixels,
        "seam_fraction": images.stitching.fraction,
        "seam_start": images.stitching.start,
    }
    if images.layout is not None:
        layout = images.layout
        if layout.stretch is not None:
            raise InputError(
                "ggi.npz holds panels at one scale, and in this layout each is stretched to a cell of its "
                "own. Use one made with lay_out(), or encode()."
            )
        about["cm_per_pixel"] = layout.cm_per_pixel
        about["name"] = layout.pattern.name
        about["rotation"] = _one_reading(layout)
        about["pattern"] = to_specification(layout.pattern)
        arrays |= {"origins": layout.origins, "mirrored": layout.mirrored}
    if images.geometry is not None:
        steps, low_step = quantize(images.geometry, images.occupancy)
        about["max_error_cm"] = float(low_step[1].max() / 2)
        arrays |= {"geometry": steps, "geometry_low_step": low_step}
    text = json.dumps(about, allow_nan=False, separators=(",", ":"))
    arrays = {"about": np.frombuffer(text.encode(), np.uint8), **arrays}
    content = io.BytesIO()
    np.savez_compressed(content, allow_pickle=False, **arrays)
    return write_bytes(path, content.getvalue(), overwrite=overwrite)


def _one_reading(layout: Layout) -> str:
    """How the placement angles are meant; one reading holds for a whole file, as for GarmentCode's."""
    readings = sorted({p.placement.reading for p in layout.pattern.panels})
    if len(readings) != 1:
        raise InputError(
            f"The pattern's placements are read in {len(readings)} ways ({', '.join(readings)}), and a file "
            "has one. Make them alike with Pattern.with_rotation_reading()."
        )
    return readings[0]


def quantize(
    geometry: NDArray[np.float32], occupancy: NDArray[np.bool_]
) -> tuple[NDArray[np.uint16], NDArray[np.float64]]:
    """Positions in 16 bits.

    Returns:
        Steps (N, N, 3), 0 where nothing is, and the lowest position and the size of a step (2, 3) in cm.

    Raises:
        InputError: An occupied pixel has a position that is not finite.
    """
    values = geometry[occupancy].astype(np.float64)
    if not np.isfinite(values).all():
        raise InputError("The geometry image holds positions that are not finite; it cannot be stored.")
    low = values.min(axis=0, initial=np.inf) if len(values) else np.zeros(3)
    high = values.max(axis=0, initial=-np.inf) if len(values) else np.zeros(3)
    step = (high - low) / STEPS
    steps = np.zeros(geometry.shape, np.uint16)
    steps[occupancy] = np.round((values - low) / np.where(step > 0, step, 1.0)).astype(np.uint16)
    return steps, np.stack([low, step])


def dequantize(
    steps: NDArray[np.uint16], low_step: NDArray[np.float64], occupancy: NDArray[np.bool_]
) -> NDArray[np.float32]:
    """Positions (N, N, 3) in cm from `quantize`; 0 where nothing is."""
    geometry = np.zeros(steps.shape, np.float32)
    for axis, (low, step) in enumerate(low_step.T):  # one at a time: doubles of all would need the memory
        geometry[..., axis][occupancy] = low + step * steps[..., axis][occupancy]
    return geometry


def read_ggi(path: Path | str) -> GarmentGeometryImage:
    """Reads a file of `write_ggi`. Nothing in the file is run, and no more memory used than it may need.

    Raises:
        InputError: The file cannot be read, is none of these, or contradicts itself.
    """
    path = Path(path)
    try:
        with zipfile.ZipFile(path) as archive:
            return _read(archive)
    except _UNREADABLE as error:
        why = getattr(error, "strerror", None) or error
        raise InputError(
            f"Cannot read '{path}' as a {GGI_FILE}: {why}. Give a file that swifttailor ggi has written."
        ) from error
    except SwiftTailorError as error:
        raise InputError(f"Cannot read '{path}' as a {GGI_FILE}: {error}") from error


def _read(archive: zipfile.ZipFile) -> GarmentGeometryImage:
    about = parse_json(_member(archive, "about", np.uint8, (None,), MAX_FILE_BYTES).tobytes(), "about")
    if not isinstance(about, dict) or about.get("format") != FORMAT:
        raise InputError("it is of another format. Make one with: swifttailor ggi PATTERN --out DIR")
    if about.get("version") != VERSION:
        raise InputError(
            f"it is of version {about.get('version')!r} and this program reads version {VERSION}. "
            "Make it again from its pattern, or use the version of SwiftTailor that made it."
        )
    size = about.get("resolution")
    if not isinstance(size, int) or isinstance(size, bool) or not MIN_RESOLUTION <= size <= MAX_RESOLUTION:
        raise InputError(
            f"its resolution is {size!r}; from {MIN_RESOLUTION} to {MAX_RESOLUTION} is accepted."
        )
    square, most = (size, size), min(_SEAMS_PER_PIXEL * size * size, MAX_CROSSINGS)
    occupancy = _member(archive, "occupancy", np.bool_, square)
    panel = _member(archive, "panel", np.int16, square)
    semantic = _member(archive, "semantic", np.uint8, square)
    stitching = StitchingImage(
        _member(archive, "stitch", np.uint16, square),
        _member(archive, "seam_pixels", np.int32, (None,), most),
        _member(archive, "seam_fraction", np.float32, (None,), most),
        _member(archive, "seam_start", np.int32, (None,), _MAX_SIDES),
    )
    names = {n.removesuffix(".npy") for n in archive.namelist()}
    geometry = layout = None
    if names & set(_GEOMETRY):
        low_step = _member(archive, "geometry_low_step", np.float64, (2, 3))
        _require(np.isfinite(low_step).all() and (low_step[1] >= 0).all(), "its positions have no scale")
        geometry = dequantize(_member(archive, "geometry", np.uint16, (*square, 3)), low_step, occupancy)
    if names & set(_LAYOUT):
        layout = _layout(archive, about, size)
    images = GarmentGeometryImage(layout, occupancy, panel, semantic, stitching, geometry)
    _check(images)
    return images


def _layout(archive: zipfile.ZipFile, about: dict[str, Any], size: int) -> Layout:
    reading = read_specification(
        about.get("pattern"), name=str(about.get("name", "pattern")), rotation=about.get("rotation", "")
    )
    errors = [f for f in reading.findings if f.severity is Severity.ERROR]
    if errors:
        raise PatternError(f"its pattern cannot be used: {errors[0].message}.")
    scale = about.get("cm_per_pixel")
    if not isinstance(scale, float):
        raise InputError(f"its scale is {scale!r}; a number of cm per pixel is expected.")
    return Layout(
        reading.pattern.canonical(),
        size,
        scale,
        _member(archive, "origins", np.float64, (None, 2), _MAX_PANELS),
        _member(archive, "mirrored", np.bool_, (None,), _MAX_PANELS),
    )


def _member(
    archive: zipfile.ZipFile,
    name: str,
    dtype: type[np.generic],
    shape: tuple[int | None, ...],
    most: int = 0,
) -> NDArray[Any]:
    """One array of the file, refused before memory is given to it where it is not as it must be.

    Args:
        archive: The file.
        name: The array's name.
        dtype: Its type.
        shape: Its shape; None for a length that may vary, up to `most`.
        most: See `shape`.
    """
    expected = np.dtype(dtype)
    try:
        member = archive.open(f"{name}.npy")
    except KeyError:
        raise InputError(f"the array '{name}' is missing; the file is incomplete.") from None
    with member:
        try:
            found, fortran, kind = read_npy_header(member)
        except ValueError as error:
            raise InputError(f"the array '{name}' is no numpy array: {error}.") from error
        fits = len(found) == len(shape) and all(
            0 <= n <= most if wanted is None else n == wanted for n, wanted in zip(found, shape, strict=True)
        )
        if not fits or fortran or kind != expected:
            wanted = "x".join("n" if n is None else str(n) for n in shape)
            raise InputError(
                f"the array '{name}' is {'x'.join(map(str, found))} {kind}; {wanted} {expected} is expected."
            )
        length = int(np.prod(found, dtype=np.int64)) * expected.itemsize
        data = member.read(length + 1)
    if len(data) != length:
        raise InputError(f"the array '{name}' is cut short or too long.")
    if expected == np.bool_:  # bytes other than 0 and 1 are no bool
        return (np.frombuffer(data, np.uint8) != 0).reshape(found)
    return np.frombuffer(data, expected).reshape(found).copy()


def _check(images: GarmentGeometryImage) -> None:
    """Refuses images that contradict each other, which later steps rely on."""
    stitching, size = images.stitching, images.resolution
    panels = len(images.layout.pattern.panels) if images.layout is not None else _MAX_PANELS
    _require((images.panel >= -1).all() and (images.panel < panels).all(), "it names panels it does not have")
    _require(np.array_equal(images.panel >= 0, images.occupancy), "its panels and its occupancy differ")
    _require(np.array_equal(images.semantic > 0, images.occupancy), "its types and its occupancy differ")
    _require((images.semantic < len(PANEL_TYPES)).all(), "it has panel types that do not exist")
    start, pixels = stitching.start, stitching.pixels
    sound = len(start) % 2 == 1 and start[0] == 0 and start[-1] == len(pixels) and (np.diff(start) >= 0).all()
    _require(sound and len(stitching.fraction) == len(pixels), "its seams have no order")
    _require((stitching.ids <= stitching.stitch_count).all(), "it names stitches it does not have")
    _require(((pixels >= 0) & (pixels < size * size)).all(), "its seams leave the image")
    _require(images.occupancy.ravel()[pixels].all(), "its seams run through empty pixels")
    fraction = stitching.fraction
    _require(((fraction >= 0) & (fraction <= 1)).all(), "its seams have places outside themselves")
    if images.layout is not None:
        boxes = images.layout.boxes
        _require((boxes >= 0).all() and (boxes < size).all(), "its layout leaves the image")
        same = np.array_equal(images.layout.raster.panel, images.panel)
        _require(same, "its images do not belong to its layout")


def _require(holds: Any, otherwise: str) -> None:
    if not holds:
        raise InputError(f"{otherwise}. The file is damaged; make it again.")
