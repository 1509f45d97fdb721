"""A preview at a value, as the page draws it, and its distance to certified bands relative to its bound."""

import numpy as np
from numpy.typing import NDArray

from haptonic.bloch.candidates import bloch_model
from haptonic.bloch.gaps import complete_gaps
from haptonic.bloch.model import BlochModel
from haptonic.bloch.settings import BandSettings
from haptonic.cell import UnitCell
from haptonic.later import xarray as xr
from quick import QUICK_CELL

REST = 1e-3  # share of the highest frequency; below it modes are at rest, and their errors are rounding
# errors of the quick cell are too large for previews
TURNED_CELL = QUICK_CELL.replace("order = 2\nfoot_rings = 0", "order = 3\nfoot_rings = 1")
Values = NDArray[np.float64]


def previewed(preview: xr.Dataset, name: str, value: float) -> tuple[Values, Values]:
    """Values and bounds of a variable, see `haptonic.design.preview.DesignLine.dataset`."""
    nodes = preview["value"].values
    after = int(np.clip(np.searchsorted(nodes, value), 1, len(nodes) - 1))
    apart = nodes[after] - nodes[after - 1]
    share = (value - nodes[after - 1]) / apart
    (v0, v1), (e0, e1), (b0, b1) = (
        preview[variable].values[after - 1 : after + 1]
        for variable in (name, f"{name}_error", f"{name}_bend")
    )
    bound = (1 - share) * e0 + share * e1 + (b0 + b1) * apart * share * (1 - share)
    return (1 - share) * v0 + share * v1, bound


def used_of_bound(preview: xr.Dataset, value: float, cell: UnitCell, settings: BandSettings) -> float:
    """Largest distance of a preview to the certified bands and gaps of a cell, as a share of its bound."""
    model: BlochModel = bloch_model(cell, settings)
    exact = np.array([model.frequencies(kappa) for kappa in cell.zone.path(settings.points).kappa])
    frequency, bound = previewed(preview, "frequency", value)
    moving = exact > REST * exact.max()
    worst = float((np.abs(frequency - exact) / bound)[moving].max())
    edges, bound = previewed(preview, "edge", value)
    for gap in complete_gaps(model):
        column = gap.between[0] - 1
        away = np.abs(edges[:, column] - [gap.lower, gap.upper]) / bound[:, column]
        worst = max(worst, float(away.max()))
    return worst
