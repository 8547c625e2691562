"""What a network that has learnt nothing but photographs tells of clothes that nobody wears.

The trunk is that of `worn_heads`; what is asked of it are a few sums, learnt from photographs that people
took of their own clothes (`scripts/train_laid_heads_torch.py`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from swifttailor.arrays import Pixels
from swifttailor.errors import InputError
from swifttailor.networks.model_file import GRAPH, ModelKind, open_model
from swifttailor.picture_reader.labels import PARTS, statement_labels
from swifttailor.picture_reader.person_halves import LOWER, UPPER, Answers
from swifttailor.picture_reader.reweighing import reweighed
from swifttailor.picture_reader.squares import scaled
from swifttailor.picture_reader.view import Square
from swifttailor.picture_reader.worn_heads import COLLARED, features_of

SHIPPED = Path(__file__).with_name("laid_heads.onnx")
VIEWS: Mapping[str, float] = MappingProxyType({"whole": 1.0, "inner": 0.8})
"""Sides of the squares that are looked at, in that around all of a picture."""
PART = "part"
"""Which part of the body it is for: a word of `PARTS`."""
NAME = "name"
"""What such clothes are called by those who sort photographs: "Shirt"."""
LEAST_NAMED = 0.6
"""What is less surely called so is called nothing."""
ASKED: Mapping[str, tuple[int, str] | None] = MappingProxyType(
    {
        PART: None,
        NAME: None,
        "upper_kind": (UPPER, "kind"),
        "lower_kind": (LOWER, "kind"),
        "sleeves": (UPPER, "sleeves"),
        "collar": (UPPER, "collar"),
        "leg_hem": (LOWER, "leg_hem"),
    }
)
"""What is told, and of which part of the body which claim it is; of collars, whether there is one."""
SHARES: Mapping[str, float] = MappingProxyType(
    {PART: 2.0, "upper_kind": 1.0, "lower_kind": 2.0, "sleeves": 2.0, "collar": 2.0, "leg_hem": 1.0}
)
"""How much counts what is told, beside the network that has learnt from drawings, too; chosen by photographs
that validate."""
FARTHEST = 3.0
"""Most that a logit of what is worn on a part of the body is moved: a set of two garments stays one."""
KIND = ModelKind(
    "network for photographs of clothes",
    "swifttailor laid heads 1",
    1 << 20,
    ({GRAPH: (tuple(VIEWS), tuple(ASKED))},),
)
Told = Mapping[str, Mapping[str, float]]
"""Of what is asked, the logarithm of the share of each word."""


@dataclass(frozen=True, eq=False)
class LaidHeads:
    """Tells a few claims of clothes in a photograph that nobody wears."""

    trunk: Any
    """Of onnxruntime: that of `worn_heads.WornHeads`."""
    session: Any
    """Of onnxruntime."""
    words: Mapping[str, tuple[str, ...]]
    """Of what is asked, in the order of what is told."""

    @staticmethod
    def load(trunk: Any, weights: Path | str | None = None, *, threads: int = 1) -> LaidHeads:
        """Opens a model file.

        Args:
            trunk: Of onnxruntime.
            weights: File; the one that comes with the package when None.
            threads: CPU cores for the sums.

        Raises:
            InputError: There is no such file, or it is damaged or another.
        """
        model = open_model(SHIPPED if weights is None else weights, KIND, threads=threads)
        with model.says("the words of its claims"):
            words = {name: tuple(map(str, model.about["card"]["words"][name])) for name in ASKED}
            if words[PART] != PARTS or any(len(set(some)) < max(len(some), 2) for some in words.values()):
                raise InputError(f"its words are {words}")
        model.require(
            {
                f"what it says of {name}": (model.shape_made(GRAPH, name), [1, len(some)])
                for name, some in words.items()
            }
        )
        return LaidHeads(trunk, model.sessions[GRAPH], words)

    def told(self, pixels: Pixels, whole: Square) -> Told:
        """What is asked of a picture.

        Args:
            pixels: (h, w, 3) sRGB.
            whole: The square around all of it.
        """
        given = {
            name: features_of(self.trunk, pixels, scaled(whole, side))[None] for name, side in VIEWS.items()
        }
        found = {}
        for name, logits in zip(ASKED, self.session.run(list(ASKED), given), strict=True):
            raised = logits[0].astype(np.float64)
            shares = raised - np.logaddexp.reduce(raised)
            found[name] = dict(zip(self.words[name], shares.tolist(), strict=True))
        return found


def with_told(answers: Answers, told: Told) -> Answers:
    """What is said of clothes, together with what such photographs look like.

    Args:
        answers: Logits by the names of outputs; (parts,) of `present`, (parts, S) of `statements`.
        told: Of the same picture.
    """
    for name, shares in told.items():
        which = ASKED[name]
        if name == NAME:
            continue
        more = {word: SHARES[name] * share for word, share in shares.items()}
        if which is None:
            ways = np.array([more[part] for part in PARTS])
            # Nearer to one part of the body is farther from the other.
            nearer = np.clip(ways - ways.mean(), -FARTHEST, FARTHEST)
            present = answers["present"] + nearer
            answers = answers | {"present": present.astype(np.float32)}
        else:
            part, claim = which
            if claim == "collar":  # of which, the network that reads says more
                words = [word for kind, word in statement_labels() if kind == claim]
                more = {word: more[word if word == "none" else COLLARED] for word in words}
            answers = reweighed(answers, part, claim, more, certain=claim != "leg_hem")
    return answers


def name_told(told: Told) -> str:
    """What clothes are called; nothing where that is not sure."""
    shares = told.get(NAME, {})
    name = max(shares, key=shares.__getitem__, default="")
    return name if name and np.exp(shares[name]) >= LEAST_NAMED else ""
