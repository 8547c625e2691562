"""The staged drape on the XPBD solver: sew the flat panels together, then let the garment hang to rest."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats
from swifttailor.body import Body
from swifttailor.draping.attachment import Attachment
from swifttailor.draping.cloth import ClothArrays, ClothModel
from swifttailor.draping.collider import build_field_arrays
from swifttailor.draping.fabric import Fabric
from swifttailor.draping.loop_arguments import (
    FRAME_RATE,
    GRAVITY,
    ContactArrays,
    FieldArrays,
    HeldArrays,
    StepSettings,
)
from swifttailor.draping.neighbor_lists import no_neighbors
from swifttailor.draping.worn_height import worn_height
from swifttailor.draping.xpbd_kernels import advance_frame
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern.check import panel_regions
from swifttailor.progress import StageProgress

_FOOTPRINT_LEVEL = 2.0
_SEWING_BENDING = 20.0
_GROWING_BENDING, _GROWN_FRAMES = 5.0, 2
_SMOOTHING_PULL, _SMOOTHING_FRICTION, _SMOOTHING_DAMPING = 4.0, 0.1, 10.0
"""Of a hand that smooths cloth down: its pull at first over the cloth's weight; what is left of friction."""
_UNTANGLING = 0.1
_LET_GO_AFTER = 30
_MIN_FRAMES, _MIN_FREE_FRAMES = 30, 15
_MAX_SPEED, _FALLING_SPEED = 250.0, 120.0
_LOST = 15.0
"""A garment this much lower than it must be held is not coming back, cm."""


@dataclass(frozen=True)
class SimulationSettings:
    """How long and how finely to simulate."""

    substeps: int = 18
    contact_interval: int = 5
    """Substeps between two searches for contacts."""
    sewing_frames: int = 40
    settling_frames: int = 10
    max_frames: int = 600
    self_collision: bool = True
    still_cm: float = 0.03
    """A vertex is at rest when it moves less than this in a frame (GarmentCode's rule)."""
    still_share: float = 0.015
    """The garment is at rest when at most this share of its vertices still moves."""
    watch: Callable[[Floats], object] | None = None
    """Called after every frame with the positions (v, 3) in cm, which the next frame overwrites."""


class Hold(Protocol):
    """What holds some of the cloth, as a belt does."""

    def __call__(self, simulation: Simulation, share: float, /) -> None:
        """Moves it after a frame, when a share of the time is over."""


@dataclass(frozen=True)
class Dressing:
    """One way of getting the panels onto the body. None suits every garment."""

    sleeves_out: bool
    """Whether sleeves start further out on the arms (see `place_vertices`)."""
    sleeve_delay_frames: int
    """How much later than the torso is closed the sleeves are sewn on."""
    contact_from: float
    """Share of the sewing after which self-collision acts."""


DRESSINGS = (
    Dressing(sleeves_out=False, sleeve_delay_frames=0, contact_from=0.5),
    Dressing(sleeves_out=True, sleeve_delay_frames=20, contact_from=0.0),
)
"""Tried in this order until one leaves the cloth untangled."""


