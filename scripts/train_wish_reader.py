"""Trains the wish reader, src/swifttailor/wishes/wish_reader.onnx: a quarter of an hour on one core.

.venv/bin/python scripts/train_wish_reader.py --patterns train.jsonl.gz --edits edits.jsonl.gz \
    --validation validation.jsonl.gz --cache cache

Patterns are measured as for `swifttailor train pattern-maker`, and kept in the same cache.
"""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path

import tyro

from swifttailor.atomic_files import write_atomically, write_text
from swifttailor.data.builder.code_version import code_version
from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.training.maker_bank import open_bank, sequences_of
from swifttailor.training.wish_samples import WishSamples
from swifttailor.wishes.reader import SHIPPED


def main(
    patterns: tuple[Path, ...],
    edits: Path,
    validation: Path,
    cache: Path,
    apart: tuple[Path, ...] = (),
    out: Path = SHIPPED,
    recuts: int = 1,
    steps: int = 6000,
    seed: int = 0,
    threads: int = 1,
) -> None:
    """Trains, judges and writes a wish reader.

    Args:
        patterns: To write texts of.
        edits: Edited versions of some of them.
        validation: To judge by.
        cache: Where measured patterns are kept.
        apart: Patterns that are not learnt from, whatever their ids: a test split.
        out: File to write.
        recuts: Versions that are made of each pattern for editing.
        steps: Of 64 texts.
        seed: Of weights and texts.
        threads: Processor cores.
    """
    import torch

    from swifttailor.training.wish_loop_torch import (
        WishTraining,
        reader_file,
        score_values,
        train_wish_reader,
    )

    torch.set_num_threads(threads)
    held = open_bank([validation], edits, cache, recuts=recuts, report=print)
    bank = open_bank(patterns, edits, cache, recuts=recuts, report=print)
    bank = bank.without([*held.sequences(), *sequences_of(apart)])
    training = WishTraining(steps=steps, seed=seed)
    tokenizer = TextTokenizer.shipped()
    samples = WishSamples(bank, tokenizer, seed=seed, typos=training.typos)
    judged = WishSamples(held, tokenizer, seed=seed + 1, typos=0.0)
    network, score = train_wish_reader(samples, [judged.make(k) for k in range(2000)], training)
    card = {
        "training": asdict(training),
        "data": bank.numbers(),
        "validation": held.numbers() | {"texts": 2000} | score_values(score),
        "parameters": sum(p.numel() for p in network.parameters()),
        "commit": code_version()["commit"],
    }
    data = reader_file(network, card)
    write_atomically(out, lambda temporary: temporary.write_bytes(data))
    write_text(out.with_suffix(".json"), json.dumps(card, indent=1) + "\n")
    print(f"wrote {out}: {len(data) / 1e6:.1f} MB; {score}")


if __name__ == "__main__":
    tyro.cli(main)
