"""Runtimes whose answers are known: one plays out a sequence, one says whatever chance has it say."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern_maker.network.runtime import Cache
from swifttailor.pattern_maker.tokens.vocabulary import NUMBERS

HIDDEN = 2


class Scripted:
    """Its likeliest outputs are a sequence, place by place, with the numbers of that."""

    copies = plans = False

    def __init__(self, outputs, numbers, choices: int) -> None:
        self.outputs, self.numbers, self.choices = list(outputs), np.asarray(numbers), choices
        self.fed: list[int] = []

    def look(self, pictures):
        return np.zeros((len(pictures), 1, HIDDEN), np.float32)

    def embed(self, tokens, numbers):
        if tokens.shape == (1, 1):
            self.fed.append(int(tokens[0, 0]))
        return np.zeros((*tokens.shape, HIDDEN), np.float32)

    def decode(self, embedded, known, cache):
        place = len(cache.seen[0])  # steps so far, the prompt being one
        seen = np.concatenate([cache.seen, np.ones((1, 1), np.float32)], axis=1)
        logits = np.zeros((1, embedded.shape[1], self.choices), np.float32)
        if place < len(self.outputs):
            logits[:, -1, self.outputs[place]] = 20
        states = np.full((1, embedded.shape[1], HIDDEN), place, np.float32)
        return states, logits, Cache(cache.keys, cache.values, seen, cache.lengths)

    def regress(self, states, tokens):
        return self.numbers[states[:, 0].astype(int)]

    def empty_cache(self, rows):
        nothing = np.zeros((1, rows))
        return Cache(nothing, nothing, np.zeros((rows, 0), np.float32), np.zeros(rows, np.int64))


class AtRandom(Scripted):
    """Its logits are chance."""

    def __init__(self, seed: int, choices: int) -> None:
        super().__init__((), (), choices)
        self.chance = np.random.default_rng(seed)

    def decode(self, embedded, known, cache):
        states, logits, cache = super().decode(embedded, known, cache)
        return states, self.chance.normal(scale=3.0, size=logits.shape).astype(np.float32), cache

    def regress(self, states, tokens):
        return self.chance.normal(size=(len(tokens), NUMBERS)).astype(np.float32)
