"""Settings of lattice analyses: bands, rows as a mirror, and a waveguide between two such mirrors."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from haptonic.bloch.mesh_levels import LARGEST_BUDGET, starting_level
from haptonic.bloch.resolution import LEAST_ORDER, LEVELS, Resolution
from haptonic.cell.directed import DirectionSettings
from haptonic.errors import StudyError
from haptonic.fields import (
    TOP,
    Aliases,
    Frequency,
    Length,
    Quantity,
    absent,
    ascending,
    described,
    meant,
    setting,
)
from haptonic.units import format_quantity

LOWEST, HIGHEST = 0.6, 1.4  # of the carrier: default ends of a spectrum
OF_INCIDENCE = Quantity("rad", above=-0.5 * math.pi, below=0.5 * math.pi, typical=(-1.5, 1.5))
COARSEST = 0.1  # accuracy: less exact bands give no information on gaps
BUDGET = Quantity("s", at_least=1.0, at_most=LARGEST_BUDGET, typical=(10.0, 86400.0))


@described("mesh")
class MeshSettings:
    """Mesh settings for experts; by default ``bands.accuracy`` selects the mesh."""

    order: Annotated[int, Field(ge=LEAST_ORDER, le=10, strict=True)] | None = setting(
        None,
        "Polynomial order of elements that span a quarter turn. Shorter ones have a lower order; long ones, "
        "and those for many bands, a higher one.",
        title="Element order",
    )
    foot_rings: Annotated[int, Field(ge=0, le=6, strict=True)] | None = setting(
        None, "Refinements on either side of the pillar's foot.", title="Rings at the foot"
    )


@described("bands")
class BandSettings:
    """Number of bands, wavevectors and accuracy."""

    aliases: ClassVar[Aliases] = {
        **meant("count", "n", "number", "bands", "modes", "nbands", "num_bands", "n_bands"),
        **meant("points", "kpoints", "k_points", "nk", "n_k", "resolution", "wavevectors", "steps"),
        **meant("accuracy", "tolerance", "tol", "error", "precision"),
        **absent(
            "path",
            "k_path",
            cause="the path along the irreducible zone follows from the lattice",
            next_step='leave it out; `haptonic bands STUDY --modes-at "1, 0.5"` shows modes at a wavevector',
        ),
    }

    count: Annotated[int, Field(ge=1, le=60, strict=True)] = setting(
        10, "Bands are counted from the lowest.", title="Number of bands"
    )
    points: Annotated[int, Field(ge=8, le=10_000, strict=True)] = setting(
        66, "Number of wavevectors along the edge of the irreducible zone.", title="Wavevectors"
    )
    accuracy: Annotated[float, Quantity("", at_least=1e-6, at_most=COARSEST, typical=(1e-5, 0.05))] = setting(
        2e-3, "Allowed relative error of every frequency up to the last band."
    )
    mesh: Annotated[MeshSettings, TOP] = setting(
        MeshSettings(), "Mesh for experts; by default the accuracy determines it."
    )
    budget: Annotated[float, BUDGET] = setting(
        600.0, "Estimated processor time for the meshes of a cell; a mesh beyond it is not started."
    )

    @property
    def resolution(self) -> Resolution | None:
        """Resolution from the mesh settings, completed for the accuracy; None without mesh settings."""
        order, rings = self.mesh.order, self.mesh.foot_rings
        if order is None and rings is None:
            return None
        level = LEVELS[starting_level(self.accuracy)]
        return Resolution(
            level.order if order is None else order,
            level.foot_rings if rings is None else rings,
            level.steps,
            level.block,
        )


@described("layers", kw_only=True)
class LayersSettings(DirectionSettings):
    """Settings of a mirror of several rows of cells between two plates."""

    count: Annotated[int, Field(ge=1, le=20, strict=True)] = setting(
        6, "Largest number of rows; all smaller numbers are computed too.", title="Rows"
    )
    lowest: Frequency | None = setting(
        None, f"Start of the spectrum; by default {LOWEST:g} of the carrier.", title="Lowest frequency"
    )
    highest: Frequency | None = setting(
        None, f"End of the spectrum; by default {HIGHEST:g} of the carrier.", title="Highest frequency"
    )
    points: Annotated[int, Field(ge=2, le=5000, strict=True)] = setting(
        161, "Number of frequencies in the spectrum, both ends included.", title="Frequencies"
    )
    angle: Annotated[float, OF_INCIDENCE] = setting(
        0.0,
        "Angle between the incident wave and the normal of the rows, positive towards their direction.",
        title="Angle of incidence",
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        ascending(self.lowest, self.highest, "spectrum")

    def frequencies(self, carrier: float) -> NDArray[np.float64]:
        """(points,) frequencies of the spectrum around a carrier, Hz.

        Raises
        ------
        StudyError : the given end lies beyond the default of the other end
        """
        low, high = self.lowest or LOWEST * carrier, self.highest or HIGHEST * carrier
        if low >= high:
            raise StudyError.conflict(
                argument="layers.lowest",
                given=format_quantity(low, "Hz"),
                allowed=f"less than the highest frequency, {format_quantity(high, 'Hz')}",
                cause="only one end of the spectrum was given, beyond the other's default",
                next_step="give both layers.lowest and layers.highest",
            )
        return np.linspace(low, high, self.points)


@described("waveguide", kw_only=True)
class WaveguideSettings(DirectionSettings):
    """Settings of a strip of plain plate between two mirrors."""

    mode: str = setting(
        "0x17",
        "Nodal lines across the strip, and intervals between nodal lines along it.",
        pattern=r"^[0-9]{1,2}x[0-9]{1,3}$",
    )
    width: Length | None = setting(
        None, "Width of the plain strip; by default the one that puts the mode at the carrier."
    )
    rows: Annotated[int, Field(ge=1, le=1000, strict=True)] | None = setting(
        None, "Length of the strip; by default several are compared.", title="Length in cells"
    )
    ends: Literal["free", "mirror"] = setting(
        "free", "Ends of the strip: edges of the plate, or closed by the mirror as well."
    )

    @property
    def nodal_lines(self) -> tuple[int, int]:
        """Number of nodal lines across, and of intervals along."""
        across, along = self.mode.split("x")
        return int(across), int(along)
