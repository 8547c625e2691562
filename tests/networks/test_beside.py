"""Work in another thread beside what this one does."""

from __future__ import annotations

import threading

import pytest

from swifttailor.networks.beside import beside


def test_a_call_goes_on_while_this_thread_does_something_else():
    gate = threading.Event()

    def waits(number: int, *, plus: int) -> tuple[int, str]:
        assert gate.wait(10)
        return number + plus, threading.current_thread().name

    result = beside(waits, 2, plus=3)
    gate.set()  # a call in this thread would have waited for it in vain
    number, name = result()
    assert number == 5 and name != threading.current_thread().name
    assert result() == (number, name)


def test_what_a_call_raises_is_raised_where_it_is_waited_for():
    result = beside(int, "no number")
    with pytest.raises(ValueError, match="no number"):
        result()
    assert beside(int, "7")() == 7, "the thread goes on"