class Simulation:
    """A cloth, a body and the state of their motion."""

    def __init__(
        self,
        mesh: PatternMesh,
        cloth: ClothModel,
        body: Body,
        fabric: Fabric,
        attachment: Attachment,
        positions: Floats,
        settings: SimulationSettings,
    ) -> None:
        self.cloth: ClothArrays = cloth.arrays
        self.fabric = fabric
        self.settings = settings
        self.attachment = attachment
        self._lowest_top = worn_height(mesh.pattern, body.measurements).lowest
        self.sleeve_edges = _sleeve_edges(mesh, self.cloth.edges)
        self.field: FieldArrays = build_field_arrays(body, mesh)
        self.positions = np.ascontiguousarray(positions, dtype=np.float64).copy()
        self.velocities = np.zeros_like(self.positions)
        self.held = HeldArrays(
            np.ascontiguousarray(attachment.vertices, dtype=np.int32),
            np.array(attachment.levels, dtype=np.float64),
        )
        self.moving = 1.0
        self.contacts_found = 0
        self.crossings = 0
        self._contacts = _contact_buffers(len(self.positions))
        self._clearance = np.zeros(len(self.positions))
        self._lists = no_neighbors()

    def frame(
        self,
        *,
        gravity: float,
        damping: float,
        friction: float,
        bending_factor: float = 1.0,
        long_edges: bool = False,
        self_collision: bool,
        untangling: float = _UNTANGLING,
        max_speed: float = _MAX_SPEED,
        rest: Floats | None = None,
        substeps: int | None = None,
    ) -> None:
        """Advances by one frame of 1/60 s."""
        s = self.settings
        substeps = substeps or s.substeps
        step = StepSettings(
            substeps=substeps,
            step=1.0 / (FRAME_RATE * substeps),
            gravity=gravity,
            damping=damping,
            friction=friction,
            thickness=self.fabric.thickness,
            max_speed=max_speed,
            bending_factor=bending_factor,
            # Hems may start or hang below the floor: there the body goes on as the print of its feet.
            lowest_level=_FOOTPRINT_LEVEL,
            long_edges=long_edges,
            self_collision=self_collision,
            untangling=untangling,
            contact_interval=s.contact_interval,
            still=s.still_cm,
        )
        self._clearance[:] = 0.0
        cloth = self.cloth if rest is None else self.cloth._replace(rest=rest)
        self.moving, self.contacts_found, self.crossings, self._lists = advance_frame(
            self.positions,
            self.velocities,
            cloth,
            self.field,
            self.held,
            self._contacts,
            self._lists,
            self._clearance,
            step,
        )
        if s.watch is not None:
            s.watch(self.positions)

    def hold(self) -> None:
        """Holds the attached vertices at their level, or where they are if that is lower."""
        heights = self.positions[self.held.vertices, 1]
        self.held.levels[:] = np.minimum(self.attachment.levels, heights)

    def let_go(self) -> None:
        """Holds no longer what is held at first only."""
        self.held.levels[self.attachment.at_first] = -np.inf

    @property
    def has_slid_down(self) -> bool:
        """Whether it is so far below where it must be held that it will not stop before the floor."""
        return bool(self.positions[:, 1].max() < self._lowest_top - _LOST)

    def edge_lengths(self) -> Floats:
        """Current length of every spring, cm."""
        a, b = self.positions[self.cloth.edges[:, 0]], self.positions[self.cloth.edges[:, 1]]
        return np.linalg.norm(a - b, axis=1)


def sew(simulation: Simulation, dressing: Dressing, progress: StageProgress) -> None:
    """Closes the seams: rest lengths shrink from those of the placed panels to the true ones.

    No gravity, no friction and strong damping, so that panels slide around the body instead of sticking
    to it or jumping over it; stiff bending keeps bands from folding.
    """
    s = simulation.settings
    initial = simulation.edge_lengths()
    true = simulation.cloth.rest
    delay = dressing.sleeve_delay_frames if simulation.sleeve_edges.any() else 0
    total = s.sewing_frames + delay + s.settling_frames
    for k in range(total):
        first = min(1.0, (k + 1) / s.sewing_frames)
        later = min(1.0, max(0.0, (k + 1 - delay) / s.sewing_frames))
        share = np.where(simulation.sleeve_edges, later, first)
        rest = np.maximum(true, initial * (1 - share) + true * share)
        simulation.frame(
            gravity=0.0,
            damping=20.0,
            friction=0.0,
            bending_factor=_SEWING_BENDING,
            long_edges=True,
            self_collision=s.self_collision and first > dressing.contact_from,
            rest=rest,
        )
        progress("sewing", (k + 1) / total)


def settle(simulation: Simulation, progress: StageProgress) -> tuple[int, bool]:
    """Lets the garment hang until it rests, or slides down.

    Returns:
        The frames used and whether it came to rest.
    """
    s = simulation.settings
    simulation.hold()
    # Nothing rests before its neckline has been let go.
    first_rest = _LET_GO_AFTER + _MIN_FREE_FRAMES if simulation.attachment.at_first.any() else _MIN_FRAMES
    for k in range(s.max_frames):
        if k == _LET_GO_AFTER:
            simulation.let_go()
        # Damping grows with time: a garment that will not rest within two seconds only chatters.
        # What still does after five, a few vertices of a coarse mesh that fold to and fro, is held.
        damping = 2.0 + 8.0 * min(max(k - 90, 0) / 200, 1.0) + 40.0 * min(max(k - 300, 0) / 200, 1.0)
        simulation.frame(
            gravity=GRAVITY,
            untangling=_UNTANGLING * max(0.0, 1 - k / 120),
            # Wide skirts fall slowly, or their layers pass through each other between two searches.
            max_speed=_FALLING_SPEED + (_MAX_SPEED - _FALLING_SPEED) * min(max((k - 60) / 40, 0.0), 1.0),
            damping=damping,
            friction=simulation.fabric.friction,
            self_collision=s.self_collision,
            long_edges=k < 15,
        )
        progress("draping", min((k + 1) / 180, 0.99))
        if simulation.has_slid_down:
            return k + 1, False
        if k >= first_rest and simulation.moving <= s.still_share:
            return k + 1, True
    return s.max_frames, False


