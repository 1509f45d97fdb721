"""Chapter on the mode shapes at one wavevector."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from haptonic import plots
from haptonic.bloch.bands import mode_names
from haptonic.plots.modes import SHOWN
from haptonic.plots.text import uncertain_hertz
from haptonic.report.chapter import Absent, Chapter, Results, Table


def chapter(results: Results) -> Chapter | Absent:
    """Describe the motion of the lowest modes."""
    data = results.bands
    if "mode_real" not in data:
        return Absent("Mode shapes", "the result has no mode shapes")
    named = mode_names(data)[:SHOWN]
    where = data.attrs["modes_at"]
    rows = tuple(
        (f"{k + 1}", uncertain_hertz(float(data["mode_frequency"][k]), float(data["mode_error"][k])), name)
        for k, name in enumerate(named)
    )
    twisted = [f"mode {k + 1}" for k, name in enumerate(named) if name.startswith("torsion")]
    note = (
        f"In {' and '.join(twisted)} the pillar turns about its axis. The picture enlarges the displacement "
        "along the tangent at every point, so the pillar looks wider than it is.",
    )
    listed = ", ".join(f"{number} {name} at {frequency}" for number, frequency, name in rows)
    words = f"Deformed unit cells, one for each mode: {listed}."
    return Chapter(
        title="Mode shapes",
        identifier="modes",
        paragraphs=(
            f"The lowest {len(named)} modes at the {where}, numbered by frequency. Each is named after the "
            "motion with most of its kinetic energy: a motion of the pillar's sections if the pillar has "
            "more than half of the energy, otherwise one of the plate.",
            *(note if twisted else ()),
        ),
        pictures=tuple(
            replace(picture, moving=partial(plots.moving_modes, data))
            for picture in results.pictures(results.parts["bands"], {"modes": words})
        ),
        tables=(Table(f"Modes at the {where}.", ("Mode", "Frequency", "Name"), rows),),
    )
