"""What a scan told: its response, the quality of its points, the gap, waves along guides, decay."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable
from dataclasses import asdict, dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from haptonic import plots
from haptonic.bloch import Gap
from haptonic.names import cell, file_parts
from haptonic.plate import Plate
from haptonic.plate.layout import Layout
from haptonic.response import FrequencyResponse, write
from haptonic.results.common import write_netcdf
from haptonic.results.scan.computed import guided
from haptonic.results.scan.places import Mirror, guides_of
from haptonic.vibrometry import LatticeGap, MeasuredGap, Quality, ReadReport, Registration

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False)
class ScanResult:
    """A scan that was read, estimated and, if a plate was given, laid on it.

    response : per unit of its reference; quality : of its points; report : of how it was read
    averages : 0 where the instrument estimated the response itself
    dataset : ``average``, and on a plate ``rms REGION``, ``contrast A over B``, ``waves REGION``, ``decay
        ...`` against frequency
    shapes : frequencies of the operating shapes, Hz
    measured : range in which the driven region stands out; lattice : edges of the gap by how waves fade
    gap : of the lattice, computed; waves : see `computed_waves`
    told : what could not be told, and why
    """

    response: FrequencyResponse
    quality: Quality
    report: ReadReport
    averages: int
    dataset: xr.Dataset
    shapes: tuple[float, ...]
    plate: Plate | None = None
    carrier: float | None = None
    gap: Gap | None = None
    measured: MeasuredGap | None = None
    lattice: LatticeGap | None = None
    registration: Registration | None = None
    waves: xr.Dataset | None = None
    mirror: Mirror | None = None
    told: tuple[str, ...] = ()

    @property
    def origin(self) -> str:
        """ "simulated" or "measured"."""
        return str(self.response.dataset.attrs["origin"])

    @property
    def loudest(self) -> float:
        """The operating shape nearest to the carrier, or else the only one, Hz."""
        return min(self.shapes, key=lambda f: abs(f - (self.carrier or f)))

    @property
    def contrasts(self) -> dict[str, xr.DataArray]:
        """dB against frequency, by what is compared."""
        return self._named("contrast ")

    @property
    def decay(self) -> xr.Dataset | None:
        """See `haptonic.vibrometry.lattice_decay`; None where it could not be fitted."""
        found = xr.Dataset(self._named("decay "))
        return found.assign_attrs(json.loads(self.dataset.attrs["decay"])) if found else None

    def _named(self, start: str) -> dict[str, xr.DataArray]:
        return {str(n)[len(start) :]: v for n, v in self.dataset.items() if str(n).startswith(start)}

    @property
    def _edges(self) -> tuple[float, float] | None:
        return (self.gap.lower, self.gap.upper) if self.gap else None

    @property
    def layout(self) -> Layout | None:
        return self.plate.layout if self.plate else None

    @property
    def mapped(self) -> bool:
        """Whether there are maps and an animation: they need the motion normal to the plate."""
        return "z" in self.response.dataset["direction"].values

    @staticmethod
    def figure_names(plate: Plate | None) -> list[str]:
        """Of all pictures that may be drawn."""
        names = ["average", "maps", "quality"]
        if plate is not None:
            names += [
                "contrast",
                "velocity",
                "decay",
                "fading",
                *wave_names(plate.layout).values(),
            ]
        return names

    def figures(self) -> dict[str, Figure]:
        """All pictures but the animation, by name."""
        lines, origin, units = self.response.frequency, self.origin, self.response.units
        average = self.dataset["average"].values
        found = {
            "average": plots.average_response(lines, average, units=units, origin=origin),
            "quality": plots.point_quality(self.response.points, self.quality, origin=origin),
        }
        if self.mapped:
            found["maps"] = plots.maps(self.response, self.shapes, self.layout, self._edges)
        if self.plate is None:
            return found
        if levels := {name: level.values for name, level in self._named("rms ").items()}:
            found["velocity"] = plots.velocity_spectrum(
                lines, levels, self._edges, units=units, origin=origin
            )
        if curves := {name: level.values for name, level in self.contrasts.items()}:
            found["contrast"] = plots.measured_contrast(
                lines, curves, self.measured, self._edges, origin=origin
            )
        named = wave_names(self.plate.layout)
        for guide in guides_of(self.plate.layout):
            if f"waves {guide.region}" in self.dataset:
                seen = self.dataset[f"waves {guide.region}"].rename(
                    {f"wavenumber {guide.region}": "wavenumber"}
                )
                plain = mode = None
                if self.waves is not None:
                    plain = self.waves["frequency"].values, self.waves["wavenumber"].values
                    mode = guided(self.waves, guide)
                found[named[guide.region]] = plots.wave_map(
                    seen, plain, mode, region=guide.region, origin=origin
                )
        if "fading" in self.dataset:
            found["fading"] = plots.fading_map(
                self.dataset["fading"], self.lattice, self._edges, origin=origin
            )
        if self.decay is not None:
            found["decay"] = plots.fading(self.decay, self._fading, self._edges, origin=origin)
        return found

    @property
    def _fading(self) -> xr.Dataset | None:
        if self.waves is None or "attenuation" not in self.waves:
            return None
        return xr.Dataset({"attenuation": self.waves["attenuation"]}).rename(mirror_frequency="frequency")

    def files(self) -> dict[str, Callable[[Path], object]]:
        """Writers of the files by name."""
        attributes = {"origin": self.origin, "report": json.dumps(self.to_json())}
        return {
            "response.nc": partial(write, self.response),
            "scan.nc": partial(write_netcdf, self.dataset.assign_attrs(attributes)),
            "points.csv": self._write_points,
        }

    def _write_points(self, path: Path) -> None:
        quality = self.quality
        with path.open("w", newline="", encoding="utf-8") as file:
            table = csv.writer(file, lineterminator="\n")
            table.writerow(["point", "x (m)", "y (m)", "clipped", "frozen", "coherence", "flags", "origin"])
            for i, (x, y) in enumerate(self.response.points):
                coherence = f"{quality.coherence[i]:.5f}" if np.isfinite(quality.coherence[i]) else ""
                table.writerow(
                    [cell(quality.names[i]), f"{x:.7g}", f"{y:.7g}", f"{quality.clipped[i]:.3g}",
                     f"{quality.frozen[i]:.3g}", coherence, "; ".join(quality.flags[i]), self.origin]
                )  # fmt: skip

    def told_at(self, frequency: float) -> dict[str, Any]:
        """Plain values at one frequency, Hz."""
        line = self.dataset.sel(frequency=frequency, method="nearest")
        found = {"frequency_hz": float(line["frequency"]), "rms_of_all": float(line["average"])}
        found["rms"] = {name: _finite(line[f"rms {name}"]) for name in self._named("rms ")}  # type: ignore[assignment]
        found["contrast_db"] = {name: _finite(line[f"contrast {name}"]) for name in self.contrasts}  # type: ignore[assignment]
        if "decay decay" in line:
            decay = {name: float(line[f"decay {name}"]) for name in ("decay", "low", "high")}
            if (fading := self._fading) is not None and fading["frequency"].min() <= frequency <= fading[
                "frequency"
            ].max():
                near = fading["attenuation"].interp(frequency=frequency).values
                decay |= {"computed_least": float(near.min()), "computed_largest": float(near.max())}
            found["decay_db_per_cell"] = decay  # type: ignore[assignment]
        return found

    def to_json(self) -> dict[str, Any]:
        """Plain values for machines."""
        quality, attributes, registration = self.quality, self.response.dataset.attrs, self.registration
        lines = self.response.frequency
        return {
            "origin": self.origin,
            "format": self.report.format,
            "points": self.response.dataset.sizes["point"],
            "dropped": [str(one) for one in self.report.dropped],
            "missing": list(self.report.missing),
            "remarks": [*self.report.remarks, *self.told, *(self.lattice.reasons if self.lattice else ())],
            "lines": len(lines),
            "band_hz": [float(lines[0]), float(lines[-1])],
            "averages": self.averages,
            "units": self.response.units,
            "reference": attributes["reference"],
            "flags": {flag: int(quality.flagged(flag).sum())
                      for flag in ("saturated", "dropout", "low coherence", "repaired")},
            "registration": None if registration is None else {
                "scale": registration.scale, "angle_rad": registration.angle,
                "shift_m": registration.shift.tolist(), "mirrored": registration.mirrored,
                "misfit_m": registration.misfit,
            },
            "gap": None if self.lattice is None else asdict(self.lattice),
            "contrast_range": None if self.measured is None else asdict(self.measured),
            "computed_gap_hz": self._edges,
            "shapes": [self.told_at(frequency) for frequency in self.shapes],
        }  # fmt: skip


def _finite(value: xr.DataArray) -> float | None:
    return float(value) if np.isfinite(value) else None


def wave_names(layout: Layout) -> dict[str, str]:
    """By region, what the picture of the waves along it is called."""
    return {name: f"waves-{part}" for name, part in file_parts(layout.regions).items()}
