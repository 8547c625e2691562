"""Looks that leave the studio: cloths as shops have them, rooms and streets, cameras as people have them."""

from __future__ import annotations

import numpy as np

from swifttailor.data.renders.backdrops import random_scenery
from swifttailor.data.renders.camera_effects import random_effects
from swifttailor.data.renders.cloths import WHOLE, Place, random_cloth
from swifttailor.data.renders.foreground import random_before
from swifttailor.data.renders.look import Backdrop, Look, Rgb, random_body, random_lighting, random_view
from swifttailor.render import to_linear

_HIDDEN_SEAMS = 0.65
"""Share of pictures in which no seam is seen."""
_SKINS = ("#f3d7c6", "#e3b594", "#c68f68", "#99663f", "#6a432b", "#432b1f")
"""From light to dark; what lies between is as likely."""
_IN_STUDIO = 0.12
"""Share of pictures before plain white or grey, as shops have them."""


def everyday_look(
    chance: np.random.Generator, view: str, place: Place = WHOLE, *, body: Rgb | None = None
) -> Look:
    """A look drawn by lot.

    Args:
        chance: Where the lots come from; the same state gives the same look.
        view: One of `look.VIEWS`.
        place: Where the garment is on the standing body.
        body: Colour of the skin; drawn, and now and then nobody, when None.
    """
    drawn = random_cloth(chance, place) if body is None else random_cloth(chance, place, behind=body)
    color = np.asarray(drawn.cloth.base.table()[11:14], np.float64)
    skin = _skin(chance, color) if body is None else body
    studio = chance.random() < _IN_STUDIO
    shade = float(chance.choice([1.0, chance.uniform(0.5, 0.95)]))
    return Look(
        print=drawn.cloth,
        inside=drawn.inside,
        view=random_view(chance, view),
        body=skin,
        backdrop=Backdrop((shade, shade, shade), (shade, shade, shade)),
        lighting=random_lighting(chance),
        seams=0.0 if chance.random() < _HIDDEN_SEAMS else float(chance.uniform(0.08, 0.4)),
        gloss=drawn.gloss,
        sheen=drawn.sheen,
        scenery=None if studio else random_scenery(chance),
        before=random_before(chance),
        effects=random_effects(chance),
    )


def _skin(chance: np.random.Generator, cloth: np.ndarray) -> Rgb | None:
    """A skin mostly, else what `look.random_body` draws: a mannequin, or nobody."""
    if chance.random() < 0.25:
        return random_body(chance, cloth)
    at, redder = chance.random() * (len(_SKINS) - 1), chance.normal(0, 0.04)
    k = min(int(at), len(_SKINS) - 2)
    low, high = to_linear(_SKINS[k]), to_linear(_SKINS[k + 1])
    r, g, b = (low + (at - k) * (high - low)) * (1 + redder, 1.0, 1 - redder)
    return float(r), float(g), float(b)
