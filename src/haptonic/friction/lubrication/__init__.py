"""From vibration to friction: a squeeze film or intermittent contact, and an interval from both."""

from haptonic.friction.lubrication.parameters import FORCES, SPEEDS, Fingertip, Parameter, Touch
from haptonic.friction.lubrication.perception import (
    CUE_THRESHOLD,
    WEBER_FRACTION,
    Margin,
    QualityLimits,
    quality_limits,
    rise_time,
    time_constant,
)
from haptonic.friction.lubrication.prediction import explained, predict
from haptonic.friction.lubrication.sharing import (
    amplitude_for,
    amplitude_ratio,
    sensitivity,
    shared_friction,
)
from haptonic.friction.lubrication.slider import intermittent_friction, slider_friction

__all__ = [
    "CUE_THRESHOLD",
    "FORCES",
    "SPEEDS",
    "WEBER_FRACTION",
    "Fingertip",
    "Margin",
    "Parameter",
    "QualityLimits",
    "Touch",
    "amplitude_for",
    "amplitude_ratio",
    "explained",
    "intermittent_friction",
    "predict",
    "quality_limits",
    "rise_time",
    "sensitivity",
    "shared_friction",
    "slider_friction",
    "time_constant",
]
