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
from haptonic.fields import Entries, ExpressedNumber, Quantity, number_of
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
    turns = [np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])] * 4
    tensor = np.einsum("ai,bj,ck,dl,ijkl->abcd", *turns, elasticity_tensor(stiffness), optimize=True)
    first, second = np.array(PAIRS).T
    matrix = tensor[first[:, None], second[:, None], first, second]
    return np.asarray((matrix + matrix.T) / 2)


def is_symmetry(stiffness: Array, operation: Array) -> bool:
    """True if an orthogonal map (3, 3) of space leaves a stiffness (6, 6) unchanged."""
    return _is_symmetry(tuple(np.ravel(stiffness)), tuple(np.ravel(operation)))


@lru_cache(maxsize=256)
def _is_symmetry(stiffness: tuple[float, ...], operation: tuple[float, ...]) -> bool:
    tensor = elasticity_tensor(np.reshape(stiffness, (6, 6)))
    turns = [np.reshape(operation, (3, 3))] * 4
    image = np.einsum("ai,bj,ck,dl,ijkl->abcd", *turns, tensor, optimize=True)
    return bool(np.abs(image - tensor).max() <= SYMMETRY_TOLERANCE * np.abs(tensor).max())


def require_name(name: object) -> None:
    if not isinstance(name, str) or not name.strip():
        raise StudyError.missing(
            argument="material.name",
            given=shown(name),
            allowed="a text that is not empty",
            cause="the name was left out",
            next_step="give the material a name; reports and plots show it",
        )


def require_between(
    name: str,
    value: object,
    unit: str,
    *,
    above: float = -math.inf,
    at_least: float = -math.inf,
    below: float = math.inf,
) -> None:
    """Refuse anything but a finite number in the interval."""
    number = isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
    if number and above < value and at_least <= value < below:  # type: ignore[operator]
        return
    limits = {"above": above, "at least": at_least, "below": below}
    bounds = [
        f"{bound} {format_quantity(limit, unit)}" for bound, limit in limits.items() if math.isfinite(limit)
    ]
    raise StudyError.out_of_range(
        argument=f"material.{name}",
        given=format_quantity(float(value), unit) if number else shown(value),  # type: ignore[arg-type]
        allowed="a finite number" + (f" {' and '.join(bounds)}" if bounds else f" in {unit}" * bool(unit)),
        cause="no stable solid has this value" if number else "it is not a finite number",
        next_step=f"check the value and its unit{f' ({unit})' if unit else ''}",
    )


def spread_of(uncertainty: Mapping[str, float], properties: Mapping[str, str]) -> Entries[float]:
    """Check and copy ``uncertainty``: half-widths of the plausible intervals of properties.

    ``properties`` maps each allowed name to its SI unit.
    """
    for name, width in uncertainty.items():
        if name not in properties:
            at, cause = f"material.uncertainty.{name}", "this material has no such property"
            raise StudyError.unknown(at, name, properties, cause, next_step="leave it out")
        require_between(f"uncertainty.{name}", width, properties[name], at_least=0.0)
    return Entries({
        name: width if isinstance(width, ExpressedNumber) else float(width)
        for name, width in uncertainty.items()
    })  # fmt: skip


def half_widths(properties: Mapping[str, str]) -> Callable[[object, ValidationInfo], object]:
    """Reader of the uncertainties of a study file; ``properties`` is that of `spread_of`."""

    def read(value: object, info: ValidationInfo) -> object:
        if not isinstance(value, Mapping):
            return value
        with collected(within="material.uncertainty"):
            spread_of(dict.fromkeys(map(str, value), 0.0), properties)  # names are refused before their units
            widths = {name: number_of(width, properties[name], info.context) for name, width in value.items()}
            return spread_of(widths, properties)

    return read


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
