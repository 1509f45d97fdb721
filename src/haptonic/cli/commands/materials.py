"""``haptonic materials``: the built-in materials."""

from __future__ import annotations

from typing import Annotated

import numpy as np
import typer

from haptonic.cli.commands import Json
from haptonic.cli.console import speaking
from haptonic.cli.listing import entry
from haptonic.errors import StudyError, nearest
from haptonic.materials import IsotropicMaterial, Material, PiezoelectricMaterial, library
from haptonic.results.table import Column, Table
from haptonic.units import format_quantity

UNITS = {"youngs_modulus": "Pa", "density": "kg/m^3"}  # units of the uncertainties
Pattern = Annotated[
    str | None,
    typer.Argument(metavar="PATTERN", help="Part of a name; prints all facts of the matching materials."),
]


def run(pattern: Pattern = None, json: Json = False) -> None:
    """List the materials; with a pattern, print sources and notes of those that match."""
    with speaking(json) as voice:
        solids = {name: solid for name, solid in library().items() if (pattern or "").lower() in name}
        if not solids:
            guess = nearest(str(pattern).lower(), library())
            instead = f"haptonic materials {guess}" if guess else "give its constants in a [material] table"
            raise StudyError.unknown(
                "pattern", pattern, library(), "no built-in material has this text in its name", slip=False,
                allowed=f"part of one of {', '.join(library())}", next_step=instead,
            )  # fmt: skip
        voice.answer({"materials": {name: solid.to_dict() for name, solid in solids.items()}})
        if pattern is None:
            voice.show(overview(solids))
            voice.write(
                'In a study: material = "steel". `haptonic materials steel` prints its source and notes.'
            )
        else:
            for name, solid in solids.items():
                entry(voice, name, lines(solid))


def overview(solids: dict[str, Material]) -> Table:
    """Table of name, stiffness, density and losses of each material."""
    columns = (
        "name",
        "kind",
        Column("stiffness", "Pa", "GPa", ".4g"),
        Column("Poisson ratio", form=".3g"),
        Column("density", "kg/m^3", form=".4g"),
        Column("loss factor", form=".2g"),
    )
    rows = [
        (
            name,
            kind_of(solid),
            stiffness(solid),
            getattr(solid, "poisson_ratio", None),
            solid.density,
            solid.loss_factor,
        )
        for name, solid in solids.items()
    ]
    return Table("built-in materials", columns, rows)


def kind_of(solid: Material) -> str:
    """Kind of a material: isotropic, anisotropic or piezoelectric."""
    if isinstance(solid, PiezoelectricMaterial):
        return "piezoelectric"
    return "isotropic" if isinstance(solid, IsotropicMaterial) else "anisotropic"


def stiffness(solid: Material) -> float:
    """Young's modulus along x, Pa: 1 / s_11 of the compliance s = c^-1, at constant field."""
    return float(1.0 / np.linalg.inv(solid.stiffness)[0, 0])


def lines(solid: Material) -> dict[str, str]:
    """Constants of a material with their source and their uncertainty, as texts."""
    poisson = getattr(solid, "poisson_ratio", None)
    spread = [
        f"{name} {format_quantity(width, UNITS.get(name, ''))}" for name, width in solid.uncertainty.items()
    ]
    return {
        "kind": kind_of(solid),
        "stiffness": f"{format_quantity(stiffness(solid), 'Pa')}, Young's modulus along x",
        "Poisson ratio": "" if poisson is None else f"{poisson:g}",
        "density": f"{solid.density:g} kg/m^3",
        "loss factor": f"{solid.loss_factor:g}",
        "half-widths": ", ".join(spread),
        "source": solid.source,
        "note": solid.note,
        "in a study": f'material = "{solid.name}"',
    }
