"""Comparison of two sets of bands: of studies, of results, or of a table from another program."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from haptonic.analyses.analysis import Analysis
from haptonic.analyses.bands import compute_bands
from haptonic.analyses.comparing import OfTable, check_table, of_dataset, of_file, of_table, zone_of
from haptonic.analyses.options import COUNT, UnitsOfFile, option
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import no_cell
from haptonic.analyses.table_path import OurPath
from haptonic.arrays import Array
from haptonic.brillouin import IrreducibleZone
from haptonic.errors import StudyError, shown
from haptonic.fields import table
from haptonic.later import xarray as xr
from haptonic.results.comparison import MOST_APART, Comparison
from haptonic.study.loading import load_as
from haptonic.study.schema import Description
from haptonic.study.template import ENDING
from haptonic.units import in_percent

RESULT = "bands.nc"  # in the folder of `haptonic bands`
SAME_CORNER = 0.25  # units of pi; corners of one name differ by less in lattices of similar shape


@dataclass(frozen=True, kw_only=True)
class CompareOptions(UnitsOfFile):
    """Options of the comparison."""

    first: Path = option(help="A study, or the folder of its bands.", place="before")
    second: Path = option(
        help="Another study or folder, or a table of bands from another program.", place="before"
    )
    wavevector: str | None = option(
        None,
        "Unit of the table's wavevector: rad/m, rad/mm, pi/a, 2pi/a, share (of the path) or segments.",
        metavar="UNIT",
    )
    skip_lines: int = option(
        0, "Lines at the top of the table that are left out.", metavar="N", quantity=COUNT
    )
    any_difference: bool = option(
        False, f"Also report a table that is more than {in_percent(MOST_APART)} apart, otherwise an error."
    )

    @property
    def of_table(self) -> OfTable:
        """The user's statements about the table."""
        return OfTable(
            wavevector=self.wavevector, frequency_unit=self.frequency_unit, skip_lines=self.skip_lines
        )

    @cached_property
    def studies(self) -> dict[Path, Description]:
        """The studies among the two files, each read once."""
        paths = dict.fromkeys(path for path in (self.first, self.second) if kind_of(path) == "study")
        return {path: load_as(path, Description) for path in paths}

    @cached_property
    def results(self) -> dict[Path, xr.Dataset]:
        """The bands of results among the two files, each read once."""
        paths = dict.fromkeys(path for path in (self.first, self.second) if kind_of(path) == "result")
        return {path: of_file(path / RESULT if path.is_dir() else path) for path in paths}


def kind_of(path: Path) -> str:
    """Kind of a file: "study", "result" or "table"."""
    if path.suffix == ENDING:
        return "study"
    return "result" if path.suffix == ".nc" or path.is_dir() else "table"


def check(study: None, options: CompareOptions) -> None:
    """Raise HaptonicError if the first is a table, or if the second is a table that does not fit its path."""
    if kind_of(options.first) == "table":
        raise StudyError.conflict(
            argument="FIRST",
            given=shown(str(options.first), 100),
            allowed="a study (.toml), or a folder of `haptonic bands`",
            cause="a table of another program has no lattice, so it defines no path",
            next_step=f"haptonic compare {options.second} {options.first}"
            if kind_of(options.second) != "table"
            else "describe the cell in a study: `haptonic new`",
        )
    if kind_of(options.second) == "table":
        # missing units are refused before bands are computed
        ours = options.studies.get(options.first)
        path = None if ours is None else OurPath.of_cell(ours.cell)
        check_table(options.second, path, options.of_table)


def compute(study: None, options: CompareOptions, runner: Runner) -> Comparison:
    """Compare two sets of bands; those of a study come from the store if they were computed before.

    Raises
    ------
    StudyError : neither a study nor a result, or lattices with different paths
    ChannelError : a table that cannot be read, or whose units are not given
    StudyError : a table that differs by more than `MOST_APART`, unless ``any_difference`` is set
    """
    paths, described = (options.first, options.second), options.studies.get(options.first)
    names = [path.absolute().stem for path in paths]
    if names[0] == names[1]:
        names = [str(path) for path in paths]
    if kind_of(options.second) == "table":
        if described is None:
            ours = options.results[options.first]
            theirs = of_table(options.second, OurPath.of_dataset(ours), options.of_table)
        else:
            theirs = of_table(options.second, OurPath.of_cell(described.cell), options.of_table)
            ours = bands_of(options.first, options, runner, also=theirs.position)
        result = Comparison(of_dataset(names[0], ours), theirs)
        if not options.any_difference:
            result.refuse_apart()
        return result
    zones = _zones(options)
    second = of_dataset(names[1], bands_of(options.second, options, runner, zone=zones[1]))
    first = of_dataset(
        names[0], bands_of(options.first, options, runner, also=second.position, zone=zones[0])
    )
    return Comparison(first, second, {path: key.unit for path, key in table(Description).items()})


def _zones(options: CompareOptions) -> list[IrreducibleZone | None]:
    """Zones on whose edges both are compared; None for their own.

    Two crystals of one kind of lattice, of which one has less symmetry, are compared on its path.

    Raises
    ------
    StudyError : lattices, or results of crystals, with different paths
    """
    paths, studies = (options.first, options.second), options.studies
    corners = [
        studies[path].cell.zone.corners if path in studies else zone_of(options.results[path])
        for path in paths
    ]
    labels = [[label for label, _ in zone] for zone in corners]
    if labels[0] == labels[1]:
        first, second = (np.array([phases for _, phases in zone]) for zone in corners)
        if np.abs(first - second).max() < SAME_CORNER:
            return [None, None]
    cells = [studies[path].cell for path in paths if path in studies]
    if len(cells) == 2 and cells[0].lattice.name == cells[1].lattice.name:
        wide = min(cells, key=lambda cell: len(cell.point_group.operations)).zone.corners
        return [IrreducibleZone(cell.lattice, wide) for cell in cells]
    raise StudyError.mismatch(
        argument="SECOND",
        given=f"a path {' '.join(labels[1])}",
        allowed=f"{' '.join(labels[0])} with the same wavevectors, the path of {options.first}",
        cause="lattices of different kinds and crystals of different symmetry have different zones",
        next_step="compare lattices of one kind, and give the studies of both",
    )


def bands_of(
    path: Path,
    options: CompareOptions,
    runner: Runner,
    also: Sequence[float] | Array = (),
    zone: IrreducibleZone | None = None,
) -> xr.Dataset:
    """Bands of a study on the edge of a zone, also at further positions there, or those of a result."""
    study = options.studies.get(path)
    if study is None:
        return options.results[path]
    bands = compute_bands(
        study.cell,
        study.bands_settings,
        surface=False,
        also=np.asarray(also).tolist(),
        zone=zone,
        inputs=study.inputs(),
        carrier=study.carrier,
        store=runner.store,
    )
    return bands.dataset


ANALYSIS = Analysis(
    name="compare",
    result=Comparison,
    compute=compute,
    supports=no_cell,
    options=CompareOptions,
    check=check,
    study="none",
    doing="bands of both",
)
