"""Files for the workshop."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import date
from pathlib import Path
from typing import Any

from haptonic import workshop
from haptonic.analyses import tolerance
from haptonic.analyses.analysis import Analysis, NoOptions, option
from haptonic.cell import UnitCell
from haptonic.later import xarray as xr
from haptonic.results.result import Result
from haptonic.results.runner import Runner
from haptonic.results.tolerance import percent
from haptonic.study.schema import Description
from haptonic.workshop.shape import TRIANGLES, dimensions_of, in_mm

KINDS = ("step", "dxf", "stl", "drawing")


@dataclass(frozen=True)
class ExportOptions:
    """What may be chosen; all kinds of files are made if none is named."""

    step: bool = option(False, "Solid, for CAD (needs haptonic[cad]).")
    dxf: bool = option(False, "Outlines seen from above.")
    stl: bool = option(False, "Surface as triangles.")
    drawing: bool = option(False, "Dimensioned drawing (PDF, DXF).")
    columns: int = option(1, "Cells along x.", metavar="N")
    rows: int = option(1, "Cells along y.", metavar="N")

    @property
    def kinds(self) -> list[str]:
        """Of files that are asked for."""
        return [kind for kind in KINDS if getattr(self, kind)] or list(KINDS)

    def names(self, stem: str) -> list[str]:
        """Of the files."""
        named = {"step": [f"{stem}.step"], "dxf": [f"{stem}.dxf"], "stl": [f"{stem}.stl"]}
        drawings = [f"{stem}.pdf", f"{stem}-drawing.dxf"]
        return [name for kind in self.kinds for name in named.get(kind, drawings)]


@dataclass(frozen=True, eq=False, repr=False)
class Workshop(Result):
    """A piece of plate as files for the workshop.

    cell, study, stem : what is made, the title of its study, and the beginning of the files' names
    tolerances : half-widths (SI) of the sizes in the drawing; why_none : why there are none, if so
    wants_tolerances : whether the study asks for tolerances
    """

    title = "Files for the workshop"

    cell: UnitCell
    study: str
    stem: str
    options: ExportOptions
    tolerances: dict[str, float]
    why_none: str
    wants_tolerances: bool

    @property
    def dataset(self) -> xr.Dataset:
        """Dimensions of the cell and their tolerances."""
        sizes = dimensions_of(self.cell)
        half = [self.tolerances.get(name, float("nan")) for name in sizes]
        meaning = {"units": "SI", "nan_means": "the drawing gives no tolerance"}
        return xr.Dataset(
            {
                "size": ("dimension", list(sizes.values()), {"units": "SI"}),
                "half_width": ("dimension", half, meaning),
            },
            coords={"dimension": list(sizes)},
        )

    @classmethod
    def names(cls, options: Any = None) -> list[str]:
        return (options or ExportOptions()).names("STUDY")

    def put(self, draft: Path, *_: object) -> None:
        asked = self.options
        solids = {"dxf": workshop.write_dxf, "stl": workshop.write_stl}
        for name in asked.names(self.stem):
            path, kind = draft / name, name.rpartition(".")[2]
            if name in (f"{self.stem}.pdf", f"{self.stem}-drawing.dxf"):
                workshop.write_drawing(
                    path, self.cell, self.study, asked.columns, asked.rows,
                    tolerances=self.tolerances, why_none=self.why_none, date=date.today(),
                )  # fmt: skip
            elif kind == "step":
                workshop.write_step(path, self.cell, asked.columns, asked.rows, title=self.study)
            else:
                solids[kind](path, self.cell, asked.columns, asked.rows)

    def summary(self) -> list[str]:
        return [f"written: {name}" for name in self.options.names(self.stem)]

    def remarks(self) -> list[str]:
        return (
            [f"the drawing has no tolerances: {self.why_none}"]
            if self.why_none and self.wants_tolerances
            else []
        )

    def facts(self) -> dict[str, Any]:
        if "drawing" not in self.options.kinds:
            return {}
        return {"tolerances": self.tolerances, "why_no_tolerances": self.why_none or None}

    def located(self, folder: Path) -> dict[str, Any]:
        return {"files": [str(folder / name) for name in self.options.names(self.stem)]}


def check(study: Description, options: ExportOptions) -> None:
    """Refuse impossible numbers of cells, and files that this cell cannot have."""
    in_mm(study.cell, options.columns, options.rows)
    if "stl" in options.kinds:
        study.cell.check_one_site(TRIANGLES)
    if "drawing" in options.kinds:
        study.cell.check_simple("the drawing")


def compute(study: Description, options: ExportOptions, runner: Runner) -> Workshop:
    """The files; the drawing has the tolerances found, or says why not."""
    found: tuple[dict[str, float], str] = ({}, "")
    if "drawing" in options.kinds:
        found = drawn_tolerances(study, runner)
    stem = "cell" if runner.about is None else runner.about.stem
    asked = bool(study.tolerance_settings.of)
    return Workshop(study.cell, study.title, stem, options, *found, asked)


def drawn_tolerances(study: Description, runner: Runner) -> tuple[dict[str, float], str]:
    """Half-widths (SI) of the sizes that the study gives spreads for: the loosest that keep its confidence.

    There is none for a draft of zero, which the drawing does not show.

    Returns
    -------
    the half-widths, and why there are none, if there are none
    """
    section = study.tolerance_settings
    if not section.of:
        return {}, "the study gives no spreads, [tolerance] of"
    result = tolerance.compute(study, NoOptions(), runner)
    shown = dimensions_of(study.cell)
    drawn = {s.parameter: result.loosest * s.half_range for s in section.of if s.parameter in shown}
    if not drawn:
        return {}, "the study gives spreads of the material or of what is not drawn only"
    if result.loosest > 0:
        return drawn, ""
    return {}, (
        f"none keeps the carrier in the gap with {section.confidence:.1%}, as [tolerance] asks; with the "
        f"study's own spreads the chance is {percent(result.plate)}"
    )


ANALYSIS = Analysis(
    name="export",
    result=Workshop,
    compute=compute,
    options=ExportOptions,
    check=check,
    doing="files for the workshop",
    writes=True,
)
