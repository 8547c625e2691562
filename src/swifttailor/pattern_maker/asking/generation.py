"""Writing patterns token by token, under the grammar: whatever the network thinks, a pattern comes out."""

from __future__ import annotations

from collections.abc import Sequence as Several
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Singles
from swifttailor.errors import InputError
from swifttailor.pattern_maker.asking.copying import mix
from swifttailor.pattern_maker.asking.counterpart import Counterpart, Counterparts
from swifttailor.pattern_maker.asking.plan import PatternPlan, approach, normalized
from swifttailor.pattern_maker.asking.prompt import Sequence
from swifttailor.pattern_maker.network.runtime import Cache, Runtime
from swifttailor.pattern_maker.tokens.grammar import Grammar, Stage, State
from swifttailor.pattern_maker.tokens.token_sequence import LARGEST_NUMBER, NUMBER_MASK, TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import NUMBERS, PATTERN_END

_CARRIES: NDArray[np.bool_] = np.any(NUMBER_MASK, axis=1)


@dataclass(frozen=True, eq=False)
class Asked:
    """A prompt and how to answer it."""

    prompt: Sequence
    picture: Singles | None = None
    """(3, size, size), where the prompt has places for one."""
    seeds: tuple[tuple[int, ...], ...] = ((0,),)
    """One answer is written for each."""
    temperature: float = 0.0
    """0 takes the most probable token always; 1 draws by probability."""
    edit: TokenSequence | None = None
    """The pattern to edit that is in the prompt."""
    brief: bool = False
    """Whether only its outlines are: what changes is then foreseen."""


@dataclass(frozen=True, eq=False)
class Written:
    """An answer."""

    sequence: TokenSequence
    log_likelihood: float
    """Natural logarithm of the probability of its tokens among those that the grammar allows, the plan
    included, at temperature 1."""
    certainty: float
    """Mean over its places of that logarithm for the likeliest token, whichever was taken."""
    look: Singles | None
    """(hidden,) what the network made of the picture, its places averaged; None without one."""
    unsewn: int = 0
    """Edges that were to be sewn to others which were never written (`Grammar.broken_off`)."""


@dataclass(eq=False)
class _Answer:
    """One that is being written."""

    temperature: float
    chance: np.random.Generator
    state: State = field(default_factory=State)
    tokens: list[int] = field(default_factory=list)
    numbers: list[Singles] = field(default_factory=list)
    log_likelihood: float = 0.0
    likeliest: float = 0.0
    """What it would be, had the likeliest token been taken everywhere."""
    likely: Counterparts | None = None
    """For a network that is told what it is likely to repeat."""
    plan: PatternPlan | None = None
    """For one that plans."""
    panels: Singles | None = None
    """(75 panels, hidden) to add at all places of each, for one that plans."""
    unsewn: int = 0
    """Edges whose stitches were open at the end."""

    def counterpart(self) -> Counterpart:
        """Of the token that is to come."""
        return Counterpart() if self.likely is None else self.likely.next()

    def take_numbers(self, numbers: Singles) -> None:
        """Adds the numbers (8,) of the token that was chosen."""
        self.numbers.append(numbers)
        if self.likely is not None:
            self.likely.follow(self.tokens[-1], numbers)

    def choose(self, logits: NDArray[np.floating], grammar: Grammar) -> int:
        """Takes the next token; its numbers are added by `_answer_all`."""
        mask = grammar.allowed(self.state)
        mask[PATTERN_END] |= grammar.may_break_off(self.state)
        allowed = np.flatnonzero(mask)
        scores = logits[allowed].astype(np.float64)
        logs = normalized(scores)
        if self.plan is not None and self.state.stage is Stage.BETWEEN_PANELS:
            logs = self.plan.weighed(logs, self.state.name, allowed)
        best = int(np.argmax(logs))
        if self.temperature > 0 and len(allowed) > 1:
            # The largest of scores with Gumbel noise is a draw by probability.
            noise = self.chance.gumbel(size=len(allowed))
            best = int(np.argmax(logs / self.temperature + noise))
        token = int(allowed[best])
        self.log_likelihood += float(logs[best])
        self.likeliest += float(logs.max())
        if token == PATTERN_END and self.state.open:
            self.unsewn = len(self.state.open)
            self.state, self.tokens = grammar.broken_off(self.state, self.tokens)
        self.state = grammar.advance(self.state, token)
        self.tokens.append(token)
        return token


