"""The built-in materials, read from ``library.toml`` beside this file."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Mapping
from functools import cache
from importlib.resources import files
from types import MappingProxyType

from haptonic.errors import StudyError, nearest
from haptonic.fields import Named
from haptonic.materials.isotropic import IsotropicMaterial
from haptonic.materials.orthotropic import OrthotropicMaterial
from haptonic.materials.piezoelectric import PiezoelectricMaterial
from haptonic.units import shown

Material = IsotropicMaterial | OrthotropicMaterial | PiezoelectricMaterial

KINDS: Mapping[str, Callable[..., Material]] = {
    "isotropic": IsotropicMaterial,
    "cubic": OrthotropicMaterial.cubic,
    "piezoelectric": PiezoelectricMaterial,
}


@cache
def library() -> Mapping[str, Material]:
    """All built-in materials by name, in the order of the file."""
    entries = tomllib.loads(files("haptonic.materials").joinpath("library.toml").read_text("utf-8"))
    return MappingProxyType(
        {name: KINDS[entry.pop("kind")](name=name, **entry) for name, entry in entries.items()}
    )


def built_in_name(solid: Material) -> str | None:
    """The name by which the library holds this very material; None if it does not."""
    return solid.name if library().get(solid.name) == solid else None


def material(name: str) -> Material:
    """The built-in material of that name.

    Raises
    ------
    StudyError : unknown name; the nearest known one is named
    """
    if name in library():
        return library()[name]
    guess = nearest(name.lower(), library())
    raise StudyError(
        argument="material",
        given=shown(name),
        allowed=f"one of {', '.join(library())}, or a [material] table",
        cause="a slip in the name" if guess else "the library does not hold this material",
        next_step=f'write "{guess}"' if guess else "give its constants in a [material] table",
    )


GIVEN = Named(material, built_in_name, IsotropicMaterial, (OrthotropicMaterial, PiezoelectricMaterial))
"""How a study gives a material: by the name of a built-in one or by a table of constants."""
