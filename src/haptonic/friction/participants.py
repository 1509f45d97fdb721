"""What is assumed of people, to plan an experiment and to simulate one."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from haptonic.errors import FrictionError
from haptonic.fields import Quantity, described, problem

Share = Annotated[float, Quantity("", at_least=0.0, below=1.0)]
Reduction = Annotated[float, Quantity("", above=0.0, below=1.0)]


@described("participants", FrictionError, kw_only=True)
class Participants:
    """What is assumed of people, to plan an experiment and to make one up; nobody has measured it."""

    driven: Reduction = Field(
        default=0.55, title="Reduction, driven", description="Of friction in the population; as published."
    )
    idle: Reduction = Field(
        default=0.11, title="Reduction, idle", description="Of friction in the population; as published."
    )
    effect_between: Share = Field(
        default=0.05,
        title="Reduction between people",
        description="Its standard deviation over people; assumed.",
    )
    friction: Annotated[float, Quantity("", above=0.0, at_most=5.0, typical=(0.1, 2.0))] = Field(
        default=0.42,
        title="Friction",
        description="Coefficient with the vibration off, mean over people; assumed.",
    )
    between: Share = Field(
        default=0.15,
        title="Friction between people",
        description="Standard deviation over the mean; assumed.",
    )
    within: Share = Field(
        default=0.22,
        title="Friction between trials",
        description="Of one person and condition, standard deviation over the mean; assumed.",
    )
    drift: Annotated[float, Quantity("", at_least=-1.0, at_most=1.0, typical=(-0.5, 0.5))] = Field(
        default=0.1,
        title="Drift",
        description="Of friction over a session, over its mean: moisture; assumed.",
    )
    force_spread: Annotated[float, Quantity("N", at_least=0.0, at_most=5.0)] = Field(
        default=0.4, title="Spread of the force", description="Standard deviation over strokes; as published."
    )
    speed_spread: Annotated[float, Quantity("m/s", at_least=0.0, at_most=1.0)] = Field(
        default=13e-3,
        title="Spread of the speed",
        description="Standard deviation over strokes; as published.",
    )
    noise: Annotated[float, Quantity("N", at_least=0.0, at_most=1.0, typical=(0.0, 0.2))] = Field(
        default=21e-3,
        title="Noise of the sensor",
        description="Root mean square of each force; as published.",
    )
    bias: Annotated[float, Quantity("N", at_least=-10.0, at_most=10.0)] = Field(
        default=0.3, title="Bias of the sensor", description="What it shows without a finger; assumed."
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
