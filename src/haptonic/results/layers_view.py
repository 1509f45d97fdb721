"""Interactive view of a mirror: insertion loss of its rows, and the waves of the lattice."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from haptonic.arrays import Array
from haptonic.bloch.mirrors import LEAST_SHARE, errors_if_moved
from haptonic.gate import WORD
from haptonic.later import xarray as xr
from haptonic.results.steps import in_steps, step_colours
from haptonic.views import InteractiveView

DECIBELS = 20 / np.log(10)  # per row, of an imaginary part of the phase of 1 rad
PROPAGATING = 1e-6  # rad, imaginary part of the phase per row below which a wave does not decay
OF_FIELDS = ("wave", "frequency", "across", "along")
OF_WAVES = ("wave_component", "slab_phase", "slab_decay")
OF_GRID = ("present", "slab_slip", "slab_rows", "across", "along")
SCALES = ("pitch_m", "shear_speed_m_per_s", "haptonic_version", "origin")


def layers_view(data: xr.Dataset, title: str, summary: Sequence[str]) -> InteractiveView:
    """View of spectra; ``data`` as in `haptonic.results.layers.Layers`.

    Errors of losses, decays and phases are their largest changes if all frequencies of the lattice move by
    the bound of their relative error. This share of the value is added, because fast decays hardly depend on
    the frequency, but on the mesh. At the carrier they are those of the answer, which were computed there; at
    other frequencies curves are interpolated.
    """
    frequency, share = data["frequency"].values, float(data.attrs["relative_frequency_error"])
    passed = data["transmitted"].sum("outgoing", skipna=False).clip(min=LEAST_SHARE)
    loss = -10 * np.log10(passed.transpose("incident", "rows", "frequency").values)
    waves = data.transpose("wave", "frequency", ...)
    decay = DECIBELS * np.maximum(waves["kappa_imag"].values, 0.0)
    phase = np.abs(waves["kappa_real"].values) / np.pi
    phase[waves["kappa_imag"].values >= PROPAGATING] = np.nan
    of_wave = ("wave", "frequency")
    variables = {}
    for name, dims, values, unit, words in (
        ("loss", ("incident", "rows", "frequency"), loss, "dB", "insertion loss"),
        ("decay", of_wave, decay, "dB/row", "decay"),
        ("phase", of_wave, phase, "π", "phase per row"),
    ):
        meaning = {WORD: "the wave does not propagate"}
        attrs = {"units": unit, "long_name": words} | meaning
        variables[name] = dims, values, attrs
        variables[f"{name}_error"] = dims, _errors(values, frequency, share), {"units": unit} | meaning
    few = data["carrier_loss_error"].isel(many=data["rows"].values - 1).transpose("incident", "many").values
    for line in np.flatnonzero(frequency == data.attrs["carrier_hz"]):
        variables["loss_error"][1][..., line] = few
        slowest = np.isclose(decay[:, line], data.attrs["carrier_attenuation_db"], rtol=1e-6)
        variables["decay_error"][1][slowest, line] = data.attrs["carrier_attenuation_error_db"]
    gap = np.atleast_1d(data.attrs["gap"]).tolist()
    extra = {"summary": list(summary), "gap": gap or None, "carrier": float(data.attrs["carrier_hz"])}
    fields = {}
    if "wave_real" in data:
        fields = {name: in_steps(data[name].transpose(*OF_FIELDS)) for name in ("wave_real", "wave_imag")}
        fields |= {name: data[name].transpose("wave", "frequency").variable for name in OF_WAVES}
        fields |= {name: data[name].variable for name in OF_GRID}
        extra["colours"] = step_colours()
    return InteractiveView(
        kind="layers",
        title=title,
        dataset=xr.Dataset(
            variables | fields,
            coords={name: data[name].variable for name in ("frequency", "rows", "incident")},
            attrs={name: data.attrs[name] for name in SCALES if name in data.attrs},
        ),
        extra=extra,
    )


def _errors(values: Array, frequency: Array, share: float) -> Array:
    """(..., f) errors of values (..., f) at frequencies (f,) with this relative error; NaN remains."""
    curves = values.reshape(-1, len(frequency))
    errors = [errors_if_moved(curve, frequency, frequency, curve, share) for curve in curves]
    return np.array(errors).reshape(values.shape)
