"""Reads GarmentCode's design parameters out of texts and pictures, in the manner of ChatGarment.

A small network learns from patterns with known parameters: it is told what is true of a pattern (statements,
measures, panels and where they lie), now as a picture shows it, now the little that words say, and answers
with the parameters. What it is told of a text or picture in the end is what SwiftTailor's readers read there,
so that this differs from ``swifttailor generate`` in one thing: parameters for GarmentCode's program in place
of a known pattern that is cut. Its answers are no patterns yet: scripts/sample_garmentcode.py makes these of
them, with a checkout of GarmentCode, and ``swifttailor evaluate systems`` takes them as a generator.

    python scripts/design_parameters_torch.py learn train.jsonl.gz train-2.jsonl.gz --out design.pt
    python scripts/design_parameters_torch.py answer design.pt --patterns test.jsonl.gz --data DIR/test
        --task image --out designs.jsonl.gz
    garmentcode-env/bin/python scripts/sample_garmentcode.py GarmentCode --designs designs.jsonl.gz
        --out answers.jsonl.gz
    swifttailor evaluate systems --patterns test.jsonl.gz --data DIR/test --tasks image
        --generators ours design-parameters=answers.jsonl.gz --out systems

The first two need the extra ``networks``. A training takes some minutes of one core.
"""

from __future__ import annotations

import argparse
import gzip
import json
import sys
from collections.abc import Iterator, Sequence
from contextlib import nullcontext
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn
from torch.nn import functional as F

from swifttailor.errors import SwiftTailorError
from swifttailor.evaluation.maker.ask import Asking
from swifttailor.evaluation.maker.questions import PatternSet
from swifttailor.evaluation.maker.run import Plan, pictures_of, questions_of
from swifttailor.pattern_library.known import PatternLibrary
from swifttailor.pattern_library.sought import EXACT, SURE, Sought
from swifttailor.picture_reader.reader import PictureReader
from swifttailor.picture_reader.truth import TRUE, Truth
from swifttailor.tailor.reading import read_order
from swifttailor.wishes.reader import WishReader

BINS = 32
"""A number is one of so many ranges, which equally many patterns fall into."""
WIDTH, CANDIDATES = 768, 8
WORDY = 0.5
"""Share of patterns of which no more is told than a few words tell."""
BATCH, RATE, HELD = 256, 1e-3, 10
LOTS = 10
"""Number of the chances that candidates are drawn by, the same for every question."""
BOX_CM = 50.0


@dataclass(frozen=True)
class Parameter:
    """One of GarmentCode's design parameters."""

    path: str
    values: list[Any]
    """Its choices, or the middles of the ranges of a number."""
    edges: list[float] | None = None
    """Between the ranges of a number; None for choices."""

    def number_of(self, value: Any) -> int:
        """Of its choice or range."""
        return self.values.index(value) if self.edges is None else int(np.searchsorted(self.edges, value))


class Network(nn.Module):
    """From what is sought to the logits of all parameters."""

    def __init__(self, inputs: int, outputs: int) -> None:
        super().__init__()
        self.first = nn.Linear(inputs, WIDTH)
        self.blocks = nn.ModuleList(
            nn.Sequential(nn.LayerNorm(WIDTH), nn.Linear(WIDTH, WIDTH), nn.GELU(), nn.Dropout(0.2))
            for _ in range(3)
        )
        self.last = nn.Sequential(nn.LayerNorm(WIDTH), nn.Linear(WIDTH, outputs))

    def forward(self, sought: Tensor) -> Tensor:
        """(B, inputs) to (B, outputs)."""
        state = F.gelu(self.first(sought))
        for block in self.blocks:
            state = state + block(state)
        return self.last(state)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    commands = parser.add_subparsers(required=True)
    learning = commands.add_parser("learn", help="train the network")
    learning.add_argument("patterns", type=Path, nargs="+", help=".jsonl.gz with id and design")
    learning.add_argument(
        "--library", type=Path, help="known patterns with these ids; the package's by default"
    )
    learning.add_argument("--out", type=Path, required=True)
    learning.add_argument("--steps", type=int, default=6000)
    learning.add_argument("--seed", type=int, default=0)
    learning.set_defaults(run=learn)
    answering = commands.add_parser("answer", help="read texts or pictures")
    answering.add_argument("network", type=Path)
    answering.add_argument("--patterns", type=Path, nargs="+", required=True)
    answering.add_argument("--data", type=Path, help="their drapes, to draw pictures of")
    answering.add_argument("--task", choices=("text", "image", "text+image"), required=True)
    answering.add_argument("--look", default="plain")
    answering.add_argument("--view", default="front")
    answering.add_argument("--limit", type=int)
    answering.add_argument("--seed", type=int, default=0)
    answering.add_argument(
        "--truth", action="store_true", help="tell it all that is true, as a perfect reader"
    )
    answering.add_argument("--out", type=Path, required=True)
    answering.set_defaults(run=answer)
    options = parser.parse_args()
    torch.set_num_threads(1)
    options.run(options)


