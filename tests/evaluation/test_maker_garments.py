"""Garments of answers beside drapes, against distances of all pairs."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from swifttailor.data.index import split_folders
from swifttailor.data.reader import SplitReader
from swifttailor.errors import GeometryError
from swifttailor.evaluation.garments.cloud_distances import chamfer
from swifttailor.evaluation.garments.point_cloud import sample_surface
from swifttailor.evaluation.maker.garments import Garments
from swifttailor.evaluation.maker.questions import Question, seed_of


class PerfectSewer:
    """Gives the drape of a pattern, moved; of the patterns in `refused` none."""

    def __init__(self, samples, moved=0.0):
        self.samples, self.moved = samples, moved
        self.refused: list[Any] = []
        self.sewn = 0

    def sew(self, pattern):
        self.sewn += 1
        if any(pattern is other for other in self.refused):
            raise GeometryError("crosses itself")
        sample = next(s for s in self.samples if s.pattern == pattern)
        garment = sample.garment
        vertices = np.add(garment.vertices, [0, self.moved, 0])
        return SimpleNamespace(vertices=vertices, faces=garment.faces, report={})


@pytest.fixture(scope="module")
def samples(data):
    reader = SplitReader(next(iter(split_folders(data).values())))
    return [reader[k] for k in range(len(reader))]


def scored(samples, answers) -> list[Any]:
    """Each sample asked for, and the pattern of another, or none, answered."""
    found = []
    for sample, answer in zip(samples, answers, strict=True):
        question = Question("text", sample.id, sample.pattern, cast(Any, None))
        record = {} if answer is not None else {"error": "no answer"}
        pattern = None if answer is None else answer.pattern
        found.append(
            SimpleNamespace(answer=SimpleNamespace(question=question, pattern=pattern, record=record))
        )
    return found


def find(samples):
    return lambda id: next((s for s in samples if s.id == id), None)


def test_right_answers_sewn_without_fault_are_at_the_floor(samples):
    sewer = PerfectSewer(samples)
    progress: list[int] = []
    garments = Garments(cast(Any, sewer), find(samples), seed=3)
    found = garments.compare(scored(samples, samples), progress.append)
    assert sum(progress) == len(samples)
    assert found.answers.coverage == found.truth.coverage == found.floor.coverage == 1.0
    assert found.chamfer == pytest.approx(found.floor.mmd, rel=0.2)
    assert sewer.sewn == 2 * len(samples)
    garments.compare(scored(samples, samples), progress.append)
    assert sewer.sewn == 3 * len(samples), "true patterns are sewn once"


def test_distances_are_those_of_all_pairs(samples):
    sewer = PerfectSewer(samples, moved=2.0)
    answers = [samples[1], samples[1], None]
    found = Garments(cast(Any, sewer), find(samples), seed=3).compare(
        scored(samples, answers), lambda n: None
    )

    def points(garment, moved, *names):
        return sample_surface(
            np.add(garment.vertices, [0, moved, 0]), garment.faces, 10_000, seed_of(3, *names)
        )

    references = [points(s.garment, 0, s.id, "drape 1") for s in samples]
    made = [
        points(a.garment, 2, f"text/{s.id}", "sewn")
        for s, a in zip(samples, answers, strict=True)
        if a is not None
    ]
    apart = np.array([[chamfer(m, r) for r in references] for m in made])
    assert found.answers.mmd == pytest.approx(apart.min(axis=0).mean())
    assert found.answers.coverage == pytest.approx(len(set(apart.argmin(axis=1).tolist())) / 3)
    assert found.chamfer == pytest.approx(np.mean([apart[0, 0], apart[1, 1]]))
    assert found.unsewable == {f"text/{samples[2].id}": "no answer"} and found.answers.failed == 1


def test_what_cannot_be_sewn_or_has_no_drape(samples):
    sewer = PerfectSewer(samples)
    sewer.refused = [samples[0].pattern]
    garments = Garments(cast(Any, sewer), find(samples[:2]), seed=0)
    found = garments.compare(scored(samples, samples), lambda n: None)
    assert found.answers.references == 2, "the third has no drape"
    assert found.unsewable == {f"text/{samples[0].id}": "crosses itself"}
    assert found.answers.failed == found.truth.failed == 1
    assert (
        Garments(cast(Any, sewer), find([]), seed=0).compare(scored(samples, samples), lambda n: None) is None
    )
