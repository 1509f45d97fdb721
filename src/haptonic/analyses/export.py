"""Files for the workshop."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from datetime import date
from pathlib import Path
from typing import Any

from haptonic import workshop
from haptonic.analyses import tolerance
from haptonic.analyses.analysis import Analysis
from haptonic.analyses.options import NoOptions, option
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import made_of_parts
from haptonic.cell import UnitCell
from haptonic.design.discs import with_shared
from haptonic.errors import HaptonicError, ResourceError
from haptonic.later import xarray as xr
from haptonic.materials import Material
from haptonic.results.cost import BASE, Cost
from haptonic.results.result import Result
from haptonic.results.tolerance import percent
from haptonic.study.schema import Description
from haptonic.units import format_quantity, in_percent
from haptonic.workshop.part import Part
from haptonic.workshop.shape import MM, dimensions_of

KINDS = ("step", "dxf", "stl", "drawing")
FILES = 3.0  # s, for outlines, solids and the drawing of a cell
PER_FACE, BYTES_OF_FACE = 1e-3, 6e4  # s and B per face of a solid
PER_PAIR = 1.5e-7  # s per pair of faces
DRAWN = 0.04  # s per pillar on the drawing of a plate
# no carrier, no gap that contains it, no mesh of the accuracy
UNANSWERED = {"missing", "no-answer", "too-large"}


@dataclass(frozen=True)
class ExportOptions:
    """Options of the export; all kinds of files are written if none is named."""

    step: bool = option(False, "Solid, for CAD (needs haptonic[cad]).")
    dxf: bool = option(False, "Outlines seen from above.")
    stl: bool = option(False, "Surface as triangles.")
    drawing: bool = option(False, "Dimensioned drawing (PDF, DXF).")
    columns: int | None = option(
        None, "A piece of lattice with so many cells along x; without --columns and --rows the study's whole "
        "plate, or one cell if it has none.", metavar="N",
    )  # fmt: skip
    rows: int | None = option(None, "Cells along y; see --columns.", metavar="N")

    @property
    def kinds(self) -> list[str]:
        """Kinds of files to write."""
        return [kind for kind in KINDS if getattr(self, kind)] or list(KINDS)

    def part(self, study: Description) -> Part:
        """Part to export: the plate of the study, or a piece of its lattice.

        Raises
        ------
        GeometryError : an impossible number of cells, or a plate that cannot be manufactured
        """
        if study.plate_settings is not None and self.columns is None and self.rows is None:
            return Part.whole(study.mounted_plate(), study.cell)
        columns, rows = (1 if number is None else number for number in (self.columns, self.rows))
        return Part.piece(study.cell, columns, rows)

    @staticmethod
    def named(kind: str, stem: str, materials: Sequence[Material] = ()) -> list[str]:
        """Names of the files of a kind; a surface has one file per material, the plate's first."""
        if kind == "drawing":
            return [f"{stem}.pdf", f"{stem}-drawing.dxf"]
        others = materials[1:] if kind == "stl" else ()
        words = [re.sub(r"[^A-Za-z0-9]+", "-", material.name) for material in others]
        more = [f"{stem}-{number}-{word}.stl" for number, word in enumerate(words, start=2)]
        return [f"{stem}.{kind}", *more]

    def names(self, stem: str) -> list[str]:
        """Names of all files."""
        return [name for kind in self.kinds for name in self.named(kind, stem)]


@dataclass(frozen=True, eq=False, repr=False)
class Workshop(Result):
    """A plate, or a piece of lattice, as files for the workshop.

    part, cell, study, stem : the part, the study's cell and title, and the beginning of the files' names
    tolerances : half-widths (SI) of the sizes in the drawing; why_none : reason for a drawing without any
    wants_tolerances : True if the study sets tolerances
    left_out : kinds of files that cannot be written on this machine, each with the reason
    """

    title = "Files for the workshop"

    part: Part
    cell: UnitCell
    study: str
    stem: str
    options: ExportOptions
    tolerances: dict[str, float]
    why_none: str
    wants_tolerances: bool
    left_out: dict[str, str] = field(default_factory=dict)

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

    @property
    def kinds(self) -> list[str]:
        """Kinds of the files that are written."""
        return [kind for kind in self.options.kinds if kind not in self.left_out]

    def _names_of(self, *kinds: str) -> list[str]:
        """Names of the files of these kinds."""
        return [name for kind in kinds for name in self.options.named(kind, self.stem, self.part.materials)]

    def put(self, draft: Path, *_: object) -> None:
        for kind in self.kinds:
            paths = [draft / name for name in self._names_of(kind)]
            if kind == "drawing":
                sheet = workshop.part_drawing(
                    self.part, self.study,
                    tolerances=self.tolerances, why_none=self.why_none, date=date.today(),
                )  # fmt: skip
                for path in paths:
                    workshop.write_drawing(path, sheet)
            elif kind == "step":
                workshop.write_step(paths[0], self.part, title=self.study)
            elif kind == "stl":
                for path, material in zip(paths, self.part.materials, strict=True):
                    workshop.write_stl(path, self.part, material=material)
            else:
                workshop.write_dxf(paths[0], self.part)

    def summary(self) -> list[str]:
        name = "the whole plate"
        aside = "; regions, patches and supports are marked but are not part of the solid"
        if self.part.count is not None:
            name, aside = "a piece of lattice, {} x {} cells".format(*self.part.count), ""
        *lengths, angle = self.part.sides
        sizes = " x ".join(format_quantity(side / MM, "m") for side in lengths)
        if angle is not None:
            sizes += f" at {format_quantity(angle, 'rad')}"
        return [f"part: {name}, {sizes}, with {self.part.parts}{aside}"]

    def remarks(self) -> list[str]:
        missing = [f"{', '.join(self._names_of(kind))} is not written: {why}"
                   for kind, why in self.left_out.items()]  # fmt: skip
        if not (self.why_none and self.wants_tolerances):
            return missing
        return [*missing, f"the drawing has no tolerances: {self.why_none}"]

    def facts(self) -> dict[str, Any]:
        facts = {"whole_plate": self.part.count is None, "size_m": [side / MM for side in self.part.size],
                 "pillars": self.part.number, "stacks": self.part.number_of_stacks,
                 "materials": [material.name for material in self.part.materials]}  # fmt: skip
        if self.left_out:
            facts |= {"left_out": self.left_out}
        if "drawing" not in self.options.kinds:
            return facts
        return facts | {"tolerances": self.tolerances, "why_no_tolerances": self.why_none or None}

    def located(self, folder: Path) -> dict[str, Any]:
        return {"files": [str(folder / name) for name in self._names_of(*self.kinds)]}


