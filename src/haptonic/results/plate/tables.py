"""Tables of the result of a plate."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from haptonic.later import xarray as xr
from haptonic.plate.layout.sampling import reference_of
from haptonic.plots.text import gap_text
from haptonic.results.table import Cell, Column, Table
from haptonic.units import hz_text

if TYPE_CHECKING:
    from haptonic.results.plate.value import CarrierAnswer, PlateResult

MODES = (
    Column("frequency", shown="kHz", form=".3f"),
    Column("solver's error", form=".0e", of="solver_error"),
    Column("nodal lines", of="name"),
    Column("Q", form=".0f", of="quality_factor"),
    Column("rise", shown="ms", form=".2f", of="rise_time"),
    Column("{}", shown="%", form=".1f", of="strain_energy"),
)


def carriers_table(answers: Sequence[CarrierAnswer]) -> list[Table]:
    """Confinement at each carrier, with its own drives; no table for a single carrier."""
    rows: list[tuple[Cell, ...]] = []
    for answer in answers:
        around = "; ".join(
            f"{name}: {gap_text(gap) if gap else 'no gap'}" for name, gap in answer.around.items()
        )
        pair, level = answer.least_contrast or (None, None)
        rows.append((answer.carrier, ", ".join(answer.drives), around, level, pair))
    columns = (
        Column("carrier", "Hz", "kHz", "g"),
        "drives",
        "gap of the lattices around",
        Column("least contrast", "dB", form=".1f"),
        "between",
    )
    return [Table("each carrier with its own drives alone", columns, rows)] if rows else []


def lines_table(result: PlateResult) -> Table:
    """Velocities and contrasts at the frequencies of the maps."""
    columns = (
        Column("frequency", shown="kHz", form=".3f"),
        Column("{}", form=".3g", of="rms"),
        Column("{}", form=".1f", of="contrast"),
        Column("finger {}", shown=result.response.units.replace("m/s", "µm"), form=".3g", of="finger"),
        Column("power", form=".3g", of="given"),
    )
    return Table.of(
        "root mean square velocity, contrast, largest amplitude below a finger, and power of the drives",
        result.maps,
        "frequency",
        [column for column in columns if (column.of or column.name) in result.maps],
    )


def power_table(result: PlateResult) -> Table:
    """Distribution of the power at the resonance of the map in the gap, for the drives of the study."""
    line, (reference, amplitude) = result.maps.sel(frequency=result.resonance), reference_of(result.plate)
    given, lost = amplitude**2 * float(line["given"]), amplitude**2 * line["dissipated"]
    rows: list[tuple[Cell, ...]] = [
        (name, power, power / given)
        for name, power in zip(lost["loss"].values.tolist(), lost.values.tolist(), strict=True) if power
    ]  # fmt: skip
    rows.append(("given by the drives", given, 1.0))
    where, drive = (
        hz_text(result.resonance, form=".3f"),
        f"{amplitude:g} {reference.unit} at {reference.name}",
    )
    return Table(
        f"power at {where} for {drive}",
        ("part", Column("power", "W", form=".3g"), Column("share", "", "%", ".1f")),
        rows,
        [len(rows) - 1],
    )


def modes_table(modes: xr.Dataset) -> Table:
    """Modes near the carrier, with the share of their strain energy in every part."""
    return Table.of("modes near the carrier: where their strain energy is", modes, "mode", MODES)
