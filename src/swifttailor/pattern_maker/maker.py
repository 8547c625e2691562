"""PatternMaker at use (paper, Fig. 3): words, a picture or a pattern in, a pattern out."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Singles
from swifttailor.clock import Clock
from swifttailor.errors import InputError, PatternError, SwiftTailorError
from swifttailor.pattern import Finding, Pattern
from swifttailor.pattern.check.repair import Change
from swifttailor.pattern.tidying.mending import mend
from swifttailor.pattern_maker.asking.confidence import Confidence
from swifttailor.pattern_maker.asking.generation import Asked, Written, write_answers
from swifttailor.pattern_maker.asking.pictures import picture_for_network
from swifttailor.pattern_maker.asking.prompt import make_prompt
from swifttailor.pattern_maker.asking.scripts import about_scripts, says_something
from swifttailor.pattern_maker.network.model_file import SHIPPED, MakerModel, load_model
from swifttailor.pattern_maker.temperatures import HIGHEST_TEMPERATURE
from swifttailor.pattern_maker.tokens.decode import decode
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.render.picture_file import read_picture

ChosenDecoding = Literal["own", "grammar", "free"]
"""Under the grammar, freely, or as the network's own method does."""


@dataclass(frozen=True, eq=False)
class Request:
    """What is wanted: a text, a picture or both; or a pattern to edit and a text that says how."""

    text: str = ""
    image: NDArray[np.uint8] | Path | str | None = None
    """(h, w, 3) sRGB with row 0 at the top, or a file."""
    edit: Pattern | None = None


@dataclass(frozen=True, eq=False)
class WrittenPattern:
    """A pattern as a network wrote it, and what is known of the writing.

    Only the pattern is needed; a network of another kind leaves out what it does not know.
    """

    pattern: Pattern
    """Mended where no guess was needed."""
    log_likelihood: float = 0.0
    """Natural logarithm of the probability of what was written: of two that are equally sound the likelier
    one is taken."""
    certainty: float | None = None
    """See `generation.Written`."""
    look: Singles | None = None
    """See `generation.Written`."""
    sequence: TokenSequence | None = None
    """What was written, before anything was mended."""
    unsewn: int = 0
    """Edges that were to be sewn to others which were never written (`Grammar.may_break_off`)."""
    dropped: int = 0
    """Stitch tags that were not on two edges, and join nothing; without the grammar alone."""
    changes: tuple[Change, ...] = ()
    """What was mended."""
    findings: tuple[Finding, ...] | None = None
    """What a check finds in the pattern; None where it was not checked."""
    notes: tuple[str, ...] = ()
    """What about the request was not used, or not understood."""
    confidence: Confidence | None = None
    """How sure the network is of the picture; None without one, or where that was not measured for it."""
    seconds: Mapping[str, float] = field(default_factory=dict)
    """By stage; requests that are answered together share theirs."""

    @property
    def tokens(self) -> int | None:
        """How many were written."""
        return None if self.sequence is None else len(self.sequence)


