"""Tokens without numbers are embedded once: what comes of it is, bit for bit, what the graphs say."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.pattern_maker.maker import SHIPPED, PatternMaker
from swifttailor.pattern_maker.network.model_file import load_model
from swifttailor.pattern_maker.network.runtime import OnnxRuntime
from swifttailor.pattern_maker.tokens.vocabulary import NUMBERS, SIZE

TINY = Path(__file__).with_name("tiny_maker.zip")
BATCHES = (1, 2, 3, 5, 8)
GRAPHS = {"embed": "embed", "counterpart": "embed_counterparts", "planned": "embed_planned"}
"""Which function runs which graph."""


class Counted:
    """A graph that counts how many tokens it is run for."""

    def __init__(self, session):
        self.session, self.tokens = session, Counter()

    def run(self, names, given):
        self.tokens.update(given["tokens"].ravel().tolist())
        return self.session.run(names, given)


@pytest.fixture(scope="module")
def sessions():
    return load_model(TINY).runtime.sessions


@pytest.fixture(scope="module")
def shipped():
    return load_model(SHIPPED).runtime.sessions


@pytest.fixture
def runtime(sessions):
    """That has embedded nothing yet."""
    return OnnxRuntime(dict(sessions))


def plainly(runtime, graph, tokens, numbers):
    """The graph itself, for the whole batch at once."""
    return runtime.sessions[graph].run(None, {"tokens": tokens, "numbers": numbers})[0]


def bare(tokens):
    return np.array(tokens, np.int64)[:, None], np.zeros((len(tokens), 1, NUMBERS), np.float32)


@pytest.mark.parametrize("graph", GRAPHS)
@pytest.mark.parametrize("batch", BATCHES)
def test_every_token_alone_and_in_company(runtime, graph, batch):
    embed = getattr(runtime, GRAPHS[graph])
    drawn = np.random.default_rng(batch)
    every = drawn.permutation(SIZE)
    for first in range(0, SIZE, batch):
        given = bare(every[first : first + batch])
        expected = plainly(runtime, graph, *given)
        for _ in range(2):
            found = embed(*given)
            assert (found.shape, found.dtype) == (expected.shape, expected.dtype)
            assert found.tobytes() == expected.tobytes()
    mixed = bare(drawn.integers(SIZE, size=batch))  # all of them known by now
    assert embed(*mixed).tobytes() == plainly(runtime, graph, *mixed).tobytes()


@settings(max_examples=30)
@given(data=st.data())
def test_with_and_without_numbers_in_any_order(sessions, data):
    """What came before, in which graph and in which company, cannot be seen."""
    runtime = OnnxRuntime(dict(sessions))
    numbers = st.sampled_from([0.0, -0.0, 1.0, -3.5, 1e-30])
    for _ in range(data.draw(st.integers(1, 6))):
        graph, batch = data.draw(st.sampled_from(list(GRAPHS))), data.draw(st.sampled_from(BATCHES))
        length = data.draw(st.sampled_from([1, 1, 1, 2]))
        few = st.sampled_from([0, 1, 7, SIZE - 1])  # so that the same come again
        tokens = np.array(data.draw(st.lists(few, min_size=batch * length, max_size=batch * length)))
        tokens = tokens.reshape(batch, length).astype(np.int64)
        given = np.zeros((batch, length, NUMBERS), np.float32)
        given.flat[0], given.flat[-1] = data.draw(numbers), data.draw(numbers)
        found = getattr(runtime, GRAPHS[graph])(tokens, given)
        assert found.tobytes() == plainly(runtime, graph, tokens, given).tobytes()


@pytest.mark.parametrize("graph", GRAPHS)
def test_each_is_embedded_once_and_numbers_always(runtime, graph):
    counted = runtime.sessions[graph] = Counted(runtime.sessions[graph])
    embed = getattr(runtime, GRAPHS[graph])
    for tokens in ([3, 5, 3], [5, 3], [5], [9, 3]):
        embed(*bare(tokens))
    assert counted.tokens == {3: 1, 5: 1, 9: 1}
    tokens, numbers = bare([3])
    numbers[0, 0, 2] = 0.5
    for _ in range(3):
        embed(tokens, numbers)
    assert counted.tokens[3] == 4


def test_graphs_do_not_take_each_other_s(runtime):
    given = bare([4])
    made = [getattr(runtime, name)(*given).tobytes() for name in GRAPHS.values()]
    assert len(set(made)) == len(GRAPHS)
    assert [getattr(runtime, name)(*given).tobytes() for name in GRAPHS.values()] == made


@pytest.mark.parametrize("graph", GRAPHS)
def test_what_is_handed_out_may_be_changed(runtime, graph):
    embed, given = getattr(runtime, GRAPHS[graph]), bare([3, 5, 3])
    expected = embed(*given).tobytes()
    for _ in range(2):
        spoilt = embed(*given)
        spoilt[:] = np.nan
    assert embed(*given).tobytes() == expected


@pytest.mark.parametrize("graph", GRAPHS)
def test_no_tokens_at_all_are_an_empty_batch(runtime, graph):
    given = bare([])
    assert getattr(runtime, GRAPHS[graph])(*given).shape == plainly(runtime, graph, *given).shape


def test_as_many_are_kept_as_there_are_tokens(runtime):
    for _ in range(2):
        for name in GRAPHS.values():
            getattr(runtime, name)(*bare(range(SIZE)))
    assert len(runtime._bare) == len(GRAPHS) * SIZE


def test_two_networks_remember_apart(sessions):
    class Doubled:
        def __init__(self, session):
            self.session = session

        def run(self, names, given):
            return [2 * self.session.run(names, given)[0]]

    first = OnnxRuntime(dict(sessions))
    other = OnnxRuntime({**sessions, "embed": Doubled(sessions["embed"])})
    given = bare([1, 2])
    assert np.array_equal(2 * first.embed(*given), other.embed(*given))
    assert np.array_equal(2 * first.embed(*given), other.embed(*given))


def test_a_pattern_is_written_the_same_by_a_network_that_has_written_before(unmended):
    used, expected = PatternMaker.load(TINY), PatternMaker.load(TINY).generate("a dress", seed=4)
    for text in ("trousers", "a hood", "a dress"):
        used.generate(text, seed=1, temperature=1.0)
    again = used.generate("a dress", seed=4)
    assert again.sequence.tokens.tolist() == expected.sequence.tokens.tolist()
    assert again.sequence.numbers.tobytes() == expected.sequence.numbers.tobytes()
    assert again.log_likelihood == expected.log_likelihood


@pytest.mark.skipif(not SHIPPED.is_file(), reason="the package has no weights")
@pytest.mark.parametrize("graph", GRAPHS)
def test_the_weights_of_the_package_too(shipped, graph):
    """Larger ones, of which a batch may be multiplied otherwise than a single token."""
    runtime, drawn = OnnxRuntime(dict(shipped)), np.random.default_rng(7)
    for batch in BATCHES * 4:
        given = bare(drawn.integers(SIZE, size=batch))
        assert getattr(runtime, GRAPHS[graph])(*given).tobytes() == plainly(runtime, graph, *given).tobytes()
