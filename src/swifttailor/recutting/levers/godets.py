"""Levers of godets: how many, how wide, how high; let into plain skirts and taken out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from swifttailor.describing.facts import GarmentFacts, Skirt
from swifttailor.describing.measuring.parts import SKIRT_PARTS, Part
from swifttailor.pattern import Pattern
from swifttailor.recutting.levers.lever import Lever, Trick, fixed, of_dimension
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.godets import add_godets, remove_godets

_FACES = 2
_NOTCH_CM = 9.0
"""What a godet's notch takes of the hem, about."""
_WIDTH_CM, _SHARE, _HIGHEST_CM = 25.0, 0.45, 40.0
"""Of a new godet: its width, and its height as a part of the skirt's length and at most."""


def _godets(facts: GarmentFacts) -> Skirt | None:
    return facts.skirt if facts.skirt and facts.skirt.godets and facts.skirt.tiers == 1 else None


def _plain_hem(skirt: Skirt) -> float:
    return skirt.base_hem + _NOTCH_CM * skirt.godets


def _with(facts: GarmentFacts, count: float, width: float, height: float) -> GarmentFacts:
    skirt = facts.skirt
    if skirt is None:
        return facts
    plain = _plain_hem(skirt) if skirt.godets else skirt.hem
    base = max(plain - _NOTCH_CM * count, 0.0)
    skirt = replace(
        skirt,
        godets=int(count),
        godet_width=width,
        godet_height=height,
        hem=base + count * width,
        base_hem=base,
    )
    return replace(facts, skirt=skirt)


def without_godets(cutter: Cutter) -> Cutter | None:
    """The skirt with its godets taken out; itself where it has none."""
    names = cutter.names(Part.GODET)
    if not names:
        return cutter
    plain = remove_godets(cutter.pattern, names)
    return None if plain is None else cutter.with_pattern(plain)


def _cut(cutter: Cutter, count: float, width: float, height: float) -> Pattern | None:
    plain, each = without_godets(cutter), round(count / _FACES)
    if plain is None or each < 1 or plain.facts.skirt is None or plain.facts.skirt.slits:
        return None
    hem = plain.hem_of(*SKIRT_PARTS)
    if not hem or len({r.panel for r in hem}) != _FACES:
        return None
    return add_godets(plain.pattern, hem, each, width, height)


def _size_lever(name: str, of: Callable[[Skirt], float], low: float, high: float, step: float) -> Lever:
    def measure(facts: GarmentFacts) -> float | None:
        skirt = _godets(facts)
        return float(of(skirt)) if skirt else None

    def sizes(skirt: Skirt, value: float) -> tuple[float, float, float]:
        own = {"godets": float(skirt.godets), "width": skirt.godet_width, "height": skirt.godet_height}
        own[name] = value
        return own["godets"], own["width"], own["height"]

    def imagine(facts: GarmentFacts, value: float) -> GarmentFacts:
        skirt = _godets(facts)
        return _with(facts, *sizes(skirt, value)) if skirt else facts

    def cut(cutter: Cutter, amount: float) -> Pattern | None:
        skirt = _godets(cutter.facts)
        return None if skirt is None else _cut(cutter, *sizes(skirt, float(of(skirt)) + amount))

    counts = name == "godets"
    return Lever(
        name=name if counts else f"godets, their {name},",
        serves=("godets",) if counts else (f"godet {name}",),
        stage=5,
        of=measure,
        imagine=imagine,
        cut=cut,
        span=fixed(low, high),
        step=step,
        words=("more", "fewer") if counts else ("more", "less"),
        unit="" if counts else " cm",
        only_for=("godets",) if counts else (f"godet {name}", "base width", "skirt hem", "godet_cm"),
    )


def _natural_height(facts: GarmentFacts) -> float:
    return min(_SHARE * facts.skirt.length, _HIGHEST_CM) if facts.skirt else 0.0


def _let_in(facts: GarmentFacts, count: float) -> GarmentFacts:
    skirt = facts.skirt
    if skirt is None or skirt.godets or skirt.tiers > 1 or skirt.slits or skirt.gores > _FACES:
        return facts
    return _with(facts, count, _WIDTH_CM, _natural_height(facts))


def _none(facts: GarmentFacts) -> GarmentFacts | None:
    skirt = _godets(facts)
    if skirt is None:
        return None
    plain = _plain_hem(skirt)
    skirt = replace(skirt, godets=0, godet_width=0.0, godet_height=0.0, hem=plain, base_hem=plain)
    return replace(facts, skirt=replace(skirt, circle=0.0))


def _take_out(cutter: Cutter) -> Pattern | None:
    plain = without_godets(cutter)
    return None if plain is None else plain.pattern


GODET_LEVERS: tuple[Lever, ...] = (
    _size_lever("godets", lambda s: s.godets, 2.0, 16.0, 2.0),
    _size_lever("width", lambda s: s.godet_width, 8.0, 60.0, 1.0),
    _size_lever("height", lambda s: s.godet_height, 10.0, 70.0, 1.0),
    Lever(
        name="godets let in",
        serves=("godets", "base width"),
        stage=5,
        of=of_dimension("godets"),
        imagine=_let_in,
        cut=lambda cutter, amount: _cut(cutter, amount, _WIDTH_CM, _natural_height(cutter.facts)),
        span=fixed(2.0, 12.0),
        step=2.0,
        unit="",
        moves=False,
        natural=6.0,
        only_for=("skirt: godets", "godets", "godet_cm"),
    ),
)
GODET_TRICKS: tuple[Trick, ...] = (
    Trick(
        name="godets taken out",
        stage=1,
        imagine=_none,
        cut=_take_out,
        only_for=("skirt",),
        opens=("skirt", "slit", "length", "length_cm", "skirt_hem", "hem_shape"),
    ),
)
