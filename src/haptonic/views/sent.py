"""A view as one HTML file that can be sent: its program, style and data inside, nothing from elsewhere."""

from __future__ import annotations

import base64
import hashlib
from pathlib import Path

from haptonic.pages import filled
from haptonic.views.packed import InteractiveView, compressed, header_of, packed, program


def sent_page(view: InteractiveView) -> str:
    """The page as text. It needs a browser of 2024 or later, and neither a server nor a network."""
    return packed_page(packed(view))


def packed_page(content: bytes) -> str:
    """The page of a packed view."""
    title = header_of(content)["title"]
    return filled("view.html", title=title, program=program(), digest=digest(), data=_coded(content))


def write_page(view: InteractiveView | None, path: Path) -> None:
    """Write the page of a result that has a view."""
    assert view is not None, "a page without a view"
    path.write_text(sent_page(view), "utf-8")


def digest() -> str:
    """SHA-256 of the program, as a content security policy contains it."""
    return base64.b64encode(hashlib.sha256(program().encode()).digest()).decode()


def embedded_data(view: InteractiveView) -> str:
    """The compressed view as text for a page."""
    return _coded(packed(view))


def _coded(content: bytes) -> str:
    return base64.b64encode(compressed(content)).decode()
