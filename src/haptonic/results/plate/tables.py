"""The tables of a plate's result."""

from __future__ import annotations

from typing import TYPE_CHECKING

from haptonic.results.table import Cell, Column, Table

if TYPE_CHECKING:
    from haptonic.results.plate.value import PlateResult


def lines_table(result: PlateResult) -> Table:
    """Velocities and contrasts at the frequencies of the maps."""
    units = result.response.units
    regions = [name for name in result.response.regions if name]
    lines = [result.told(line) for line in result.map_lines]
    contrasts = list(lines[0]["contrast_db"])
    columns = [
        Column("frequency", "Hz", "kHz", ".3f"),
        *(Column(f"{name} / ({units})", form=".3g") for name in regions),
        *(Column(f"{name} / dB", form=".1f") for name in contrasts),
        *(Column(f"finger {name} / ({units.replace('m/s', 'um')})", form=".3g") for name in regions),
        Column("power / W", form=".3g"),
    ]
    rows = [
        (
            line["frequency_hz"],
            *(line["rms"][name] for name in regions),
            *(line["contrast_db"][name] for name in contrasts),
            *(line["finger_um"][name] for name in regions),
            line["given_w"],
        )
        for line in lines
    ]
    title = "root mean square velocity, contrast, largest amplitude below a finger, and power of the drives"
    return Table(title, columns, rows)


def power_table(result: PlateResult) -> Table:
    """Where the power goes at the resonance of the map in the gap."""
    line = result.told(result.marked.at(result.resonance))
    given = line["given_w"]
    rows: list[tuple[Cell, ...]] = [
        (name, power, power / given) for name, power in line["dissipated_w"].items() if power
    ]
    rows.append(("given by the drives", given, 1.0))
    return Table(
        f"power at {line['frequency_hz'] / 1e3:.3f} kHz, per unit squared",
        ("part", Column("power", "W", form=".3g"), Column("share", "", "%", ".1f")),
        rows,
        [len(rows) - 1],
    )


def modes_table(result: PlateResult) -> Table:
    """Modes near the carrier."""
    modes = result.modes
    regions = modes["region"].values.tolist()
    regions += [f"patch {name}" for name in modes["actuator"].values.tolist()]
    columns: list[Column | str] = [
        Column("frequency", "Hz", "kHz", ".3f"), Column("solver's error", form=".0e"), "name",
        Column("Q", form=".0f"), Column("rise", "s", "ms", ".2f"),
        *(Column(name, "", "%", ".1f") for name in regions),
    ]  # fmt: skip
    rows: list[tuple[Cell, ...]] = []
    for k in range(modes.sizes["mode"]):
        mode = modes.isel(mode=k)
        rows.append(
            (
                *(float(mode[name]) for name in ("mode_frequency", "mode_error")),
                str(mode["name"].values),
                *(float(mode[name]) for name in ("quality", "rise_time")),
                *mode["stored"].values.tolist(),
                *mode["stored_in_actuator"].values.tolist(),
            )
        )
    return Table("modes near the carrier: where their strain energy is", columns, rows)
