"""What GCD-MM adds to GarmentCodeData: captions, and edited patterns with instructions.

The published edits have defects: edited specifications equal to the original, and instructions that do not
fit. `EditPair.unchanged` tells the first.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from swifttailor.data.garmentcodedata.dataset import SampleFolder
from swifttailor.errors import InputError
from swifttailor.pattern import Pattern, read_specification
from swifttailor.pattern.json_values import as_object, read_json_file


@dataclass(frozen=True)
class MultimodalCaptions:
    """Two texts about a garment."""

    description: str
    """Its geometry."""
    occasion: str
    """When to wear it; may be empty."""


@dataclass(frozen=True)
class EditPair:
    """A pattern, an edited one, and how to get from each to the other."""

    name: str
    before: Pattern
    after: Pattern
    forward: str
    """Instruction that leads from `before` to `after`."""
    backward: str
    """Instruction that leads back; may be empty."""

    @property
    def unchanged(self) -> bool:
        """Whether both patterns are the same, whatever the instruction says."""
        return self.before.canonical() == self.after.canonical()


def read_captions(root: Path | str, name: str) -> MultimodalCaptions:
    """Reads ``<name>/captions.json``.

    Args:
        root: Folder of the unpacked captions.
        name: Of the garment.

    Raises:
        InputError: The file is missing or damaged.
    """
    path = Path(root) / name / "captions.json"
    content = _texts(path)
    if not content.get("description"):
        raise InputError(f"'{path}' has no 'description'.")
    return MultimodalCaptions(content["description"], content.get("occasion", ""))


def read_edit_pair(root: Path | str, original: SampleFolder) -> EditPair:
    """Reads ``<name>/edited_specification.json`` and ``<name>/editing_caption.json``.

    Args:
        root: Folder of the unpacked edits.
        original: The garment that was edited.

    Raises:
        InputError: A file is missing or damaged.
        PatternError: A specification is no pattern.
    """
    folder = Path(root) / original.name
    texts = _texts(folder / "editing_caption.json")
    forward = texts.get("editing_description_forward", "")
    if not forward:
        raise InputError(f"'{folder / 'editing_caption.json'}' has no 'editing_description_forward'.")
    before, after = (
        read_specification(read_json_file(path), name=original.name).pattern
        for path in (original.file("specification.json"), folder / "edited_specification.json")
    )
    return EditPair(original.name, before, after, forward, texts.get("editing_description_reverse", ""))


def _texts(path: Path) -> dict[str, str]:
    content = as_object(read_json_file(path), str(path))
    return {key: value.strip() for key, value in content.items() if isinstance(value, str)}
