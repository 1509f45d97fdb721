"""Moving pictures: one cycle of a vibration, which repeats for ever."""

from __future__ import annotations

import io
from collections.abc import Callable

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from haptonic.plots import style

FRAMES = 24  # of a cycle
FRAME_SECONDS = 0.05
FRAME_DOTS = 160  # per inch
PALETTE = 4  # every fourth frame determines the colours


def moments(count: int) -> list[complex]:
    """exp(i omega t) at evenly spaced moments of a cycle."""
    return [complex(turn) for turn in np.exp(2j * np.pi * np.arange(count) / count)]


def moving(figure: Figure, turned: Callable[[complex], object], frames: int = FRAMES) -> bytes:
    """A figure at evenly spaced moments of a cycle, as GIF, which slides and browsers play.

    All frames share their 256 colours without dithering, so that what does not move does not flicker.

    Parameters
    ----------
    turned : changes the figure to the moment at which all has been multiplied by a number exp(i omega t)
    """
    style.arrange(figure)
    figure.set_layout_engine("none")  # every frame has the same arrangement
    figure.dpi = FRAME_DOTS
    canvas, pictures = FigureCanvasAgg(figure), []
    for turn in moments(frames):
        turned(turn)
        canvas.draw()  # type: ignore[no-untyped-call]
        pixels = np.asarray(canvas.buffer_rgba())  # type: ignore[no-untyped-call]
        pictures.append(Image.fromarray(pixels).convert("RGB"))
    palette = Image.fromarray(np.vstack([np.asarray(each) for each in pictures[::PALETTE]])).quantize(256)
    pictures = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    stream = io.BytesIO()
    milliseconds = round(1e3 * FRAME_SECONDS * FRAMES / frames)
    pictures[0].save(
        stream, format="GIF", save_all=True, append_images=pictures[1:], duration=milliseconds, loop=0
    )
    return stream.getvalue()
