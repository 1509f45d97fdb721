"""Frequency response as a value: the result of a simulation and of a laser vibrometer's scan.

The time factor is exp(+i omega t): a velocity is i omega times the displacement. Amplitudes are peak values.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib.metadata import version
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import AnyComplex, Array, Ints
from haptonic.errors import ResponseError
from haptonic.later import xarray as xr
from haptonic.response import checks
from haptonic.response.rasters import regular_grid
from haptonic.response.reference import Reference

Quantity = Literal["velocity", "displacement"]
Origin = Literal["simulated", "measured"]

UNITS: dict[Quantity, str] = {"velocity": "m/s", "displacement": "m"}
ROUNDING = 1e-9  # of a frequency: closer frequencies are the same line


@dataclass(frozen=True, eq=False)
class FrequencyResponse:
    """Complex response of a plate against frequency, point and direction.

    dataset : ``response`` (frequency, point, direction), optional ``coherence`` (frequency, point), and the
        coordinates ``frequency`` (Hz), ``x`` and ``y`` of the points (m), ``direction``, optional ``region``
        of the points; the attributes ``quantity``, ``reference``, ``origin``, ``title``, ``inputs`` (JSON)
        and ``haptonic_version``. Its arrays cannot be written to.
    """

    dataset: xr.Dataset

    @classmethod
    def of(
        cls,
        response: AnyComplex,
        *,
        frequency: Array,
        x: Array,
        y: Array,
        reference: Reference | str,
        origin: Origin,
        direction: Sequence[str] = ("z",),
        quantity: Quantity = "velocity",
        coherence: NDArray[np.floating[Any]] | None = None,
        region: Sequence[str] | None = None,
        title: str = "",
        inputs: Mapping[str, Any] | None = None,
    ) -> FrequencyResponse:
        """Make a response from its arrays, which are not copied.

        Parameters
        ----------
        response : (frequency, point, direction) complex, single or double precision; SI units per unit of
            the reference
        frequency : (frequency,) ascending, Hz
        x, y : (point,) positions on the plate, m
        reference : quantity that the response is divided by, and its unit: ``"A1, V"`` for the voltage of
            actuator A1, ``"F1, N"`` for a force; empty for none
        origin : "simulated" or "measured"
        direction : (direction,) of "x", "y", "z"; z is normal to the plate
        quantity : "velocity" (m/s) or "displacement" (m)
        coherence : (frequency, point) between 0 and 1
        region : (point,) name of each point's region, empty outside of any
        title : text for readers
        inputs : all inputs of the response, in JSON types

        Raises
        ------
        ResponseError : arrays of contradicting shapes, numbers that are not finite, unknown words
        """
        checks.one_of(quantity, tuple(UNITS), "quantity")
        checks.one_of(origin, ("simulated", "measured"), "origin")
        checks.directions(direction)
        reference = Reference.parse(reference) if isinstance(reference, str) else reference
        checks.reference(reference)
        checks.frequencies(frequency)
        checks.positions(x, y)
        shape = (len(frequency), len(x), len(direction))
        checks.response(response, shape)
        unit = "/".join(filter(None, [UNITS[quantity], reference.unit]))
        data: dict[str, Any] = {
            "response": (
                ("frequency", "point", "direction"),
                _frozen(response),
                {"units": unit, "long_name": f"complex {quantity}, exp(+i omega t)"},
            )
        }
        if coherence is not None:
            checks.coherence(coherence, shape[:2])
            data["coherence"] = (("frequency", "point"), _frozen(coherence), {"units": "1"})
        coordinates: dict[str, Any] = {
            "frequency": ("frequency", _frozen(frequency), {"units": "Hz"}),
            "x": ("point", _frozen(x), {"units": "m"}),
            "y": ("point", _frozen(y), {"units": "m"}),
            "direction": ("direction", np.array(direction, dtype=str)),
        }
        if region is not None:
            checks.regions(region, len(x))
            coordinates["region"] = ("point", np.array(region, dtype=str))
        attributes = {
            "quantity": quantity,
            "reference": str(reference),
            "origin": origin,
            "title": title,
            "inputs": json.dumps(dict(inputs or {})),
            "haptonic_version": version("haptonic"),
        }
        return cls(xr.Dataset(data, coords=coordinates, attrs=attributes))

    @property
    def frequency(self) -> Array:
        """(frequency,) Hz."""
        return np.asarray(self.dataset["frequency"].values)

    @property
    def values(self) -> AnyComplex:
        """(frequency, point, direction) the complex response."""
        return np.asarray(self.dataset["response"].values)

    @property
    def points(self) -> Array:
        """(point, 2) x and y, m."""
        return np.column_stack([self.dataset["x"].values, self.dataset["y"].values])

    @property
    def units(self) -> str:
        """Unit of the response, such as "m/s/V"."""
        return str(self.dataset["response"].attrs["units"])

    @property
    def reference(self) -> Reference:
        """Quantity that the response is divided by."""
        return Reference.parse(str(self.dataset.attrs["reference"]))

    @property
    def regions(self) -> tuple[str, ...]:
        """Names of the regions in the order of their first point."""
        if "region" not in self.dataset.coords:
            return ()
        return tuple(dict.fromkeys(str(name) for name in self.dataset["region"].values if name))

    def at(self, frequency: float) -> FrequencyResponse:
        """Select the line nearest to a frequency (Hz).

        Raises
        ------
        ResponseError : the frequency is out of range
        """
        lines = self.frequency
        slack = ROUNDING * lines[-1]
        if not lines[0] - slack <= frequency <= lines[-1] + slack:
            raise ResponseError.out_of_range(
                argument="frequency",
                given=f"{frequency:g} Hz",
                allowed=f"between {lines[0]:g} and {lines[-1]:g} Hz, the range of the response",
                cause="the frequency is given in kHz, or was not covered",
                next_step="choose a frequency within the range, in Hz",
            )
        return self.with_lines(slice(line := int(np.abs(lines - frequency).argmin()), line + 1))

    def between(self, low: float, high: float) -> FrequencyResponse:
        """Select the lines from ``low`` to ``high`` (Hz), both included.

        Raises
        ------
        ResponseError : no line in this range
        """
        lines = self.frequency
        slack = ROUNDING * lines[-1]
        start, stop = np.searchsorted(lines, [low - slack, high + slack])
        if not start < stop:
            raise ResponseError.no_answer(
                argument="between",
                given=f"{low:g} to {high:g} Hz",
                allowed=f"a range with at least one line; they lie between {lines[0]:g} and {lines[-1]:g} Hz",
                cause="the limits are given in kHz or in the wrong order, or lie between two lines",
                next_step="choose a wider range, in Hz",
            )
        return self.with_lines(slice(int(start), int(stop)))

    def of_region(self, name: str) -> FrequencyResponse:
        """Select the points of one region.

        Raises
        ------
        ResponseError : no point in a region of that name
        """
        inside = self.inside(name)
        return FrequencyResponse(_locked(self.dataset.isel(point=np.flatnonzero(inside))))

    def inside(self, name: str) -> NDArray[np.bool_]:
        """(point,) True for points in a region.

        Raises
        ------
        ResponseError : no point in a region of that name
        """
        if name not in self.regions:
            cause = "the name is misspelt, or no point lies there"
            raise ResponseError.unknown("region", name, self.regions, cause)
        return np.asarray(self.dataset["region"].values == name)

    def displacement(self) -> FrequencyResponse:
        """Displacement (m): a velocity divided by i omega. A line at 0 Hz is left out."""
        if self.dataset.attrs["quantity"] == "displacement":
            return self
        moving = self.with_lines(slice(int(self.frequency[0] == 0), None))
        return moving._converted("displacement", 1 / (2j * np.pi * moving.frequency))

    def velocity(self) -> FrequencyResponse:
        """Velocity (m/s): a displacement times i omega."""
        if self.dataset.attrs["quantity"] == "velocity":
            return self
        return self._converted("velocity", 2j * np.pi * self.frequency)

    def grid(self) -> xr.DataArray:
        """The response on the regular grid of its points.

        Returns
        -------
        (frequency, direction, y, x) with the coordinates of the rows and columns (m); NaN where there is no
        point

        Raises
        ------
        ResponseError : the points do not lie on a regular grid, or two of them coincide
        """
        place, x, y = regular_grid(self.points)
        values = np.moveaxis(self.values, 1, 2)
        filled = np.full((*values.shape[:2], len(y) * len(x)), np.nan, dtype=values.dtype)
        filled[..., place] = values
        names = {name: self.dataset[name] for name in ("frequency", "direction")}
        return xr.DataArray(
            filled.reshape(*values.shape[:2], len(y), len(x)),
            dims=("frequency", "direction", "y", "x"),
            coords=names | {"y": ("y", y, {"units": "m"}), "x": ("x", x, {"units": "m"})},
            attrs=self.dataset["response"].attrs,
            name="response",
        )

    def with_lines(self, lines: slice | Ints) -> FrequencyResponse:
        """Select lines by their ascending numbers."""
        checks.frequencies(self.frequency[lines])
        return FrequencyResponse(_locked(self.dataset.isel(frequency=lines)))

    def _converted(self, quantity: Quantity, factor: AnyComplex) -> FrequencyResponse:
        """The response times a factor for each line, in its own precision."""
        old = self.dataset["response"]
        values = old.values * factor.astype(old.dtype)[:, None, None]
        unit = self.units.replace(UNITS[self.dataset.attrs["quantity"]], UNITS[quantity], 1)
        notes = {"units": unit, "long_name": f"complex {quantity}, exp(+i omega t)"}
        converted = self.dataset.assign(response=(old.dims, _frozen(values), notes))
        return FrequencyResponse(converted.assign_attrs(quantity=quantity))


def _frozen(array: NDArray[Any]) -> NDArray[Any]:
    """A view of an array that cannot be written to."""
    view = np.asarray(array).view()
    view.setflags(write=False)
    return view


def _locked(dataset: xr.Dataset) -> xr.Dataset:
    """The same dataset, with its arrays locked against writing."""
    for variable in dataset.variables.values():
        variable.values.setflags(write=False)
    return dataset
