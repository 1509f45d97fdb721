"""The chapters in their order. Each is a module with ``chapter(results)``."""

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

__all__ = ["IN_ORDER"]
