"""Solids of a CAD program in place of pillars and discs: the file, and what its solids consist of."""

from __future__ import annotations

import hashlib
import importlib.util
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, ClassVar

import numpy as np

from haptonic.arrays import Array, Bools
from haptonic.errors import GeometryError, ResourceError, shown
from haptonic.fields import Aliases, absent, described, meant, needed, problem, setting
from haptonic.foreign.process import Limits, ask
from haptonic.materials import GIVEN, Material
from haptonic.units import format_quantity

LARGEST_FILE = 200_000_000  # bytes
ENDINGS = (".step", ".stp")
SECONDS, MEMORY = 600.0, 12 * 2**30  # of the processor, and bytes, that a file may take
MOST_PARTS = 64


@described("cell.solid.part", GeometryError)
class SolidPart:
    """What a solid of the file consists of."""

    name: str = needed(
        "Name of the solid in the file; unnamed ones are called solid1, solid2, ... in order.",
        examples=["core"],
    )
    material: Annotated[Material, GIVEN] = needed(
        "A built-in name or its constants.", title="Material of the solid"
    )


@described("cell.solid", GeometryError)
class Solid:
    """One period of a plate as a CAD program drew it, in a STEP file.

    The file may have any part of the lattice that fills the plane when it is repeated: a hexagon or a
    rhombus, with a pillar in its middle or at its corners. Around some place the plate has to be whole along
    the sides of the cell, of one material, and as thick as ``[cell]`` says.

    Raises
    ------
    GeometryError : a file that is not there, of another format, or of other content than ``sha256`` says
    """

    aliases: ClassVar[Aliases] = {
        **meant("file", "path", "step", "cad", "name"),
        **meant("part", "parts", "material", "materials", "solid"),
        **absent(
            "unit", "scale",
            cause="a STEP file gives the unit of its lengths itself",
            next_step="leave it out, or export the file again in the right unit",
        ),
    }  # fmt: skip

    file: str = needed(
        "A STEP file, its path counted from the study's folder.",
        title="CAD file",
        min_length=1,
        examples=["cell.step"],
    )
    sha256: str = setting(
        "",
        "Hash of the file; filled in, and one that is given has to agree.",
        title="Hash of the file",
        examples=["9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"],
    )
    part: tuple[SolidPart, ...] = setting(
        (),
        "Materials of the file's solids; those without a table are of the material of the plate.",
        title="Materials of solids",
        max_length=MOST_PARTS,
    )

    def __post_init__(self) -> None:
        path = Path(self.file)
        if path.suffix.lower() not in ENDINGS:
            raise problem(
                "unsupported",
                shown(self.file, 100),
                f"a file whose name ends in {' or '.join(ENDINGS)}",
                "solids are read from STEP files (ISO 10303-21)",
                "export the cell as STEP from the program that drew it",
                at="file",
            )
        try:
            size = path.stat().st_size if path.is_file() else -1
            content = path.read_bytes() if 0 <= size <= LARGEST_FILE else b""
        except OSError as error:
            raise _unread(self.file, f"the system says: {error.strerror}") from None
        if size < 0:
            raise _unread(self.file, "there is no such file")
        if size > LARGEST_FILE:
            raise _unread(self.file, f"it is larger than {LARGEST_FILE // 10**6} MB")
        found = hashlib.sha256(content).hexdigest()
        if self.sha256 and self.sha256 != found:
            raise problem(
                "mismatch",
                shown(self.sha256, 80),
                found,
                "the file was changed after its hash was written down",
                "leave sha256 out to take the file as it is, or bring the older file back",
                at="sha256",
            )
        names = [part.name for part in self.part]
        if (twice := next((name for name in names if names.count(name) > 1), None)) is not None:
            raise problem(
                "repeated", shown(twice), "a table for each solid", "a solid has two materials",
                "leave one of the tables out", at="part",
            )  # fmt: skip
        object.__setattr__(self, "sha256", found)

    def period(self, tile: Array, vectors: Array, thickness: float, turns: Array) -> SolidPeriod:
        """The solids as one period of a plate.

        Parameters
        ----------
        tile : (sides, 2) corners of the polygon that repeats, m; vectors : (2, 2) translations, m
        thickness : of the plate, m; turns : (n, 2, 2) maps of the plane that may leave the solids as they are

        Raises
        ------
        GeometryError : solids that make no period of such a plate
        ChannelError, ResourceError : the file cannot be read, or the libraries for it are not installed
        """
        found = self.ask("inspected", tile=tile, vectors=vectors, thickness=thickness, turns=turns)
        if found["problem"]:
            raise _no_period(found["problem"], found, thickness)
        names = list(found["names"])
        if unknown := [part.name for part in self.part if part.name not in names]:
            raise GeometryError.unknown(
                known=names,
                argument="cell.solid.part.name",
                given=shown(unknown[0]),
                allowed=f"a solid of the file: {', '.join(map(shown, names))}",
                cause="no solid has this name",
                next_step="write one of these names; the program that drew them may show others",
            )
        kept = np.asarray(found["kept"], dtype=bool)
        return SolidPeriod(tuple(names), np.array(found["volumes"]), kept, int(found["elements"]))

    @property
    def materials(self) -> dict[str, Material]:
        """Materials of the solids that have their own, by their key in [cell]."""
        return {f"solid.part[{n}].material": part.material for n, part in enumerate(self.part, start=1)}

    def material_of(self, name: str, plate: Material) -> Material:
        """What the solid of a name consists of."""
        return next((part.material for part in self.part if part.name == name), plate)

    def ask(self, question: str, **arguments: object) -> dict[str, Any]:
        """The answer of `haptonic.foreign.solids` about the file."""
        if importlib.util.find_spec("ngsolve") is None:
            raise ResourceError.not_installed(
                argument="cell.solid",
                given="a Python without ngsolve",
                allowed="a Python with the package ngsolve, which meshes solids of CAD files",
                cause="the extra for CAD files is not installed",
                next_step='run: pip install "haptonic[cad]"',
            )
        answer: dict[str, Any] = ask(
            f"solids.{question}",
            Path(self.file),
            limits=Limits(SECONDS, 4 * SECONDS, MEMORY),
            digest=self.sha256,
            **arguments,
        )
        return answer


