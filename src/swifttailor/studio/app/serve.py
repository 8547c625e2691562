"""Serving the studio: a socket, the application on it, an address to open."""

from __future__ import annotations

import asyncio
import errno
import socket
from collections.abc import Callable
from pathlib import Path
from typing import Any

import uvicorn
from uvicorn.protocols.http.h11_impl import H11Protocol

from swifttailor.errors import InputError
from swifttailor.studio.app.application import make_application
from swifttailor.studio.app.guard import LOOPBACK
from swifttailor.studio.app.limits import ServerLimits

USUAL_PORT = 8765
_CLOSING_SECONDS = 5


def open_socket(host: str, port: int | None) -> socket.socket:
    """A socket that listens.

    Args:
        host: Address or name to bind to.
        port: 0 for any that is free; None for the usual one, or any where that is taken.

    Raises:
        InputError: There is no such address, or the port is taken.
    """
    tried = [USUAL_PORT, 0] if port is None else [port]
    for number in tried:
        try:
            found = socket.getaddrinfo(host, number, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)
            family, kind, protocol, _, address = found[0]
            listening = socket.socket(family, kind, protocol)
        except OSError as error:
            raise InputError(f"--host is '{host}', which is no address of this machine: {error}.") from error
        try:
            listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            listening.bind(address)
            listening.listen(128)
        except OSError as error:
            listening.close()
            if error.errno == errno.EADDRINUSE and number != tried[-1]:
                continue
            raise InputError(
                f"Cannot listen on {host}, port {number}: {error.strerror or error}. "
                "Choose another --port, or leave it out."
            ) from error
        return listening
    raise AssertionError("the last port was tried")


def is_loopback(host: str) -> bool:
    """Whether only this machine can reach an address."""
    return host in LOOPBACK


def address_of(listening: socket.socket, host: str, token: str | None) -> str:
    """What to open in a browser; the token stands in the fragment, which browsers send nowhere."""
    port = listening.getsockname()[1]
    shown = {"::1": "[::1]", "0.0.0.0": socket.gethostname(), "::": socket.gethostname()}.get(host, host)
    return f"http://{shown}:{port}/" + ("" if token is None else f"#token={token}")


def serve(
    listening: socket.socket,
    *,
    host: str,
    projects: Path,
    token: str | None,
    started: Callable[[], None],
    limits: ServerLimits | None = None,
) -> None:
    """Serves until it is interrupted.

    Args:
        listening: Of `open_socket`.
        host: That it is bound to.
        projects: Folder of the projects.
        token: That requests must carry.
        started: Called once the first page can be asked for.
        limits: What is refused beyond.
    """
    limits = limits or ServerLimits()
    hosts = LOOPBACK if is_loopback(host) else None
    app = make_application(projects, token=token, hosts=hosts, limits=limits)
    _WatchfulProtocol.seconds = limits.header_seconds
    config = uvicorn.Config(
        app,
        http=_WatchfulProtocol,
        ws="none",
        lifespan="on",
        log_config=None,
        log_level="warning",
        access_log=False,
        server_header=False,
        proxy_headers=False,
        limit_concurrency=limits.connections,
        timeout_keep_alive=int(limits.header_seconds),
        timeout_graceful_shutdown=_CLOSING_SECONDS,
        h11_max_incomplete_event_size=32 * 2**10,
    )
    _Server(config, started).run(sockets=[listening])


class _Server(uvicorn.Server):
    """Tells when it serves."""

    def __init__(self, config: uvicorn.Config, started: Callable[[], None]) -> None:
        super().__init__(config)
        self._tell = started

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        if self.started:
            self._tell()


class _WatchfulProtocol(H11Protocol):
    """Ends connections that send the head of a request so slowly that others might want their place."""

    seconds = 10.0

    def __init__(self, *arguments: Any, **named: Any) -> None:
        super().__init__(*arguments, **named)
        self._waits_since: float | None = None
        self._watch: asyncio.TimerHandle | None = None

    def connection_made(self, transport: Any) -> None:
        super().connection_made(transport)
        self._waits_since = self.loop.time()
        self._watch = self.loop.call_later(self.seconds, self._look)

    def connection_lost(self, exc: Exception | None) -> None:
        if self._watch is not None:
            self._watch.cancel()
        super().connection_lost(exc)

    def _look(self) -> None:
        now = self.loop.time()
        if self.cycle is not None and not self.cycle.response_complete:
            self._waits_since = None
        elif self._waits_since is None:
            self._waits_since = now
        elif now - self._waits_since >= self.seconds - 0.01:
            self.transport.close()
            return
        self._watch = self.loop.call_later(self.seconds / 2, self._look)
