"""The command that compares a measured response with a plate's model: verdict."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import numpy as np
import typer
from rich.table import Table

from haptonic import plots
from haptonic.cli.console import Voice, speaking
from haptonic.cli.options import Json, Out, Overwrite, StudyFile, folder_for, pictures, tell_where
from haptonic.response import read
from haptonic.results import Verdict, refuse_taken, write_files
from haptonic.results.verdict import MEASURED
from haptonic.store import whole_set
from haptonic.study import load
from haptonic.study.judging import judged
from haptonic.units import format_quantity
from haptonic.updating.agreement import Agreement
from haptonic.updating.fit import Fit

MOST_ROWS = 40  # pairs that a table shows


def verdict(
    response: Annotated[Path, typer.Argument(metavar="RESPONSE", help="response.nc that a scan has given.")],
    study: StudyFile,
    computed: Annotated[
        Path | None,
        typer.Option("--computed", metavar="RESPONSE", help="The model's response, if it is there already."),
    ] = None,
    out: Out = None,
    json: Json = False,
    overwrite: Overwrite = False,
) -> None:
    """A response that a scan has given, once more against its plate's model: new unknowns, no records."""
    with speaking(json) as voice:
        loaded = load(study)
        folder = folder_for(study, out, json, "verdict")
        refuse_taken(folder, verdict_files(bool(loaded.fit_settings.vary)), overwrite=overwrite)
        measured = read(response)
        model = None if computed is None else read(computed)
        with voice.busy("model") as said:
            found = judged(loaded, measured, computed=model, said=said)
        if folder:
            with whole_set(folder, overwrite=overwrite) as draft:
                write_verdict(found, draft, overwrite)
        tell_verdict(found, voice)
        tell_where(voice, folder)
        voice.answer(found.to_json())


def verdict_files(with_fit: bool) -> list[str]:
    """Names of all that `write_verdict` can write."""
    names = ["verdict.nc", "verdict.json", "model.nc", *pictures(["before-after", "frac", "mac"])]
    return [*names, "fitted.toml"] if with_fit else names


def write_verdict(found: Verdict, folder: Path, overwrite: bool) -> None:
    """Data, pictures, and the study with the fitted numbers."""
    write_files(folder, found.files(), overwrite=overwrite)
    for name, figure in found.figures().items():
        plots.save(figure, folder, name, overwrite=overwrite)


def tell_verdict(found: Verdict, voice: Voice) -> None:
    """Fitted numbers, pairs of shapes, ranges of high contrast, and how much is explained."""
    if found.fit:
        voice.tell(fit_table(found.fit))
    voice.tell(pairs_table(found.agreements[found.last], found.last))
    if any(found.ranges.values()):
        voice.tell(ranges_table(found))
    voice.tell(summary(found))


def fit_table(fit: Fit) -> Table:
    """Each number before and after."""
    table = Table("parameter", "start", "fitted", "95 % interval", title="numbers fitted to the response")
    for one in fit.numbers:
        start, value = (format_quantity(number, one.unit) for number in (one.start, one.value))
        table.add_row(one.name, start, value, one.told)
    return table


def pairs_table(one: Agreement, model: str) -> Table:
    """Shapes that belong together."""
    table = Table(
        "measured / kHz", "model / kHz", "difference / %", "damping / %", "model damping / %", "MAC",
        title=f"{one.measured.how}: {len(one.pairs)} pairs of {len(one.measured.frequency)} measured and "
        f"{len(one.computed.frequency)} of the {model}",
    )  # fmt: skip
    for pair in one.pairs[:MOST_ROWS]:
        first, second = one.measured.frequency[pair.first], one.computed.frequency[pair.second]
        table.add_row(
            f"{first / 1e3:.3f}", f"{second / 1e3:.3f}", f"{100 * (second / first - 1):+.2f}",
            f"{100 * one.measured.damping[pair.first]:.3f}", f"{100 * one.computed.damping[pair.second]:.3f}",
            f"{pair.mac:.3f}",
        )  # fmt: skip
    return table


def ranges_table(found: Verdict) -> Table:
    """Where the driven region stands out from the lattice in each response, found in the same way."""
    table = Table("response", "from / kHz", "to / kHz", title="high contrast over the lattice")
    for name, one in found.ranges.items():
        if one is None:
            table.add_row(name, "none found", "")
        else:
            table.add_row(
                name, f"{one.lower / 1e3:.2f} ± {one.lower_error / 1e3:.2f}",
                f"{one.upper / 1e3:.2f} ± {one.upper_error / 1e3:.2f}",
            )  # fmt: skip
    return table


def summary(found: Verdict) -> str:
    """How much of the measurement the models explain, and how sure the numbers are."""
    lines = [
        f"{name}: the model leaves {100 * one.unexplained:.2g} % of the measured energy unexplained; "
        f"median FRAC {np.nanmedian(one.frac):.4f}."
        for name, one in found.agreements.items()
    ]
    if (fit := found.fit) is not None:
        kind = "look independent" if fit.told.independent else "are alike at neighbouring points or lines"
        lines.append(
            f"Residuals {kind}: {fit.told.data} numbers count as {fit.told.effective:.0f}. The response "
            f"of the fit is {found.recomputed:.1e} off the plate computed anew. {len(fit.left_out)} points "
            "of strange residuals were left out."
        )
    if found.left_out:
        lines.append(f"{found.left_out} points do not lie on the plate and were left out.")
    return "\n".join([*lines, f"{found.labels[MEASURED].capitalize()} against a simulation."])
