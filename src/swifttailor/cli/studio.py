"""``swifttailor studio``: pattern and garment side by side in the browser."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from swifttailor.cli.postponed_imports import tyro
from swifttailor.errors import InputError, MissingExtraError

LARGEST_PORT = 65535
SHORTEST_TOKEN = 16


@dataclass(frozen=True)
class Studio:
    """Open the studio: pattern and garment side by side in the browser, the garment following every edit.

    It works offline and answers to this machine alone, unless --host says otherwise. Projects are folders
    that the other commands read too. Ctrl-C ends it; what was saved stays.
    """

    projects: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None
    """Folder of the projects. Default: swifttailor-projects in your home folder."""
    port: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Port to serve on, 0 for any that is free. Default: 8765, or any where that is taken."""
    host: str = "127.0.0.1"
    """Address to serve on. Any but this machine's own loopback needs a token, which is made up if none is
    given; what is sent is not encrypted."""
    token: str | None = None
    """Token that the address carries, 16 characters or more of A-Z, a-z, 0-9, - and _."""
    open: bool = True
    """Open the browser."""

    def run(self) -> int:
        """Serves until it is interrupted, and returns the exit code.

        Raises:
            InputError: An option cannot be used.
            MissingExtraError: The extra `studio` is not installed.
        """
        self._validate()
        try:
            import fastapi  # noqa: F401
            import uvicorn  # noqa: F401
        except ImportError as error:
            raise MissingExtraError(str(error.name or "fastapi"), "studio", "The studio") from None
        from swifttailor.studio.app.serve import address_of, is_loopback, open_socket, serve

        token = self.token
        if token is None and not is_loopback(self.host):
            import secrets

            token = secrets.token_urlsafe(24)
        projects = Path.home() / "swifttailor-projects" if self.projects is None else self.projects.absolute()
        if projects.exists() and not projects.is_dir():
            raise InputError(f"--projects is '{projects}', which is not a folder. Give a folder.")
        listening = open_socket(self.host, self.port)
        address = address_of(listening, self.host, token)

        def started() -> None:
            sys.stdout.write(f"The studio is open at {address}\nProjects: {projects}. Ctrl-C ends it.\n")
            sys.stdout.flush()
            if self.open:
                _open_browser(address)

        try:
            serve(listening, host=self.host, projects=projects, token=token, started=started)
        except KeyboardInterrupt:  # the usual end
            sys.stdout.write("The studio is closed.\n")
        return 0

    def _validate(self) -> None:
        if self.port is not None and not 0 <= self.port <= LARGEST_PORT:
            raise InputError(f"--port is {self.port}; 0 to {LARGEST_PORT} is accepted.")
        if self.token is not None and (
            len(self.token) < SHORTEST_TOKEN
            or not self.token.replace("-", "").replace("_", "").isalnum()
            or not self.token.isascii()
        ):
            raise InputError(
                f"--token has {len(self.token)} characters; {SHORTEST_TOKEN} or more of A-Z, a-z, 0-9, "
                "- and _ are accepted."
            )


def _open_browser(address: str) -> None:
    """Opens the browser, where there is a screen to show it on; whether that works decides nothing."""
    import os
    import threading
    import webbrowser

    if sys.platform.startswith("linux") and not (
        os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    ):
        return
    threading.Thread(target=webbrowser.open, args=(address,), daemon=True).start()
