"""A sheet in the paper space of a DXF document: lines, dimensions, leaders and text; and its picture.

ezdxf draws the dimensions (its DIMENSION entities keep what they measure and their tolerances) and the
picture. Three things stay ours. ezdxf guesses the width of a dimension's text, so the shelf under it would be
too long or too short: `_Measured` measures it. In its pictures text is filled outlines: `_Pipeline` writes it
as text, which can be searched in a PDF. And nothing there keeps labels apart: `Sheet.beside` does. Dimensions
are read from below (ISO 129-1, method 2), so that text needs no room along the line that it belongs to.
"""

from __future__ import annotations

import datetime
import random
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import matplotlib as mpl
import numpy as np
from ezdxf.addons.drawing.config import BackgroundPolicy, ColorPolicy, Configuration
from ezdxf.addons.drawing.frontend import UniversalFrontend
from ezdxf.addons.drawing.matplotlib import MatplotlibBackend
from ezdxf.addons.drawing.pipeline import RenderPipeline2d
from ezdxf.addons.drawing.properties import Properties, RenderContext
from ezdxf.document import Drawing
from ezdxf.enums import TextEntityAlignment
from ezdxf.fonts import fonts
from ezdxf.layouts import Paperspace
from ezdxf.math import Matrix44, Vec2
from ezdxf.render.dim_base import BaseDimensionRenderer
from ezdxf.render.dim_linear import LinearDimension
from ezdxf.render.dim_radius import RadiusDimension
from ezdxf.render.dimension import DimensionRenderer
from ezdxf.tools.text import MTextEditor
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from haptonic.arrays import Array
from haptonic.names import visible
from haptonic.plots.style import CENTIMETRE, drawn, spread

A4 = (297.0, 210.0)  # mm, landscape
A3 = (420.0, 297.0)
POINT = 25.4 / 72  # mm

SIZE = 2.5  # mm, height of capitals (ISO 3098)
SMALL = 1.8
CAPITAL = 0.729  # height of DejaVu Sans' capitals, in its size
ARROW = 2.6  # mm
GAP, BEYOND = 0.8, 1.5  # mm: extension lines begin and end so far from what they belong to
SHORT = 3 * ARROW  # mm; shorter dimension lines end in oblique strokes
SHELF = 2.0  # mm between a dimension line and its text
APART = 6.0  # mm between labels
DESCENT = 1.0  # mm between a shelf and a text that may have letters with tails

Place = tuple[float, float]  # mm on the paper
FONT = "DejaVuSans.ttf"  # comes with matplotlib: the same picture on every machine
BOLD = "DejaVuSans-Bold.ttf"

# layer: hundredths of a millimetre that its lines are wide, and dashes and gaps (mm)
LAYERS: dict[str, tuple[int, tuple[float, ...]]] = {
    "OUTLINE": (50, ()),
    "SEEN": (25, ()),
    "THIN": (18, ()),
    "HIDDEN": (25, (3.5, -1.5)),
    "AXIS": (18, (8.0, -1.2, 0.6, -1.2)),
    "TOUCH": (50, (3.5, -0.8, 0.5, -0.8)),
    "CLAMPED": (70, ()),
    "SIMPLE SUPPORT": (70, (3.0, -1.2)),
    "ELASTIC FOUNDATION": (70, (0.7, -1.0)),
    "PERIOD": (25, (6.0, -1.0, 0.6, -1.0, 0.6, -1.0)),
    "HATCH": (9, ()),
    "DIMENSION": (18, ()),
    "TEXT": (18, ()),
}


@dataclass(frozen=True)
class View:
    """Where on the paper (mm) the origin of a body lies, and how much larger it is drawn."""

    origin: tuple[float, float]
    scale: float

    def place(self, right: float, up: float) -> tuple[float, float]:
        """The point so far (mm of the body) to the right of the origin and above it."""
        return self.origin[0] + self.scale * right, self.origin[1] + self.scale * up

    def __str__(self) -> str:
        return f"{self.scale:g} : 1" if self.scale >= 1 else f"1 : {1 / self.scale:g}"


