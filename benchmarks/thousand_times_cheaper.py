"""Claim: NGSolve needs a thousand times as long for the same diagram at the same accuracy.

Both run here, one after the other, on all cores. The peer makes its mesh once and solves wavevector by
wavevector; a few are timed and scaled to the 66 of the diagram. The error of both is the largest of bands 1
to 10 at the zone's corners, against the converged values of a third code.
"""

from __future__ import annotations

import sys

import ngsolve as ng
import numpy as np
from record import CORNERS, ROOT, STUDY, fresh, timed, true_error, write
from threadpoolctl import threadpool_limits

import haptonic
from haptonic.bloch import BlochModel, Resolution
from haptonic.materials import IsotropicMaterial

sys.path.insert(0, str(ROOT / "tests"))
from peers.ngsolve_cell import PeerCell, meshed

POINTS = 66
OURS = (Resolution(2, 1), Resolution(3, 1), Resolution(4, 1), Resolution(5, 1), Resolution(5, 2, 3))
THEIRS = (
    {"order": 2},
    {"order": 3},
    {"order": 3, "foot_layers": 2},
    {"order": 4},
)


def ours(resolution: Resolution) -> dict[str, float]:
    cell = haptonic.load(STUDY).cell
    path = cell.zone.path(POINTS).kappa

    def whole() -> BlochModel:
        model = BlochModel.of(fresh(cell), resolution, 10, measured=False)
        for kappa in path:
            model.solve(kappa)
        return model

    with threadpool_limits(1):  # as in the commands; symmetry classes use all cores
        whole()  # the index work of the topology
        seconds, model = timed(whole, repeats=3)
    at_corners = {name: model.solve(np.array(kappa)).frequency for name, kappa in CORNERS.items()}
    return {
        "order": resolution.order,
        "foot_rings": resolution.foot_rings,
        "unknowns": model.fine.tiling.meshes[0].unknowns,
        "diagram_s": seconds,
        "true_error": true_error(at_corners),
    }


def theirs(settings: dict[str, int]) -> dict[str, float]:
    study = haptonic.load(STUDY)
    cell, material = study.cell, study.cell.material
    assert cell.pillar is not None
    assert isinstance(material, IsotropicMaterial)
    peer = PeerCell(
        cell.lattice.pitch, cell.lattice.pitch, cell.thickness, cell.pillar.diameter, cell.pillar.height,
        material.youngs_modulus, material.poisson_ratio, material.density,
    )  # fmt: skip
    with ng.TaskManager():
        model = meshed(peer, **settings)
        model.solve(CORNERS["X"], 10)  # the first call loads libraries
        solutions = {name: model.solve(kappa, 10) for name, kappa in CORNERS.items()}
    per_point = float(np.mean([solution.seconds for solution in solutions.values()]))
    return {
        **settings,
        "unknowns": solutions["X"].unknowns,
        "mesh_s": model.mesh_seconds,
        "point_s": per_point,
        "timed_points": len(solutions),
        "diagram_s": model.mesh_seconds + POINTS * per_point,
        "true_error": true_error({name: s.frequencies for name, s in solutions.items()}),
    }


def seconds_at(rows: list[dict[str, float]], error: float) -> float:
    """Time at which a code reaches an error: a straight line between its runs, both in logarithms."""
    rows = sorted(rows, key=lambda row: row["true_error"])
    x, y = (np.log([row[name] for row in rows]) for name in ("true_error", "diagram_s"))
    return float(np.exp(np.interp(np.log(error), x, y)))


if __name__ == "__main__":
    own = [ours(resolution) for resolution in OURS]
    peer = [theirs(settings) for settings in THEIRS]
    # the accuracy of the product, and the best of the peer's runs
    compared = []
    for accuracy in (2e-3, min(row["true_error"] for row in peer)):
        times = {"haptonic": seconds_at(own, accuracy), "ngsolve": seconds_at(peer, accuracy)}
        compared.append(
            {"accuracy": accuracy, "diagram_s": times, "ratio": times["ngsolve"] / times["haptonic"]}
        )
    write(
        "thousand_times_cheaper",
        {
            "points": POINTS,
            "haptonic": own,
            "ngsolve": peer,
            "ngsolve_version": ng.__version__,
            "compared": compared,
        },
    )
