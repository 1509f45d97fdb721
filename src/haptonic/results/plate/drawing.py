"""Pictures and files of a plate."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from haptonic import plots
from haptonic.later import Axes, Figure
from haptonic.names import file_parts, listed
from haptonic.plate import Plate
from haptonic.plate.vibration.region_measures import compared
from haptonic.response import write
from haptonic.results.common import write_netcdf
from haptonic.results.result import figure, file, page
from haptonic.vtu import write_body

if TYPE_CHECKING:
    from haptonic.results.plate.value import PlateResult


def _has_spectrum(result: PlateResult) -> bool:
    return len(result.response.frequency) > 1


def _compares(result: PlateResult) -> bool:
    return _has_spectrum(result) and bool(compared(result.response, result.driven))


@figure("plan", "Simulated plate: its pillars, regions, actuators and supports.")
def plan(result: PlateResult, *, ax: Axes | None = None) -> Figure:
    return plots.plate_plan(result.plate, ax=ax)


@figure("maps", "Simulated normal displacement of the flat face, all maps on one scale.")
def maps(result: PlateResult, *, frequency: float | None = None, ax: Axes | None = None) -> Figure:
    layout, drive = result.plate.layout, result.drive
    gap = None if result.answers else result.gap_edges  # lattices of several carriers have different gaps
    shown, lines = result.marked, result.marked.frequency.tolist()
    if frequency is not None:
        shown, lines = result.response, [frequency]
    if ax is not None:
        return plots.map_at(shown, frequency or result.resonance, layout, gap, drive=drive, ax=ax)
    return plots.maps(shown, lines, layout, gap, drive=drive)


@figure(
    "carriers",
    "Simulated normal displacement of the flat face at each carrier, with its own drives alone.",
    when=lambda result: result.answers,
)
def carriers(result: PlateResult) -> Figure:
    alone = [(listed(answer.drives), answer.result) for answer in result.answers]
    driven = {drives: (each.marked, each.drive, each.gap_edges) for drives, each in alone}
    return plots.maps_of_drives(driven, result.plate.layout)


@figure("velocity", "Simulated velocity of the regions.", when=_has_spectrum)
def velocity(result: PlateResult, *, ax: Axes | None = None) -> Figure:
    levels = {name: level.values for name, level in result.levels.items()}
    return plots.velocity_spectrum(
        result.response.frequency, levels, result.gaps, units=result.response.units,
        drive=result.drive, carrier=result.carrier, origin=result.origin, ax=ax,
    )  # fmt: skip


@figure("contrast", "Simulated contrast of the driven region.", when=_compares)
def contrast(result: PlateResult, *, ax: Axes | None = None) -> Figure:
    curves = {name: level.values for name, level in result.contrasts(result.response).items()}
    lines = result.response.frequency
    return plots.contrast_spectrum(
        lines, curves, result.gaps, carrier=result.carrier, origin=result.origin, ax=ax
    )


@figure(
    "impedance-*",
    "Simulated conductance and capacitance of a driven actuator, which give its electrical impedance.",
    when=_has_spectrum,
)
def impedances(result: PlateResult) -> dict[str, Callable[[], Figure]]:
    return {
        name: partial(_impedance, result, actuator)
        for actuator, name in impedance_names(result.plate).items()
        if result.impedance(actuator).any()
    }


def _impedance(result: PlateResult, actuator: str) -> Figure:
    lines, values = result.lines["frequency"].values, result.impedance(actuator)
    return plots.impedance_spectrum(lines, values, result.gaps, origin=result.origin)


@file("response.nc")
def write_response(result: PlateResult, path: Path) -> None:
    write(result.response, path)


@file("maps.nc")
def write_maps(result: PlateResult, path: Path) -> None:
    write(result.marked, path)


@file("modes.nc")
def write_modes(result: PlateResult, path: Path) -> None:
    write_netcdf(result.modes, path)


@file("plate.vtu")
def write_solid(result: PlateResult, path: Path) -> None:
    write_body(path, result.body)


write_view = page("plate.html")


@file("carrier.gif")
def animate(result: PlateResult, path: Path) -> None:
    content = plots.animated(result.marked, result.resonance, result.plate.layout, drive=result.drive)
    path.write_bytes(content)


PRODUCTS = (
    plan, maps, carriers, velocity, contrast, impedances,
    write_response, write_maps, write_modes, write_solid, write_view, animate,
)  # fmt: skip


def impedance_names(plate: Plate) -> dict[str, str]:
    """Name of the picture of each actuator's impedance."""
    parts = file_parts(actuator.name for actuator in plate.actuators)
    return {name: f"impedance-{part}" for name, part in parts.items()}
