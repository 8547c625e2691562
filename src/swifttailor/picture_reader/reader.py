"""Reading pictures, with onnxruntime."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.errors import InputError
from swifttailor.networks.model_file import GRAPH, ModelKind, open_model
from swifttailor.picture_reader.close_looks import close_squares, with_close_designs, with_close_looks
from swifttailor.picture_reader.close_ups import CLOSE_UPS
from swifttailor.picture_reader.cut_square import cut_square
from swifttailor.picture_reader.figures import FIGURES
from swifttailor.picture_reader.hoods import with_hoods_of_near
from swifttailor.picture_reader.kinds_worn import BEFORE_PLAIN, kinds_as_worn
from swifttailor.picture_reader.labels import (
    GUESS,
    PARTS,
    labels_checksum,
    statement_labels,
)
from swifttailor.picture_reader.laid_heads import LaidHeads, name_told, with_told
from swifttailor.picture_reader.panel_kinds import PANEL_KINDS
from swifttailor.picture_reader.people_wear import as_people_wear
from swifttailor.picture_reader.person_finder import PersonFinder
from swifttailor.picture_reader.person_halves import View, mean_of, with_legs, with_neck
from swifttailor.picture_reader.photograph_head import LEAST_LOGIT, PhotographHead
from swifttailor.picture_reader.photographed import as_photograph, says_no_design, surely_somebody
from swifttailor.picture_reader.plain_pictures import one_colour_around
from swifttailor.picture_reader.print_head import PrintHead
from swifttailor.picture_reader.prints_read import with_prints
from swifttailor.picture_reader.reading import PictureReading
from swifttailor.picture_reader.said import certainties, parts_present, share_of
from swifttailor.picture_reader.said_reading import DESIGNS, reading_of
from swifttailor.picture_reader.squares import around, halves, scaled
from swifttailor.picture_reader.view import Square, view_in
from swifttailor.picture_reader.worn_heads import WornHeads
from swifttailor.picture_reader.worn_names import with_name
from swifttailor.picture_reader.worn_signs import WornSigns, with_signs, worn_below
from swifttailor.programs.read_parameter import ReadParameter
from swifttailor.render.pixels import require_picture

SHIPPED = Path(__file__).with_name("picture_reader.onnx")
SHIPPED_PLAIN = tuple(
    Path(__file__).with_name(f"plain_{name}.onnx") for name in ("reader", "neck", "details")
)
"""Reads all of a plain picture; necks; waists, armholes, ends of sleeves and skirts."""
SHIPPED_LAID = Path(__file__).with_name("laid_reader.onnx")
"""Reads pictures of garments that nobody wears."""
SHIPPED_SHOP = Path(__file__).with_name("shop_reader.onnx")
"""Tells photographs of people from drawings, and reads those before a plain ground, as shops show them."""
FROM_NEAR = ("neck", "waist", "sleeve")
"""Of close-ups, see `CloseUp.part`: what a network that reads whole garments looks at; anything else it reads
as well in a picture of all of the garment."""
INPUTS = ("pictures", "guess")
OUTPUTS = (
    "present",
    "statements",
    "has",
    "measures",
    "panels",
    "boxes",
    "camera_view",
    "figures",
    "masks",
    "worn_places",
    "panel_kinds",
    "seams",
)
KIND = ModelKind(
    "picture reader",
    "swifttailor picture-reader 1",
    2**28,
    ({GRAPH: (INPUTS, OUTPUTS)}, {GRAPH: (INPUTS, (*OUTPUTS, DESIGNS))}),
)
LEAST_LAID = 0.8
"""What is less surely a garment that nobody wears is read like others: to take a person for one is worse."""
LEAST_FOUND = 0.8
"""How sure somebody has to be dressed in a part of a picture, where nobody is seen in all of it."""
_SCALES, _SHOP_SCALES = (1.0, 0.87, 1.15), (1.0, 0.92, 1.1)
"""Sides of the frames of the nearer looks, in that around the garment; of photographs, in all of them."""
_OF_A_FRAME = ("camera_view", "masks", "worn_places", "panel_kinds", "seams")


@dataclass(frozen=True, eq=False)
class PictureReader:
    """Reads what pictures show."""

    session: Any
    """Of onnxruntime."""
    size: int
    """Pixels along each side of what it is shown."""
    scales: NDArray[np.float32]
    """(S, 2) factor and summand that make the logits of statements as sure as they are right."""
    card: dict[str, Any]
    """What it was trained on and how good it is."""
    close_ups: tuple[str, ...] = ()
    """Names of the `CLOSE_UPS` it has learnt from."""
    near: tuple[PictureReader, ...] = ()
    """Look at close-ups in its place, each at what it has learnt from; the last of several that have."""
    plain: Callable[[], PictureReader] | None = None
    """Gives the one that reads plain pictures together with it, and their details in its place."""
    laid: Callable[[], PictureReader] | None = None
    """Gives the one that reads garments that nobody wears, laid or hung, in its place."""
    shop: Callable[[], PictureReader] | None = None
    """Gives the one that tells photographs of people, and reads them in its place."""
    people: Callable[[], PersonFinder] | None = None
    """Gives what cuts people out of their photographs."""
    heads: Callable[[], WornHeads] | None = None
    """Gives what has seen nothing but photographs, and tells a few claims of somebody who is cut out."""
    photograph_head: Callable[[], PhotographHead] | None = None
    """Gives another that tells photographs from drawings, where the one in `shop` sees a drawing."""
    names: Callable[[], LaidHeads] | None = None
    """Gives what tells what clothes are called, of somebody who is cut out."""
    prints: Callable[[], PrintHead] | None = None
    """Gives what tells prints apart in photographs."""
    laid_heads: Callable[[], LaidHeads] | None = None
    """Gives what has seen nothing but photographs, and tells a few claims of what this network reads in such;
    of that for garments that nobody wears."""
    parameters: tuple[ReadParameter, ...] = ()
    """Design parameters that it reads."""
    near_designs: bool = False
    """Whether it reads them in close-ups, too."""

    @staticmethod
    def load(
        weights: Path | str | None = None,
        *,
        close_ups: Sequence[Path | str] | None = None,
        plain: Sequence[Path | str] | None = None,
        laid: Path | str | None = None,
        shop: Path | str | None = None,
        threads: int = 1,
    ) -> PictureReader:
        """Opens a model file.

        Args:
            weights: File; the ones that come with the package when None.
            close_ups: Files of networks that look at details, each at what it has learnt from; at what
                several have learnt from, the last of them looks. Without any the network looks at necks,
                waists and sleeves itself, if it has learnt to.
            plain: Files of the network that reads plain pictures, and of those that look at their details;
                where `weights` are given and these are not, plain pictures are read like others. They are
                opened with the first picture that may be plain.
            laid: File of the network that reads garments that nobody wears; where `weights` are given and
                this is not, they are read like others. It is opened with the first picture that is not plain.
            shop: The same for photographs of people.
            threads: CPU cores for the network.

        Raises:
            InputError: There is no such file, or it is damaged or another.
        """
        reader = PictureReader._opened(SHIPPED if weights is None else weights, threads)
        near = tuple(PictureReader._opened(file, threads) for file in close_ups or ())
        names = {one.name for one in CLOSE_UPS if one.part in FROM_NEAR}
        own = tuple(name for name in reader.close_ups if name in names)
        reader = replace(reader, close_ups=own, near=near)
        if weights is None:
            plain = SHIPPED_PLAIN if plain is None else plain
            laid = SHIPPED_LAID if laid is None else laid
            shop = SHIPPED_SHOP if shop is None else shop
        heads = cache(lambda: WornHeads.load(threads=threads))
        if laid or shop:
            prints = cache(lambda: PrintHead.load(heads().trunk, threads=threads))
            reader = replace(reader, prints=prints)
        if laid:
            told = cache(lambda: LaidHeads.load(heads().trunk, threads=threads))
            of_laid = cache(lambda: replace(PictureReader._opened(laid, threads), laid_heads=told))
            reader = replace(reader, laid=of_laid, names=told)
        if shop:
            people = cache(lambda: PersonFinder.load(threads=threads))
            reader = replace(reader, shop=cache(lambda: PictureReader._opened(shop, threads)), people=people)
            told_apart = cache(lambda: PhotographHead.load(heads().trunk, threads=threads))
            reader = replace(reader, heads=heads, photograph_head=told_apart)
        if not plain:
            return reader
        whole, *details = plain
        return replace(
            reader, plain=cache(lambda: PictureReader.load(whole, close_ups=details, threads=threads))
        )

    @staticmethod
    def _opened(weights: Path | str, threads: int) -> PictureReader:
        model = open_model(weights, KIND, threads=threads)
        with model.says("what it reads"):
            if model.about["labels_sha256"] != labels_checksum():
                raise InputError("it was trained for other statements than this version's")
            if tuple(model.about["panel_kinds"]) != PANEL_KINDS:
                raise InputError("it was trained for other kinds of panels than this version's")
            scales = np.array(model.about["scales"], np.float32)
            if scales.shape != (len(statement_labels()), 2) or not np.isfinite(scales).all():
                raise InputError(f"its scales have the shape {scales.shape}")
            close_ups = tuple(map(str, model.about.get("close_ups", ())))
            parameters = tuple(ReadParameter.from_json(one) for one in model.about.get("parameters", ()))
            near_designs = bool(model.about.get("near_designs", False))
        if parameters:
            most = max(len(one.values) for one in parameters)
            shape = [1, len(PARTS), len(parameters), most]
            model.require({"what it says of designs": (model.shape_made(GRAPH, DESIGNS), shape)})
        size = model.shape_given(GRAPH, "pictures")[-1]
        card = model.about.get("card", {})
        reader = PictureReader(model.sessions[GRAPH], int(size), scales, card, close_ups)
        return replace(reader, parameters=parameters, near_designs=near_designs)

    def read(self, pixels: Pixels) -> PictureReading:
        """What a picture shows.

        It is looked at whole for where the wearer is, then near each garment, and at last near its details;
        in a picture like those of GarmentCodeData, from near by networks as well that have learnt from no
        others. Garments that nobody wears are read by a network that knows nothing else, in photographs with
        another beside it (`laid_heads`); people in photographs are cut out first (`photographed`). Where all
        those say that it is not for them, what people seldom wear is believed less (`as_people_wear`).

        Args:
            pixels: (h, w, 3) sRGB, row 0 at the top.

        Raises:
            InputError: It is no picture of three colours.
        """
        require_picture(pixels)
        read = self._read(pixels)
        if self.prints is not None and read.is_photograph:
            read = with_prints(read, pixels, self.prints())
        return read

    def _read(self, pixels: Pixels) -> PictureReading:
        height, width = pixels.shape[:2]
        side = max(height, width)
        whole = ((width - side) // 2, (height - side) // 2, side)
        told = {} if self.laid_heads is None else self.laid_heads().told(pixels, whole)
        first = with_told(self._look(pixels, whole, None), told)
        nearer = self._looking_nearer(pixels, whole)
        laid = nearer is self and self.laid is not None and self.laid()._knows(pixels, whole, LEAST_LAID)
        looks_real = self._looks_real(pixels, whole)
        if laid and self.laid is not None and not surely_somebody(pixels, self.people):
            real, reader = looks_real(), self.laid()
            reader = reader if real else replace(reader, laid_heads=None)
            return replace(reader.read(pixels), is_laid=True, is_photograph=real)
        is_photograph = False
        if nearer is self and self.shop is not None:
            of_all = self.shop().at_frames((pixels, whole))
            shop = self.shop()
            read = as_photograph(
                (pixels, whole),
                of_all,
                self.people,
                shop.at_frames,
                self.heads,
                looks_real,
                self.names,
            )
            if read is not None:
                return read
            is_photograph = says_no_design(of_all) and of_all.figures != "none"
        if nearer is self:
            whole, first = self._searched(pixels, whole, first)
        seen: dict[int, tuple[Square, dict[str, Any]]] = {}
        waiting = [(k, whole, first) for k in parts_present(first)]
        while waiting:
            part, square, look = waiting.pop(0)
            if part not in seen:
                square = around(share_of(look["masks"][part]) > 0.5, square) or whole
                lookers = (self,) if nearer is self else (nearer, self)
                answers = nearer._nearer(pixels, part, square, whole, first, lookers)
                if nearer is self and self.plain is not None:
                    answers = as_people_wear(answers, self.parameters)
                answers = with_told(answers, told)
                seen[part] = square, answers
                waiting += [(k, *seen[part]) for k in parts_present(seen[part][1])]
        read = reading_of(first, whole, seen, (height, width), nearer.parameters)
        if called := name_told(told):
            read = replace(read, parts=tuple(replace(part, called=called) for part in read.parts))
        return replace(read, is_plain=nearer is not self, is_photograph=is_photograph)

    def _looks_real(self, pixels: Pixels, whole: Square) -> Callable[[], bool]:
        """Tells whether a picture looks like a photograph."""
        head = self.photograph_head
        return lambda: head is not None and head().logit(pixels, whole) >= LEAST_LOGIT

    def at_frames(
        self,
        *views: View,
        chest: View | None = None,
        legs: Sequence[View] | None = None,
        signs: WornSigns | None = None,
    ) -> PictureReading:
        """What is seen at three frames of each of some views of one picture, which somebody fills.

        Args:
            views: Pixels of all of it, and a square of it. The first tells where things are.
            chest: A view of the chest, for the neckline.
            legs: Views from the waist down, the first as above; None before a plain ground.
            signs: What else tells of what is worn.
        """
        pixels, whole = views[0]
        answers = self._at_frames(views)
        if chest is not None:
            answers = with_neck(answers, self._at_frames((chest,)))
        if legs is None:
            seen = with_legs((whole, kinds_as_worn(answers, BEFORE_PLAIN)), None)
        else:
            near = self._at_frames(legs) if legs else None
            below = worn_below(answers, near, signs.limbs) if signs else None
            nearer = (legs[0][1], kinds_as_worn(near)) if near else None
            seen = with_legs((whole, kinds_as_worn(answers)), nearer, below)
        if signs is not None:
            street = legs is not None
            seen = {k: (at, with_signs(told, signs, k, street=street)) for k, (at, told) in seen.items()}
        read = reading_of(answers, whole, seen, pixels.shape[:2], self.parameters)
        return read if signs is None else with_name(read, signs.called)

    def _at_frames(self, views: Sequence[View]) -> dict[str, Any]:
        frames = [(pixels, scaled(square, k)) for pixels, square in views for k in _SHOP_SCALES]
        looks = [self._look(*frame, None) for frame in frames]
        return mean_of(looks) | {name: looks[0][name] for name in _OF_A_FRAME}

    def _searched(
        self, pixels: Pixels, whole: Square, first: dict[str, Any]
    ) -> tuple[Square, dict[str, Any]]:
        """Where nobody is seen in all of a picture, the part in which somebody is, and a look at it."""
        figures = FIGURES[int(first["figures"].argmax())]
        if figures == "several" or (figures == "one" and parts_present(first)):
            return whole, first
        best = LEAST_FOUND
        for square in halves(pixels.shape[:2]):
            look = self._look(pixels, square, None)
            certain = float(certainties(look["figures"])[FIGURES.index("one")])
            certain *= float(share_of(look["present"]).max())
            if certain > best:
                best, whole, first = certain, square, look
        return whole, first

    def _looking_nearer(self, pixels: Pixels, whole: Square) -> PictureReader:
        """Who decides about garments and looks at details: of plain pictures those who know nothing else."""
        if self.plain is not None and one_colour_around(pixels):
            plain = self.plain()
            if plain._knows(pixels, whole):
                return plain
        return self

    def _knows(self, pixels: Pixels, whole: Square, least: float = 0.5) -> bool:
        """Whether a picture shows one person, or one garment, as far as this network knows what that is."""
        return bool(certainties(self._look(pixels, whole, None)["figures"])[FIGURES.index("one")] > least)

    def _nearer(
        self,
        pixels: Pixels,
        part: int,
        square: Square,
        whole: Square,
        first: dict[str, Any],
        lookers: Sequence[PictureReader],
    ) -> dict[str, Any]:
        """Three looks of each looker at much the same, whose mean is steadier, and at details.

        Where things are is of the first look alone, and designs are of those who read the same parameters.
        """
        squares = [(one, scaled(square, scale)) for one in lookers for scale in _SCALES]
        looks = [one._look(pixels, at, view_in(first["camera_view"], whole, at)) for one, at in squares]
        answers = {name: np.mean([look[name] for look in looks], axis=0) for name in OUTPUTS}
        if self.parameters:
            alike = [k for k, (one, _) in enumerate(squares) if one.parameters == self.parameters]
            answers[DESIGNS] = np.mean([looks[k][DESIGNS] for k in alike], axis=0)
        answers |= {name: looks[0][name] for name in _OF_A_FRAME}
        view = answers["camera_view"]
        looker_of = {name: looker for looker in self.near or (self,) for name in looker.close_ups}
        near = {
            number: looker_of[CLOSE_UPS[number].name]._look(pixels, detail, view_in(view, square, detail))
            for number, detail in close_squares(answers, part, square, tuple(looker_of)).items()
        }
        altogether = with_close_looks(answers, part, near)
        if self.parameters:
            telling = {k: look for k, look in near.items() if self._tells_designs(looker_of, k)}
            altogether[DESIGNS] = with_close_designs(answers[DESIGNS], part, telling, self.parameters)
        return with_hoods_of_near(altogether, answers, part, self.parameters)

    def _tells_designs(self, looker_of: Mapping[str, PictureReader], number: int) -> bool:
        """Whether who looks at a close-up says of it the design parameters that this network says."""
        looker = looker_of[CLOSE_UPS[number].name]
        return looker.near_designs and looker.parameters == self.parameters

    def _look(self, pixels: Pixels, square: Square, view: NDArray[np.float32] | None) -> dict[str, Any]:
        shown = cut_square(pixels, square, self.size)
        batch = np.ascontiguousarray(shown.transpose(2, 0, 1)[None], np.float32) / 255
        guess = np.zeros((1, len(GUESS)), np.float32)
        if view is not None:
            guess[0] = (*view, 1)
        names = (*OUTPUTS, DESIGNS) if self.parameters else OUTPUTS
        found = self.session.run(list(names), {"pictures": batch, "guess": guess})
        answers = {name: value[0] for name, value in zip(names, found, strict=True)}
        return answers | {"statements": answers["statements"] * self.scales[:, 0] + self.scales[:, 1]}
