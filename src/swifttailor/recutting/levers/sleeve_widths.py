"""Levers that make sleeves wider or narrower: at the underarm, at their heads, at their cuffs."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.describing.facts import GarmentFacts, Sleeve
from swifttailor.describing.facts_paths import sleeves_of, with_sleeves
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts import sleeve_cuts
from swifttailor.recutting.levers.lever import MORE_GATHERED, WIDER, Lever, fixed, of_dimension
from swifttailor.recutting.levers.parts import THINNER_WRIST
from swifttailor.recutting.table.cutter import Cutter

_SHAPES = ("sleeve_shape", "sleeve_width_cm", "sleeve width", "sleeve end")
_WIDER_A_HEAD = 1.3
"""Exponent: how much wider a sleeve gets for a longer head, its cap staying as high."""
_LEAST_EASE_CM = 2.0
_WIDEST = 3.2
"""Over the girth of the upper arm."""

_upper, _head = of_dimension("sleeve width"), of_dimension("sleeve head")
_end_gather = of_dimension("sleeve gathers")


def _cuffed(facts: GarmentFacts) -> bool:
    return any(s.cuff for s in sleeves_of(facts))


def _upper_span(facts: GarmentFacts) -> tuple[float, float]:
    arm = facts.body.upper_arm_girth
    return arm + _LEAST_EASE_CM, _WIDEST * arm


def _widened(sleeve: Sleeve, upper: float, end: float) -> Sleeve:
    free = 1.0 if sleeve.cuff else end
    return replace(
        sleeve,
        upper_width=sleeve.upper_width * upper,
        end_width=sleeve.end_width * end,
        opening=sleeve.opening * free,
        end_gather=sleeve.end_gather * end if sleeve.cuff else 1.0,
    )


def _width_lever(name: str, *, whole: bool) -> Lever:
    """At the underarm; the whole sleeve down to a free end, or its end staying as it is."""

    def of(facts: GarmentFacts) -> float | None:
        return None if whole and _cuffed(facts) else _upper(facts)

    def imagine(facts: GarmentFacts, width: float) -> GarmentFacts:
        factor = width / max(of(facts) or width, 1.0)
        return with_sleeves(facts, lambda s: _widened(s, factor, factor if whole else 1.0))

    def cut(cutter: Cutter, amount: float) -> Pattern | None:
        was = of(cutter.facts)
        factor = (was + amount) / was if was else 0.0
        return sleeve_cuts.widen_sleeves(cutter, factor, factor if whole else 1.0) if factor > 0 else None

    return Lever(
        name=name,
        serves=("sleeve width", "sleeve end") if whole else ("sleeve width",),
        stage=3,
        of=of,
        imagine=imagine,
        cut=cut,
        span=_upper_span,
        words=WIDER,
        only_for=_SHAPES,
    )


def _least_end(facts: GarmentFacts) -> float:
    """How far ends may be narrowed: cuffed ones until nothing is gathered."""
    if not _cuffed(facts):
        return 0.0
    return 1.0 / max(min((s.end_gather for s in sleeves_of(facts)), default=1.0), 1.0)


def _with_heads(facts: GarmentFacts, factor: float) -> GarmentFacts:
    wide = factor**_WIDER_A_HEAD
    end = max(min(wide, 1.0), _least_end(facts))
    return with_sleeves(facts, lambda s: replace(_widened(s, wide, end), head_gather=s.head_gather * factor))


def _set_head(facts: GarmentFacts, gather: float) -> GarmentFacts:
    return _with_heads(facts, gather / max(_head(facts) or gather, 0.1))


def _cut_head(cutter: Cutter, amount: float) -> Pattern | None:
    was = _head(cutter.facts)
    factor = (was + amount) / was if was else 0.0
    return sleeve_cuts.gather_sleeve_heads(cutter, factor, _least_end(cutter.facts)) if factor > 0 else None


def _set_upper_gathering(facts: GarmentFacts, width: float) -> GarmentFacts:
    return _with_heads(facts, (width / max(_upper(facts) or width, 1.0)) ** (1.0 / _WIDER_A_HEAD))


def _cut_upper_gathering(cutter: Cutter, amount: float) -> Pattern | None:
    was, head = _upper(cutter.facts), _head(cutter.facts)
    if not was or not head or was + amount <= 0:
        return None
    factor = ((was + amount) / was) ** (1.0 / _WIDER_A_HEAD)
    if not 0.97 <= head * factor <= 2.4:
        return None
    return sleeve_cuts.gather_sleeve_heads(cutter, factor, _least_end(cutter.facts))


def _set_anew(facts: GarmentFacts, width: float) -> GarmentFacts:
    arm = facts.body.upper_arm_girth

    def anew(sleeve: Sleeve) -> Sleeve:
        end = width - THINNER_WRIST * arm * min(sleeve.length / facts.body.arm_length, 1.0)
        cuff = sleeve.cuff and replace(sleeve.cuff, opening=end * sleeve.cuff.flare)
        opening = end if cuff is None else cuff.opening
        return replace(
            sleeve,
            upper_width=width,
            end_width=end,
            opening=opening,
            head_gather=1.0,
            end_gather=1.0,
            cuff=cuff,
        )

    return with_sleeves(facts, anew)


def _cut_anew(cutter: Cutter, amount: float) -> Pattern | None:
    was = _upper(cutter.facts)
    return sleeve_cuts.renew_sleeves(cutter, was + amount) if was else None


def _set_end_gather(facts: GarmentFacts, gather: float) -> GarmentFacts:
    factor = gather / max(_end_gather(facts) or gather, 0.1)
    return with_sleeves(facts, lambda s: _widened(s, 1.0, factor))


def _cut_end_gather(cutter: Cutter, amount: float) -> Pattern | None:
    was = _end_gather(cutter.facts)
    if not was or was + amount <= 0.9:
        return None
    return sleeve_cuts.gather_sleeve_ends(cutter, (was + amount) / was)


_HEADS = Lever(
    name="sleeve heads",
    serves=("sleeve head",),
    stage=3,
    of=_head,
    imagine=_set_head,
    cut=_cut_head,
    span=fixed(0.99, 2.3),
    step=0.03,
    words=MORE_GATHERED,
    unit="",
    only_for=("sleeve_shape", "sleeve head"),
    gathers=True,
)
SLEEVE_WIDTH_LEVERS: tuple[Lever, ...] = (
    _width_lever("sleeves", whole=True),
    _width_lever("sleeves above their ends", whole=False),
    _HEADS,
    Lever(
        name="sleeves, their heads gathered,",
        serves=("sleeve width",),
        stage=3,
        of=_upper,
        imagine=_set_upper_gathering,
        cut=_cut_upper_gathering,
        span=_upper_span,
        words=WIDER,
        only_for=_SHAPES,
        gathers=True,
    ),
    Lever(
        name="sleeves cut anew,",
        serves=("sleeve width",),
        stage=3,
        of=_upper,
        imagine=_set_anew,
        cut=_cut_anew,
        span=_upper_span,
        words=WIDER,
        only_for=("sleeve_shape", "sleeve width"),
        gathers=True,
    ),
    replace(
        _HEADS,
        name="sleeves at their cuffs",
        serves=("sleeve gathers",),
        stage=4,
        of=_end_gather,
        imagine=_set_end_gather,
        cut=_cut_end_gather,
        span=fixed(1.0, 3.0),
        step=0.04,
        only_for=("sleeve_shape", "sleeve gathers"),
    ),
)
