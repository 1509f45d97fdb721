"""Claim: the edges of a lattice's gap that the scan of a plate shows lie within two of their standard errors
of the computed ones, for plates of other cells, guides and rows. Two of them had no part in the choice of
that error."""

from __future__ import annotations

import sys
import tempfile
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from record import STUDY, write

import haptonic
from haptonic.analyses import scanning
from haptonic.analyses.plate_needs import response_settings
from haptonic.analyses.scanning import Estimation, compute_scan
from haptonic.response import FrequencyResponse, read
from haptonic.store import Store
from haptonic.vibrometry import ReadReport, Scan
from haptonic.vibrometry.of_settings import drive_for, response_for

# pitch, thickness, pillar's diameter and height, guide's width (mm), columns of a guide, cells along, rows of
# a mirror, band of the scan and carrier (kHz), sample rate (kHz), loss factor
DESIGNS: dict[str, tuple[float, ...]] = {
    "pitch 5 mm": (5, 1.2, 2.6, 10.5, 24, 4, 16, 3, 50, 120, 82, 300, 2e-3),
    "tall pillars": (7, 1.5, 3.5, 16.1, 28, 4, 14, 3, 35, 75, 50.7, 250, 2e-3),
    "thick pillars": (7, 1.5, 4.2, 14.7, 28, 4, 14, 3, 38, 95, 63, 250, 2e-3),
    "four rows": (7, 1.5, 3.5, 14.7, 40, 5, 16, 4, 35, 85, 56, 250, 1e-3),
    "pitch 9 mm": (9, 2.0, 4.5, 18, 36, 4, 12, 3, 28, 72, 47, 250, 2e-3),
    "short pillars": (7, 1.5, 3.8, 13.5, 35, 5, 13, 3, 42, 95, 65, 250, 2e-3),
    "pitch 6 mm, four rows": (6, 1.3, 3.0, 13.0, 24, 4, 13, 4, 45, 95, 63, 250, 3e-3),
}
HELD_OUT = ("short pillars", "pitch 6 mm, four rows")


def main() -> None:
    """A folder may be named that holds responses, computed before, as NAME.nc."""
    warnings.simplefilter("ignore", haptonic.HaptonicWarning)  # periods are shorter than the ring-down
    kept = Path(sys.argv[1]) if len(sys.argv) > 1 else None
    plates = [compare_edges("prototype", haptonic.load(STUDY), kept)]
    for name, numbers in DESIGNS.items():
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "study.toml"
            path.write_text(study_of(*numbers), "utf-8")
            plates.append(compare_edges(name, haptonic.load(path), kept))
    write(
        "gap_in_the_scan", {"plates": plates, "held_out": HELD_OUT, "responses_from_files": kept is not None}
    )


def compare_edges(name: str, study: haptonic.Study, kept: Path | None) -> dict[str, Any]:
    """Computed and reported edges, Hz, and the error of the contrast of a simulated scan."""
    store = Store.default()
    asked = response_for(
        study.scan_settings,
        response_settings(study).tolerance,
        drive_for(study.scan_settings, study.mounted_plate()),
    )
    response: FrequencyResponse
    if kept is not None:
        response = read(kept / f"{name}.nc")
    else:
        response = study.plate(settings=asked, store=store).response
    simulated = study.simulate_scan(seed=1, response=response)
    on = scanning.on_plate(study)
    scan = Scan(simulated.records, ReadReport("twin", "memory", len(simulated.records.names)))
    result = compute_scan(scan, Estimation(), on, store=store)
    truth = simulated.truth()["contrast_db"]["WG1 over WG2"]
    off = np.abs(result.contrasts["WG1 over WG2"].values - np.array(truth))
    lattice, gap = result.lattice, on.gap
    assert lattice is not None
    assert gap is not None
    edges = {
        side: {"computed": getattr(gap, side)}
        | ({"determined": edge.frequency, "error": edge.error} if edge else {})
        for side, edge in (("lower", lattice.lower), ("upper", lattice.upper))
    }
    return {
        "name": name, "points": len(simulated.records.names), "reasons": lattice.reasons, **edges,
        "beside_upper": beside(result.dataset["row_decay"], gap.upper),
        "contrast_db": float(np.nanmax(off)), "hidden_lines": int(np.isnan(off).sum()), "lines": len(off),
    }  # fmt: skip


def beside(fades: xr.DataArray, edge: float) -> dict[str, list[float]]:
    """Decay of waves of small and of large phase within 4 % below and above an edge, dB per row."""
    around = fades.sel(frequency=slice(0.96 * edge, edge)), fades.sel(frequency=slice(edge, 1.04 * edge))
    large = fades["phase"].values > np.pi / 2
    return {
        "small": [float(np.nanmean(decay.values[:, ~large])) for decay in around],
        "large": [float(np.nanmean(decay.values[:, large])) for decay in around],
    }


def study_of(
    pitch: float, thickness: float, diameter: float, height: float, guide: float, columns: float,
    cells: float, rows: float, low: float, high: float, carrier: float, rate: float, loss: float,
) -> str:  # fmt: skip
    """The prototype's study with other sizes and coarser bands."""
    text = STUDY.read_text("utf-8").partition("# Wider and narrower pillars")[0]
    mirror, first, second = "o" * int(rows), "1" * int(columns), "2" * int(columns)
    for old, new in {
        'carrier = "60 kHz"': f'carrier = "{carrier} kHz"', 'pitch = "7 mm"': f'pitch = "{pitch} mm"',
        'thickness = "1.5 mm"': f'thickness = "{thickness} mm"',
        'diameter = "3.5 mm"': f'diameter = "{diameter} mm"',
        'height = "14.7 mm"': f'height = "{height} mm"', "accuracy = 2e-3": "accuracy = 1e-2",
        "points = 66": "points = 34", "ooo1111ooo2222ooo": mirror + first + mirror + second + mirror,
        "rows = 20": f"rows = {cells:g}", 'WG1 = "8 mm"': f'WG1 = "{guide / columns} mm"',
        'WG2 = "8 mm"': f'WG2 = "{guide / columns} mm"', 'width = "32 mm"': f'width = "{guide} mm"',
        "loss_factor = 2e-3": f"loss_factor = {loss}",
        '["16 mm", "35 mm"]': f'["{guide * 0.45:.3g} mm", "{cells * pitch * 0.25:.3g} mm"]',
    }.items():  # fmt: skip
        assert old in text, old
        text = text.replace(old, new)
    return text + (
        "\n[plate.response]\ntolerance = 1e-2\n"
        f'\n[scan]\nlowest = "{low} kHz"\nhighest = "{high} kHz"\nrate = "{rate} kHz"\nrecord = "10 ms"\n'
    )


if __name__ == "__main__":
    main()
