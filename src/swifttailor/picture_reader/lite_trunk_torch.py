"""EfficientNet-Lite, the trunk that has seen photographs. It loads torch.

Tan and Le 2019, "EfficientNet"; the lite variants are Google's for small devices: no squeeze-and-excitation,
ReLU6.
"""

from __future__ import annotations

from torch import Tensor, nn
from torch.nn import functional as F

_STEM, _FIRST = 32, 16
_Rows = tuple[tuple[int, int, int, int], ...]
"""Of a stage: rows of channels, side of the kernel, stride of the first block, number of blocks."""
_STAGES: dict[str, tuple[_Rows, _Rows, _Rows, _Rows]] = {
    "efficientnet-lite0": (
        ((24, 3, 2, 2),),
        ((40, 5, 2, 2),),
        ((80, 3, 2, 3), (112, 5, 1, 3)),
        ((192, 5, 2, 4), (320, 3, 1, 1)),
    ),
    "efficientnet-lite2": (
        ((24, 3, 2, 3),),
        ((48, 5, 2, 3),),
        ((88, 3, 2, 4), (120, 5, 1, 4)),
        ((208, 5, 2, 5), (352, 3, 1, 1)),
    ),
}
TRUNKS = tuple(_STAGES)
_WIDER = 6
_EPSILON, _MOMENTUM = 1e-3, 0.01


class LiteTrunk(nn.Module):
    """What begins a network: a stem, then four stages, each on half the resolution of the one before."""

    def __init__(self, name: str, channels: int) -> None:
        """With random weights.

        Args:
            name: One of `TRUNKS`.
            channels: Of the pictures.
        """
        super().__init__()
        self.embedder = nn.Sequential(
            _SameConv(channels, _STEM, 3, 2), _norm(_STEM), nn.ReLU6(), _Block(_STEM, _FIRST, 3, 1, 1)
        )
        stages, given = [], _FIRST
        for rows in _STAGES[name]:
            blocks = []
            for made, kernel, stride, count in rows:
                for k in range(count):
                    blocks.append(_Block(given, made, kernel, stride if k == 0 else 1, _WIDER))
                    given = made
            stages.append(nn.Sequential(*blocks))
        self.stages = nn.ModuleList(stages)
        self.channels = tuple(rows[-1][0] for rows in _STAGES[name])
        """Of what the four stages give, at strides of 4, 8, 16 and 32 pixels."""


class _Block(nn.Module):
    """Widened, seen channel by channel, narrowed, and added to what came in where that has the same shape."""

    def __init__(self, given: int, made: int, kernel: int, stride: int, wider: int) -> None:
        super().__init__()
        middle = given * wider
        widened = [nn.Conv2d(given, middle, 1, bias=False), _norm(middle), nn.ReLU6()] if wider > 1 else []
        self.inner = nn.Sequential(
            *widened,
            _SameConv(middle, middle, kernel, stride, groups=middle),
            _norm(middle),
            nn.ReLU6(),
            nn.Conv2d(middle, made, 1, bias=False),
            _norm(made),
        )
        self.adds = stride == 1 and given == made

    def forward(self, x: Tensor) -> Tensor:
        made: Tensor = self.inner(x)
        return x + made if self.adds else made


class _SameConv(nn.Conv2d):
    """A convolution that pads as TensorFlow does, with which the weights were learnt: less at first."""

    def __init__(self, given: int, made: int, kernel: int, stride: int, groups: int = 1) -> None:
        total = kernel - stride
        even = total % 2 == 0
        super().__init__(
            given, made, kernel, stride, padding=total // 2 if even else 0, groups=groups, bias=False
        )
        self.around = None if even else (total // 2, total - total // 2) * 2

    def forward(self, input: Tensor) -> Tensor:
        """(B, given, H, W), H and W multiples of the stride."""
        return super().forward(input if self.around is None else F.pad(input, self.around))


def _norm(channels: int) -> nn.BatchNorm2d:
    return nn.BatchNorm2d(channels, eps=_EPSILON, momentum=_MOMENTUM)
