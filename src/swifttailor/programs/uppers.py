"""Upper garments: straight or fitted to the waist, of two halves that need not be alike."""

from __future__ import annotations

from swifttailor.programs.bodice import BodiceHalf
from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.component import Component
from swifttailor.programs.design import Design
from swifttailor.programs.interface import Interface

_SHARED = ("shirt.length", "collar.fc_depth", "collar.bc_depth")
"""The left half has these of the right one: the halves meet there."""


class Shirt(Component):
    """A straight upper garment. Its interface ``bottom`` goes around the body from the front right."""

    fitted = False

    def __init__(self, body: BodyParameters, design: Design) -> None:
        """Drafts both halves and joins them in front and behind."""
        super().__init__(self.__class__.__name__)
        right = left = design
        if design["left.enable_asym"]:
            # Collars with panels would not meet.
            plain = {"collar.component.style": None}
            right = design.replaced(plain)
            left = design.section("left").replaced({**plain, **{name: design[name] for name in _SHARED}})
        self.right = BodiceHalf("right", body, right, self.fitted)
        self.left = BodiceHalf("left", body, left, self.fitted).mirror()
        one, two = self.right.interfaces, self.left.interfaces
        self.stitching_rules.append((one["front_in"], two["front_in"]))
        self.stitching_rules.append((one["back_in"], two["back_in"]))
        self.interfaces = {
            "bottom": Interface.from_multiple(
                one["f_bottom"].reverse(), two["f_bottom"], two["b_bottom"].reverse(), one["b_bottom"]
            )
        }

    def length(self) -> float:
        """Length of the back, cm."""
        return self.right.length()


class FittedShirt(Shirt):
    """An upper garment with darts, which may be strapless."""

    fitted = True


UPPERS: dict[str, type[Shirt]] = {"Shirt": Shirt, "FittedShirt": FittedShirt}
"""By the names that ``meta.upper`` accepts."""
