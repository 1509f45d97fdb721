"""Parameters of the friction models, with unit, bounds, source and uncertainty.

Most of them are not measured on the user's finger. Every result computed from them carries `assumptions`, so
that a prediction shows which of its inputs are assumed.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Annotated, Any, Literal, Self

import numpy as np
import scipy

from haptonic.arrays import Array
from haptonic.errors import FrictionError
from haptonic.fields import Quantity, described, needed, problem, setting
from haptonic.units import format_quantity

Values = Mapping[str, float | Array]
"""Input of a model: `Fingertip.values`, or draws from `Fingertip.sampled`."""
Mark = Literal["assumed", "stated", "computed", "given"]


@dataclass(frozen=True)
class Parameter:
    """One parameter of a model.

    value : in ``unit``
    unit : SI unit; empty for a ratio
    title : name in prose
    bounds : the model is invalid outside of them and at their ends
    plausible : interval in which the value is expected to lie; the uncertainty of a prediction is computed
        from it
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

    def at(self, share: Array) -> Array:
        """Values that lie at shares (0 to 1) of the plausible interval, on a logarithmic scale."""
        low, high = self.plausible
        return np.asarray(low * (high / low) ** share)


PARAMETERS = {
    "patch_area": Parameter(
        value=1e-4, unit="m^2", title="contact area at 0.5 N",
        bounds=(1e-6, 1e-2), plausible=(0.7e-4, 1.4e-4), mark="assumed", source="usual fingertip",
    ),
    "area_exponent": Parameter(
        value=0.4, unit="", title="growth of the area with force",
        bounds=(0.0, 1.0), plausible=(0.3, 0.5), mark="assumed", source="between Hertz and a rod",
    ),
    "asperity_pressure": Parameter(
        value=5e3, unit="Pa", title="asperity pressure at the contact gap",
        bounds=(1e2, 1e6), plausible=(5e3, 5e3), mark="assumed",
        source="defines the contact gap: the pressure of 0.5 N on the area",
    ),
    "contact_gap": Parameter(
        value=4e-6, unit="m", title="gap at which asperities carry that pressure",
        bounds=(1e-8, 1e-3), plausible=(3e-6, 5e-6), mark="assumed",
        source="chosen so that 2.5 um remove about 95 % of the friction; not measured",
    ),
    "decay_length": Parameter(
        value=3e-6, unit="m", title="gap over which asperity pressure falls to 1/e",
        bounds=(1e-8, 1e-3), plausible=(2.5e-6, 3.5e-6), mark="assumed",
        source="chosen together with the contact gap; not measured",
    ),
    "film_share": Parameter(
        value=1.0, unit="", title="length of the film over the radius of the contact",
        bounds=(1e-4, 10.0), plausible=(0.04, 1.0), mark="assumed",
        source="1: the whole pad; 0.04: half the width of one ridge. The largest uncertainty of all",
    ),
    "viscosity": Parameter(
        value=1.81e-5, unit="Pa s", title="viscosity of air",
        bounds=(1e-6, 1e-3), plausible=(1.79e-5, 1.86e-5), mark="assumed", source="air at 15 to 30 C",
    ),
    "ambient_pressure": Parameter(
        value=101325.0, unit="Pa", title="ambient pressure",
        bounds=(1e3, 1e7), plausible=(0.95e5, 1.04e5), mark="assumed", source="standard atmosphere",
    ),
    "static_friction": Parameter(
        value=0.42, unit="", title="coefficient of friction without vibration",
        bounds=(0.0, 10.0), plausible=(0.3, 0.6), mark="computed",
        source="from the drop of 0.23, which is 55 %, that Daunizeau, Gueorguiev, Haliyo and Hayward found",
    ),
    "stiffness_ratio": Parameter(
        value=2 / 3, unit="", title="tangential over normal stiffness of the contact",
        bounds=(0.0, 1.0), plausible=(0.6, 0.7), mark="computed",
        source="2 (1 - nu) / (2 - nu) of an elastic contact, nu = 0.5",
    ),
}  # fmt: skip
"""Defaults for parameters that the user does not give."""


