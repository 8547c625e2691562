"""The fabrics that are known by name: what each is, its constants, and where they come from.

Wang, O'Brien and Ramamoorthi measured ten cloths ("Data-driven elastic models for cloth: modeling and
measurement", SIGGRAPH 2011): weight, stretching at six directions and loads, bending at three directions and
five curvatures. The weight here is theirs. Stretch is the mean of their stiffnesses along both axes over the
six tests, N/m. Their bending stiffness k is that of one hinge between two triangles, k l^2 / (4 a) for an
edge of length l and triangles of area a together; a sheet bent into a cylinder then has the rigidity k / 4
for each unit of width, and the mean over the fifteen tests of that is the bending here. It agrees with the
Kawabata system: their denim comes to 18 uN m, and six denims of another study (Journal of Textiles 2016,
4614168, table 5) to 14 to 22 uN m.

Friction on the body and the distance between layers are estimated throughout.
"""

from __future__ import annotations

from swifttailor.draping.fabric import Fabric
from swifttailor.errors import InputError

_WANG = "Wang et al. 2011, '{}'"
_STIFF = "Wang et al. 2011, '{}'; stretch lowered to what the solver resolves"
_CHOSEN = "estimated"

FABRICS: dict[str, Fabric] = {
    f.name: f
    for f in (
        Fabric(
            "cotton",
            density=0.15,
            stretch=1000.0,
            bending=1e-5,
            kind="plain-woven shirt cotton, poplin",
            source=_CHOSEN,
        ),
        Fabric(
            "linen", density=0.19, stretch=1500.0, bending=2.5e-5, kind="plain-woven linen", source=_CHOSEN
        ),
        Fabric(
            "twill",
            density=0.220,
            stretch=2000.0,
            bending=4.3e-5,
            friction=0.55,
            kind="trouser twill, 65 % cotton, 35 % polyester",
            source=_STIFF.format("royal target"),
        ),
        Fabric(
            "denim",
            density=0.324,
            stretch=640.0,
            bending=1.8e-5,
            friction=0.6,
            thickness=0.35,
            kind="jeans denim of 11 oz, 99 % cotton, 1 % spandex",
            source=_WANG.format("11oz black denim"),
        ),
        Fabric(
            "silk",
            density=0.08,
            stretch=800.0,
            bending=3e-6,
            friction=0.3,
            thickness=0.25,
            kind="silk satin, charmeuse",
            source=_CHOSEN,
        ),
        Fabric(
            "chiffon",
            density=0.05,
            stretch=400.0,
            bending=1e-6,
            friction=0.35,
            thickness=0.25,
            kind="silk or polyester chiffon",
            source=_CHOSEN,
        ),
        Fabric(
            "wool",
            density=0.25,
            stretch=900.0,
            bending=1.2e-5,
            friction=0.6,
            thickness=0.35,
            kind="worsted suiting",
            source=_CHOSEN,
        ),
        Fabric(
            "leather",
            density=0.45,
            stretch=2000.0,
            bending=1e-4,
            friction=0.6,
            thickness=0.4,
            kind="garment leather of 0.7 mm, and what is like it",
            source=_CHOSEN,
        ),
        Fabric(
            "polyester",
            density=0.113,
            stretch=205.0,
            bending=4.7e-6,
            friction=0.4,
            thickness=0.25,
            kind="light jacket cloth, 100 % polyester",
            source=_WANG.format("tango red jet set"),
        ),
        Fabric(
            "jersey",
            density=0.187,
            stretch=185.0,
            bending=5.4e-6,
            friction=0.6,
            kind="T-shirt interlock, 60 % cotton, 40 % polyester",
            source=_WANG.format("gray interlock"),
        ),
        Fabric(
            "rib-knit",
            density=0.276,
            stretch=110.0,
            bending=1.2e-5,
            friction=0.6,
            kind="rib knit, 95 % cotton, 5 % spandex",
            source=_WANG.format("ivory rib knit"),
        ),
        Fabric(
            "sweatshirt",
            density=0.224,
            stretch=125.0,
            bending=8.1e-6,
            friction=0.6,
            thickness=0.35,
            kind="sweater knit, 96 % polyester, 4 % spandex",
            source=_WANG.format("navy sparkle sweat"),
        ),
        Fabric(
            "ponte",
            density=0.284,
            stretch=130.0,
            bending=8.3e-6,
            friction=0.6,
            thickness=0.35,
            kind="ponte Roma, 60 % polyester, 40 % rayon",
            source=_WANG.format("camel ponte roma"),
        ),
        Fabric(
            "fleece",
            density=0.228,
            stretch=210.0,
            bending=3.0e-5,
            friction=0.6,
            thickness=0.4,
            kind="blanket fleece, 100 % polyester",
            source=_WANG.format("pink ribbon brown"),
        ),
        Fabric(
            "swimwear",
            density=0.204,
            stretch=82.0,
            bending=1.3e-5,
            friction=0.5,
            kind="swimsuit knit, 87 % nylon, 13 % spandex",
            source=_WANG.format("white swim solid"),
        ),
    )
}
"""The presets by name: woven cloth first, then knitted."""


def get_fabric(fabric: Fabric | str) -> Fabric:
    """A preset by name; a fabric is itself.

    Raises:
        InputError: There is no such preset.
    """
    if not isinstance(fabric, str):
        return fabric
    if fabric not in FABRICS:
        raise InputError(
            f"There is no fabric '{fabric}'. Known fabrics: {', '.join(FABRICS)}. "
            "'swifttailor fabrics' shows what they are."
        )
    return FABRICS[fabric]
