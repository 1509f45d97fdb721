"""A lattice as a mirror, as labelled arrays: how waves fade in it, and what a few rows of it let through."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from haptonic.arrays import Array, Complex
from haptonic.bloch.evanescent import bloch_waves
from haptonic.bloch.layers import OUTGOING, Interface, Scattering
from haptonic.bloch.plate_waves import FAMILIES
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.rows import CondensedRows
from haptonic.cell import UnitCell
from haptonic.errors import StudyError
from haptonic.gate import WORD
from haptonic.later import xarray as xr
from haptonic.parallel import each, one_thread
from haptonic.units import format_quantity

PHASES = np.linspace(0.0, np.pi, 5)  # along the rows, at which the decay is followed
SHOWN_WAVES = 8  # of each frequency in the complex band structure: those that reach farthest
MOST_ROWS = 60  # tried for a given insulation
GOALS = (20.0, 40.0, 60.0)  # dB
LEAST_SHARE = 1e-30  # of the energy: below it rounding is all that is left


@lru_cache(maxsize=2)
def condensed_rows(cell: UnitCell, resolution: Resolution, along: tuple[int, int] = (0, 1)) -> CondensedRows:
    """Rows of a cell; kept for the next task of a worker."""
    return CondensedRows.of(cell, resolution, along)


@dataclass(frozen=True)
class Incidence:
    """Waves that come from the left plate.

    angle : from the normal of the rows, rad; layers : rows, all fewer ones are computed as well
    loss_factor : of the rows; the plates have none
    """

    angle: float
    layers: int
    loss_factor: float


@one_thread()
def mirror_dataset(rows: CondensedRows, frequency: Array, incidence: Incidence) -> xr.Dataset:
    """Complex band structure and transmission at some frequencies.

    Returns
    -------
    dataset with dimensions ``frequency`` (Hz), ``wave``, ``phase``, ``rows``, ``incident`` and ``outgoing``:
    ``kappa`` complex phases per row of the waves to the right at normal incidence (as real and imaginary
    part), ``attenuation`` (dB per row) of the one that reaches farthest for each phase along the rows,
    ``reflected`` and ``transmitted`` energies as shares of the incident one, NaN where the incident wave does
    not propagate
    """
    slabs = [rows.slab(float(phase)) for phase in PHASES]
    normal = Interface.of(rows, 0.0)

    def one(at: float) -> tuple[Complex, Array, Array]:
        omega = 2 * np.pi * at
        waves = [bloch_waves(slab.at(omega), omega)[0] for slab in slabs]
        shares = np.full((2, incidence.layers, len(FAMILIES), len(OUTGOING)), np.nan)
        for family, found in scattering_at(rows, at, incidence, normal).items():
            shares[:, :, FAMILIES.index(family)] = found.reflected[:, 0], found.transmitted[:, 0]
        exponents = rows.exponents(waves[0], float(PHASES[0]))[:SHOWN_WAVES]
        return -1j * exponents, np.array([rows.decay(right) for right in waves]), shares

    columns = zip(*each(one, frequency.tolist()), strict=True)
    kappa, attenuation, energy = (np.array(column) for column in columns)
    shares = np.moveaxis(energy, 1, 0)
    by_rows = ("frequency", "rows", "incident", "outgoing")
    return xr.Dataset(
        {
            "kappa_real": (("frequency", "wave"), kappa.real, _words("rad", "phase per row, real part")),
            "kappa_imag": (("frequency", "wave"), kappa.imag, _words("rad", "the same, imaginary part")),
            "attenuation": (
                ("frequency", "phase"), attenuation,
                _words("dB", "decay per row of the wave that reaches farthest"),
            ),
            "reflected": (by_rows, shares[0], _of_incident()),
            "transmitted": (by_rows, shares[1], _of_incident()),
        },
        coords={
            "frequency": ("frequency", frequency, _words("Hz", "frequency")),
            "phase": ("phase", PHASES, _words("rad", "phase along the rows")),
            "rows": np.arange(1, incidence.layers + 1),
            "incident": list(FAMILIES),
            "outgoing": list(OUTGOING),
        },
    )  # fmt: skip


def _of_incident() -> dict[str, str]:
    return _words("1", "share of the incident energy") | {WORD: "the incident wave does not propagate"}


def _words(unit: str, title: str) -> dict[str, str]:
    return {"units": unit, "long_name": title}


def scattering_at(
    rows: CondensedRows, frequency: float, incidence: Incidence, normal: Interface | None = None
) -> dict[str, Scattering]:
    """What happens to each kind of incident wave at one frequency (Hz), if it propagates at this angle.

    ``normal`` is the interface at normal incidence, if it is there already.
    """
    omega = 2 * np.pi * frequency
    if incidence.angle == 0:
        normal = normal or Interface.of(rows, 0.0)
        there = normal.incoming(omega)
        found = normal.scattering(omega, incidence.layers, there, incidence.loss_factor)
        return {family: found.of(family) for family in there}
    each_by = {}
    for family in FAMILIES:
        try:
            interface = Interface.met_by(rows, omega, family, incidence.angle)
            each_by[family] = interface.scattering(omega, incidence.layers, (family,), incidence.loss_factor)
        except StudyError as error:
            if error.argument != "layers.incident":
                raise
    return each_by


def first_reaching(insulation: Sequence[float] | Array, goal: float) -> int | None:
    """Number of rows (from 1) from which the insulation stays at a goal, dB; None if it never does."""
    below = np.flatnonzero(np.asarray(insulation) < goal)
    rows = int(below[-1]) + 2 if len(below) else 1
    return rows if rows <= len(insulation) else None


def at_carrier(rows: CondensedRows, carrier: float, incidence: Incidence) -> dict[str, Scattering]:
    """Energies for many rows at the carrier, by family of the incident wave."""
    found = scattering_at(rows, carrier, replace(incidence, layers=MOST_ROWS))
    if not found:
        raise StudyError.no_answer(
            argument="layers.angle",
            given=f"{np.degrees(incidence.angle):g} deg at {format_quantity(carrier, 'Hz')}",
            allowed="an angle at which some plate wave propagates towards the rows",
            cause="all of them only fade",
            next_step="give a smaller angle",
        )
    return found


def carrier_dataset(found: Mapping[str, Scattering]) -> xr.Dataset:
    """Energies at the carrier for 1, 2, ... many rows; NaN for families that do not propagate."""
    shape = len(FAMILIES), MOST_ROWS, len(OUTGOING)
    arrays, silent = {}, {WORD: "the incident wave does not propagate"}
    for name in ("transmitted", "reflected"):
        values = np.full(shape, np.nan)
        for family, scattering in found.items():
            values[FAMILIES.index(family)] = getattr(scattering, name)[:, 0]
        arrays[f"carrier_{name}"] = ("incident", "many", "outgoing"), values, {"units": "1", **silent}
    coords = {"many": np.arange(1, MOST_ROWS + 1), "incident": list(FAMILIES), "outgoing": list(OUTGOING)}
    return xr.Dataset(arrays, coords=coords)


def passed_by_rows(dataset: xr.Dataset, families: Sequence[str]) -> xr.Dataset:
    """(incident, rows) what many rows do at the carrier to each kind of wave that propagates there.

    Parameters
    ----------
    dataset : with ``carrier_transmitted`` and ``carrier_reflected`` (incident, outgoing, many), shares of the
        incident energy
    families : kinds of waves that propagate at the carrier

    Returns
    -------
    ``insulation`` : all transmitted energy, dB below the incident one; ``same_wave`` : that of the incident
    kind alone; ``dissipated`` : share of the incident energy that the rows turn into heat
    """
    data = dataset[["carrier_transmitted", "carrier_reflected"]].sel(incident=families).rename(many="rows")
    passed, reflected = data["carrier_transmitted"], data["carrier_reflected"]
    alike = xr.DataArray(families, dims="incident")
    return xr.Dataset(
        {
            "insulation": _decibels(passed.sum("outgoing")),
            "same_wave": _decibels(passed.sel(outgoing=alike).drop_vars("outgoing")),
            "dissipated": 1 - (passed + reflected).sum("outgoing"),
        }
    )


def _decibels(share: xr.DataArray) -> xr.DataArray:
    """Below the incident energy."""
    return xr.DataArray(-10 * np.log10(share.clip(min=LEAST_SHARE))).assign_attrs(units="dB")
