"""Meshes by the hash of their content, as many as fit."""

from __future__ import annotations

from collections import OrderedDict

from swifttailor.studio.mesh_record import MeshRecord

MOST_BYTES = 192 * 2**20


class MeshStore:
    """Keeps the meshes that were used last."""

    def __init__(self, most_bytes: int = MOST_BYTES) -> None:
        """It is empty.

        Args:
            most_bytes: Of all together.
        """
        self._most, self._bytes = most_bytes, 0
        self._records: OrderedDict[str, MeshRecord] = OrderedDict()

    def add(self, record: MeshRecord) -> None:
        """Keeps a mesh, and drops those that were not used for longest where there are too many."""
        before = self._records.pop(record.name, None)
        self._bytes += record.size - (before.size if before else 0)
        self._records[record.name] = record
        while self._bytes > self._most and len(self._records) > 1:
            _, dropped = self._records.popitem(last=False)
            self._bytes -= dropped.size

    def find(self, name: str) -> MeshRecord | None:
        """A mesh by its name; None where it was dropped or never was."""
        if name in self._records:
            self._records.move_to_end(name)
        return self._records.get(name)

    @property
    def size(self) -> int:
        """Bytes of all."""
        return self._bytes
