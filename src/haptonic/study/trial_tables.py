"""The tables of the study file about trials: how they are processed, which count, what the sensor says."""

from __future__ import annotations

from haptonic.errors import FrictionError
from haptonic.fields import Name, described, setting
from haptonic.friction.recordings import Exclusion, Sensor
from haptonic.friction.signals import Rules


@described("trials", FrictionError)
class TrialSettings(Rules):
    """How force records become coefficients of friction, and which trials count."""

    driven: Name | None = setting(
        None,
        "Driven waveguide; by default the plate's, or the one with the largest reduction.",
        title="Driven waveguide",
        examples=["WG1"],
    )
    exclude: tuple[Exclusion, ...] = setting(
        (), "Trials that do not count.", title="Exclusions", max_length=1000
    )
    sensor: Sensor = setting(Sensor(), "What the channels are.")


@described("", kw_only=True)
class TrialsFile:
    """A file that says how trials are processed and nothing else: not every experiment has a lattice."""

    title: str = setting("Trials", "Heads the page.", max_length=200, strict=True)
    trials: TrialSettings = setting(TrialSettings(), "As in a study.")
