"""The finger that feels the plate, and how hard the plate is driven."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Any

from pydantic import Field

from haptonic.errors import FrictionError
from haptonic.fields import INLINE, Quantity, described, problem, setting
from haptonic.friction.lubrication.parameters import Fingertip, Force, Parameter, Speed, Touch
from haptonic.units import format_quantity

Damping = Annotated[float, Quantity("N s/m", above=0.0, at_most=1e4, typical=(1.0, 100.0))]
VOLTAGE = Quantity("V", above=0.0, at_most=1e4, typical=(1.0, 500.0))
USUAL_DAMPING = (5.0, 10.0, 30.0)  # N s/m, assumed: what a fingertip does to a vibrating plate


def _three(parameter: Parameter) -> Any:
    """A field for the lowest plausible value of a parameter, its value, and the highest plausible one."""
    low, high = parameter.bounds
    number = Annotated[float, Quantity(parameter.unit, above=low, below=high)]
    usual = ", ".join(
        format_quantity(n, parameter.unit)
        for n in (parameter.plausible[0], parameter.value, parameter.plausible[1])
    )
    field = Field(
        default=None,
        title=parameter.title[0].upper() + parameter.title[1:],
        description=f"Lowest plausible, value, highest plausible; else {usual}, {parameter.mark}: "
        f"{parameter.source}.",
    )
    return (tuple[number, number, number] | None, field)


class _Ordered:
    """Numbers that come in threes, in ascending order."""

    def __post_init__(self) -> None:
        for name, three in vars(self).items():
            if isinstance(three, tuple) and list(three) != sorted(three):
                raise problem(
                    "conflict",
                    ", ".join(f"{number:g}" for number in three),
                    "the lowest plausible value, the value, the highest plausible value",
                    "they are not in ascending order",
                    f"sort the numbers of {name}",
                    at=name,
                )


_THREES = {name: _three(parameter) for name, parameter in Fingertip()}
Skin: Any = described("touch.skin", FrictionError, kw_only=True)(
    type(
        "Skin",
        (_Ordered,),
        {
            "__doc__": "What the models of friction know of the fingertip; what is not given is assumed.",
            "__module__": __name__,
            "__annotations__": {name: kind for name, (kind, _) in _THREES.items()},
            **{name: field for name, (_, field) in _THREES.items()},
        },
    )
)


@described("touch", FrictionError)
class Pad(_Ordered):
    """What the finger does to the plate: a damper, spread evenly over a disc."""

    diameter: Annotated[float, Quantity("m", at_least=1e-3, at_most=40e-3, typical=(5e-3, 20e-3))] = setting(
        10e-3, "Of the disc that it covers; assumed.", title="Diameter below the finger"
    )
    damping: tuple[Damping, Damping, Damping] = setting(
        USUAL_DAMPING,
        "Of the whole disc: lowest plausible, value, highest plausible; assumed.",
        title="Damping of the finger",
    )


@described("touch", FrictionError, kw_only=True)
class TouchSettings:
    """The finger that feels the plate, and how hard the plate is driven."""

    force: Force = setting(0.5, "Normal to the plate.", title="Force of the finger")
    speed: Speed = setting(0.078, "Along the plate.", title="Speed of the finger")
    pad: Annotated[Pad, INLINE] = setting(Pad(), "What the finger does to the plate.")
    voltage: Annotated[float, VOLTAGE] | None = setting(
        None, "Of the first actuator while the finger feels; else the plate's."
    )
    skin: Skin = Field(
        default_factory=Skin, title="Skin", description="What the models of friction know of it."
    )

    def at(self, frequency: float) -> Touch:
        """The touch at a frequency of the plate, Hz."""
        return Touch(frequency, self.force, self.speed)

    def fingertip(self) -> Fingertip:
        """The fingertip as the lubrication models compute with it."""
        known = dict(Fingertip())
        given = {name: three for name in vars(self.skin) if (three := getattr(self.skin, name))}
        return replace(
            Fingertip(),
            **{name: known[name].having(value, (low, high)) for name, (low, value, high) in given.items()},
        )
