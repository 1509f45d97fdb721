"""A sheet in the paper space of a DXF document: dimensions, leaders and text, and views of its model space.

ezdxf draws the dimensions, the views and the picture, with two exceptions: it only estimates the width of a
text, so texts beside a dimension are placed here by their true width; and its pictures fill the outlines of
letters, so `_Pipeline` writes text instead, which can be searched in a PDF.
"""

from __future__ import annotations

import datetime
import math
import random
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import matplotlib as mpl
from ezdxf.addons.drawing.config import BackgroundPolicy, ColorPolicy, Configuration
from ezdxf.addons.drawing.frontend import UniversalFrontend
from ezdxf.addons.drawing.matplotlib import MatplotlibBackend
from ezdxf.addons.drawing.pipeline import RenderPipeline2d
from ezdxf.addons.drawing.properties import Properties, RenderContext
from ezdxf.document import Drawing
from ezdxf.enums import TextEntityAlignment
from ezdxf.fonts import fonts
from ezdxf.layouts import Paperspace
from ezdxf.math import Matrix44
from ezdxf.tools.text import MTextEditor
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from haptonic.arrays import Array
from haptonic.names import visible
from haptonic.plots.style import CENTIMETRE, drawn
from haptonic.workshop.dimensions import DECIMALS, decimals, style_of, text_of
from haptonic.workshop.shape import Dimension

A3 = (420.0, 297.0)  # mm, landscape
POINT = 25.4 / 72  # mm

SIZE = 2.5  # mm, height of capitals (ISO 3098)
SMALL = 1.8
CAPITAL = 0.729  # height of DejaVu Sans' capitals, in its size
ARROW = 2.6  # mm
GAP, BEYOND = 0.8, 1.5  # mm: distance of extension lines from their edge, and beyond the dimension line
LEG = 1.2  # mm, half the straight ends of the line to a number beside an edge
SHORT = 3 * ARROW  # mm; shorter dimension lines end in oblique strokes
SHELF = 2.0  # mm between a dimension line and its text
LISTED = 3.0  # heights of letters between the margin of a list and its text
APART = 6.0  # mm between labels
DESCENT = 1.0  # mm between a shelf and a text that may have letters with tails

SCALES = [step * 10.0**power for power in range(4, -4, -1) for step in (5, 2, 1)]  # ISO 5455

Place = tuple[float, float]  # mm on the paper
Box = tuple[float, float, float, float]  # left, bottom, right, top, mm
FONT = "DejaVuSans.ttf"  # included in matplotlib: the same picture on every machine
BOLD = "DejaVuSans-Bold.ttf"

# layer: line width in hundredths of a millimetre, and dashes and gaps (mm)
LAYERS: dict[str, tuple[int, tuple[float, ...]]] = {
    "OUTLINE": (50, ()),
    "THIN": (18, ()),
    "AXIS": (18, (8.0, -1.2, 0.6, -1.2)),
    "TOUCH": (50, (3.5, -0.8, 0.5, -0.8)),
    "CLAMPED": (70, ()),
    "SIMPLE SUPPORT": (70, (3.0, -1.2)),
    "ELASTIC FOUNDATION": (70, (0.7, -1.0)),
    "BREAK": (25, (6.0, -1.0, 0.6, -1.0, 0.6, -1.0)),
    "HATCH": (9, ()),
    "DIMENSION": (18, ()),
    "TEXT": (18, ()),
}


@dataclass(frozen=True)
class View:
    """Position of a body's origin on the paper (mm), and scale of the drawing."""

    origin: tuple[float, float]
    scale: float

    @classmethod
    def fitting(cls, width: float, height: float, box: Box, room: Box) -> View:
        """Largest standard scale that fits into a box with room around it; the origin is the lower middle."""
        across, up = box[2] - box[0] - room[0] - room[2], box[3] - box[1] - room[1] - room[3]
        scale = next((s for s in SCALES if s <= min(across / width, up / height)), SCALES[-1])
        return cls((box[0] + room[0] + 0.5 * across, box[1] + room[1] + 0.5 * (up - scale * height)), scale)

    def place(self, right: float, up: float) -> tuple[float, float]:
        """Point on the paper for a point of the body, in mm to the right of the origin and above it."""
        return self.origin[0] + self.scale * right, self.origin[1] + self.scale * up

    def __str__(self) -> str:
        return f"{self.scale:.0f} : 1" if self.scale >= 1 else f"1 : {1 / self.scale:g}"


