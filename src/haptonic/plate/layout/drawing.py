"""Lines and outlines of a plate for pages that draw it, as plain numbers in metres."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from haptonic.cell.stack import Feature
from haptonic.plate.layout.outline import held, outline
from haptonic.plate.layout.parts import Plate

AROUND = 24  # points of a curved outline, drawn a few pixels wide
DIGITS = ".6g"  # a millionth of the plate is below a pixel


def drawing_of(plate: Plate) -> dict[str, Any]:
    """Outlines of the plate, its regions, features, supports and patches.

    Returns
    -------
    ``plate``, ``regions`` (by name): closed lines of (x, y); ``features``: for each kind its ``outline``
    about the axis and the ``places`` (x, y) of the axes; ``held``: ends of every supported part of a side,
    with its ``hold``; ``patches`` (by name): centre and size along x and y
    """
    layout = plate.layout
    kinds: dict[Feature, list[tuple[float, float]]] = {}
    for x, y, feature in layout.features:
        kinds.setdefault(feature, []).append((x, y))
    return {
        "plate": [_rounded(loop) for loop in outline(layout, set(layout.there.values()))],
        "regions": {name: [_rounded(loop) for loop in outline(layout, {name})] for name in layout.regions},
        "features": [
            {
                "outline": _rounded(feature.broadest * feature.outline.polygon(AROUND)),
                "places": _rounded(places),
            }
            for feature, places in kinds.items()
        ],
        "held": [
            {"hold": support.hold, "ends": _rounded(ends)}
            for support in plate.supports
            for _, ends in held(layout, support)
        ],
        "patches": {patch.name: [*patch.centre, *patch.size[:2]] for patch in plate.actuators},
    }


def _rounded(points: Iterable[Iterable[float]]) -> list[list[float]]:
    return [[float(f"{value:{DIGITS}}") for value in point] for point in points]
