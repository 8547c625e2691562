"""How a picture reader is trained: everything that decides what comes out, in one JSON file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

from swifttailor.picture_reader.close_ups import ALL_PARTS
from swifttailor.training.config_file import read_config_of, require
from swifttailor.training.loop_config import LoopConfig

if TYPE_CHECKING:
    from swifttailor.data.pictures.blocks import Family

_STRIDE, _STAGES = 32, 4
_ROUNDED = 1e-6


@dataclass(frozen=True)
class EyesSize:
    """The size of the network: see `picture_reader.network_torch.EyesConfig`."""

    image_size: int = 192
    embedding: int = 32
    stages: tuple[int, ...] = (32, 64, 160, 320)
    depths: tuple[int, ...] = (2, 2, 2, 2)
    width: int = 192
    heads: int = 6
    mask_width: int = 24
    trunk: Literal["resnet", "efficientnet-lite0", "efficientnet-lite2"] = "resnet"
    design_values: tuple[int, ...] = ()
    """Follows from the designs that are given (--designs)."""

    def __post_init__(self) -> None:
        sized = self.image_size >= _STRIDE and self.image_size % _STRIDE == 0
        require(self, "image_size", sized, f"a multiple of {_STRIDE}")
        require(self, "stages", len(self.stages) == 4 and min(self.stages) >= 1, "four numbers of channels")
        require(self, "depths", len(self.depths) == 4 and min(self.depths) >= 1, "four numbers of blocks")
        for name in ("embedding", "width", "heads", "mask_width"):
            require(self, name, getattr(self, name) >= 1, "at least 1")
        require(self, "width", self.width % self.heads == 0, f"a multiple of heads ({self.heads})")


@dataclass(frozen=True)
class LossWeights:
    """What each loss counts."""

    figures: float = 1.0
    present: float = 1.0
    statements: float = 1.0
    measures: float = 0.5
    panels: float = 1.0
    boxes: float = 0.5
    view: float = 0.3
    masks: float = 3.0
    places: float = 4.0
    kinds: float = 4.0
    seams: float = 2.0
    designs: float = 0.5
    details: float = 1.0
    """How many times as much what close-ups tell of counts, in every picture."""


@dataclass(frozen=True)
class PictureConfig(LoopConfig):
    """Network, pictures, and how the network is optimised."""

    network: EyesSize = field(default_factory=EyesSize)
    losses: LossWeights = field(default_factory=LossWeights)

    steps: int = 100_000
    batch_size: int = 64
    learning_rate: float = 2e-3
    final_rate: float = 0.01
    weight_decay: float = 0.05
    optimizer: Literal["adamw", "muon"] = "adamw"
    ema: float = 0.998
    block: int = 256
    """Pictures that are drawn together; batches are drawn from one block."""
    echo: int = 2
    """How often a picture that was drawn is shown, each time cut, turned and lit otherwise."""
    pool: int = 0
    """Pictures that are kept, and that batches are drawn from, instead of from one block: where there is much
    memory. 0 keeps none. A training that is resumed begins with an empty one."""
    plain: float = 0.15
    """Share of pictures that look like those of GarmentCodeData."""
    studio: float = 0.25
    """Share of pictures of one garment in a studio; the others show people."""
    nothing: float = 0.03
    """Share of pictures without any garment: places, plain colours, drawings."""
    several: float = 0.04
    """Share of pictures of several people."""
    unlike: float = 0.0
    """Share of pictures that are not plain and of which is learnt that they show nobody: for a reader that is
    asked of plain ones alone, and says which are."""
    laid: float = 0.0
    """Share of pictures of garments that nobody wears, laid or hung."""
    photograph: float = 0.0
    """Share of photographs of clothes of which some claims are known (--photographs)."""
    cut_out: float = 0.0
    """Share of people, drawn ones and photographs on white, that are shown as if cut out of a picture."""
    worn: float = 0.0
    """Share of pictures of people and of bodies of which is learnt that they show nothing: for a reader that
    is asked of laid garments alone, and says which are."""
    close: float = 0.3
    """Share of close-ups among the pictures of one person."""
    parts: tuple[str, ...] = ALL_PARTS
    """Of close-ups, see `CloseUp.part`."""
    near: float = 0.65
    """Share of the other plain pictures that the garment fills, as the second look at one does."""
    variation: float = 1.0
    """Strength of the cutting, turning and lighting."""
    unguessed: float = 0.35
    """Share of pictures of which the network is not told where the wearer is, as at a first look."""
    frozen_stages: int = 0
    """How many of the trunk's four stages stay as `start` has them, the first ones. With all only what looks
    at their map learns: four times as many pictures in the same time of a processor."""
    training_garments: int = 0
    """How many of the garments to learn from, spread evenly over them; 0 takes all."""
    validation_garments: int = 150

    def __post_init__(self) -> None:
        super().__post_init__()
        require(self, "echo", self.echo >= 1, "at least 1")
        require(self, "pool", self.pool >= 0 and self.pool % self.block == 0, f"a multiple of {self.block}")
        fits = self.pool > 0 or self.block % self.batch_size == 0
        require(self, "block", fits, f"a multiple of {self.batch_size}")
        for name, share in self.shares.items():
            require(self, name, 0 <= share <= 1, "0 to 1")
        total = sum(self.shares.values())
        require(
            self,
            "studio",
            total <= 1 + _ROUNDED,
            f"such that {', '.join(self.shares)} are at most 1 together",
        )
        require(self, "close", 0 <= self.close <= 1, "0 to 1")
        require(self, "cut_out", 0 <= self.cut_out <= 1, "0 to 1")
        accepted = f"some of {', '.join(ALL_PARTS)}"
        require(self, "parts", bool(self.parts) and set(self.parts) <= set(ALL_PARTS), accepted)
        require(self, "near", 0 <= self.near <= 1, "0 to 1")
        require(self, "unguessed", 0 <= self.unguessed <= 1, "0 to 1")
        require(self, "variation", self.variation >= 0, "0 or more")
        require(self, "training_garments", self.training_garments >= 0, "0 or more")
        require(self, "validation_garments", self.validation_garments >= 1, "at least 1")
        require(self, "compiled", not self.compiled, "false")
        begun = self.frozen_stages == 0 or (bool(self.start) and 0 < self.frozen_stages <= _STAGES)
        require(self, "frozen_stages", begun, "0, or 1 to 4 with weights to start with (start=FILE)")

    @property
    def shares(self) -> dict[Family, float]:
        """Of each look that is no person's among the pictures."""
        return {
            "plain": self.plain,
            "studio": self.studio,
            "nothing": self.nothing,
            "several": self.several,
            "unlike": self.unlike,
            "laid": self.laid,
            "photograph": self.photograph,
            "worn": self.worn,
        }

    @property
    def only_laid(self) -> bool:
        """Whether all that it learns to read nobody wears."""
        return self.laid > 0 and not self.plain + self.studio and sum(self.shares.values()) > 1 - _ROUNDED

    @property
    def only_plain(self) -> bool:
        """Whether all that it learns to read is plain."""
        return not self.studio + self.laid and sum(self.shares.values()) > 1 - _ROUNDED


CONFIGS: dict[str, PictureConfig] = {"small": PictureConfig()}


def read_config(name: str, overrides: Sequence[str] = ()) -> PictureConfig:
    """One of these, or one from a JSON file that says what differs from ``small``: see `read_config_of`."""
    return read_config_of(CONFIGS, name, overrides)