def write_answers(
    runtime: Runtime, asked: Several[Asked], grammar: Grammar, text_size: int
) -> list[list[Written]]:
    """Answers prompts, all at once.

    Args:
        runtime: The network.
        asked: Prompts; each is read once however many answers it gets.
        grammar: What may be written.
        text_size: Tokens of text of the network.

    Returns:
        Of each prompt an answer for each of its seeds.

    Raises:
        InputError: The network's numbers are not finite.
    """
    if not asked:
        return []
    states, logits, cache, looks, plans = _read(runtime, asked)
    panels = {row: runtime.embed_panels(plan.numbers) for row, plan in plans.items()}
    answers, rows = [], []
    for row, one in enumerate(asked):
        for seed in one.seeds:
            chance = np.random.default_rng(list(seed))
            likely = Counterparts(one.edit, plans.get(row)) if runtime.copies else None
            plan = plans.get(row)
            answers.append(_Answer(one.temperature, chance, likely=likely, plan=plan, panels=panels.get(row)))
            rows.append(row)
    chosen = np.array(rows, np.int64)
    if len(rows) != len(asked):
        states, logits, cache = states[chosen], logits[chosen], cache.rows(chosen)
    _answer_all(runtime, list(answers), states, logits, cache, grammar, text_size)
    written: list[list[Written]] = [[] for _ in asked]
    for answer, row in zip(answers, rows, strict=True):
        sequence = TokenSequence(np.array(answer.tokens), np.array(answer.numbers))
        certainty = answer.likeliest / len(answer.tokens)
        look = looks.get(row)
        written[row].append(Written(sequence, answer.log_likelihood, certainty, look, answer.unsewn))
    return written


def _read(
    runtime: Runtime, asked: Several[Asked]
) -> tuple[Singles, Singles, Cache, dict[int, Singles], dict[int, PatternPlan]]:
    """States (B, hidden) and logits (B, tokens) after prompts; by row the looks of pictures, and plans."""
    lengths = np.array([len(one.prompt) for one in asked])
    longest = int(lengths.max())
    tokens = np.zeros((len(asked), longest), np.int64)
    numbers = np.zeros((len(asked), longest, NUMBERS), np.float32)
    for row, one in enumerate(asked):
        tokens[row, : lengths[row]], numbers[row, : lengths[row]] = one.prompt.tokens, one.prompt.numbers
    embedded = np.array(runtime.embed(tokens, numbers))
    pictured = [row for row, one in enumerate(asked) if one.picture is not None]
    averages: dict[int, Singles] = {}
    if pictured:
        looks = runtime.look(np.stack([one.picture for one in asked if one.picture is not None]))
        for row, look in zip(pictured, looks, strict=True):
            embedded[row, : len(look)] = look  # the places of a picture come first
            averages[row] = look.mean(axis=0)
    known = (np.arange(longest) < lengths[:, None]).astype(np.float32)
    plans = _plan(runtime, asked, embedded, known)
    firsts = [Counterparts(one.edit).next() for one in asked]
    embedded[np.arange(len(asked)), lengths - 1] += _added(runtime, firsts, embedded.shape[-1])
    states, logits, cache = runtime.decode(embedded, known, runtime.empty_cache(len(asked)))
    last = np.arange(len(asked)), lengths - 1
    return states[last], logits[last], cache, averages, plans