class Ordered:
    """Fields of three numbers in ascending order."""

    def __post_init__(self) -> None:
        for name, triple in vars(self).items():
            if isinstance(triple, tuple) and list(triple) != sorted(triple):
                raise problem(
                    "conflict",
                    ", ".join(f"{number:g}" for number in triple),
                    "the lowest plausible value, the value, the highest plausible value",
                    "they are not in ascending order",
                    f"sort the numbers of {name}",
                    at=name,
                )


class _Fingertip(Ordered):
    def __iter__(self) -> Iterator[tuple[str, Parameter]]:
        """Every parameter by its name, with the user's value or the default."""
        for name, usual in PARAMETERS.items():
            given = getattr(self, name)
            if given is not None:
                low, value, high = given
                usual = replace(usual, value=value, plausible=(low, high), mark="given", source="user")
            yield name, usual

    def having(self, **values: float) -> Self:
        """Return a finger with values of the user's, taken as exactly known.

        Raises
        ------
        FrictionError : an unknown parameter, or a value out of bounds
        """
        return type(self)(**{**vars(self), **{name: (value,) * 3 for name, value in values.items()}})

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
        cube = scipy.stats.qmc.LatinHypercube(len(PARAMETERS), rng=np.random.default_rng(seed))
        shares = cube.random(samples)
        return {name: parameter.at(shares[:, i]) for i, (name, parameter) in enumerate(self)}

    def assumptions(self) -> dict[str, dict[str, object]]:
        """Every parameter with its mark, interval and source, to be stored with each result."""
        attributes = ("value", "unit", "title", "plausible", "mark", "source")
        return {
            name: {attribute: getattr(number, attribute) for attribute in attributes} for name, number in self
        }


def _declared() -> dict[str, Any]:
    """Declare a field of three numbers for each parameter: lowest plausible, value, highest plausible."""
    kinds, fields = dict[str, Any](), dict[str, Any]()
    for name, usual in PARAMETERS.items():
        low, high = usual.bounds
        number = Annotated[float, Quantity(usual.unit, above=low, below=high)]
        three = (usual.plausible[0], usual.value, usual.plausible[1])
        texts = [format_quantity(number_in_unit, usual.unit) for number_in_unit in three]
        words, quote = ", ".join(texts), '"' if usual.unit else ""
        kinds[name] = tuple[number, number, number] | None
        fields[name] = setting(
            None,
            f"Lowest plausible value, value, highest plausible value; by default {words}, "
            f"{usual.mark}: {usual.source}.",
            title=usual.title[0].upper() + usual.title[1:],
            examples=[f"[{', '.join(f'{quote}{text}{quote}' for text in texts)}]"],
        )
    return {"__annotations__": kinds, **fields}


FINGERTIP = """A fingertip and the air below it, as in the friction models; missing numbers are assumed.

    Examples
    --------
    >>> dict(Fingertip(contact_gap=(4e-6, 5e-6, 6e-6)))["contact_gap"].mark
    'given'
    """
Fingertip: Any = described("touch.skin", FrictionError, kw_only=True)(
    type("Fingertip", (_Fingertip,), {"__doc__": FINGERTIP, "__module__": __name__, **_declared()})
)


FORCES = (0.01, 20.0)  # N, usual for a finger
SPEEDS = (1e-3, 2.0)  # m/s, usual for a finger
Force = Annotated[float, Quantity("N", at_least=FORCES[0], at_most=FORCES[1], typical=(0.1, 5.0))]
Speed = Annotated[float, Quantity("m/s", at_least=SPEEDS[0], at_most=SPEEDS[1], typical=(0.01, 0.5))]


@described("touch", FrictionError)
class Touch:
    """Contact of the finger with the vibrating plate."""

    frequency: Annotated[float, Quantity("Hz", at_least=1e3, at_most=1e6)] = needed(
        "Frequency of the vibration."
    )
    force: Force = setting(0.5, "Force normal to the plate.", title="Force of the finger")
    speed: Speed = setting(0.078, "Speed along the plate.", title="Speed of the finger")

    @property
    def omega(self) -> float:
        """Angular frequency, rad/s."""
        return 2 * math.pi * self.frequency
