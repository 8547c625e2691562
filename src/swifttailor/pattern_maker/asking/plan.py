"""What a network foresees of its answer, told to itself place by place while it writes.

A prompt says most of a garment at once; token by token a small network forgets it again: of 150 validation
texts the head of foresight knew the panels of 59 %, and of 40 % they were written; skirts that it foresaw to
15 cm were written with errors of 23 cm. So where there is nothing to repeat, the writer is given the plan.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Singles
from swifttailor.pattern_maker.asking.foresight import (
    CORNERS,
    EDGES,
    FORESEEN,
    MANY,
    OUTLINE,
    PANEL_NUMBERS,
    PLACEMENT,
    foresight_of,
)
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import (
    CLOSING_COMMANDS,
    COMMANDS,
    END,
    MOVE,
    NUMBERS,
    PANEL_TOKENS,
    PATTERN_END,
    SIZE,
    TRANSLATION,
)

FORESEEN_NUMBERS: NDArray[np.bool_] = np.zeros((SIZE, NUMBERS), bool)
"""Which numbers of a token may be taken from a plan: where a panel stands, and where an edge ends. A rotation
has two quaternions, between which there is no middle."""
FORESEEN_NUMBERS[MOVE, TRANSLATION] = True
FORESEEN_NUMBERS[COMMANDS.start : COMMANDS.stop, END] = True


FORESEEN_SHARE = 0.9
"""Of the plan, beside the network's own word, where the next panel is chosen: the panels of an answer are
foreseen better than they are written."""


@dataclass(frozen=True, eq=False)
class PatternPlan:
    """The panels of an answer that is still to be written."""

    panels: tuple[int, ...]
    """Class ids, in the order in which they are written; one at least."""
    numbers: Singles
    """(75 panels, `PANEL_NUMBERS`) as in `foresight`, of those above and of all others."""
    odds: NDArray[np.float64]
    """(75 panels,) logarithms of how much likelier it is that the answer has a panel than that it has not."""

    @staticmethod
    def from_foresight(foreseen: NDArray[np.floating], old: TokenSequence | None = None) -> PatternPlan:
        """Reads what the head of foresight has said.

        Args:
            foreseen: (`FORESEEN`,) logits of the tokens and numbers of the panels.
            old: The pattern that is to be edited, to which the numbers are to be added (`foresight_of`).
        """
        assert foreseen.shape == (FORESEEN,)
        logits = foreseen[PANEL_TOKENS.start : PANEL_TOKENS.stop]
        likely = np.flatnonzero(logits > 0)
        panels = likely.tolist() or [int(np.argmax(logits))]
        numbers = np.asarray(foreseen[SIZE:], np.float32).reshape(len(PANEL_TOKENS), PANEL_NUMBERS)
        if old is not None:
            before = foresight_of(old)
            numbers = numbers + np.where(before.known, before.numbers, 0)
        return PatternPlan(tuple(panels), numbers, logits.astype(np.float64))

    def after(self, name: int) -> int:
        """Token that follows a panel (class id; -1 before the first): the next panel, or the end."""
        later = next((panel for panel in self.panels if panel > name), None)
        return PATTERN_END if later is None else PANEL_TOKENS[later]

    def next_panels(self, name: int) -> NDArray[np.float64]:
        """How likely the likeliest answer is in which each panel, or none, is the next after one.

        Panels are foreseen one by one, each with its own odds: a panel is the next if it is there and those
        between are not; of those after it each is there or not, whichever is likelier. The likeliest choices
        lead to the likeliest panels altogether.

        Args:
            name: Class id of the latest panel; -1 before the first.

        Returns:
            (tokens of patterns,) logarithms of probabilities; infinitely small for all other tokens.
        """
        logs = np.full(SIZE, -np.inf)
        present, absent = -np.logaddexp(0, -self.odds), -np.logaddexp(0, self.odds)
        skipped = np.concatenate([[0.0], np.cumsum(absent[name + 1 :])])
        best = np.maximum(present, absent)[name + 1 :]
        later = np.cumsum(best[::-1])[::-1] - best
        logs[PANEL_TOKENS.start + name + 1 : PANEL_TOKENS.stop] = present[name + 1 :] + skipped[:-1] + later
        logs[PATTERN_END] = skipped[-1]
        return logs

    def weighed(
        self, logs: NDArray[np.float64], name: int, tokens: NDArray[np.integer]
    ) -> NDArray[np.float64]:
        """What the network says of the next panel, and the plan.

        Args:
            logs: (n,) logarithms of probabilities, from the network.
            name: Class id of the latest panel; -1 before the first.
            tokens: (n,) what they are of: later panels, or the end.
        """
        return normalized((1 - FORESEEN_SHARE) * logs + FORESEEN_SHARE * self.next_panels(name)[tokens])

    def placement(self, name: int) -> Singles:
        """(8,) of a panel."""
        numbers = np.zeros(NUMBERS, np.float32)
        numbers[PLACEMENT] = self.numbers[name, PLACEMENT]
        return numbers

    def edge(self, name: int, number: int) -> tuple[int, Singles] | None:
        """Token and numbers (8,) of an edge, said as a line; None where no corner of it is foreseen."""
        numbers = np.zeros(NUMBERS, np.float32)
        own = self.numbers[name]
        if number >= round(float(own[EDGES].sum()) * MANY) - 1:
            return CLOSING_COMMANDS[0], numbers
        if number >= CORNERS:
            return None
        start = OUTLINE.start + 2 * number
        numbers[END] = own[start : start + 2]
        return COMMANDS[0], numbers


def normalized(logs: NDArray[np.floating]) -> NDArray[np.float64]:
    """Logarithms of probabilities that are known but for a constant."""
    logs = np.asarray(logs, np.float64) - np.max(logs)
    return logs - np.log(np.exp(logs).sum())


def approach(
    written: NDArray[np.floating],
    planned: NDArray[np.floating],
    trust: NDArray[np.floating],
    tokens: NDArray[np.integer],
    others: NDArray[np.integer],
) -> NDArray[np.floating]:
    """Numbers between those that the network would write and those of its plan.

    Args:
        written: (n, 8) what it would write.
        planned: (n, 8) what is foreseen.
        trust: (n, 8) logits of the share of that.
        tokens: (n,) of patterns.
        others: (n,) foreseen, negative for none.
    """
    known = FORESEEN_NUMBERS[tokens] & FORESEEN_NUMBERS[others] & (others >= 0)[:, None]
    return np.where(known, written + (planned - written) / (1 + np.exp(-trust)), written)
