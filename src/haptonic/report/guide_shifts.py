"""What moves the mode of the paper's waveguides: the same plate computed with one thing changed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import xarray as xr

from haptonic.materials import material
from haptonic.plate import Fineness, Plate
from haptonic.report import paper
from haptonic.results.plate.variants import COARSE, Look, mode_shifts, with_material
from haptonic.store import Store
from haptonic.study import Study

THICKER = 50e-6  # m, a common tolerance of rolled or milled sheet
NEAR = 0.92, 1.03  # of the paper's resonance, between which the mode is looked for
AS_IT_IS, DRIVEN = "without the patch", "with the patch on this guide"


def guide_shifts(study: Study, store: Store, told: Callable[[], None] = lambda: None) -> xr.Dataset:
    """Frequency of the mode `paper.GUIDE_MODE` in the driven guide of each variant of a study's plate."""
    plate, section = study.mounted_plate(), study.finite_plate
    assert section is not None
    region = section.actuator[0].region
    bare, usual = replace(plate, actuators=()), study.fineness()
    thicker = study.with_parameters({"cell.thickness": plate.layout.thickness + THICKER}).mounted_plate()
    plates: dict[str, tuple[Plate, Fineness | None]] = {
        AS_IT_IS: (bare, usual),
        DRIVEN: (plate, usual),
        "coarse mesh of quadratic elements": (bare, COARSE),
        "constants of aluminium 2017A": (with_material(bare, material("aluminium-2017a")), usual),
        f"plate thicker by {THICKER * 1e6:.0f} um": (replace(thicker, actuators=()), usual),
    }
    low, high = (share * paper.RESONANCE for share in NEAR)
    look = Look(low, high, paper.GUIDE_MODE, section.response.grid, section.response.tolerance)
    return mode_shifts(plates, region, look, store, study.inputs(), told)
