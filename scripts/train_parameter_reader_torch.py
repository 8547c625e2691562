"""Trains the parameter reader that comes with the package (docs/garment-programs.md).

python scripts/train_parameter_reader_torch.py --patterns train.jsonl.gz usual.jsonl.gz
    --apart validation.jsonl.gz test.jsonl.gz --data DIR/train --out parameter_reader.onnx

The patterns have their design parameters beside them (``design``), as those of scripts/sample_garmentcode.py.
The network is told what is true of a pattern: now as a picture shows it, with mistakes drawn by lot, now the
little that words say, and of the garments of --data what the picture reader really reads in a plain picture.
It answers with the parameters. The card is written beside the model file. Needs the extra ``networks``.
"""

from __future__ import annotations

import argparse
import gzip
import hashlib
import json
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn import functional as F

from swifttailor.atomic_files import write_text
from swifttailor.data.reader import SplitReader
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.evaluation.maker.looks import LookPictures
from swifttailor.parameter_reader.drawn import drawn_designs
from swifttailor.parameter_reader.features import BOX_UNIT_CM, features_of
from swifttailor.parameter_reader.network_torch import ParameterNetwork, export
from swifttailor.parameter_reader.read_parameter import ReadParameter, read_parameters
from swifttailor.parameter_reader.which_matter import matters
from swifttailor.pattern import read_specification
from swifttailor.pattern.digest import pattern_digest
from swifttailor.pattern_library.sought import SURE, Sought
from swifttailor.picture_reader.labels import PARTS
from swifttailor.picture_reader.reader import PictureReader
from swifttailor.picture_reader.truth import TRUE, Truth

WIDTH, BLOCKS, DROPOUT = 512, 2, 0.3
BATCH, READ_BATCH, RATE, DECAY = 256, 128, 1e-3, 0.05
WORDY, FORESEEN = 0.4, 0.7
"""Share of patterns of which words tell, and of these the share of which panels are foreseen, too."""
MOST_DOUBT = 0.35
NEXT_RANGE = 0.15
"""How right the ranges beside a number's are."""
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
    parser.add_argument("--steps", type=int, default=1500)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--cache", type=Path, help="folder that keeps what was measured and read")
    parser.add_argument("--out", type=Path, required=True, help="model file, .onnx")
    options = parser.parse_args()
    torch.set_num_threads(1)
    torch.manual_seed(options.seed)
    apart = {pattern_digest(pattern) for path in options.apart for _, _, pattern in patterns_of(path)}
    rows = [row for path in options.patterns for row in measured(path, apart, options.cache)]
    rows += drawn(options.draw, options.seed, apart)
    read = [one for path in options.data for one in readings(path, options.most_read, options.cache)]
    print(f"{len(rows)} patterns, {len(read)} pictures read", flush=True)
    training = Training(rows, read, options.seed)
    figures = training.run(options.steps)
    files = {str(path.name): sha256(path) for path in (*options.patterns, *options.apart)}
    card = {
        "model": "ParameterReader",
        "parameters": sum(p.numel() for p in training.network.parameters()),
        "config": {"width": WIDTH, "blocks": BLOCKS, "dropout": DROPOUT, "steps": options.steps}
        | {"batch_size": BATCH, "read_batch_size": READ_BATCH, "learning_rate": RATE, "seed": options.seed},
        "data": {"patterns": len(rows), "drawn": options.draw, "pictures": training.pictures, "files": files},
        "validation": figures,
        "command": " ".join(["python", "scripts/train_parameter_reader_torch.py", *map(shown, sys.argv[1:])]),
    }
    export(training.network, training.parameters, card, options.out)
    write_text(options.out.with_suffix(".json"), json.dumps(card, indent=1) + "\n", overwrite=True)
    print(f"{options.out}: {options.out.stat().st_size / 1e6:.1f} MB")


@dataclass(frozen=True, eq=False)
class Row:
    """A pattern whose design is known."""

    id: str
    design: dict[str, Any]
    truth: Truth


def patterns_of(path: Path) -> Iterator[tuple[str, dict[str, Any], Any]]:
    """Id, design and pattern of each line that can be read."""
    with gzip.open(path, "rt", encoding="utf-8") as file:
        for line in map(json.loads, file):
            try:
                pattern = read_specification(line["pattern"], name=line["id"]).pattern.canonical()
            except SwiftTailorError as error:
                print(f"{line['id']}: {error}", file=sys.stderr)
                continue
            yield line["id"], line.get("design", {}), pattern


