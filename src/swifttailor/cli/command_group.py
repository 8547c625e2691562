"""Commands of two words, such as ``swifttailor data build``: finds the one that was asked for."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from importlib import import_module
from typing import Any

USAGE_ERROR = 2


@dataclass(frozen=True)
class GroupedCommand:
    """One command of a group."""

    summary: str
    """Lines of at most 80 characters."""
    usage: str
    options: str
    """``module:Class`` of its options, a dataclass with a method `run`; imported when it is called."""

    def load(self) -> Any:
        """The class of its options."""
        module, name = self.options.split(":")
        return getattr(import_module(module), name)


@dataclass(frozen=True)
class CommandGroup:
    """Commands with the same first word."""

    name: str
    summary: str
    commands: Mapping[str, GroupedCommand]
    """In the order in which they are listed."""

    def run(self, arguments: list[str]) -> int:
        """Runs the command with the arguments that follow the group's name.

        Returns:
            The exit code.

        Raises:
            SwiftTailorError: What the command raises.
        """
        name = arguments[0] if arguments else ""
        if name in self.commands:
            import tyro

            program = f"swifttailor {self.name} {name}"
            return tyro.cli(self.commands[name].load(), args=arguments[1:], prog=program).run()
        if name in ("-h", "--help"):
            sys.stdout.write(self.overview())
            return 0
        if name:
            close = get_close_matches(name.lower(), self.commands, n=1, cutoff=0.5)
            hint = f" Did you mean '{self.name} {close[0]}'?" if close else ""
            sys.stderr.write(f"There is no command '{self.name} {name}'.{hint}\n")
        sys.stderr.write(self.overview())
        return USAGE_ERROR

    def overview(self) -> str:
        """What ``--help`` prints."""
        width = max(len(name) for name in self.commands)
        indent = f"\n  {'':<{width}}  "
        lines = [
            self.summary,
            "",
            f"usage: swifttailor {self.name} COMMAND [OPTIONS]",
            "",
            *(
                f"  {name:<{width}}  {c.summary.replace(chr(10), indent)}{indent}{c.usage}"
                for name, c in self.commands.items()
            ),
            "",
            f"  swifttailor {self.name} COMMAND --help   all options of a command",
        ]
        return "\n".join(lines) + "\n"
