"""Who may ask: the studio's own pages on this machine, or who has the token; and how much at once."""

from __future__ import annotations

import asyncio
import hmac
import ipaddress
import socket
from collections.abc import Awaitable, Callable, MutableMapping
from http.cookies import CookieError, SimpleCookie
from typing import Any
from urllib.parse import urlsplit

from swifttailor.studio.app.answers import StudioError
from swifttailor.studio.app.limits import ServerLimits

Scope = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
Send = Callable[[MutableMapping[str, Any]], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]

COOKIE = "swifttailor-studio"
LOOPBACK = frozenset({"localhost", "127.0.0.1", "::1"})
_ACCEPTED = {
    "/api/files": frozenset({"image/png", "image/jpeg", "image/webp"}),
    "/api/bodies": frozenset({"application/octet-stream"}),
}
"""Types of what is sent as it is; all else is JSON."""
_SAFE = frozenset({"GET", "HEAD", "OPTIONS"})
CONTENT_SECURITY_POLICY = (
    "default-src 'self'; img-src 'self' blob: data:; style-src 'self' 'unsafe-inline'; connect-src 'self'; "
    "worker-src 'self' blob:; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
_HEADERS = (
    (b"content-security-policy", CONTENT_SECURITY_POLICY.encode()),
    (b"x-content-type-options", b"nosniff"),
    (b"x-frame-options", b"DENY"),
    (b"referrer-policy", b"no-referrer"),
    (b"cross-origin-opener-policy", b"same-origin"),
    (b"cross-origin-resource-policy", b"same-origin"),
    (b"permissions-policy", b"camera=(), microphone=(), geolocation=()"),
)


class Guard:
    """Stands before an application: refuses what is not meant for it, before anything of it is read."""

    def __init__(
        self, app: App, *, hosts: frozenset[str] | None, token: str | None, limits: ServerLimits
    ) -> None:
        """Puts it before an application.

        Args:
            app: What it lets through to.
            hosts: Names that requests may be addressed to; None where any address of this machine will do.
            token: That requests to the API must carry; None where none is needed.
            limits: Of bodies.
        """
        self._app, self._hosts, self._token, self._limits = app, hosts, token, limits

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Lets a request through, or answers it."""
        if scope["type"] != "http":
            if scope["type"] == "lifespan":
                await self._app(scope, receive, send)
            return  # there are no web sockets here

        async def with_headers(message: MutableMapping[str, Any]) -> None:
            if body.error is not None and not body.answered:
                return  # what an application says of a body that it could not read
            if message["type"] == "http.response.start":
                body.answered = True
                given = {name.lower() for name, _ in message["headers"]}
                message["headers"] = [*message["headers"], *((n, v) for n, v in _HEADERS if n not in given)]
                if b"cache-control" not in given:
                    message["headers"].append((b"cache-control", b"no-store"))
            await send(message)

        headers = {
            name.decode("latin-1").lower(): value.decode("latin-1") for name, value in scope["headers"]
        }
        body = _Body(receive, self._limits)
        try:
            self._look_at(scope, headers)
            if scope["method"] not in _SAFE:
                body.limit = self._most_bytes(scope["path"])
                body.refuse_announced(headers.get("content-length"))
            await self._app(scope, body.receive, with_headers)
        except StudioError as error:
            body.error = error
        if body.error is not None and not body.answered:
            answer = body.error.response()
            answer.headers["Connection"] = "close"  # what may still come of the request is not read
            body.error = None
            await answer(scope, receive, with_headers)

    def _look_at(self, scope: Scope, headers: dict[str, str]) -> None:
        self._require_host(headers.get("host", ""))
        path, method = scope["path"], scope["method"]
        if not path.startswith("/api"):
            return
        self._require_same_site(headers, method)
        if self._token is not None and not self._carries_token(headers):
            raise StudioError(
                401,
                "token-missing",
                "The token is missing or wrong.",
                "Open the address that the command printed.",
            )
        if method in ("POST", "PUT", "PATCH"):
            _require_type(path, headers)

    def _require_host(self, host: str) -> None:
        """A page of another name that is resolved to this machine gets nothing (DNS rebinding)."""
        name = _host_name(host)
        if self._hosts is not None and name in self._hosts:
            return
        if self._hosts is None and (name in LOOPBACK or _is_address(name) or name in _own_names()):
            return
        raise StudioError(
            421,
            "wrong-host",
            f"The studio does not answer to the name '{name[:100]}'.",
            "Use the address that was printed.",
        )

    def _require_same_site(self, headers: dict[str, str], method: str) -> None:
        site = headers.get("sec-fetch-site", "same-origin")
        origin = headers.get("origin")
        own = origin is None or (
            urlsplit(origin).netloc.lower() == headers.get("host", "").lower() and origin != "null"
        )
        if not own or site not in ("same-origin", "none"):
            raise StudioError(
                403, "other-site", "Requests of other sites are refused.", "Use the studio's own page."
            )

    def _carries_token(self, headers: dict[str, str]) -> bool:
        assert self._token is not None
        scheme, _, given = headers.get("authorization", "").partition(" ")
        if scheme.lower() == "bearer" and _equal(given.strip(), self._token):
            return True
        try:
            cookie = SimpleCookie(headers.get("cookie", "")).get(COOKIE)
        except CookieError:
            return False
        return cookie is not None and _equal(cookie.value, self._token)

    def _most_bytes(self, path: str) -> int:
        if path in _ACCEPTED:
            return self._limits.upload_bytes
        return self._limits.project_bytes if path.startswith("/api/projects") else self._limits.pattern_bytes


class _Body:
    """The body of a request, as it comes: not too much of it, and not too slowly."""

    def __init__(self, receive: Receive, limits: ServerLimits) -> None:
        self._receive, self._seconds = receive, limits.body_seconds
        self.limit = 0
        self.answered = False
        self.error: StudioError | None = None
        """Why the rest of it is not read."""
        self._taken = 0
        self._done = False
        self._deadline: float | None = None

    def refuse_announced(self, length: str | None) -> None:
        if length is not None and length.isdigit() and int(length) > self.limit:
            raise self._too_large()

    async def receive(self) -> MutableMapping[str, Any]:
        if self._done:
            return await self._receive()  # until the client goes
        loop = asyncio.get_running_loop()
        self._deadline = self._deadline or loop.time() + self._seconds
        try:
            async with asyncio.timeout_at(self._deadline):
                message = await self._receive()
        except TimeoutError:
            text = f"The body did not come within {self._seconds:g} s."
            self.error = StudioError(408, "too-slow", text, "Try again.")
            raise self.error from None
        if message["type"] == "http.request":
            self._taken += len(message.get("body", b""))
            self._done = not message.get("more_body", False)
            if self._taken > self.limit:
                self.error = self._too_large()
                raise self.error
        return message

    def _too_large(self) -> StudioError:
        return StudioError(
            413, "too-large", f"The request is larger than {self.limit / 2**20:g} MiB.", "Send less at once."
        )


def _require_type(path: str, headers: dict[str, str]) -> None:
    kind = headers.get("content-type", "").partition(";")[0].strip().lower()
    if path in _ACCEPTED:
        if kind not in _ACCEPTED[path]:
            raise StudioError(
                415,
                "wrong-type",
                f"The type '{kind[:60]}' is not accepted.",
                f"Accepted: {', '.join(sorted(_ACCEPTED[path]))}.",
            )
        return
    empty = headers.get("content-length", "0") == "0" and "transfer-encoding" not in headers
    if kind != "application/json" and not empty:
        raise StudioError(
            415, "wrong-type", f"The type '{kind[:60]}' is not accepted.", "Accepted: application/json."
        )


def _host_name(host: str) -> str:
    """Without the port, in lower case, and without brackets."""
    name = host.strip().lower()
    if name.startswith("["):
        return name[1:].partition("]")[0]
    return name.rpartition(":")[0] if name.rpartition(":")[2].isdigit() and ":" in name else name


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


def _own_names() -> frozenset[str]:
    name = socket.gethostname().lower()
    return frozenset({name, f"{name}.local"})


def _equal(given: str, token: str) -> bool:
    return hmac.compare_digest(given.encode("utf-8", "replace"), token.encode())
