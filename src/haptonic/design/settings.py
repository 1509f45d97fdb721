"""Settings of a design search: parameters, and limits of the workshop and the finger."""

from __future__ import annotations

from typing import Annotated

import numpy as np
from pydantic import Field

from haptonic.design.parameters import OfCell
from haptonic.fields import INLINE, Length, NumberRange, Quantity, described, once, problem, setting
from haptonic.materials import IsotropicMaterial

# centre of a long plate with clamped sides under a force: w = factor * F * span^2 / D (Timoshenko and
# Woinowsky-Krieger, Theory of Plates and Shells, table 37, the limit of long plates)
STRIP_FACTOR = 0.00725


@described("design.vary")
class Variable(OfCell, NumberRange):
    """A number of the cell that the design may change."""


@described("design", kw_only=True)
class DesignLimits:
    """Limits of the workshop, and the load on the plate; None for no limit."""

    slenderness: Annotated[float, Quantity("", at_least=0.1, at_most=100.0, typical=(1.0, 10.0))] | None = (
        setting(None, "Largest height of a pillar over its diameter.")
    )
    tool: Length | None = setting(
        None,
        "Diameter of the end mill: the least gap between two pillars, and the least width of a hole.",
        title="End mill",
        examples=["3 mm"],
    )
    reach: Length | None = setting(
        None,
        "Largest depth of the end mill's cut: largest height of a pillar, and largest depth of a hole.",
        examples=["20 mm"],
    )
    finger_force: Annotated[float, Quantity("N", above=0.0, at_most=1e3, typical=(0.1, 20.0))] | None = (
        setting(None, "Force in the middle of a waveguide of the given span.", title="Force of a finger")
    )
    finger_span: Length | None = setting(
        None, "Width of the waveguide under the finger.", title="Span", examples=["20 mm"]
    )
    finger_deflection: Length | None = setting(
        None, "Largest deflection of the plate; limits its thickness.", title="Deflection", examples=["10 um"]
    )

    def __post_init__(self) -> None:
        given = (self.finger_force, self.finger_span, self.finger_deflection)
        if None in given and given != (None, None, None):
            raise problem(
                "missing",
                "only some of finger_force, finger_span and finger_deflection",
                "all three of them, or none",
                "one of them was left out",
                "add the others",
                at="finger_force",
            )

    def least_thickness(self, material: IsotropicMaterial) -> float:
        """Smallest thickness of the plate that is stiff enough for the finger, m; 0 without a finger.

        The waveguide is long and its sides are clamped, so that its deflection w and bending stiffness D are
        ``w = STRIP_FACTOR F span^2 / D``, ``D = E h^3 / (12 (1 - nu^2))``.
        """
        if self.finger_force is None or self.finger_span is None or self.finger_deflection is None:
            return 0.0
        stiffness = STRIP_FACTOR * self.finger_force * self.finger_span**2 / self.finger_deflection
        nu = material.poisson_ratio
        return float(np.cbrt(12 * (1 - nu**2) * stiffness / material.youngs_modulus))


@described("design", kw_only=True)
class DesignSettings:
    """Parameters of a design, and the effort of the search."""

    vary: tuple[Variable, ...] = setting(
        (), "Parameters that the design may change.", title="Parameters", max_length=12
    )
    starts: Annotated[int, Field(ge=1, le=1024, strict=True)] = setting(
        48, "Designs, the study's own among them, that the search tries first."
    )
    climbs: Annotated[int, Field(ge=1, le=64, strict=True)] = setting(
        3, "Number of best starts that are improved; more while none reaches the carrier."
    )
    steps: Annotated[int, Field(ge=1, le=200, strict=True)] = setting(
        12, "Designs computed in each climb at most."
    )
    limits: Annotated[DesignLimits, INLINE] = setting(
        DesignLimits(), "Limits of the workshop and the finger."
    )
    pitches: Annotated[int, Field(ge=2, le=40, strict=True)] = setting(
        6, "Number of pitches that are compared for the front."
    )

    def __post_init__(self) -> None:
        once(self.vary, "vary")
