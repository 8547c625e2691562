"""Bodies as they are asked for: by a size, by measures, by a file of either."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from pathlib import Path

from swifttailor.body.body import Body
from swifttailor.body.made_to_measure import body_to_measure, missed
from swifttailor.body.measure_names import measure_name, read_measures
from swifttailor.body.mesh_files import FORMATS
from swifttailor.body.size_charts import find_size
from swifttailor.body.weight import USUAL_HEIGHTS, waist_of_weight
from swifttailor.errors import InputError
from swifttailor.pattern.drafted_for import DraftedFor

MEASURE_FILES = (".yaml", ".yml", ".json")
GIRTHS = ("bust", "underbust", "waist", "hips")
OF_MESHES = ("height", *GIRTHS, "waist_line", "hips_line", "arm_length", "shoulder_w")
"""What patterns say of a body that is a mesh."""


@dataclass(frozen=True)
class Wearer:
    """Who wears a garment, as far as is said; the default body where nothing is."""

    size: str | None = None
    """As `size_charts.find_size` reads it."""
    measures: Mapping[str, float] | None = None
    """By the names of `body_measures.MEASURES`, cm; they outrank those of the size."""
    file: Path | None = None
    """A mesh, or a file of measurements."""
    figure: str | None = None
    """``women``, ``men`` or ``children``; the size says it otherwise."""
    pose: str = "A"
    """One of `standing.POSES`; patterns are made for the A-pose."""
    before: DraftedFor | None = None
    """Who wore the garment until now. What was asked of that body holds where measures alone are said and
    none of them overrules it; a size, a file or another figure begins anew."""
    weight: float | None = None
    """In kg; it decides the girths where no girth and no size is said."""
    nearest: bool = False
    """Whether the nearest body is taken where none has these measures, instead of refusing them."""

    def body(self) -> Body:
        """The body.

        Raises:
            InputError: The size, a measure or the file cannot be used, or no body has these measures.
        """
        if self.file is not None and self.file.suffix.lower() in FORMATS:
            if self.size is not None or self.measures:
                raise InputError(
                    f"Both a body mesh ('{self.file}') and a size or measures were given. Give one of them."
                )
            body = Body.load(self.file)
            named = DraftedFor(self.file.stem, None, known_measures(body))
            return self._posed(replace(body, made_for=named))
        before = self._kept()
        wanted = {} if before is None else dict(before.measures)
        figure = self.figure or (None if before is None else before.figure)
        name = "" if before is None else before.name
        if self.size is not None:
            size = find_size(f"{self.figure} {self.size}" if self.figure else self.size)
            wanted |= size.measures
            figure, name = size.figure, size.title
        if self.file is not None:
            if self.file.suffix.lower() not in MEASURE_FILES:
                raise InputError(
                    f"'{self.file}' is no body: a mesh ({', '.join(FORMATS)}) or a file of measurements "
                    f"({', '.join(MEASURE_FILES)}) is accepted."
                )
            wanted |= read_measures(self.file)
            name = self.file.stem
        if self.measures:
            wanted |= self.measures
            given = ", ".join(f"{k} {v:g}" for k, v in self.measures.items())
            name = f"{name}, {given}" if name else given
        if self.weight is not None and self.size is None and not any(girth in wanted for girth in GIRTHS):
            height = wanted.get("height") or USUAL_HEIGHTS.get(
                figure or "", Body.default().measurements.height
            )
            wanted |= {"height": height, "waist": waist_of_weight(self.weight, height, figure)}
            name = f"{name}, {self.weight:g} kg" if name else f"{self.weight:g} kg"
        if self.nearest and wanted:
            figure, wanted = _nearest(wanted, self.measures or {}, figure)
        if not wanted and figure is None:
            return self._posed(Body.default())
        named = DraftedFor(name or figure or "", figure, tuple(wanted.items()))
        try:
            return self._posed(body_of(named))
        except InputError as error:
            kept = [f"{k}={v:g}" for k, v in wanted.items() if k not in (self.measures or {})]
            if before is None or not kept:
                raise
            raise InputError(
                f"{error} The garment was made for '{before.name}', from whom these are kept: "
                f"{', '.join(kept)}. Give other values for them, or a size, which begins anew."
            ) from error

    @cached_property
    def not_had(self) -> str:
        """What of the measures nobody has, and what was taken instead, in words; empty where all are had."""
        if not self.nearest or self.file is not None:
            return ""
        size = None if self.size is None else find_size(self.size)
        said = dict(self.measures or {})
        figure = self.figure or (None if size is None else size.figure)
        _, taken = _nearest(({} if size is None else size.measures) | said, said, figure)
        wanted = said or ({} if size is None else size.measures)
        names = missed(wanted, taken)
        if not names:
            return ""
        asked = ", ".join(f"{name} {wanted[name]:.0f}" for name in names)
        near = ", ".join(f"{name} {taken[name]:.0f}" for name in names)
        return f"No body with {asked} cm can be had; the nearest was taken, with {near} cm."

    def _kept(self) -> DraftedFor | None:
        """What is known of the wearer until now and holds still, named without what is overruled."""
        before = self.before
        if before is None or self.size is not None or self.file is not None:
            return None
        if self.figure is not None and before.figure not in (None, self.figure):
            return None
        new = self.measures or {}
        # Of a mesh the girths are kept: its other measures belong to it alone, and go with the height.
        of_mesh = before.figure is None and tuple(name for name, _ in before.measures) == OF_MESHES
        names = GIRTHS if of_mesh else tuple(name for name, _ in before.measures)
        kept = tuple((k, v) for k, v in before.measures if k in names and k not in new)
        overruled = {f"{k} {v:g}" for k, v in before.measures if k in new}
        parts = [part for part in before.name.split(", ") if part not in overruled]
        return replace(before, name=", ".join(parts), measures=kept, mesh=None)

    def _posed(self, body: Body) -> Body:
        if self.pose == "A":
            return body
        from swifttailor.body.standing import carried_to

        return carried_to(self.pose, body)[0]


def body_for(
    size: str | None = None, measures: Mapping[str, float] | None = None, *, figure: str | None = None
) -> Body:
    """Makes the likeliest body for a size or for measures, without any other package; see docs/sizes.md.

    Args:
        size: Of a chart: ``44``, ``UK 12``, ``men 50``, ``children 128``.
        measures: Names and cm, such as ``{"bust": 96, "height": 172}``; they outrank those of the size.
        figure: ``women``, ``men`` or ``children``, whose shape completes the measures; the size's, or an
            adult about the default body, when None.

    Raises:
        InputError: A measure or the size is unknown or out of range, or no body has all of them; the text
            says which come nearest.
    """
    named = {measure_name(name): float(value) for name, value in (measures or {}).items()}
    return Wearer(size, named, figure=figure).body()


def _nearest(
    wanted: Mapping[str, float], said: Mapping[str, float], figure: str | None
) -> tuple[str | None, dict[str, float]]:
    """A figure and measures that one body has: those wanted, or the nearest.

    Args:
        wanted: Of a size and measures together.
        said: The measures alone; where nobody has all, girths of the size give way to them.
        figure: As it is said; where nobody of it has the measures, a body between the figures may be
            nearer.
    """
    alone = dict(said) or dict(wanted)
    if said and "height" in wanted:
        alone.setdefault("height", wanted["height"])
    tries = [(figure, dict(wanted)), (figure, alone), (None, alone)]
    lacks = []
    for whose, measures in tries:
        taken = dict(_taken(tuple(measures.items()), whose))
        if not missed(measures, taken):
            return whose, measures
        lacks.append(
            (sum(abs(taken[name] / alone[name] - 1.0) for name in alone if name in taken), whose, taken)
        )
    _, whose, taken = min(lacks, key=lambda one: one[0])
    return whose, {name: round(value, 1) for name, value in taken.items()}


@lru_cache(maxsize=16)
def _taken(measures: tuple[tuple[str, float], ...], figure: str | None) -> tuple[tuple[str, float], ...]:
    """The measures as the nearest body has them."""
    return tuple(body_to_measure(dict(measures), figure=figure, nearest=True).taken.items())


@lru_cache(maxsize=4)  # one pattern is asked of several times, and it takes up to half a second
def body_of(named: DraftedFor | None) -> Body:
    """The body that a pattern says it was drafted for; the default body where it says nothing.

    Args:
        named: Its figure and measures; of a mesh, a body that has the same.

    Raises:
        InputError: No body has these measures.
    """
    if named is None:
        return Body.default()
    if not named.measures and named.figure is None:
        return Body.default()
    made = body_to_measure(dict(named.measures), figure=named.figure, name=named.name)
    return replace(made.body, made_for=named)


def known_measures(body: Body) -> tuple[tuple[str, float], ...]:
    """The main measures of a body by name, cm: what patterns say of a body that is a mesh."""
    values = body.measurements.as_dict()
    return tuple((name, round(values[name], 2)) for name in OF_MESHES)
