"""Trains the parameter reader that comes with the package (docs/garment-programs.md).

python scripts/train_parameter_reader_torch.py --patterns train.jsonl.gz usual.jsonl.gz
    --apart validation.jsonl.gz test.jsonl.gz --data DIR/train --out parameter_reader.onnx

The patterns have their design parameters beside them (``design``), as those of scripts/sample_garmentcode.py.
The network is told what is true of a pattern: now as a picture shows it, with mistakes drawn by lot, now the
little that words say, and of the garments of --data what the picture reader really reads in a picture of
each of the --looks. It answers with the parameters. The card is written beside the model file. Needs the
extra ``networks``.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn import functional as F

from swifttailor.atomic_files import write_text
from swifttailor.describing.measuring import measure_facts
from swifttailor.evaluation.maker.looks import LOOKS
from swifttailor.networks.graph_weights_torch import graph_weights
from swifttailor.parameter_reader import ParameterReader
from swifttailor.parameter_reader.drawn import drawn_designs
from swifttailor.parameter_reader.features import features_of
from swifttailor.parameter_reader.network_torch import ParameterNetwork, export
from swifttailor.parameter_reader.placed_designs import nearly_right
from swifttailor.parameter_reader.which_matter import matters
from swifttailor.pattern.digest import pattern_digest
from swifttailor.pattern_library.sought import Sought
from swifttailor.picture_reader.truth import Truth
from swifttailor.programs.read_parameter import ReadParameter, read_parameters
from swifttailor.training.told_patterns import ToldPattern, measured, patterns_of, readings, sha256, shown
from swifttailor.training.told_torch import Told

WIDTH, BLOCKS, DROPOUT = 512, 2, 0.3
BATCH, RATE, DECAY = 256, 1e-3, 0.05
HELD = 12
"""One of so many patterns is held back."""
SHOWN = ("meta.upper", "meta.bottom", "meta.wb", "collar.f_collar", "sleeve.sleeveless", "sleeve.cuff.type")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--patterns", type=Path, nargs="*", default=[], help=".jsonl.gz with design")
    parser.add_argument("--draw", type=int, default=0, help="so many designs are drawn by lot, and drafted")
    parser.add_argument("--apart", type=Path, nargs="*", default=[], help="patterns whose twins are left out")
    parser.add_argument("--data", type=Path, nargs="*", default=[], help="splits of sewn garments to read")
    parser.add_argument("--most-read", type=int, default=3000, help="garments of each split that are read")
    parser.add_argument(
        "--looks", nargs="+", choices=LOOKS, default=["plain"], help="of the pictures that are read"
    )
    parser.add_argument("--steps", type=int, default=1500)
    parser.add_argument(
        "--read-batch", type=int, default=128, help="pictures beside 256 patterns in each step"
    )
    parser.add_argument("--start", type=Path, help="model file to go on from, with its choices and ranges")
    parser.add_argument("--learning-rate", type=float, default=RATE)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--cache", type=Path, help="folder that keeps what was measured and read")
    parser.add_argument("--out", type=Path, required=True, help="model file, .onnx")
    options = parser.parse_args()
    torch.set_num_threads(1)
    torch.manual_seed(options.seed)
    apart = {pattern_digest(pattern) for path in options.apart for _, _, pattern in patterns_of(path)}
    rows = [row for path in options.patterns for row in measured(path, apart, options.cache)]
    rows += drawn(options.draw, options.seed, apart)
    ids = {row.id for row in rows}
    read = [
        one
        for look in options.looks
        for path in options.data
        for one in readings(path, options.most_read, options.cache, ids, look)
    ]
    print(f"{len(rows)} patterns, {len(read)} pictures read", flush=True)
    training = Training(rows, read, options.seed, options.start)
    figures = training.run(options.steps, options.read_batch, options.learning_rate)
    sources = [*options.patterns, *options.apart, *filter(None, [options.start])]
    files = {str(path.name): sha256(path) for path in sources}
    card = {
        "model": "ParameterReader",
        "parameters": sum(p.numel() for p in training.network.parameters()),
        "config": {"width": WIDTH, "blocks": BLOCKS, "dropout": DROPOUT, "steps": options.steps}
        | {"batch_size": BATCH, "read_batch_size": options.read_batch}
        | {"learning_rate": options.learning_rate, "start": options.start and options.start.name}
        | {"seed": options.seed},
        "data": {"patterns": len(rows), "drawn": options.draw, "pictures": training.pictures, "files": files},
        "validation": figures,
        "command": " ".join(["python", "scripts/train_parameter_reader_torch.py", *map(shown, sys.argv[1:])]),
    }
    export(training.network, training.parameters, card, options.out)
    write_text(options.out.with_suffix(".json"), json.dumps(card, indent=1) + "\n", overwrite=True)
    print(f"{options.out}: {options.out.stat().st_size / 1e6:.1f} MB")


def drawn(count: int, seed: int, apart: set[str]) -> list[ToldPattern]:
    """Designs drawn by lot."""
    rows: list[ToldPattern] = []
    for design, pattern in drawn_designs(seed):
        if len(rows) >= count:
            break
        if pattern_digest(pattern) not in apart:
            rows.append(ToldPattern(f"drawn {len(rows)}", design, Truth.of(pattern, measure_facts(pattern))))
    return rows


class Training:
    """Of a network, from what is true of patterns and from what was read of pictures."""

    def __init__(
        self,
        rows: Sequence[ToldPattern],
        read: Sequence[tuple[str, np.ndarray]],
        seed: int,
        start: Path | None = None,
    ) -> None:
        before = ParameterReader.load(start) if start else None
        if before:
            rows = [row for row in rows if known_to(before.parameters, row.design)]
        designs = [row.design for row in rows]
        names = [matters(design) for design in designs]
        self.parameters = before.parameters if before else read_parameters(designs, names)
        self.sizes = [len(one.values) for one in self.parameters]
        # A value that occurs only where it does not matter is none of the choices.
        self.matter = torch.tensor([[p.name in one for p in self.parameters] for one in names]).float()
        self.right = torch.tensor(
            [
                [p.place_of(d[p.name]) if p.name in one else 0 for p in self.parameters]
                for d, one in zip(designs, names, strict=True)
            ]
        )
        self.soft = [
            torch.from_numpy(nearly_right(len(one.values), is_number=one.is_number)).float()
            for one in self.parameters
        ]
        self.told = Told([row.truth for row in rows])
        place = {row.id: k for k, row in enumerate(rows)}
        read = [(id, features) for id, features in read if id in place]
        self.pictures = len(read)
        self.features = torch.from_numpy(np.array([features for _, features in read], np.float32))
        self.of = torch.tensor([place[id] for id, _ in read], dtype=torch.long)
        self.chance = torch.Generator().manual_seed(seed)
        count = len(features_of(Sought.nothing()))
        self.network = ParameterNetwork(count, sum(self.sizes), width=WIDTH, blocks=BLOCKS, dropout=DROPOUT)
        if start:
            self.network.load_state_dict(graph_weights(start, self.network))

    def run(self, steps: int, read_batch: int, learning_rate: float = RATE) -> dict[str, Any]:
        """Trains, and says how well patterns that were held back are answered."""
        held = torch.arange(len(self.right)) % HELD == 0
        learnt, back = torch.where(~held)[0], torch.where(held)[0]
        seen, unseen = (torch.where(held[self.of] == x)[0] for x in (False, True))
        optimizer = torch.optim.AdamW(self.network.parameters(), learning_rate, weight_decay=DECAY)
        rate = torch.optim.lr_scheduler.OneCycleLR(optimizer, learning_rate, total_steps=steps)
        figures: dict[str, Any] = {}
        for step in range(1, steps + 1):
            rows = learnt[torch.randint(len(learnt), (BATCH,), generator=self.chance)]
            features = self.told.by_chance(rows, self.chance)
            if len(seen):
                chosen = seen[torch.randint(len(seen), (read_batch,), generator=self.chance)]
                features = torch.cat([features, self.features[chosen]])
                rows = torch.cat([rows, self.of[chosen]])
            loss = self.loss(features, rows)
            optimizer.zero_grad()
            loss.backward()
            nn.utils.clip_grad_norm_(self.network.parameters(), 1.0)
            optimizer.step()
            rate.step()
            if step % 250 == 0 or step == steps:
                self.network.eval()
                figures = {"patterns": len(back), "told_all": self.judge(self.told.all_of(back), back)}
                if len(unseen):
                    figures["read"] = self.judge(self.features[unseen], self.of[unseen])
                self.network.train()
                print(f"{step} of {steps} steps, loss {loss.item():.3f}; held back: {figures}", flush=True)
        return figures

    def loss(self, features: Tensor, rows: Tensor) -> Tensor:
        """Mean over the parameters that matter."""
        total = torch.zeros(len(rows))
        for k, logits in enumerate(self.network(features).split(self.sizes, 1)):
            off = -(self.soft[k][self.right[rows, k]] * F.log_softmax(logits, 1)).sum(1)
            total = total + off * self.matter[rows, k]
        return (total / self.matter[rows].sum(1)).mean()

    @torch.no_grad()
    def judge(self, features: Tensor, rows: Tensor) -> dict[str, Any]:
        """The loss, and how often the likeliest value of a parameter is right where it matters."""
        parts = self.network(features).split(self.sizes, 1)
        found: dict[str, Any] = {"loss": round(float(self.loss(features, rows)), 4)}
        for k, parameter in enumerate(self.parameters):
            mine = self.matter[rows, k] > 0
            if parameter.name in SHOWN and mine.any():
                hits = (parts[k].argmax(1) == self.right[rows, k])[mine]
                found[parameter.name] = round(float(hits.float().mean()), 3)
        return found


def known_to(parameters: Sequence[ReadParameter], design: dict[str, Any]) -> bool:
    """Whether every choice of a design that matters is one that a reader knows."""
    names = matters(design)
    return all(one.is_number or design[one.name] in one.values for one in parameters if one.name in names)


if __name__ == "__main__":
    main()
