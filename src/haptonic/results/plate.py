"""How a finite plate vibrates: response over a band, localisation, energies, impedance, modes."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from numpy.typing import NDArray

from haptonic import plots
from haptonic.bloch import Gap
from haptonic.errors import StudyError
from haptonic.plate import Band, Plate, PlateModel, PlateModes, Vibration, modes_between
from haptonic.plate.parts import Actuator, Force
from haptonic.response import FrequencyResponse, contrast, disc_average, from_plain, plain, rms
from haptonic.results.common import stamped
from haptonic.results.shapes import nodal_name
from haptonic.store import Store, content_key

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

NEAR = 0.06  # share of the carrier around it within which modes are listed
BELOW, ABOVE = 0.76, 1.25  # of the gap's edges, where the maps below and above it are taken
FINGER = 10e-3  # m, width of the disc over which a finger averages


@dataclass(frozen=True)
class PlateQuestion:
    """What is asked of a plate. lowest, highest : Hz; points : lines; tolerance : field error; grid : m"""

    lowest: float
    highest: float
    points: int
    tolerance: float
    grid: float

    @property
    def frequencies(self) -> Array:
        """Hz"""
        return np.linspace(self.lowest, self.highest, self.points)


@dataclass(frozen=True, eq=False)
class PlateResult:
    """Response of a plate per unit of its reference, with all that was found beside it.

    plate : what was computed; gap : of its lattice around the carrier, if there is one; carrier : Hz
    response : velocity of the flat face; marked : the same at the frequencies of the maps
    lines : dataset on the response's frequencies; modes : dataset of the modes near the carrier
    body : displacement of the whole plate at the carrier, on a coarse mesh
    """

    plate: Plate
    gap: Gap | None
    carrier: float
    response: FrequencyResponse
    marked: FrequencyResponse
    lines: xr.Dataset
    modes: xr.Dataset
    body: xr.Dataset

    @property
    def driven(self) -> str | None:
        """The region of plain plate that carries the first actuator, or else the first force."""
        layout = self.plate.layout
        names = [layout.at(layout.under((*first.centre, *first.centre))[0]) for first in _drives(self.plate)]
        return next((name for name in names if name is not None and name not in layout.cells), None)

    def contrasts(self, response: FrequencyResponse) -> dict[str, xr.DataArray]:
        """How much more the driven region vibrates than others and than all the rest, dB."""
        driven, regions = self.driven, response.regions
        if driven not in regions:
            return {}
        assert driven is not None
        others = [name for name in regions if name not in ("", driven)]
        pairs = {f"{driven} over {other}": contrast(response, driven, other) for other in others}
        if regions == (driven,):
            return pairs
        return pairs | {f"{driven} over the rest": contrast(response, driven, "rest")}

    @cached_property
    def levels(self) -> dict[str, xr.DataArray]:
        """Root mean square velocity of every region, in the units of the response."""
        return {name: rms(self.response, name) for name in self.response.regions if name}

    def figures(self) -> dict[str, Figure]:
        """All pictures but the animation, by name."""
        frequency, gap = self.response.frequency, self._gap_edges
        layout = self.plate.layout
        found = {
            "plan": plots.plate_plan(self.plate),
            "maps": plots.maps(self.marked, self.marked.frequency.tolist(), layout, gap),
            "velocity": plots.velocity_spectrum(
                frequency, {k: v.values for k, v in self.levels.items()}, gap, units=self.response.units
            ),
        }
        if contrasts := self.contrasts(self.response):
            curves = {name: level.values for name, level in contrasts.items()}
            found["contrast"] = plots.contrast_spectrum(frequency, curves, gap)
        for actuator in self.plate.actuators:
            impedance = self.impedance(actuator.name)
            lines = self.lines["frequency"].values
            found[f"impedance-{actuator.name}"] = plots.impedance_spectrum(lines, impedance, gap)
        return found

    @property
    def _gap_edges(self) -> tuple[float, float] | None:
        return (self.gap.lower, self.gap.upper) if self.gap else None

    def impedance(self, actuator: str) -> Complex:
        """(frequency of ``lines``,) voltage over current of an actuator while all drives act, ohm."""
        lines = self.lines.sel(actuator=actuator)
        return np.asarray(lines["impedance_real"].values + 1j * lines["impedance_imag"].values)

    @property
    def resonance(self) -> float:
        """The frequency of the map in the gap, or else of the one nearest to the carrier, Hz."""
        return _resonance(self.marked.frequency, self.carrier, self._gap_edges)

    def told(self, line: FrequencyResponse) -> dict[str, Any]:
        """Plain values at one line of the response or of the maps."""
        where = {"frequency": float(line.frequency[0])}
        lines = self.lines.sel(where, method="nearest")
        return {
            "frequency_hz": where["frequency"],
            "error": float(lines["error"]),
            "rms": {name: float(rms(line, name)[0]) for name in line.regions if name},
            "units": line.units,
            "contrast_db": {name: float(level[0]) for name, level in self.contrasts(line).items()},
            "finger_um": below_finger(line),
            "impedance_ohm": {
                name: [float(lines[f"impedance_{part}"].sel(actuator=name)) for part in ("real", "imag")]
                for name in self.lines["actuator"].values.tolist()
            },
            "given_w": float(lines["given"]),
            "dissipated_w": _by_name(lines["dissipated"], "loss"),
            "strain_energy_j": _by_name(lines["stored"], "region"),
        }  # fmt: skip

    @property
    def map_lines(self) -> list[FrequencyResponse]:
        """The response at each frequency of the maps."""
        return [self.marked.at(float(f)) for f in self.marked.frequency]

    def to_json(self) -> dict[str, Any]:
        """Plain values for machines."""
        modes = self.modes
        return {
            "origin": "simulated",
            "reference": self.response.dataset.attrs["reference"],
            "carrier_hz": self.carrier,
            "gap_hz": self._gap_edges,
            "driven": self.driven,
            "unknowns": int(self.lines.attrs["unknowns"]),
            "basis": int(self.lines.attrs["basis"]),
            "pillars": self.plate.layout.pillars,
            "largest_error": float(self.lines["error"].max()),
            "resonance_hz": self.resonance,
            "maps": [self.told(line) for line in self.map_lines],
            "modes": [
                {
                    "frequency_hz": float(mode["mode_frequency"]),
                    "error": float(mode["mode_error"]),
                    "quality_factor": _finite(mode["quality"]),
                    "rise_time_s": _finite(mode["rise_time"]),
                    "name": str(mode["name"].values),
                    "strain_energy": _by_name(mode["stored"], "region"),
                    "loss": _by_name(mode["lost"], "loss"),
                }
                for mode in (modes.isel(mode=k) for k in range(modes.sizes["mode"]))
            ],
            "inputs": json.loads(self.lines.attrs["inputs"]),
            "version": self.lines.attrs["haptonic_version"],
        }  # fmt: skip


def below_finger(line: FrequencyResponse) -> dict[str, float]:
    """Amplitude below a finger where it is largest in each region, um per unit of the reference."""
    amplitude = disc_average(line.displacement(), FINGER).values[0]
    return {name: float(amplitude[line.inside(name)].max() * 1e6) for name in line.regions if name}


def _by_name(values: xr.DataArray, dim: str) -> dict[str, float]:
    return dict(zip(values[dim].values.tolist(), values.values.tolist(), strict=True))


def _finite(value: xr.DataArray) -> float | None:
    return float(value) if np.isfinite(value) else None


def _drives(plate: Plate) -> list[Actuator | Force]:
    return [*plate.actuators, *plate.forces]


def _amplitude(drive: Actuator | Force) -> complex:
    return drive.voltage if isinstance(drive, Actuator) else drive.amplitude


def reference_of(plate: Plate) -> tuple[str, float]:
    """What the response is divided by: the first drive's name and unit, and its amplitude."""
    moving = [drive for drive in _drives(plate) if _amplitude(drive)]
    if not moving:
        raise StudyError(
            argument="plate.actuator",
            given="nothing that drives the plate",
            allowed="at least one [[plate.actuator]] or [[plate.force]] with an amplitude above zero",
            cause="the plate has no drive, or its amplitude is zero",
            next_step='add [[plate.force]] with region, centre and force = "1 N"',
        )
    first = moving[0]
    return f"{first.name}, {'V' if isinstance(first, Actuator) else 'N'}", abs(_amplitude(first))


