"""Contact sheets: what was asked, what was answered and what is true, from the nearest to the farthest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from swifttailor.arrays import Pixels
from swifttailor.data.stats.sheets import wrapped
from swifttailor.evaluation.maker.scores import Scored
from swifttailor.evaluation.spread import spread
from swifttailor.pattern import Pattern
from swifttailor.render.numbered_sheets import write_numbered_sheets

PER_SHEET = 6
TILE = 420, 330
_TEXT_WIDTH, _SHOWN = 400, 190
_MARGIN, _CAPTION = 10, 24
_MOST_LINES = 8
_LARGER = 2.0
"""A pattern so much larger than the truth is drawn at its own scale."""
_PAPER, _INK, _GREY, _RED = (250, 249, 247), (40, 40, 40), (120, 118, 114), (176, 58, 46)


@dataclass(frozen=True, eq=False)
class Shown:
    """A row of a sheet."""

    scored: Scored
    picture: Pixels | None
    """What the network was shown."""


def chosen(scored: Sequence[Scored], count: int) -> list[Scored]:
    """At most `count` answers evenly from the nearest to the truth to the farthest."""
    return spread(sorted(scored, key=lambda s: (s.score.by_name.vertex_cm, s.answer.question.key)), count)


def write_sheets(folder: Path, name: str, shown: Sequence[Shown]) -> list[Path]:
    """Writes sheet-<name>-01.png and so on.

    Raises:
        InputError: A file cannot be written.
    """
    return write_numbered_sheets(folder, f"sheet-{name}", shown, PER_SHEET, _draw)


def _draw(shown: Sequence[Shown]) -> Any:
    from PIL import Image, ImageDraw, ImageFont

    edit = any(s.scored.answer.question.before is not None for s in shown)
    columns = 3 if edit else 2
    width = _TEXT_WIDTH + columns * (TILE[0] + _MARGIN) + 2 * _MARGIN
    height = TILE[1] + _CAPTION + _MARGIN
    sheet = Image.new("RGB", (width, height * len(shown) + _MARGIN), _PAPER)
    draw, font, small = ImageDraw.Draw(sheet), ImageFont.load_default(16), ImageFont.load_default(14)
    for row, one in enumerate(shown):
        top = _MARGIN + row * height
        question, scored = one.scored.answer.question, one.scored
        patterns = [("asked to edit", question.before)] if edit else []
        patterns += [("answer", scored.answer.pattern), ("truth", question.truth)]
        scale = _common_scale([p for _, p in patterns if p is not None], question.truth)
        for column, (title, pattern) in enumerate(patterns):
            left = _MARGIN + _TEXT_WIDTH + column * (TILE[0] + _MARGIN)
            about = title if title != "answer" else f"answer: {_numbers(scored)}"
            draw.text((left, top), about, fill=_INK, font=small)
            _paste(sheet, draw, (left, top + _CAPTION), pattern, scale)
        _write_question(sheet, draw, (_MARGIN, top), one, font, small)
    return sheet


def _write_question(sheet: Any, draw: Any, at: tuple[int, int], one: Shown, font: Any, small: Any) -> None:
    from PIL import Image

    question, (left, top) = one.scored.answer.question, at
    room = _TEXT_WIDTH - 2 * _MARGIN
    draw.text((left, top), question.id, fill=_GREY, font=small)
    y = top + _CAPTION
    if one.picture is not None:
        picture = Image.fromarray(one.picture).resize((_SHOWN, _SHOWN), Image.Resampling.LANCZOS)
        sheet.paste(picture, (left, y))
        y += _SHOWN + 6
    most = _MOST_LINES if one.picture is None else _MOST_LINES // 2 - 1
    for text, color, used in ((question.text, _INK, font), (_not_held(one.scored), _RED, small)):
        lines = wrapped(text, room, used.getlength)
        shown = lines[:most] + (["..."] if len(lines) > most else [])
        draw.text((left, y), "\n".join(shown), fill=color, font=used, spacing=2)
        y += len(shown) * (used.size + 4) + 4


def _paste(sheet: Any, draw: Any, at: tuple[int, int], pattern: Pattern | None, scale: float) -> None:
    from swifttailor.render.pattern_picture import fitting_scale, pattern_picture

    if pattern is None:
        draw.text(at, "nothing could be decoded", fill=_RED)
        return
    own = fitting_scale(pattern, TILE)
    sheet.paste(pattern_picture(pattern, TILE, min(scale, own)), at)


def _common_scale(patterns: Sequence[Pattern], truth: Pattern) -> float:
    """Pixels per cm at which all can be compared, but for those that are far too large."""
    from swifttailor.render.pattern_picture import fitting_scale

    true = fitting_scale(truth, TILE)
    fitting = [fitting_scale(p, TILE) for p in patterns]
    return min([true, *(f for f in fitting if f * _LARGER >= true)])


def _numbers(scored: Scored) -> str:
    name = scored.score.by_name
    return (
        f"vertices {name.vertex_cm:.1f} cm, panel F1 {name.panels.f1:.0%}, stitch F1 {name.stitches.f1:.0%}"
    )


def _not_held(scored: Scored) -> str:
    wrong = [about for about, holds in scored.fulfilled if not holds]
    return "not so: " + ", ".join(_words(about) for about in wrong) if wrong else ""


def _words(about: dict[str, Any]) -> str:
    if "gain" in about:
        return _words(about["gain"])
    if "step" in about:
        return f"{about['step']} {'up' if about['direction'] > 0 else 'down'}"
    value = about["value"]
    return f"{about['name']} {value:g}" if isinstance(value, float) else f"{about['name']} {value}"
