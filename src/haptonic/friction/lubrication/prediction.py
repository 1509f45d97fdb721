"""Prediction of friction by both models, with the uncertainty of their parameters."""

from __future__ import annotations

import json
from collections.abc import Callable
from importlib.metadata import version

import numpy as np
from numpy.typing import ArrayLike

from haptonic.arrays import Array
from haptonic.errors import FrictionError
from haptonic.friction.lubrication.parameters import Fingertip, Touch, Values
from haptonic.friction.lubrication.sharing import (
    amplitude_for,
    amplitude_ratio,
    checked_amplitude,
    gap_at_rest,
    shared_friction,
)
from haptonic.friction.lubrication.slider import VALIDITY, intermittent_friction
from haptonic.later import xarray as xr

Model = Callable[[ArrayLike, Touch, Values], Array]

MODELS: dict[str, Model] = {"load_sharing": shared_friction, "intermittent": intermittent_friction}
VALID = {
    "load_sharing": "a film of air all the time; not where the excursion reaches 0.95 of the gap (NaN)",
    "intermittent": VALIDITY,
}
SAMPLES = 200  # draws from the plausible intervals
QUANTILES = (0.025, 0.975)
DIRECT = 200  # amplitudes; of more, a curve is interpolated, because friction depends on the amplitude alone


def predict(
    amplitude: xr.DataArray, touch: Touch, finger: Fingertip, *, samples: int = SAMPLES, seed: int = 0
) -> xr.Dataset:
    """Friction over that without vibration, mu / mu0, by both models.

    Parameters
    ----------
    amplitude : of displacement, zero to peak, m, any dimensions: a series of amplitudes, or a map
    touch : frequency, force, speed
    finger : parameters with their uncertainty
    samples : draws from the plausible intervals
    seed : seed of the draws

    Returns
    -------
    on the dimensions of ``amplitude``: the value of either model, ``load_sharing`` and ``intermittent``, and
    the ends (``_low``, ``_high``) of the interval that contains 95 % of the draws, NaN if a draw has no
    solution; ``low`` and ``high``, the ends of the interval over both models and their values, which a model
    without an interval may have. The attribute ``assumptions`` (JSON) lists every parameter with its mark;
    ``pressed_flat`` is the share of draws that the force presses flat, which load sharing leaves out.

    Raises
    ------
    FrictionError : amplitudes that are no displacements in m, a force too large, or too few samples
    """
    if not isinstance(samples, int) or isinstance(samples, bool) or samples < 20:
        raise FrictionError.too_few(
            argument="samples",
            given=samples,
            allowed="an integer of at least 20",
            cause="fewer draws leave no interval of 95 %",
            next_step="leave it out, or use 200",
        )
    moving = checked_amplitude(amplitude.values)
    line, place = np.unique(moving, return_inverse=True)
    knots = line if line.size <= DIRECT else np.linspace(line[0], line[-1], DIRECT)
    friction: dict[str, Array] = {}
    for name, model in MODELS.items():
        friction[name], friction[f"{name}_low"], friction[f"{name}_high"] = with_interval(
            model, knots, touch, finger, samples=samples, seed=seed
        )
    for end, outermost in (("low", np.fmin), ("high", np.fmax)):
        ends = [friction[f"{name}{part}"] for name in MODELS for part in (f"_{end}", "")]
        friction[end] = outermost.reduce(ends)
    data = {
        name: (
            amplitude.dims,
            np.interp(line, knots, values)[place].reshape(moving.shape),
            {"units": "1", "long_name": "mu / mu0"},
        )
        for name, values in friction.items()
    }
    for name, words in VALID.items():
        data[name][2]["validity"] = words
    flat = gap_at_rest(touch, finger.sampled(samples, seed)) <= 0
    attributes = {
        "origin": "simulated",
        "pressed_flat": float(flat.mean()),
        "touch": json.dumps({"frequency": touch.frequency, "force": touch.force, "speed": touch.speed}),
        "assumptions": json.dumps(finger.assumptions()),
        "samples": samples,
        "seed": seed,
        "haptonic_version": version("haptonic"),
    }
    return xr.Dataset(data, coords=amplitude.coords, attrs=attributes)


def with_interval(
    model: Model,
    amplitude: Array,
    touch: Touch,
    finger: Fingertip,
    *,
    samples: int = SAMPLES,
    seed: int = 0,
) -> Array:
    """(3, amplitude) friction by one model: the value, and the ends of its interval; see `predict`."""
    needs_gap = model is shared_friction  # intermittent contact does not depend on the force
    drawn = plausible(touch, finger, samples, seed) if needs_gap else finger.sampled(samples, seed)
    cloud = model(amplitude, touch, {name: numbers[:, None] for name, numbers in drawn.items()})
    return np.stack([model(amplitude, touch, finger.values), *np.quantile(cloud, QUANTILES, axis=0)])


def plausible(touch: Touch, finger: Fingertip, samples: int, seed: int) -> dict[str, Array]:
    """Draws of the parameters, name -> (k,), without those that the force presses flat."""
    drawn = finger.sampled(samples, seed)
    has_gap = gap_at_rest(touch, drawn) > 0
    return {name: numbers[has_gap] for name, numbers in drawn.items()}


def explained(
    driven: float, idle: float, touch: Touch, finger: Fingertip, *, samples: int = 200, seed: int = 0
) -> xr.Dataset:
    """Amplitudes of two regions, and their ratio, that explain two reductions by load sharing.

    Parameters
    ----------
    driven, idle : reductions, 0.55 for 55 %

    Returns
    -------
    ``driven``, ``idle`` (amplitudes, m) and ``ratio``, along ``quantity``: "value", and the ends "low" and
    "high" of the interval that contains 95 % of the draws that have a solution; ``solved`` is their share

    Raises
    ------
    FrictionError : reductions that are not 0 < idle < driven < 1
    """
    drawn = finger.sampled(samples, seed)
    quantities: dict[str, Callable[[Values], Array]] = {
        "ratio": lambda values: amplitude_ratio(driven, idle, touch, values),
        "driven": lambda values: amplitude_for(1 - driven, touch, values),
        "idle": lambda values: amplitude_for(1 - idle, touch, values),
    }
    rows = {name: (float(of(finger.values)), of(drawn)) for name, of in quantities.items()}
    units = {"ratio": "1", "driven": "m", "idle": "m"}
    data = {
        name: ("quantity", np.array([value, *_interval(cloud)]), {"units": units[name]})
        for name, (value, cloud) in rows.items()
    }
    attributes = {
        "origin": "simulated",
        "solved": float(np.isfinite(rows["ratio"][1]).mean()),
        "assumptions": json.dumps(finger.assumptions()),
    }
    return xr.Dataset(data, coords={"quantity": ["value", "low", "high"]}, attrs=attributes)


def _interval(cloud: Array) -> Array:
    solved = cloud[np.isfinite(cloud)]
    return np.asarray(np.quantile(solved, QUANTILES)) if solved.size else np.full(2, np.nan)