def grid_points(plate: Plate, spacing: float) -> tuple[Array, list[str]]:
    """Points (k, 2) of the flat face on a grid of squares, at the middle of each, m, and their regions.

    Points of a lattice have no region.
    """
    layout = plate.layout
    axes = []
    for lines in (layout.x, layout.y):
        count = max(1, round((lines[-1] - lines[0]) / spacing))
        axes.append(lines[0] + (lines[-1] - lines[0]) / count * (np.arange(count) + 0.5))
    x, y = (axis.ravel() for axis in np.meshgrid(*axes))
    column = np.searchsorted(layout.x, x, side="right") - 1
    row = np.searchsorted(layout.y, y, side="right") - 1
    names = [layout.at((int(i), int(j))) for i, j in zip(row, column, strict=True)]
    there = [k for k, name in enumerate(names) if name is not None]
    regions = [names[k] or "" for k in there]
    return np.stack([x, y], axis=-1)[there], ["" if name in layout.cells else name for name in regions]


def compute_plate(
    plate: Plate,
    question: PlateQuestion,
    *,
    carrier: float,
    gap: Gap | None,
    inputs: Mapping[str, Any],
    store: Store,
    told: Callable[[int, int, bool], None] = lambda done, planned, stored: None,
) -> PlateResult:
    """How a plate answers its drives, from the store if it was computed before.

    Parameters
    ----------
    carrier : Hz, near which modes are listed
    gap : for the maps below, in and above it; without one the only map is at the carrier
    inputs : plain values of what was asked; told : called with the shifts done and planned

    Raises
    ------
    StudyError : nothing drives the plate, or it has no loss
    ResourceError : the basis would need more memory than there is
    HaptonicError : lines that cannot be made as exact as asked for
    """
    reference_of(plate)
    _need_loss(plate)
    edges = None if gap is None else [gap.lower, gap.upper]
    keys = [
        content_key(
            {"part": part, "carrier": carrier, "gap": edges, **asdict(question), "inputs": dict(inputs)}
        )
        for part in ("plate response", "plate maps", "plate lines", "plate modes", "plate body")
    ]
    kept = [dataset for key in keys if (dataset := store.get(key)) is not None]
    if len(kept) < len(keys):
        kept = _computed(plate, question, carrier, edges, inputs, told)
        for key, dataset in zip(keys, kept, strict=True):
            store.put(key, dataset)
    response, marked, lines, modes, body = kept
    return PlateResult(plate, gap, carrier, from_plain(response), from_plain(marked), lines, modes, body)


