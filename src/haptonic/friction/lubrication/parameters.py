"""The numbers of the friction models: each declared once, with unit, bounds, source and uncertainty.

Most of them nobody has measured on the finger at hand. Whatever is computed from them carries `assumptions`,
so that a prediction shows which of its inputs are assumed.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from typing import Annotated, Literal

import numpy as np
import scipy

from haptonic.arrays import Array
from haptonic.errors import FrictionError, shown
from haptonic.fields import Quantity, described, needed, setting
from haptonic.units import format_quantity

Values = Mapping[str, float | Array]
"""What a model computes with: `Fingertip.values`, or draws from `Fingertip.sampled`."""
Mark = Literal["assumed", "stated", "computed", "given"]


@dataclass(frozen=True)
class Parameter:
    """One number of a model.

    value : in ``unit``
    unit : SI unit; empty for a ratio
    title : what it is, for people
    bounds : outside of which, ends included, the model means nothing
    plausible : interval in which the value lies, as far as anybody knows; it is what the uncertainty of a
        prediction is computed from
    mark : where the value comes from: "assumed" (common, but not checked against a source), "stated" (in a
        source), "computed", or "given" by the user
    source : the source, or why the value was chosen
    """

    value: float
    unit: str
    title: str
    bounds: tuple[float, float]
    plausible: tuple[float, float]
    mark: Mark
    source: str

    def __post_init__(self) -> None:
        low, high = self.plausible
        numbers = (self.value, low, high)
        if not all(isinstance(n, int | float) and not isinstance(n, bool) for n in numbers):
            raise self._refused(shown(self.value), "it is not a number")
        if not all(math.isfinite(n) and self.bounds[0] < n < self.bounds[1] for n in numbers):
            raise self._refused(
                f"{self.value:g} {self.unit}, plausible {low:g} to {high:g}".strip(),
                "the unit of the value is not SI, or a digit slipped",
            )
        if not low <= self.value <= high:
            raise self._refused(
                f"{self.value:g} {self.unit}, plausible {low:g} to {high:g}".strip(),
                "the value lies outside of its own uncertainty",
            )

    def _refused(self, given: str, cause: str) -> FrictionError:
        limits = " and ".join(format_quantity(bound, self.unit) for bound in self.bounds)
        return FrictionError.out_of_range(
            argument=f"finger: {self.title}",
            given=given,
            allowed=f"a number between {limits}, inside of its plausible interval",
            cause=cause,
            next_step=f"give the value in {self.unit or 'no unit'}, and an interval around it",
        )

    def having(self, value: float, plausible: tuple[float, float] | None = None) -> Parameter:
        """The parameter with a value of the user's; without an interval it counts as exactly known."""
        return replace(self, value=value, plausible=plausible or (value, value), mark="given", source="user")

    def at(self, share: Array) -> Array:
        """Values that lie at shares (0 to 1) of the plausible interval, on a logarithmic scale."""
        low, high = self.plausible
        return np.asarray(low * (high / low) ** share)


