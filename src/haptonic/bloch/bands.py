"""Bands, gaps and mode shapes of a cell as labelled datasets."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass

import numpy as np

from haptonic.arrays import Array
from haptonic.bloch.candidates import best_model, candidate_models
from haptonic.bloch.character import NAMES
from haptonic.bloch.gap_datasets import dataset_of_gaps
from haptonic.bloch.gaps import Gap, complete_gaps, listed_gaps
from haptonic.bloch.mesh_levels import Lack
from haptonic.bloch.model import BlochModel, Solution
from haptonic.bloch.path_modes import path_modes
from haptonic.bloch.pencil import Periodic
from haptonic.bloch.settings import BandSettings
from haptonic.bloch.shapes import mode_shapes
from haptonic.bloch.symmetry import MIDDLE, WAVES
from haptonic.bloch.tracking import (
    STILL,
    VELOCITY_ERROR,
    Diagram,
    diagram,
    group_velocity_error,
    solved,
)
from haptonic.bloch.wavevectors import wavevector_at
from haptonic.bloch.zone import ZoneModes, zone_surface
from haptonic.brillouin import IrreducibleZone, Path
from haptonic.cell import UnitCell
from haptonic.cell.scales import scales
from haptonic.gate import declared, describe, titled
from haptonic.later import xarray as xr
from haptonic.lattice import Lattice
from haptonic.parallel import one_thread
from haptonic.superelement import whole_mesh

SURFACE_DIVISIONS = 24  # of the irreducible zone's sides, for contours and the density of states
APART = 3.0  # margin of counts, as a multiple of the estimated distance of a band to the lower orders
CLOSE_ABOVE = "less accurate bands lie close above the last one; set a larger count in [bands]"
LEAST_COUNTED = 2  # order of a model up to which counts use its own mesh: the next is too coarse for them


@one_thread()
def bands_dataset(
    cell: UnitCell,
    settings: BandSettings,
    *,
    surface: bool = False,
    modes_at: str | None = None,
    moving: bool = False,
    also: Sequence[float] = (),
    zone: IrreducibleZone | None = None,
    first: Callable[[xr.Dataset], object] | None = None,
) -> xr.Dataset:
    """Band diagram, gaps and mode shapes of a cell.

    Parameters
    ----------
    surface : also sample the whole zone evenly, for contours and the density of states; with ``moving``, also
        the modes there
    modes_at : wavevector of the mode shapes, see `haptonic.bloch.wavevectors`; by default the middle of the
        path's second segment
    moving : also the surface of the cell in every mode of the diagram, see `haptonic.bloch.path_modes`
    also : positions of further wavevectors on the path, see `IrreducibleZone.path`
    zone : zone whose edge is the path, such as that of a cell of less symmetry; by default the cell's own
    first : called with the frequencies and their errors as soon as a model is accurate along the path, and
        again with the complete gaps, before anything else is computed

    Returns
    -------
    dataset with dimensions ``wavevector``, ``band``, ``axis``, ``gap``, ``mode``, ``node``, ...; every
    variable has its unit in ``units``

    Raises
    ------
    ResourceError : the coarsest mesh exceeds the budget or the memory; if some meshes fit and none reaches
        the accuracy, the best result is returned: see `BestModel.attributes`
    """
    zone = zone or cell.zone
    path = zone.path(settings.points, also)  # first, because it refuses too few points
    early = None if first is None else _FirstCurves(cell, settings, path, first)
    best = best_model(cell, settings, tried=early.solve if early else None)
    model = best.model
    kappa, name = wavevector_at(zone, modes_at or f"{path.labels[1]}-{path.labels[2]}")
    gaps = complete_gaps(model)
    solutions = solved(model, path) if early is None else early.with_gaps(model, gaps)

    def parts_along_path() -> list[xr.Dataset]:
        along = diagram(model, path, solutions)
        parts = [_diagram_dataset(along), dataset_of_gaps(listed_gaps(model, along, gaps))]
        of_zone: ZoneModes | None = None
        if surface:
            over = zone_surface(model, SURFACE_DIVISIONS)
            parts.append(over.dataset())
            if moving:
                of_zone = ZoneModes.of(model, over.kappa)
                parts.append(of_zone.dataset())
        parts += [path_modes(model, along, of_zone), _velocity_errors(model, solutions)] if moving else []
        return parts

    # the counts use a separate mesh; with the shapes, they take about as long as the rest
    with ThreadPoolExecutor(1) as aside:
        showing = aside.submit(parts_along_path)
        levels = [gap.centre for gap in gaps] or [float(showing.result()[0]["frequency"][:, -1].min())]
        checked, missed = count_check(model, levels)
        shapes = mode_shapes(model, kappa)
        dataset = xr.merge([*showing.result(), shapes])
    tiling = model.fine.tiling
    dataset.attrs = {
        "mesh": _mesh_attribute(model),
        "element_grids": json.dumps([grid for mesh in tiling.meshes for grid in mesh.grids()]),
        "unknowns": sum(mesh.unknowns for mesh in tiling.meshes),
        "condensed_unknowns": tiling.size,
        "basis_size": model.fine.pencil.size,
        "projection_error": model.fine.projection_error,
        "counts_checked": checked,
        "counts_missed": missed,
        "lattice": json.dumps(asdict(cell.lattice.named)),
        "point_group": json.dumps(cell.point_group.operations),
        "zone": json.dumps(zone.corners),
        "path_labels": json.dumps(path.labels),
        "path_corners": json.dumps(path.corners),
        "modes_at": name,
        "character_names": json.dumps(NAMES),
        **scales(cell),
        **best.attributes(
            settings, max(model.worst_error, _largest_error(dataset, model.rest)), ("bands", CLOSE_ABOVE)
        ),
    }
    return dataset


@dataclass
class _FirstCurves:
    """Curves along the path that are reported before the rest of a result; see `bands_dataset`."""

    cell: UnitCell
    settings: BandSettings
    path: Path
    report: Callable[[xr.Dataset], object]
    _solved: tuple[BlochModel, list[Solution]] | None = None  # the last model

    def solve(self, model: BlochModel) -> list[Solution]:
        """Solve along the path; report the curves if they are as accurate as the settings demand."""
        solutions = solved(model, self.path)
        self._solved = model, solutions
        curves = self._curves(solutions)
        if self.settings.resolution or _largest_error(curves, model.rest) <= self.settings.accuracy:
            self.report(curves)
        return solutions

    def with_gaps(self, model: BlochModel, gaps: tuple[Gap, ...]) -> list[Solution]:
        """Report the curves of the best model with its gaps; returns the solutions along the path."""
        assert self._solved is not None, "the best model is one of those that were tried"
        latest, solutions = self._solved
        if latest is not model:  # a finer one was no better
            solutions = solved(model, self.path)
        self.report(xr.merge([self._curves(solutions), dataset_of_gaps(gaps)]))
        return solutions

    def _curves(self, solutions: Sequence[Solution]) -> xr.Dataset:
        count = self.settings.count
        frequency, error = (
            np.stack([getattr(solution, name)[:count] for solution in solutions])
            for name in ("frequency", "error")
        )
        return _curves_dataset(self.path, frequency, error).assign_attrs(scales(self.cell))


def _largest_error(dataset: xr.Dataset, rest: float) -> float:
    """Largest relative error of the diagram, without modes below a frequency (Hz), see `BlochModel.rest`."""
    frequency = dataset["frequency"].values
    moving = frequency > rest
    return float((dataset["frequency_error"].values[moving] / frequency[moving]).max())


@one_thread()
def gaps_dataset(cell: UnitCell, settings: BandSettings, *, above: int | None = None) -> xr.Dataset:
    """Compute only the complete gaps of a cell, for one design of a sweep.

    Errors and attributes as in `bands_dataset`. The accuracy applies to the edges of gaps only; if ``above``
    is the number of a band, from 1, only to those of the gap above it.
    """
    model: BlochModel | None = None
    lack: Lack | None = None
    for candidate in candidate_models(cell, settings, gaps_only=True):
        if isinstance(candidate, Lack):
            lack = candidate
            break
        model, gaps = candidate, complete_gaps(candidate)
        matter = [gap for gap in gaps if above is None or gap.between[0] == above]
        if settings.resolution or all(gap.relative_error <= settings.accuracy for gap in matter):
            break
    assert model is not None, "the candidates contain neither a model nor an error"
    dataset = dataset_of_gaps(gaps)
    wavevectors, _ = cell.zone.triangles(2)
    lowest = min(float(model.frequencies(kappa)[-1]) for kappa in wavevectors)
    dataset["searched_up_to"] = (), lowest
    describe(
        dataset,
        {"searched_up_to": ("Hz", "lowest computed frequency of the last band; above it more bands exist")},
    )
    dataset.attrs = {"mesh": _mesh_attribute(model), "accuracy": settings.accuracy}
    if lack is not None:
        dataset.attrs |= {
            "largest_error": max(gap.relative_error for gap in matter),
            "budget_s": settings.budget,
            **lack.attributes(cell),
        }
    return dataset


def lattice_of(dataset: xr.Dataset) -> Lattice:
    """Read the lattice of a dataset of bands."""
    keys = {"form": "lattice", "period": "pitch"}  # fields with another name as a key
    values = {keys.get(name, name): value for name, value in json.loads(dataset.attrs["lattice"]).items()}
    return Lattice(**{key: value for key, value in values.items() if value is not None})


def mode_names(dataset: xr.Dataset) -> list[str]:
    """Names of the modes at the wavevector of the mode shapes, in order of frequency.

    If the middle plane of the plate is a mirror, they include the symmetry about it.
    """
    if "mode_name" not in dataset:
        return []
    names = json.loads(dataset.attrs["character_names"])
    modes = zip(dataset["mode_name"].values, dataset["mode_parity"].values, strict=True)
    return [names[int(number)] + (f", {WAVES[parity]}" if parity else "") for number, parity in modes]


def count_check(model: BlochModel, frequencies: list[float]) -> tuple[int, int]:
    """Compare the number of bands below some frequencies with an exact count in a mesh without reduction.

    The comparison is made at the corners of the irreducible zone and half-way between them. The orders of the
    mesh are one lower, because a count then takes a third of the time. A wavevector is skipped if a band may
    lie on different sides of the frequency in the two.

    Returns
    -------
    checked, missed : number of comparisons, and number of missing or excess bands
    """
    cell, resolution = model.cell, model.resolution
    lower = resolution.order > LEAST_COUNTED
    mesh = whole_mesh(cell, resolution.lowered(cell) if lower else resolution.plans(cell))
    periodic = Periodic.of_joint(mesh.joint)
    wavevectors, _ = cell.zone.triangles(2)
    checked = missed = 0
    for level in frequencies:
        dynamic = mesh.dynamic(2 * np.pi * level)
        matrix, clamped = dynamic.matrix, dynamic.below
        for kappa in wavevectors:
            solution = model.solve(kappa)
            apart = APART * model.to_lower_orders(solution) if lower else np.zeros(model.count)
            if (np.abs(solution.frequency - level) < solution.error + apart).any():
                continue
            folded = periodic.hermitian(matrix, kappa)
            exact = clamped + int((np.linalg.eigvalsh(folded) < 0).sum())
            computed = int((solution.frequency < level).sum())
            if computed < model.count or exact <= model.count:
                checked += 1
                missed += abs(exact - computed)
    return checked, missed


def _mesh_attribute(model: BlochModel) -> str:
    """Plans of the tiles as JSON text; for a single tile its plan."""
    plans = [asdict(plan) for plan in model.resolution.plans(model.cell)]
    return json.dumps(plans[0] if len(plans) == 1 else plans)


def _curves_dataset(path: Path, frequency: Array, error: Array) -> xr.Dataset:
    """Frequencies (wavevectors, bands) along a path and bounds of their errors, Hz."""
    of_modes = ("wavevector", "band")
    length = "arc length of the wavevector along the edge of the irreducible zone"
    dataset = titled({
        "distance": ("wavevector", path.distance, "rad/m", length),
        "frequency": (of_modes, frequency, "Hz", "frequency"),
        "frequency_error": (of_modes, error, "Hz", "bound of the frequency's error"),
    })  # fmt: skip
    return dataset.assign_coords(band=np.arange(1, frequency.shape[1] + 1))


def _diagram_dataset(along: Diagram) -> xr.Dataset:
    of_modes, curves = ("wavevector", "band"), _curves_dataset(along.path, along.frequency, along.error)
    dataset = xr.Dataset(
        {
            "kappa": (("wavevector", "axis"), along.path.kappa),
            **curves,
            "group_velocity": ((*of_modes, "axis"), along.velocity),
            "parity": (of_modes, along.parity),
            "middle_parity": (of_modes, along.middle),
            "corner_symmetry": (("path_corner", "band"), np.array(along.corner_symmetry).astype("U")),
            "branch": (of_modes, along.branch),
            "out_of_plane": (of_modes, along.vertical),
            "pillar_strain": (of_modes, along.pillar_strain),
            "pillar_kinetic": (of_modes, along.pillar_kinetic),
            "character": (of_modes, along.name),
        }
    )
    describe(dataset, {
        "kappa": ("rad", "phases k . a1 and k . a2"),
        "group_velocity": ("m/s", "group velocity along x and y; NaN for rigid-body motions"),
        "parity": ("1", "+1 even, -1 odd under the mirror of the segment, 0 without one"),
        "middle_parity": ("1", MIDDLE),
        "corner_symmetry": ("1", "behaviour under the mirrors of the corner's little group"),
        "branch": ("1", "number of the curve followed through crossings"),
        "out_of_plane": ("1", "share of kinetic energy in motion along z"),
        "pillar_strain": ("1", "share of strain energy in the pillar"),
        "pillar_kinetic": ("1", "share of kinetic energy in the pillar"),
        "character": ("1", "character, a position in character_names"),
    })  # fmt: skip
    return declared(dataset, group_velocity=STILL)


def _velocity_errors(model: BlochModel, solutions: Sequence[Solution]) -> xr.Dataset:
    """Errors of the group velocities of a diagram, for views that show single modes."""
    errors = [group_velocity_error(model, solution)[: model.count] for solution in solutions]
    variable = (("wavevector", "band"), np.array(errors), "m/s", VELOCITY_ERROR)
    return declared(titled({"group_velocity_error": variable}), group_velocity_error=STILL)