def _need_loss(plate: Plate) -> None:
    if not plate.loss_factor:
        raise StudyError(
            argument="plate.loss_factor",
            given="0",
            allowed="more than 0",
            cause="without loss the response at a resonance has no bound",
            next_step="add loss_factor = 1e-3 to [plate], or the loss factor of the material",
        )


def _computed(
    plate: Plate,
    question: PlateQuestion,
    carrier: float,
    gap: list[float] | None,
    inputs: Mapping[str, Any],
    told: Callable[[int, int, bool], None],
) -> list[xr.Dataset]:
    low, high = question.lowest, question.highest
    model = PlateModel.of(plate, high)
    band = Band.of(model, low, high, lambda done, planned: told(done, planned, False))
    found = modes_between(band, max(low, (1 - NEAR) * carrier), min(high, (1 + NEAR) * carrier))
    reference, unit = reference_of(plate)
    drives = {drive.name: _amplitude(drive) / unit for drive in _drives(plate)}
    aside = [carrier] if gap is None else [BELOW * gap[0], ABOVE * gap[1], *found.frequency]
    extra = [f for f in aside if low <= f <= high]
    every = np.union1d(question.frequencies, extra)
    band, vibration = band.answer(drives, every, question.tolerance)
    points, regions = grid_points(plate, question.grid)
    surface = model.observed(points) @ band.reduced.basis.vectors
    velocity = (surface @ vibration.amplitudes) * (1j * vibration.omega)
    marked = _marked(plate, every, velocity, regions, carrier, gap)
    main = np.searchsorted(every, question.frequencies)

    def response(picked: NDArray[np.int64], title: str) -> xr.Dataset:
        return plain(
            FrequencyResponse.of(
                np.ascontiguousarray(velocity[:, picked].T, dtype=np.complex64)[..., None],
                frequency=every[picked], x=points[:, 0], y=points[:, 1], reference=reference,
                origin="simulated", region=regions, title=title, inputs=inputs,
            )
        )  # fmt: skip

    lines = _lines(plate, vibration, band)
    shapes = surface_of(model, points, found)
    at_resonance = int(marked[np.abs(every[marked] - _resonance(every[marked], carrier, gap)).argmin()])
    return [
        response(main, "finite plate"),
        response(marked, "finite plate, the frequencies of its maps"),
        stamped(lines, inputs),
        stamped(_modes(plate, band, found, shapes, points, regions), inputs),
        stamped(_body(band, vibration, at_resonance), inputs),
    ]


