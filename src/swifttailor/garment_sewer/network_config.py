"""The shape of the network; no torch is needed to read or write it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from swifttailor.errors import InputError


@dataclass(frozen=True)
class NetworkConfig:
    """A DPT (Ranftl et al. 2021): a vision transformer and a convolutional decoder over four of its layers.

    With `convolutions`, a DPT-Hybrid; from `decoder_sizes` on, only `output` says anything about it. The
    small model is `SMALL_NETWORK`, DPT-Large `PAPER_NETWORK`.
    """

    resolution: int = 128
    """Pixels along each side that it is trained at; any size that `patch_size` divides can be given."""
    patch_size: int = 8
    hidden_size: int = 256
    layers: int = 8
    heads: int = 4
    convolutions: tuple[int, ...] = ()
    """Channels of the convolutions before the transformer, finest first, each at half the resolution of the
    one before: 2 to the power of their number is `patch_size`. Empty for DPT itself."""
    decoder_sizes: tuple[int, int, int, int] = (64, 64, 128, 128)
    """Channels of the decoder's four inputs, finest first."""
    fusion_size: int = 64
    """Channels of the decoder."""
    readout: Literal["ignore", "add", "project"] = "ignore"
    """What becomes of the class token."""
    output: Literal["displacement", "absolute"] = "displacement"
    """From the prior, or from a point on the body's axis."""
    input_skip: int = 16
    """Channels in which the input reaches the last, full-resolution stage directly; 0 for none, as in DPT."""
    masked: bool = True
    """Whether the stages at full resolution look at pixels of panels only, and not across the empty pixels
    between them."""
    normalized: bool = True
    """Whether what the decoder reads and adds up is normalised over the batch, as in DPT for segmentation,
    and its features over the channels before the last stage, whose activations are GELU then instead of ReLU.
    From random weights a DPT without it learns next to nothing from its transformer."""
    pretrained: str = ""
    """Folder or name of a DPT or ViT whose weights to begin with; empty to begin with random ones."""

    def __post_init__(self) -> None:
        for name in ("resolution", "patch_size", "hidden_size", "layers", "heads", "fusion_size"):
            value = getattr(self, name)
            if not isinstance(value, int) or isinstance(value, bool) or value < 1:
                raise InputError(f"network.{name} is {value!r}; a whole number of at least 1 is accepted.")
        if self.patch_size not in (8, 16, 32):
            raise InputError(f"network.patch_size is {self.patch_size}; 8, 16 or 32 is accepted.")
        if not all(isinstance(w, int) and w >= 1 for w in self.convolutions):
            raise InputError(
                f"network.convolutions are {list(self.convolutions)}; whole numbers of at least 1 are "
                "accepted."
            )
        if self.convolutions and 2 ** len(self.convolutions) != self.patch_size:
            raise InputError(
                f"network.convolutions are {len(self.convolutions)} and network.patch_size is "
                f"{self.patch_size}; 2 to the power of their number is accepted."
            )
        if self.convolutions and self.pretrained:
            raise InputError("network.pretrained is of a DPT; set network.convolutions=[] for that.")
        if self.resolution % self.patch_size:
            raise InputError(
                f"network.resolution is {self.resolution}; a multiple of patch_size is accepted."
            )
        if self.hidden_size % self.heads:
            raise InputError(
                f"network.hidden_size is {self.hidden_size}; a multiple of heads {self.heads} is accepted."
            )
        if self.layers < 4 and not self.convolutions:
            raise InputError(f"network.layers is {self.layers}; at least 4 are needed, one for each input.")
        if len(self.decoder_sizes) != 4 or self.fusion_size % 2:
            raise InputError("network.decoder_sizes are four numbers, and network.fusion_size is even.")
        if self.input_skip < 0:
            raise InputError(f"network.input_skip is {self.input_skip}; 0 or more is accepted.")
        if self.output not in ("displacement", "absolute"):
            raise InputError(f"network.output is {self.output!r}; displacement or absolute is accepted.")
        if self.readout not in ("ignore", "add", "project"):
            raise InputError(f"network.readout is {self.readout!r}; ignore, add or project is accepted.")


SMALL_NETWORK = NetworkConfig(patch_size=16, layers=4, convolutions=(32, 48, 96, 160))
"""The default: 6.8 million parameters."""
SMALL_DPT = NetworkConfig()
"""Without convolutions: 8.2 million parameters, and about twice the time for an image."""
PAPER_NETWORK = NetworkConfig(
    resolution=256,
    patch_size=16,
    hidden_size=1024,
    layers=24,
    heads=16,
    decoder_sizes=(256, 512, 1024, 1024),
    fusion_size=256,
    readout="project",
    output="absolute",
    input_skip=0,
    masked=False,
    normalized=False,
)
"""DPT-Large, as the paper has it; its resolution is not given there."""
