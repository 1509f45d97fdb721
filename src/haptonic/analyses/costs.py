"""Costs that several analyses share: meshes, the gaps of a cell, sizes of files.

The record of each analysis contains its own estimate. Numbers are processor seconds measured with the
templates on the machine of the benchmarks.
"""

from __future__ import annotations

from pathlib import Path

from haptonic import solvers
from haptonic.analyses.needs import meshes_of
from haptonic.errors import HaptonicError
from haptonic.results.cost import Cost
from haptonic.study.schema import Description

FIRST, SECOND = 0.8, 0.35  # shares of the estimate for a mesh; the second mesh is not always needed
ZONE = 0.2  # s, of the search for gaps


def meshes(study: Description, second: float = SECOND) -> Cost:
    """Estimated cost of the models of a cell: the first mesh, and a share of the next; or the refusal.

    The memory is that of the first mesh: the next is computed only if its memory is free.
    `haptonic.bloch.mesh_levels` selects the meshes, as in the computation; its estimates and the budget do
    not depend on the sparse solver, so that a study gives the same answer with each of them.
    """
    cell = study.cell
    try:
        resolutions = meshes_of(study)
    except HaptonicError as error:
        return Cost(0.0, refusal=error)
    seconds = FIRST * resolutions[0].seconds(cell) + second * sum(
        mesh.seconds(cell) for mesh in resolutions[1:]
    )
    seconds *= solvers.chosen().slower
    return Cost(seconds, resolutions[0].memory(cell), budget=study.bands_settings.budget)


def gaps(study: Description) -> Cost:
    """Estimated cost of the complete gaps of the study's cell; mostly the first mesh is fine enough."""
    return meshes(study, second=0.0) + Cost(ZONE)


def size_of(path: Path) -> int:
    """Size of a file, or of all files in a folder, bytes."""
    files = path.rglob("*") if path.is_dir() else [path]
    return sum(file.stat().st_size for file in files if file.is_file())
