"""Replies that several addresses share."""

from __future__ import annotations

from starlette.responses import PlainTextResponse, Response


def binary(content: bytes | None) -> Response:
    """Bytes for the program of the page; the reply for something missing without any."""
    return Response(content, media_type="application/octet-stream") if content else missing()


def download(name: str, content: bytes) -> Response:
    """A file that the browser saves and never shows as a page of the studio."""
    headers = {"content-disposition": f'attachment; filename="{name}"'}
    return Response(content, media_type="application/octet-stream", headers=headers)


def missing() -> Response:
    """The reply for something that a job does not have."""
    return PlainTextResponse("There is no such job, or no such part of it.", 404)