def check(study: Description, options: ExportOptions) -> None:
    """Refuse a part that cannot be manufactured, and ``step`` by name if its extra is not installed."""
    options.part(study)
    if options.step:
        workshop.need_opencascade()


def left_out(options: ExportOptions) -> dict[str, str]:
    """Kinds of files, not asked for, that cannot be written on this machine, each with the reason."""
    if "step" not in options.kinds:
        return {}
    try:
        workshop.need_opencascade()
    except ResourceError as error:
        return {"step": f'{error.cause}; run: pip install "haptonic[cad]"'}
    return {}


def compute(study: Description, options: ExportOptions, runner: Runner) -> Workshop:
    """Prepare the files; the drawing has the computed tolerances, or the reason why there are none."""
    tolerances, why_none = dict[str, float](), ""
    if "drawing" in options.kinds:
        tolerances, why_none = drawn_tolerances(study, runner)
    return Workshop(
        part=options.part(study), cell=study.cell, study=study.title, options=options,
        stem="cell" if runner.about is None else runner.about.stem, tolerances=tolerances,
        why_none=why_none, wants_tolerances=bool(study.tolerance_settings.of), left_out=left_out(options),
    )  # fmt: skip


def drawn_tolerances(study: Description, runner: Runner) -> tuple[dict[str, float], str]:
    """Half-widths (SI) for the drawing: the loosest tolerances that keep the study's confidence.

    A draft angle of zero has none, because the drawing does not show it.

    Returns
    -------
    the half-widths, and the reason if there are none
    """
    section = study.tolerance_settings
    if not section.of:
        return {}, "the study gives no spreads, [tolerance] of"
    try:
        result = tolerance.compute(study, NoOptions(), runner)
    except HaptonicError as error:  # other errors of [tolerance] are raised
        if error.code == "out-of-range" and error.argument.startswith("tolerance.of"):
            return {}, f"a spread is too large, see {error.argument}: {error.allowed}"
        if error.code not in UNANSWERED:
            raise
        return {}, f"no gap contains the carrier, see {error.argument}: {error.cause}"
    shown = dimensions_of(study.cell)
    factor = result.loosest or 0.0
    drawn = {s.parameter: factor * s.half_range for s in section.of if s.parameter in shown}
    if not drawn:
        return {}, "the study gives spreads only for material constants or sizes that are not drawn"
    if factor > 0:
        return with_shared(study.cell, drawn), ""
    return {}, (
        f"no tolerance keeps the carrier in the gap with the confidence of [tolerance], "
        f"{in_percent(section.confidence, form='.1f')}; with the study's own spreads the probability is "
        f"{percent(result.plate)}"
    )


def cost(study: Description, options: ExportOptions) -> Cost:
    """Estimated cost of the files, and of the tolerances in a drawing if the study gives spreads."""
    part, total = options.part(study), Cost(FILES)
    if "step" in options.kinds:
        total += Cost(PER_FACE * part.faces + PER_PAIR * part.faces**2, BASE + BYTES_OF_FACE * part.faces)
    if "drawing" in options.kinds:
        total += Cost(DRAWN * (part.number + part.number_of_stacks))
        if study.carrier and study.tolerance_settings.of:
            # if the tolerances are refused, the drawing has none
            total += replace(tolerance.cost(study, NoOptions()), refusal=None)
    return total


ANALYSIS = Analysis(
    name="export",
    result=Workshop,
    compute=compute,
    supports=made_of_parts,
    cost=cost,
    options=ExportOptions,
    check=check,
    doing="files for the workshop",
    writes=True,
)
