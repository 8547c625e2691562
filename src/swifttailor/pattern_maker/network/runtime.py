"""What generation needs of a network, whichever library runs it; and the runtime without torch."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any, Protocol

import numpy as np

from swifttailor.arrays import Longs, Singles

GRAPHS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "vision": (("pictures",), ("looks",)),
    "embed": (("tokens", "numbers"), ("embedded",)),
    "decoder": (
        ("embedded", "positions", "seen", "keys", "values"),
        ("states", "logits", "new_keys", "new_values"),
    ),
    "regress": (("states", "tokens"), ("numbers",)),
}
"""The parts of a network as ONNX graphs: names of their inputs and outputs."""
COPYING_GRAPHS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "counterpart": (("tokens", "numbers"), ("added",)),
    "leaning": (("states",), ("leanings",)),
}
"""Those that a network has which is told what it is likely to repeat (`counterpart`)."""
PLANNING_GRAPHS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "plan": (("early",), ("foreseen",)),
    "planned": (("tokens", "numbers"), ("added",)),
    "trust": (("states",), ("shares",)),
    "panels": (("plans",), ("added",)),
}
"""And those of one that is told what it has foreseen as well (`plan`)."""
EARLY = "early"
"""What the decoder of such a network makes besides: states after the layer of foresight."""
_ALL_GRAPHS = GRAPHS | COPYING_GRAPHS | PLANNING_GRAPHS


def signature(name: str, *, planning: bool) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names of the inputs and outputs of a graph."""
    inputs, outputs = _ALL_GRAPHS[name]
    return inputs, (*outputs, EARLY) if planning and name == "decoder" else outputs


@dataclass(frozen=True, eq=False)
class Cache:
    """What a runtime remembers of some sequences."""

    keys: Any
    values: Any
    """(layers, B, groups, P, size)."""
    seen: Singles
    """(B, P) 1 where a place holds a token."""
    lengths: Longs
    """(B,) tokens so far."""

    def rows(self, chosen: Longs) -> Cache:
        """Of some of the sequences, in the given order; one may come several times."""
        return replace(
            self,
            keys=self.keys[:, chosen],
            values=self.values[:, chosen],
            seen=self.seen[chosen],
            lengths=self.lengths[chosen],
        )


class Runtime(Protocol):
    """A network ready to run."""

    def look(self, pictures: Singles) -> Singles:
        """(P, image tokens, hidden) of pictures (P, 3, S, S)."""
        ...

    def embed(self, tokens: Longs, numbers: Singles) -> Singles:
        """(B, L, hidden) of tokens (B, L) of the whole vocabulary and their numbers (B, L, 8)."""
        ...

    def decode(self, embedded: Singles, known: Singles, cache: Cache) -> tuple[Singles, Singles, Cache]:
        """(B, L, hidden) states and (B, L, tokens of patterns) logits of embedded tokens (B, L, hidden).

        Args:
            embedded: Tokens that follow those in the cache.
            known: (B, L) 1 where there is a token, 0 for padding, which comes last.
            cache: Of the tokens before.
        """
        ...

    def regress(self, states: Singles, tokens: Longs) -> Singles:
        """(B, 8) numbers of the tokens (B,) of patterns, chosen after the states (B, hidden)."""
        ...

    def empty_cache(self, rows: int) -> Cache:
        """Of no tokens."""
        ...

    @property
    def copies(self) -> bool:
        """Whether it is told the counterparts of what it writes, by the two functions below."""
        ...

    def embed_counterparts(self, tokens: Longs, numbers: Singles) -> Singles:
        """(B, L, hidden) to add to tokens, for the counterparts (B, L) of those after them."""
        ...

    def lean(self, states: Singles) -> Singles:
        """(B, `LEANINGS`) towards the counterparts, after the states (B, hidden)."""
        ...

    @property
    def plans(self) -> bool:
        """Whether it is told what it has foreseen, by the functions below."""
        ...

    def foresee(self, embedded: Singles, known: Singles) -> Singles:
        """(B, `FORESEEN`) of the answers to embedded prompts (B, L, hidden), padded as for `decode`."""
        ...

    def embed_planned(self, tokens: Longs, numbers: Singles) -> Singles:
        """What `embed_counterparts` is, for those that are foreseen."""
        ...

    def embed_panels(self, plans: Singles) -> Singles:
        """(n, hidden) to add to the tokens of panels, for what is foreseen of them (n, `PANEL_NUMBERS`)."""
        ...

    def trust(self, states: Singles) -> Singles:
        """(B, 8) logits of how much of the next numbers is the plan's, after the states (B, hidden)."""
        ...


