"""The chapters in their order, each a module with ``chapter(results)``; other results have a plain one."""

from __future__ import annotations

from haptonic.report.chapter import Chapter, Picture, Results
from haptonic.report.chapters import comparison, dispersion, feel, mirror, modes, plate, scan, sweeps, trials

IN_ORDER = (
    dispersion.chapter,
    modes.chapter,
    sweeps.chapter,
    mirror.chapter,
    plate.chapter,
    scan.chapter,
    feel.chapter,
    trials.chapter,
    comparison.chapter,
)
TOLD = {"bands", "sweep", "layers", "waveguide", "plate", "scan", "feel", "friction"}  # analyses in these


def others(results: Results) -> list[Chapter]:
    """A chapter for each result that none of the others tells of: what it says of itself."""
    made = []
    for name, one in results.parts.items():
        if name in TOLD:
            continue
        figures = one.figures
        pictures = tuple(
            Picture(figures[picture], figures.captions[picture] or f"{one.title}: {picture}.",
                    figures.captions[picture] or picture)
            for picture in figures
        )  # fmt: skip
        made.append(
            Chapter(
                title=one.title or name,
                identifier=name.replace(" ", "-"),
                findings=tuple(one.summary()),
                pictures=pictures,
                tables=tuple(one.tables()),
            )
        )
    return made


__all__ = ["IN_ORDER", "others"]
