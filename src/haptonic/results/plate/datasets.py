"""What was computed of a plate as datasets: lines, modes, and the whole body at one line."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from haptonic.plate import Band, Plate, PlateModel, PlateModes, Vibration
from haptonic.plate.keys import PLATE, PartKey
from haptonic.results.plate.question import reference_of
from haptonic.results.plate.shapes import nodal_name

Array = NDArray[np.float64]


def _by_region(plate: Plate, stored: Mapping[PartKey, Array], model: PlateModel) -> tuple[list[str], Array]:
    """Names of regions and lattices, and (n, names) what is stored in the plate there."""
    layout, blocks = plate.layout, model.assembly.skeleton.blocks
    names = [layout.at(block.tiles[0]) for block in blocks]
    shares = {
        name: stored[PLATE][:, [k for k, other in enumerate(names) if other == name]].sum(axis=1)
        for name in dict.fromkeys(names) if name is not None
    }  # fmt: skip
    return list(shares), np.stack(list(shares.values()), axis=-1)


def _in_actuators(plate: Plate, stored: Mapping[PartKey, Array]) -> tuple[list[str], Array]:
    """Names of actuators, and (n, names) what is stored in each and in its bond."""
    names = [actuator.name for actuator in plate.actuators]
    shares = np.zeros((len(stored[PLATE]), len(names)))
    for part, values in stored.items():
        if part.kind == "actuator":
            shares[:, names.index(str(part.owner))] += values.sum(axis=1)
    return names, shares


def lines_dataset(plate: Plate, vibration: Vibration, band: Band) -> xr.Dataset:
    """Energies, powers, impedances and errors against frequency."""
    model = band.reduced.model
    regions, stored = _by_region(plate, vibration.stored, model)
    actuators, in_actuators = _in_actuators(plate, vibration.stored)
    _, unit = reference_of(plate)
    impedance = np.stack(
        [
            np.asarray(a.amplitude / unit / (1j * vibration.omega * vibration.charge[a.name]))
            for a in plate.actuators
        ]
    ) if actuators else np.zeros((0, len(vibration.omega)), complex)  # fmt: skip
    losses = list(vibration.dissipated)
    data = xr.Dataset(
        {
            "error": ("frequency", vibration.error, {"long_name": "bound of the relative error of solving"}),
            "stored": (("frequency", "region"), stored, {"units": "J", "long_name": "mean strain energy"}),
            "stored_in_actuator": (
                ("frequency", "actuator"), in_actuators, {"units": "J", "long_name": "mean strain energy"},
            ),
            "moving": (
                "frequency", vibration.moving.sum(axis=1), {"units": "J", "long_name": "mean kinetic energy"},
            ),
            "given": ("frequency", vibration.given, {"units": "W", "long_name": "mean power of the drives"}),
            "dissipated": (
                ("loss", "frequency"), np.stack([vibration.dissipated[part] for part in losses]),
                {"units": "W"},
            ),
            "impedance_real": (("actuator", "frequency"), impedance.real, {"units": "ohm"}),
            "impedance_imag": (("actuator", "frequency"), impedance.imag, {"units": "ohm"}),
        },
        coords={
            "frequency": ("frequency", vibration.frequency, {"units": "Hz"}),
            "region": regions,
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
    plate: Plate, band: Band, found: PlateModes, shapes: Array, points: Array, regions: list[str]
) -> xr.Dataset:
    """Modes near the carrier."""
    names, stored = _by_region(plate, found.stored, band.reduced.model)
    actuators, in_actuators = _in_actuators(plate, found.stored)
    losses = list(found.lost)
    called = mode_names(plate, band.reduced.model, found, shapes, points, regions)
    return xr.Dataset(
        {
            "mode_frequency": ("mode", found.frequency, {"units": "Hz"}),
            "mode_error": ("mode", found.error, {"long_name": "bound of the relative error of solving"}),
            "quality": ("mode", found.quality, {"long_name": "quality factor"}),
            "rise_time": ("mode", found.rise_time, {"units": "s", "long_name": "10 to 90 %"}),
            "stored": (("mode", "region"), stored, {"long_name": "share of the strain energy"}),
            "stored_in_actuator": (
                ("mode", "actuator"), in_actuators, {"long_name": "share of the strain energy"},
            ),
            "lost": (("mode", "loss"), np.stack([found.lost[part] for part in losses], axis=-1)),
            "name": ("mode", np.array(called, dtype=str)),
            "shape": (("mode", "point"), shapes.T.astype(np.float32), {"long_name": "normal displacement"}),
        },
        coords={
            "region": names, "loss": [str(part) for part in losses],
            "actuator": np.array(actuators, dtype=str),
            "x": ("point", points[:, 0], {"units": "m"}), "y": ("point", points[:, 1], {"units": "m"}),
        },
    )  # fmt: skip


def mode_names(
    plate: Plate, model: PlateModel, found: PlateModes, shapes: Array, points: Array, regions: list[str]
) -> list[str]:
    """Nodal lines of each mode in the region of plain plate that holds most of its energy; "" if it has none.

    shapes : (points, modes) normal displacement; regions : of the points
    """
    names, stored = _by_region(plate, found.stored, model)
    inside = np.array(regions)
    plain = [name for name in names if name in plate.layout.regions]
    called = []
    for k in range(len(found.frequency)):
        best = max(plain, key=lambda name: stored[k, names.index(name)], default=None)
        called.append(nodal_name(_on_grid(points, shapes[:, k], inside == best)) if best else "")
    return called


def _on_grid(points: Array, values: Array, mask: NDArray[np.bool_]) -> Array:
    """(along, across) values of some points on their grid, the longer direction first; NaN where none is."""
    x, column = np.unique(np.round(points[mask, 0], 9), return_inverse=True)
    y, row = np.unique(np.round(points[mask, 1], 9), return_inverse=True)
    grid = np.full((len(y), len(x)), np.nan)
    grid[row, column] = values[mask]
    return grid if np.ptp(y) >= np.ptp(x) else grid.T


def body_dataset(band: Band, vibration: Vibration, line: int) -> xr.Dataset:
    """Displacement of the whole plate at one line, on the corners of the elements."""
    assembly = band.reduced.model.assembly
    amplitudes = vibration.amplitudes[:, line]
    vectors = vibration.vectors
    field = np.stack([vectors @ amplitudes.real, vectors @ amplitudes.imag], axis=1)
    layout = assembly.skeleton.layout
    points, cells, moved, count = [], [], [], 0
    for group, shares in assembly.shares(field):
        inside = group.tile.inside
        used, own = np.unique(inside.subcells, return_inverse=True)
        lifted = inside.lifted(shares.reshape(len(shares), -1))[used].reshape(len(used), 3, -1, 2)
        for number, block in enumerate(group.blocks):
            rows, columns = assembly.skeleton.blocks[block].rows, assembly.skeleton.blocks[block].columns
            corner = [layout.x[columns[0]], layout.y[rows[0]], 0.0]
            points.append(inside.points[used] + corner)
            cells.append(own.reshape(-1, 8) + count)
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
