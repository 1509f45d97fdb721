"""HTML pages: each is one file with its pictures, style and program, without external parts."""

from __future__ import annotations

import base64
import re
from collections.abc import Callable
from dataclasses import dataclass
from importlib.resources import files
from typing import TYPE_CHECKING, Literal

from haptonic import plots
from haptonic.later import jinja2

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# spaces between a number and its unit or error
BREAKS = re.compile(r"(?<=\d) (?=(?:%|±|[kMG]?Hz|dB|[mµn]m|ms|[Nk]?V|mm/s)(?![A-Za-z]))|(?<=±) (?=\d)")


@dataclass(frozen=True, eq=False)
class Picture:
    """A figure with its caption and its alternative text.

    name : name for the findings of its chapter
    moving : returns the animated picture, as GIF
    number : in the order of the page
    """

    figure: Figure
    caption: str
    alternative: str
    name: str = ""
    moving: Callable[[], bytes] | None = None
    number: int = 0


def filled(template: str, **values: object) -> str:
    """Fill in a template of this folder; texts are escaped."""
    environment = jinja2.Environment(
        autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True,
        finalize=_unbroken,
    )  # fmt: skip
    environment.filters["embedded"] = embedded
    environment.filters["film"] = lambda content: address(content, "gif")
    text = files("haptonic.pages").joinpath(template).read_text("utf-8")
    return environment.from_string(text).render(**values)


def _unbroken(value: object) -> object:
    """A text whose numbers stay on one line with their units and errors; other values as they are."""
    return BREAKS.sub("\N{NO-BREAK SPACE}", value) if type(value) is str else value


def embedded(figure: Figure, kind: Literal["svg", "png"] = "svg") -> str:
    """The figure as a data URL."""
    return address(plots.rendered(figure, kind), "svg+xml" if kind == "svg" else kind)


def address(content: bytes, form: str) -> str:
    """A picture of this format as a data URL."""
    return f"data:image/{form};base64,{base64.b64encode(content).decode()}"
