"""Protocol on paper: instructions, and a box to tick for every trial."""

from __future__ import annotations

from importlib.metadata import version
from itertools import groupby
from typing import TYPE_CHECKING

from haptonic.pages import filled
from haptonic.units import format_quantity

if TYPE_CHECKING:
    from haptonic.results.protocol import TrialPlan

TEMPLATE = "sheet.html"


def sheet(plan: TrialPlan) -> str:
    """Protocol as an HTML page for printing on A4."""
    task = plan.task
    people = [
        (
            person,
            [
                (block, guide, list(trials))
                for (block, guide), trials in groupby(
                    labels, key=lambda label: (label.block, label.waveguide)
                )
            ],
        )
        for person, labels in groupby(plan.labels, key=lambda label: label.participant)
    ]
    return filled(
        TEMPLATE,
        plan=plan,
        people=people,
        speed=format_quantity(task.speed, "m/s", prefer="mm/s"),
        force=format_quantity(task.force, "N", prefer="N"),
        stroke=format_quantity(task.stroke, "m", prefer="mm"),
        lasting=format_quantity(task.lasting, "s", prefer="s", digits=2),
        pause=format_quantity(task.pause, "s", prefer="s"),
        version=version("haptonic"),
    )
