"""The tables of the study file on trials: their evaluation, exclusions, and the sensor."""

from __future__ import annotations

from haptonic.errors import FrictionError
from haptonic.fields import Name, described, setting
from haptonic.friction.recordings import Exclusion, Sensor
from haptonic.friction.signals import Rules


@described("trials", FrictionError)
class TrialSettings(Rules):
    """Evaluation of force records to coefficients of friction, and exclusions of trials."""

    driven: Name | None = setting(
        None,
        "Driven waveguide; by default the plate's, or the one with the largest reduction.",
        title="Driven waveguide",
        examples=["WG1"],
    )
    exclude: tuple[Exclusion, ...] = setting((), "Excluded trials.", title="Exclusions", max_length=1000)
    sensor: Sensor = setting(Sensor(), "Channels of the force sensor.")


@described("", kw_only=True)
class TrialsFile:
    """A file with nothing but the evaluation of trials, for experiments without a lattice."""

    title: str = setting("Trials", "Heading of the page.", max_length=200, strict=True)
    trials: TrialSettings = setting(TrialSettings(), "Evaluation of trials, as in a study.")
