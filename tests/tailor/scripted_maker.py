"""A network that writes what it is told to: patterns are known, everything around it is real."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.pattern import Pattern
from swifttailor.pattern.tidying.symmetry import OTHER_SIDE
from swifttailor.pattern_maker.asking.confidence import Calibration, PictureSpace
from swifttailor.pattern_maker.maker import PatternMaker
from swifttailor.pattern_maker.network.model_file import MakerModel
from swifttailor.pattern_maker.network.runtime import Cache
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.grammar import Grammar
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import SIZE

HIDDEN = 3
CARD = {
    "model": "PatternMaker",
    "parameters": 7,
    "config": {"secret": "not told"},
    "data": {"train": {"garments": 2}},
    "validation": {"text": {"token_accuracy": 0.5}},
}


@dataclass(eq=False)
class ScriptedRuntime:
    """Answers the prompts of each call with the next of its rounds, one pattern a prompt."""

    rounds: list[list[TokenSequence]]
    asked: list[int] = field(default_factory=list)
    """Prompts in each call so far."""
    pictures: list[np.ndarray] = field(default_factory=list)
    """All that it was shown."""
    written: list[TokenSequence] = field(default_factory=list)
    copies = plans = False

    def look(self, pictures):
        self.pictures += list(pictures)
        return pictures.mean(axis=(2, 3))[:, None, :]

    def embed(self, tokens, numbers):
        return np.zeros((*tokens.shape, HIDDEN), np.float32)

    def decode(self, embedded, known, cache):
        rows, length, _ = embedded.shape
        script, place = cache.keys[0].astype(int), cache.values[0].astype(int) + 1
        if cache.seen.shape[1] == 0:  # prompts
            answers = self.rounds[min(len(self.asked), len(self.rounds) - 1)]
            script = np.arange(rows) + len(self.written)
            self.written += [answers[k % len(answers)] for k in range(rows)]
            self.asked.append(rows)
            place = np.zeros(rows, int)
        logits = np.full((rows, length, SIZE), -40.0, np.float32)
        for row in range(rows):
            tokens = self.written[script[row]].tokens
            logits[row, :, tokens[min(place[row], len(tokens) - 1)]] = 0
        states = np.stack([script, place], axis=1)[:, None].repeat(length, axis=1).astype(np.float32)
        seen = np.concatenate([cache.seen, known], axis=1)
        lengths = cache.lengths + known.sum(axis=1).astype(np.int64)
        return states, logits, Cache(script[None], place[None], seen, lengths)

    def regress(self, states, tokens):
        return np.stack([self.written[int(s)].numbers[int(p)] for s, p in states])

    def empty_cache(self, rows):
        nothing = np.zeros((1, rows))
        return Cache(nothing, nothing, np.zeros((rows, 0), np.float32), np.zeros(rows, np.int64))


def scripted_maker(*rounds: Sequence[Pattern], calibration: Calibration | None = None) -> PatternMaker:
    """A maker that answers its first call with the first patterns, its second with the second, and so on.

    The last round is repeated for all calls that follow, and the patterns of a round in turn.
    """
    runtime = ScriptedRuntime([[encode(p) for p in patterns] for patterns in rounds])
    return PatternMaker(
        MakerModel(runtime, TextTokenizer.shipped(), Grammar(), 192, 32, 1, CARD, calibration=calibration)
    )


def sure_of(color: tuple[float, float, float]) -> Calibration:
    """A calibration that trusts pictures whose normalised mean colour is near this one."""
    space = PictureSpace(np.array(color), np.eye(3)[:1], np.array([0.01]), 0.01)
    usual = tuple(np.sort(space.familiarity(color + np.random.default_rng(0).normal(0, 0.1, (50, 3)))))
    told = {"noise": {"certainty": 0.5, "familiarity": 1.0}}
    return Calibration(
        "familiarity", space, {"familiarity": usual, "certainty": (-1.0, 0.0)}, 50, told, {"noise": 1.0}
    )


def crossed(pattern: Pattern) -> Pattern:
    """The pattern with far corners of its first panel exchanged, and of that on the other side.

    So it crosses itself by more than is mended, and neither side can be made of the other.
    """
    names = {pattern.panels[0].name, OTHER_SIDE.get(pattern.panels[0].name)}
    panels = []
    for panel in pattern.panels:
        vertices = panel.vertices.copy()
        far = 1 + len(vertices) // 2
        if panel.name in names:
            vertices[[1, far]] = vertices[[far, 1]]
        panels.append(replace(panel, vertices=vertices))
    return replace(pattern, panels=tuple(panels))
