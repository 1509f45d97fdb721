"""Interactive view of friction trials: estimates with intervals, and conclusions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from importlib.metadata import version
from typing import TYPE_CHECKING

import numpy as np

from haptonic.friction.signals.record import EVERYBODY
from haptonic.gate import declared
from haptonic.later import xarray as xr
from haptonic.views import InteractiveView

if TYPE_CHECKING:
    from haptonic.results.friction import FrictionResult

REDUCTION = "reduction of friction, with 95 % intervals"
FRICTION = "friction, mean and standard deviation over trials"
NO_INTERVAL = "there are too few values for an interval"


@dataclass(frozen=True)
class EstimateMark:
    """A mark of the plot: its quantity, its group, value and ends; `whole` for all participants."""

    quantity: str
    name: str
    value: float
    low: float
    high: float
    note: str
    whole: bool


def friction_view(result: FrictionResult) -> InteractiveView:
    """View of the reductions and the friction of the conditions, with every trial behind its condition."""
    marks = [*_marks(result)]
    trials = result.trials.isel(stroke=result.trials["excluded"].values == "")
    names = [
        _condition(*labels)
        for labels in zip(
            *(trials[name].values.tolist() for name in ("participant", "waveguide", "actuation")), strict=True
        )
    ]
    about = {"units": "1"}
    columns = {
        name: ("mark", np.array([getattr(mark, name) for mark in marks], dtype=kind), about)
        for name, kind in (("value", float), ("low", float), ("high", float), ("whole", np.int8))
    }
    texts = {
        name: ("mark", np.array([getattr(mark, name) for mark in marks], dtype=str))
        for name in ("quantity", "name", "note")
    }
    data = xr.Dataset(
        {
            **columns,
            **texts,
            "trial_friction": ("trial", trials["friction"].values.astype(float), about),
            "trial_condition": ("trial", np.array(names, dtype=str)),
        },
        attrs={"origin": result.origin, "haptonic_version": version("haptonic")},
    )
    missing = dict.fromkeys(("value", "low", "high", "trial_friction"), NO_INTERVAL)
    summary = result.summary()
    conclusions = list(result.found.conclusions) or summary[:1]
    extra = {"summary": conclusions, "sentences": [text for text in summary if text not in conclusions]}
    return InteractiveView(
        kind="friction", title=result.title, dataset=declared(data, **missing), extra=extra
    )


def _marks(result: FrictionResult) -> Iterator[EstimateMark]:
    summary = result.found
    for region, estimate in summary.reductions.items():
        of_people = {EVERYBODY: estimate} | {
            person: own for (other, person), own in summary.own.items() if other == region
        }
        for person, each in of_people.items():
            yield EstimateMark(
                quantity=REDUCTION, name=f"{region}, {person}", value=each.value, low=each.low,
                high=each.high, note=each.note, whole=person == EVERYBODY,
            )  # fmt: skip
    for condition in summary.conditions:
        mean, deviation = condition.friction
        whole = condition.participant == EVERYBODY
        name = _condition(condition.participant, condition.waveguide, condition.actuation)
        note = f"{condition.used} trials, {condition.excluded} excluded"
        yield EstimateMark(
            quantity=FRICTION, name=name, value=mean, low=mean - deviation, high=mean + deviation, note=note,
            whole=whole,
        )  # fmt: skip


def _condition(participant: str, region: str, actuation: str) -> str:
    return f"{region} {actuation}, {participant}"
