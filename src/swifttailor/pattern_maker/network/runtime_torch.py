"""The runtime of torch: for networks that were just trained, large ones, and GPUs.

Import this module in the function that needs it: it loads torch and transformers.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import torch

from swifttailor.arrays import Longs, Singles
from swifttailor.pattern_maker.network.decoder_torch import CachedDecoder
from swifttailor.pattern_maker.network.network_torch import PatternMakerNetwork
from swifttailor.pattern_maker.network.runtime import Cache, ends_of, extended


class TorchRuntime:
    """Runs a network where it is; see `swifttailor.pattern_maker.network.runtime.Runtime`."""

    def __init__(self, network: PatternMakerNetwork) -> None:
        """Prepares to run a network as it is now; later changes of its weights are seen only in parts."""
        self.network = network.eval()
        self.decoder = CachedDecoder(network)
        self.device = next(network.parameters()).device

    @torch.inference_mode()
    def look(self, pictures: Singles) -> Singles:
        """See `Runtime`."""
        return _floats(self.network.look(self._given(pictures)))

    @torch.inference_mode()
    def embed(self, tokens: Longs, numbers: Singles) -> Singles:
        """See `Runtime`."""
        nothing = torch.zeros((0, 1, self.network.hidden_size), device=self.device)
        return _floats(self.network.embed(self._given(tokens), self._given(numbers), nothing))

    @torch.inference_mode()
    def decode(self, embedded: Singles, known: Singles, cache: Cache) -> tuple[Singles, Singles, Cache]:
        """See `Runtime`."""
        positions, seen = extended(known, cache)
        given = self._given(embedded).to(self.decoder.norm.dtype)
        states, logits, keys, values = self.decoder(
            given, self._given(positions), self._given(seen), cache.keys, cache.values
        )[:4]
        lengths = cache.lengths + known.sum(axis=1).astype(np.int64)
        return _floats(states), _floats(logits), Cache(keys, values, seen, lengths)

    @torch.inference_mode()
    def regress(self, states: Singles, tokens: Longs) -> Singles:
        """See `Runtime`."""
        return _floats(self.network.regress(self._given(states), self._given(tokens)))

    def empty_cache(self, rows: int) -> Cache:
        """See `Runtime`."""
        nothing = self.decoder.empty_cache(rows)
        return Cache(nothing, nothing, np.zeros((rows, 0), np.float32), np.zeros(rows, np.int64))

    @property
    def copies(self) -> bool:
        """See `Runtime`."""
        return self.network.copying

    @torch.inference_mode()
    def embed_counterparts(self, tokens: Longs, numbers: Singles) -> Singles:
        """See `Runtime`."""
        return _floats(self.network.embed_counterparts(self._given(tokens), self._given(numbers)))

    @torch.inference_mode()
    def lean(self, states: Singles) -> Singles:
        """See `Runtime`."""
        return _floats(self.network.lean(self._given(states)))

    @property
    def plans(self) -> bool:
        """See `Runtime`."""
        return self.network.planning

    @torch.inference_mode()
    def foresee(self, embedded: Singles, known: Singles) -> Singles:
        """See `Runtime`."""
        positions, seen = extended(known, self.empty_cache(len(embedded)))
        given = self._given(embedded).to(self.decoder.norm.dtype)
        nothing = self.decoder.empty_cache(len(embedded))
        early = self.decoder(given, self._given(positions), self._given(seen), nothing, nothing)[4]
        return _floats(self.network.foresight_head(ends_of(early, known).float()))

    @torch.inference_mode()
    def embed_planned(self, tokens: Longs, numbers: Singles) -> Singles:
        """See `Runtime`."""
        return _floats(self.network.embed_planned(self._given(tokens), self._given(numbers)))

    @torch.inference_mode()
    def embed_panels(self, plans: Singles) -> Singles:
        """See `Runtime`."""
        return _floats(self.network.embed_panels(self._given(plans)))

    @torch.inference_mode()
    def trust(self, states: Singles) -> Singles:
        """See `Runtime`."""
        return _floats(self.network.trust(self._given(states)))

    def _given(self, array: Any) -> torch.Tensor:
        return torch.as_tensor(array, device=self.device)


def _floats(tensor: torch.Tensor) -> Singles:
    return tensor.float().cpu().numpy()
