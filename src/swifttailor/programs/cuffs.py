"""Cuffs of sleeves and trouser legs: a band, a flared and gathered skirt, or the one on the other."""

from __future__ import annotations

from swifttailor.programs.component import Component
from swifttailor.programs.design import Design
from swifttailor.programs.interface import Interface
from swifttailor.programs.panel import Panel
from swifttailor.programs.skirt_panels import SkirtPanel
from swifttailor.programs.stitching import Stitches
from swifttailor.programs.waistbands import StraightBandPanel


class Cuff(Component):
    """Something around the end of a limb; interfaces ``top``, ``top_front``, ``top_back`` and ``bottom``.

    Parameters used: ``cuff.b_width``, the girth at the top, and ``cuff.cuff_len``, both in cm, and for skirts
    ``cuff.skirt_flare``, ``cuff.skirt_ruffle`` and ``cuff.skirt_fraction``.
    """


class _TwoPanelCuff(Cuff):
    """A cuff with a front and a back alike."""

    def _sew(self, front: Panel, back: Panel) -> None:
        self.front = front.translate_by([0.0, 0.0, 15.0])
        self.back = back.translate_by([0.0, 0.0, -15.0])
        one, two = front.interfaces, back.interfaces
        self.stitching_rules = Stitches((one["right"], two["right"]), (one["left"], two["left"]))
        self.interfaces = {
            "top": Interface.from_multiple(one["top"], two["top"]),
            "top_front": one["top"],
            "top_back": two["top"],
            "bottom": Interface.from_multiple(one["bottom"], two["bottom"]),
        }

    def length(self) -> float:
        """Length of one of its panels, cm."""
        return self.front.length()


class CuffBand(_TwoPanelCuff):
    """A straight band."""

    def __init__(self, tag: str, design: Design, length: float | None = None) -> None:
        """Drafts it, of another length in cm than the design says if that is given."""
        super().__init__(f"CuffBand_{tag}")
        length = design["cuff.cuff_len"] if length is None else length
        half = design["cuff.b_width"] / 2
        self._sew(
            StraightBandPanel(f"{tag}_cuff_f", half, length),
            StraightBandPanel(f"{tag}_cuff_b", half, length),
        )


class CuffSkirt(_TwoPanelCuff):
    """A flared cuff, gathered at its top."""

    def __init__(self, tag: str, design: Design, length: float | None = None) -> None:
        """Drafts it, of another length in cm than the design says if that is given."""
        super().__init__(f"CuffSkirt_{tag}")
        length = design["cuff.cuff_len"] if length is None else length
        half, ruffle = design["cuff.b_width"] / 2, design["cuff.skirt_ruffle"]
        flare = (design["cuff.skirt_flare"] - 1) * half
        self._sew(
            SkirtPanel(f"{tag}_cuff_skirt_f", half, length, ruffle, flare=flare),
            SkirtPanel(f"{tag}_cuff_skirt_b", half, length, ruffle, flare=flare),
        )


class CuffBandSkirt(Cuff):
    """A band with a skirt below it."""

    def __init__(self, tag: str, design: Design) -> None:
        """Drafts both; ``cuff.skirt_fraction`` is the part of the length that the skirt takes."""
        super().__init__("CuffBandSkirt")
        length, fraction = design["cuff.cuff_len"], design["cuff.skirt_fraction"]
        self.cuff = CuffBand(tag, design, length * (1 - fraction))
        self.skirt = CuffSkirt(tag, design, length * fraction)
        self.skirt.place_below(self.cuff)
        band, skirt = self.cuff.interfaces, self.skirt.interfaces
        self.stitching_rules = Stitches((band["bottom"], skirt["top"]))
        self.interfaces = {
            "top": band["top"],
            "top_front": band["top_front"],
            "top_back": band["top_back"],
            "bottom": skirt["bottom"],
        }


CUFFS: dict[str, type[CuffBand | CuffSkirt | CuffBandSkirt]] = {
    "CuffBand": CuffBand,
    "CuffSkirt": CuffSkirt,
    "CuffBandSkirt": CuffBandSkirt,
}
"""By the names that ``sleeve.cuff.type`` and ``pants.cuff.type`` accept."""