@dataclass(frozen=True, eq=False)
class PatternMaker:
    """Writes sewing patterns, one for each request and draw; which is taken, the tailor decides."""

    model: MakerModel

    @property
    def card(self) -> dict[str, Any]:
        """What the network was trained on, and how good it is."""
        return self.model.card

    @staticmethod
    def load(weights: Path | str | None = None, *, threads: int = 1) -> PatternMaker:
        """Opens a model file.

        Args:
            weights: File; the one that comes with the package when None.
            threads: CPU cores for the network.

        Raises:
            InputError: There is no such file, or it is damaged or another.
        """
        if weights is None and not SHIPPED.is_file():
            raise InputError(
                "This version comes without weights for a PatternMaker. Give a model file (with generate and "
                "edit --maker-weights FILE); one is made by: "
                "swifttailor train pattern-maker --patterns FILE --out RUN"
            )
        return PatternMaker(load_model(SHIPPED if weights is None else weights, threads=threads))

    def generate(
        self,
        text: str = "",
        image: NDArray[np.uint8] | Path | str | None = None,
        edit: Pattern | None = None,
        *,
        seed: int = 0,
        temperature: float = 0.0,
    ) -> WrittenPattern:
        """Writes one pattern.

        Args:
            text: Description, or the instruction where there is a pattern to edit.
            image: Picture of a garment.
            edit: Pattern to edit.
            seed: Decides what is drawn where `temperature` is above 0.
            temperature: 0 takes the likeliest token always; 1 draws tokens by their probability.

        Raises:
            InputError: An argument is out of range, or the picture cannot be read.
            PatternError: The pattern to edit does not fit.
        """
        request = Request(text, image, edit)
        (made,) = self.generate_all([request], seed=seed, temperature=temperature)
        return made

    def generate_all(
        self,
        requests: Sequence[Request],
        *,
        seed: int | Sequence[int] = 0,
        temperature: float = 0.0,
        draw: int = 0,
    ) -> list[WrittenPattern]:
        """Writes a pattern for each request, all together: faster than one by one.

        Args:
            requests: What is wanted.
            seed: One for all, or one for each.
            temperature: See `generate`.
            draw: Of the same seed, from 0: each gives another pattern where the temperature is above 0.

        Raises:
            SwiftTailorError: See `generate`.
        """
        made = self.write_all(requests, seed=seed, temperature=temperature, draw=draw)
        for one in made:
            if isinstance(one, SwiftTailorError):
                raise one
        return [one for one in made if isinstance(one, WrittenPattern)]

    def write_all(
        self,
        requests: Sequence[Request],
        *,
        seed: int | Sequence[int] = 0,
        temperature: float = 0.0,
        draw: int = 0,
        decoding: ChosenDecoding = "grammar",
    ) -> list[WrittenPattern | PatternError]:
        """The same in any way of decoding; without the grammar what is written may be no pattern.

        Args:
            requests: What is wanted.
            seed: See `generate_all`.
            temperature: See `generate`.
            draw: See `generate_all`.
            decoding: Under the grammar, freely, or as the method of the network does (``own``).

        Returns:
            For each request a pattern, or why what was written is none.

        Raises:
            SwiftTailorError: See `generate`.
        """
        clock, free = Clock(), self.decodes_freely(decoding)
        written, notes = self._write(requests, seed, temperature, draw, free=free, clock=clock)
        read = [(answer, _pattern_of(answer, free=free)) for answer in written]
        mended = [
            pattern if isinstance(pattern, PatternError) else mend(pattern, alike=request.edit is None)
            for (_, pattern), request in zip(read, requests, strict=True)
        ]
        clock.stop("checking")
        return [
            repair
            if isinstance(repair, PatternError)
            else WrittenPattern(
                pattern=repair.pattern,
                log_likelihood=answer.log_likelihood,
                certainty=answer.certainty,
                look=answer.look,
                sequence=answer.sequence,
                unsewn=answer.unsewn,
                dropped=answer.dropped,
                changes=repair.changes,
                findings=repair.remaining,
                notes=about,
                confidence=self._confidence(answer),
                seconds=clock.seconds,
            )
            for (answer, _), repair, about in zip(read, mended, notes, strict=True)
        ]

    def answer_all(
        self, requests: Sequence[Request], *, seed: int | Sequence[int] = 0, temperature: float = 0.0
    ) -> list[Written]:
        """What the network itself says to each request, all together: neither read as a pattern nor mended.

        Args:
            requests: What is wanted.
            seed: One for all, or one for each.
            temperature: See `generate`.

        Raises:
            SwiftTailorError: See `generate`.
        """
        return self._write(requests, seed, temperature, 0, free=False, clock=Clock())[0]

    def decodes_freely(self, decoding: ChosenDecoding) -> bool:
        """Whether what is written may be no pattern."""
        return (self.model.decoding if decoding == "own" else decoding) == "free"

    def _write(
        self,
        requests: Sequence[Request],
        seed: int | Sequence[int],
        temperature: float,
        draw: int,
        *,
        free: bool,
        clock: Clock,
    ) -> tuple[list[Written], list[tuple[str, ...]]]:
        """Answers to requests, and what there is to say about each of them."""
        seeds = [seed] * len(requests) if isinstance(seed, int) else list(seed)
        if len(seeds) != len(requests):
            raise InputError(f"There are {len(seeds)} seeds for {len(requests)} requests; give one for each.")
        if not (math.isfinite(temperature) and 0 <= temperature <= HIGHEST_TEMPERATURE):
            raise InputError(f"The temperature is {temperature}; 0 to 10 is accepted.")
        if min(seeds, default=0) < 0:
            raise InputError(f"The seed is {min(seeds)}; 0 or more is accepted.")
        asked, notes = [], []
        for request, own in zip(requests, seeds, strict=True):
            one, about = self._ask(request)
            asked.append(replace(one, seeds=((own, draw),), temperature=temperature))
            notes.append(about)
        clock.stop("reading")
        model = self.model
        written = write_answers(
            model.runtime, asked, model.grammar, model.text.size, names=model.names, free=free
        )
        clock.stop("writing")
        return [answer for (answer,) in written], notes

    def _ask(self, request: Request) -> tuple[Asked, tuple[str, ...]]:
        model = self.model
        if not says_something(request.text) and (request.image is None or request.edit is not None):
            wanted = "an instruction" if request.edit is not None else "a text or an image"
            raise InputError(f"There is nothing to go by; {wanted} is needed.")
        encoded = model.text.encode(request.text, model.longest_text)
        notes = about_scripts(request.text)
        if encoded.truncated:
            read = len(model.text.decode(encoded.tokens))
            notes.append(
                f"The text is longer than the {model.longest_text} tokens that are read: what comes after "
                f"its first {read} characters was not used."
            )
        picture: Singles | None = None
        if request.image is not None:
            pixels = request.image if isinstance(request.image, np.ndarray) else read_picture(request.image)
            picture = picture_for_network(pixels, model.image_size)
        edit = None if request.edit is None else encode(request.edit, limits=model.grammar.limits)
        places = 0 if picture is None else model.image_tokens
        prompt = make_prompt(
            encoded.tokens,
            model.text.size,
            image_tokens=places,
            edit=edit,
            brief=model.brief_edits,
            names=model.names,
        )
        return Asked(prompt, picture, edit=edit, brief=model.brief_edits), tuple(notes)

    def _confidence(self, answer: Written) -> Confidence | None:
        usual = self.model.calibration
        return usual.confidence(answer.look, answer.certainty) if usual and answer.look is not None else None


def _pattern_of(answer: Written, *, free: bool) -> Pattern | PatternError:
    """What was written, or why it is no pattern."""
    if answer.fault:
        return PatternError(answer.fault)
    try:
        return decode(answer.sequence)
    except SwiftTailorError as error:
        if not free:
            raise  # the grammar lets patterns alone through
        return PatternError(f"What was written is no pattern. {error}")
