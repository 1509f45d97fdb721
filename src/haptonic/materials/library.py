"""Built-in materials, read from ``library.toml`` beside this file."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Mapping
from functools import cache, partial
from importlib.resources import files
from types import MappingProxyType

from haptonic.errors import StudyError
from haptonic.fields import Named
from haptonic.materials.isotropic import IsotropicMaterial
from haptonic.materials.orthotropic import OrthotropicMaterial
from haptonic.materials.piezoelectric import PiezoelectricMaterial

Material = IsotropicMaterial | OrthotropicMaterial | PiezoelectricMaterial

KINDS: Mapping[str, Callable[..., Material]] = {
    "isotropic": IsotropicMaterial,
    "orthotropic": OrthotropicMaterial,
    "piezoelectric": PiezoelectricMaterial,
}
NOTHING = {"void", "air", "vacuum", "empty", "nothing", "none", "hole"}  # usual names of empty space


@cache
def library() -> Mapping[str, Material]:
    """All built-in materials by name, in the order of the file."""
    entries = tomllib.loads(files("haptonic.materials").joinpath("library.toml").read_text("utf-8"))
    return MappingProxyType(
        {name: KINDS[entry.pop("kind")](name=name, **entry) for name, entry in entries.items()}
    )


def built_in_name(solid: Material) -> str | None:
    """Name of this very material in the library; None if it is not built in."""
    return solid.name if library().get(solid.name) == solid else None


def material(name: str, *, piezoelectric: bool = False) -> Material:
    """Built-in material with a name; capitals and blanks of the name do not matter.

    Raises
    ------
    StudyError : unknown name, with the nearest known one, or a material that is not piezoelectric although it
        has to be
    """
    materials = ceramics() if piezoelectric else library()
    key = re.sub(r"[\s_-]+", "-", name.strip().lower())
    if key in materials:
        return materials[key]
    form = "a table of piezoelectric constants" if piezoelectric else "a [material] table"
    cause, next_step = "the library does not have this material", f"give its constants in {form}"
    if key in NOTHING:
        cause, next_step = "empty space is no material", "for a hole, write empty = true for a disc"
    elif key in library():
        cause = "it is not piezoelectric"
    allowed = f"one of {', '.join(materials)}, or {form}"
    raise StudyError.unknown("material", name, materials, cause, next_step=next_step, allowed=allowed)


def ceramics() -> Mapping[str, Material]:
    """Piezoelectric materials of the library."""
    return {key: solid for key, solid in library().items() if isinstance(solid, PiezoelectricMaterial)}


GIVEN = Named(
    find=material,
    name_of=built_in_name,
    known=library,
    tables=(IsotropicMaterial, OrthotropicMaterial),
    others=(PiezoelectricMaterial,),
)
"""Forms of a material in a study: name of a built-in one, or a table of constants."""
CERAMIC = Named(
    find=partial(material, piezoelectric=True),
    name_of=built_in_name,
    known=ceramics,
    tables=(PiezoelectricMaterial,),
)
"""Forms of a piezoelectric material in a study."""
