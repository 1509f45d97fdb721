"""Assumptions about participants, for planning an experiment and for simulating one."""

from __future__ import annotations

from typing import Annotated

from haptonic.errors import FrictionError
from haptonic.fields import Quantity, described, problem, setting

Share = Annotated[float, Quantity("", at_least=0.0, below=1.0)]
Reduction = Annotated[float, Quantity("", above=0.0, below=1.0)]


@described("participants", FrictionError, kw_only=True)
class Participants:
    """Assumptions about participants, for planning and simulating an experiment; none of them is measured."""

    driven: Reduction = setting(
        0.55, "Reduction of friction in the population; as published.", title="Reduction, driven"
    )
    idle: Reduction = setting(
        0.11, "Reduction of friction in the population; as published.", title="Reduction, idle"
    )
    effect_between: Share = setting(
        0.05, "Standard deviation of the reduction over people; assumed.", title="Reduction between people"
    )
    friction: Annotated[float, Quantity("", above=0.0, at_most=5.0, typical=(0.1, 2.0))] = setting(
        0.42, "Coefficient with the vibration off, mean over people; assumed."
    )
    between: Share = setting(
        0.15, "Standard deviation over the mean; assumed.", title="Friction between people"
    )
    within: Share = setting(
        0.22,
        "Standard deviation over the mean, for one person and condition; assumed.",
        title="Friction between trials",
    )
    drift: Annotated[float, Quantity("", at_least=-1.0, at_most=1.0, typical=(-0.5, 0.5))] = setting(
        0.1, "Relative drift of friction over a session, by moisture; assumed."
    )
    force_spread: Annotated[float, Quantity("N", at_least=0.0, at_most=5.0)] = setting(
        0.4, "Standard deviation over strokes; as published.", title="Spread of the force"
    )
    speed_spread: Annotated[float, Quantity("m/s", at_least=0.0, at_most=1.0)] = setting(
        13e-3, "Standard deviation over strokes; as published.", title="Spread of the speed"
    )
    noise: Annotated[float, Quantity("N", at_least=0.0, at_most=1.0, typical=(0.0, 0.2))] = setting(
        21e-3, "Root mean square of each force; as published.", title="Noise of the sensor"
    )
    bias: Annotated[float, Quantity("N", at_least=-10.0, at_most=10.0)] = setting(
        0.3, "Output of the sensor without a finger; assumed.", title="Bias of the sensor"
    )

    def __post_init__(self) -> None:
        if self.idle >= self.driven:
            raise problem(
                "conflict",
                f"{self.idle:g}",
                f"less than the driven one, {self.driven:g}",
                "the two are exchanged",
                "exchange them",
                at="idle",
            )