@dataclass(frozen=True)
class Fingertip:
    """A fingertip, and the air below it, as the two models see it. All values are positive.

    Examples
    --------
    >>> Fingertip().having(contact_gap=5e-6).contact_gap.mark
    'given'
    """

    patch_area: Parameter = Parameter(
        1e-4, "m^2", "contact area at 0.5 N", (1e-6, 1e-2), (0.7e-4, 1.4e-4), "assumed", "usual fingertip"
    )
    area_exponent: Parameter = Parameter(
        0.4, "", "growth of the area with force", (0.0, 1.0), (0.3, 0.5), "assumed", "between Hertz and a rod"
    )
    asperity_pressure: Parameter = Parameter(
        5e3, "Pa", "asperity pressure at the contact gap", (1e2, 1e6), (5e3, 5e3), "assumed",
        "defines the contact gap: the pressure of 0.5 N on the area"
    )  # fmt: skip
    contact_gap: Parameter = Parameter(
        4e-6, "m", "gap at which asperities carry that pressure", (1e-8, 1e-3), (3e-6, 5e-6), "assumed",
        "chosen so that 2.5 um remove about 95 % of the friction; not measured"
    )  # fmt: skip
    decay_length: Parameter = Parameter(
        3e-6, "m", "gap over which asperity pressure falls to 1/e", (1e-8, 1e-3), (2.5e-6, 3.5e-6), "assumed",
        "chosen together with the contact gap; not measured"
    )  # fmt: skip
    film_share: Parameter = Parameter(
        1.0, "", "length of the film over the radius of the contact", (1e-4, 10.0), (0.04, 1.0), "assumed",
        "1: the whole pad; 0.04: half the width of one ridge. The largest uncertainty of all"
    )  # fmt: skip
    viscosity: Parameter = Parameter(
        1.81e-5, "Pa s", "viscosity of air", (1e-6, 1e-3), (1.79e-5, 1.86e-5), "assumed", "air at 15 to 30 C"
    )
    ambient_pressure: Parameter = Parameter(
        101325.0, "Pa", "ambient pressure", (1e3, 1e7), (0.95e5, 1.04e5), "assumed", "standard atmosphere"
    )
    static_friction: Parameter = Parameter(
        0.42, "", "coefficient of friction without vibration", (0.0, 10.0), (0.3, 0.6), "computed",
        "from the drop of 0.23, which is 55 %, of [daunizeau-haptics]"
    )  # fmt: skip
    stiffness_ratio: Parameter = Parameter(
        2 / 3, "", "tangential over normal stiffness of the contact", (0.0, 1.0), (0.6, 0.7), "computed",
        "2 (1 - nu) / (2 - nu) of an elastic contact, nu = 0.5"
    )  # fmt: skip

    def __iter__(self) -> Iterator[tuple[str, Parameter]]:
        return ((entry.name, getattr(self, entry.name)) for entry in fields(self))

    def having(self, **values: float) -> Fingertip:
        """A finger with values of the user's, taken as exactly known.

        Raises
        ------
        FrictionError : no such parameter, or a value out of bounds
        """
        known = dict(self)
        for name in values:
            if name not in known:
                cause = "the models have no such number"
                raise FrictionError.unknown(f"finger.{name}", name, known, cause, next_step="leave it out")
        return replace(self, **{name: known[name].having(value) for name, value in values.items()})

    @property
    def values(self) -> dict[str, float]:
        """All values in SI units, by name."""
        return {name: float(parameter.value) for name, parameter in self}

    def sampled(self, samples: int, seed: int = 0) -> dict[str, Array]:
        """Values drawn from the plausible intervals, logarithmically uniform (Latin hypercube).

        Returns
        -------
        name -> (samples,)
        """
        cube = scipy.stats.qmc.LatinHypercube(len(dict(self)), rng=np.random.default_rng(seed))
        shares = cube.random(samples)
        return {name: parameter.at(shares[:, i]) for i, (name, parameter) in enumerate(self)}

    def assumptions(self) -> dict[str, dict[str, object]]:
        """Every number with its mark, interval and source: to be kept with whatever was computed from it."""
        return {
            name: {
                "value": parameter.value,
                "unit": parameter.unit,
                "title": parameter.title,
                "plausible": list(parameter.plausible),
                "mark": parameter.mark,
                "source": parameter.source,
            }
            for name, parameter in self
        }


FORCES = (0.01, 20.0)  # N, and
SPEEDS = (1e-3, 2.0)  # m/s: what a finger does
Force = Annotated[float, Quantity("N", at_least=FORCES[0], at_most=FORCES[1], typical=(0.1, 5.0))]
Speed = Annotated[float, Quantity("m/s", at_least=SPEEDS[0], at_most=SPEEDS[1], typical=(0.01, 0.5))]


@described("touch", FrictionError)
class Touch:
    """How the finger touches the vibrating plate."""

    frequency: Annotated[float, Quantity("Hz", at_least=1e3, at_most=1e6)] = needed("Of the vibration.")
    force: Force = setting(0.5, "Normal to the plate.", title="Force of the finger")
    speed: Speed = setting(0.078, "Along the plate.", title="Speed of the finger")

    @property
    def omega(self) -> float:
        """rad/s."""
        return 2 * math.pi * self.frequency
