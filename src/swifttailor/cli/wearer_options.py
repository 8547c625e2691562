"""Who wears what is made: options of all commands that make garments or refit patterns."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from swifttailor.cli.postponed_imports import tyro

if TYPE_CHECKING:
    from swifttailor.body import Body
    from swifttailor.garment.garment import Garment
    from swifttailor.pattern.drafted_for import DraftedFor

MESHES = (".obj", ".ply", ".glb", ".stl")


@dataclass(frozen=True, kw_only=True)
class BodyOptions:
    """A body by its size, its measures or a file."""

    size: Annotated[str | None, tyro.conf.arg(metavar="SIZE")] = None
    """Make it for a size of a chart: 44, "UK 12", "US 8", M, "men 50", "children 128". EU sizes for women
    unless it says otherwise."""
    measure: Annotated[tuple[str, ...], tyro.conf.arg(metavar="NAME=CM")] = ()
    """Make it for measures, such as bust=96 waist=80 height=172; they outrank those of --size."""
    figure: Literal["women", "men", "children"] | None = None
    """Whose shape completes the measures. Default: the size's, else an adult like the default body."""
    body: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Body mesh (.obj, .ply, .glb, .stl), standing upright, facing +Z; or measurements (.yaml, .json) under
    GarmentCode's or FreeSewing's names. The default body without any of these."""

    @property
    def names_body(self) -> bool:
        """Whether a body is asked for."""
        return any((self.size is not None, self.measure, self.figure is not None, self.body is not None))

    def wearer(self, before: DraftedFor | None = None) -> Body | None:
        """The body that is asked for; None where none is.

        Args:
            before: Who wears the garment until now, of whom all is kept that is not overruled.

        Raises:
            InputError: There is no such size, measure or file, or no body has these measures.
        """
        if not self.names_body:
            return None
        from swifttailor.body.measure_names import parse_measures
        from swifttailor.body.wearer import Wearer

        return Wearer(self.size, parse_measures(self.measure), self.body, self.figure, before=before).body()


@dataclass(frozen=True, kw_only=True)
class WearerOptions(BodyOptions):
    """A body, whether patterns are refitted to it, and how it stands."""

    fit: Literal["auto", "always", "never"] = "auto"
    """Whether the pattern is refitted to that body. auto: to a size and to measures; on a mesh it is left as
    it was drafted."""

    pose: Literal["A", "T", "down"] = "A"
    """How the wearer stands in the end: A as it is sewn, T with level arms, or down with hanging arms. The
    garment is carried along."""

    @property
    def refits(self) -> bool:
        """Whether patterns are refitted to it."""
        mesh = self.body is not None and self.body.suffix.lower() in MESHES
        return self.names_body and (self.fit == "always" or (self.fit == "auto" and not mesh))

    def posed(self, garment: Garment, body: Body | None) -> tuple[Garment, Body | None]:
        """A garment and its wearer in the pose that is asked for.

        Raises:
            InputError: The body has a mesh of its own.
        """
        if self.pose == "A":
            return garment, body
        from dataclasses import replace

        from swifttailor.body import Body
        from swifttailor.body.standing import carried_to

        off_arm = _off_arm(garment) if self.pose == "T" else None
        wearer = body or Body.default()
        stood, cloth = carried_to(self.pose, wearer, garment.vertices, garment.faces, off_arm)
        report = garment.report | {"pose": self.pose}
        return replace(garment, vertices=cloth, report=report), stood


def worn_by(report: dict[str, Any]) -> str:
    """``, worn by women EU 44``, of a garment's report; nothing of the default body."""
    from swifttailor.body import Body

    name = report.get("body", Body.default().name)
    return "" if name == Body.default().name else f", worn by {name}"


def _off_arm(garment: Garment) -> Any:
    """(v,) how far the vertices of a garment with sleeves are from the armholes, cm; None without sleeves."""
    import numpy as np
    from scipy.spatial import KDTree

    from swifttailor.pattern.check import panel_regions

    mesh = garment.mesh
    region = panel_regions(garment.pattern)
    flat = np.array([region[p.name] == "arm" for p in garment.pattern.panels])[mesh.flat_panel]
    sleeve, trunk = (np.zeros(len(garment.vertices), np.bool_) for _ in range(2))
    sleeve[mesh.weld[flat]] = True
    trunk[mesh.weld[~flat]] = True
    armhole = sleeve & trunk
    if not armhole.any():
        return None
    away, _ = KDTree(garment.vertices[armhole]).query(garment.vertices)
    return np.where(sleeve, 0.0, away)
