"""Pictures and files of a scan."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from haptonic import plots
from haptonic.later import Axes, Figure, xarray as xr
from haptonic.names import cell, file_parts
from haptonic.plate.layout.grid import Layout
from haptonic.response import write
from haptonic.results.common import write_netcdf
from haptonic.results.plain import split
from haptonic.results.result import figure, file, page
from haptonic.vibrometry.guides import Guiding, guides_of
from haptonic.vibrometry.theory import guided

if TYPE_CHECKING:
    from haptonic.results.scan.value import ScanResult


def _mapped(scan: ScanResult) -> bool:
    return scan.mapped


def _has(name: str) -> Callable[[ScanResult], bool]:
    return lambda scan: name in scan.data


@figure("average", "{Origin} velocity averaged over all points.")
def average(scan: ScanResult, *, ax: Axes | None = None) -> Figure:
    velocity, units = scan.data["average"].values, scan.response.units
    return plots.average_response(scan.response.frequency, velocity, units=units, origin=scan.origin, ax=ax)


@figure(
    "quality",
    "{Origin} share of noise at every point, 1 less its median coherence; points with flags are marked.",
)
def quality(scan: ScanResult, *, ax: Axes | None = None) -> Figure:
    return plots.point_quality(scan.response.points, scan.quality, origin=scan.origin, ax=ax)


@figure("maps", "{Origin} normal displacement, all maps on one scale.", when=_mapped)
def maps(scan: ScanResult, *, frequency: float | None = None, ax: Axes | None = None) -> Figure:
    if ax is not None:
        return plots.map_at(scan.response, frequency or scan.loudest, scan.layout, scan.gap_edges, ax=ax)
    shapes = scan.shapes
    if frequency is not None:
        shapes = (frequency,)
    return plots.maps(scan.response, shapes, scan.layout, scan.gap_edges)


@figure("velocity", "{Origin} velocity of the regions.", when=_has("rms"))
def velocity(scan: ScanResult, *, ax: Axes | None = None) -> Figure:
    levels = {name: level.values for name, level in split(scan.data.get("rms"), "region").items()}
    gaps = [scan.gap_edges] if scan.gap_edges else []
    return plots.velocity_spectrum(
        scan.response.frequency, levels, gaps, units=scan.response.units, origin=scan.origin, ax=ax
    )


@figure(
    "contrast",
    "{Origin} contrast of the driven region; the range of high contrast is the bar on the upper edge.",
    when=_has("contrast"),
)
def contrast(scan: ScanResult, *, ax: Axes | None = None) -> Figure:
    curves = {name: level.values for name, level in scan.contrasts.items()}
    return plots.measured_contrast(
        scan.response.frequency, curves, scan.measured, scan.gap_edges, origin=scan.origin, ax=ax
    )


@figure("waves-*", "{Origin} waves along a guide.", when=_has("waves"))
def waves(scan: ScanResult) -> dict[str, Callable[[], Figure]]:
    assert scan.layout is not None
    named, present = wave_names(scan.layout), scan.data["guide"].values.tolist()
    return {
        named[guide.region]: partial(_waves_along, scan, guide)
        for guide in guides_of(scan.layout)
        if guide.region in present
    }


def _waves_along(scan: ScanResult, guide: Guiding, *, ax: Axes | None = None) -> Figure:
    seen, plain, mode = waves_of(scan.data, guide.region), None, None
    if scan.waves is not None:
        plain = scan.waves["frequency"].values, scan.waves["wavenumber"].values
        mode = guided(scan.waves, guide) if scan.gap else None
    return plots.wave_map(seen, plain, mode, region=guide.region, origin=scan.origin, ax=ax)


@figure(
    "row_decay",
    "{Origin} decay of waves from row to row of the lattice, means over frequency.",
    when=_has("row_decay"),
)
def row_decay(scan: ScanResult, *, ax: Axes | None = None) -> Figure:
    return plots.decay_map(scan.data["row_decay"], scan.lattice, scan.gap_edges, origin=scan.origin, ax=ax)


@figure("decay", "{Origin} decay into the lattice.", when=_has("decay"))
def decay(scan: ScanResult, *, ax: Axes | None = None) -> Figure:
    assert scan.decay is not None
    return plots.measured_decay(scan.decay, scan.computed_decay, scan.gap_edges, origin=scan.origin, ax=ax)


@file("response.nc")
def write_response(scan: ScanResult, path: Path) -> None:
    write(scan.response, path)


@file("scan.nc")
def write_data(scan: ScanResult, path: Path) -> None:
    write_netcdf(scan.dataset.assign_attrs(report=json.dumps(scan.to_json())), path)


@file("shape.gif", when=_mapped)
def animate(scan: ScanResult, path: Path) -> None:
    path.write_bytes(plots.animated(scan.response, scan.loudest, scan.layout))


write_view = page("scan.html", when=lambda scan: scan.interactive and scan.mapped)


@file("points.csv")
def write_points(scan: ScanResult, path: Path) -> None:
    seen = scan.quality
    with path.open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["point", "x (m)", "y (m)", "clipped", "frozen", "coherence", "flags", "origin"])
        for i, (x, y) in enumerate(scan.response.points):
            coherence = f"{seen.coherence[i]:.5f}" if np.isfinite(seen.coherence[i]) else ""
            table.writerow(
                [cell(seen.names[i]), f"{x:.7g}", f"{y:.7g}", f"{seen.clipped[i]:.3g}",
                 f"{seen.frozen[i]:.3g}", coherence, "; ".join(seen.flags[i]), scan.origin]
            )  # fmt: skip


PRODUCTS = (
    average, quality, maps, velocity, contrast, waves, row_decay, decay,
    write_response, write_data, animate, write_view, write_points,
)  # fmt: skip


def waves_of(data: xr.Dataset, guide: str) -> xr.DataArray:
    """(frequency, wavenumber) amplitude of the waves along a guide."""
    seen = data["waves"].sel(guide=guide)
    finite = np.isfinite(seen["wavenumber"].values)
    cut = seen.isel(step=finite).drop_vars("guide")
    return cut.swap_dims(step="wavenumber")


def wave_names(layout: Layout) -> dict[str, str]:
    """Name of the picture of the waves along each region."""
    return {name: f"waves-{part}" for name, part in file_parts(layout.regions).items()}
