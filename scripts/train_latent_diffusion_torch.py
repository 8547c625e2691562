"""Trains a latent diffusion over panel tensors, in the manner of SewingLDM (docs/evaluation.md, Systems).

python scripts/train_latent_diffusion_torch.py --patterns train.jsonl.gz ... --validation validation.jsonl.gz
    --apart test.jsonl.gz --minutes 20 25 --run DIR --out latent_diffusion.zip

First an auto-encoder learns to bring the panel tensors of patterns into few numbers and back, then a denoiser
to draw such numbers for what it is told: what is true of the pattern, with mistakes drawn by lot, now as a
picture shows it, now the little that words say, and of the garments of --data what the picture reader really
reads in a plain picture. Checkpoints go into --run every three minutes; the same command goes on from there.
The card is in the model file, and written beside it. Needs the extra ``train``.
"""

from __future__ import annotations

import argparse
import json
import sys
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
import torch

from swifttailor.atomic_files import write_text
from swifttailor.latent_diffusion import network_torch as network
from swifttailor.latent_diffusion.export_torch import export
from swifttailor.latent_diffusion.sampling import STEPS, drawn_latents
from swifttailor.latent_diffusion.tensor_pattern import pattern_of
from swifttailor.pattern.digest import pattern_digest
from swifttailor.training import latent_autoencoder_torch as first
from swifttailor.training import latent_denoiser_torch as second
from swifttailor.training.latent_bank import TensorBank, bank_of
from swifttailor.training.latent_stage_torch import Stage, StageConfig
from swifttailor.training.told_patterns import measured, patterns_of, readings, sha256, shown
from swifttailor.training.told_torch import Told

