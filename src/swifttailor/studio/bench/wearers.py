"""Who wears a pattern: the body that it names, and what is worked out of that once."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

from swifttailor.body import Body
from swifttailor.body.probe import probe_body
from swifttailor.body.wearer import body_of
from swifttailor.pattern.check import BodyProbe
from swifttailor.pattern.drafted_for import DraftedFor
from swifttailor.studio.bench.own_bodies import own_bodies
from swifttailor.studio.body_mesh import body_record
from swifttailor.studio.mesh_record import MeshRecord
from swifttailor.studio.shipped import shipped_options

if TYPE_CHECKING:
    from swifttailor.tailor import Tailor

MOST_KEPT = 4
"""Bodies; each has its distance field, some megabytes."""


@dataclass(frozen=True, eq=False)
class Wearing:
    """A body with what sews on it."""

    body: Body
    stands_in: bool = False
    """Whether it is made to the measures of a mesh that is not kept here."""

    @property
    def is_default(self) -> bool:
        """Whether it is the body that comes with the package."""
        return self.body is Body.default()

    @cached_property
    def tailor(self) -> Tailor:
        """Sews on this body; patterns stay as they are."""
        from swifttailor.studio.bench.tasks import tailor

        if self.is_default:
            return tailor()
        _ = tailor().garment_sewer  # opened once, for all bodies
        return tailor().worn_by(self.body)

    @cached_property
    def hasty_tailor(self) -> Tailor:
        """The same, with a coarser drape to start from: for garments that are looked at for a moment."""
        from swifttailor.draping.coarse import HASTY
        from swifttailor.garment_sewer.sewer import GarmentSewer
        from swifttailor.studio.bench.tasks import tailor
        from swifttailor.tailor import Tailor

        sewer = tailor().garment_sewer
        if isinstance(sewer, GarmentSewer):
            sewer = replace(sewer, coarse=HASTY)
        return Tailor(garment_sewer=sewer, body=None if self.is_default else self.body)

    @cached_property
    def probe(self) -> BodyProbe:
        """For checks."""
        return probe_body(self.body)

    @cached_property
    def record(self) -> MeshRecord:
        """Its mesh, for the store."""
        return body_record(self.body)

    @property
    def name(self) -> str:
        """Of its mesh."""
        return shipped_options()["body"] if self.is_default else self.record.name

    @property
    def meshes(self) -> tuple[MeshRecord, ...]:
        """What a document that names this body brings along; the default body is known to all."""
        return () if self.is_default else (self.record,)


def wearing(named: DraftedFor | None) -> Wearing:
    """The wearer of patterns that were drafted for a body; the default body where they name none.

    A body that was loaded as a mesh is that mesh where it is kept here, else one of the same measures.

    Raises:
        InputError: There is no such figure, or no body has these measures.
    """
    return _wearing(named, named is not None and named.mesh is not None and own_bodies().has(named.mesh))


@lru_cache(maxsize=MOST_KEPT)
def _wearing(named: DraftedFor | None, has_mesh: bool) -> Wearing:
    if named is None:
        return Wearing(Body.default())
    if has_mesh and named.mesh is not None:
        return Wearing(replace(own_bodies().find(named.mesh), made_for=named))
    return Wearing(body_of(named), stands_in=named.mesh is not None)
