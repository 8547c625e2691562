"""Which panels a garment will have, told from its description before any is written: one pass of a few ms."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import InputError
from swifttailor.networks.model_file import open_model
from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.pattern_maker.asking.foresight import FORESEEN
from swifttailor.pattern_maker.asking.prompt import make_prompt
from swifttailor.pattern_maker.network.model_file import KIND, SHIPPED, TEXT, network_of
from swifttailor.pattern_maker.network.runtime import OnnxRuntime, Runtime
from swifttailor.pattern_maker.tokens.vocabulary import NUMBERS, PANEL_TOKENS

if TYPE_CHECKING:
    from swifttailor.pattern_maker.maker import PatternMaker

_GRAPHS = ("embed", "decoder", "plan")
"""Half of the file of a PatternMaker, and opened in a third of the time."""


@dataclass(frozen=True, eq=False)
class PanelForesight:
    """What a PatternMaker foresees of its answers to texts."""

    runtime: Runtime
    text: TextTokenizer
    longest_text: int
    """Tokens of a text that are read."""

    @staticmethod
    def load(weights: Path | str | None = None, *, threads: int = 1) -> PanelForesight | None:
        """Opens of a model file what is needed.

        Args:
            weights: File of a PatternMaker; the one that comes with the package when None.
            threads: CPU cores for the network.

        Returns:
            None where its network foresees nothing (`network.planning`), or the package comes without one.

        Raises:
            InputError: There is no such file, or it is damaged or another.
        """
        if weights is None and not SHIPPED.is_file():
            return None
        path = SHIPPED if weights is None else weights
        model = open_model(path, KIND, threads=threads, only=_GRAPHS)
        if "plan" not in model.sessions:
            return None
        text = TextTokenizer.from_json(model.members[TEXT], f"{path}, {TEXT}")
        with model.says("how it must be asked"):
            network = network_of(model.about["card"])
        made = model.shape_made("plan", "foreseen")
        model.require({"what it foresees": (made[1], FORESEEN)})
        return PanelForesight(OnnxRuntime(model.sessions), text, network.longest_text)

    @staticmethod
    def of(maker: PatternMaker) -> PanelForesight | None:
        """That of one that is open already; None where its network foresees nothing."""
        model = maker.model
        return PanelForesight(model.runtime, model.text, model.longest_text) if model.runtime.plans else None

    def odds(self, texts: Sequence[str]) -> NDArray[np.float64]:
        """How likely a garment has each panel, by one description of it or several.

        Args:
            texts: The same garment in several words, at least one; what they say counts equally.

        Returns:
            (75,) of each of `PANEL_NAMES` the logarithm of how much likelier it is there than not.

        Raises:
            InputError: There is no text, or the network's numbers are not finite.
        """
        if not texts:
            raise InputError("There are no texts to foresee panels from; give one at least.")
        size = self.text.size
        prompts = [make_prompt(self.text.encode(text, self.longest_text).tokens, size) for text in texts]
        lengths = np.array([len(one) for one in prompts])
        tokens = np.zeros((len(prompts), int(lengths.max())), np.int64)
        numbers = np.zeros((*tokens.shape, NUMBERS), np.float32)
        for row, one in enumerate(prompts):
            tokens[row, : lengths[row]], numbers[row, : lengths[row]] = one.tokens, one.numbers
        known = (np.arange(tokens.shape[1]) < lengths[:, None]).astype(np.float32)
        foreseen = self.runtime.foresee(self.runtime.embed(tokens, numbers), known)
        odds = np.asarray(foreseen, np.float64)[:, PANEL_TOKENS.start : PANEL_TOKENS.stop].mean(axis=0)
        if not np.isfinite(odds).all():
            raise InputError("What the network foresees are not finite numbers: its weights are damaged.")
        return odds
