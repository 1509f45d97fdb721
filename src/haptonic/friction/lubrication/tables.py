"""Both models of friction for many forces and speeds, so that a page can follow its sliders."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from haptonic.errors import FrictionError
from haptonic.friction.lubrication.law import ENDS, LOGARITHMS
from haptonic.friction.lubrication.parameters import Fingertip, Touch
from haptonic.friction.lubrication.prediction import MODELS, with_interval
from haptonic.gate import WORD
from haptonic.later import xarray as xr

SHARED = "the plate would strike the skin; the model of intermittent contact applies"


def friction_tables(
    touch: Touch, skin: Fingertip, forces: Sequence[float], speeds: Sequence[float]
) -> xr.Dataset:
    """Friction mu / mu0 by either model at the amplitudes of a `FrictionLaw`.

    Load sharing does not depend on the speed, nor intermittent contact on the force. The law of a force and a
    speed is therefore joined from two rows, exactly as `FrictionLaw.of` joins them.

    Parameters
    ----------
    touch : frequency; forces : N, ascending; speeds : m/s

    Returns
    -------
    ``load_sharing`` (force, end, amplitude), for the forces at which asperities leave a gap, and
    ``intermittent`` (speed, end, amplitude); ``end`` is "value", "low" or "high"

    Raises
    ------
    FrictionError : not even the smallest force is allowed
    """
    amplitudes = np.exp(LOGARITHMS)
    shared = []
    for force in forces:
        try:
            shared.append(
                with_interval(MODELS["load_sharing"], amplitudes, replace(touch, force=force), skin)
            )
        except FrictionError:
            if not shared:
                raise
            break  # larger forces press the skin flat as well
    intermittent = [
        with_interval(MODELS["intermittent"], amplitudes, replace(touch, speed=speed), skin)
        for speed in speeds
    ]
    about = {"units": "1", "long_name": "μ/μ₀"}
    return xr.Dataset(
        {
            "load_sharing": (("force", "end", "table"), np.array(shared), about | {WORD: SHARED}),
            "intermittent": (("speed", "end", "table"), np.array(intermittent), about),
        },
        coords={
            "force": ("force", list(forces)[: len(shared)], {"units": "N"}),
            "speed": ("speed", list(speeds), {"units": "m/s"}),
            "end": list(ENDS),
            "table": ("table", amplitudes, {"units": "m", "long_name": "amplitude below the finger"}),
        },
    )
