"""Chapter on the bands and gaps of the unit cell."""

from __future__ import annotations

import json
from functools import partial

from haptonic.bloch import gaps_of
from haptonic.later import xarray as xr
from haptonic.plots.text import gap_text
from haptonic.report.chapter import Absent, Chapter, Finding, Results


def chapter(results: Results) -> Chapter | Absent:
    """Describe the bands along the edge of the irreducible zone, and the gaps of the whole zone."""
    bands = results.parts["bands"]
    complete = [gap for gap in gaps_of(results.bands) if gap.complete]
    gaps = "; ".join(f"complete gap {gap_text(gap)}" for gap in complete) or "no complete gap"
    second = "the band below the widest complete gap" if complete else "the second band"
    empty = f"; it is zero in the complete gap from {gap_text(complete[0])}" if complete else ""
    *sentences, counted = bands.summary()
    visible = partial(Finding, picture="dispersion")
    words = {
        "dispersion": f"Band diagram: {results.bands.sizes['band']} bands along "
        f"{'-'.join(along(results.bands))}; {gaps}.",
        "iso_frequency": f"Contour maps over the first Brillouin zone: the first band, and {second}.",
        "density_of_states": f"Density of states against frequency{empty}.",
    }
    return Chapter(
        title="Bands and gaps",
        identifier="dispersion",
        paragraphs=(
            "The bands are those of one unit cell with Floquet-Bloch phases on its sides. A gap is complete "
            "if no wave of any direction has its frequencies: the whole irreducible zone is sampled for it, "
            "more finely near the edges. The other gaps are gaps of the wavevectors along one segment of the "
            "path.",
            "The number after ± is a bound of the error of mesh, reduced model and sampling.",
        ),
        findings=(*map(visible, sentences), counted, *bands.remarks()),
        pictures=results.pictures(bands, words),
        tables=tuple(bands.tables()),
        views={"Move the modes": bands.view()},
    )


def along(data: xr.Dataset) -> list[str]:
    """Return the names of the corners along the path."""
    return list(json.loads(data.attrs["path_labels"]))
