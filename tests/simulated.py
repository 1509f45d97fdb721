"""Results for tests of pictures and pages: real, coarse ones of the reference cell, and synthetic ones."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import xarray as xr

import haptonic
from haptonic.bloch import bands_dataset
from haptonic.bloch.layers import OUTGOING
from haptonic.bloch.mirrors import PHASES
from haptonic.bloch.plate_waves import FAMILIES
from haptonic.bloch.settings import BandSettings, LayersSettings, MeshSettings, WaveguideSettings
from haptonic.fields import remade
from haptonic.report import Results
from haptonic.results import Guides, Layers
from haptonic.results.bands import Bands
from haptonic.results.common import stamped
from haptonic.results.references import References
from haptonic.results.sweeps import Sweep, Sweeps
from haptonic.store import Store
from haptonic.study import Study


@cache
def reference_study() -> Study:
    return haptonic.load(Path(__file__).parents[1] / "studies" / "touchpad.toml")


@cache
def _reference_bands() -> xr.Dataset:
    cell, settings = reference_study().cell, BandSettings(10, 24, 2e-2, MeshSettings(4, 1))
    asked = {"kind": "bands of tests", "cell": cell, "settings": settings}
    dataset = Store.default().kept(asked, lambda: bands_dataset(cell, settings, surface=True))
    return stamped(dataset, {})


def reference_bands() -> xr.Dataset:
    """Bands of the reference cell on a coarse mesh; a copy, so that a test may change it."""
    return _reference_bands().copy(deep=True)


def simulated_sweep(steps: int = 9, exponent: float = 0.8, **attrs: object) -> xr.Dataset:
    """A gap between bands 6 and 7 whose edges follow a power of the swept value exactly; below it, in the
    first four designs, a gap that is narrower than its errors; the last design has a third gap."""
    value = np.linspace(0.4, 0.8, steps)
    names = ("gap_lower", "gap_upper", "gap_lower_error", "gap_upper_error", "gap_below")
    gaps = {name: np.full((steps, 3), np.nan) for name in names}
    gaps["gap_lower"][:, 0] = 50e3 * (value / 0.5) ** exponent
    gaps["gap_upper"][:, 0] = 60e3 * (value / 0.5) ** exponent
    gaps["gap_below"][:, 0] = 6
    gaps["gap_lower"][:4, 1], gaps["gap_upper"][:4, 1], gaps["gap_below"][:4, 1] = 20e3, 20.1e3, 3
    gaps["gap_lower"][-1, 2], gaps["gap_upper"][-1, 2], gaps["gap_below"][-1, 2] = 110e3, 120e3, 8
    there = np.isfinite(gaps["gap_lower"])
    gaps["gap_lower_error"][there] = gaps["gap_upper_error"][there] = 80.0
    slender = np.outer(value / 0.5, [11.5e3, 72.3e3, 202.5e3])
    dataset = xr.Dataset(
        {
            "value": ("step", value, {"units": "1", "long_name": "cell.pillar.diameter / cell.pitch"}),
            **{name: (("step", "gap_slot"), array, {"units": "Hz"}) for name, array in gaps.items()},
            "searched_up_to": ("step", np.linspace(110e3, 150e3, steps)),
            "euler_bernoulli": (("step", "resonance"), slender),
            "timoshenko": (("step", "resonance"), 0.83 * slender),
        },
        attrs={"expression": "cell.pillar.diameter / cell.pitch", "own_value": 0.5, "carrier_hz": 60e3},
    )
    dataset.attrs |= attrs
    return dataset


def simulated_search(visits: int = 14, *, best: float = 0.06) -> xr.Dataset:
    """Starts, climbs and a polish whose margins rise to the best; a design without margin has no gap either.

    The gap that a margin belongs to is as wide above the carrier as below it.
    """
    margin = np.linspace(best - 0.14, best, visits)
    stage = np.array(["look", "climb", "polish"])[(3 * np.arange(visits)) // visits]
    turn = np.linspace(0, 5, visits)
    sizes = np.stack([12e-3 - 4e-3 * margin * np.cos(turn), 4e-3 + 20e-3 * margin * np.sin(turn)], axis=1)
    return xr.Dataset(
        {
            "lower": ("visit", 60e3 * (1 - margin)),
            "upper": ("visit", 60e3 * (1 + margin)),
            "margin": ("visit", margin),
            "stage": ("visit", stage),
            "value": (("visit", "parameter"), sizes),
        },
        coords={"parameter": ["cell.pillar.height", "cell.pillar.diameter"]},
        attrs={"carrier_hz": 60e3},
    )


def simulated_front(pitches: int = 6) -> xr.Dataset:
    """A gap that widens with the pitch; the first pitch holds no carrier, and the second allows no design."""
    margin = np.linspace(-0.03, 0.08, pitches)
    lower, upper = 60e3 * (1 - margin), 60e3 * (1 + 1.2 * margin)
    lower[1:2] = upper[1:2] = margin[1:2] = np.nan
    return xr.Dataset(
        {
            "pitch": ("design", np.linspace(4e-3, 8e-3, pitches)),
            "lower": ("design", lower),
            "upper": ("design", upper),
            "margin": ("design", margin),
        },
        attrs={"carrier_hz": 60e3},
    )


def simulated_tolerance(paths: tuple[str, ...], margin: float = 500.0) -> xr.Dataset:
    """Edges at 55 and 64 kHz that scatter by 300 and 500 Hz, the shares of their variances falling by half
    from one parameter to the next; the carrier is 60 kHz."""
    chance = np.random.default_rng(7)
    share = 0.5 ** np.arange(1, len(paths) + 1)
    share /= share.sum()
    both = np.stack([share, share[::-1]], axis=1)
    return xr.Dataset(
        {
            "drawn": (("plate", "side"), chance.normal([55e3, 64e3], [300.0, 500.0], (2000, 2))),
            "first_order_share": (("parameter", "side"), both),
            "total_index": (("parameter", "side"), np.minimum(1.05 * both, 1.0)),
        },
        coords={"parameter": list(paths), "side": ["lower", "upper"]},
        attrs={"carrier_hz": 60e3, "margin_hz": margin},
    )


@cache
def _reference_mirror() -> tuple[Layers, Guides]:
    study = remade(
        reference_study(), bands_settings=BandSettings(8, 13, 2e-2, MeshSettings(4, 1)),
        layers_settings=LayersSettings(lowest=50e3, highest=62e3, points=4, count=4),
        waveguide_settings=WaveguideSettings(mode="0x17", width=32e-3, rows=20),
    )  # fmt: skip
    lossy = remade(study, cell=study.cell.with_numbers({"material.loss_factor": 1e-3}))
    return lossy.layers(), study.waveguide()


def reference_layers() -> Layers:
    """The reference cell as a mirror, on a coarse mesh; its dataset is a copy."""
    layers = _reference_mirror()[0]
    return replace(layers, dataset=layers.dataset.copy(deep=True))


def reference_guides() -> Guides:
    """The prototype's waveguide between two such mirrors."""
    return _reference_mirror()[1]


