"""Band diagram and gaps."""

from __future__ import annotations

import json

import xarray as xr

from haptonic import plots
from haptonic.bloch import Gap, gaps_of
from haptonic.plots.words import khz
from haptonic.report.chapter import Absent, Chapter, Picture, Results, Table


def chapter(results: Results) -> Chapter | Absent:
    """Dispersion along the edge of the irreducible zone, and what the whole zone adds."""
    data, carrier = results.bands, results.study.carrier
    gaps = gaps_of(data)
    complete = [gap for gap in gaps if gap.complete]
    path = "-".join(along(data))
    picture = Picture(
        plots.dispersion(data, carrier_hz=carrier),
        f"Simulated dispersion along {path}. Colour, dashes and markers tell what moves; a curve changes "
        "its colour where the mode changes its nature. Complete gaps are shaded."
        + results.where("dispersion"),
        f"Band diagram: {data.sizes['band']} bands along {path}; "
        + ("; ".join(f"complete gap {in_words(gap)}" for gap in complete) or "no complete gap")
        + ".",
    )
    return Chapter(
        title="Bands and gaps",
        identifier="dispersion",
        paragraphs=(
            "The bands are those of one unit cell with Floquet-Bloch phases on its sides. A gap is called "
            "complete only after the whole irreducible zone was sampled, more finely near the gap's edges; "
            "the other gaps hold for the wavevectors of one segment only.",
            "A bound after ± holds the error of the mesh, of the reduced model and of the sampling.",
        ),
        findings=tuple(_findings(complete, carrier)),
        pictures=(picture, *_zone_pictures(results, complete)),
        tables=(_gap_table(gaps),),
    )


def along(data: xr.Dataset) -> list[str]:
    """Corners of the path in their order."""
    return list(json.loads(data.attrs["path_labels"]))


def in_words(gap: Gap) -> str:
    """``52.51 ± 0.05 to 60.21 ± 0.06 kHz``."""
    return f"{khz(gap.lower, gap.lower_error)} to {khz(gap.upper, gap.upper_error)} kHz"


def _findings(complete: list[Gap], carrier: float | None) -> list[str]:
    if not complete:
        return ["There is no complete gap among the bands that were computed."]
    said = [
        f"Complete gap from {in_words(gap)}, between bands {gap.between[0]} and {gap.between[1]}"
        + ("." if gap.certain else "; it is not wider than the errors of its edges, so it may not exist.")
        for gap in complete
    ]
    if carrier is not None:
        said.append(_about_carrier(complete, carrier))
    return said


def _about_carrier(complete: list[Gap], carrier: float) -> str:
    name = f"The carrier, {carrier / 1e3:g} kHz,"
    holding = [gap for gap in complete if gap.lower < carrier < gap.upper]
    if not holding:
        return f"{name} lies in no complete gap: at this frequency the lattice lets waves through."
    gap = holding[0]
    below, above = carrier - gap.lower, gap.upper - carrier
    edge, room, error = (
        ("lower", below, gap.lower_error) if below < above else ("upper", above, gap.upper_error)
    )
    said = f"{name} lies inside the gap, {room / 1e3:.2g} kHz ({room / carrier:.1%}) from its {edge} edge"
    if room <= error:
        return f"{said}, which is within the error of that edge."
    if room < 0.1 * gap.width:
        return (
            f"{said}: close enough for a tolerance of the sizes or of the material to move the edge past it."
        )
    return f"{said}."


def _gap_table(gaps: tuple[Gap, ...]) -> Table:
    rows = tuple(
        (
            f"{gap.between[0]} and {gap.between[1]}",
            "complete" if gap.complete else f"{gap.direction} only",
            khz(gap.lower, gap.lower_error),
            khz(gap.upper, gap.upper_error),
            khz(gap.width, gap.lower_error + gap.upper_error),
            f"{gap.samples}",
        )
        for gap in gaps
    )
    head = ("Between bands", "Where", "Lower edge (kHz)", "Upper edge (kHz)", "Width (kHz)", "Wavevectors")
    return Table("Gaps, and the number of wavevectors that each claim rests on.", head, rows)


def _zone_pictures(results: Results, complete: list[Gap]) -> tuple[Picture, ...]:
    data = results.bands
    if "zone_frequency" not in data or "lattice" not in data.attrs:
        return ()
    contours = Picture(
        plots.iso_frequency(data),
        "Simulated contours of equal frequency over the first Brillouin zone; the dashed line bounds the "
        "irreducible zone. Waves travel at right angles to the contours.",
        "Contour maps of frequency over the first Brillouin zone: the first band"
        + (", and the band below the widest complete gap." if complete else ", and the second band."),
    )
    density = Picture(
        plots.density_of_states(data),
        "Simulated density of states of the infinite lattice, from the bands over the whole zone.",
        "Density of states against frequency"
        + (f"; it is zero in the complete gap from {in_words(complete[0])}." if complete else "."),
    )
    return (contours, density)
