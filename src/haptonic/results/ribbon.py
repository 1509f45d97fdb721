"""Waves along a ribbon: its projected bands, and the modes that its guide, its edge or a defect holds."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.arrays import Array
from haptonic.bloch.gaps import gap_at, widest_gap
from haptonic.bloch.guided import decay, harmonics, in_gap, outermost, within
from haptonic.bloch.model import BlochModel, bloch_model
from haptonic.bloch.ribbon import RibbonModel, RibbonModes, bulk_bands
from haptonic.bloch.settings import HIGHEST, LOWEST, BandSettings
from haptonic.cell import Ribbon, UnitCell
from haptonic.errors import StudyError
from haptonic.gate import declared
from haptonic.later import Axes, Figure
from haptonic.later import xarray as xr
from haptonic.parallel import one_thread
from haptonic.plots.text import khz
from haptonic.results.common import stamped
from haptonic.results.result import Result, figure
from haptonic.results.runner import Runner
from haptonic.results.table import Column, Table
from haptonic.units import format_quantity

Range = tuple[float, float]

BESIDE = 0.15  # of a gap's width, on either side of it, where modes are sought as well
MOST_TOLD = 40  # modes in the table, those nearest to the middle of the gap
MOST = 0.5  # share of the energy from which a mode belongs to the guide more than to what is around it
COLUMNS = (
    Column("frequency", shown="kHz", form=".4f", error="frequency_error"),
    Column("phase / pi", form=".4f", of="phase_share"),
    Column("wavenumber", form=".1f"),
    Column("across", form=".0f", of="nodal_lines"),
    Column("intervals along", form=".0f", of="intervals"),
    Column("group velocity", form=".0f", of="group_velocity"),
    Column("in the guide", form=".3f", of="guide_share"),
    Column("decay", form=".1f"),
)
ALONG = ("wavenumber", "across", "intervals along", "group velocity")  # what a defect's modes have not


@dataclass(frozen=True, eq=False, repr=False)
class RibbonWaves(Result):
    """All modes of a ribbon within a range of frequencies; ``dataset`` holds them on dimension ``mode``."""

    title = "Ribbon"
    data_file = "ribbon"

    dataset: xr.Dataset

    @property
    def guided(self) -> xr.Dataset:
        """Those between the bulk bands with more energy in the guide than at the outer edges."""
        found = self.dataset.drop_dims(["node", "triangle"], errors="ignore")
        found = found.isel(mode=np.flatnonzero(found["guided"].values))
        return found.isel(mode=np.argsort(found["frequency"].values))

    @property
    def best(self) -> xr.Dataset | None:
        """Of `guided` the mode nearest to the `target`, if possible with most of its energy there."""
        found = self.guided
        if not found.sizes["mode"]:
            return None
        most = np.flatnonzero(found["guide_share"].values >= MOST)
        found = found.isel(mode=most) if len(most) else found
        return found.isel(mode=int(np.abs(found["frequency"].values - self.target).argmin()))

    @property
    def target(self) -> float:
        """Hz, the carrier if it lies in the range, else the middle of this."""
        low, high = self.dataset.attrs["range_hz"]
        carrier = self.dataset.attrs.get("carrier_hz", 0.0)
        return float(carrier if low < carrier < high else 0.5 * (low + high))

    def summary(self) -> list[str]:
        found = self.guided
        low, high = self.dataset.attrs["range_hz"]
        where = f"from {low / 1e3:.4g} to {high / 1e3:.4g} kHz"
        best = self.best
        if best is None:
            return [f"The ribbon holds no wave between the bulk bands {where}."]
        kind = f"The {self.dataset.attrs['kind']}"
        intervals = float(best["intervals"])
        across = float(best["nodal_lines"])
        name = f"{across:.0f}x{intervals:.0f}, " if np.isfinite(intervals) and np.isfinite(across) else ""
        fading = float(best["decay"])
        near, speed, inside = (float(best[name]) for name in ("frequency", "group_velocity", "guide_share"))
        fades = f", and it fades by {fading:.1f} dB per row" if np.isfinite(fading) else ""
        return [
            self._of_defect(where)
            or f"{kind} holds {found.sizes['mode']} modes between the bulk bands {where}, at "
            f"{self.dataset.sizes['wavevector']} wavevectors.",
            f"Nearest to {self.target / 1e3:.4g} kHz: "
            f"{khz(near, float(best['frequency_error']))} kHz ({name}phase "
            f"{float(best['phase_share']):.3f} pi per period): {inside:.0%} of its energy "
            f"is there{fades}; group velocity {speed:.0f} m/s.",
            *self._of_copies(near),
        ]

    def _of_defect(self, where: str) -> str:
        """Modes that have most of their energy in a defect, where copies of it are in phase."""
        found = self.guided
        most = (found["phase"].values == 0) & (found["guide_share"].values >= MOST)
        if self.dataset.attrs["kind"] != "defect" or not most.any():
            return ""
        at = ", ".join(f"{one / 1e3:.2f}" for one in found["frequency"].values[most])
        return f"The defect holds {at} kHz between the bulk bands {where}, with most of their energy in it."

    def _of_copies(self, near: float) -> list[str]:
        """What the repetition of a defect whose mode is at a frequency (Hz) changes, and what damps it."""
        lines = self.dataset.sizes["line"]
        if self.dataset.attrs["kind"] != "defect":
            return []
        found = self.guided
        apart = np.abs(found["frequency"].values - near)
        nearest = [apart[found["phase"].values == phase].min() for phase in np.unique(found["phase"].values)]
        loss = self.dataset.attrs["loss_factor"]
        damped = f"; the plate's material damps it to a quality of {1 / loss:.0f}" if loss else ""
        return [f"Copies of it {lines} cells apart move it by {max(nearest) / 1e3:.2g} kHz{damped}."]

    def tables(self) -> list[Table]:
        found = self.guided
        near = np.sort(np.argsort(np.abs(found["frequency"].values - self.target))[:MOST_TOLD])
        rows = self.dataset.attrs["rows"]
        what = f"resonances of a guide {rows} cells long with free ends" if rows else "modes that are held"
        left = found.sizes["mode"] - len(near)
        more = f"; {left} farther from {self.target / 1e3:.4g} kHz are in the file" if left else ""
        columns = [one for one in COLUMNS if one.name not in ALONG or self.dataset.attrs["kind"] != "defect"]
        return [Table.of(f"{what}{more}", found.isel(mode=near), "mode", columns)]

    @figure(
        "ribbon",
        "Simulated projected bands of the ribbon. Bulk bands of the crystals are shaded, for all phases "
        "across; dashes are modes of the ribbon, their slope the group velocity, their colour the share of "
        "energy in the guide or at the edge.",
    )
    def _projected(self, *, ax: Axes | None = None) -> Figure:
        return plots.projected(self.dataset, ax=ax)

    @figure(
        "field",
        "Simulated field of one mode that is held, on the flat face, at the moment when it is largest.",
        when=lambda result: "field_real" in result.dataset,
    )
    def _field(self, *, ax: Axes | None = None) -> Figure:
        return plots.ribbon_field(self.dataset, ax=ax)

    def facts(self) -> dict[str, Any]:
        found = self.guided
        return {"guided": found[[name for name in found if found[name].dims == ("mode",)]]}


@one_thread()
def compute_ribbon(
    ribbon: Ribbon,
    names: Sequence[Sequence[str]],
    settings: BandSettings,
    *,
    points: int,
    rows: int | None,
    between: tuple[float | None, float | None],
    carrier: float | None,
    inputs: Mapping[str, Any],
    runner: Runner,
) -> RibbonWaves:
    """Projected bands of a ribbon and its modes.

    Parameters
    ----------
    names : of the cells, a list for each line
    points : wavevectors from 0 to pi per period, unless rows are given
    rows : length in cells, whose resonances are told: at a free end a wave gains a quarter of an interval
    between : Hz, ends of the range of frequencies, those that were given
    inputs : plain values of what was asked, for the result's attributes

    Raises
    ------
    StudyError : nothing says where to look for modes
    """
    crystals = ribbon.crystals
    models = [bloch_model(cell, settings) for cell in crystals or ribbon.first[:1]]
    resolution = max(
        (one.resolution for one in models), key=lambda one: (one.order, one.foot_rings, one.steps)
    )
    low, high = _range(between, crystals, settings, carrier, runner)
    kappa = (np.arange(rows) + 0.5) * np.pi / rows if rows else np.linspace(0.0, np.pi, points)
    bulk = _bulk(models if crystals else [], ribbon, kappa)
    model = RibbonModel.of(ribbon, resolution)
    found = []
    for done, phase in enumerate(kappa):
        runner.progress(done, len(kappa), "wavevectors")
        found.append(model.solve(float(phase), low, high))
    runner.progress(len(kappa), len(kappa), "wavevectors")
    dataset = _modes_dataset(model, found, bulk, rows)
    dataset = dataset.merge(_bulk_dataset(ribbon, kappa, bulk, names))
    dataset.attrs = {
        "range_hz": [low, high],
        "rows": rows or 0,
        "period": ribbon.period,
        "kind": ribbon.kind,
        "loss_factor": ribbon.first[0].material.loss_factor,
        "unknowns": len(model.fine.order),
        "mesh": json.dumps([resolution.order, resolution.foot_rings]),
    } | ({"carrier_hz": carrier} if carrier is not None else {})
    result = RibbonWaves(dataset)
    best = result.best
    if best is not None:
        dataset = dataset.merge(_field_dataset(model, best, found))
    return RibbonWaves(stamped(dataset.assign_attrs(result.dataset.attrs), inputs))


def _range(
    between: tuple[float | None, float | None],
    crystals: Sequence[UnitCell],
    settings: BandSettings,
    carrier: float | None,
    runner: Runner,
) -> Range:
    """Hz: as given, else about the gap of the first crystal, else about the carrier."""
    low, high = between
    if low is None or high is None:
        gaps = runner.gaps(crystals[0], settings) if crystals else ()
        gap = (gap_at(gaps, carrier) if carrier else None) or widest_gap(gaps)
        if gap is not None:
            ends = gap.lower - BESIDE * gap.width, gap.upper + BESIDE * gap.width
        elif carrier is not None:
            ends = LOWEST * carrier, HIGHEST * carrier
        else:
            raise StudyError.missing(
                argument="ribbon.lowest",
                allowed="the range of frequencies in which modes are sought",
                cause="there is no complete gap about which to look, and no carrier",
                next_step='add lowest = "40 kHz" and highest = "70 kHz" to [ribbon]',
            )
        low, high = low or ends[0], high or ends[1]
    if low >= high:
        raise StudyError.conflict(
            argument="ribbon.lowest",
            given=format_quantity(low, "Hz"),
            allowed=f"less than the highest frequency, {format_quantity(high, 'Hz')}",
            cause="only one end of the range was given, beyond the other's default",
            next_step="give both ribbon.lowest and ribbon.highest",
        )
    return low, high


def _bulk(models: Sequence[BlochModel], ribbon: Ribbon, kappa: Array) -> Array:
    """(crystals, wavevectors, bands, 2) Hz."""
    if not models:
        return np.empty((0, len(kappa), 0, 2))
    return np.array([bulk_bands(one, ribbon, [float(k) for k in kappa]) for one in models])


def _modes_dataset(
    model: RibbonModel, found: Sequence[RibbonModes], bulk: Array, rows: int | None
) -> xr.Dataset:
    ribbon = model.ribbon
    pieces = []
    for number, modes in enumerate(found):
        share = modes.energy / modes.energy.sum(axis=(1, 2), keepdims=True)
        inside, there = within(modes.energy, ribbon.guide), in_gap(modes, bulk[:, number])
        wavenumber, across = harmonics(ribbon, model.fine, modes)
        pieces.append({
            "phase": np.full(len(modes.frequency), modes.kappa),
            "frequency": modes.frequency,
            "frequency_error": modes.error,
            "group_velocity": 2 * np.pi * ribbon.period * modes.slope,
            "guide_share": inside,
            "cell_share": share,
            "in_gap": there.astype(np.int8),
            "guided": (there & (inside > within(modes.energy, outermost(ribbon)))).astype(np.int8),
            "decay": np.where(there, decay(ribbon, modes.energy), np.nan),
            "wavenumber": wavenumber,
            "nodal_lines": across,
            "intervals": wavenumber * (rows or np.nan) * ribbon.period / np.pi - 0.5,
        })  # fmt: skip
    joined = {name: np.concatenate([one[name] for one in pieces]) for name in pieces[0]}
    of_cells = ("mode", "line", "column")
    dataset = xr.Dataset({name: (of_cells[: values.ndim], values) for name, values in joined.items()})
    dataset["phase_share"] = dataset["phase"] / np.pi
    words = {
        "phase": ("rad", "phase of the wave from one period of the ribbon to the next"),
        "phase_share": ("1", "the same over pi"),
        "frequency": ("Hz", "frequency"),
        "frequency_error": ("Hz", "bound of the frequency's error"),
        "group_velocity": ("m/s", "group velocity along the ribbon"),
        "guide_share": (
            "1",
            "share of energy in the guide or defect, or in the cells on either side of an edge",
        ),
        "cell_share": ("1", "share of energy in each cell, lines from the bottom up"),
        "in_gap": ("1", "1 between the bulk bands at this phase"),
        "guided": ("1", "1 if so, and more energy is in the guide than in the outermost columns"),
        "decay": ("dB/row", "decay of the energy away from the guide"),
        "wavenumber": ("rad/m", "of the strongest harmonic of the normal motion along the guide"),
        "nodal_lines": ("1", "nodal lines of the normal motion across the guide"),
        "intervals": ("1", "intervals between nodal lines along a guide of the given length"),
    }
    for name, (unit, title) in words.items():
        dataset[name].attrs = {"units": unit, "long_name": title}
    return declared(
        dataset,
        decay="a mode within a bulk band, or fewer than two rows to compare",
        wavenumber="tiles without sides along the ribbon, or several lines of cells",
        nodal_lines="no guide of one line, or tiles without sides along the ribbon",
        intervals="no length in cells was given, or tiles without sides along the ribbon",
    )


def _bulk_dataset(ribbon: Ribbon, kappa: Array, bulk: Array, names: Sequence[Sequence[str]]) -> xr.Dataset:
    edges = ("crystal", "wavevector", "bulk_band")
    dataset = xr.Dataset(
        {
            "wavevector_phase": (
                "wavevector",
                kappa,
                {"units": "rad", "long_name": "phases along the ribbon"},
            ),
            "bulk_lower": (edges, bulk[..., 0], {"units": "Hz", "long_name": "lower edge of a bulk band"}),
            "bulk_upper": (edges, bulk[..., 1], {"units": "Hz", "long_name": "upper edge of a bulk band"}),
        }
    )
    return dataset.assign_coords(cell_name=(("line", "column"), np.array(names)))


def _field_dataset(model: RibbonModel, chosen: xr.Dataset, found: Sequence[RibbonModes]) -> xr.Dataset:
    """The field of one mode on the flat face, in the direction of its largest, the ribbon along y."""
    modes = next(one for one in found if one.kappa == float(chosen["phase"]))
    number = int(np.abs(modes.frequency - float(chosen["frequency"])).argmin())
    tiling, ribbon = model.fine.tiling, model.ribbon
    points = tiling.points
    faces = tiling.linear_subcells()[:, :4]
    faces = faces[(np.abs(points[faces, 2]) < 1e-9 * ribbon.period).all(axis=1)]
    nodes, faces = np.unique(faces, return_inverse=True)
    faces = faces.reshape(-1, 4)
    motion = tiling.lifted(modes.fields[:, [number]])[nodes, :, 0]
    motion[:, :2] = motion[:, :2] @ ribbon.turn.T
    which = int(np.linalg.norm(motion, axis=0).argmax())
    field = motion[:, which]
    field = field / field[np.abs(field).argmax()]
    dataset = xr.Dataset(
        {
            "field_position": (("node", "axis"), points[nodes, :2] @ ribbon.turn.T),
            "field_triangle": (("triangle", "vertex"), np.concatenate([faces[:, :3], faces[:, [0, 2, 3]]])),
            "field_real": ("node", field.real),
            "field_imag": ("node", field.imag),
            "field_frequency": ((), float(chosen["frequency"])),
            "field_phase": ((), float(chosen["phase"])),
            "field_component": ((), which),
        }
    )
    for name, unit in (("field_position", "m"), ("field_frequency", "Hz"), ("field_phase", "rad")):
        dataset[name].attrs["units"] = unit
    for name in ("field_triangle", "field_real", "field_imag", "field_component"):
        dataset[name].attrs["units"] = "1"
    return dataset
