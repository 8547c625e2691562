"""The numbers by which bare arms and legs of people in photographs are told (`picture_reader/bare_limbs.py`).

``python scripts/fit_bare_limbs.py FOLDER... [--told FOLDER]``

FOLDER has a list of what people wear (docs/picture-reader.md); of its photographs those are looked at that
networks learn from. Prints logistic regressions, how many photographs each was fitted with, and how well it
tells those of `--told`, which none has seen.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from swifttailor.arrays import Array
from swifttailor.cli.item_progress import ItemProgress
from swifttailor.data.pictures.photograph_lists import SPLITS, Photograph
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.picture_reader.bare_limbs import limb_signs
from swifttailor.picture_reader.bare_skin import BareSkin
from swifttailor.picture_reader.person_finder import PersonFinder

SHORT_LEGS = {"very short", "mid-thigh", "thigh", "knee", "calf"}
LONG_SKIRTS = {"calf", "midi", "maxi", "floor"}
RIDGE = 1.0
"""Of the regressions' weights, but for the summand."""
Sign = tuple[str, Array, bool]
"""The name of what is told, the signs of it, and whether it is so."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folders", type=Path, nargs="+")
    parser.add_argument("--told", type=Path)
    options = parser.parse_args()
    learnt = Photographs(options.folders, SPLITS[0]).photographs
    told: tuple[Photograph, ...] = ()
    if options.told:
        told = tuple(one for split in SPLITS for one in Photographs([options.told], split).photographs)
    finder = PersonFinder.load()
    signs: list[list[Sign]] = [[], []]
    with ItemProgress(len(learnt) + len(told), "photographs looked at") as progress:
        for one in learnt:
            signs[0] += limbs_of(finder, one)
            progress.add(1)
        for one in told:
            signs[1] += limbs_of(finder, one)
            progress.add(1)
    for name in TRUTHS:
        (seen, so), (others, others_so) = (_table(some, name) for some in signs)
        weights = fitted(seen, so)
        said = f"{name}: n = {len(so)}"
        if len(others_so):
            logits = others @ weights[:-1] + weights[-1]
            yes, no = logits[others_so], logits[~others_so]
            right = ((logits > 0) == others_so).mean()
            said += (
                f", told n = {len(others_so)}, AUC {(yes[:, None] > no[None]).mean():.3f}, right {right:.3f}"
            )
        # Only how much likelier than usual: in shops they are bare oftener.
        weights[-1] -= np.log(so.mean() / (1 - so.mean()))
        sys.stdout.write(f"{said}: ({', '.join(f'{weight:.3f}' for weight in weights)})\n")


def limbs_of(finder: PersonFinder, photograph: Photograph) -> list[Sign]:
    """Of what is known of limbs in a photograph that are seen."""
    pixels = photograph.pixels()
    person = finder.find(pixels)
    skin = BareSkin.of(pixels, person.mask > 0.5, person.joints) if person else None
    found = []
    for name, sign in limb_signs(skin).items() if skin else ():
        bare = TRUTHS[name](photograph)
        if sign is not None and bare is not None:
            found.append((name, sign, bare))
    return found


def _table(signs: list[Sign], name: str) -> tuple[Array, NDArray[np.bool_]]:
    some = [one for one in signs if one[0] == name]
    return np.array([one[1] for one in some]), np.array([one[2] for one in some], bool)


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


def fitted(signs: Array, so: NDArray[np.bool_]) -> Array:
    """Weights (n + 1,) of a logistic regression, its summand last."""
    extended = np.column_stack([signs, np.ones(len(signs))])

    def loss(weights: Array) -> float:
        unlikely = np.logaddexp(0, -(2 * so - 1) * (extended @ weights)).sum()
        return float(unlikely + RIDGE / 2 * (weights[:-1] ** 2).sum())

    return np.asarray(minimize(loss, np.zeros(extended.shape[1])).x)


if __name__ == "__main__":
    main()