def measured(path: Path, apart: set[str], cache: Path | None) -> list[Row]:
    """What is true of the patterns of a file."""
    kept = None if cache is None else cache / f"truths-{sha256(path)[:16]}.npz"
    if kept is not None and kept.is_file():
        with np.load(kept) as found:
            about = json.loads(str(found["about"]))
            arrays = [found[name] for name in ("part", "statements", "measures", "panels", "boxes")]
        return [
            Row(id, design, Truth(int(arrays[0][k]), *(a[k] for a in arrays[1:])))
            for k, (id, design) in enumerate(about)
        ]
    rows = []
    for id, design, pattern in patterns_of(path):
        if pattern_digest(pattern) in apart:
            continue
        try:
            rows.append(Row(id, design, Truth.of(pattern, measure_facts(pattern))))
        except SwiftTailorError as error:
            print(f"{id}: {error}", file=sys.stderr)
        if len(rows) % 500 == 0:
            print(f"{path.name}: {len(rows)} patterns measured", flush=True)
    if kept is not None:
        kept.parent.mkdir(parents=True, exist_ok=True)
        truths = [row.truth for row in rows]
        names = ("part", "statements", "measures", "panels", "boxes")
        arrays = {name: np.array([getattr(truth, name) for truth in truths]) for name in names}
        np.savez_compressed(kept, about=json.dumps([[row.id, row.design] for row in rows]), **arrays)
    return rows


def drawn(count: int, seed: int, apart: set[str]) -> list[Row]:
    """Designs drawn by lot."""
    rows: list[Row] = []
    for design, pattern in drawn_designs(seed):
        if len(rows) >= count:
            break
        if pattern_digest(pattern) not in apart:
            rows.append(Row(f"drawn {len(rows)}", design, Truth.of(pattern, measure_facts(pattern))))
    return rows


