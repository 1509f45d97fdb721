"""Options of all pictures: the look (paper, column, slide), legends, colours of curves."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from typing import Any

from haptonic.errors import HaptonicError, shown
from haptonic.later import colors  # stored pictures need no matplotlib

PICTURE_KINDS = ("svg", "png")  # file formats of a written picture


@dataclass(frozen=True)
class Look:
    """Size of a figure and of its type.

    width : of a whole figure, cm; type : points
    tall : height over that of a figure on a page; dots : of a PNG, per inch
    """

    width: float
    type: float
    tall: float
    dots: int


PAGE = Look(15.0, 9.0, 1.0, 200)  # type of 9 points is still 7 points when a picture is shrunk to 12 cm
LOOKS = {
    "plain": PAGE,
    "column": Look(8.5, 7.0, 0.68, 381),
    "wide": Look(18.0, 8.0, 1.0, 254),
    "slide": Look(24.0, 16.0, 1.5, 150),
}


@dataclass(frozen=True)
class AxisUnit:
    """Unit of the axes of one quantity. factor : SI units in one of it"""

    name: str
    factor: float


@dataclass
class Choice:
    """A look, whether legends are drawn, and colours of the curves.

    units : of axes by the SI unit of their quantity, "Hz" or "rad/m"; others have the usual ones
    coloured : whether a picture used the colours
    """

    look: Look = PAGE
    legend: bool = True
    colours: tuple[str, ...] = ()
    units: Mapping[str, AxisUnit] = field(default_factory=dict)
    coloured: bool = False


_CHOICE: ContextVar[Choice] = ContextVar("choice", default=Choice())  # noqa: B039  # see `chosen`


def choice() -> Choice:
    """Options of the picture that is being drawn."""
    return _CHOICE.get()


@contextmanager
def chosen(
    style: str | None = None,
    *,
    legend: bool = True,
    color: str | Sequence[str] | None = None,
    units: Mapping[str, AxisUnit] | None = None,
) -> Iterator[None]:
    """Draw the pictures of a block in one look.

    Parameters
    ----------
    style : "plain" for a page (150 mm, 9 points), "column" for one of two columns (85 mm, 7 points), "wide"
        for both (180 mm), "slide" (240 mm, 16 points); by default the look around the block
    legend : whether to explain curves and marks beside the axes
    color : of the curves in their order, one or several; the rest keep theirs
    units : of axes, see `Choice`

    Raises
    ------
    HaptonicError : no such style or colour, or a colour for a picture without curves
    """
    if style is not None and style not in LOOKS:
        raise HaptonicError.unknown("style", style, LOOKS, "the name is misspelt, or it is one of matplotlib")
    is_one = isinstance(color, str) or colors.is_color_like(color) or not isinstance(color, Sequence)
    colours: tuple[Any, ...] = () if color is None else (color,) if is_one else tuple(color)
    for name in colours:
        if not colors.is_color_like(name):
            raise HaptonicError.malformed(
                argument="color", given=shown(name), allowed='a colour of matplotlib, such as "#0072B2"',
                cause="the name is misspelt, or a map of colours", next_step='write color="black"',
            )  # fmt: skip
    chosen_options = Choice(
        look=LOOKS[style] if style else choice().look, legend=legend, colours=colours, units=units or {}
    )
    token = _CHOICE.set(chosen_options)
    try:
        yield
    finally:
        _CHOICE.reset(token)
    if colours and not chosen_options.coloured:
        raise HaptonicError.unsupported(
            argument="color", given=f"color={shown(color)}", allowed="color for pictures with curves",
            cause="this picture has no curves; its colours are those of a scale", next_step="leave color out",
        )  # fmt: skip


def colours(standard: Sequence[str]) -> list[str]:
    """Colours of curves in their order: those that were chosen, then the standard ones."""
    chosen_options = choice()
    chosen_options.coloured = chosen_options.coloured or bool(chosen_options.colours)
    return [*chosen_options.colours, *standard[len(chosen_options.colours) :]]
