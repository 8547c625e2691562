"""The language model with its cache of keys and values as plain inputs and outputs.

It is Qwen2 written out, for generation and for export: transformers' own caches cannot be exported as they
are, and take longer at this size. Import this module in the function that needs it: it loads torch.
"""

from __future__ import annotations

from typing import Any

import torch
import torch.nn.functional as F
from torch import Tensor, nn
from transformers import Qwen2Model

from swifttailor.errors import InputError
from swifttailor.pattern_maker.network.network_torch import PatternMakerNetwork


class CachedDecoder(nn.Module):
    """States and logits of some tokens, given the keys and values of those before them."""

    frequencies: Tensor

    def __init__(self, network: PatternMakerNetwork) -> None:
        """Takes the weights of a network; they are copied where several are joined into one."""
        super().__init__()
        model: Any = network.vlm.language_model
        if not isinstance(model, Qwen2Model):
            raise InputError(
                f"The language model is a {type(model).__name__}; a Qwen2Model is accepted, as in InternVL3."
            )
        config = model.config
        self.heads, self.groups = config.num_attention_heads, config.num_key_value_heads
        self.size = getattr(config, "head_dim", None) or config.hidden_size // self.heads
        self.epsilon, self.layers = config.rms_norm_eps, nn.ModuleList(_Layer(x) for x in model.layers)
        self.norm = nn.Parameter(model.norm.weight.detach(), requires_grad=False)
        self.head = nn.Parameter(network.token_head.weight.detach(), requires_grad=False)
        self.register_buffer("frequencies", model.rotary_emb.inv_freq.detach().float())
        self.scale = float(model.rotary_emb.attention_scaling)
        self.early = network.foresight_layer if network.planning else None

    def forward(
        self, embedded: Tensor, positions: Tensor, seen: Tensor, keys: Tensor, values: Tensor
    ) -> tuple[Tensor, ...]:
        """Goes through all layers once.

        Args:
            embedded: (B, L, hidden) of the new tokens.
            positions: (B, L) places of the new tokens in their sequences.
            seen: (B, P + L) 1 where a place of the cache and of the new tokens holds a token, 0 for padding.
            keys: (layers, B, groups, P, size) of the tokens before.
            values: The same.

        Returns:
            (B, L, hidden) states, (B, L, tokens of patterns) logits, and keys and values for P + L tokens; of
            a network that plans also (B, L, hidden) states after the layer of foresight.
        """
        before, count = keys.shape[3], embedded.shape[1]
        angles = positions[..., None].float() * self.frequencies
        angles = torch.cat([angles, angles], dim=-1)[:, None]
        cosine, sine = ((f(angles) * self.scale).to(embedded.dtype) for f in (torch.cos, torch.sin))
        place = torch.arange(before + count, device=embedded.device)
        causal = place[None, :] <= before + torch.arange(count, device=embedded.device)[:, None]
        hidden = (~causal)[None] | (seen[:, None] < 0.5)
        bias = hidden[:, None, None].to(embedded.dtype) * -1e9
        x, new_keys, new_values, early = embedded, [], [], embedded
        layers: Any = self.layers
        for number, layer in enumerate(layers):
            y = F.rms_norm(x, (x.shape[-1],), layer.attention_norm, self.epsilon)
            joined = F.linear(y, layer.qkv, layer.qkv_bias).unflatten(-1, (-1, self.size)).transpose(1, 2)
            q, k, v = joined.split([self.heads, self.groups, self.groups], dim=1)
            q, k = _rotate(q, cosine, sine), _rotate(k, cosine, sine)
            k, v = torch.cat([keys[number], k], dim=2), torch.cat([values[number], v], dim=2)
            new_keys.append(k)
            new_values.append(v)
            # The heads of a group lie side by side and share its keys.
            q = q.unflatten(1, (self.groups, -1)).flatten(2, 3)
            scores = (q @ k.transpose(2, 3)) * self.size**-0.5
            scores = scores.unflatten(2, (self.heads // self.groups, -1)) + bias
            mixed = scores.softmax(-1).flatten(2, 3) @ v
            mixed = mixed.unflatten(2, (self.heads // self.groups, -1)).flatten(1, 2).transpose(1, 2)
            x = x + F.linear(mixed.flatten(2), layer.out)
            y = F.rms_norm(x, (x.shape[-1],), layer.mlp_norm, self.epsilon)
            gate, up = F.linear(y, layer.gate_up).chunk(2, dim=-1)
            x = x + F.linear(F.silu(gate) * up, layer.down)
            if number + 1 == self.early:
                early = x
        x = F.rms_norm(x, (x.shape[-1],), self.norm, self.epsilon)
        logits = F.linear(x.to(self.head.dtype), self.head)
        made = x, logits, torch.stack(new_keys), torch.stack(new_values)
        return made if self.early is None else (*made, early)

    def empty_cache(self, rows: int) -> Tensor:
        """Keys or values of no tokens."""
        shape = (len(self.layers), rows, self.groups, 0, self.size)
        return torch.zeros(shape, dtype=self.norm.dtype, device=self.norm.device)


class _Layer(nn.Module):
    def __init__(self, layer: Any) -> None:
        super().__init__()
        attention, mlp = layer.self_attn, layer.mlp
        parts = (attention.q_proj, attention.k_proj, attention.v_proj)
        given = {
            "qkv": torch.cat([p.weight for p in parts]),
            "qkv_bias": torch.cat([p.bias for p in parts]),
            "out": attention.o_proj.weight,
            "gate_up": torch.cat([mlp.gate_proj.weight, mlp.up_proj.weight]),
            "down": mlp.down_proj.weight,
            "attention_norm": layer.input_layernorm.weight,
            "mlp_norm": layer.post_attention_layernorm.weight,
        }
        for name, value in given.items():
            setattr(self, name, nn.Parameter(value.detach(), requires_grad=False))


def _rotate(x: Tensor, cosine: Tensor, sine: Tensor) -> Tensor:
    first, second = x.chunk(2, dim=-1)
    return x * cosine + torch.cat([-second, first], dim=-1) * sine