def readings(split: Path, most: int, cache: Path | None) -> list[tuple[str, np.ndarray]]:
    """What the picture reader says of plain pictures of garments, front and back in turn."""
    kept = None if cache is None else cache / f"read-{split.parent.name}-{split.name}-{most}.npz"
    if kept is not None and kept.is_file():
        with np.load(kept) as found:
            return list(zip(found["ids"].tolist(), found["features"], strict=True))
    reader, samples, found = PictureReader.load(), SplitReader(split), []
    drawn = {view: LookPictures(split, 0, "plain", view) for view in ("front", "back")}
    step = max(1, len(samples.ids) // most)
    for number, id in enumerate(samples.ids[::step]):
        pattern = samples.sample(id).pattern
        part = PARTS[Truth.of(pattern, measure_facts(pattern)).part]
        picture = drawn["back" if number % 4 == 3 else "front"].picture(id)[1][0]
        seen = [one for one in reader.read(picture).parts if one.part == part]
        if seen:
            found.append((id, features_of(Sought.of_reading(seen[0]))))
        if number % 100 == 99:
            print(f"{split}: {number + 1} pictures read", flush=True)
    if kept is not None:
        kept.parent.mkdir(parents=True, exist_ok=True)
        ids, features = zip(*found, strict=True)
        np.savez_compressed(kept, ids=np.array(ids), features=np.stack(features))
    return found


class Training:
    """Of a network, from what is true of patterns and from what was read of pictures."""

    def __init__(self, rows: Sequence[Row], read: Sequence[tuple[str, np.ndarray]], seed: int) -> None:
        designs = [row.design for row in rows]
        names = [matters(design) for design in designs]
        self.parameters = read_parameters(designs, names)
        self.sizes = [len(one.values) for one in self.parameters]
        # A value that occurs only where it does not matter is none of the choices.
        self.matter = torch.tensor([[p.name in one for p in self.parameters] for one in names]).float()
        self.right = torch.tensor(
            [
                [p.place_of(d[p.name]) if p.name in one else 0 for p in self.parameters]
                for d, one in zip(designs, names, strict=True)
            ]
        )
        self.soft = [_near(one) for one in self.parameters]
        self.told = _Told(rows)
        place = {row.id: k for k, row in enumerate(rows)}
        read = [(id, features) for id, features in read if id in place]
        self.pictures = len(read)
        self.features = torch.from_numpy(np.array([features for _, features in read], np.float32))
        self.of = torch.tensor([place[id] for id, _ in read], dtype=torch.long)
        self.chance = torch.Generator().manual_seed(seed)
        count = len(features_of(Sought.nothing()))
        self.network = ParameterNetwork(count, sum(self.sizes), width=WIDTH, blocks=BLOCKS, dropout=DROPOUT)

    def run(self, steps: int) -> dict[str, Any]:
        """Trains, and says how well patterns that were held back are answered."""
        held = torch.arange(len(self.right)) % HELD == 0
        learnt, back = torch.where(~held)[0], torch.where(held)[0]
        seen, unseen = (torch.where(held[self.of] == x)[0] for x in (False, True))
        optimizer = torch.optim.AdamW(self.network.parameters(), RATE, weight_decay=DECAY)
        rate = torch.optim.lr_scheduler.OneCycleLR(optimizer, RATE, total_steps=steps)
        figures: dict[str, Any] = {}
        for step in range(1, steps + 1):
            rows = learnt[torch.randint(len(learnt), (BATCH,), generator=self.chance)]
            features = self.told.by_chance(rows, self.chance)
            if len(seen):
                chosen = seen[torch.randint(len(seen), (READ_BATCH,), generator=self.chance)]
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


class _Told:
    """What is true of patterns, and what of it is told."""

    def __init__(self, rows: Sequence[Row]) -> None:
        full = [Sought.of_truth(row.truth) for row in rows]

        def stacked(name: str) -> Tensor:
            return torch.from_numpy(np.stack([getattr(one, name) for one in full]))

        self.statements, self.has, self.panels = map(stacked, ("statements", "has", "panels"))
        self.measures = stacked("measured")[..., 0]
        self.boxes, self.placed = stacked("boxes"), stacked("placed").clamp(max=1)
        self.true = torch.from_numpy(np.stack([row.truth.statements == TRUE for row in rows]))

    def all_of(self, rows: Tensor) -> Tensor:
        """Everything, without a mistake."""
        ones = [torch.ones_like(x[rows]) for x in (self.statements, self.has, self.panels)]
        return _features(
            (self.statements[rows], ones[0]),
            (self.has[rows], ones[1], self.measures[rows]),
            (self.panels[rows], ones[2]),
            (self.boxes[rows], self.placed[rows]),
        )

    def by_chance(self, rows: Tensor, chance: torch.Generator) -> Tensor:
        """As pictures tell it, with mistakes, or as few words do."""
        count = len(rows)

        def lots(*shape: int) -> Tensor:
            return torch.rand(*shape, generator=chance)

        doubt = MOST_DOUBT * lots(count, 1)

        def doubted(values: Tensor) -> Tensor:
            logits = torch.logit(values.clamp(1e-3, 1 - 1e-3)) * (1 - doubt)
            off = 4 * doubt * torch.randn(values.shape, generator=chance)
            return torch.sigmoid(logits + off).clamp(1 - SURE, SURE)

        statements, has, panels = self.statements[rows], self.has[rows], self.panels[rows]
        measures, placed = self.measures[rows], self.placed[rows]
        off_measures = measures + 0.3 * doubt * torch.randn(measures.shape, generator=chance)
        off = 12 * doubt[..., None] * torch.randn(self.boxes[rows].shape, generator=chance)
        boxes = self.boxes[rows] + off * (placed > 0)[..., None]
        words = lots(count, 1) < WORDY
        said = (lots(*statements.shape) < 0.15 + 0.75 * lots(count, 1)) & self.true[rows]
        told = (lots(*has.shape) < 0.3 * lots(count, 1)) & (has > 0.5)
        named = ~words | (lots(count, 1) < FORESEEN)
        asked = torch.where(said, torch.full_like(statements, SURE), torch.full_like(statements, 0.5))
        asked_has = torch.where(told, torch.full_like(has, SURE), torch.full_like(has, 0.5))
        return _features(
            (torch.where(words, asked, doubted(statements)), (~words | said).float()),
            (
                torch.where(words, asked_has, doubted(has)),
                (~words | told).float(),
                torch.where(words, measures, off_measures),
            ),
            (doubted(panels), named.float().expand_as(panels)),
            (boxes, placed * (~words).float()),
        )


def _features(
    said: tuple[Tensor, Tensor],
    measured: tuple[Tensor, Tensor, Tensor],
    named: tuple[Tensor, Tensor],
    placed: tuple[Tensor, Tensor],
) -> Tensor:
    """(B, F) the same as `features_of`, of many."""
    (statements, told), (has, known, values), (panels, names), (boxes, there) = said, measured, named, placed
    rows = [told * (2 * statements - 1), told, known * (2 * has - 1), known, known * has * values]
    rows += [names * (2 * panels - 1), names, (there[..., None] * boxes / BOX_UNIT_CM).flatten(1)]
    return torch.cat(rows, 1).float()


def _near(parameter: ReadParameter) -> Tensor:
    """(values, values) how right each value is where another one is true."""
    count = len(parameter.values)
    if not parameter.is_number:
        return torch.eye(count)
    apart = (torch.arange(count)[:, None] - torch.arange(count)).abs()
    right = torch.where(apart == 0, 1 - 2 * NEXT_RANGE, torch.where(apart == 1, NEXT_RANGE, 0.0))
    return right / right.sum(1, keepdim=True)


def sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def shown(argument: str) -> str:
    """Without the folders of this machine."""
    return Path(argument).name if "/" in argument else argument


if __name__ == "__main__":
    main()
