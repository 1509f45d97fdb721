"""The command about trials with people before they are made: protocol."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from rich.table import Table

from haptonic import plots, report
from haptonic.cli.console import speaking
from haptonic.cli.options import Json, Out, Overwrite, StudyFile, folder_for, pictures, tell_where
from haptonic.results import Plan, refuse_taken, write_files
from haptonic.store import whole_set
from haptonic.study import load
from haptonic.study.experimenting import planned

SHEET = "sheet.html"


def protocol(
    study: StudyFile,
    out: Out = None,
    json: Json = False,
    overwrite: Overwrite = False,
) -> None:
    """Order of friction trials: list, printed sheet, metronome, and how many participants are needed."""
    with speaking(json) as voice:
        loaded = load(study)
        folder = folder_for(study, out, json, "protocol")
        refuse_taken(folder, [*Plan.FILES, SHEET, *pictures(["power"])], overwrite=overwrite)
        with voice.busy("simulated experiments"):
            plan = planned(loaded)
        if folder:
            with whole_set(folder, overwrite=overwrite) as draft:
                _write(plan, draft, overwrite)
        voice.tell(order_table(plan))
        for text in [*plan.statements, plan.drift_remark]:
            voice.tell(text)
        voice.tell("Chances are of simulated experiments, with what the study assumes of its participants.")
        tell_where(voice, folder)
        voice.answer(plan.to_json())


def order_table(plan: Plan) -> Table:
    """Which waveguide every participant strokes in which block, as a person reads them."""
    first = plan.protocol.waveguides[0]
    shown = Table(
        "participant", *(str(block + 1) for block in range(plan.protocol.blocks)),
        title=f"waveguide in each block, {plan.order} order; {first} is driven",
    )  # fmt: skip
    for person in dict.fromkeys(label.participant for label in plan.labels):
        blocks = {one.block: one.waveguide for one in plan.labels if one.participant == person}
        shown.add_row(person, *blocks.values())
    return shown


def _write(plan: Plan, folder: Path, overwrite: bool) -> None:
    write_files(folder, plan.files() | {SHEET: partial(report.write_sheet, plan)}, overwrite=overwrite)
    for name, figure in plan.figures().items():
        plots.save(figure, folder, name, overwrite=overwrite)
