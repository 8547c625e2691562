"""What a tailor works with: networks and the library, each opened when it is first needed."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Self

from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.tailor.order import Order
from swifttailor.tailor.protocols import PatternWriter, Sewer

if TYPE_CHECKING:
    from swifttailor.body import Body
    from swifttailor.draping.fabric import Fabric
    from swifttailor.parameter_reader.reader import ParameterReader
    from swifttailor.pattern_library.known import PatternLibrary
    from swifttailor.pattern_maker.panel_foresight import PanelForesight
    from swifttailor.tailor.looking import ReadsPictures
    from swifttailor.wishes.reader import WishReader


class Workshop:
    """Networks, the library of known patterns, and who wears what is made."""

    def __init__(
        self,
        pattern_maker: PatternWriter | Path | str | None = None,
        garment_sewer: Sewer | Path | str | None = None,
        *,
        wish_reader: WishReader | Path | str | None = None,
        picture_reader: ReadsPictures | Path | str | None = None,
        pattern_library: PatternLibrary | Path | str | None = None,
        parameter_reader: ParameterReader | Path | str | None = None,
        body: Body | None = None,
        fabric: Fabric | str = "cotton",
        fit: bool = False,
        threads: int = 1,
    ) -> None:
        """Prepares to work; a network is opened when it is first needed.

        Args:
            pattern_maker: What writes patterns: a `PatternMaker`, the model file of one, or anything that
                does what `protocols.PatternWriter` says; the one that comes with the package when None.
            garment_sewer: What sews them: a `GarmentSewer`, the model file of one, or anything that does what
                `protocols.Sewer` says; the one that comes with the package when None.
            wish_reader: The network that reads what texts ask for, or its model file; the one that comes with
                the package when None.
            picture_reader: The network that reads what pictures show, its model file, or anything that does
                what `looking.ReadsPictures` says; the one that comes with the package when None.
            pattern_library: Known patterns, tried before any is written, or their file; those that come with
                the package when None, unless a writer or weights of your own are given: these write them all.
            parameter_reader: The network that reads design parameters to draft patterns from, or its model
                file; the one that comes with the package when None, unless a writer, weights or a library of
                your own are given.
            body: Who wears the garments: a `GarmentSewer` sews them around it and keeps them out of it,
                physics hangs them on it (`finish`), and previews show it. Somebody else's sewer has to know
                it by itself. The default body when None.
            fabric: What hangs where garments are finished by physics: a `Fabric` or the name of a preset.
            fit: Whether patterns are refitted to `body`; else they are sewn on it as they were drafted, for
                the default body or the one that a pattern names.
            threads: CPU cores for the networks.
        """
        self.fits = fit
        self._maker, self._sewer, self._reader = pattern_maker, garment_sewer, wish_reader
        self._eyes, self._library = picture_reader, pattern_library
        self._parameters = parameter_reader
        self.body, self.fabric = body, fabric
        self._threads = threads

    @classmethod
    def load(
        cls,
        pattern_maker: PatternWriter | Path | str | None = None,
        garment_sewer: Sewer | Path | str | None = None,
        *,
        wish_reader: WishReader | Path | str | None = None,
        picture_reader: ReadsPictures | Path | str | None = None,
        pattern_library: PatternLibrary | Path | str | None = None,
        body: Body | None = None,
        fabric: Fabric | str = "cotton",
        fit: bool = False,
        threads: int = 1,
    ) -> Self:
        """The same as the constructor, under the name that networks have for it."""
        return cls(
            pattern_maker,
            garment_sewer,
            wish_reader=wish_reader,
            picture_reader=picture_reader,
            pattern_library=pattern_library,
            body=body,
            fabric=fabric,
            fit=fit,
            threads=threads,
        )

    def worn_by(self, body: Body | None) -> Self:
        """The same workshop with the same networks, for another body."""
        other = copy(self)
        other.body = body
        sewer = other.__dict__.pop("garment_sewer", None)
        if isinstance(sewer, GarmentSewer):  # opened already; only what it keeps garments out of is another's
            from swifttailor.body import Body
            from swifttailor.garment_sewer.to_scale import sewer_for

            other._sewer = sewer if body is not None else sewer_for(sewer, Body.default())
        return other

    @cached_property
    def pattern_maker(self) -> PatternWriter:
        """What writes patterns.

        Raises:
            InputError: There are no such weights, or they are damaged.
        """
        if self._maker is None or isinstance(self._maker, Path | str):
            from swifttailor.pattern_maker.maker import PatternMaker

            return PatternMaker.load(self._maker, threads=self._threads)
        return self._maker

    @cached_property
    def garment_sewer(self) -> Sewer:
        """What sews them.

        Raises:
            InputError: There are no such weights, or they are damaged.
        """
        sewer = self._sewer
        if sewer is None or isinstance(sewer, Path | str):
            sewer = GarmentSewer.load(sewer, threads=self._threads)
        if self.body is not None and isinstance(sewer, GarmentSewer):
            from swifttailor.garment_sewer.to_scale import sewer_for

            return sewer_for(sewer, self.body)
        return sewer

    @cached_property
    def wish_reader(self) -> WishReader:
        """The network that reads what texts ask for.

        Raises:
            InputError: There are no such weights, or they are damaged.
        """
        from swifttailor.wishes.reader import WishReader

        if self._reader is None or isinstance(self._reader, Path | str):
            return WishReader.load(self._reader, threads=self._threads)
        return self._reader

    @cached_property
    def picture_reader(self) -> ReadsPictures | None:
        """The network that reads what pictures show; None where none was given and the package has none.

        Raises:
            InputError: There are no such weights, or they are damaged.
        """
        if self._eyes is None or isinstance(self._eyes, Path | str):
            from swifttailor.picture_reader.reader import SHIPPED, PictureReader

            if self._eyes is None and not SHIPPED.is_file():
                return None
            return PictureReader.load(self._eyes, threads=self._threads)
        return self._eyes

    @cached_property
    def panel_foresight(self) -> PanelForesight | None:
        """What tells of words which panels a garment will have; None where somebody else's writer does not.

        Raises:
            InputError: There are no such weights, or they are damaged.
        """
        from swifttailor.pattern_maker.panel_foresight import PanelForesight

        if self._maker is None or isinstance(self._maker, Path | str):
            return PanelForesight.load(self._maker, threads=self._threads)
        from swifttailor.pattern_maker.maker import PatternMaker

        return PanelForesight.of(self._maker) if isinstance(self._maker, PatternMaker) else None

    @cached_property
    def pattern_library(self) -> PatternLibrary | None:
        """Known patterns; None where a writer or weights of your own write them all.

        Raises:
            InputError: There is no such file, or it is damaged.
        """
        if self._library is None or isinstance(self._library, Path | str):
            from swifttailor.pattern_library.known import PatternLibrary

            own = self._maker is not None
            return None if self._library is None and own else PatternLibrary.load(self._library)
        return self._library

    @cached_property
    def parameter_reader(self) -> ParameterReader | None:
        """The network that reads design parameters; None where others have the say.

        Raises:
            InputError: There is no such file, or it is damaged.
        """
        if self._parameters is None or isinstance(self._parameters, Path | str):
            from swifttailor.parameter_reader.reader import ParameterReader

            own = self._maker is not None or self._library is not None
            return None if self._parameters is None and own else ParameterReader.load(self._parameters)
        return self._parameters

    def designer_for(self, orders: Sequence[Order]) -> ParameterReader | None:
        """What reads design parameters, where any order may be answered by a draft of them."""
        return self.parameter_reader if any(one.may_be_designed for one in orders) else None

    def library_for(self, orders: Sequence[Order]) -> PatternLibrary | None:
        """Known patterns, where any order may be answered by one."""
        asked = any(one.source in ("both", "library") and one.edit is None and one.alter for one in orders)
        return self.pattern_library if asked else None

    def compile_notes(self, *, finish: bool) -> list[str]:
        """What the first garment waits for on a machine where it is not compiled yet, in words.

        Args:
            finish: Whether garments hang to rest by physics in the end.

        Raises:
            InputError: There are no weights to sew with, or they are damaged.
        """
        from swifttailor.draping.compiled_code import COARSE_COMPILE_NOTE, COMPILE_NOTE, solver_is_compiled

        sewer = self.garment_sewer
        waits = {
            COARSE_COMPILE_NOTE: isinstance(sewer, GarmentSewer) and sewer.must_compile,
            COMPILE_NOTE: finish and not solver_is_compiled(),
        }
        return [note for note, must_wait in waits.items() if must_wait]

    def open_for(self, order: Order) -> None:
        """Opens the networks that an order needs, so that their time is not another stage's."""
        if self.library_for([order]) is None:
            _ = self.pattern_maker
        elif order.text.strip():
            _ = self.panel_foresight
        _ = self.designer_for([order])
        _ = self.garment_sewer, self.wish_reader if order.alter else None
        _ = self.picture_reader if order.alter and order.images else None
        if isinstance(self.garment_sewer, GarmentSewer):
            import swifttailor.tailor.writing  # noqa: F401  modules are loaded by one thread at a time

            self.garment_sewer.load_drape()