@dataclass(frozen=True, eq=False)
class SolidPeriod:
    """What a file has for one period.

    names, volumes : of its solids, m^3; kept : which maps leave them as they are; elements : of their mesh
    """

    names: tuple[str, ...]
    volumes: Array
    kept: Bools
    elements: int


def _unread(file: str, cause: str) -> Exception:
    return problem(
        "not-found", shown(file, 100), "a STEP file that can be read", cause,
        "check the path; it is counted from the folder of the study, in Python from the working directory",
        at="file",
    )  # fmt: skip


def _no_period(kind: str, found: dict[str, Any], thickness: float) -> GeometryError:
    """The error for solids that make no period of a plate."""
    share, length = found["number"], format_quantity(found["number"], "m")
    if kind == "thickness":
        return GeometryError.mismatch(
            argument="cell.thickness",
            given=format_quantity(thickness, "m"),
            allowed=f"{length}, as in the file",
            cause="the plate of the file has another thickness along the sides of the cell",
            next_step=f'write thickness = "{length}" in [cell], or check the unit of the file',
        )
    words = {
        "empty": (
            "a file without a solid", "at least one solid",
            "it has surfaces or curves only", "export the cell as solids",
        ),
        "period": (
            f"solids whose copies fill {share:.4g} times their volume", "solids that fill one period",
            "the lattice of [cell] is not that of the file, so that copies overlap or leave gaps, or the "
            "file has more than one period",
            "check lattice, pitch and pitch_y against the drawing, and the unit of the file",
        ),
        "sides": (
            "a plate that is not whole along the sides of the cell", "a flat plate of one thickness there",
            "around every place tried, holes or pillars reach a side of the cell: they touch their "
            "neighbours, or the file is not drawn about one of them",
            "draw one period with its pillar or hole in the middle or at the corners",
        ),
        "materials": (
            "several solids along the sides of the cell", "one solid along all sides",
            "the plate consists of layers, or solids meet where cells do",
            "join the solids along the sides into one, or draw the period about another place",
        ),
        "overlap": (
            "solids that overlap", "solids that touch at most",
            "the same space belongs to two solids", "cut one out of the other in the program that drew them",
        ),
    }  # fmt: skip
    given, allowed, cause, next_step = words[kind]
    return GeometryError.mismatch(
        argument="cell.solid.file", given=given, allowed=allowed, cause=cause, next_step=next_step
    )
