"""``swifttailor generate --read``: what a picture shows, without making anything."""

from __future__ import annotations

import json
import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from swifttailor.cli.generate import Generate
    from swifttailor.tailor.looking import SeenPicture

READING = "reading.json"


def read_pictures(asked: Generate) -> int:
    """Prints what pictures show, and writes it beside what was looked at.

    Returns:
        The exit code: 1 where no garment was found.

    Raises:
        SwiftTailorError: A picture cannot be read, or the folder not be written.
    """
    from swifttailor.atomic_files import write_bytes, write_text
    from swifttailor.garment.folder import SEEN
    from swifttailor.output_folder import OutputFolder
    from swifttailor.parameter_reader.told_design import told_design
    from swifttailor.picture_reader.reading import TOLD
    from swifttailor.picture_reader.together import together
    from swifttailor.render.png import encode_png
    from swifttailor.tailor.looking import parts_seen
    from swifttailor.tailor.picture_color import color_line, color_report, color_seen
    from swifttailor.tailor.picture_print import print_line, print_report, print_seen
    from swifttailor.tailor.seen_sheet import draw_seen
    from swifttailor.wording.wish_lines import claim_line

    with OutputFolder(asked.folder, overwrite=asked.overwrite, sources=asked.image) as output:
        output.require_own([READING, SEEN])
        tailor = asked.tailor()
        pictures = [tailor.look(path) for path in asked.image]
        seen = parts_seen(pictures)
        told: list[dict[str, Any]] = [{"file": one.name} | one.reading.to_json() for one in pictures]
        for about, one in zip(told, pictures, strict=True):
            for part, read in zip(about["parts"], one.reading.parts, strict=True):
                color = color_seen(one, read.part)
                part["color"] = None if color is None else color_report(color)
                if read.print is not None:
                    part["print"] = print_report(read.print)
                if read.design is not None:
                    part["design"] = [parameter.to_json() for parameter in told_design(read.design)]
        with output.fill() as folder:
            write_text(folder / READING, json.dumps(told, indent=2) + "\n")
            write_bytes(folder / SEEN, encode_png(draw_seen(pictures, next(iter(seen), None))))
    asked.show(SEEN)
    if asked.json:
        sys.stdout.write(json.dumps(told, indent=2) + "\n")
        return 0 if seen else 1
    lines = [_picture_line(one) for one in pictures]
    for name in seen:
        part = together([next(p for p in one.reading.parts if p.part == name) for one in pictures])
        lines.append(f"{name} ({part.certainty:.0%}):")
        color = color_seen(pictures[0], name)
        if color is not None:
            lines.append(f"  colour: {color_line(color)}")
        if (printed := print_seen(pictures[0], name)) is not None:
            lines.append(f"  print: {print_line(printed)}")
        lines += [
            f"  {claim_line(s.claim)} ({s.certainty:.0%})" for s in part.statements if s.certainty >= TOLD
        ]
        lines += [
            f"  {m.name}: {m.value:.1f}, give or take {m.off:.1f}" for m in part.measures if m.certainty > 0.5
        ]
        panels = [p.name for p in part.panels if p.certainty > 0.5]
        lines.append(f"  panels: {', '.join(panels)}")
        if part.design is not None:
            lines.append("  design parameters, by what is seen alone:")
            lines += [f"    {parameter.line()}" for parameter in told_design(part.design)]
    if not seen:
        lines.append("No garment was found in the picture.")
    lines.append(f"Wrote {asked.folder / SEEN} and {asked.folder / READING}.")
    print("\n".join(lines))  # noqa: T201
    return 0 if seen else 1


def _picture_line(one: SeenPicture) -> str:
    read = one.reading
    if read.is_laid:
        return f"{one.name}: worn by nobody, its {read.face} to be seen"
    return f"{one.name}: seen from the {read.face}; people: {read.figures}"
