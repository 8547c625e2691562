"""A look like the pictures that come with GarmentCodeData: the same camera, a dark body, panels in tones.

Its camera opens 30 degrees, stands 4.15 m before the middle of the body at a height of 0.97 m, and is then
turned about the origin: 15 degrees up and 20 to the wearer's left, and half around for the back.
"""

from __future__ import annotations

import numpy as np

from swifttailor.looks.look import Backdrop, Look, Rgb, View
from swifttailor.render import Camera, Light, Lighting, Plain, to_linear

AZIMUTH, ELEVATION, FIELD_OF_VIEW = 20.0, 15.0, 30.0
EYE_HEIGHT_CM, DISTANCE_CM = 97.0, 415.0
_BODY = "#151517"
_TONES = (
    "#e9e4ea",
    "#cdd6dc",
    "#a3b7cb",
    "#8791bf",
    "#8068ad",
    "#74478c",
    "#6e3a68",
    "#8a4c66",
    "#b5767a",
    "#cfa79c",
)
_LIGHTS = Lighting(
    key=Light((-0.35, 0.45, 0.80), (0.85, 0.85, 0.85), wrap=0.25),
    fill=Light((0.75, 0.40, 0.45), (0.40, 0.40, 0.40), wrap=0.3),
    rim=Light((0.30, 0.50, -0.80), (0.15, 0.15, 0.15)),
    sky=(0.22, 0.22, 0.22),
    ground=(0.12, 0.12, 0.12),
)


def plain_look(view: str = "front") -> Look:
    """The look of a GarmentCodeData picture.

    Args:
        view: ``front`` or ``back``.
    """
    tones = tuple(_tone(t) for t in _TONES)
    return Look(
        print=Plain(tones[0], 0.0),
        inside=(0.45, 0.43, 0.45),
        view=View(camera=plain_camera(view)),
        body=_tone(_BODY),
        backdrop=Backdrop(),
        lighting=_LIGHTS,
        seams=0.5,
        shadows=False,
        panel_colors=tones,
    )


def plain_camera(view: str = "front") -> Camera:
    """The camera of a GarmentCodeData picture, ``front`` or ``back``."""
    azimuth = AZIMUTH + (180.0 if view == "back" else 0.0)
    tilt, turn = np.deg2rad(ELEVATION), np.deg2rad(azimuth)
    # The point that it looks at was turned about the origin, too.
    back = -EYE_HEIGHT_CM * np.sin(tilt)
    target = float(back * np.sin(turn)), float(EYE_HEIGHT_CM * np.cos(tilt)), float(back * np.cos(turn))
    height = 2 * DISTANCE_CM * float(np.tan(np.deg2rad(FIELD_OF_VIEW) / 2))
    return Camera(target, height, azimuth, ELEVATION, FIELD_OF_VIEW)


def _tone(color: str) -> Rgb:
    r, g, b = (float(v) for v in to_linear(color))
    return r, g, b
