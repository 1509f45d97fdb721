"""Checks of every request: a page of another site, or another user, must not talk to the studio."""

from __future__ import annotations

import secrets
from http.cookies import CookieError, SimpleCookie
from urllib.parse import parse_qs

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import HTMLResponse, PlainTextResponse, Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from haptonic.pages import filled

LARGEST_BODY = 3_000_000  # bytes; a study has at most one million, and JSON may double it
UPLOAD = "/api/upload"  # address that takes measured files
LARGEST_UPLOAD = 500_000_000  # bytes
READING = {"GET", "HEAD"}


class Guard:
    """Admits requests with the cookie of this start, from the pages of this server only.

    The link with ``token``, by default a new one, works once and gives the cookie.
    """

    def __init__(self, app: ASGIApp, port: int, token: str | None = None) -> None:
        self.app = app
        self.token = secrets.token_urlsafe(32) if token is None else token
        self._used = False
        self._secret = secrets.token_urlsafe(32)
        # browsers share cookies between the ports of a host
        self.cookie = f"haptonic-studio-{port}"
        self.hosts = (f"127.0.0.1:{port}", f"localhost:{port}")
        sockets = " ".join(f"ws://{host}" for host in self.hosts)
        self.headers = {
            "content-security-policy": "default-src 'self'; style-src 'self' 'unsafe-inline'; "
            f"img-src 'self' data: blob:; connect-src 'self' {sockets}; object-src 'none'; "
            "base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
            "x-content-type-options": "nosniff",
            "referrer-policy": "no-referrer",
            "cross-origin-opener-policy": "same-origin",
            "cross-origin-resource-policy": "same-origin",
            "cache-control": "no-store",
        }

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer, refuse or hand on a request."""
        if scope["type"] not in ("http", "websocket"):
            await self.app(scope, receive, send)
            return
        refusal = self._refusal(scope)
        if scope["type"] == "websocket":
            if refusal is not None:
                await send({"type": "websocket.close", "code": 1008})
                return
            await self.app(scope, receive, send)
            return
        answer = self.app if refusal is None else refusal
        await answer(scope, _limited(receive, largest_body(scope)), self._with_headers(send))

    def _refusal(self, scope: Scope) -> Response | None:
        """The answer to a request that is not handed on; None for one that is."""
        headers = Headers(scope=scope)
        host = headers.get("host", "")
        if host not in self.hosts:
            return PlainTextResponse("This server answers to its own address only.", 403)
        changes = scope["type"] == "websocket" or scope["method"] not in READING
        if changes and headers.get("origin") != f"http://{host}":
            return PlainTextResponse("The request comes from another site.", 403)
        largest = largest_body(scope)
        if int(length if (length := headers.get("content-length", "0")).isdigit() else 0) > largest:
            return PlainTextResponse(f"The request is larger than {largest} bytes.", 413)
        given = parse_qs(scope["query_string"].decode("latin-1")).get("token", [""])[0]
        if scope["path"] == "/" and not changes and self._opens(given):
            return self._admission()
        if not self._knows(headers):
            return HTMLResponse(filled("studio_refused.html"), 403)
        return None

    def _opens(self, token: str) -> bool:
        """True for the token of this start, the first time."""
        if self._used or not secrets.compare_digest(token.encode(), self.token.encode()):
            return False
        self._used = True
        return True

    def _admission(self) -> Response:
        """Give the cookie. The page then goes on by itself, because a browser that follows the link from
        another site would not send a strict cookie along with a redirection."""
        answer = HTMLResponse(filled("studio_admitted.html"))
        answer.set_cookie(self.cookie, self._secret, httponly=True, samesite="strict", path="/")
        return answer

    def _knows(self, headers: Headers) -> bool:
        try:
            morsel = SimpleCookie(headers.get("cookie", "")).get(self.cookie)
        except CookieError:
            return False
        return morsel is not None and secrets.compare_digest(morsel.value.encode(), self._secret.encode())

    def _with_headers(self, send: Send) -> Send:
        async def sent(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                for name, value in self.headers.items():
                    headers.setdefault(name, value)
            await send(message)

        return sent


class TooLargeError(Exception):
    """A body without a length in its head that exceeds the limit."""


def largest_body(scope: Scope) -> int:
    """Bytes that a request may have."""
    return LARGEST_UPLOAD if scope["path"] == UPLOAD else LARGEST_BODY


def _limited(receive: Receive, largest: int) -> Receive:
    size = 0

    async def received() -> Message:
        nonlocal size
        message = await receive()
        size += len(message.get("body", b""))
        if size > largest:
            raise TooLargeError
        return message

    return received
