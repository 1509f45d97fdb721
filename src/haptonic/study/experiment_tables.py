"""The tables of the study file about trials with people: their order, and what is assumed of the people."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from haptonic.fields import Name, Quantity, described, problem

Share = Annotated[float, Quantity("", at_least=0.0, below=1.0)]
Reduction = Annotated[float, Quantity("", above=0.0, below=1.0)]


@described("protocol", kw_only=True)
class ProtocolSection:
    """Trials with people: how many, in which order, and what they are asked to do."""

    blocks: Annotated[int, Field(ge=2, le=99, strict=True)] = Field(
        default=8, title="Blocks", description="Of each participant; an even number."
    )
    trials: Annotated[int, Field(ge=2, le=98, strict=True)] = Field(
        default=30, title="Trials", description="Strokes in a block; an even number."
    )
    participants: Annotated[int, Field(ge=1, le=500, strict=True)] = Field(
        default=3, title="Participants", description="How many people take part."
    )
    order: Literal["published", "balanced"] = Field(
        default="published",
        title="Order",
        description="As published, with on before off, or balanced and drawn at random.",
    )
    seed: Annotated[int, Field(ge=0, le=2**31, strict=True)] = Field(
        default=0, title="Seed", description="Of the balanced order and of the plan's simulations."
    )
    stroke: Annotated[float, Quantity("m", at_least=1e-3, at_most=1.0, typical=(10e-3, 200e-3))] = Field(
        default=70e-3, title="Stroke length", description="From where the finger sets down to where it lifts."
    )
    pause: Annotated[float, Quantity("s", at_least=0.1, at_most=60.0, typical=(0.5, 30.0))] = Field(
        default=4.0, title="Pause", description="Between the end of a stroke and the start of the next."
    )
    driven: Name | None = Field(
        default=None,
        title="Driven waveguide",
        description="By its name; else the one with the first actuator.",
    )
    idle: Name | None = Field(
        default=None, title="Idle waveguide", description="By its name; else the plate's first other region."
    )
    power: Annotated[float, Quantity("", above=0.5, below=1.0, typical=(0.7, 0.99))] = Field(
        default=0.8,
        title="Power",
        description="Chance of showing an effect, for which participants are counted.",
    )

    def __post_init__(self) -> None:
        for name in ("blocks", "trials"):
            number = getattr(self, name)
            if number % 2:
                raise problem(
                    str(number), "an even number", "one condition would have more trials than the other",
                    f"write {number + 1}", at=name,
                )  # fmt: skip
        if self.driven is not None and self.driven == self.idle:
            raise problem(
                f'"{self.idle}"', "another waveguide than the driven one",
                "one is compared with the other", "name another one", at="idle",
            )  # fmt: skip


@described("participants", kw_only=True)
class ParticipantsSection:
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
                f"{self.idle:g}", f"less than the driven one, {self.driven:g}",
                "the two are exchanged", "exchange them", at="idle",
            )  # fmt: skip
