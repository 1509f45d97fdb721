"""The touching finger, and the drive of the plate."""

from __future__ import annotations

from typing import Annotated

from haptonic.errors import FrictionError
from haptonic.fields import INLINE, Quantity, described, setting
from haptonic.friction.lubrication.parameters import Fingertip, Force, Ordered, Speed, Touch

Damping = Annotated[float, Quantity("N s/m", above=0.0, at_most=1e4, typical=(1.0, 100.0))]
VOLTAGE = Quantity("V", above=0.0, at_most=1e4, typical=(1.0, 500.0))
USUAL_DAMPING = (5.0, 10.0, 30.0)  # N s/m, assumed for a fingertip on a vibrating plate


@described("touch", FrictionError)
class Pad(Ordered):
    """Load of the finger on the plate: a damper, spread evenly over a disc."""

    diameter: Annotated[float, Quantity("m", at_least=1e-3, at_most=40e-3, typical=(5e-3, 20e-3))] = setting(
        10e-3, "Diameter of the disc below the finger; assumed.", title="Diameter below the finger"
    )
    damping: tuple[Damping, Damping, Damping] = setting(
        USUAL_DAMPING,
        "Damping of the whole disc: lowest plausible, value, highest plausible; assumed.",
        title="Damping of the finger",
    )


@described("touch", FrictionError, kw_only=True)
class TouchSettings:
    """The touching finger, and the drive of the plate."""

    force: Force = setting(0.5, "Force normal to the plate.", title="Force of the finger")
    speed: Speed = setting(0.078, "Speed along the plate.", title="Speed of the finger")
    pad: Annotated[Pad, INLINE] = setting(Pad(), "Load of the finger on the plate.")
    voltage: Annotated[float, VOLTAGE] | None = setting(
        None, "Voltage of the first drive, to which the others keep their ratio; by default the plate's."
    )
    skin: Fingertip = setting(Fingertip(), "Parameters of the friction models.")

    def at(self, frequency: float) -> Touch:
        """The touch at a frequency of the plate, Hz."""
        return Touch(frequency, self.force, self.speed)