def _marked(
    plate: Plate, every: Array, velocity: Complex, regions: list[str], carrier: float, gap: list[float] | None
) -> NDArray[np.int64]:
    """Lines of the maps: below, in and above the gap; in it where the driven region resonates most."""
    if gap is None:
        return np.array([int(np.abs(every - carrier).argmin())])
    inside = np.flatnonzero((every > gap[0]) & (every < gap[1]))
    layout = plate.layout
    first = _drives(plate)[0]
    driven = layout.at(layout.under((*first.centre, *first.centre))[0])
    there = np.array([name == driven for name in regions])
    if not there.any():
        there[:] = True
    found = []
    if every[0] <= BELOW * gap[0]:
        found.append(int(np.abs(every - BELOW * gap[0]).argmin()))
    if len(inside):
        loudness = (np.abs(velocity[there][:, inside]) ** 2).mean(axis=0)
        near = np.abs(every[inside] / carrier - 1) < NEAR
        found.append(int(inside[np.where(near, loudness, 0.0).argmax()]))
    if every[-1] >= ABOVE * gap[1]:
        found.append(int(np.abs(every - ABOVE * gap[1]).argmin()))
    return np.array(found or [int(np.abs(every - carrier).argmin())])


def _resonance(marked: Array, carrier: float, gap: Sequence[float] | None) -> float:
    """The frequency of the map in the gap, or else of the one nearest to the carrier, Hz."""
    low, high = gap or (0.0, np.inf)
    inside = marked[(marked > low) & (marked < high)]
    return float(min(inside if len(inside) else marked, key=lambda f: abs(f - carrier)))


def surface_of(model: PlateModel, points: Array, found: PlateModes) -> Array:
    """(points, modes) normal displacement of the flat face."""
    return np.asarray(model.observed(points) @ found.vectors)


def _by_region(plate: Plate, stored: Mapping[str, Array], band: Band) -> tuple[list[str], Array]:
    """Names of regions, lattices and actuators, and (n, names) what is stored in each."""
    layout, blocks = plate.layout, band.reduced.model.assembly.skeleton.blocks
    names = [layout.at(block.tiles[0]) for block in blocks]
    shares = {
        name: stored["plate"][:, [k for k, other in enumerate(names) if other == name]].sum(axis=1)
        for name in dict.fromkeys(names) if name is not None
    }  # fmt: skip
    for actuator in plate.actuators:
        own = (values for part, values in stored.items() if part.split(" ")[0] == actuator.name)
        shares[actuator.name] = np.asarray(sum(values.sum(axis=1) for values in own))
    return list(shares), np.stack(list(shares.values()), axis=-1)