def learn(options: argparse.Namespace) -> None:
    """Trains, and says how often parameters of patterns that were held back are right."""
    library = PatternLibrary.load(options.library)
    designs = {line["id"]: line["design"] for path in options.patterns for line in lines_of(path)}
    rows = [k for k, id in enumerate(library.ids) if id in designs]
    if not rows:
        sys.exit("None of the patterns of the library has a design in these files.")
    chosen = [designs[library.ids[k]] for k in rows]
    parameters = parameters_of(chosen)
    truths = [library.table[k] for k in rows]
    targets = torch.tensor([[p.number_of(design[p.path]) for p in parameters] for design in chosen])
    held = torch.arange(len(rows)) % HELD == 0
    torch.manual_seed(options.seed)
    chance = np.random.default_rng(options.seed)
    sizes = [len(p.values) for p in parameters]
    inputs = len(vector(Sought.nothing()))
    network = Network(inputs, sum(sizes))
    optimizer = torch.optim.AdamW(network.parameters(), RATE, weight_decay=0.05)
    rate = torch.optim.lr_scheduler.OneCycleLR(optimizer, RATE, total_steps=options.steps)
    learnt = np.flatnonzero(~held.numpy())
    full = torch.from_numpy(np.stack([vector(Sought.of_truth(truth)) for truth in truths]))
    for step in range(options.steps):
        batch = chance.choice(learnt, BATCH, replace=False)
        sought = torch.stack([as_told(truths[k], full[k], chance) for k in batch])
        loss = loss_of(network(sought), targets[batch], sizes)
        optimizer.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(network.parameters(), 1.0)
        optimizer.step()
        rate.step()
        if (step + 1) % 500 == 0:
            network.eval()
            with torch.no_grad():
                told_all = network(full[held])
            network.train()
            right = shares_right(told_all, targets[held], sizes)
            shown = {p.path: round(r, 3) for p, r in zip(parameters, right, strict=True) if p.path in SHOWN}
            print(
                f"{step + 1} of {options.steps} steps, loss {loss.item():.3f}, held back: {shown}", flush=True
            )
    torch.save(
        {"network": network.state_dict(), "parameters": [asdict(p) for p in parameters], "inputs": inputs},
        options.out,
    )
    print(f"{len(learnt)} patterns learnt, {int(held.sum())} held back, seed {options.seed}: {options.out}")


SHOWN = ("meta.upper", "meta.bottom", "meta.wb", "collar.f_collar", "sleeve.sleeveless", "skirt.length")


def lines_of(path: Path) -> Iterator[dict[str, Any]]:
    """The objects of a .jsonl.gz file."""
    with gzip.open(path, "rt", encoding="utf-8") as file:
        for line in file:
            yield json.loads(line)


