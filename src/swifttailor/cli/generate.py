"""``swifttailor generate``: words or a picture to a sewing pattern and its garment."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from swifttailor.cli.making import Making
from swifttailor.cli.postponed_imports import tyro
from swifttailor.errors import InputError

_PICTURES = (".png", ".jpg", ".jpeg", ".webp", ".bmp", ".gif", ".tif", ".tiff")


@dataclass(frozen=True, kw_only=True)
class Generate(Making):
    """Make a sewing pattern and its garment from a description, a picture, or both.

    Writes pattern.json, pattern.svg, garment.glb, garment.obj, preview.png, ggi.npz and report.json into a
    folder.

    Exit code 0: made; 1: made, but read what it says, or some samples failed; 2: nothing was made.
    """

    text: Annotated[tyro.conf.Positional[str], tyro.conf.arg(metavar="TEXT")] = ""
    """What the garment should be, in English: "a knee-length sleeveless dress with a V neck"."""
    image: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Picture of one garment, best against a plain background: PNG, JPEG, WEBP, BMP, GIF or TIFF."""
    crop: bool = True
    """Crop the picture to its figure where the background is plain."""

    def run(self) -> int:
        """Makes what is asked for, prints what came of it, and returns the exit code.

        Raises:
            SwiftTailorError: Nothing could be made.
        """
        if not self.text.strip() and self.image is None:
            raise InputError(
                'Nothing was requested. Describe a garment: swifttailor generate "a long dress" --out DIR, '
                "or give a picture of one: --image FILE"
            )
        if self.image is None and Path(self.text.strip()).suffix.lower() in _PICTURES:
            raise InputError(
                f"'{self.text}' looks like a picture's name and was given as the text. To use the picture: "
                f"--image {self.text}"
            )
        self.require_options()
        return self.make(self.order(self.text, image=self.image, crop=self.crop))
