from __future__ import annotations

import re
from html.parser import HTMLParser
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sample_makers import COARSE, make_quickly, run_here

from swifttailor.data.builder import build_split
from swifttailor.data.reader import SplitReader
from swifttailor.data.renders.files import RenderSettings, SplitRenders
from swifttailor.data.stats import choose, count_split, show_sample, write_page, write_sheets
from swifttailor.data.stats.numbers import MEASURES, SplitNumbers
from swifttailor.data.stats.page import histogram
from swifttailor.data.stats.sheets import wrapped
from swifttailor.errors import InputError
from swifttailor.pattern.pattern_list import read_patterns


@pytest.fixture
def split(patterns_file, tmp_path) -> Path:
    ids = ("a", "bad-b", "c", "bad-<d>", "e", "f", "g")
    build_split(
        read_patterns(patterns_file(*ids)),
        tmp_path / "set",
        "train",
        COARSE,
        runner=run_here,
        make=make_quickly,
    )
    return tmp_path / "set" / "train"


def numbers_of(split: Path, **options) -> SplitNumbers:
    *counts, result = count_split(split, **options)
    assert sum(counts) == 5
    return result


def test_numbers_are_those_of_the_samples(split):
    found = numbers_of(split)
    reader = SplitReader(split)
    samples = list(reader)
    assert found.values.keys() == MEASURES.keys()
    np.testing.assert_array_equal(found.values["vertices"], [len(s.vertices) for s in samples])
    np.testing.assert_array_equal(found.values["panels"], [len(s.pattern.panels) for s in samples])
    np.testing.assert_allclose(found.values["lowest_cm"], [s.vertices[:, 1].min() for s in samples])
    np.testing.assert_allclose(found.values["length_cm"], [np.ptp(s.vertices[:, 1]) for s in samples])
    np.testing.assert_allclose(found.values["kilobytes"], [reader.stored(k).size / 1e3 for k in range(5)])
    assert np.isnan(found.values["strain_p95"]).all(), "quickly made samples have none"
    assert found.reasons == {"did not come to rest": 2}
    assert found.claims["kind"] == {"skirt": 5}
    written = found.to_json()
    counts = [written[name] for name in ("patterns", "accepted", "rejected", "failed", "acceptance")]
    assert counts == [7, 5, 2, 0, 0.7143]
    assert written["quantiles"]["strain_p95"] == {}
    assert written["quantiles"]["panels"]["p50"] == len(samples[0].pattern.panels)
    assert len(found.seconds["sewing"]) == 5


def test_workers_do_not_change_the_numbers(split):
    one, two = numbers_of(split), numbers_of(split, workers=2)
    for name in MEASURES:
        np.testing.assert_array_equal(one.values[name], two.values[name])
    assert one.claims == two.claims
    (split / "results.jsonl").unlink()
    assert numbers_of(split).seconds == {}
    next(split.glob("shard-00001*")).unlink()
    with pytest.raises(InputError, match=r"shard-00001"):
        numbers_of(split)


def test_what_is_shown(split):
    assert choose(3, 5, 0) == choose(3, 5, 0) and len(set(choose(3, 5, 0))) == 3
    assert choose(9, 5, 1) == [0, 1, 2, 3, 4] and len({tuple(choose(3, 100, s)) for s in range(9)}) == 9
    reader = SplitReader(split)
    shown = show_sample(reader, 2, None, seed=4)
    assert shown.id == reader.ids[2] and shown.caption and shown.facts["number"] == 2
    assert {p.shape for p in (shown.front, shown.back, shown.render)} == {(256, 256, 3)}
    assert not np.array_equal(shown.front, shown.back)
    renders = SplitRenders(reader, RenderSettings(size=32, random=2))
    list(renders.draw())
    drawn = show_sample(reader, 2, renders, seed=4)
    assert drawn.render.shape == (256, 256, 3) and drawn.caption == shown.caption


class Page(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.sources: list[str] = []
        self.tags: list[str] = []

    def handle_starttag(self, tag, attributes) -> None:
        self.tags.append(tag)
        self.sources += [value for name, value in attributes if name in ("src", "href") and value]


def test_sheets_and_page(split, tmp_path):
    from PIL import Image

    reader = SplitReader(split)
    shown = [show_sample(reader, k, None, 0) for k in range(3)] * 8
    out = tmp_path / "stats"
    out.mkdir()
    sheets = write_sheets(out, "train", shown)
    assert [p.name for p in sheets] == ["train-01.png", "train-02.png"]
    assert sorted(p.name for p in out.iterdir()) == ["train-01.png", "train-02.png"]
    with Image.open(sheets[0]) as sheet:
        assert np.asarray(sheet).std() > 10
    page = write_page(out, "Data <set>", {"train": numbers_of(split)}, {"train": shown[:3]})
    text = page.read_text()
    parsed = Page()
    parsed.feed(text)
    assert parsed.tags.count("article") == 3 and parsed.tags.count("svg") == len(MEASURES) - 4
    assert len(parsed.sources) == 9 and all((out / source).is_file() for source in parsed.sources)
    assert "Data &lt;set&gt;" in text and "<set>" not in text and "did not come to rest" in text
    assert not re.search(r"https?://", text), "the page fetches nothing"


def test_histogram():
    drawing = histogram(np.array([1.0] * 30 + [2.0] * 10 + [np.nan]), bins=2)
    assert re.findall(r"<title>(\d+)</title>", drawing) == ["30", "10"]
    assert histogram(np.full(3, np.nan)) == "<p>no values</p>"
    assert histogram(np.full(3, 5.0)).count("<rect") == 28


@given(words=st.lists(st.text("abW", min_size=1, max_size=12), max_size=30), width=st.integers(5, 80))
def test_captions_are_broken_by_their_width(words, width):
    def length(text: str) -> float:
        return sum(3.0 if c == "W" else 1.0 for c in text)

    lines = wrapped(" ".join(words), width, length)
    assert " ".join(lines).split() == words
    assert all(length(line) <= width or " " not in line for line in lines)
    # No line is broken before it must be.
    assert all(length(f"{a} {b.split()[0]}") > width for a, b in pairwise(lines))
