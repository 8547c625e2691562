"""Looks that leave the studio: cloths as shops have them, rooms and streets, cameras as people have them."""

from __future__ import annotations

import numpy as np

from swifttailor.data.renders.backdrops import random_before, random_scenery
from swifttailor.data.renders.camera_effects import random_effects
from swifttailor.data.renders.cloths import WHOLE, Place, random_cloth
from swifttailor.data.renders.look import Backdrop, Look, Rgb, random_body, random_lighting, random_view

_HIDDEN_SEAMS = 0.65
"""Share of pictures in which no seam is seen."""
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
    skin = random_body(chance, color) if body is None else body
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