def fall(
    simulation: Simulation,
    frames: int,
    damping: float,
    progress: StageProgress,
    holds: Sequence[Hold] = (),
) -> None:
    """Lets the garment hang for a while, whether it comes to rest or not; necklines stay held.

    Args:
        simulation: Of a garment that is worn already.
        frames: For so many sixtieths of a second.
        damping: Per second.
        progress: Called with the name of the stage and the share of it that is done.
        holds: What moves some of it after every frame.
    """
    simulation.hold()
    for k in range(frames):
        simulation.frame(
            gravity=GRAVITY,
            damping=damping,
            friction=simulation.fabric.friction,
            self_collision=simulation.settings.self_collision,
            max_speed=_FALLING_SPEED,
            long_edges=k < 15,
        )
        for hold in holds:
            hold(simulation, (k + 1) / frames)
        progress("relaxing", (k + 1) / frames)


def smooth_down(simulation: Simulation, frames: int, below: float, progress: StageProgress) -> None:
    """Pulls the garment down over the body, as hands do that smooth a back which has ridden up.

    Cloth that was put there, and not drawn on, lies in rolls above the seat, and friction keeps it so. The
    pull grows less until the cloth hangs by its own weight, for what is let go of at once springs back.

    Args:
        simulation: Of a garment that is worn already.
        frames: For so many sixtieths of a second.
        below: What lies below this height is pulled, cm; collars, hoods and shoulders stay where they are.
        progress: Called with the stage's name and the share of it that is done.
    """
    simulation.hold()
    pulled = simulation.positions[:, 1] < below
    upper = simulation.positions[~pulled]
    for k in range(frames):
        pull = (_SMOOTHING_PULL - 1.0) * (1.0 - k / frames)
        simulation.velocities[pulled, 1] -= pull * GRAVITY / FRAME_RATE
        simulation.frame(
            gravity=GRAVITY,
            damping=_SMOOTHING_DAMPING,
            friction=_SMOOTHING_FRICTION * simulation.fabric.friction,
            self_collision=simulation.settings.self_collision,
            max_speed=_FALLING_SPEED,
            long_edges=k < 15,
        )
        simulation.positions[~pulled] = upper
        simulation.velocities[~pulled] = 0.0
        progress("relaxing", (k + 1) / frames)


def grow(simulation: Simulation, frames: int, progress: StageProgress, substeps: int | None = None) -> None:
    """Lets cloth that lies shorter than it is grow to its true lengths, folding as it does.

    Bends are stiff meanwhile, so that it folds in few wide folds instead of many narrow ones.

    Args:
        simulation: Of cloth that lies smoothly.
        frames: For so many sixtieths of a second.
        progress: Called with the stage's name and the share of it that is done.
        substeps: Of each frame; the simulation's when None.
    """
    simulation.hold()
    true = simulation.cloth.rest
    short = np.minimum(simulation.edge_lengths(), true)
    for k in range(frames):
        share = min(1.0, (k + 1) / (frames - _GROWN_FRAMES))
        simulation.frame(
            gravity=0.5 * GRAVITY,
            damping=10.0,
            friction=simulation.fabric.friction,
            bending_factor=_GROWING_BENDING,
            self_collision=simulation.settings.self_collision,
            max_speed=_FALLING_SPEED,
            rest=short * (1 - share) + true * share,
            substeps=substeps,
        )
        progress("relaxing", (k + 1) / frames)


def _sleeve_edges(mesh: PatternMesh, edges: NDArray[np.int32]) -> NDArray[np.bool_]:
    """(e,) edges with an end that lies on sleeves alone."""
    on_sleeve = np.array([region == "arm" for region in panel_regions(mesh.pattern).values()])
    elsewhere = np.zeros(mesh.vertex_count, dtype=bool)
    elsewhere[mesh.weld[~on_sleeve[mesh.flat_panel]]] = True
    if not elsewhere.any():
        return np.zeros(len(edges), dtype=bool)
    return ~(elsewhere[edges[:, 0]] & elsewhere[edges[:, 1]])


def _contact_buffers(count: int) -> ContactArrays:
    contacts, crossings = 40 * count + 1000, 10 * count + 1000
    return ContactArrays(
        vertex=np.zeros(contacts, np.int32),
        face=np.zeros(contacts, np.int32),
        side=np.zeros(contacts, np.float64),
        crossing_edge=np.zeros(crossings, np.int32),
        crossing_face=np.zeros(crossings, np.int32),
        crossing_push=np.zeros((crossings, 3), np.float64),
        tangled=np.zeros(count, np.uint8),
    )
