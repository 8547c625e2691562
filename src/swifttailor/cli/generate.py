"""``swifttailor generate``: words or a picture to a sewing pattern and its garment."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from swifttailor.cli.making import PICTURES, Making
from swifttailor.cli.picture_reader_files import chosen_reader
from swifttailor.cli.postponed_imports import tyro
from swifttailor.cli.results import new_place
from swifttailor.errors import InputError

if TYPE_CHECKING:
    from swifttailor.pattern.drafted_for import DraftedFor
    from swifttailor.tailor import Order, Tailor

_BOTH = ("upper", "lower")


@dataclass(frozen=True, kw_only=True)
class Generate(Making):
    """Make a sewing pattern and its garment from a description, a picture, or both.

    Writes pattern.json, pattern.svg, garment.glb, garment.obj, preview.png, ggi.npz and report.json into a
    folder; with a picture also seen.png, what was looked at.

    Exit code 0: made, and all that was understood holds; 1: made, but read what it says, or some samples
    failed, or no garment was found in the picture; 2: nothing was made.
    """

    asks_for = "Say what to make, in quotes, or give a picture with --image."
    example = '"a knee-length dress with a V neck" --out dress'

    text: Annotated[tyro.conf.Positional[str], tyro.conf.arg(metavar="TEXT")] = ""
    """What the garment should be, in English: "a knee-length sleeveless dress with a V neck"."""
    image: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE")] = ()
    """Picture of a garment, or of one person: PNG, JPEG, WEBP, BMP, GIF or TIFF. Give two for the front and
    the back of one garment. What TEXT says outranks it."""
    part: Literal["upper", "lower", "whole", "beside"] | None = None
    """Which garment in the picture, or of those that TEXT names: on the upper body (or on top of the other),
    on the lower (or beneath), one dress, jumpsuit or other single garment, or a third beside two. Default:
    all; several get a folder each in DIR."""
    read: tyro.conf.FlagCreatePairsOff[bool] = False
    """Only read the picture: print what it shows, write seen.png and reading.json."""
    source: Literal["both", "drafts", "designs", "library", "writer"] = "both"
    """Where patterns come from. both: from a draft where the text names a garment that only that shows, else
    of a picture alone drafted by GarmentCode's programs from design parameters that are read in it, else from
    the library of known patterns, and where none of these will do PatternMaker writes one; or one of the four
    alone."""
    refine: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Drafted and known patterns that are sewn and compared with the picture, of which the most alike is
    taken; 4 without it, and 0 to compare none."""
    crop: bool = True
    """Show PatternMaker the picture cropped to its figure where the background is plain."""

    picture_reader_weights: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Model file (.onnx) of a trained picture reader. Default: the one in the package."""
    close_up_weights: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")] = ()
    """Model files (.onnx) of networks that look at details from near, each at what it has learnt from, beside
    --picture-reader-weights. Default: that one looks itself, if it was trained to."""
    plain_reader_weights: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")] = ()
    """Model files (.onnx) of a network that reads pictures like GarmentCodeData's, and of those that look
    at their details, beside --picture-reader-weights. Default: that one reads all pictures."""
    laid_reader_weights: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Model file (.onnx) of a network that reads pictures of garments that nobody wears, beside
    --picture-reader-weights. Default: that one reads them, too."""
    shop_reader_weights: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Model file (.onnx) of a network that tells photographs of people and reads those by shops, beside
    --picture-reader-weights. Default: that one reads them, too."""
    pattern_library: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Library (.zip) of known patterns. Default: the one in the package."""

    def run(self) -> int:
        """Makes what is asked for, prints what came of it, and returns the exit code.

        Raises:
            SwiftTailorError: Nothing could be made.
        """
        self._require_request()
        self.require_options()
        if self.read:
            from swifttailor.cli.read_pictures import read_pictures

            return read_pictures(self)
        order = self.order(
            self.text,
            image=self.image or None,
            crop=self.crop,
            part=self.part,
            source=self.source,
            refine=self.refine,
        )
        return self.make(order)

    def usual_place(self) -> Path:
        """Named after what is asked for."""
        return new_place(self.text.strip() or self.image[0].stem)

    def sources(self) -> tuple[Path, ...]:
        """The pictures."""
        return self.image

    def shows_what_is_seen(self) -> bool:
        """Whether pictures are read."""
        return bool(self.image)

    def tailor(self, before: DraftedFor | None = None, **networks: Any) -> Tailor:
        """Who makes the garments, and reads the pictures."""
        reader = chosen_reader(
            self.picture_reader_weights,
            self.close_up_weights,
            self.plain_reader_weights,
            self.laid_reader_weights,
            self.shop_reader_weights,
        )
        return super().tailor(before, picture_reader=reader, pattern_library=self.pattern_library, **networks)

    def several(self, tailor: Tailor, order: Order) -> dict[str, Order]:
        """Both garments of a text that names two, or of a picture that shows two, unless one is asked for.

        Raises:
            InputError: A picture cannot be read.
        """
        from swifttailor.tailor.all_parts import orders_of_parts

        parts = orders_of_parts(order, tailor)
        return {"" if len(parts) == 1 else name: one for name, one in parts.items()}

    def folders_within(self) -> tuple[str, ...]:
        """Of the garments of a text that names two, or of a picture that shows two."""
        if self.part is not None:
            return ("",)
        if self.image:
            return ("", *_BOTH)
        from swifttailor.wishes.outfits.two_garments import two_garments

        outfit = two_garments(self.text)
        if outfit is None:
            return ("",)
        return (*_BOTH, "beside") if outfit.third else _BOTH

    def _require_request(self) -> None:
        if not self.text.strip() and not self.image:
            raise self.nothing_requested()
        if not self.image and Path(self.text.strip()).suffix.lower() in PICTURES:
            raise InputError(
                f"'{self.text}' looks like a picture's name and was given as the text. To use the picture: "
                f"--image {self.text}"
            )
        for path in self.image[1:]:
            if path.suffix.lower() not in PICTURES and not path.exists():
                raise InputError(
                    f"'{path}' was given as a picture, and there is no such file. Put the text before "
                    f'--image: swifttailor generate "{path}" --image {self.image[0]}'
                )
        if self.part in _BOTH and not self.image:
            from swifttailor.wishes.outfits.two_garments import two_garments

            if two_garments(self.text) is None:
                raise InputError(
                    f"--part {self.part} chooses one of two garments. There is no picture, and the text "
                    "names no two, one for the upper body and one for the lower. Leave it out."
                )
        for option, given in (
            ("--read", self.read),
            ("--refine", self.refine is not None),
        ):
            if given and not self.image:
                raise InputError(f"{option} is about a picture, and there is none. Give one: --image FILE")
