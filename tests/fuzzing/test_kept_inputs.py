"""Every reader, with the inputs that failed once and a few fresh ones; `make fuzz` feeds many more."""

from __future__ import annotations

import pytest

from fuzzing.campaign import Campaign
from fuzzing.corpus import CORPUS, corpus_of
from fuzzing.registry import all_targets, module_of

TARGETS = all_targets()
SHARE = 40
"""One in so many of the fresh inputs of `make fuzz`."""


@pytest.mark.parametrize("name", TARGETS)
def test_files_are_accepted_or_refused(name, tmp_path):
    target = TARGETS[name]
    campaign = Campaign(target, module_of(name), seed=1, folder=tmp_path)
    fresh = []
    for number in range(target.in_ci // SHARE):
        made = target.input(1, number)
        fresh.append(tmp_path / f"{number}{made.ending}")
        fresh[-1].write_bytes(made.data)
    # Together, for it takes a process longer to begin than to read them.
    assert campaign.replay([*corpus_of(name), *fresh]) == {}


def test_kept_inputs_are_of_targets():
    assert {folder.name for folder in CORPUS.iterdir()} <= set(TARGETS)


@pytest.mark.parametrize("name", [n for n in TARGETS if n != "sew"])
def test_sound_files_are_accepted(name, tmp_path):
    target = TARGETS[name]
    feed = target.load_feed()
    for k, file in enumerate(target.seeds):
        (tmp_path / str(k)).mkdir()
        path = tmp_path / str(k) / f"input{file.ending}"
        path.write_bytes(file.data)
        feed(path)