def _lines(plate: Plate, vibration: Vibration, band: Band) -> xr.Dataset:
    """Energies, powers, impedances and errors against frequency."""
    regions, stored = _by_region(plate, vibration.stored, band)
    actuators = [actuator.name for actuator in plate.actuators]
    _, unit = reference_of(plate)
    impedance = np.stack(
        [
            np.asarray(a.voltage / unit / (1j * vibration.omega * vibration.charge[a.name]))
            for a in plate.actuators
        ]
    ) if actuators else np.zeros((0, len(vibration.omega)), complex)  # fmt: skip
    losses = list(vibration.dissipated)
    data = xr.Dataset(
        {
            "error": ("frequency", vibration.error, {"long_name": "bound of the relative field error"}),
            "stored": (("frequency", "region"), stored, {"units": "J", "long_name": "mean strain energy"}),
            "moving": (
                "frequency", vibration.moving.sum(axis=1), {"units": "J", "long_name": "mean kinetic energy"},
            ),
            "given": ("frequency", vibration.given, {"units": "W", "long_name": "mean power of the drives"}),
            "dissipated": (
                ("loss", "frequency"), np.stack([vibration.dissipated[name] for name in losses]),
                {"units": "W"},
            ),
            "impedance_real": (("actuator", "frequency"), impedance.real, {"units": "ohm"}),
            "impedance_imag": (("actuator", "frequency"), impedance.imag, {"units": "ohm"}),
        },
        coords={
            "frequency": ("frequency", vibration.frequency, {"units": "Hz"}),
            "region": regions,
            "loss": losses,
            "actuator": np.array(actuators, dtype=str),
        },
    )  # fmt: skip
    model = band.reduced.model
    data.attrs |= {
        "unknowns": model.assembly.size,
        "basis": band.reduced.basis.dimension,
        "mesh": json.dumps(asdict(model.fineness)),
        "blocks": len(model.assembly.skeleton.blocks),
    }
    return data


def _modes(
    plate: Plate, band: Band, found: PlateModes, shapes: Array, points: Array, regions: list[str]
) -> xr.Dataset:
    """Modes near the carrier."""
    names, stored = _by_region(plate, found.stored, band)
    losses = list(found.lost)
    inside = np.array(regions)
    called = []
    for k in range(len(found.frequency)):
        plain_names = [name for name in names if name in plate.layout.regions]
        best = max(plain_names, key=lambda name: stored[k, names.index(name)], default=None)
        called.append(nodal_name(_on_grid(points, shapes[:, k], inside == best)) if best else "")
    return xr.Dataset(
        {
            "mode_frequency": ("mode", found.frequency, {"units": "Hz"}),
            "mode_error": ("mode", found.error, {"long_name": "bound of the frequency's relative error"}),
            "quality": ("mode", found.quality, {"long_name": "quality factor"}),
            "rise_time": ("mode", found.rise_time, {"units": "s", "long_name": "10 to 90 %"}),
            "stored": (("mode", "region"), stored, {"long_name": "share of the strain energy"}),
            "lost": (("mode", "loss"), np.stack([found.lost[name] for name in losses], axis=-1)),
            "name": ("mode", np.array(called, dtype=str)),
            "shape": (("mode", "point"), shapes.T.astype(np.float32), {"long_name": "normal displacement"}),
        },
        coords={
            "region": names, "loss": losses,
            "x": ("point", points[:, 0], {"units": "m"}), "y": ("point", points[:, 1], {"units": "m"}),
        },
    )  # fmt: skip


def _on_grid(points: Array, values: Array, mask: NDArray[np.bool_]) -> Array:
    """(along, across) values of some points on their grid, the longer direction first; NaN where none is."""
    x, column = np.unique(np.round(points[mask, 0], 9), return_inverse=True)
    y, row = np.unique(np.round(points[mask, 1], 9), return_inverse=True)
    grid = np.full((len(y), len(x)), np.nan)
    grid[row, column] = values[mask]
    return grid if np.ptp(y) >= np.ptp(x) else grid.T


def _body(band: Band, vibration: Vibration, line: int) -> xr.Dataset:
    """Displacement of the whole plate at one line, on the corners of the elements."""
    assembly = band.reduced.model.assembly
    amplitudes = vibration.amplitudes[:, line]
    vectors = band.reduced.basis.vectors
    field = np.stack([vectors @ amplitudes.real, vectors @ amplitudes.imag], axis=1)
    layout = assembly.skeleton.layout
    points, cells, moved, count = [], [], [], 0
    for group, shares in assembly.shares(field):
        inside = group.tile.inside
        used, own = np.unique(inside.subcells, return_inverse=True)
        for block, share in zip(group.blocks, shares, strict=True):
            rows, columns = assembly.skeleton.blocks[block].rows, assembly.skeleton.blocks[block].columns
            corner = [layout.x[columns[0]], layout.y[rows[0]], 0.0]
            points.append(inside.points[used] + corner)
            cells.append(own.reshape(-1, 8) + count)
            moved.append(inside.lifted(share)[used])
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
