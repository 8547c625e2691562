"""Damage inside ZIP archives: members of other content, doubled, missing, of other names and compressions."""

from __future__ import annotations

import io
import warnings
import zipfile
from collections.abc import Callable
from random import Random

from fuzzing.mutation.byte_mutations import mutate_bytes

_NAMES = (
    "card.json",
    "about.json",
    "about.npy",
    "../out",
    "/etc/x",
    "a" * 300,
    "",
    "panel.npy",
    "network.onnx",
    "é",
)
_DATE = (1980, 1, 1, 0, 0, 0)
Change = Callable[[str, bytes, Random], bytes]
"""Damages a member, given its name."""


def mutate_archive(data: bytes, random: Random, change: Change, *, stored: bool) -> bytes:
    """An archive with damage to its members or to its bytes.

    Args:
        data: A sound archive.
        random: Decides.
        change: Damages a member.
        stored: Whether members are not compressed.
    """
    if random.random() < 0.25:
        return mutate_bytes(data, random)
    members = members_of(data)
    usual = zipfile.ZIP_STORED if stored else zipfile.ZIP_DEFLATED
    packing = [usual] * len(members)
    for _ in range(random.randint(1, 2)):
        k = random.randrange(len(members))
        name, content = members[k]
        way = random.randrange(12)
        if way == 0 and len(members) > 1:
            del members[k], packing[k]
        elif way == 1:
            members.append((random.choice((name, random.choice(_NAMES))), content))
            packing.append(usual)
        elif way == 2:
            members[k] = (random.choice(_NAMES), content)
        elif way == 3:
            packing[k] = random.choice(
                (zipfile.ZIP_DEFLATED, zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA, zipfile.ZIP_STORED)
            )
        elif way == 4:  # small in the file, large when unpacked
            members[k], packing[k] = (name, content + bytes(30_000_000)), zipfile.ZIP_DEFLATED
        else:
            try:
                members[k] = (name, change(name, content, random))
            except Exception:  # it is damaged already, and may look like anything
                members[k] = (name, mutate_bytes(content, random))
    return archive_of(members, packing)


def members_of(data: bytes) -> list[tuple[str, bytes]]:
    """Names and contents."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        return [(info.filename, archive.read(info)) for info in archive.infolist()]


def archive_of(members: list[tuple[str, bytes]], packing: list[int]) -> bytes:
    """The archive with these members."""
    buffer = io.BytesIO()
    with warnings.catch_warnings(), zipfile.ZipFile(buffer, "w") as archive:
        warnings.simplefilter("ignore")  # doubled names are meant
        for (name, content), kind in zip(members, packing, strict=True):
            info = zipfile.ZipInfo(name, _DATE)
            info.compress_type = kind
            archive.writestr(info, content)
    return buffer.getvalue()