@dataclass(frozen=True)
class Sheet:
    """The sheet of a document; the origin is its lower left corner, lengths are mm.

    title, date : of the drawing on it; without a date, the same drawing always gives the same file
    """

    document: Drawing
    space: Paperspace
    size: Place = A3
    title: str = ""
    date: datetime.date | None = None

    @classmethod
    def of(cls, document: Drawing, title: str = "", date: datetime.date | None = None) -> Sheet:
        """Make an empty sheet for a document, with its layers and styles."""
        if not fonts.font_manager.has_font(FONT) or not fonts.font_manager.has_font(BOLD):
            fonts.font_manager.scan_folder(Path(mpl.get_data_path()) / "fonts" / "ttf")
        document.styles.add("PLAIN", font=FONT)
        document.styles.add("BOLD", font=BOLD)
        for name, (width, dashes) in LAYERS.items():
            if dashes:
                document.linetypes.add(name, [sum(map(abs, dashes)), *dashes])
            document.layers.add(name, linetype=name if dashes else "Continuous", lineweight=width)
        document.dimstyles.add("SHEET", dxfattribs={
            "dimtxsty": "PLAIN", "dimtxt": SIZE, "dimasz": ARROW, "dimexe": BEYOND, "dimexo": GAP,
            "dimgap": 0.8, "dimtad": 1, "dimtih": 1, "dimtoh": 1, "dimtofl": 0, "dimcen": 0,
            "dimdsep": ord("."), "dimlwd": LAYERS["DIMENSION"][0], "dimlwe": LAYERS["DIMENSION"][0],
        })  # fmt: skip
        document.layouts.rename("Layout1", "Drawing")
        space = document.paperspace("Drawing")
        space.page_setup(size=A3, margins=(0, 0, 0, 0), units="mm")
        return cls(document=document, space=space, title=title, date=date)

    def line(self, points: Sequence[Place] | Array, layer: str = "OUTLINE", *, close: bool = False) -> None:
        places = [(float(x), float(y)) for x, y in points]
        if len(places) == 2:
            self.space.add_line(places[0], places[1], dxfattribs={"layer": layer})
        else:
            self.space.add_lwpolyline(places, close=close, dxfattribs={"layer": layer})

    def text(
        self,
        place: Place,
        text: str,
        size: float = SIZE,
        align: Literal["LEFT", "CENTER", "RIGHT"] = "LEFT",
        bold: bool = False,
    ) -> None:
        """Write one line of text with its baseline at ``place``."""
        style = {"layer": "TEXT", "style": "BOLD" if bold else "PLAIN"}
        entity = self.space.add_text(_literal(text), height=size, dxfattribs=style)
        entity.set_placement((float(place[0]), float(place[1])), align=TextEntityAlignment[align])

    def notes(self, place: Place, title: str, notes: Mapping[str, str], width: float) -> None:
        """Write a title and a list below and to the right of ``place``, with lines broken at ``width``.

        notes : notes by their numbers or letters
        """
        plain = [re.sub(r"([\\{}])", r"\\\1", _literal(note)) for note in notes.values()]
        text = MTextEditor(f"{title}\\P").bullet_list(
            indent=LISTED * SMALL, bullets=list(notes), content=plain
        )
        style = {"layer": "TEXT", "style": "PLAIN", "char_height": SMALL, "width": width, "insert": place}
        self.space.add_mtext(str(text), dxfattribs=style)

    def dimension(
        self,
        view: View,
        ends: tuple[Place, Place],
        line: float,
        number: Dimension,
        half_width: float | None = None,
        *,
        sign: str = "",
        upright: bool = False,
        shelf: Place | None = None,
    ) -> None:
        """Draw a dimension between two points, with its line at the height (``upright``: x) ``line``.

        Parameters
        ----------
        half_width : half-width of its tolerance, m or None
        sign : sign before the number, such as that of a diameter
        shelf : start of the shelf below the text, for a text that is not on the dimension line
        """
        (x0, y0), (x1, y1) = ((float(x), float(y)) for x, y in ends)
        override = {"dimlfac": 1 / view.scale, **style_of(number, half_width, sign)}
        if abs(y1 - y0 if upright else x1 - x0) < SHORT:
            override["dimtsz"] = ARROW / 3
        dimension = self.space.add_linear_dim(
            (line, line), (x0, y0), (x1, y1), angle=90 if upright else 0, dimstyle="SHEET",
            override=override, dxfattribs={"layer": "DIMENSION"},
        )  # fmt: skip
        if shelf is not None:
            middle = (line, 0.5 * (y0 + y1)) if upright else (0.5 * (x0 + x1), line)
            width = text_width(text_of(number, half_width, sign)) + 1
            width *= 1 if shelf[0] > middle[0] else -1
            dimension.set_location((shelf[0] + 0.5 * width, shelf[1] + DESCENT + 0.5 * SIZE))
            self.line([middle, shelf, (shelf[0] + width, shelf[1])], "DIMENSION")
        dimension.render()

    def ordinate(self, view: View, at: Place, end: Place, *, upright: bool = False) -> None:
        """Draw the distance of a point from the origin of a view along x (``upright``: y)."""
        x, y = (a - b for a, b in zip(end, at, strict=True))
        add = self.space.add_ordinate_y_dim if upright else self.space.add_ordinate_x_dim
        distance = (at[1] - view.origin[1] if upright else at[0] - view.origin[0]) / view.scale
        places = decimals(distance, DECIMALS)
        override = {"dimlfac": 1 / view.scale, "dimdec": places, "dimzin": 8, "dimtad": 0, "dimasz": LEG}
        add(
            at, (x, y), origin=view.origin, dimstyle="SHEET", override=override,
            dxfattribs={"layer": "DIMENSION"},
        ).render()  # fmt: skip

    def leader(self, tip: Place, label: Place, text: str, side: Literal[-1, 1]) -> None:
        """Write text on a shelf that begins at ``label``, with a line to an arrow at ``tip``."""
        end = (label[0] + side * text_width(text), label[1])
        look = {"layer": "DIMENSION"}
        self.space.add_leader([tip, label, end], dimstyle="SHEET", dxfattribs=look)
        self.text((min(label[0], end[0]), label[1] + DESCENT), text)

    def window(self, view: View, low: Place, high: Place) -> None:
        """Show the rectangle between two corners of model space, at a view's scale."""
        (left, bottom), (right, top) = view.place(*low), view.place(*high)
        window = self.space.add_viewport(
            (0.5 * (left + right), 0.5 * (bottom + top)), (right - left, top - bottom),
            (0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])), high[1] - low[1],
        )  # fmt: skip
        window.dxf.layer = "Defpoints"  # which is not plotted, so there is no border

    @drawn
    def figure(self) -> Figure:
        """The sheet as a picture, to scale."""
        figure = Figure(figsize=(self.size[0] * 0.1 * CENTIMETRE, self.size[1] * 0.1 * CENTIMETRE))
        axes = figure.add_axes((0, 0, 1, 1))
        settings = Configuration(
            color_policy=ColorPolicy.BLACK, background_policy=BackgroundPolicy.WHITE,
            lineweight_scaling=1 / POINT, min_lineweight=0.1,
        )  # fmt: skip
        state = random.getstate()
        random.seed(0)  # ezdxf moves the lines of a hatch at random, by a share of 1e-3
        try:
            UniversalFrontend(RenderContext(self.document), _Pipeline(axes), settings).draw_layout(self.space)
        finally:
            random.setstate(state)
        axes.set_xlim(0, self.size[0])
        axes.set_ylim(0, self.size[1])
        return figure