@dataclass(frozen=True, eq=False)
class OnnxRuntime:
    """Runs the graphs of a model file with onnxruntime."""

    sessions: dict[str, Any]
    """By name, as in `GRAPHS`; all or none of `COPYING_GRAPHS`, and with these of `PLANNING_GRAPHS`."""
    _bare: dict[tuple[str, int], Singles] = field(default_factory=dict, init=False, repr=False)
    """What the graphs that embed make of tokens without numbers: (hidden,), by graph and token."""

    def look(self, pictures: Singles) -> Singles:
        """See `Runtime`."""
        return self._run("vision", pictures)[0]

    def embed(self, tokens: Longs, numbers: Singles) -> Singles:
        """See `Runtime`."""
        return self._embedded("embed", tokens, numbers)

    def decode(self, embedded: Singles, known: Singles, cache: Cache) -> tuple[Singles, Singles, Cache]:
        """See `Runtime`."""
        positions, seen = extended(known, cache)
        given = (embedded, positions, seen, cache.keys, cache.values)
        states, logits, keys, values = self._run("decoder", *given)[:4]
        lengths = cache.lengths + known.sum(axis=1).astype(np.int64)
        return states, logits, Cache(keys, values, seen, lengths)

    def regress(self, states: Singles, tokens: Longs) -> Singles:
        """See `Runtime`."""
        return self._run("regress", states, tokens)[0]

    def empty_cache(self, rows: int) -> Cache:
        """See `Runtime`."""
        layers, _, groups, _, size = self.sessions["decoder"].get_inputs()[3].shape
        nothing = np.zeros((layers, rows, groups, 0, size), np.float32)
        return Cache(nothing, nothing, np.zeros((rows, 0), np.float32), np.zeros(rows, np.int64))

    @property
    def copies(self) -> bool:
        """See `Runtime`."""
        return COPYING_GRAPHS.keys() <= self.sessions.keys()

    def embed_counterparts(self, tokens: Longs, numbers: Singles) -> Singles:
        """See `Runtime`."""
        return self._embedded("counterpart", tokens, numbers)

    def lean(self, states: Singles) -> Singles:
        """See `Runtime`."""
        return self._run("leaning", states)[0]

    @property
    def plans(self) -> bool:
        """See `Runtime`."""
        return PLANNING_GRAPHS.keys() <= self.sessions.keys()

    def foresee(self, embedded: Singles, known: Singles) -> Singles:
        """See `Runtime`."""
        nothing = self.empty_cache(len(embedded))
        positions, seen = extended(known, nothing)
        early = self._run("decoder", embedded, positions, seen, nothing.keys, nothing.values)[4]
        return self._run("plan", ends_of(early, known))[0]

    def embed_planned(self, tokens: Longs, numbers: Singles) -> Singles:
        """See `Runtime`."""
        return self._embedded("planned", tokens, numbers)

    def embed_panels(self, plans: Singles) -> Singles:
        """See `Runtime`."""
        return self._run("panels", plans)[0]

    def trust(self, states: Singles) -> Singles:
        """See `Runtime`."""
        return self._run("trust", states)[0]

    def _embedded(self, graph: str, tokens: Longs, numbers: Singles) -> Singles:
        """Runs a graph that embeds; single tokens without numbers, which most are, only when they are new."""
        if tokens.shape[1] != 1 or not len(tokens) or numbers.any():
            return self._run(graph, tokens, numbers)[0]
        own = [(graph, token) for token in tokens[:, 0].tolist()]
        for row, key in enumerate(own):
            if key not in self._bare:
                one = slice(row, row + 1)
                self._bare[key] = self._run(graph, tokens[one], numbers[one])[0][0, 0]
        return np.stack([self._bare[key] for key in own])[:, None]

    def _run(self, graph: str, *given: Any) -> Any:
        return self.sessions[graph].run(None, dict(zip(_ALL_GRAPHS[graph][0], given, strict=True)))


def ends_of(states: Any, known: Singles) -> Any:
    """(B, hidden) of states (B, L, hidden): those of the last known places."""
    return states[np.arange(len(known)), known.sum(axis=1).astype(np.int64) - 1]


def extended(known: Singles, cache: Cache) -> tuple[Longs, Singles]:
    """Positions (B, L) of new tokens, and which places (B, P + L) of old and new ones hold tokens."""
    positions = cache.lengths[:, None] + np.cumsum(known, axis=1).astype(np.int64) - 1
    return np.maximum(positions, 0), np.concatenate([cache.seen, known], axis=1)
