"""Claim: a number fitted to a scan lies within its 95 % interval of the truth in 95 % of scans.

Scans of a small plate are simulated: numbers between the bounds of the fit, a periodic chirp, noise of a
sensor, 16 bits, points that were not reached, and one whose signal was lost for half of the record. The plate
that is scanned has tiles of its own, so that errors of the fit's small model count too.
"""

from __future__ import annotations

import argparse
import time

import numpy as np
from record import write
from scipy.stats import binom

from haptonic.analyses.plate_needs import fineness
from haptonic.plate import Band, PlateModel
from haptonic.plate.layout.sampling import grid_points, unit_drives
from haptonic.plate.vibration.damping import real_times
from haptonic.study import loads
from haptonic.updating.fit import Fit, SmallModel, fitted
from haptonic.updating.match import MeasuredResponse
from haptonic.vibrometry.chirp import drive

STUDY = """
title = "Small plate"
[material]
youngs_modulus = "70 GPa"
poisson_ratio = 0.33
density = "2700 kg/m^3"
[cell]
pitch = "7 mm"
thickness = "1.5 mm"
[cell.pillar]
diameter = "3.5 mm"
height = "14.7 mm"
[mesh]
order = 2
foot_rings = 0
[plate]
map = '''
11o
112
'''
loss_factor = 5e-3
[plate.tiles]
o = "lattice"
1 = "WG1"
2 = "WG2"
[plate.clamp]
corners = "5 mm"
spring = "1e12 N/m^3"
loss_factor = 0.02
[[plate.actuator]]
name = "A1"
region = "WG1"
centre = ["7 mm", "7 mm"]
size = ["8 mm", "5 mm", "0.5 mm"]
material = "pzt-4"
bond = { thickness = "50 um", material = "silver-epoxy" }
[[fit.vary]]
parameter = "material.youngs_modulus"
from = "63 GPa"
to = "77 GPa"
[[fit.vary]]
parameter = "plate.loss_factor"
from = 2e-3
to = 12e-3
[[fit.vary]]
parameter = "plate.actuator[1].bond.thickness"
from = "20 um"
to = "120 um"
[[fit.vary]]
parameter = "plate.clamp.spring"
from = "2e11 N/m^3"
to = "5e12 N/m^3"
"""
BAND = (4e3, 40e3)  # Hz
RATE, PERIOD = 102.4e3, 10e-3  # Hz, s
GRID = 2.5e-3  # m
NOISE = 0.02  # root mean square of the sensor's, in that of the velocity
FULL_SCALE, BITS = 1.2, 16  # of the largest velocity anywhere
MISSING, LOST = 2, 1  # points of a scan
MIDDLE = (0.15, 0.85)  # part of the range between the bounds from which truths are drawn
TOLERANCE = 1e-3
CHANCE = 0.01  # of fewer hits than allowed, if the claim is true


class Bench:
    """A small plate, its small model, and what a scan of it is."""

    def __init__(self) -> None:
        study = loads(STUDY)
        self.plate, self.unknowns, self.fineness = (
            study.mounted_plate(),
            study.fit_settings.vary,
            fineness(study),
        )
        self.points, _ = grid_points(self.plate, GRID)
        self.drive = drive(low=BAND[0], high=BAND[1], sample_rate=RATE, duration=PERIOD)
        lines = np.asarray(np.fft.rfftfreq(len(self.drive.samples), 1 / RATE), dtype=np.float64)
        self.inside = (lines >= BAND[0] - 1) & (lines <= BAND[1] + 1)
        self.frequency = lines[self.inside]
        self.small = SmallModel.of(
            self.plate, self.unknowns, self.frequency, self.points, unit_drives(self.plate), TOLERANCE,
            self.fineness,
        )  # fmt: skip

    def scan(self, x: np.ndarray, chance: np.random.Generator) -> tuple[MeasuredResponse, np.ndarray]:
        """Scan of the plate with numbers given as logarithms over the start; also its spoiled points."""
        plate = self.small.space.plate_at(x)
        model = PlateModel.of(plate, BAND[1], self.fineness)
        band = Band.of(model, *BAND)
        _, vibration = band.answer(unit_drives(plate), self.frequency, TOLERANCE)
        moved = real_times(model.displaced(self.points, vibration.vectors), vibration.amplitudes)
        volts = np.fft.rfft(self.drive.samples)
        spectrum = np.zeros((len(self.points), len(volts)), complex)
        spectrum[:, self.inside] = moved * (1j * vibration.omega) * volts[self.inside]
        velocity = np.fft.irfft(spectrum, len(self.drive.samples))
        velocity += NOISE * velocity.std() * chance.standard_normal(velocity.shape)
        spoiled = chance.permutation(len(self.points))[: MISSING + LOST]
        velocity[spoiled[:LOST], len(self.drive.samples) // 2 :] = 0.0
        step = FULL_SCALE * np.abs(velocity).max() / 2 ** (BITS - 1)
        response = (np.fft.rfft(step * np.round(velocity / step)) / volts)[:, self.inside].T
        data = MeasuredResponse.of(self.frequency, self.points, response, True, unit_drives(plate))
        return data.without(spoiled[LOST:]), spoiled[:LOST]

    def fit(self, seed: int) -> tuple[Fit, np.ndarray, np.ndarray]:
        """A fit to a scan, the true values of its numbers, and the points that it should have left out."""
        chance = np.random.default_rng(seed)
        space = self.small.space
        x = space.low + chance.uniform(*MIDDLE, len(self.unknowns)) * (space.high - space.low)
        data, spoiled = self.scan(x, chance)
        return fitted(self.small, data), space.start * np.exp(x), spoiled


def main(seeds: int) -> None:
    start = time.perf_counter()
    bench = Bench()
    built = time.perf_counter() - start
    hits, scores, widths, spoiled_found, left, seconds = [], [], [], 0, [], []
    for seed in range(seeds):
        start = time.perf_counter()
        fit, true, spoiled = bench.fit(seed)
        seconds.append(time.perf_counter() - start)
        half = np.array(
            [np.log(n.interval_95[1] / n.value) if n.interval_95 else np.nan for n in fit.numbers]
        )
        off = np.log(np.array([n.value for n in fit.numbers]) / true)
        hits.append(np.abs(off) <= half)
        scores.append(off / half)
        widths.append(half)
        left.append(len(fit.left_out))
        spoiled_found += int(np.isin(spoiled, fit.left_out).all())
        print(f"seed {seed}: {np.round(off / half, 2)}, {seconds[-1]:.0f} s", flush=True)
    within = np.array(hits).sum(axis=0)
    write(
        "fit_covers_the_truth",
        {
            "seeds": seeds,
            "parameters": [unknown.parameter for unknown in bench.unknowns],
            "within": within.tolist(),
            "least_allowed": int(binom.ppf(CHANCE, seeds, 0.95)),
            "chance": CHANCE,
            "half_width_median": np.nanmedian(widths, axis=0).tolist(),
            "off_over_half_rms": np.sqrt(np.nanmean(np.square(scores), axis=0)).tolist(),
            "spoiled_points_found": spoiled_found,
            "left_out_largest": max(left),
            "points": len(bench.points),
            "lines": len(bench.frequency),
            "noise": NOISE,
            "small_model_s": built,
            "fit_s": float(np.median(seconds)),
        },
    )
    assert (within >= binom.ppf(CHANCE, seeds, 0.95)).all(), within


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--seeds", type=int, default=40)
    main(parser.parse_args().seeds)
