"""Simulated responses on a small grid of points."""

import numpy as np

from haptonic.response import FrequencyResponse

LINES = np.linspace(0.0, 100e3, 6)
X = np.arange(5) * 2e-3
Y = 1e-3 + np.arange(4) * 2e-3


def numbers(shape: tuple[int, ...], seed: int = 1, precision=np.complex128):
    random = np.random.default_rng(seed)
    return (random.normal(size=shape) + 1j * random.normal(size=shape)).astype(precision)


def response_of_waves(**changes) -> FrequencyResponse:
    """On 5 x 4 points; WG1 is the first column, WG2 the last two."""
    x, y = (along.ravel() for along in np.meshgrid(X, Y))
    region = np.where(x == X[0], "WG1", np.where(x > X[2], "WG2", ""))
    keywords = {
        "frequency": LINES,
        "x": x,
        "y": y,
        "reference": "A1, V",
        "origin": "simulated",
        "region": region.tolist(),
        "title": "a plate",
        "inputs": {"plate": {"loss_factor": 0.002}},
    } | changes
    values = keywords.pop("response", None)
    if values is None:
        values = numbers((len(keywords["frequency"]), len(keywords["x"]), 1))
    return FrequencyResponse.of(values, **keywords)
