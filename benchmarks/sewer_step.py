"""How many garments a second the GarmentSewer's network is trained on: forward and backward pass.

``python benchmarks/sewer_step.py [--networks NAME ...] [--batch 8] [--repeats 9] [--threads 1]``

The networks are variants of ``small``, named below; ``--set FIELD=VALUE ...`` measures one more. Input and
target are random numbers, the loss is the mean absolute error: drawing the data, the other losses and the
optimiser are not counted. Processor time, which is wall time on one thread; the median of the repeats after
one that is not counted, in bfloat16 and in float32 (``--precision``). Needs the extra `train`.
"""

from __future__ import annotations

import argparse
import time

import numpy as np

from machine import describe
from swifttailor.training.sewer_config import SewerConfig, read_config

_DPT = ("network.convolutions=[]", "network.patch_size=8", "network.layers=8")
_LARGE = ("network.resolution=256",)
NETWORKS: dict[str, tuple[str, ...]] = {
    "small": (),
    "small-256": _LARGE,
    "dpt": _DPT,
    "dpt-no-skip": (*_DPT, "network.input_skip=0"),
    "dpt-256": (*_DPT, *_LARGE, "network.patch_size=16"),
}
"""By name, what is changed in the configuration ``small``."""


def main() -> None:
    import torch

    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--networks", nargs="*", default=list(NETWORKS), choices=list(NETWORKS))
    parser.add_argument("--set", nargs="+", default=[], metavar="FIELD=VALUE")
    parser.add_argument("--batch", type=int, default=8)
    parser.add_argument("--repeats", type=int, default=9)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--precision", nargs="+", default=["bfloat16", "float32"])
    options = parser.parse_args()
    torch.set_num_threads(options.threads)
    print(describe())
    fast = "with" if torch.ops.mkldnn._is_mkldnn_bf16_supported() else "without"
    print(
        f"torch {torch.__version__}, {options.threads} thread(s), {fast} instructions for bfloat16; batch of "
        f"{options.batch}, median of {options.repeats}"
    )
    chosen = {name: NETWORKS[name] for name in options.networks}
    if options.set:
        chosen[" ".join(options.set)] = tuple(options.set)
    for name, overrides in chosen.items():
        config = read_config("small", overrides)
        count, rates = 0, []
        for precision in options.precision:
            count, seconds = measure(config, precision, options.batch, options.repeats)
            rates.append(f"{precision} {options.batch / seconds:6.2f} garments/s")
        size = f"{config.network.resolution} px, {count / 1e6:.1f} M parameters"
        print(f"{name:<22} {size:<26} {', '.join(rates)}")


def measure(config: SewerConfig, precision: str, batch: int, repeats: int) -> tuple[int, float]:
    """Parameters, and seconds of processor time for a forward and a backward pass of a batch."""
    import torch

    from swifttailor.garment_sewer.network_torch import build_network

    torch.manual_seed(0)
    size = config.network.resolution
    network = build_network(config.network, config.conditioning.count)
    network.set_attn_implementation("eager")  # as in trainings on a CPU
    network = network.to(memory_format=torch.channels_last).train()
    shape = (batch, config.conditioning.count, size, size)
    given = torch.randn(shape).contiguous(memory_format=torch.channels_last)
    occupancy = (torch.rand(batch, 1, size, size) < 0.5).float()
    prior, target = torch.randn(2, batch, 3, size, size).unbind()
    times = []
    for _ in range(repeats + 1):
        started = time.process_time()
        with torch.autocast("cpu", torch.bfloat16, enabled=precision == "bfloat16"):
            predicted = network(given, occupancy, prior)
        (predicted - target).abs().mean().backward()
        times.append(time.process_time() - started)
        network.zero_grad(set_to_none=True)
    count = sum(p.numel() for p in network.parameters())
    return count, float(np.median(times[1:]))


if __name__ == "__main__":
    main()
