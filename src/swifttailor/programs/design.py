"""The design of a garment: values of GarmentCode's parameters by flat name."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any


class Design(Mapping[str, Any]):
    """Parameter values by flat name ("sleeve.cuff.type"), all of them known and checked."""

    def __init__(self, values: Mapping[str, Any]) -> None:
        """Keeps a copy of the values."""
        self._values = dict(values)

    def section(self, name: str) -> Design:
        """The parameters below a name, without it: ``section("sleeve")["cuff.type"]``."""
        start = name + "."
        return Design({k.removeprefix(start): v for k, v in self._values.items() if k.startswith(start)})

    def replaced(self, values: Mapping[str, Any]) -> Design:
        """The design with other values."""
        return Design({**self._values, **values})

    def __getitem__(self, name: str) -> Any:
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)
