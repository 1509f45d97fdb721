"""Friction law of a touch: mu / mu0 against the amplitude of the vibration below the finger."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
import scipy

from haptonic.arrays import Array
from haptonic.errors import StudyError
from haptonic.friction.lubrication.parameters import Fingertip, Touch
from haptonic.friction.lubrication.prediction import predict
from haptonic.later import xarray as xr

End = Literal["value", "low", "high"]
ENDS: tuple[End, ...] = get_args(End)

STRONGEST = 1e4  # V or N: the search for a drive ends there
SMALLEST, LARGEST = 1e-9, 5e-5  # m, amplitudes between which the law is tabulated
LOGARITHMS = np.linspace(np.log(SMALLEST), np.log(LARGEST), 200)


def check_reduction(reduction: float) -> None:
    """Raise StudyError unless a reduction of friction is a share between 0 and 1."""
    if not 0 < reduction < 1:
        raise StudyError.out_of_range(
            argument="reduction",
            given=f"{reduction:g}",
            allowed="a share above 0 and below 1",
            cause="a percentage was given, or the remaining friction",
            next_step="give 0.5 for half the friction",
        )


@dataclass(frozen=True, eq=False)
class FrictionLaw:
    """mu / mu0 at amplitudes evenly spaced in their logarithm: the value, and the ends of its interval.

    Where the plate would strike the skin through the film, the value is that of intermittent contact.

    pressed_flat : share of the plausible skins that the force presses flat; the interval is without them
    """

    value: Array
    low: Array
    high: Array
    pressed_flat: float

    @classmethod
    def of(cls, touch: Touch, skin: Fingertip) -> FrictionLaw:
        """Law by load sharing, with the interval over both models and plausible parameters; see `predict`."""
        prediction = predict(xr.DataArray(np.exp(LOGARITHMS), dims="amplitude"), touch, skin)
        shared = prediction["load_sharing"]
        value = shared.where(np.isfinite(shared), prediction["intermittent"])
        return cls(
            value.values,
            prediction["low"].values,
            prediction["high"].values,
            float(prediction.attrs["pressed_flat"]),
        )

    def at(self, amplitude: Array, end: End = "value") -> Array:
        """mu / mu0 at amplitudes (m); outside the table it is constant."""
        logarithms = np.log(np.maximum(amplitude, SMALLEST))
        return np.asarray(np.interp(logarithms, LOGARITHMS, getattr(self, end)))

    def drive_for(self, reduction: float, per_unit: Array, usual: float) -> float | None:
        """Amplitude of the drive for a mean reduction over places; None if `STRONGEST` is not enough.

        Parameters
        ----------
        per_unit : (place,) amplitude of vibration, m per unit of the drive
        usual : drive at which the search starts, V or N; a thousandth of it is the smallest result
        """
        check_reduction(reduction)

        def missing(logarithm: float) -> float:
            return 1 - float(self.at(per_unit * math.exp(logarithm)).mean()) - reduction

        low, high = math.log(1e-3 * usual), math.log(usual)
        while missing(high) < 0:
            high += math.log(2)
            if high > math.log(STRONGEST):
                return None
        if missing(low) >= 0:
            return math.exp(low)
        return math.exp(scipy.optimize.brentq(missing, low, high, xtol=1e-4))
