"""A view as one HTML file that can be sent: its program, style and data inside, nothing from elsewhere."""

from __future__ import annotations

import base64
import hashlib
import zlib
from importlib.resources import files

from haptonic.pages import filled
from haptonic.views.packed import InteractiveView, header_of, packed

PROGRAM = "sent.js"


def sent_page(view: InteractiveView) -> str:
    """The page as text. It needs a browser of 2023 or later, and neither a server nor a network."""
    return packed_page(packed(view))


def packed_page(view: bytes) -> str:
    """The page of a packed view."""
    program = files("haptonic.views").joinpath("bundle", PROGRAM).read_text("utf-8")
    digest = base64.b64encode(hashlib.sha256(program.encode()).digest()).decode()
    data = base64.b64encode(zlib.compress(view, 6)).decode()
    title = header_of(view)["title"]
    return filled("view.html", title=title, program=program, digest=digest, data=data)