def simulated_mirror(rows: int = 6, families: tuple[str, ...] = FAMILIES, **attrs: object) -> xr.Dataset:
    """Spectra from 40 to 80 kHz: one wave propagates below 50 kHz and one above 60 kHz; in between the n-th
    kind of wave decays by 5 n dB per row, its energy evenly spread over all kinds."""
    frequency = np.linspace(40e3, 80e3, 21)
    inside = (frequency >= 50e3) & (frequency <= 60e3)
    real = np.column_stack([np.where(inside, 1.0, np.linspace(0.2, 0.8, 21)) * np.pi, np.full(21, np.pi)])
    imaginary = np.column_stack([np.where(inside, 0.5, 0.0), np.full(21, 2.0)])
    passed = np.full((21, rows, len(FAMILIES), len(OUTGOING)), np.nan)
    for family in families:
        number = FAMILIES.index(family)
        decay = np.outer(np.where(inside, 5.0 * (number + 1), 0.0), np.arange(1, rows + 1))
        passed[:, :, number] = (10 ** (-decay / 10) / len(OUTGOING))[..., None]
    return xr.Dataset(
        {
            "kappa_real": (("frequency", "wave"), real),
            "kappa_imag": (("frequency", "wave"), imaginary),
            "attenuation": (("frequency", "phase"), np.outer(np.where(inside, 4.0, 0.0), np.arange(1, 6))),
            "transmitted": (("frequency", "rows", "incident", "outgoing"), passed),
        },
        coords={
            "frequency": frequency, "phase": PHASES, "rows": np.arange(1, rows + 1),
            "incident": list(FAMILIES), "outgoing": list(OUTGOING),
        },
        attrs={"carrier_hz": 58e3, "gap": [50e3, 60e3], "angle": 0.0, "along": [0, 1]} | attrs,
    )  # fmt: skip


def results_of(
    study: Study, bands: xr.Dataset, sweeps: tuple[xr.Dataset, ...] = (), *, alarms: object = None,
    references: References | None = None, timings: object = None, started: object = None, **parts: object,
) -> Results:  # fmt: skip
    """What a report is made of; parts by the names of their analyses, None for what is not there."""
    rows = Sweeps(tuple(Sweep(dataset, {}) for dataset in sweeps)) if sweeps else None
    every = {"bands": Bands(bands), "sweep": rows, **parts}
    there = {name: part for name, part in every.items() if part is not None}
    return Results(
        study, there, alarms=alarms or {}, references=references, timings=timings or {}, started=started
    )
