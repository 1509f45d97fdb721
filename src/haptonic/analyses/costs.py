"""What forecasts of several analyses are made of: meshes, the gaps of a cell, a plate's response, files.

The record of an analysis has its own forecast. Numbers are processor seconds that the templates took, on the
machine of the benchmarks.
"""

from __future__ import annotations

from pathlib import Path

from haptonic.analyses.needs import fineness, meshes_of, tile_resolution
from haptonic.errors import HaptonicError
from haptonic.plate.forecast import Counted
from haptonic.plate.parts import Plate
from haptonic.plate.settings import ResponseSettings
from haptonic.results.cost import Cost
from haptonic.study.schema import Description

FIRST, SECOND = 0.5, 0.25  # of what meshes are foreseen to take at most: the second is not always needed
ZONE = 0.2  # s, of the search for gaps
# Of a file's cell as a tile of a plate, times the time of its bands: it keeps more of the interior. At orders
# 3 and 4 a drawn pillar took 25 and 85 s; for its bands 11 and 44 s are foreseen.
OF_SOLIDS = 2.1


def meshes(study: Description, second: float = SECOND) -> Cost:
    """Of the models of a cell: the first that is tried, and a share of the next; or why there is none.

    The decision is that of the computation, `haptonic.bloch.reach`.
    """
    cell = study.cell
    try:
        tried = meshes_of(study)
    except HaptonicError as error:
        return Cost(0.0, refusal=error)
    seconds = FIRST * tried[0].seconds(cell) + second * sum(one.seconds(cell) for one in tried[1:])
    return Cost(seconds, max(one.memory(cell) for one in tried), budget=study.bands_settings.budget)


def gaps(study: Description) -> Cost:
    """Of the complete gaps of the study's cell, for which the first mesh is mostly enough."""
    return meshes(study, second=0.0) + Cost(ZONE)


def response(study: Description, mounted: Plate, asked: ResponseSettings) -> Cost:
    """Of the study's plate."""
    chosen = fineness(study)
    counted = Counted.of(mounted, asked, chosen)
    whole = Cost(counted.seconds, counted.memory)
    for cell in mounted.layout.cells.values():
        if cell.solid is not None:
            mesh = tile_resolution(cell, chosen)
            whole += Cost(OF_SOLIDS * mesh.seconds(cell), mesh.memory(cell))
    return whole


def size_of(path: Path) -> int:
    """Of a file, or of all in a folder, bytes."""
    files = path.rglob("*") if path.is_dir() else [path]
    return sum(one.stat().st_size for one in files if one.is_file())