def _plan(
    runtime: Runtime, asked: Several[Asked], embedded: Singles, known: Singles
) -> dict[int, PatternPlan]:
    """What is foreseen, by row; of edits only where the prompts are brief."""
    rows = np.array([row for row, one in enumerate(asked) if one.edit is None or one.brief], np.int64)
    if not runtime.plans or not len(rows):
        return {}
    longest = int(known[rows].sum(axis=1).max())
    foreseen = runtime.foresee(embedded[rows, :longest], known[rows, :longest])
    if not np.isfinite(foreseen).all():
        raise InputError("What the network foresees are not finite numbers: its weights are damaged.")
    return {
        row: PatternPlan.from_foresight(f, asked[row].edit)
        for row, f in zip(rows.tolist(), foreseen, strict=True)
    }


def _answer_all(
    runtime: Runtime,
    active: list[_Answer],
    states: Singles,
    logits: Singles,
    cache: Cache,
    grammar: Grammar,
    text_size: int,
) -> None:
    own = [answer.counterpart() for answer in active]
    while True:
        others = np.array([c.token for c in own], np.int64)
        leanings = runtime.lean(states) if (others >= 0).any() else None
        if leanings is not None:
            there = np.flatnonzero(others >= 0)
            logits = np.array(logits)
            logits[there, others[there]] += leanings[there, 0]
        if not np.isfinite(logits).all():
            raise InputError("The network's logits are not finite numbers: its weights are damaged.")
        tokens = np.array([a.choose(x, grammar) for a, x in zip(active, logits, strict=True)], np.int64)
        written = np.zeros((len(active), NUMBERS), np.float32)
        if _CARRIES[tokens].any():
            given = runtime.regress(states, tokens)
            foretold = np.array([c.planned for c in own], np.int64)
            if (foretold >= 0).any():
                numbers = np.stack([c.planned_numbers for c in own])
                given = approach(given, numbers, runtime.trust(states), tokens, foretold)
            if leanings is not None:
                given = mix(given, np.stack([c.numbers for c in own]), leanings, tokens, others)
            if not np.isfinite(given).all():
                raise InputError("The network's numbers are not finite: its weights are damaged.")
            written = (given.clip(-LARGEST_NUMBER, LARGEST_NUMBER) * NUMBER_MASK[tokens]).astype(np.float32)
        for answer, row in zip(active, written, strict=True):
            answer.take_numbers(row)
        going = np.array([k for k, a in enumerate(active) if a.state.stage is not Stage.FINISHED], np.int64)
        if not len(going):
            return
        if len(going) < len(active):
            active = [active[k] for k in going]
            tokens, written, cache = tokens[going], written[going], cache.rows(going)
        own = [answer.counterpart() for answer in active]
        embedded = runtime.embed(tokens[:, None] + text_size, written[:, None])
        embedded = embedded + _added(runtime, own, embedded.shape[-1], active)[:, None]
        known = np.ones((len(active), 1), np.float32)
        after, next_logits, cache = runtime.decode(embedded, known, cache)
        states, logits = after[:, 0], next_logits[:, 0]


def _added(
    runtime: Runtime, following: Several[Counterpart], hidden: int, answers: Several[_Answer] = ()
) -> Singles:
    """(B, hidden) to add to the tokens before those that have these counterparts, in these answers."""
    added = np.zeros((len(following), hidden), np.float32)
    if not runtime.copies:
        return added
    repeated = [(c.token, c.numbers) for c in following], runtime.embed_counterparts
    planned = [(c.planned, c.planned_numbers) for c in following], runtime.embed_planned
    for told, embed in (repeated, planned):
        there = [k for k, (token, _) in enumerate(told) if token >= 0]
        if there:
            tokens = np.array([told[k][0] for k in there], np.int64)
            numbers = np.stack([told[k][1] for k in there])
            added[there] += embed(tokens[:, None], numbers[:, None])[:, 0]
    for row, answer in enumerate(answers):
        if answer.panels is not None and following[row].panel >= 0:
            added[row] += answer.panels[following[row].panel]
    return added
