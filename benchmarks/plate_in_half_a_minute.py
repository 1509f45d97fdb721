"""Claim: the prototype's response from zero to 100 kHz, 1001 lines on the 2 mm grid with a field error of at
most 1e-3, in 30 s and 4 GB on two cores, nothing having been computed before."""

from __future__ import annotations

import time

import numpy as np
from record import STUDY, peak_memory, write

import haptonic
from haptonic.plate import Band, PlateModel
from haptonic.plate.layout.sampling import grid_points, unit_drives
from haptonic.plate.vibration.damping import real_times
from haptonic.plate.vibration.direct import direct_answer

STEPS = ("tiles", "basis", "lines and their check", "grid")
CHECKED = (5e3, 20e3, 48e3, 57e3, 75e3, 98e3)  # Hz, lines that are compared with the direct answer


def main() -> None:
    study = haptonic.load(STUDY)
    plate, section = study.mounted_plate(), study.plate_settings
    assert section is not None
    asked = section.response
    lines = np.linspace(asked.lowest, asked.highest, asked.points)
    drives = unit_drives(plate)
    marks = [time.perf_counter()]
    model = PlateModel.of(plate, asked.highest)
    marks.append(time.perf_counter())
    band = Band.of(model, asked.lowest, asked.highest)
    marks.append(time.perf_counter())
    band, vibration = band.answer(drives, lines, asked.tolerance)
    marks.append(time.perf_counter())
    points, _ = grid_points(plate, asked.grid)
    seen = model.displaced(points, vibration.vectors)
    velocity = real_times(seen, vibration.amplitudes) * (1j * vibration.omega)
    marks.append(time.perf_counter())
    assert velocity.shape == (len(points), len(lines))
    peak = peak_memory()
    true = []
    load = model.load(drives)[:, None]
    for frequency in CHECKED:
        k = int(np.abs(lines - frequency).argmin())
        exact = direct_answer(model, load, float(vibration.omega[k]))[:, 0]
        apart = vibration.vectors @ vibration.amplitudes[:, k] - exact
        true.append(
            float(
                np.sqrt(energy(model, apart, vibration.omega[k]) / energy(model, exact, vibration.omega[k]))
            )
        )
    steps = np.diff(marks)
    write(
        "plate_in_half_a_minute",
        {
            "pillars": plate.layout.pillars,
            "unknowns": model.assembly.size,
            "basis": band.reduced.basis.dimension,
            "lines": len(lines),
            "points": len(points),
            "total_s": float(marks[-1] - marks[0]),
            "steps_s": dict(
                zip(("tiles", "basis", "lines and their check", "grid"), steps.tolist(), strict=True)
            ),
            "peak_bytes": peak,
            "largest_bound": float(vibration.error.max()),
            "checked_hz": list(CHECKED),
            "true_error": true,
            "bound_there": [float(vibration.error[np.abs(lines - f).argmin()]) for f in CHECKED],
        },
    )


def energy(model: PlateModel, field: np.ndarray, omega: float) -> float:
    """Four times the strain and kinetic energy of a complex displacement."""
    parts = np.stack([field.real, field.imag], axis=1)
    force = model.assembly.stiffness_times(parts) + omega**2 * model.assembly.mass_times(parts)
    return float((parts * force).sum())


if __name__ == "__main__":
    main()
