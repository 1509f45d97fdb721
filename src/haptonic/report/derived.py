"""Numbers that follow from a study and its results and that no single analysis gives.

References may compare with them, as with the answer of an analysis called "derived".
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from haptonic.cell.cantilever import euler_bernoulli
from haptonic.errors import HaptonicError
from haptonic.fields import leaves
from haptonic.later import elementwise
from haptonic.materials import IsotropicMaterial
from haptonic.names import listed
from haptonic.report.trend import FEWEST, fitted_power
from haptonic.study.schema import Description

WITHIN = 1e-3  # relative distance from an edge at which a band counts as reaching it, or the error if larger


def inputs_of(study: Description) -> dict[str, Any]:
    """Every input of a study by its key; a number of several by its key with ``[1]`` behind it."""
    return {path: value for path, value, _ in leaves(study, names=False)}


def derived(study: Description, answers: Mapping[str, Any]) -> dict[str, Any]:
    """Derived numbers by name; those that the study or its results do not give are left out.

    Parameters
    ----------
    answers : of the analyses by name, as JSON has them
    """
    return {
        **_of_pillar(study),
        **_of_waves(study),
        **_of_plate(study),
        "edges": _edges(answers.get("bands", {})),
        "optimum": _optima(study, answers.get("sweep", {})),
        "power": _powers(answers.get("bands", {}), answers.get("sweep", {})),
    }


def _of_pillar(study: Description) -> dict[str, Any]:
    """Factors of a clamped beam's frequencies, roots of cos x cosh x = -1 squared, and the pillar's."""
    starts = math.pi * np.array([0.5, 1.5, 2.5])

    def ends(x: Any) -> Any:
        return np.cos(x) + 1 / np.cosh(x)

    roots = elementwise.find_root(ends, (starts - 0.3, starts + 0.5)).x
    numbers: dict[str, Any] = {f"alpha_{n}": float(x**2) for n, x in enumerate(roots, start=1)}
    pillar, solid = study.cell.pillars[0], study.cell.material
    if pillar is not None and isinstance(solid, IsotropicMaterial):
        slender = euler_bernoulli(pillar, solid)
        numbers |= {f"pillar_alone_{n}_hz": float(f) for n, f in enumerate(slender, start=1)}
    return numbers


def _of_waves(study: Description) -> dict[str, Any]:
    """Speed of shear waves, and the period whose Bragg scattering would be at the carrier."""
    solid = study.cell.material
    if not isinstance(solid, IsotropicMaterial):
        return {}
    speed = math.sqrt(solid.youngs_modulus / (2 * (1 + solid.poisson_ratio) * solid.density))
    numbers = {"shear_speed_m_per_s": speed}
    if solid.loss_factor:
        numbers["quality_factor_of_material"] = 1 / solid.loss_factor
    if study.carrier is not None:
        numbers["bragg_period_m"] = speed / study.carrier
    return numbers


def _of_plate(study: Description) -> dict[str, Any]:
    if study.plate_settings is None:
        return {}
    try:
        layout = study.mounted_plate().layout
    except HaptonicError:  # such as lattice tiles without a pillar; the chapter of the plate gives the reason
        return {}
    return {"plate_width_m": layout.x[-1] - layout.x[0], "plate_length_m": layout.y[-1] - layout.y[0]}


def _edges(bands: Mapping[str, Any]) -> dict[str, str]:
    """Bands that reach each edge of the first complete gap at that edge's wavevector, as ``M7 and M8``."""
    gap = next((gap for gap in bands.get("gaps", ()) if gap["complete"]), None)
    if gap is None:
        return {}
    edges, table = {}, bands["bands"]
    for name in ("lower", "upper"):
        away = np.linalg.norm(np.array(table["kappa_rad"]) - gap[f"{name}_kappa"], axis=1)
        edge, row = gap[f"{name}_hz"], int(away.argmin())
        room = max(WITHIN * edge, 2 * gap[f"{name}_error_hz"])
        near = np.abs(np.array(table["frequency_hz"][row], dtype=float) - edge) <= room
        edges[name] = listed([f"M{table['band'][k]}" for k in np.flatnonzero(near)])
    return edges


def _along_one(sweeps: Mapping[str, Any]) -> list[dict[str, Any]]:
    """The sweeps along a single expression, of which an optimum or a power can be found."""
    return [sweep for sweep in sweeps.get("sweeps", ()) if "second_vary" not in sweep]


def _optima(study: Description, sweeps: Mapping[str, Any]) -> dict[str, Any]:
    """By swept expression the value whose gap has the widest margin around the carrier, and half a step."""
    optima = {}
    for sweep in _along_one(sweeps):
        margins = [
            (min(study.carrier - gap["lower_hz"], gap["upper_hz"] - study.carrier), design["value"])
            for design in sweep["designs"] for gap in design["gaps"]
        ] if study.carrier else []  # fmt: skip
        if margins and max(margins)[0] > 0:
            values = [design["value"] for design in sweep["designs"]]
            optima[sweep["vary"]] = {"value": max(margins)[1], "error": 0.5 * abs(values[1] - values[0])}
    return optima


def _powers(bands: Mapping[str, Any], sweeps: Mapping[str, Any]) -> dict[str, Any]:
    """By swept expression the power of it that the upper edge of the study's gap follows, and its error."""
    gap = next((gap for gap in bands.get("gaps", ()) if gap["complete"]), None)
    if gap is None:
        return {}
    powers = {}
    for sweep in _along_one(sweeps):
        points = [
            (design["value"], edge["upper_hz"])
            for design in sweep["designs"]
            for edge in design["gaps"]
            if edge["between"] == gap["between"]
        ]
        if len(points) >= FEWEST and min(value for value, _ in points) > 0:
            fit = fitted_power(*np.array(points).T)
            powers[sweep["vary"]] = {"exponent": fit.exponent, "error": fit.error}
    return powers