def text_width(text: str, size: float = SIZE, bold: bool = False) -> float:
    """Width of a text in mm."""
    return float(fonts.make_font(BOLD if bold else FONT, size).text_width(text))


def shortened(text: str, width: float, size: float, bold: bool = False) -> str:
    """A text cut so that it is at most ``width`` mm wide."""
    if text_width(text, size, bold) <= width:
        return text
    text = text[: int(4 * width / size)]  # every legible letter is wider than a quarter of its height
    while text and text_width(f"{text}…", size, bold) > width:
        text = text[:-1].rstrip()
    return f"{text}…"


def _literal(text: str) -> str:
    """One line in which a caret and two per cent signs, codes of DXF, are escaped."""
    line = visible(text).translate({ord("\t"): " ", ord("\n"): " ", ord("^"): "^ "}).replace("%%", "% %")
    return line + "\N{NO-BREAK SPACE}" * line.endswith("^ ")  # readers drop a caret at the end


class _Pipeline(RenderPipeline2d):
    """Pipeline that draws text as text."""

    def __init__(self, axes: Axes) -> None:
        super().__init__(MatplotlibBackend(axes, adjust_figure=False))
        self.axes = axes

    def draw_text(
        self, text: str, transform: Matrix44, properties: Properties, cap_height: float, dxftype: str = ""
    ) -> None:
        if not text.strip():
            return
        place, face = transform.origin, properties.font
        weight = "bold" if face and face.is_bold else "normal"
        along = transform.ux
        self.axes.text(
            place.x, place.y, text, fontsize=cap_height / CAPITAL / POINT, fontweight=weight,
            rotation=math.degrees(math.atan2(along.y, along.x)), rotation_mode="anchor",
            parse_math=False, zorder=1e6,
        )  # fmt: skip
