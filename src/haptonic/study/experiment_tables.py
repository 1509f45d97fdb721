"""The table of the study file on trials with people: their number and order."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from haptonic.fields import Name, Quantity, described, problem, setting

MOST_PARTICIPANTS = 500


@described("protocol", kw_only=True)
class ProtocolSettings:
    """Trials with people: their number and order, and the task of the participants."""

    blocks: Annotated[int, Field(ge=2, le=99, strict=True)] = setting(
        8, "Number of blocks of each participant; even."
    )
    trials: Annotated[int, Field(ge=2, le=98, strict=True)] = setting(
        30, "Strokes in a block; an even number."
    )
    participants: Annotated[int, Field(ge=1, le=MOST_PARTICIPANTS, strict=True)] = setting(
        3, "Number of participants."
    )
    order: Literal["published", "balanced"] = setting(
        "published", "Published order, with on before off, or a balanced one, drawn at random."
    )
    seed: Annotated[int, Field(ge=0, le=2**31, strict=True)] = setting(
        0, "Seed of the balanced order and of the plan's simulations."
    )
    stroke: Annotated[float, Quantity("m", at_least=1e-3, at_most=1.0, typical=(10e-3, 200e-3))] = setting(
        70e-3, "Distance between touching down and lifting the finger.", title="Stroke length"
    )
    pause: Annotated[float, Quantity("s", at_least=0.1, at_most=60.0, typical=(0.5, 30.0))] = setting(
        4.0, "Time between the end of a stroke and the start of the next."
    )
    driven: Name | None = setting(
        None,
        "Name of the driven waveguide; by default the one with the first actuator.",
        title="Driven waveguide",
        examples=["WG1"],
    )
    idle: Name | None = setting(
        None,
        "Name of the idle waveguide; by default the plate's first other region.",
        title="Idle waveguide",
        examples=["WG2"],
    )
    power: Annotated[float, Quantity("", above=0.5, below=1.0, typical=(0.7, 0.99))] = setting(
        0.8, "Probability of detecting an effect, used to determine the number of participants."
    )

    def __post_init__(self) -> None:
        for name in ("blocks", "trials"):
            number = getattr(self, name)
            if number % 2:
                raise problem(
                    "out-of-range",
                    str(number), "an even number", "one condition would have more trials than the other",
                    f"write {number + 1}", at=name,
                )  # fmt: skip
        if self.driven is not None and self.driven == self.idle:
            raise problem(
                "conflict",
                f'"{self.idle}"', "another waveguide than the driven one",
                "one is compared with the other", "choose another waveguide", at="idle",
            )  # fmt: skip
