"""The first page: filled, offline, in no time."""

from __future__ import annotations


def test_it_opens_on_a_finished_example(page, shot):
    page.goto("/")
    page.wait_for_selector("canvas")
    page.wait_for_load_state("networkidle")
    shot(page, "first-page")
    assert page.title()
    assert page.locator("svg").count() > 0
