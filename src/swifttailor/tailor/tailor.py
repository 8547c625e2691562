"""Both stages in a row (paper, Fig. 3): prompt, pattern, image, garment."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cache
from itertools import groupby, islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

from swifttailor.body.wearer import body_of
from swifttailor.clock import Clock
from swifttailor.errors import InputError, NothingAskedError, SwiftTailorError
from swifttailor.garment_sewer.sewer import BATCH
from swifttailor.pattern import Pattern, check_pattern
from swifttailor.pattern.check import require_no_errors
from swifttailor.pattern.panel import RotationReading
from swifttailor.pattern_maker.temperatures import USUAL_TEMPERATURE
from swifttailor.progress import StageProgress
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.order import NO_READER, Image, Order, Part, Source
from swifttailor.tailor.protocols import Sewer
from swifttailor.tailor.reporting import described
from swifttailor.tailor.sewing import PatternSource, SewingOptions, prepare_sources, read_sources, sew_answers
from swifttailor.tailor.tailored import Tailored, only
from swifttailor.tailor.wearing import all_refitted, body_wanted, named_as
from swifttailor.tailor.workshop import Workshop

if TYPE_CHECKING:
    from swifttailor.garment.cloth_print import ClothPrint
    from swifttailor.garment.part_looks import PartLook
    from swifttailor.tailor.looking import SeenPicture
    from swifttailor.tailor.reading import Wanted

Outcome = Tailored | SwiftTailorError
"""A garment, or why there is none."""


class Tailor(Workshop):
    """Makes garments from words, pictures and patterns."""

    def look(self, image: Image) -> SeenPicture:
        """What a picture shows: garments, what can be said of each, and where they are.

        Args:
            image: (h, w, 3) sRGB with row 0 at the top, or a file.

        Raises:
            InputError: The picture or the weights cannot be used.
        """
        from swifttailor.tailor.looking import look_at

        if self.picture_reader is None:
            raise InputError(NO_READER)
        return look_at(image, self.picture_reader)

    def generate(
        self,
        text: str = "",
        image: Image | SeenPicture | Sequence[Image | SeenPicture] | None = None,
        *,
        part: Part | None = None,
        seed: int = 0,
        temperature: float = USUAL_TEMPERATURE,
        attempts: int | None = None,
        refine: int | None = None,
        source: Source = "both",
        alter: bool = True,
        edge_length: float = 2.0,
        finish: bool = False,
        relax: bool = True,
        progress: StageProgress | None = None,
    ) -> Tailored:
        """Makes a garment of a description, a picture, or both.

        Of a description of two that are worn together it makes the one that `part` chooses; without it one of
        the whole text, whose report says that several were asked for. `generate_all` makes both.

        Args:
            text: Description.
            image: (h, w, 3) sRGB with row 0 at the top, a file, or what was read of one (`look`); or two of
                the same garment.
            part: See `Order`.
            seed: Decides what is drawn.
            temperature: See `Order`.
            attempts: See `Order`.
            refine: See `Order`.
            source: See `Order`.
            alter: See `Order`.
            edge_length: Of the mesh, cm.
            finish: Whether it hangs to rest by physics in the end.
            relax: See `Order`.
            progress: Called with the name of a stage and the share of it that is done.

        Raises:
            InputError: An argument, the picture or the weights cannot be used.
            NothingAskedError: The text asks for no garment that could be made.
            NothingSeenError: There is no garment in a picture, and no text.
            PatternError: None of the patterns that were tried can be sewn.
        """
        order = Order(
            text,
            image,
            part=part,
            seed=seed,
            temperature=temperature,
            attempts=attempts,
            refine=refine,
            source=source,
            alter=alter,
            edge_length=edge_length,
            finish=finish,
            relax=relax,
        )
        return only(self.make(order, progress=progress))

    def generate_all(
        self,
        text: str = "",
        image: Image | SeenPicture | Sequence[Image | SeenPicture] | None = None,
        *,
        progress: StageProgress | None = None,
        **asked: Any,
    ) -> dict[Part, Tailored]:
        """Makes all garments of a description, or of a picture: "a blouse and a skirt" is two.

        Args:
            text: See `generate`.
            image: See `generate`.
            progress: See `generate`.
            asked: All else that `generate` takes.

        Returns:
            ``upper`` and ``lower``, and ``beside`` of a third; where there is but one, that is ``whole``, or
            the part that is chosen.

        Raises:
            SwiftTailorError: See `generate`.
        """
        from swifttailor.tailor.all_parts import orders_of_parts

        orders = orders_of_parts(Order(text, image, **asked), self)
        return {part: only(self.make(one, progress=progress)) for part, one in orders.items()}

    def edit(
        self,
        pattern: Pattern,
        instruction: str,
        *,
        color: str | None = None,
        print: ClothPrint | None = None,
        looks: tuple[PartLook, ...] = (),
        seed: int = 0,
        temperature: float = USUAL_TEMPERATURE,
        attempts: int | None = None,
        alter: bool = True,
        edge_length: float = 2.0,
        finish: bool = False,
        relax: bool = True,
        progress: StageProgress | None = None,
    ) -> Tailored:
        """Makes a garment of a pattern, changed as the instruction says.

        Args:
            pattern: To change; it stays as it is.
            instruction: In words, such as "make the sleeves longer".
            color: See `Order`, as for `print` and `looks`.
            print: Of its cloth.
            looks: Of its parts.
            seed: See `generate`.
            temperature: See `Order`.
            attempts: See `Order`.
            alter: See `Order`.
            edge_length: Of the mesh, cm.
            finish: See `generate`.
            relax: See `Order`.
            progress: See `generate`.

        Raises:
            InputError: An argument or the weights cannot be used.
            PatternError: The pattern does not fit the network, or what was written cannot be sewn.
        """
        order = Order(
            instruction,
            edit=pattern,
            color=color,
            print=print,
            looks=looks,
            seed=seed,
            temperature=temperature,
            attempts=attempts,
            alter=alter,
            edge_length=edge_length,
            finish=finish,
            relax=relax,
        )
        return only(self.make(order, progress=progress))

    def make(self, order: Order, *, progress: StageProgress | None = None) -> list[Outcome]:
        """Carries out an order: as many garments as it wants, or why one could not be made.

        Args:
            order: What is wanted.
            progress: See `generate`.

        Raises:
            SwiftTailorError: The order cannot be answered at all.
        """
        say = progress or (lambda stage, share: None)
        if order.edit is not None:
            require_no_errors(check_pattern(order.edit), "The pattern to edit")
        clock = Clock()
        say("loading", 0.0)
        self.open_for(order)
        clock.stop("loading")
        body = body_wanted(order, self.body if self.fits else None)
        options = SewingOptions(order.edge_length, finish=order.finish, relax=order.relax)
        say("writing", 0.0)
        if body is None:
            dressed, answers = self, self.write([order], clock)
        else:
            # Patterns are written, and checked, for the default body.
            answers = (self.worn_by(None) if self.body is not None else self).write([order], clock)
            dressed = self.worn_by(body)
            clock.restart()
            answers = [named_as(one, order.edit) for one in answers]
            answers = all_refitted(answers, body, dressed.garment_sewer, options)
            clock.stop("fitting")
        say("sewing", 0.0)
        written = [one for one in answers if isinstance(one, Answer)]
        sewn = dressed._sew(written, options, progress, clock)
        return [next(sewn) if isinstance(one, Answer) else one for one in answers]

    def write(self, orders: Sequence[Order], clock: Clock | None = None) -> list[Answer | SwiftTailorError]:
        """Writes the patterns of orders, all together, without sewing them.

        It is the first half of `make`, and what `swifttailor evaluate pattern-maker` measures.

        Args:
            orders: What is wanted; all of one temperature and number of attempts.
            clock: Takes the seconds of the stages.

        Returns:
            The pattern of each sample of each order, or why there is none.

        Raises:
            SwiftTailorError: The orders cannot be answered at all.
        """
        # Sewing alone does without them, and starts a fifth of a second earlier.
        from swifttailor.tailor.refused_orders import read_or_refused, with_refused
        from swifttailor.tailor.writing import write_patterns

        clock = clock or Clock()
        clock.restart()
        asked = [read_or_refused(self.read, order) for order in orders]
        clock.stop("reading")
        wanted = [one for one in asked if not isinstance(one, NothingAskedError)]
        samples = [(one, one.order.seed + k) for one in wanted for k in range(one.order.samples)]
        if not samples:
            return with_refused(asked, orders, [])
        written = write_patterns(
            lambda: self.pattern_maker,
            self.garment_sewer,
            samples,
            clock,
            self.library_for(orders),
            lambda: self.pattern_library,
            self.designer_for(orders),
            self.picture_reader if any(one.part is not None for one in wanted) else None,
        )
        return with_refused(asked, orders, written)

    def read(self, order: Order) -> Wanted:
        """What an order asks for, before anything is made.

        Args:
            order: What is wanted.

        Raises:
            SwiftTailorError: See `read_order`.
        """
        from swifttailor.tailor.orders_read import read_order

        if not order.alter:
            return read_order(order, None)
        read = read_order(order, self.wish_reader, self.picture_reader if order.images else None)
        sought = self.library_for([order]) is not None or self.designer_for([order]) is not None
        asked = order.text.strip() and sought
        return replace(read, foresight=self.panel_foresight) if asked else read

    def sew(
        self,
        pattern: Pattern | Path | str,
        *,
        edge_length: float = 2.0,
        finish: bool = False,
        relax: bool = True,
        repair: bool = False,
        progress: StageProgress | None = None,
    ) -> Tailored:
        """Makes the garment of a pattern.

        Args:
            pattern: In any order, or a GarmentCode JSON file.
            edge_length: Of the mesh, cm.
            finish: See `generate`.
            relax: See `Order`.
            repair: Whether it is mended first.
            progress: See `generate`.

        Raises:
            InputError: An argument, the file or the weights cannot be used.
            PatternError: The pattern cannot be sewn.
        """
        options = SewingOptions(edge_length, repair=repair, finish=finish, relax=relax)
        return only(list(self.sew_all([pattern], options, progress=progress)))

    def sew_all(
        self,
        patterns: Iterable[Pattern | Path | str],
        options: SewingOptions | None = None,
        *,
        rotation: RotationReading = "intrinsic",
        progress: StageProgress | None = None,
        note: Callable[[str], None] | None = None,
    ) -> Iterator[Outcome]:
        """Makes the garments of many patterns, a few at a time; one that cannot be sewn stops no other.

        Where the tailor has no body, each is worn by the one that it says it was drafted for.

        Args:
            patterns: Patterns, or GarmentCode JSON files.
            options: How they are sewn.
            rotation: How files mean their placement angles.
            progress: See `generate`.
            note: Called with what the first garment waits for (`compile_notes`). Nothing is loaded before
                there is a pattern that can be sewn.

        Raises:
            InputError: The weights cannot be used.
        """
        options = options or SewingOptions()

        @cache
        def noted() -> None:
            if note is not None:
                for line in self.compile_notes(finish=options.finish):
                    note(line)

        for named, sources in groupby(read_sources(patterns, rotation), key=lambda one: one.drafted_for):
            try:
                tailor = self if named is None or self.body is not None else self.worn_by(body_of(named))
            except InputError as error:
                yield from (InputError(f"{one.name} names its wearer. {error}") for one in sources)
                continue
            yield from tailor._sew_sources(sources, options, noted, progress)

    def _sew_sources(
        self,
        sources: Iterable[PatternSource],
        options: SewingOptions,
        noted: Callable[[], None],
        progress: StageProgress | None,
    ) -> Iterator[Outcome]:
        """Sews what was read, on this tailor's body."""

        def sewer() -> Sewer:
            noted()
            return self.garment_sewer

        fit = self.fits and self.body is not None
        prepared = prepare_sources(sewer, sources, options, self.body, fit=fit)
        while part := list(islice(prepared, BATCH)):
            sewn = self._sew([one for one in part if isinstance(one, Answer)], options, progress)
            for one in part:
                yield next(sewn) if isinstance(one, Answer) else one

    def _sew(
        self,
        answers: Sequence[Answer],
        options: SewingOptions,
        progress: StageProgress | None,
        clock: Clock | None = None,
    ) -> Iterator[Outcome]:
        """Sews prepared patterns and says all that is known of them."""
        for sewn in sew_answers(
            self.garment_sewer, answers, options, body=self.body, fabric=self.fabric, progress=progress
        ):
            yield described(sewn, self, clock) if isinstance(sewn, Tailored) else sewn
