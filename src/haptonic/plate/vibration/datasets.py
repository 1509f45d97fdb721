"""Datasets of a plate: frequency lines, modes, and the whole body at one line."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.later import xarray as xr
from haptonic.plate.body.model import PlateModel
from haptonic.plate.layout.keys import PLATE, PartKey
from haptonic.plate.layout.parts import Plate
from haptonic.plate.layout.sampling import reference_of
from haptonic.plate.vibration.modes import PlateModes, nodal_name
from haptonic.plate.vibration.reduced_plate import Vibration
from haptonic.plate.vibration.sweep import Band


def _by_part(plate: Plate, stored: Mapping[PartKey, Array], model: PlateModel) -> tuple[list[str], Array]:
    """Names of the parts of a plate, and (n, parts) energy stored in each.

    Names are such as "region WG1", "lattice bulk", and "actuator A1" with its bond.
    """
    layout, blocks = plate.layout, model.assembly.skeleton.blocks
    names = [layout.at(block.tiles[0]) for block in blocks]
    shares = {}
    for name in dict.fromkeys(name for name in names if name is not None):
        there = [number for number, other in enumerate(names) if other == name]
        shares[part_name(plate, name)] = stored[PLATE][:, there].sum(axis=1)
    for actuator in plate.actuators:
        of_parts = [values.sum(axis=1) for part, values in stored.items()
               if (part.kind, part.owner) == ("actuator", actuator.name)]  # fmt: skip
        shares[f"actuator {actuator.name}"] = sum(of_parts, np.zeros(len(stored[PLATE])))
    return list(shares), np.stack(list(shares.values()), axis=-1)


def part_name(plate: Plate, tile: str) -> str:
    """Name of a region or a lattice on the dimension ``part``, with its kind as the first word.

    The lattice of the study's cell has this word as its name.
    """
    if tile not in plate.layout.cells:
        return f"region {tile}"
    return tile if tile == "lattice" else f"lattice {tile}"


def lines_dataset(plate: Plate, vibration: Vibration, band: Band) -> xr.Dataset:
    """Dataset of energies, powers, impedances and errors against frequency.

    Energies and powers are those of a unit amplitude of the first drive, and grow with its square.
    """
    model = band.reduced.model
    parts, stored = _by_part(plate, vibration.stored, model)
    actuators = [actuator.name for actuator in plate.actuators]
    reference, unit = reference_of(plate)
    energy, power = (f"{of}/{reference.unit}^2" for of in ("J", "W"))
    impedance = np.stack(
        [
            np.asarray(a.amplitude / unit / (1j * vibration.omega * vibration.charge[a.name]))
            for a in plate.actuators
        ]
    ) if actuators else np.zeros((0, len(vibration.omega)), complex)  # fmt: skip
    losses = list(vibration.dissipated)
    data = xr.Dataset(
        {
            "solver_error": ("frequency", vibration.error, {"long_name": "relative, a bound"}),
            "strain_energy": (("frequency", "part"), stored, {"units": energy, "long_name": "mean"}),
            "moving": (
                "frequency", vibration.moving.sum(axis=1),
                {"units": energy, "long_name": "mean kinetic energy"},
            ),
            "given": (
                "frequency", vibration.given, {"units": power, "long_name": "mean power of the drives"},
            ),
            "dissipated": (
                ("loss", "frequency"), np.stack([vibration.dissipated[part] for part in losses]),
                {"units": power},
            ),
            "impedance_real": (("actuator", "frequency"), impedance.real, {"units": "ohm"}),
            "impedance_imag": (("actuator", "frequency"), impedance.imag, {"units": "ohm"}),
        },
        coords={
            "frequency": ("frequency", vibration.frequency, {"units": "Hz"}),
            "part": parts,
            "loss": [str(part) for part in losses],
            "actuator": np.array(actuators, dtype=str),
        },
    )  # fmt: skip
    data.attrs |= {
        "unknowns": model.assembly.size,
        "basis": band.reduced.basis.dimension,
        "mesh": json.dumps(asdict(model.fineness)),
        "blocks": len(model.assembly.skeleton.blocks),
    }
    return data


def modes_dataset(
    plate: Plate, band: Band, modes: PlateModes, shapes: Array, points: Array, regions: list[str]
) -> xr.Dataset:
    """Dataset of the modes near the carrier."""
    parts, stored = _by_part(plate, modes.stored, band.reduced.model)
    losses = list(modes.lost)
    called = mode_names(plate, band.reduced.model, modes, shapes, points, regions)
    return xr.Dataset(
        {
            "frequency": ("mode", modes.frequency, {"units": "Hz"}),
            "solver_error": ("mode", modes.error, {"long_name": "bound of the relative error of solving"}),
            "quality_factor": ("mode", modes.quality, {"long_name": "quality factor"}),
            "rise_time": ("mode", modes.rise_time, {"units": "s", "long_name": "10 to 90 %"}),
            "strain_energy": (("mode", "part"), stored, {"long_name": "share in each part"}),
            "lost": (("mode", "loss"), np.stack([modes.lost[part] for part in losses], axis=-1)),
            "name": ("mode", np.array(called, dtype=str)),
            "shape": (("mode", "point"), shapes.T.astype(np.float32), {"long_name": "normal displacement"}),
        },
        coords={
            "part": parts, "loss": [str(part) for part in losses],
            "x": ("point", points[:, 0], {"units": "m"}), "y": ("point", points[:, 1], {"units": "m"}),
        },
    )  # fmt: skip


def mode_names(
    plate: Plate, model: PlateModel, modes: PlateModes, shapes: Array, points: Array, regions: list[str]
) -> list[str]:
    """Nodal lines of each mode in the region of plain plate with most of its energy; "" without a region.

    shapes : (points, modes) normal displacement; regions : of the points
    """
    parts, stored = _by_part(plate, modes.stored, model)
    inside = np.array(regions)
    column = {name: parts.index(part_name(plate, name)) for name in plate.layout.regions}
    called = []
    for k in range(len(modes.frequency)):
        best = max(column, key=lambda name: stored[k, column[name]], default=None)
        called.append(nodal_name(_on_grid(points, shapes[:, k], inside == best)) if best else "")
    return called


def _on_grid(points: Array, values: Array, mask: NDArray[np.bool_]) -> Array:
    """(along, across) values of some points on their grid, longer direction first; NaN without a point."""
    x, column = np.unique(np.round(points[mask, 0], 9), return_inverse=True)
    y, row = np.unique(np.round(points[mask, 1], 9), return_inverse=True)
    grid = np.full((len(y), len(x)), np.nan)
    grid[row, column] = values[mask]
    return grid if np.ptp(y) >= np.ptp(x) else grid.T


def body_dataset(band: Band, vibration: Vibration, line: int) -> xr.Dataset:
    """Dataset of the displacement of the whole plate at one line, on the corners of the elements."""
    assembly = band.reduced.model.assembly
    amplitudes = vibration.amplitudes[:, line]
    vectors = vibration.vectors
    field = np.stack([vectors @ amplitudes.real, vectors @ amplitudes.imag], axis=1)
    layout = assembly.skeleton.layout
    points, cells, moved, count = [], [], [], 0
    for group, shares in assembly.shares(field):
        inside = group.tile.inside
        used, corners = np.unique(inside.subcells, return_inverse=True)
        lifted = inside.lifted(shares.reshape(len(shares), -1))[used].reshape(len(used), 3, -1, 2)
        for number, block in enumerate(group.blocks):
            rows, columns = assembly.skeleton.blocks[block].rows, assembly.skeleton.blocks[block].columns
            corner = [layout.x[columns[0]], layout.y[rows[0]], 0.0]
            points.append(inside.points[used] + corner)
            cells.append(corners.reshape(-1, 8) + count)
            moved.append(lifted[:, :, number])
            count += len(used)
    displacement = np.concatenate(moved)
    return xr.Dataset(
        {
            "node_position": (("node", "axis"), np.concatenate(points), {"units": "m"}),
            "subcell": (("cell", "corner"), np.concatenate(cells)),
            "real": (("node", "axis"), displacement[..., 0].astype(np.float32), {"units": "m"}),
            "imag": (("node", "axis"), displacement[..., 1].astype(np.float32), {"units": "m"}),
        },
        attrs={"frequency_hz": float(vibration.frequency[line])},
    )
