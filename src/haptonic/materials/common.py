"""Common parts of all materials: declarations of fields, checks at construction, Voigt's notation."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Annotated

import numpy as np
from pydantic import Field, ValidationInfo

from haptonic.arrays import Array
from haptonic.errors import StudyError, shown
from haptonic.fields import Entries, Quantity, number_of
from haptonic.fields.quantity import collected
from haptonic.units import format_quantity

VOIGT = ((0, 5, 4), (5, 1, 3), (4, 3, 2))  # Voigt number of the pair (i, j); order 11 22 33 23 13 12
PAIRS = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))  # of the Voigt numbers
DENSITY = Quantity("kg/m^3", at_least=1.0, at_most=5e4, typical=(500.0, 23e3))
UNITS = {"stiffness": "Pa", "compliance": "1/Pa", "permittivity": "F/m"}
SYMMETRY_TOLERANCE = 1e-9  # relative to the largest entry of a matrix

LossFactor = Annotated[
    float,
    Quantity("", at_least=0.0, below=1.0, typical=(0.0, 0.2)),
    Field(description="Imaginary over real part of the stiffness; about 1 / Q."),
]
MaterialName = Annotated[str, Field(description="Name in reports.", min_length=1, strict=True)]
Source = Annotated[
    str,
    Field(
        description="Source of the constants: words, or a key of the bibliography.",
        strict=True,
        examples=["data sheet"],
    ),
]
Note = Annotated[str, Field(description="Further facts on the constants.", strict=True, examples=["rolled"])]


def elasticity_tensor(stiffness: Array) -> Array:
    """(3, 3, 3, 3) tensor c_ikjl from the (6, 6) Voigt matrix, Pa."""
    voigt = np.array(VOIGT)
    return np.asarray(stiffness[voigt[:, :, None, None], voigt[None, None, :, :]])


def turned(stiffness: Array, angle: float) -> Array:
    """A stiffness (6, 6) whose axes are turned about axis 3 by an angle, in the axes before the turn, Pa."""
    if angle == 0.0:
        return stiffness
    cosine, sine = math.cos(angle), math.sin(angle)
    turn = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    tensor = _image(elasticity_tensor(stiffness), turn)
    first, second = np.array(PAIRS).T
    matrix = tensor[first[:, None], second[:, None], first, second]
    return np.asarray((matrix + matrix.T) / 2)


def is_symmetry(stiffness: Array, operation: Array) -> bool:
    """True if an orthogonal map (3, 3) of space leaves a stiffness (6, 6) unchanged."""
    return _is_symmetry(tuple(np.ravel(stiffness)), tuple(np.ravel(operation)))


@lru_cache(maxsize=256)
def _is_symmetry(stiffness: tuple[float, ...], operation: tuple[float, ...]) -> bool:
    tensor = elasticity_tensor(np.reshape(stiffness, (6, 6)))
    image = _image(tensor, np.reshape(operation, (3, 3)))
    return bool(np.abs(image - tensor).max() <= SYMMETRY_TOLERANCE * np.abs(tensor).max())


def _image(tensor: Array, operation: Array) -> Array:
    """Image of a tensor (3, 3, 3, 3) in an orthogonal map (3, 3) of space."""
    return np.asarray(np.einsum("ai,bj,ck,dl,ijkl->abcd", *[operation] * 4, tensor, optimize=True))


def require_name(name: object) -> None:
    if not isinstance(name, str) or not name.strip():
        raise StudyError.missing(
            argument="material.name",
            given=shown(name),
            allowed="a text that is not empty",
            cause="the name was left out",
            next_step="give the material a name; reports and plots show it",
        )


def half_widths(properties: Mapping[str, str]) -> Callable[[object, ValidationInfo], object]:
    """Reader of the uncertainties of a material: half-widths of the plausible intervals of its properties.

    ``properties`` maps each allowed name to its SI unit.
    """

    def read(value: object, info: ValidationInfo) -> object:
        if not isinstance(value, Mapping):
            return value
        with collected(within="material.uncertainty"):
            for name in value:  # all names before any unit
                if name not in properties:
                    at, cause = f"material.uncertainty.{name}", "this material has no such property"
                    raise StudyError.unknown(at, name, properties, cause, next_step="leave it out")
            widths = {name: number_of(width, properties[name], info.context) for name, width in value.items()}
            for name, width in widths.items():
                _require_half_width(name, width, properties[name])
            return Entries(widths)

    return read


def _require_half_width(name: str, width: float, unit: str) -> None:
    """Refuse a half-width that is negative or not finite."""
    if math.isfinite(width) and width >= 0:
        return
    finite = math.isfinite(width)
    raise StudyError.out_of_range(
        argument=f"material.uncertainty.{name}",
        given=format_quantity(width, unit) if finite else shown(width),
        allowed=f"a finite number at least {format_quantity(0.0, unit)}",
        cause="no stable solid has this value" if finite else "it is not a finite number",
        next_step=f"check the value and its unit{f' ({unit})' if unit else ''}",
    )


def require_positive_definite(
    kind: str,
    matrix: Array,
    at: str,
    cause: str = "with these constants the solid would deform by itself",
    next_step: str = "check the signs, the order of the entries and which of them are compliances",
) -> None:
    """Refuse a symmetric matrix whose energy is zero or negative for some deformation or field.

    kind : stiffness, compliance or permittivity; at : key of the material that is blamed
    """
    smallest = float(np.linalg.eigvalsh(matrix).min())
    if smallest <= SYMMETRY_TOLERANCE * float(np.abs(matrix).max()):
        raise StudyError.malformed(
            argument=f"material.{at}",
            given=f"a {kind} matrix with an eigenvalue of {smallest:.3g} {UNITS[kind]}",
            allowed="a positive definite matrix",
            cause=cause,
            next_step=next_step,
        )
