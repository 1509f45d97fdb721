"""Result of a scan: response, quality of its points, gap, waves along guides, decay."""

from __future__ import annotations

import json
import shutil
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from haptonic.bloch import Gap
from haptonic.gate import WORD
from haptonic.later import xarray as xr
from haptonic.plate import Plate
from haptonic.plate.layout.grid import Layout
from haptonic.progress import Progress, silent
from haptonic.response import FrequencyResponse
from haptonic.results.common import accuracy_remarks
from haptonic.results.plain import split
from haptonic.results.result import Result
from haptonic.results.scan.drawing import PRODUCTS
from haptonic.results.scan.interactive import scan_view
from haptonic.results.table import Column, Table
from haptonic.results.verdict import Verdict
from haptonic.units import hz_text
from haptonic.vibrometry import LatticeGap, MeasuredGap, Quality, ReadReport, Registration
from haptonic.vibrometry.estimation.quality import FLAGS
from haptonic.vibrometry.guides import Mirror
from haptonic.views import InteractiveView

SHOWN = ("average", "rms", "contrast", "decay", "low", "high")  # variables at the operating shapes
DECAY = ("decay", "error_of_decay", "low", "high")  # variables of the decay through a mirror


@dataclass(frozen=True, eq=False, repr=False)
class ScanResult(Result, products=PRODUCTS):
    """Responses of a scan and their analysis; with a plate, registered to it.

    response : per unit of its reference; quality : of its points; report : of the reader
    averages : 0 if the instrument estimated the response itself
    data : against frequency: ``average``, and on a plate ``rms`` (region), ``contrast`` and its ``error``
        (pair), ``waves`` (guide, step) with their ``wavenumber``, ``row_decay``, and ``decay`` of a mirror
        with its ends ``low`` and ``high``
    shapes : frequencies of the operating shapes, Hz
    measured : range with high contrast of the driven region; lattice : edges of the gap from decay
    gap : of the lattice, computed; waves : see `computed_waves`
    undetermined : reasons for missing results
    verdict : comparison with a model of the plate, if any
    state : folder from which an interrupted estimation continues
    interactive : whether the interactive page is among its files
    """

    title = "Scan"

    response: FrequencyResponse
    quality: Quality
    report: ReadReport
    averages: int
    data: xr.Dataset
    shapes: tuple[float, ...]
    plate: Plate | None = None
    carrier: float | None = None
    gap: Gap | None = None
    measured: MeasuredGap | None = None
    lattice: LatticeGap | None = None
    registration: Registration | None = None
    waves: xr.Dataset | None = None
    mirror: Mirror | None = None
    undetermined: tuple[str, ...] = ()
    verdict: Verdict | None = None
    state: Path | None = None
    interactive: bool = False

    @property
    def origin(self) -> str:
        """ "simulated" or "measured"."""
        return str(self.response.dataset.attrs["origin"])

    @property
    def loudest(self) -> float:
        """The operating shape nearest to the carrier, or else the only operating shape, Hz."""
        return min(self.shapes, key=lambda f: abs(f - (self.carrier or f)))

    @property
    def dataset(self) -> xr.Dataset:
        """The data with their origin."""
        return self.data.assign_attrs(origin=self.origin)

    @property
    def contrasts(self) -> dict[str, xr.DataArray]:
        """Contrasts in dB against frequency, by pair of regions."""
        return dict(split(self.data.get("contrast"), "pair"))

    @property
    def decay(self) -> xr.Dataset | None:
        """Decay in the lattice, see `haptonic.vibrometry.lattice_decay`; None if it could not be fitted."""
        if "decay" not in self.data:
            return None
        return self.data[list(DECAY)].assign_attrs(json.loads(self.data.attrs["decay"]))

    @property
    def gap_edges(self) -> tuple[float, float] | None:
        return self.gap.edges if self.gap else None

    @property
    def layout(self) -> Layout | None:
        return self.plate.layout if self.plate else None

    @property
    def mapped(self) -> bool:
        """True if maps and an animation are possible: they need the motion normal to the plate."""
        return "z" in self.response.dataset["direction"].values

    def view(self) -> InteractiveView | None:
        """Interactive view of the maps; None if not asked for, or without motion normal to the plate."""
        return scan_view(self) if self.interactive and self.mapped else None

    @classmethod
    def names(cls, options: Any = None) -> list[str]:
        judging = options is None or options.against is not None or options.model
        return [*super().names(options), *(Verdict.names(options) if judging else [])]

    def put(self, draft: Path, progress: Progress = silent) -> None:
        super().put(draft, progress)
        if self.verdict:
            self.verdict.put(draft, progress)

    def write(self, folder: Path | str, *, overwrite: bool = False, progress: Progress = silent) -> None:
        super().write(folder, overwrite=overwrite, progress=progress)
        if self.state is not None:  # the result is written, so the state is not needed
            shutil.rmtree(self.state, ignore_errors=True)

    def summary(self) -> list[str]:
        """Contents of the scan, agreement with a model, gap; then the rest of the comparison, and reading."""
        flags = ", ".join(f"{count} {flag}" for flag, count in self.flags.items() if count)
        low, high = (f"{self.response.frequency[end] / 1e3:.4g}" for end in (0, -1))
        sentences = [
            f"{len(self.response.points)} points ({flags or 'none flagged'}), {len(self.response.frequency)} "
            f"frequencies from {low} to {high} kHz, {self.origin}."
        ]
        compared = self.verdict.summary() if self.verdict else []
        sentences += compared[:1]  # the agreement
        if self.lattice is not None:
            computed = f"; computed {hz_text(self.gap.lower, self.gap.upper, form='.2f')}" if self.gap else ""
            lower, upper = (edge or "not determined" for edge in (self.lattice.lower, self.lattice.upper))
            if self.gap and self.lattice.beside(*self.gap.edges):
                computed += ": another range, in which probably only some waves decay"
            sentences.append(
                f"Gap in the scan (experimental): lower edge {lower}, upper edge {upper}{computed}."
            )
            sentences += [f"  {text}" for text in self.lattice.reasons]
        if (seen := self.measured) is not None:
            sentences.append(
                f"High contrast of the driven region over the lattice: "
                f"{hz_text(seen.lower, form='.2f', error=seen.lower_error)} to "
                f"{hz_text(seen.upper, form='.2f', error=seen.upper_error)}."
            )
        sentences += compared[1:]
        if not self.report.complete or self.report.remarks:
            sentences += [line.strip() for line in str(self.report).splitlines()]
        if self.registration is not None:
            sentences.append(self.registration.sentence)
        return sentences

    def remarks(self) -> list[str]:
        return [*self.undetermined, *accuracy_remarks({} if self.waves is None else self.waves.attrs)]

    def tables(self) -> list[Table]:
        """Velocities, contrasts and decay at the operating shapes; then the comparison with a model."""
        columns = (
            Column("frequency", shown="kHz", form=".3f"),
            Column("rms of all", form=".3g", of="average"),
            Column("rms of {}", form=".3g", of="rms"),
            Column("{}", form=".1f", of="contrast"),
            Column("decay", form=".1f", ends=("low", "high")),
            Column("least computed decay", form=".1f", of="computed_least"),
            Column("largest computed decay", form=".1f", of="computed_largest"),
        )
        data = self.at_shapes
        present = [column for column in columns if (column.of or column.name) in data]
        shapes = Table.of(f"operating shapes, {self.origin}", data, "frequency", present)
        return [shapes, *(self.verdict.tables() if self.verdict else [])]

    @property
    def computed_decay(self) -> xr.Dataset | None:
        if self.waves is None or "attenuation" not in self.waves:
            return None
        return xr.Dataset({"attenuation": self.waves["attenuation"]}).rename(mirror_frequency="frequency")

    @cached_property
    def at_shapes(self) -> xr.Dataset:
        """The data at the operating shapes; with a decay also ``computed_least`` and ``computed_largest``."""
        names = [name for name in SHOWN if name in self.data]
        data = self.data[names].sel(frequency=list(self.shapes), method="nearest")
        if "decay" in data and (decay := self.computed_decay) is not None:
            near = decay["attenuation"].interp(frequency=list(self.shapes))
            beyond = {"units": "dB/row", WORD: "it was computed around the gap only"}
            data["computed_least"] = "frequency", near.min("phase").values, beyond
            data["computed_largest"] = "frequency", near.max("phase").values, beyond
        return data

    @property
    def flags(self) -> dict[str, int]:
        """Number of points with each flag."""
        return {flag: int(self.quality.flagged(flag).sum()) for flag in FLAGS}

    def facts(self) -> dict[str, Any]:
        report, lines = self.report, self.response.frequency
        reasons = self.lattice.reasons if self.lattice else ()
        return {
            "format": report.format,
            "points": self.response.dataset.sizes["point"],
            "dropped": [str(name) for name in report.dropped],
            "missing": report.missing,
            "remarks": [*report.remarks, *self.undetermined, *reasons],
            "lines": len(lines),
            "band_hz": [float(lines[0]), float(lines[-1])],
            "averages": self.averages,
            "units": self.response.units,
            "reference": self.response.dataset.attrs["reference"],
            "flags": self.flags,
            "registration": self.registration,
            "experimental_gap": self.lattice,
            "contrast_range": self.measured,
            "computed_gap_hz": self.gap_edges,
            "shapes": split(self.at_shapes, "frequency"),
            **({"verdict": self.verdict.to_json()} if self.verdict else {}),
        }