FIRST = {"batch_size": 16, "learning_rate": 1e-3, "weight_decay": 0.01, "ema": 0.999}
SECOND = {"batch_size": 64, "learning_rate": 6e-4, "weight_decay": 0.02, "ema": 0.999}
GUIDANCE = 1.0, 1.5, 2.0, 3.0
"""Of these the one is taken by which validation patterns, of which some is told, are drawn best."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--patterns", type=Path, nargs="+", required=True, help=".jsonl.gz")
    parser.add_argument("--validation", type=Path, required=True, help=".jsonl.gz")
    parser.add_argument("--apart", type=Path, nargs="*", default=[], help="patterns whose twins are left out")
    parser.add_argument("--data", type=Path, nargs="*", default=[], help="splits of sewn garments to read")
    parser.add_argument("--most-read", type=int, default=3000, help="garments of each split that are read")
    parser.add_argument("--minutes", type=float, nargs=2, default=[20, 25], help="of a core, for each stage")
    parser.add_argument("--steps", type=int, nargs=2, default=[10**6] * 2, help="at most so many")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--cache", type=Path, help="folder that keeps what was measured and read")
    parser.add_argument("--run", type=Path, required=True, help="folder for checkpoints")
    parser.add_argument("--out", type=Path, required=True, help="model file, .zip")
    options = parser.parse_args()
    torch.set_num_threads(1)
    torch.manual_seed(options.seed)
    held, files = (
        (options.validation, *options.apart),
        (*options.patterns, options.validation, *options.apart),
    )
    apart = {pattern_digest(pattern) for path in held for _, _, pattern in patterns_of(path)}
    rows = {row.id: row for path in options.patterns for row in measured(path, apart, options.cache)}
    bank = TensorBank.joined([bank_of(path, options.cache) for path in options.patterns])
    bank = bank.chosen([k for k, id in enumerate(bank.ids) if str(id) in rows])
    read = [one for path in options.data for one in readings(path, options.most_read, options.cache)]
    place = {str(id): k for k, id in enumerate(bank.ids)}
    read = [(place[id], features) for id, features in read if id in place]
    checked = Checked(options.validation, options.cache)
    print(f"{len(bank)} patterns, {len(read)} pictures read", flush=True)

    stages = [
        StageConfig(**settings, minutes=minutes, steps=steps, seed=options.seed)
        for settings, minutes, steps in zip((FIRST, SECOND), options.minutes, options.steps, strict=True)
    ]
    panels = first.Panels.of(bank)
    coder = first.AutoEncoder()
    coding = Stage("auto-encoder", coder, stages[0], options.run / "auto-encoder")
    coding.run(lambda chance: coder.loss(panels, panels.draw(stages[0].batch_size, chance)))
    decoder = coder.whole_decoder(panels)
    figures = {"auto_encoder": checked.coded(coder, panels)}
    print(f"auto-encoder: {figures['auto_encoder']}", flush=True)

    told = Told([rows[str(id)].truth for id in bank.ids])
    diffusion = second.LatentDiffusion(coder.latents(panels), told, read)
    drawing = Stage("denoiser", diffusion, stages[1], options.run / "denoiser")
    drawing.run(lambda chance: diffusion.loss(stages[1].batch_size, chance))
    decoder = decoder.for_drawn(diffusion.middle, diffusion.unit)
    some = {guidance: checked.drawn(diffusion, decoder, guidance, every=False) for guidance in GUIDANCE}
    guidance = max(some, key=lambda one: some[one]["panels"] + some[one]["stitch_f1"])
    figures["told_some"] = {f"guidance {one:g}": found for one, found in some.items()}
    figures["told_all"] = checked.drawn(diffusion, decoder, guidance, every=True)
    print(f"drawn: {figures['told_some']}, told everything: {figures['told_all']}", flush=True)
    networks = {"encoder": coder.encoder, "decoder": coder.decoder, "denoiser": diffusion.denoiser}
    card: dict[str, Any] = {
        "model": "LatentDiffusion",
        "parameters": {k: sum(p.numel() for p in net.parameters()) for k, net in networks.items()},
        "config": {
            "latents": [network.LATENTS, network.WIDE],
            "levels": network.LEVELS,
            "auto_encoder": asdict(stages[0])
            | {"width": first.WIDTH, "hidden": first.HIDDEN}
            | {"encoder_blocks": first.ENCODER_BLOCKS, "decoder_blocks": first.DECODER_BLOCKS},
            "denoiser": asdict(stages[1])
            | {"width": second.WIDTH, "blocks": second.BLOCKS, "dropout": second.DROPOUT},
            "sampler": {"steps": STEPS, "guidance": guidance},
            "seed": options.seed,
        },
        "data": {
            "patterns": len(bank),
            "pictures": len(read),
            "files": {path.name: sha256(path) for path in files},
        },
        "trained": {
            stage.name: {"steps": stage.step, "minutes": round(stage.seconds / 60, 1)}
            for stage in (coding, drawing)
        },
        "validation": figures,
        "command": " ".join(["python", "scripts/train_latent_diffusion_torch.py", *map(shown, sys.argv[1:])]),
    }
    export(diffusion.denoiser, decoder, card, options.out)
    write_text(options.out.with_suffix(".json"), json.dumps(card, indent=1) + "\n", overwrite=True)
    print(f"{options.out}: {options.out.stat().st_size / 1e6:.1f} MB")


class Checked:
    """Validation patterns, and how much of them comes back."""

    def __init__(self, path: Path, cache: Path | None) -> None:
        self.bank = bank_of(path, cache)
        self.patterns = [pattern_of(self.bank.tensor(k)) for k in range(len(self.bank))]
        truths = {row.id: row.truth for row in measured(path, set(), cache)}
        self.known = [k for k, id in enumerate(self.bank.ids) if str(id) in truths]
        told, every = Told([truths[str(self.bank.ids[k])] for k in self.known]), torch.arange(len(self.known))
        self.all = told.all_of(every).numpy()
        self.some = told.by_chance(every, torch.Generator().manual_seed(0)).numpy()

    def coded(self, coder: first.AutoEncoder, panels: first.Panels) -> dict[str, Any]:
        """Of each pattern itself, through encoder and decoder."""
        latents = coder.latents(first.Panels.of(self.bank, panels.middle))
        return first.figures_of(coder.whole_decoder(panels), latents, self.patterns)

    @torch.no_grad()
    def drawn(
        self,
        diffusion: second.LatentDiffusion,
        decoder: network.WholeDecoder,
        guidance: float,
        *,
        every: bool,
    ) -> dict[str, Any]:
        """Of patterns drawn for all that is true of them, or some of it, with mistakes."""

        def velocity(*given: np.ndarray) -> np.ndarray:
            return diffusion.denoiser(*map(torch.from_numpy, given)).numpy()

        shape = network.LATENTS, network.WIDE
        latents = [
            drawn_latents(velocity, told, shape, seed=k, guidance=guidance)
            for k, told in enumerate(self.all if every else self.some)
        ]
        truths = [self.patterns[k] for k in self.known]
        return first.figures_of(decoder, torch.from_numpy(np.stack(latents)).float(), truths)


if __name__ == "__main__":
    main()
