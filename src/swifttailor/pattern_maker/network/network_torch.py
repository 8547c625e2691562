"""The network itself. Import this module in the function that needs it: it loads torch and transformers."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Generator
from typing import Any

import torch
from torch import Tensor, nn
from torch.distributed.tensor import DTensor
from transformers import InternVLModel

from swifttailor.pattern_maker.asking.copying import LEANINGS
from swifttailor.pattern_maker.asking.foresight import FORESEEN, PANEL_NUMBERS
from swifttailor.pattern_maker.asking.plan import FORESEEN_NUMBERS
from swifttailor.pattern_maker.asking.prompt import IMAGE, OWN_TOKENS, OWN_TOKENS_WITH_NAME_TEXT
from swifttailor.pattern_maker.network.initial_weights_torch import EMBEDDING
from swifttailor.pattern_maker.tokens.name_text import NameText
from swifttailor.pattern_maker.tokens.token_sequence import padded_mask
from swifttailor.pattern_maker.tokens.vocabulary import MOVE, NUMBERS, SIZE

LONGEST_WAVE, WAVES = 16.0, 7
"""Fourier features of a number: a wave of 16 units (440 cm), of half as much, ... down to 7 cm. Shorter ones
would tell apart numbers which the network, feeding on its own predictions, cannot."""
_FEATURES = 1 + 2 * WAVES

FORESIGHT_DEPTH = 2 / 3
"""Of the layers of the language model, those that a prompt must be understood by. What it says is then there
for the layers above to read, at every token of the answer."""

OPTIONAL = {
    "foresight": ("foresight_head.",),
    "vision": ("vlm.vision_tower.", "vlm.multi_modal_projector."),
    "copying": ("counterpart_",),
    "planning": ("planned_in.", "planned_head."),
    "plans of panels": ("panel_in.",),
}
"""Parts that weights to begin a training with may lack, as the beginnings of the names of theirs."""
DOUBT = -1.0
"""And of how much rather from the plan."""
SELDOM = -2.0
"""Before anything is learnt, the logarithm of how much rather a number is taken from its counterpart."""


class PatternMakerNetwork(nn.Module):
    """InternVL, with tokens that carry numbers: embedded on the way in, regressed on the way out."""

    number_mask: Tensor
    foreseen_numbers: Tensor

    def __init__(
        self,
        vlm: InternVLModel,
        text_size: int,
        *,
        command_seen: bool,
        copying: bool,
        planning: bool,
        names: NameText | None = None,
        embedding_std: float = EMBEDDING,
    ) -> None:
        super().__init__()
        outputs = SIZE if names is None else names.outputs
        self.vlm = vlm
        self.text_size = text_size
        self.command_seen = command_seen
        self.copying, self.planning = copying, planning
        text: Any = vlm.config.text_config
        hidden: int = text.hidden_size
        self.hidden_size = hidden
        self.own_embedding = nn.Embedding(OWN_TOKENS if names is None else OWN_TOKENS_WITH_NAME_TEXT, hidden)
        self.placement_embedding = _mlp(NUMBERS * _FEATURES, hidden, hidden, nn.GELU)
        self.edge_embedding = _mlp(NUMBERS * _FEATURES, hidden, hidden, nn.GELU)
        self.token_head = nn.Linear(hidden, outputs, bias=False)
        self.placement_head = _mlp(hidden, hidden, NUMBERS, nn.ReLU)
        self.edge_head = _mlp(hidden, hidden, NUMBERS, nn.ReLU)
        self.foresight_head = nn.Sequential(nn.LayerNorm(hidden), nn.Linear(hidden, FORESEEN))
        self.foresight_layer = math.ceil(FORESIGHT_DEPTH * text.num_hidden_layers)
        self.register_buffer("number_mask", torch.tensor(padded_mask(outputs)), persistent=False)
        nn.init.normal_(self.own_embedding.weight, std=embedding_std)
        nn.init.normal_(self.token_head.weight, std=text.initializer_range)
        if copying:
            self.counterpart_in = nn.Linear(hidden, hidden, bias=False)
            self.counterpart_head = _mlp(hidden, hidden, LEANINGS, nn.GELU)
            # Until something is learnt the network is what it is without.
            leaning: Any = self.counterpart_head[2]
            for weight in (self.counterpart_in.weight, leaning.weight):
                nn.init.zeros_(weight)
            with torch.no_grad():
                leaning.bias.zero_()[1] = SELDOM
        if planning:
            self.planned_in = nn.Linear(hidden, hidden, bias=False)
            self.planned_head = _mlp(hidden, hidden, NUMBERS, nn.GELU)
            self.panel_in = _mlp(PANEL_NUMBERS, hidden, hidden, nn.GELU)
            self.register_buffer("foreseen_numbers", torch.tensor(FORESEEN_NUMBERS), persistent=False)
            trust: Any = self.planned_head[2]
            last = self.planned_in.weight, trust.weight, *self.panel_in[2].parameters()
            for weight in last:
                nn.init.zeros_(weight)
            nn.init.constant_(trust.bias, DOUBT)

    def forward(
        self,
        tokens: Tensor,
        numbers: Tensor,
        pictures: Tensor,
        answers: Tensor,
        next_tokens: Tensor,
        firsts: Tensor,
        read: Tensor,
        read_numbers: Tensor,
        read_positions: Tensor,
        read_ends: Tensor,
        read_pictures: Tensor,
        copied: Tensor,
        copied_numbers: Tensor,
        planned: Tensor,
        planned_numbers: Tensor,
        panels: Tensor,
        plans: Tensor,
    ) -> tuple[Tensor, Tensor, Tensor]:
        """Predicts the answers to some prompts, each token from those before it; reads others without answer.

        Args:
            tokens: (B, L) ids of the whole vocabulary.
            numbers: (B, L, 8) that go with them.
            pictures: (P, 3, S, S) in -1 to 1, those of the prompts that have one, in order.
            answers: (n,) places in the flattened (B * L) from which the next token is predicted.
            next_tokens: (n,) that token, as outputs are numbered: tokens of patterns, and where names are
                text what `name_text` adds.
            firsts: (B,) places in the flattened (B * L) of the last token of each prompt.
            read: (M, T) ids of R prompts that are only read, several in a row.
            read_numbers: (M, T, 8) that go with them.
            read_positions: (M, T) of each in its prompt, from 0.
            read_ends: (R,) places in the flattened (M * T) of the last token of each of these prompts.
            read_pictures: (Q, 3, S, S), those of these prompts that have one, in order.
            copied: (B, L) the counterpart of the token after each place, of a pattern; negative for none.
            copied_numbers: (B, L, 8) that go with them.
            planned: (B, L) the token that is foreseen there; negative for none.
            planned_numbers: (B, L, 8) that go with them.
            panels: (B, L) class id of the panel that is being written there; negative for none.
            plans: (B, 75, `PANEL_NUMBERS`) all that is foreseen of the panels.

        Returns:
            (n, outputs) logits, (n, 8) its numbers, and (B + R, `FORESEEN`) what is foreseen of
            each whole answer from its prompt alone.
        """
        looks = self.look(torch.cat([pictures, read_pictures]))
        embedded = self.embed(tokens, numbers, looks[: len(pictures)])
        if self.copying:
            embedded = _added(embedded, copied, copied_numbers, self.embed_counterparts)
        if self.planning:
            embedded = _added(embedded, planned, planned_numbers, self.embed_planned)
            told = self.embed_panels(plans)[torch.arange(len(plans), device=plans.device)[:, None], panels]
            embedded = embedded + torch.where((panels >= 0)[..., None], told, 0.0).to(embedded.dtype)
        states, early = self._states(embedded)
        understood = early[firsts]
        if len(read):
            others = self._understood(read, read_numbers, read_positions, looks[len(pictures) :])
            understood = torch.cat([understood, others[read_ends]])
        foreseen = self.foresight_head(understood.float())
        states = states[answers]
        logits, given = self.logits(states), self.regress(states, next_tokens)
        if self.planning:
            foretold = planned.flatten()[answers]
            share = self.trust(states).sigmoid() * self.are_foreseen(next_tokens, foretold)
            given = given + share * (planned_numbers.flatten(0, 1)[answers] - given)
        if self.copying:
            own, own_numbers = copied.flatten()[answers], copied_numbers.flatten(0, 1)[answers]
            there = torch.nonzero(own >= 0)[:, 0]
            leanings = self.lean(states[there])
            logits = logits.index_put((there, own[there]), leanings[:, 0], accumulate=True)
            mixed = mix(given[there], own_numbers[there], leanings)
            alike = self.carries_alike(next_tokens[there], own[there])
            given = given.index_copy(0, there, torch.where(alike[:, None], mixed, given[there]))
            given = given * self.number_mask[next_tokens]
        return logits, given, foreseen

    def _states(self, embedded: Tensor) -> tuple[Tensor, Tensor]:
        """(B * L, hidden) after the last layer and after that of foresight, of embedded (B, L, hidden)."""
        language = self.vlm.language_model
        above = [*language.layers, language.norm][self.foresight_layer]
        with _seen_by(above) as early:
            out = language(inputs_embeds=embedded, use_cache=False)
        return out.last_hidden_state.flatten(0, 1), early[0].flatten(0, 1)

    def foresee(
        self, tokens: Tensor, numbers: Tensor, positions: Tensor, ends: Tensor, pictures: Tensor
    ) -> Tensor:
        """(R, `FORESEEN`) of the answers to prompts that stand in rows, as `read` does in `forward`."""
        states = self._understood(tokens, numbers, positions, self.look(pictures))
        return self.foresight_head(states[ends].float())

    def _understood(self, tokens: Tensor, numbers: Tensor, positions: Tensor, looks: Tensor) -> Tensor:
        """(B * L, hidden) after the layer of foresight; those above are not computed."""
        embedded = self.embed(tokens, numbers, looks)
        language = self.vlm.language_model
        layers = language.config.num_hidden_layers
        language.config.num_hidden_layers = self.foresight_layer  # transformers runs so many of its layers
        try:
            with _seen_by(language.norm) as early:
                # Positions that begin anew tell transformers that these are several sequences.
                language(inputs_embeds=embedded, position_ids=positions, use_cache=False)
        finally:
            language.config.num_hidden_layers = layers
        return early[0].flatten(0, 1)

    def look(self, pictures: Tensor) -> Tensor:
        """(P, image tokens, hidden) of pictures (P, 3, S, S)."""
        if not len(pictures) and not self._always_looks:
            return torch.zeros((0, 1, self.hidden_size), device=pictures.device)
        if len(pictures):
            return self.vlm.get_image_features(pictures).pooler_output
        # Several processes wait for each other's gradients, and parts: all take part in every step.
        unseen = torch.zeros((1, 3, self.image_size, self.image_size), device=pictures.device)
        return self.vlm.get_image_features(unseen).pooler_output[:0]

    def embed(self, tokens: Tensor, numbers: Tensor, looks: Tensor) -> Tensor:
        """(B, L, hidden) of tokens (B, L), their numbers (B, L, 8), and looks (P, image tokens, hidden)."""
        own = tokens - self.text_size
        text = self.vlm.get_input_embeddings()(tokens.clamp(max=self.text_size - 1))
        embedded = torch.where(
            (own < 0)[..., None], text, self.own_embedding(own.clamp(min=0)).to(text.dtype)
        )
        flat = embedded.flatten(0, 1)
        carries = torch.nonzero(self.carries_numbers(own).flatten())[:, 0]
        values = self.embed_numbers(own.flatten()[carries], numbers.flatten(0, 1)[carries])
        flat = flat.index_add(0, carries, values.to(flat.dtype))
        embedded = flat.view(embedded.shape)
        if looks.requires_grad or len(looks):
            embedded = embedded.masked_scatter((own == IMAGE)[..., None], looks.to(embedded.dtype))
        return embedded

    def embed_numbers(self, own: Tensor, numbers: Tensor) -> Tensor:
        """(..., hidden) of the numbers (..., 8) of tokens (...) of patterns that carry some."""
        own = own.clamp(0, SIZE - 1)
        # A quaternion and its negative are the same rotation, and one of both is what is embedded.
        quaternion = numbers[..., 3:7]
        largest = quaternion.gather(-1, quaternion.abs().argmax(-1, keepdim=True))
        sign = torch.where(largest < 0, -1.0, 1.0)
        turned = torch.cat([numbers[..., :3], quaternion * sign, numbers[..., 7:]], dim=-1)
        known = self.number_mask[own][..., None]
        placement = self.placement_embedding((_features(turned) * known).flatten(-2))
        edge = self.edge_embedding((_features(numbers) * known).flatten(-2))
        return torch.where((own == MOVE)[..., None], placement, edge)

    def embed_counterparts(self, tokens: Tensor, numbers: Tensor) -> Tensor:
        """(..., hidden) to add to tokens, for the counterparts (...) of those after them.

        Args:
            tokens: (...) the counterparts, of a pattern.
            numbers: (..., 8) that go with them.
        """
        return self.counterpart_in(self._with_numbers(tokens, numbers))

    def embed_planned(self, tokens: Tensor, numbers: Tensor) -> Tensor:
        """The same for counterparts that are foreseen."""
        return self.planned_in(self._with_numbers(tokens, numbers))

    def embed_panels(self, plans: Tensor) -> Tensor:
        """(..., hidden) to add at all places of panels, for the numbers foreseen of them (..., 31)."""
        return self.panel_in(plans)

    def _with_numbers(self, tokens: Tensor, numbers: Tensor) -> Tensor:
        """(..., hidden) of tokens (...) of patterns and their numbers (..., 8)."""
        carries = self.carries_numbers(tokens)[..., None]
        return self.own_embedding(tokens) + torch.where(carries, self.embed_numbers(tokens, numbers), 0.0)

    def lean(self, states: Tensor) -> Tensor:
        """(..., `LEANINGS`) towards the counterparts, of states (..., hidden).

        What the logit of the counterpart gains; the logit of taking its numbers; and what is added to these.
        """
        return self.counterpart_head(states.float())

    def trust(self, states: Tensor) -> Tensor:
        """(..., 8) logits of how much of the next numbers is taken from the plan, of states (..., hidden)."""
        return self.planned_head(states.float())

    def are_foreseen(self, tokens: Tensor, others: Tensor) -> Tensor:
        """(..., 8) which numbers of tokens (...) may be those of foreseen ones (...), negative for none."""
        known = self.foreseen_numbers[tokens] & self.foreseen_numbers[others.clamp(min=0)]
        return known & (others >= 0)[..., None]

    def carries_alike(self, tokens: Tensor, others: Tensor) -> Tensor:
        """Which tokens (...) of patterns carry numbers that mean the same as those of others (...)."""
        same = (self.number_mask[tokens] == self.number_mask[others]).all(-1)
        return same & self.number_mask[tokens].any(-1) & ((tokens == MOVE) == (others == MOVE))

    def logits(self, states: Tensor) -> Tensor:
        """(..., outputs) float32 of states (..., hidden)."""
        return self.token_head(states.float())

    def regress(self, states: Tensor, tokens: Tensor) -> Tensor:
        """(..., 8) numbers of tokens (...) of patterns, from the states (..., hidden) before them."""
        states = states.float()
        if self.command_seen:
            states = states + self.own_embedding(tokens.clamp(max=SIZE - 1))  # others have no numbers
        placed = (tokens == MOVE)[..., None]
        numbers = torch.where(placed, self.placement_head(states), self.edge_head(states))
        return numbers * self.number_mask[tokens]

    def carries_numbers(self, own: Tensor) -> Tensor:
        """Which tokens (...), counted like those of patterns, have numbers."""
        inside = (own >= 0) & (own < SIZE)
        return inside & self.number_mask.any(-1)[own.clamp(0, SIZE - 1)]

    @property
    def image_size(self) -> int:
        """Pixels along one side of a picture."""
        vision: Any = self.vlm.config.vision_config
        return vision.image_size[0]

    @property
    def layers(self) -> list[nn.Module]:
        """Those of the language and of the vision model, where the time goes."""
        return [*self.vlm.language_model.layers, *self.vlm.vision_tower.encoder.layer]

    @property
    def compilable(self) -> list[nn.Module]:
        """What is translated as a whole where a training is compiled."""
        return [self.vlm.vision_tower.embeddings, *self.layers]

    @property
    def units(self) -> list[nn.Module]:
        """Parts that can be held by several processes together, inner ones first."""
        norms = [m for m in self.vlm.vision_tower.modules() if isinstance(m, nn.BatchNorm2d)]
        layers = [*norms, *self.layers]
        whole = [self.vlm.get_input_embeddings(), self.vlm.multi_modal_projector, self.vlm.vision_tower]
        return [*layers, *whole, self.vlm.language_model]

    @property
    def _always_looks(self) -> bool:
        some = next(self.vlm.vision_tower.parameters())
        several = torch.distributed.is_initialized()
        return several and (isinstance(some, DTensor) or (self.training and some.requires_grad))


@contextlib.contextmanager
def _seen_by(module: nn.Module) -> Generator[list[Tensor]]:
    """Keeps what a module is called with."""
    seen: list[Tensor] = []
    watch = module.register_forward_pre_hook(lambda _, given: seen.append(given[0]))
    try:
        yield seen
    finally:
        watch.remove()


def _added(
    embedded: Tensor, tokens: Tensor, numbers: Tensor, embed: Callable[[Tensor, Tensor], Tensor]
) -> Tensor:
    """What is embedded (B, L, hidden), and something of tokens (B, L) where these are not negative."""
    there = torch.nonzero(tokens.flatten() >= 0)[:, 0]
    values = embed(tokens.flatten()[there], numbers.flatten(0, 1)[there])
    return embedded.flatten(0, 1).index_add(0, there, values.to(embedded.dtype)).view(embedded.shape)


def _mlp(size: int, hidden: int, out: int, activation: type[nn.Module]) -> nn.Sequential:
    return nn.Sequential(nn.Linear(size, hidden), activation(), nn.Linear(hidden, out))


def _features(numbers: Tensor) -> Tensor:
    """(..., 8, features) of numbers (..., 8): each itself, large ones compressed, and waves of it."""
    waves = 2 * torch.pi / LONGEST_WAVE * 2.0 ** torch.arange(WAVES, device=numbers.device)
    angles = numbers[..., None] * waves
    return torch.cat([torch.asinh(numbers)[..., None], angles.sin(), angles.cos()], dim=-1)


def mix(written: Tensor, copied: Tensor, leanings: Tensor) -> Tensor:
    """(..., 8) numbers, from those that the network would write and those of the counterparts (..., 8).

    Args:
        written: (..., 8).
        copied: (..., 8).
        leanings: (..., `LEANINGS`), see `PatternMakerNetwork.lean`.
    """
    share = leanings[..., 1:2].sigmoid()
    return written + share * (copied + leanings[..., 2:] - written)
