"""The numbers by which bare arms and legs of people in photographs are told (`picture_reader/bare_limbs.py`).

``python scripts/fit_bare_limbs.py FOLDER... --people FOLDER``

FOLDER has a list of what people wear (docs/picture-reader.md); of those before a plain ground what is learnt
from counts, of `--people` all photographs. Prints logistic regressions, and with how many photographs each
was fitted; `--folds` also how well those of `--people` are told by regressions that have not seen them.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy.optimize import minimize

from swifttailor.arrays import Array
from swifttailor.cli.item_progress import ItemProgress
from swifttailor.data.pictures.photograph_lists import SPLITS, Photograph
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.picture_reader.bare_limbs import BareLimbs, limb_signs
from swifttailor.picture_reader.bare_skin import BareSkin
from swifttailor.picture_reader.reader import PictureReader
from swifttailor.picture_reader.told_by_limbs import below_signs

SHORT_LEGS = {"very short", "mid-thigh", "thigh", "knee", "calf"}
LONG_SKIRTS = {"calf", "midi", "maxi", "floor"}
RIDGE = 1.0
"""Of the regressions' weights, but for the summand."""
Sample = tuple[Array, bool, bool]
"""Signs, whether it is so, and whether it is one of `--people`."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folders", type=Path, nargs="+")
    parser.add_argument("--people", type=Path, required=True)
    parser.add_argument("--folds", type=int, default=8)
    options = parser.parse_args()
    learnt = Photographs(options.folders, SPLITS[0]).photographs
    people = tuple(one for split in SPLITS for one in Photographs([options.people], split).photographs)
    reader = PictureReader.load()
    samples: dict[str, list[Sample]] = {}
    with ItemProgress(len(learnt) + len(people), "photographs looked at") as progress:
        for one in (*learnt, *people):
            is_one = one in people
            for name, signs, bare in looked_at(reader, one, below=is_one):
                samples.setdefault(name, []).append((signs, bare, is_one))
            progress.add(1)
    for name, some in samples.items():
        # Whether anything is worn below is known of streets alone; limbs are bare more often in shops.
        signs = np.array([one[0] for one in some])
        bare, own = (np.array([one[k] for one in some]) for k in (1, 2))
        weights = fitted(signs, bare)
        if name != "below":
            weights[-1] -= np.log(bare.mean() / (1 - bare.mean()))
        said = ", ".join(f"{weight:.3f}" for weight in weights)
        told = cross_validated(signs, bare, own, options.folds)
        sys.stdout.write(f"{name}: ({said}), n = {len(bare)}, of people {own.sum()}, {told}\n")


def looked_at(reader: PictureReader, photograph: Photograph, *, below: bool) -> list[tuple[str, Array, bool]]:
    """Of what is known of a photograph: its name, the signs of it, and whether it is so."""
    pixels = photograph.pixels()
    person = reader.people().find(pixels) if reader.people else None
    if person is None:
        return []
    found = []
    skin = BareSkin.of(pixels, person.mask > 0.5, person.joints)
    signs = limb_signs(skin) if skin else {}
    for name, sign in signs.items():
        bare = TRUTHS[name](photograph)
        if sign is not None and bare is not None:
            found.append((name, sign, bare))
    if below and photograph.told[1] and reader.shop is not None:
        cut = person.cut_out(pixels)
        legs = person.legs(cut[0])
        near = reader.shop().answers_at_frames(legs) if legs else None
        limbs = BareLimbs.of(pixels, person.mask > 0.5, person.joints)
        answers = reader.shop().answers_at_frames((cut,))
        found.append(("below", below_signs(answers, near, limbs), photograph.kinds[1] is not None))
    return found


def _words(photograph: Photograph, claim: str, part: int = 0) -> set[str]:
    kind = photograph.kinds[part]
    return set() if kind is None else {*kind.are.get(claim, ()), *kind.may_be.get(claim, ())}


def _forearms(photograph: Photograph) -> bool | None:
    words = _words(photograph, "sleeves")
    if not words or words & {"long", "three-quarter"}:
        return False if words == {"long"} else None
    return True


def _upper_arms(photograph: Photograph) -> bool | None:
    words, bare = _words(photograph, "sleeves"), {"none", "cap"}
    if not words or (words & bare and not words <= bare):
        return None
    return words <= bare


def _shins(photograph: Photograph) -> bool | None:
    for part in (0, 1):
        kinds = _words(photograph, "kind", part)
        hems = _words(photograph, "skirt_hem", part) | _words(photograph, "leg_hem", part)
        if kinds == {"trousers"} and not hems & SHORT_LEGS:
            return False
        if kinds and kinds <= {"shorts", "skirt", "dress"} and not hems & LONG_SKIRTS:
            return True
    return None


TRUTHS: dict[str, Callable[[Photograph], bool | None]] = {
    "forearms": _forearms,
    "upper_arms": _upper_arms,
    "shins": _shins,
}


def fitted(signs: Array, so: Array) -> Array:
    """Weights (n + 1,) of a logistic regression, its summand last."""
    extended = np.column_stack([signs, np.ones(len(signs))])

    def loss(weights: Array) -> float:
        unlikely = np.logaddexp(0, -(2 * so - 1) * (extended @ weights)).sum()
        return float(unlikely + RIDGE / 2 * (weights[:-1] ** 2).sum())

    return np.asarray(minimize(loss, np.zeros(extended.shape[1])).x)


def cross_validated(signs: Array, so: Array, own: Array, folds: int) -> str:
    """How well people are told apart by regressions that have not seen them."""
    fold = np.random.default_rng(0).integers(0, folds, len(so))
    logits = np.zeros(len(so))
    for k in range(folds):
        held = fold == k
        logits[held] = np.column_stack([signs[held], np.ones(held.sum())]) @ fitted(signs[~held], so[~held])
    yes, no = logits[own & so], logits[own & ~so]
    above = (yes[:, None] > no[None]).mean()
    return f"AUC of people {above:.3f}, right {((logits > 0) == so)[own].mean():.3f}"


if __name__ == "__main__":
    main()
