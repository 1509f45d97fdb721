"""Datasets of a lattice as a mirror: decay of waves in it, and transmission through a few rows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from haptonic.arrays import Array, Complex
from haptonic.bloch.evanescent import bloch_waves
from haptonic.bloch.layers import OUTGOING, Interface, Scattering
from haptonic.bloch.plate_waves import FAMILIES
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.row_fields import RowFields, WaveField
from haptonic.bloch.rows import CondensedRows
from haptonic.cell import Rows, UnitCell
from haptonic.errors import StudyError
from haptonic.gate import WORD, declared, titled
from haptonic.later import xarray as xr
from haptonic.parallel import each, one_thread
from haptonic.units import format_quantity

PHASES = np.linspace(0.0, np.pi, 5)  # along the rows, for the decay
SHOWN_WAVES = 8  # of each frequency in the complex band structure: the least attenuated ones
MOST_ROWS = 60  # computed for a given insulation
GOALS = (20.0, 40.0, 60.0)  # dB
SILENT = "the incident wave does not propagate"
LEAST_SHARE = 1e-30  # of the energy; smaller shares are rounding errors


@lru_cache(maxsize=2)
def condensed_rows(cell: UnitCell, resolution: Resolution, along: tuple[int, int] = (0, 1)) -> CondensedRows:
    """Condense rows of a cell, cached for the next task of a worker."""
    return CondensedRows.of(cell, resolution, along)


def opposite_rows(cell: UnitCell, resolution: Resolution, along: tuple[int, int]) -> CondensedRows | None:
    """Rows on the left of a strip, turned by half a turn; None if they are images of those on the right."""
    rows = Rows(cell, along)
    if rows.is_reversible(rows.turn[0]):
        return None
    return condensed_rows(cell, resolution, (-along[0], -along[1]))


@dataclass(frozen=True)
class Incidence:
    """Incident waves from the left plate.

    angle : from the normal of the rows, rad; layers : largest number of rows
    loss_factor : of the rows; the plates have no losses
    """

    angle: float
    layers: int
    loss_factor: float


@one_thread()
def mirror_dataset(
    rows: CondensedRows, frequency: Array, incidence: Incidence, fields: bool = False
) -> xr.Dataset:
    """Complex band structure and transmission at some frequencies.

    Returns
    -------
    dataset with dimensions ``frequency`` (Hz), ``wave``, ``phase``, ``rows``, ``incident`` and ``outgoing``:
    ``kappa`` complex phases per row of the waves to the right at normal incidence (as real and imaginary
    part), ``attenuation`` (dB per row) of the least attenuated wave for each phase along the rows,
    ``reflected`` and ``transmitted`` energies as shares of the incident energy, NaN if the incident wave does
    not propagate; with ``fields`` also those of the waves at normal incidence, see `waves_dataset`
    """
    slabs = [rows.slab(float(phase)) for phase in PHASES]
    normal = Interface.of(rows, 0.0)
    row_fields = RowFields.of(rows, float(PHASES[0])) if fields else None

    def at_frequency(at: float) -> tuple[Complex, Array, Array, WaveField | None]:
        omega = 2 * np.pi * at
        waves = [bloch_waves(slab.at(omega), omega)[0] for slab in slabs]
        shares = np.full((2, incidence.layers, len(FAMILIES), len(OUTGOING)), np.nan)
        for family, scattering in scattering_at(rows, at, incidence, normal).items():
            shares[:, :, FAMILIES.index(family)] = scattering.reflected[:, 0], scattering.transmitted[:, 0]
        exponents = rows.exponents(waves[0], float(PHASES[0]))[:SHOWN_WAVES]
        shown = waves[0].chosen(np.arange(SHOWN_WAVES))
        field = row_fields.field(omega, shown) if row_fields else None
        return -1j * exponents, np.array([rows.decay(right) for right in waves]), shares, field

    columns = zip(*each(at_frequency, frequency.tolist()), strict=True)
    *numbers, wave_fields = columns
    kappa, attenuation, energy = (np.array(column) for column in numbers)
    shares = np.moveaxis(energy, 1, 0)
    by_rows = ("frequency", "rows", "incident", "outgoing")
    dataset = titled({
        "kappa_real": (("frequency", "wave"), kappa.real, "rad", "phase per row, real part"),
        "kappa_imag": (("frequency", "wave"), kappa.imag, "rad", "phase per row, imaginary part"),
        "attenuation": (
            ("frequency", "phase"), attenuation, "dB", "decay per row of the least attenuated wave",
        ),
        "reflected": (by_rows, shares[0], "1", "share of the incident energy"),
        "transmitted": (by_rows, shares[1], "1", "share of the incident energy"),
        "frequency": ("frequency", frequency, "Hz", "frequency"),
        "phase": ("phase", PHASES, "rad", "phase along the rows"),
    })  # fmt: skip
    dataset = dataset.assign_coords(
        rows=np.arange(1, incidence.layers + 1), incident=list(FAMILIES), outgoing=list(OUTGOING)
    )
    declared(dataset, reflected=SILENT, transmitted=SILENT)
    return dataset if row_fields is None else dataset.merge(row_fields.dataset(wave_fields))


def scattering_at(
    rows: CondensedRows, frequency: float, incidence: Incidence, normal: Interface | None = None
) -> dict[str, Scattering]:
    """Scattering of each kind of incident wave that propagates at this angle, at one frequency (Hz).

    ``normal`` is the interface at normal incidence, if it was computed before.
    """
    omega = 2 * np.pi * frequency
    if incidence.angle == 0:
        normal = normal or Interface.of(rows, 0.0)
        families = normal.incoming(omega)
        scattering = normal.scattering(omega, incidence.layers, families, incidence.loss_factor)
        return {family: scattering.of(family) for family in families}
    each_by = {}
    for family in FAMILIES:
        try:
            interface = Interface.met_by(rows, omega, family, incidence.angle)
            each_by[family] = interface.scattering(omega, incidence.layers, (family,), incidence.loss_factor)
        except StudyError as error:
            if error.argument != "layers.incident":
                raise
    return each_by


def errors_if_moved(values: Array, at: Array, frequency: Array, curve: Array, share: float) -> Array:
    """(n,) errors of values of a curve (f,) over frequencies (f,); NaN remains.

    An error is the largest change if the lattice's frequencies move by the bound ``share`` of their relative
    error, and this share of the value.

    values : (n,) at the frequencies ``at`` (n,)
    """
    moved = [np.interp(at * (1 + by), frequency, curve) for by in (-share, share)]
    return error_if_moved(values, moved, share)


def error_if_moved(values: Array, moved: Sequence[ArrayLike], share: float) -> Array:
    """Errors of values: the largest change to those of moved frequencies, and a share of the values.

    NaN, in values and among the moved ones, is a wave that does not propagate.
    """
    # at the end of a wave's range only one is known
    change = np.fmax.reduce(np.abs(np.array(moved) - values))
    return np.asarray(np.where(np.isnan(values), np.nan, np.nan_to_num(change) + share * np.abs(values)))


def first_reaching(insulation: Sequence[float] | Array, goal: float) -> int | None:
    """Smallest number of rows from which on the insulation reaches a goal, dB; None if it does not."""
    below = np.flatnonzero(np.asarray(insulation) < goal)
    rows = int(below[-1]) + 2 if len(below) else 1
    return rows if rows <= len(insulation) else None


def at_carrier(rows: CondensedRows, carrier: float, incidence: Incidence) -> dict[str, Scattering]:
    """Compute the scattering by many rows at the carrier, by family of the incident wave."""
    by_family = scattering_at(rows, carrier, replace(incidence, layers=MOST_ROWS))
    if not by_family:
        raise StudyError.no_answer(
            argument="layers.angle",
            given=f"{np.degrees(incidence.angle):g} deg at {format_quantity(carrier, 'Hz')}",
            allowed="an angle at which some plate wave propagates towards the rows",
            cause="all waves are evanescent",
            next_step="give a smaller angle",
        )
    return by_family


def carrier_dataset(scatterings: Mapping[str, Scattering]) -> xr.Dataset:
    """Dataset of energies at the carrier for 1, 2, ... many rows; NaN for families that do not propagate."""
    shape = len(FAMILIES), MOST_ROWS, len(OUTGOING)
    arrays = {}
    for name in ("transmitted", "reflected"):
        values = np.full(shape, np.nan)
        for family, scattering in scatterings.items():
            values[FAMILIES.index(family)] = getattr(scattering, name)[:, 0]
        arrays[f"carrier_{name}"] = ("incident", "many", "outgoing"), values, {"units": "1", WORD: SILENT}
    coords = {"many": np.arange(1, MOST_ROWS + 1), "incident": list(FAMILIES), "outgoing": list(OUTGOING)}
    return xr.Dataset(arrays, coords=coords)


def loss_at_carrier(dataset: xr.Dataset) -> xr.DataArray:
    """(incident, many) insertion loss at the carrier, dB, from a `carrier_dataset`."""
    return _decibels(dataset["carrier_transmitted"].sum("outgoing", skipna=False))


def passed_by_rows(dataset: xr.Dataset, families: Sequence[str]) -> xr.Dataset:
    """(incident, rows) insertion loss and dissipation of many rows at the carrier.

    Parameters
    ----------
    dataset : with ``carrier_transmitted`` and ``carrier_reflected`` (incident, outgoing, many), shares of the
        incident energy
    families : kinds of waves that propagate at the carrier

    Returns
    -------
    ``insulation`` : insertion loss for all transmitted energy, dB; ``same_wave`` : for energy of the incident
    kind only; ``dissipated`` : share of the incident energy dissipated in the rows
    """
    data = dataset[["carrier_transmitted", "carrier_reflected"]].sel(incident=families).rename(many="rows")
    passed, reflected = data["carrier_transmitted"], data["carrier_reflected"]
    alike = xr.DataArray(families, dims="incident")
    return xr.Dataset(
        {
            "insulation": loss_at_carrier(dataset).sel(incident=families).rename(many="rows"),
            "same_wave": _decibels(passed.sel(outgoing=alike).drop_vars("outgoing")),
            "dissipated": 1 - (passed + reflected).sum("outgoing"),
        }
    )


def _decibels(share: xr.DataArray) -> xr.DataArray:
    """Decibels below the incident energy."""
    return xr.DataArray(-10 * np.log10(share.clip(min=LEAST_SHARE))).assign_attrs(units="dB")
