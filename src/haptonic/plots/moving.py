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


def moments(count: int) -> list[complex]:
    """exp(i omega t) at evenly spaced moments of a cycle."""
    return [complex(turn) for turn in np.exp(2j * np.pi * np.arange(count) / count)]


def moving(figure: Figure, turned: Callable[[complex], object], frames: int = FRAMES) -> bytes:
    """A figure at evenly spaced moments of a cycle, as WebP.

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
    stream = io.BytesIO()
    milliseconds = round(1e3 * FRAME_SECONDS * FRAMES / frames)
    pictures[0].save(
        stream, format="WEBP", save_all=True, append_images=pictures[1:], duration=milliseconds, loop=0,
        quality=80,
    )  # fmt: skip
    return stream.getvalue()
