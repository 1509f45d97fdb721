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
IN_CHAPTERS = {
    "bands",
    "sweep",
    "layers",
    "waveguide",
    "plate",
    "scan",
    "feel",
    "friction",
}  # analyses in these


def others(results: Results) -> list[Chapter]:
    """Make a plain chapter of each other result: its summary, pictures and tables."""
    chapters = []
    for name, result in results.parts.items():
        if name in IN_CHAPTERS:
            continue
        figures = result.figures
        pictures = tuple(
            Picture(figures[picture], figures.captions[picture] or f"{result.title}: {picture}.",
                    figures.captions[picture] or picture)
            for picture in figures
        )  # fmt: skip
        chapters.append(
            Chapter(
                title=result.title or name,
                identifier=name.replace(" ", "-"),
                findings=tuple(result.summary()),
                pictures=pictures,
                tables=tuple(result.tables()),
                views={"Open the interactive view": result.view()},
            )
        )
    return chapters


__all__ = ["IN_ORDER", "others"]
