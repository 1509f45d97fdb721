"""Claim: the reference cell's diagram, 66 wavevectors and 10 bands, within 0.2 %, takes a second.

Measured in processes of their own, from the study file on, imports not counted: the first diagram of a
process, which has index work to do that a topology needs once, and a later one, of a cell with another foot.
"""

from __future__ import annotations

import json
import sys
from dataclasses import replace

import numpy as np
from record import CORNERS, STUDY, apart, fresh, peak_memory, timed, true_error, write
from threadpoolctl import threadpool_limits

import haptonic
from haptonic.bloch import BlochModel, bloch_model
from haptonic.bloch.gaps import complete_gaps
from haptonic.bloch.settings import BandSettings
from haptonic.bloch.tracking import diagram
from haptonic.cell import UnitCell
from haptonic.lattice import Lattice


def reference_cell(lattice: Lattice | None = None) -> tuple[UnitCell, BandSettings]:
    study = haptonic.load(STUDY)
    return fresh(replace(study.cell, lattice=lattice or study.cell.lattice)), study.bands_settings


def frequencies_and_errors(lattice: Lattice | None = None) -> BlochModel:
    """From the study file to frequencies, errors and group velocities along the path."""
    return along_path(*reference_cell(lattice))


def along_path(cell: UnitCell, asked: BandSettings) -> BlochModel:
    """Compute frequencies, errors and group velocities along the path."""
    model = bloch_model(cell, asked)
    for kappa in cell.zone.path(asked.points).kappa:
        solution = model.solve(kappa)
        model.gradient(kappa, solution.values, solution.modes)
    return model


def measure() -> dict[str, float]:
    first, model = timed(frequencies_and_errors)
    later, model = timed(frequencies_and_errors, repeats=3)
    cell, asked = reference_cell()
    path = cell.zone.path(asked.points)
    tracked, _ = timed(lambda: diagram(model, path), repeats=3)
    # copies of the model have no samples yet
    searched, gaps = timed(lambda: complete_gaps(replace(model)), repeats=3)
    point = np.array([1.0, 0.3])
    one_more, _ = timed(lambda: model.solve(point), repeats=20)
    (gap,) = gaps
    at_corners = {name: model.solve(np.array(kappa)).frequency for name, kappa in CORNERS.items()}
    worst = [model.solve(kappa) for kappa in path.kappa]
    return {
        "first_s": first,
        "later_s": later,
        "branches_and_characters_s": tracked,
        "one_more_point_s": one_more,
        "gap_search_s": searched,
        "diagram_and_gap_s": later + searched,
        "true_error": true_error(at_corners),
        "largest_estimate": float(
            max((s.error[s.frequency > 1e3] / s.frequency[s.frequency > 1e3]).max() for s in worst)
        ),
        "order": model.resolution.order,
        "foot_rings": model.resolution.foot_rings,
        "unknowns": model.fine.tiling.meshes[0].unknowns,
        "gap_hz": [gap.lower, gap.upper],
        "gap_error_hz": [gap.lower_error, gap.upper_error],
        "gap_samples": gap.samples,
        "peak_memory_bytes": peak_memory(),
    }


def triangular() -> dict[str, float]:
    """The same of a triangular lattice of the same pillar, in turns with the square one."""
    lattice = Lattice.triangular(7e-3)
    for each in (None, lattice):  # what their topologies need once
        frequencies_and_errors(each)
    runs = [(timed(frequencies_and_errors), timed(lambda: frequencies_and_errors(lattice))) for _ in range(3)]
    model = runs[0][1][1]
    one_more, _ = timed(lambda: model.solve(np.array([1.0, 0.3])), repeats=20)
    errors = [
        model.solve(kappa).error / model.solve(kappa).frequency
        for kappa in model.cell.zone.path(66).kappa[1:-1]
    ]
    return {
        "square_s": min(square for (square, _), _ in runs),
        "later_s": min(own for _, (own, _) in runs),
        "one_more_point_s": one_more,
        "largest_estimate": float(max(error.max() for error in errors)),
        "unknowns": model.fine.tiling.meshes[0].unknowns,
    }


def whole_command() -> dict[str, float]:
    """All that `haptonic bands` computes: with branches, gaps, mode shapes and the count check."""
    from haptonic.bloch import bands_dataset

    cell, asked = reference_cell()

    def whole() -> None:
        bands_dataset(fresh(cell), asked)

    first, _ = timed(whole)
    later, _ = timed(whole, repeats=3)
    return {"first_s": first, "later_s": later, "peak_memory_bytes": peak_memory()}


MEASURED = {"measure": measure, "triangular": triangular, "whole_command": whole_command}

if __name__ == "__main__":
    if len(sys.argv) > 1:
        with threadpool_limits(1):  # as in the commands
            print(json.dumps(MEASURED[sys.argv[1]]()))
    else:
        write(
            "diagram_in_a_second",
            {name: apart(__file__, name) for name in MEASURED},
        )