def parameters_of(designs: Sequence[dict[str, Any]]) -> list[Parameter]:
    """Those that vary, with their choices or ranges."""
    found = []
    for path in designs[0]:
        values = [design[path] for design in designs]
        if all(type(value) in (int, float) for value in values) and len(set(values)) > BINS:
            among = np.sort(values)
            edges = np.unique(among[len(among) * np.arange(1, BINS) // BINS])
            edges = edges[edges < among[-1]]  # a range ends with a value that occurs, so that none is empty
            which = np.searchsorted(edges, among)
            middles = [float(np.median(among[which == k])) for k in range(len(edges) + 1)]
            found.append(Parameter(path, middles, edges.tolist()))
        elif len({json.dumps(value) for value in values}) > 1:
            unlike = {json.dumps(value): value for value in values}
            found.append(Parameter(path, [unlike[key] for key in sorted(unlike)]))
    return found


def vector(sought: Sought) -> NDArray[np.float32]:
    """What is sought as one row: every value weighed by whether it is known, and whether it is."""
    known = [np.minimum(w, 1.0) for w in (sought.said, sought.measures, sought.named, sought.placed)]
    said, measured, named, placed = known
    return np.concatenate(
        [
            said * (2 * sought.statements - 1),
            said,
            measured * (2 * sought.has - 1),
            measured,
            measured * sought.has * sought.measured[:, 0],
            named * (2 * sought.panels - 1),
            named,
            (placed[:, None] * sought.boxes / BOX_CM).ravel(),
        ],
        dtype=np.float32,
    )


def as_told(truth: Truth, full: Tensor, chance: np.random.Generator) -> Tensor:
    """What is true, told as by a picture that is read with mistakes, or as by few words."""
    if chance.random() >= WORDY:
        return torch.from_numpy(vector(misread(truth, chance)))
    return torch.from_numpy(vector(few_words(truth, chance)))


def misread(truth: Truth, chance: np.random.Generator) -> Sought:
    """As of a picture: nothing is quite sure, some of it is wrong, places and measures are off."""
    found = Sought.of_truth(truth)
    doubt = chance.uniform(0.0, 0.35)
    for values in (found.statements, found.has, found.panels):
        logits = np.log(values / (1 - values)) * (1 - doubt) + chance.normal(0, 4 * doubt, values.shape)
        values[:] = np.clip(1 / (1 + np.exp(-logits)), 1 - SURE, SURE)
    found.measured[:, 0] += chance.normal(0, 0.3 * doubt, len(found.measured))
    found.boxes[:] += chance.normal(0, 12 * doubt, found.boxes.shape) * (found.placed[:, None] > 0)
    return found


def few_words(truth: Truth, chance: np.random.Generator) -> Sought:
    """As of a caption: some true statements and measures, and nothing of the rest."""
    found = Sought.nothing()
    true = np.flatnonzero(truth.statements == TRUE)
    said = true[chance.random(len(true)) < chance.uniform(0.15, 0.9)]
    found.statements[said], found.said[said] = SURE, 1.0
    known = np.flatnonzero(np.isfinite(truth.measures))
    told = known[chance.random(len(known)) < chance.uniform(0.0, 0.3)]
    full = Sought.of_truth(truth)
    found.has[told], found.measures[told] = SURE, 1.0
    found.measured[told, 0], found.measured[told, 1] = full.measured[told, 0], EXACT
    return found


def loss_of(logits: Tensor, targets: Tensor, sizes: Sequence[int]) -> Tensor:
    """Mean over the parameters."""
    parts = logits.split(list(sizes), dim=1)
    losses = [F.cross_entropy(part, targets[:, k]) for k, part in enumerate(parts)]
    return torch.stack(losses).mean()


def shares_right(logits: Tensor, targets: Tensor, sizes: Sequence[int]) -> list[float]:
    """Of each parameter how often its likeliest value is right."""
    parts = logits.split(list(sizes), dim=1)
    return [float((part.argmax(dim=1) == targets[:, k]).float().mean()) for k, part in enumerate(parts)]


def answer(options: argparse.Namespace) -> None:
    """Writes for each question designs to try, the likeliest first."""
    kept = torch.load(options.network, weights_only=True)
    parameters = [Parameter(**values) for values in kept["parameters"]]
    network = Network(kept["inputs"], sum(len(p.values) for p in parameters))
    network.load_state_dict(kept["network"])
    network.eval()
    pictured = options.task != "text"
    asking = Asking(seed=options.seed)
    plan = Plan(
        tuple(options.patterns),
        options.data,
        tasks=(options.task,),
        limit=options.limit,
        asking=asking,
        look=options.look if options.data is not None else None,
        view=options.view,
        samples=0,
    )
    patterns, pictures = PatternSet.read(plan.patterns), pictures_of(plan)
    if pictures is not None:
        for id in [id for id in patterns.patterns if id not in pictures]:
            del patterns.patterns[id]
    questions = questions_of(
        plan, plan.chosen_tasks(), patterns, pictures, None, lambda *_: nullcontext(Silent())
    )
    words, eyes = WishReader.load(), PictureReader.load() if pictured else None
    with gzip.GzipFile(options.out, "wb", mtime=0) as file:
        for question in questions:
            try:
                if options.truth:
                    sought = Sought.of_truth(Truth.of(question.truth, question.facts))
                else:
                    sought = read_order(asking.order(question, pictures), words, eyes).sought
            except SwiftTailorError as error:
                print(f"{question.id}: {error}", file=sys.stderr)
                continue
            with torch.no_grad():
                logits = network(torch.from_numpy(vector(sought))[None])[0]
            designs = candidates(logits, parameters, np.random.default_rng([options.seed, LOTS]))
            file.write(json.dumps({"id": question.id, "designs": designs}).encode() + b"\n")
    print(f"{len(questions)} questions: {options.out}")


class Silent:
    """Progress that nobody watches."""

    def add(self, count: int) -> None:
        """Does nothing."""


def candidates(
    logits: Tensor, parameters: Sequence[Parameter], chance: np.random.Generator
) -> list[dict[str, Any]]:
    """Parameters to try: the likeliest values, then some drawn by their probabilities."""
    parts = [
        part.softmax(dim=0).double().numpy() for part in logits.split([len(p.values) for p in parameters])
    ]
    found = []
    for number in range(CANDIDATES):
        design = {}
        for parameter, shares in zip(parameters, parts, strict=True):
            if parameter.edges is not None:
                choice = int(np.searchsorted(np.cumsum(shares), 0.5))
            elif number == 0:
                choice = int(shares.argmax())
            else:
                sharper = shares ** (1 + 3 / number)
                choice = int(chance.choice(len(shares), p=sharper / sharper.sum()))
            design[parameter.path] = parameter.values[min(choice, len(parameter.values) - 1)]
        found.append(design)
    return found


if __name__ == "__main__":
    main()
