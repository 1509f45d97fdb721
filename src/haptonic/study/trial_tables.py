"""The tables of the study file about trials: how they are processed, which count, what the sensor says."""

from __future__ import annotations

from pydantic import Field

from haptonic.errors import FrictionError
from haptonic.fields import Name, described
from haptonic.friction.recordings import Exclusion, Sensor
from haptonic.friction.signals import Rules


@described("trials", FrictionError)
class TrialSettings(Rules):
    """How force records become coefficients of friction, and which trials count."""

    driven: Name | None = Field(
        default=None,
        title="Driven waveguide",
        description="Else the plate's, or the one with the largest reduction.",
    )
    exclude: tuple[Exclusion, ...] = Field(
        default=(), title="Exclusions", description="Trials that do not count.", max_length=1000
    )
    sensor: Sensor = Field(default=Sensor(), title="Sensor", description="What the channels are.")


@described("", kw_only=True)
class TrialsFile:
    """A file that says how trials are processed and nothing else: not every experiment has a lattice."""

    title: str = Field(
        default="Trials",
        title="Title",
        description="Heads the page.",
        max_length=200,
        strict=True,
    )
    trials: TrialSettings = Field(default=TrialSettings(), title="Trials", description="As in a study.")