@dataclass(frozen=True)
class Sheet:
    """The sheet of a document; the origin is its lower left corner, lengths are mm.

    title, date : of the drawing on it; without a date, the same drawing is the same file at any time
    """

    document: Drawing
    space: Paperspace
    size: Place = A4
    title: str = ""
    date: datetime.date | None = None

    @classmethod
    def of(
        cls, document: Drawing, size: Place = A4, title: str = "", date: datetime.date | None = None
    ) -> Sheet:
        """An empty sheet for a document, with its layers and styles."""
        if not fonts.font_manager.has_font(FONT) or not fonts.font_manager.has_font(BOLD):
            fonts.font_manager.scan_folder(Path(mpl.get_data_path()) / "fonts" / "ttf")
        document.dimension_renderer = _Renderers()
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
        space.page_setup(size=size, margins=(0, 0, 0, 0), units="mm")
        return cls(document=document, space=space, size=size, title=title, date=date)

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
        """One line of text, its baseline at ``place``."""
        style = {"layer": "TEXT", "style": "BOLD" if bold else "PLAIN"}
        entity = self.space.add_text(_literal(text), height=size, dxfattribs=style)
        entity.set_placement((float(place[0]), float(place[1])), align=TextEntityAlignment[align])

    def notes(self, place: Place, notes: Sequence[str], width: float) -> None:
        """A numbered list below and to the right of ``place``, its lines broken at ``width``."""
        numbers = [str(1 + k) for k in range(len(notes))]
        plain = [re.sub(r"([\\{}])", r"\\\1", _literal(note)) for note in notes]
        text = MTextEditor("NOTES\\P").bullet_list(indent=3, bullets=numbers, content=plain)
        style = {"layer": "TEXT", "style": "PLAIN", "char_height": SMALL, "width": width, "insert": place}
        self.space.add_mtext(str(text), dxfattribs=style)

    def arrow(self, tip: Place, angle: float) -> None:
        """A head with its point at ``tip`` that flies in this direction, degrees."""
        self.space.add_arrow("", (float(tip[0]), float(tip[1])), ARROW, angle, {"layer": "DIMENSION"})

    def hatch(self, points: Array) -> None:
        """Fill what a line encloses as a section."""
        hatch = self.space.add_hatch(dxfattribs={"layer": "HATCH"})
        hatch.set_pattern_fill("ANSI31", scale=0.6)
        hatch.paths.add_polyline_path(points.tolist())

    def dimension(
        self,
        view: View,
        ends: tuple[Place, Place],
        line: float,
        style: Mapping[str, Any],
        *,
        upright: bool = False,
        shelf: Place | None = None,
    ) -> None:
        """Dimension between two places on the paper, its line at the height (``upright``: the x) ``line``.

        Parameters
        ----------
        style : what a DIMENSION entity sets apart from the sheet's own, such as its tolerance
        shelf : where that below the text begins, if the text does not stand on the dimension line
        """
        one, other = ((float(x), float(y)) for x, y in ends)
        override = {"dimlfac": 1 / view.scale, **style}
        if abs(other[upright] - one[upright]) < SHORT:
            override["dimtsz"] = ARROW / 3
        dimension = self.space.add_linear_dim(
            (line, line), one, other, angle=90 if upright else 0, dimstyle="SHEET", override=override,
            dxfattribs={"layer": "DIMENSION"},
        )  # fmt: skip
        if shelf is not None:
            dimension.set_location(shelf, leader=True)
        dimension.render()

    def radius(self, view: View, centre: Place, tip: Place, style: Mapping[str, Any], shelf: Place) -> None:
        """Radius of a hollow arc about ``centre``, shown at its point ``tip``, all on the paper."""
        dimension = self.space.add_radius_dim(
            centre, mpoint=tip, dimstyle="SHEET", dxfattribs={"layer": "DIMENSION"},
            override={"dimlfac": 1 / view.scale, "dimtmove": 2, **style},
        )  # fmt: skip
        dimension.user_location_override(shelf)
        dimension.render()

    def leader(self, tip: Place, label: Place, text: str, side: Literal[-1, 1]) -> None:
        """Text on a shelf that begins at ``label``, joined to ``tip`` by a line with an arrow there."""
        end = (label[0] + side * text_width(text), label[1])
        self.line([tip, label, end], "DIMENSION")
        away = np.asarray(tip, dtype=float) - label
        self.arrow(tip, float(np.degrees(np.arctan2(away[1], away[0]))))
        self.text((min(label[0], end[0]), label[1] + DESCENT), text)

    def window(
        self, view: View, centre: Place, size: Place, about: Place, without: Sequence[str] = ()
    ) -> None:
        """What lies ``about`` a place in model space, at a view's scale, ``without`` some layers."""
        window = self.space.add_viewport(centre, size, about, size[1] / view.scale)
        window.dxf.layer = "Defpoints"  # which is not plotted: no border
        window.frozen_layers = list(without)

    @staticmethod
    def beside(labels: Sequence[tuple[float, Callable[[float], None]]], low: float, high: float) -> None:
        """Draw labels at the heights that they would have best, moved apart where needed within bounds."""
        heights = spread([height for height, _ in labels], APART, low, high)
        for (_, draw), height in zip(labels, heights, strict=True):
            draw(height)

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
    text = text[: int(4 * width / size)]  # no letter that is read is narrower than a quarter of its height
    while text and text_width(f"{text}…", size, bold) > width:
        text = text[:-1].rstrip()
    return f"{text}…"


def _literal(text: str) -> str:
    """One line in which a caret and two per cent signs, codes of DXF, mean themselves."""
    line = visible(text).translate({ord("\t"): " ", ord("\n"): " ", ord("^"): "^ "}).replace("%%", "% %")
    return line + "\N{NO-BREAK SPACE}" * line.endswith("^ ")  # readers take a caret at the end away


class _Measured(BaseDimensionRenderer):
    """A dimension whose text is as wide as its font makes it; ezdxf takes letters for as wide as high."""

    def total_text_width(self) -> float:
        return text_width(f"{self.measurement.text}{self.tol.text}")


class _Linear(_Measured, LinearDimension):
    def get_text_location(self) -> Vec2:
        """The middle of the text; with a leader, the place asked for is where its shelf begins."""
        place = super().get_text_location()
        if not self.measurement.has_leader:
            return place
        side = 1 if place.x > self.dim_line_center.x else -1
        rise = 0.5 * self.measurement.text_height + 0.75 * self.measurement.text_gap
        return place + Vec2(0.5 * side * self._total_text_width, rise)


class _Radius(_Measured, RadiusDimension):
    pass


class _Renderers(DimensionRenderer):
    """Which of these classes draws a dimension; the arguments are ezdxf's."""

    def linear(self, *args: Any, **options: Any) -> LinearDimension:
        return _Linear(*args, **options)

    def radius(self, *args: Any, **options: Any) -> RadiusDimension:
        return _Radius(*args, **options)


class _Pipeline(RenderPipeline2d):
    """Draws text as text."""

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
        size = cap_height / CAPITAL / POINT
        self.axes.text(place.x, place.y, text, fontsize=size, fontweight=weight, parse_math=False, zorder=1e6)
