"""Both stages in a row (paper, Fig. 3): prompt, pattern, image, garment."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import cached_property
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

from swifttailor.clock import Clock
from swifttailor.errors import SwiftTailorError
from swifttailor.garment_sewer.sewer import BATCH, GarmentSewer
from swifttailor.pattern import Pattern
from swifttailor.pattern.panel import RotationReading
from swifttailor.pattern_maker.maker import USUAL_TEMPERATURE, PatternMaker
from swifttailor.progress import StageProgress
from swifttailor.tailor.order import Image, Order, one_line
from swifttailor.tailor.provenance import versions, weights
from swifttailor.tailor.sewing import (
    Ready,
    SewingOptions,
    Sewn,
    read_and_make_ready,
    sew_ready,
)
from swifttailor.tailor.tailored import Tailored, change_line, finding_entry, finishing_notes
from swifttailor.tailor.writing import WrittenPattern, ask, doubts, oddities, write_patterns

if TYPE_CHECKING:
    from swifttailor.wishes.reader import WishReader

LONGEST_NOTE = 200
"""Letters of a text that a note says again."""
Outcome = Tailored | SwiftTailorError
"""A garment, or why there is none."""
NOTHING_UNDERSTOOD = (
    "Nothing that can be measured was understood of the text for certain, so nothing was altered."
)


class Tailor:
    """Makes garments of words, pictures and patterns."""

    def __init__(
        self,
        pattern_maker: PatternMaker | Path | str | None = None,
        garment_sewer: GarmentSewer | Path | str | None = None,
        *,
        wish_reader: WishReader | Path | str | None = None,
        threads: int = 1,
    ) -> None:
        """Prepares to work; a network is opened when it is first needed.

        Args:
            pattern_maker: A network, or its model file; the one that comes with the package when None.
            garment_sewer: The same.
            wish_reader: The same, for what texts ask for.
            threads: Processor cores for the networks.
        """
        self._maker, self._sewer, self._reader = pattern_maker, garment_sewer, wish_reader
        self._threads = threads

    @classmethod
    def load(
        cls,
        pattern_maker: PatternMaker | Path | str | None = None,
        garment_sewer: GarmentSewer | Path | str | None = None,
        *,
        wish_reader: WishReader | Path | str | None = None,
        threads: int = 1,
    ) -> Tailor:
        """The same as the constructor, under the name that networks have for it."""
        return cls(pattern_maker, garment_sewer, wish_reader=wish_reader, threads=threads)

    @cached_property
    def pattern_maker(self) -> PatternMaker:
        """The network that writes patterns.

        Raises:
            InputError: There are no such weights, or they are damaged.
        """
        if isinstance(self._maker, PatternMaker):
            return self._maker
        return PatternMaker.load(self._maker, threads=self._threads)

    @cached_property
    def garment_sewer(self) -> GarmentSewer:
        """The network that sews them.

        Raises:
            InputError: There are no such weights, or they are damaged.
        """
        if isinstance(self._sewer, GarmentSewer):
            return self._sewer
        return GarmentSewer.load(self._sewer, threads=self._threads)

    @cached_property
    def wish_reader(self) -> WishReader:
        """The network that reads what texts ask for.

        Raises:
            InputError: There are no such weights, or they are damaged.
        """
        from swifttailor.wishes.reader import WishReader

        if isinstance(self._reader, WishReader):
            return self._reader
        return WishReader.load(self._reader, threads=self._threads)

    def compile_notes(self, *, finish: bool) -> list[str]:
        """What the first garment waits for on a machine where it is not compiled yet, in words.

        Args:
            finish: Whether garments hang to rest by physics in the end.

        Raises:
            InputError: There are no weights to sew with, or they are damaged.
        """
        from swifttailor.draping.compiled_code import COARSE_COMPILE_NOTE, COMPILE_NOTE, solver_is_compiled

        waits = {
            COARSE_COMPILE_NOTE: self.garment_sewer.must_compile,
            COMPILE_NOTE: finish and not solver_is_compiled(),
        }
        return [note for note, must_wait in waits.items() if must_wait]

    def generate(
        self,
        text: str = "",
        image: Image | None = None,
        *,
        seed: int = 0,
        temperature: float = USUAL_TEMPERATURE,
        attempts: int | None = None,
        alter: bool = True,
        edge_length: float = 2.0,
        finish: bool = False,
        progress: StageProgress | None = None,
    ) -> Tailored:
        """Makes a garment of a description, a picture, or both.

        Args:
            text: Description.
            image: (h, w, 3) sRGB with row 0 at the top, or a file.
            seed: Decides what is drawn.
            temperature: See `Order`.
            attempts: See `Order`.
            alter: See `Order`.
            edge_length: Of the mesh, cm.
            finish: Whether it hangs to rest by physics in the end.
            progress: Called with the name of a stage and the share of it that is done.

        Raises:
            InputError: An argument, the picture or the weights cannot be used.
            PatternError: None of the patterns that were written can be sewn.
        """
        order = Order(
            text,
            image,
            seed=seed,
            temperature=temperature,
            attempts=attempts,
            alter=alter,
            edge_length=edge_length,
            finish=finish,
        )
        return _only(self.make(order, progress=progress))

    def edit(
        self,
        pattern: Pattern,
        instruction: str,
        *,
        seed: int = 0,
        temperature: float = USUAL_TEMPERATURE,
        attempts: int | None = None,
        alter: bool = True,
        edge_length: float = 2.0,
        finish: bool = False,
        progress: StageProgress | None = None,
    ) -> Tailored:
        """Makes a garment of a pattern, changed as the instruction says.

        Args:
            pattern: To change; it stays as it is.
            instruction: In words, such as "make the sleeves longer".
            seed: See `generate`.
            temperature: See `Order`.
            attempts: See `Order`.
            alter: See `Order`.
            edge_length: Of the mesh, cm.
            finish: See `generate`.
            progress: See `generate`.

        Raises:
            InputError: An argument or the weights cannot be used.
            PatternError: The pattern does not fit the network, or what was written cannot be sewn.
        """
        order = Order(
            instruction,
            edit=pattern,
            seed=seed,
            temperature=temperature,
            attempts=attempts,
            alter=alter,
            edge_length=edge_length,
            finish=finish,
        )
        return _only(self.make(order, progress=progress))

    def make(self, order: Order, *, progress: StageProgress | None = None) -> list[Outcome]:
        """Carries out an order: as many garments as it wants, or why one could not be made.

        Args:
            order: What is wanted.
            progress: See `generate`.

        Raises:
            SwiftTailorError: The order cannot be answered at all.
        """
        # Sewing alone does without them, and starts a fifth of a second earlier.
        from swifttailor.tailor.fitted import FittingMaker

        say = progress or (lambda stage, share: None)
        clock = Clock()
        say("loading", 0.0)
        maker, sewer = self.pattern_maker, self.garment_sewer
        fitting = FittingMaker(maker, self.wish_reader if order.alter else None)
        clock.stop("loading")
        say("writing", 0.0)
        asked = ask(order)
        clock.stop("reading")
        written = write_patterns(fitting, sewer, order, asked.request, clock)
        say("sewing", 0.0)
        ready = [w.ready for w in written if isinstance(w, WrittenPattern)]
        sewn = sew_ready(sewer, ready, SewingOptions(order.edge_length, finish=order.finish), progress)
        outcomes: list[Outcome] = []
        for number, one in enumerate(written):
            if isinstance(one, WrittenPattern):
                made = next(sewn)
                facts = self._about(order, order.seed + number, one, clock)
                warnings = (*doubts(one.fitted), *one.fitted.generated.notes)
                notes = (*asked.notes, *_remarks(order, one))
                outcomes.append(self._hand_over(made, facts, one, notes, warnings))
            else:
                outcomes.append(one)
        return outcomes

    def sew(
        self,
        pattern: Pattern | Path | str,
        *,
        edge_length: float = 2.0,
        finish: bool = False,
        repair: bool = False,
        progress: StageProgress | None = None,
    ) -> Tailored:
        """Makes the garment of a pattern.

        Args:
            pattern: In any order, or a GarmentCode JSON file.
            edge_length: Of the mesh, cm.
            finish: See `generate`.
            repair: Whether it is mended first.
            progress: See `generate`.

        Raises:
            InputError: An argument, the file or the weights cannot be used.
            PatternError: The pattern cannot be sewn.
        """
        options = SewingOptions(edge_length, repair=repair, finish=finish)
        return _only(list(self.sew_all([pattern], options, progress=progress)))

    def sew_all(
        self,
        patterns: Iterable[Pattern | Path | str],
        options: SewingOptions | None = None,
        *,
        rotation: RotationReading = "intrinsic",
        progress: StageProgress | None = None,
    ) -> Iterator[Outcome]:
        """Makes the garments of many patterns, a few at a time; one that cannot be sewn stops no other.

        Args:
            patterns: Patterns, or GarmentCode JSON files.
            options: How they are sewn.
            rotation: How files mean their placement angles.
            progress: See `generate`.

        Raises:
            InputError: The weights cannot be used.
        """
        options, sewer = options or SewingOptions(), self.garment_sewer
        source = read_and_make_ready(sewer, patterns, options, rotation)
        while part := list(islice(source, BATCH)):
            sewn = sew_ready(sewer, [one for one in part if isinstance(one, Ready)], options, progress)
            for one in part:
                yield self._hand_over(next(sewn), {}) if isinstance(one, Ready) else one

    def _hand_over(
        self,
        sewn: Sewn | SwiftTailorError,
        facts: dict[str, Any],
        written: WrittenPattern | None = None,
        notes: tuple[str, ...] = (),
        warnings: tuple[str, ...] = (),
    ) -> Outcome:
        if isinstance(sewn, SwiftTailorError):
            return sewn
        checked, garment = sewn.ready.checked, sewn.garment
        notes = (*notes, *finishing_notes(garment))
        reader = self.wish_reader if written is not None and written.fitted.wishes else None
        seconds = facts.pop("seconds", {}) | garment.report["seconds"]
        report = garment.report | {
            "seconds": {name: round(value, 4) for name, value in seconds.items()},
            **facts,
            "findings": [finding_entry(f) for f in checked.findings],
            "versions": versions(),
            "weights": weights(self.pattern_maker if written else None, self.garment_sewer, reader),
        }
        if checked.changes:
            report["mended"] = [change_line(c) for c in checked.changes]
        if written is not None:
            report["warnings"] = list(warnings)
        if written is not None or notes:
            report["notes"] = list(notes)
        return Tailored(
            replace(garment, report=report),
            sewn.ready.prepared.layout,
            None if "quality" in garment.report else sewn.prediction,
            checked.findings,
            checked.changes,
            notes,
            warnings,
            written.fitted.confidence if written is not None else None,
        )

    def _about(self, order: Order, seed: int, one: WrittenPattern, clock: Clock) -> dict[str, Any]:
        """What a report says of an order and how it was answered."""
        from swifttailor.wording.wish_lines import wish_line

        made, fitted = one.fitted.generated, one.fitted
        return {
            "seconds": clock.seconds,
            "order": order.to_json() | {"seed": seed},
            "writing": {
                "tokens": made.tokens,
                "log_likelihood": made.log_likelihood,
                "certainty": made.certainty,
                "attempt": one.attempt + 1,
                "failed_attempts": list(one.failures),
            },
            "wishes": [
                {
                    "wish": wish_line(w.change),
                    "certainty": round(w.certainty, 3),
                    "holds": w.change not in fitted.open,
                }
                for w in fitted.wishes
            ],
            "alterations": {"of_the_pattern_to_edit": fitted.recut, "cuts": list(fitted.cuts)},
            "confidence": made.confidence.to_json() if made.confidence is not None else None,
        }


def _remarks(order: Order, one: WrittenPattern) -> list[str]:
    from swifttailor.wishes.spelling import put_right
    from swifttailor.wording.wish_lines import wish_line

    found = []
    if one.failures:
        count = len(one.failures) + 1
        found.append(f"{count} patterns were written, of which number {one.attempt + 1} was taken.")
    if order.image is not None and one.fitted.confidence is None:
        found.append(
            "Whether the picture shows a garment was not judged: these weights have no measure of that."
        )
    found += [f"Look at the pattern: {oddity}." for oddity in oddities(one.fitted)]
    if order.alter and (meant := put_right(order.text)) != order.text:
        found.append(f"Read as: {one_line(meant, LONGEST_NOTE)}")
    if order.alter and order.text.strip() and not one.fitted.wishes:
        found.append(NOTHING_UNDERSTOOD)
    if one.fitted.cuts:
        found.append(f"Altered: {'; '.join(one.fitted.cuts)}.")
    if one.fitted.open:
        found.append(f"Asked for, and not so: {'; '.join(map(wish_line, one.fitted.open))}.")
    return found


def _only(outcomes: list[Outcome]) -> Tailored:
    (one,) = outcomes
    if isinstance(one, SwiftTailorError):
        raise one
    return one
