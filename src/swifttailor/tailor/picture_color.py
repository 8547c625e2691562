"""The colour that a garment has in a picture: whether it gets that, and what is told of it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from swifttailor.picture_reader.seen_color import SeenColor
    from swifttailor.tailor.looking import SeenPicture
    from swifttailor.wishes.heard import Heard


def color_seen(picture: SeenPicture, part: str) -> SeenColor | None:
    """The colour that the cloth of a garment has in a picture.

    Args:
        picture: That was read. One that is plain is drawn in colours that mean something else.
        part: Where the garment is worn.

    Returns:
        None where the picture tells none.
    """
    from swifttailor.picture_reader.seen_color import seen_color

    if picture.reading.is_plain:
        return None
    mask = next((one.mask for one in picture.reading.parts if one.part == part), None)
    return None if mask is None else seen_color(picture.pixels, mask)


def color_taken(picture: SeenPicture, part: str, heard: Heard) -> SeenColor | None:
    """The same, where words neither say a colour or a print nor refuse that one."""
    seen = None if heard.says_color else color_seen(picture, part)
    return None if seen is None or heard.refuses_color(seen.rgb) else seen


def color_line(seen: SeenColor) -> str:
    """For a person: "dark red (#7b1320)"; that there is more than one colour is said."""
    from swifttailor.wording.lexicon.color_names import color_name

    name, others = color_name(seen.rgb), list(dict.fromkeys(map(color_name, seen.others)))
    if not others:
        return f"{name} ({seen.rgb})"
    return f"{name} ({seen.rgb}), which covers most; more than one colour ({', '.join(others)})"


def color_report(seen: SeenColor) -> dict[str, Any]:
    """For a report: JSON values."""
    from swifttailor.wording.lexicon.color_names import color_name

    return {
        "name": color_name(seen.rgb),
        "rgb": seen.rgb,
        "share": round(seen.share, 2),
        "others": list(seen.others),
    }
