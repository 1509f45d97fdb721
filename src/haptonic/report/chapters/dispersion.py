"""Band diagram and gaps."""

from __future__ import annotations

import json
from functools import partial

from haptonic.bloch import gaps_of
from haptonic.later import xarray as xr
from haptonic.plots.text import gap_text
from haptonic.report.chapter import Absent, Chapter, Finding, Results


def chapter(results: Results) -> Chapter | Absent:
    """Dispersion along the edge of the irreducible zone, and what the whole zone adds."""
    bands = results.parts["bands"]
    complete = [gap for gap in gaps_of(results.bands) if gap.complete]
    told = "; ".join(f"complete gap {gap_text(gap)}" for gap in complete) or "no complete gap"
    second = "the band below the widest complete gap" if complete else "the second band"
    empty = f"; it is zero in the complete gap from {gap_text(complete[0])}" if complete else ""
    *said, counted = bands.summary()
    drawn = partial(Finding, picture="dispersion")
    words = {
        "dispersion": f"Band diagram: {results.bands.sizes['band']} bands along "
        f"{'-'.join(along(results.bands))}; {told}.",
        "iso_frequency": f"Contour maps over the first Brillouin zone: the first band, and {second}.",
        "density_of_states": f"Density of states against frequency{empty}.",
    }
    return Chapter(
        title="Bands and gaps",
        identifier="dispersion",
        paragraphs=(
            "The bands are those of one unit cell with Floquet-Bloch phases on its sides. A gap is called "
            "complete only after the whole irreducible zone was sampled, more finely near the gap's edges; "
            "the other gaps hold for the wavevectors of one segment only.",
            "A bound after ± holds the error of the mesh, of the reduced model and of the sampling.",
        ),
        findings=(*map(drawn, said), counted, *bands.remarks()),
        pictures=results.pictures(bands, words),
        tables=tuple(bands.tables()),
    )


def along(data: xr.Dataset) -> list[str]:
    """Corners of the path in their order."""
    return list(json.loads(data.attrs["path_labels"]))
