"""What stands before the page: hosts, origins, the token, sizes, and headers for the browser.

A page on another site must neither read nor steer this server through somebody's browser, and a
server that others can reach wants a token. Nothing here knows what the page shows.
"""

import hashlib
import hmac
from collections.abc import Iterable
from dataclasses import dataclass
from http.cookies import SimpleCookie
from urllib.parse import parse_qs, urlsplit

from starlette.responses import PlainTextResponse, RedirectResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from starlette.websockets import WebSocketClose

LARGEST_BODY = 2_500_000
"""Bytes of a request; a scenario file needs a hundredth of it."""
LOOPBACK = frozenset({"localhost", "127.0.0.1", "::1"})
_HEADERS = {
    b"content-security-policy": (
        b"default-src 'self'; script-src 'self' 'unsafe-inline' 'unsafe-eval'; "
        b"style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; font-src 'self' data:; "
        b"object-src 'none'; base-uri 'none'; form-action 'self'; frame-ancestors 'none'"
    ),
    b"cross-origin-opener-policy": b"same-origin",
    b"cross-origin-resource-policy": b"same-origin",
    b"referrer-policy": b"no-referrer",
    b"x-content-type-options": b"nosniff",
    b"x-frame-options": b"DENY",
}
"""The framework compiles its templates in the browser, hence unsafe-eval; nothing is fetched from
elsewhere, so that even a script that came in could send nothing away."""
_DROPPED = b"x-forwarded-"


@dataclass(frozen=True, slots=True)
class Refusal:
    """A request that goes no further: its status and what is said about it."""

    status: int
    message: str

    async def answer(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Say so to who asked."""
        if scope["type"] == "websocket":
            await receive()
            await WebSocketClose(1008, self.message)(scope, receive, send)
        else:
            said = PlainTextResponse(self.message, self.status, {"connection": "close"})
            await said(scope, receive, send)


class Guard:
    """Lets through to ``app`` what may come through.

    A visitor must show the ``token`` once; it is None where only this machine can connect. Under
    ``cookie`` the browser keeps that it was shown; cookies of a host are shared by all its ports,
    so each server has its own.
    """

    def __init__(self, app: ASGIApp, token: str | None = None, cookie: str = "scegen_key") -> None:
        self._app = app
        self._cookie = cookie
        self._token = token
        self._proof = None if token is None else _digest(token)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """One request or connection."""
        if scope["type"] not in {"http", "websocket"}:
            await self._app(scope, receive, send)
            return
        headers = _headers(scope["headers"])
        bounded = _Bounded(receive, send)
        answer: ASGIApp = self._app
        if (refusal := self._refusal(scope, headers)) is not None:
            answer = refusal.answer
        elif self._shown(scope):
            # on to the page without the token in its address, which would stay in the history
            cookie = f"{self._cookie}={self._proof}; Path=/; HttpOnly; SameSite=Strict"
            answer = RedirectResponse("/", 303, {"set-cookie": cookie})
        kept = [pair for pair in scope["headers"] if not pair[0].startswith(_DROPPED)]
        await answer({**scope, "headers": kept}, bounded.receive, bounded.send)

    def _refusal(self, scope: Scope, headers: dict[str, str]) -> Refusal | None:
        host = headers.get("host", "")
        if self._token is None and _name(host) not in LOOPBACK:
            return Refusal(403, "This server answers to localhost only.")
        origin = headers.get("origin")
        if origin is not None and urlsplit(origin).netloc.lower() != host.lower():
            return Refusal(403, "Requests from other sites are refused.")
        crosses = headers.get("sec-fetch-site") == "cross-site"
        if crosses and headers.get("sec-fetch-mode") not in {"navigate", None}:
            return Refusal(403, "Requests from other sites are refused.")
        length = headers.get("content-length", "0")
        if not length.isdigit() or int(length) > LARGEST_BODY:
            limit = LARGEST_BODY / 1e6
            return Refusal(413, f"That is too large: at most {limit:.1f} MB are taken.")
        if self._proof is not None and not self._shown(scope):
            shown = SimpleCookie(headers.get("cookie", "")).get(self._cookie)
            if shown is None or not hmac.compare_digest(shown.value, self._proof):
                return Refusal(
                    401, "This page wants its token: open the address that scegen serve printed."
                )
        return None

    def _shown(self, scope: Scope) -> bool:
        """Whether the address itself holds the token."""
        if self._token is None or scope["type"] != "http":
            return False
        given = parse_qs(scope["query_string"].decode("latin-1")).get("token", [""])[0]
        return hmac.compare_digest(given.encode(), self._token.encode())


class _Bounded:
    """A connection of whose body no more is read than is taken, and whose answers are marked."""

    def __init__(self, receive: Receive, send: Send) -> None:
        self._receive, self._send = receive, send
        self._read = 0

    async def receive(self) -> Message:
        """The next part; a body that goes on for too long is as if the sender had gone."""
        message = await self._receive()
        if message["type"] == "http.request":
            self._read += len(message.get("body", b""))
            if self._read > LARGEST_BODY:
                return {"type": "http.disconnect"}
        return message

    async def send(self, message: Message) -> None:
        """The answer with the headers that bound what the browser does with it."""
        if message["type"] == "http.response.start":
            own = [(key, value) for key, value in message["headers"] if key not in _HEADERS]
            message = {**message, "headers": [*own, *_HEADERS.items()]}
        await self._send(message)


def _digest(token: str) -> str:
    return hashlib.sha256(b"scegen page " + token.encode()).hexdigest()


def _headers(raw: Iterable[tuple[bytes, bytes]]) -> dict[str, str]:
    return {key.decode("latin-1").lower(): value.decode("latin-1") for key, value in raw}


def _name(host: str) -> str:
    """A host without its port."""
    return (urlsplit(f"//{host}").hostname or "").lower()
