"""Writing patterns token by token: under the grammar, where a pattern always comes out, or freely."""

from __future__ import annotations

from collections.abc import Sequence as Several
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Singles
from swifttailor.errors import InputError
from swifttailor.pattern_maker.asking.answer_paths import AnswerPath, FreePath, GrammarPath, SpelledPath
from swifttailor.pattern_maker.asking.copying import mix
from swifttailor.pattern_maker.asking.counterpart import Counterpart, Counterparts
from swifttailor.pattern_maker.asking.plan import PatternPlan, approach, normalized
from swifttailor.pattern_maker.asking.prompt import Sequence
from swifttailor.pattern_maker.network.runtime import Cache, Runtime
from swifttailor.pattern_maker.tokens.free_reading import settled
from swifttailor.pattern_maker.tokens.grammar import Grammar, Stage
from swifttailor.pattern_maker.tokens.name_text import NameText
from swifttailor.pattern_maker.tokens.token_sequence import LARGEST_NUMBER, TokenSequence, padded_mask
from swifttailor.pattern_maker.tokens.vocabulary import NUMBERS, SIZE

_NO_NUMBERS = np.zeros(NUMBERS, np.float32)


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
    """Names as tokens; where there is a `fault`, what was read until then."""
    log_likelihood: float
    """Natural logarithm of the probability of its tokens among those that the grammar allows, the plan
    included, at temperature 1."""
    certainty: float
    """Mean over its places of that logarithm for the likeliest token, whichever was taken."""
    look: Singles | None
    """(hidden,) what the network made of the picture, its places averaged; None without one."""
    unsewn: int = 0
    """Edges that were to be sewn to others which were never written (`Grammar.broken_off`)."""
    fault: str = ""
    """Why it is no pattern; without the grammar alone."""
    dropped: int = 0
    """Stitch tags without the grammar that were not on two edges, and join nothing."""


@dataclass(eq=False)
class _Answer:
    """One that is being written."""

    temperature: float
    chance: np.random.Generator
    path: AnswerPath
    numbers: list[Singles] = field(default_factory=list)
    log_likelihood: float = 0.0
    likeliest: float = 0.0
    """What it would be, had the likeliest token been taken everywhere."""
    places: int = 0
    likely: Counterparts | None = None
    """For a network that is told what it is likely to repeat."""
    plan: PatternPlan | None = None
    """For one that plans."""
    panels: Singles | None = None
    """(75 panels, hidden) to add at all places of each, for one that plans."""
    _done: int = 0
    """Tokens of the pattern that the latest choice has completed."""

    def counterpart(self) -> Counterpart:
        """Of the token that is to come."""
        return Counterpart() if self.likely is None else self.likely.next()

    def take_numbers(self, numbers: Singles) -> None:
        """Adds the numbers (8,) of the token that was chosen."""
        for token in self.path.tokens[len(self.path.tokens) - self._done :]:
            own = numbers if len(self.numbers) == len(self.path.tokens) - 1 else _NO_NUMBERS
            self.numbers.append(own)
            if self.likely is not None:
                self.likely.follow(token, own)

    def choose(self, logits: NDArray[np.floating]) -> int:
        """Takes the next output; its numbers are added by `_answer_all`."""
        state = self.path.state
        allowed = np.flatnonzero(self.path.allowed())
        scores = logits[allowed].astype(np.float64)
        logs = normalized(scores)
        if self.plan is not None and state.stage is Stage.BETWEEN_PANELS:
            logs = self.plan.weighed(logs, state.name, allowed)
        best = int(np.argmax(logs))
        if self.temperature > 0 and len(allowed) > 1:
            # The largest of scores with Gumbel noise is a draw by probability.
            noise = self.chance.gumbel(size=len(allowed))
            best = int(np.argmax(logs / self.temperature + noise))
        self.log_likelihood += float(logs[best])
        self.likeliest += float(logs.max())
        self.places += 1
        output = int(allowed[best])
        self._done = self.path.take(output)
        return output

    def written(self, look: Singles | None, *, free: bool) -> Written:
        """What came of it."""
        path, certainty = self.path, self.likeliest / self.places
        if free and not path.fault:
            read = settled(path.tokens, self.numbers)
            return Written(read.sequence, self.log_likelihood, certainty, look, dropped=read.dropped)
        sequence = TokenSequence(np.array(path.tokens), np.array(self.numbers).reshape(-1, NUMBERS))
        return Written(sequence, self.log_likelihood, certainty, look, path.unsewn, path.fault)


def write_answers(
    runtime: Runtime,
    asked: Several[Asked],
    grammar: Grammar,
    text_size: int,
    *,
    names: NameText | None = None,
    free: bool = False,
) -> list[list[Written]]:
    """Answers prompts, all at once.

    Args:
        runtime: The network.
        asked: Prompts; each is read once however many answers it gets.
        grammar: What may be written.
        text_size: Tokens of text of the network.
        names: Of a network that writes names as text.
        free: Whether anything may be written, up to the longest sequence of the grammar.

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
            path: AnswerPath
            if free:
                path = FreePath(grammar.limits.tokens, names)
            else:
                path = GrammarPath(grammar) if names is None else SpelledPath(grammar, names)
            told = panels.get(row)
            answers.append(_Answer(one.temperature, chance, path, likely=likely, plan=plan, panels=told))
            rows.append(row)
    chosen = np.array(rows, np.int64)
    if len(rows) != len(asked):
        states, logits, cache = states[chosen], logits[chosen], cache.rows(chosen)
    whole = np.arange(SIZE, dtype=np.int64) + text_size if names is None else names.whole(text_size)
    _answer_all(runtime, list(answers), states, logits, cache, whole)
    written: list[list[Written]] = [[] for _ in asked]
    for answer, row in zip(answers, rows, strict=True):
        written[row].append(answer.written(looks.get(row), free=free))
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
    whole: NDArray[np.int64],
) -> None:
    """Writes answers to their ends; `whole` are the outputs (outputs,) as tokens of the whole vocabulary."""
    mask = padded_mask(len(whole))
    carries = np.any(mask, axis=1)
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
        tokens = np.array([a.choose(x) for a, x in zip(active, logits, strict=True)], np.int64)
        written = np.zeros((len(active), NUMBERS), np.float32)
        if carries[tokens].any():
            given = runtime.regress(states, tokens)
            foretold = np.array([c.planned for c in own], np.int64)
            if (foretold >= 0).any():
                numbers = np.stack([c.planned_numbers for c in own])
                given = approach(given, numbers, runtime.trust(states), tokens, foretold)
            if leanings is not None:
                given = mix(given, np.stack([c.numbers for c in own]), leanings, tokens, others)
            if not np.isfinite(given).all():
                raise InputError("The network's numbers are not finite: its weights are damaged.")
            written = (given.clip(-LARGEST_NUMBER, LARGEST_NUMBER) * mask[tokens]).astype(np.float32)
        for answer, row in zip(active, written, strict=True):
            answer.take_numbers(row)
        going = np.array([k for k, a in enumerate(active) if not a.path.finished], np.int64)
        if not len(going):
            return
        if len(going) < len(active):
            active = [active[k] for k in going]
            tokens, written, cache = tokens[going], written[going], cache.rows(going)
        own = [answer.counterpart() for answer in active]
        embedded = runtime.embed(whole[tokens][:, None], written[:, None])
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
