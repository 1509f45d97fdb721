"""Pictures that cost next to nothing, for commands of which files and words are asked."""

from __future__ import annotations

from pathlib import Path

import pytest
from matplotlib.figure import Figure


def leave_pictures_empty(patch: pytest.MonkeyPatch) -> dict[str, Figure]:
    """Pictures are drawn and named but neither arranged nor rendered, most of the work of a small question.

    What was drawn is given by name; pictures themselves are tried in ``tests/plots``.
    """
    drawn: dict[str, Figure] = {}

    def save(figure: Figure, folder: Path, name: str) -> None:
        drawn[name] = figure
        for kind in ("svg", "png"):
            (folder / f"{name}.{kind}").touch()

    patch.setattr("haptonic.plots.save", save)
    patch.setattr("haptonic.results.pictures.shown_by", lambda result: None)  # nor stored for others
    patch.setattr("haptonic.plots.style.arrange", lambda figure: None)
    patch.setattr("haptonic.plots.rendered", lambda figure, kind: b"<svg/>")  # in pages
    patch.setattr("haptonic.plots.mode_shapes", lambda dataset: Figure())  # painted as images
    for moving in ("animated", "moving_modes"):
        patch.setattr(f"haptonic.plots.{moving}", lambda *_, **__: b"")
    return drawn
