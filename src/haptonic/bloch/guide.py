"""Modes of a strip of plain plate between two lattices, which reflect flexural waves within their gap.

If neither a mirror nor a half turn maps one lattice onto the other, only one wave is exchanged between
them, and only its phases matter: the strip is as wide as the mean of two strips, each between two images
of one of the lattices.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import scipy

from haptonic.arrays import Array
from haptonic.bloch.layers import Interface
from haptonic.bloch.rows import CondensedRows
from haptonic.bloch.wall import LEAD, Wall
from haptonic.errors import StudyError
from haptonic.names import counted
from haptonic.units import hz_text

WITHIN = 1e-4  # of an interval's upper end: accuracy of the frequency from which further waves propagate
CLOSED = 1e-6  # rad, largest phase mismatch of a mode


@dataclass(frozen=True)
class GuidedMode:
    """Mode of a strip.

    omega : rad/s; wavenumber : along the strip, rad/m; width : m; nodal_lines : across
    position : (s,) from the middle, m; amplitude : (s,) of w on the flat face, its peak 1
    at_edge : amplitude at the edge of the lattice, as a share of that peak; the larger one of two edges
    shift : from the middle to the point about which the mode is even or odd, to the right, m
    """

    omega: float
    wavenumber: float
    width: float
    nodal_lines: int
    position: Array
    amplitude: Array
    at_edge: float
    shift: float = 0.0


@dataclass(frozen=True)
class Guide:
    """Strip of plain plate between two half-infinite lattices.

    interface : its right edge, at the wavenumber along the strip
    left : its left edge, seen from the strip; None if it is an image of the right one
    """

    interface: Interface
    left: Interface | None = None

    @classmethod
    def of(cls, rows: CondensedRows, wavenumber: float, opposite: CondensedRows | None = None) -> Guide:
        """Make a guide for waves of a wavenumber (rad/m) along rows.

        opposite : the rows in the opposite direction, which are those to the left of the strip, turned by
            half a turn; None if they are equal. Of reciprocal lattices, waves in both directions along the
            strip are reflected with equal phases.
        """
        left = None if opposite is None else Interface.of(opposite, wavenumber)
        return cls(Interface.of(rows, wavenumber), left)

    def width(self, omega: float, nodal_lines: int) -> float:
        """Width (m) of the strip that has a mode at omega (rad/s) with a number of nodal lines across.

        Raises
        ------
        StudyError : other waves propagate across the strip, or no strip guides such a mode
        """
        return float(np.mean([_width(wall, omega, nodal_lines) for wall in self.walls(omega) or (None,)]))

    def mode_at(self, omega: float, nodal_lines: int) -> GuidedMode:
        """Mode at omega (rad/s) of the strip with the `width` for this mode."""
        return self.mode_with(omega, self.width(omega, nodal_lines), nodal_lines)

    def mode_with(self, omega: float, width: float, nodal_lines: int) -> GuidedMode:
        """The mode of a strip of a width (m) that has one at omega (rad/s)."""
        walls, along = self.walls(omega), float(self.interface.tangential[0])
        if len(walls) == 1:
            position, amplitude, at_edge = walls[0].across(width, nodal_lines)
            return GuidedMode(
                omega=omega, wavenumber=along, width=width, nodal_lines=nodal_lines, position=position,
                amplitude=amplitude, at_edge=at_edge,
            )  # fmt: skip
        widths = [_width(wall, omega, nodal_lines) for wall in walls]
        shift = 0.25 * (widths[1] - widths[0])
        right, left = (
            wall.across(width - 2 * side, nodal_lines)
            for wall, side in zip(walls, (shift, -shift), strict=True)
        )
        half = len(right[0]) // 2
        return GuidedMode(
            omega=omega, wavenumber=along, width=width, nodal_lines=nodal_lines,
            position=np.concatenate([-left[0][:half:-1], right[0][half:]]) + shift,
            amplitude=np.concatenate([left[1][:half:-1], right[1][half:]]),
            at_edge=max(left[2], right[2]), shift=shift,
        )  # fmt: skip

    def mode(self, width: float, nodal_lines: int, between: tuple[float, float]) -> GuidedMode:
        """Mode with a number of nodal lines across, and an angular frequency within an interval.

        Raises
        ------
        StudyError : other waves propagate across the strip, or it guides no such mode within the interval
        """
        return _mode(lambda _: self, width, nodal_lines, between)

    def walls(self, omega: float) -> tuple[Wall, ...]:
        """Walls at the right and, if it differs, the left edge; none below the cut-off of the flexural wave.

        Raises
        ------
        StudyError : other waves propagate across the strip
        """
        edges = (self.interface,) if self.left is None else (self.interface, self.left)
        walls = [Wall.of(edge, omega) for edge in edges]
        if any(wall is not None and wall.plate.waves.propagates.sum() > 1 for wall in walls):
            raise StudyError.no_answer(
                argument="waveguide.mode",
                given=f"{self.interface.tangential[0]:.4g} rad/m at {_kilohertz(omega)}",
                allowed=f"a wavenumber at which only {LEAD} propagates across the strip",
                cause="waves so long along the strip also excite in-plane waves or diffracted waves",
                next_step="use another number of intervals along the strip, a lower frequency, or "
                "`haptonic ribbon`, which computes all waves in the strip",
            )
        return tuple(wall for wall in walls if wall is not None)


def along_strip(omega: float, length: float, intervals: int, closed_by: CondensedRows | None = None) -> float:
    """Wavenumber (rad/m) along a strip of a length (m) with a number of intervals between nodal lines.

    Both conditions at the ends are approximate. A free end reflects flexural waves like the end of a long
    beam, so each end adds a quarter of an interval: ``k L = (intervals + 1/2) pi``. An end closed by a
    lattice acts like a support at the distance d behind the interface, as at normal incidence:
    ``k (L + 2 d) = (intervals + 2) pi``; conversion into other waves is neglected.

    Parameters
    ----------
    omega : rad/s, for the reflection at a lattice at the ends
    closed_by : rows of that lattice, at right angles to the strip; None for free ends
    """
    if closed_by is None:
        return (intervals + 0.5) * np.pi / length
    end = Wall.of(Interface.of(closed_by, 0.0), omega)
    assert end is not None, "at normal incidence the flexural wave always propagates"
    return float((intervals + 2) * np.pi / (length + 2 * end.fixed_line))


def strip_mode(
    rows: CondensedRows,
    *,
    width: float,
    length: float,
    intervals: int,
    nodal_lines: int,
    between: tuple[float, float],
    closed_by: CondensedRows | None = None,
    opposite: CondensedRows | None = None,
) -> GuidedMode:
    """Mode of a strip of finite length with a number of intervals between nodal lines along it.

    Parameters
    ----------
    rows : on both sides of the strip; width, length : of the strip, m
    intervals, nodal_lines : along and across the strip
    between : range of angular frequencies, rad/s
    closed_by : see `along_strip`; opposite : see `Guide.of`

    Raises
    ------
    StudyError : see `Guide.mode`; a strip narrower than the plain plate between rows and straight edges
    """
    if width <= 2 * rows.setback:
        raise StudyError.out_of_range(
            argument="waveguide.width",
            given=f"{width * 1e3:.4g} mm",
            allowed=f"more than {2 * rows.setback * 1e3:.4g} mm beside these rows",
            cause="their faces are not straight lines, and take up the whole width of the strip",
            next_step="choose a wider strip, or use `haptonic ribbon`, which accepts strips of any width",
        )

    def guide_at(omega: float) -> Guide:
        return Guide.of(rows, along_strip(omega, length, intervals, closed_by), opposite)

    if closed_by is None:
        return guide_at(between[0]).mode(width, nodal_lines, between)
    return _mode(guide_at, width, nodal_lines, between)


def _mode(
    guide_at: Callable[[float], Guide], width: float, nodal_lines: int, between: tuple[float, float]
) -> GuidedMode:
    """Mode of a strip whose wavenumber along it may depend on the angular frequency."""

    def misfit(omega: float) -> float:
        phases = [wall.phase(width, nodal_lines) for wall in guide_at(omega).walls(omega)]
        return float(np.mean(phases or [0.0])) - (nodal_lines + 1) * np.pi

    try:
        omega = _root(misfit, *between)
    except StudyError:  # other waves propagate at the upper end
        between = _with_one_wave(guide_at, between)
        omega = _root(misfit, *between)
    if omega is not None:
        guide = guide_at(omega)
        walls = guide.walls(omega)
        if walls and all(wall.closed for wall in walls):
            return guide.mode_with(omega, width, nodal_lines)
    raise _no_mode(nodal_lines, f"{_kilohertz(between[0])} to {_kilohertz(between[1])}")


def _with_one_wave(guide_at: Callable[[float], Guide], between: tuple[float, float]) -> tuple[float, float]:
    """The lower part of an interval of angular frequencies, in which one wave propagates across the strip.

    In-plane and diffracted waves propagate above a frequency of their own.

    Raises
    ------
    StudyError : other waves propagate already at the lower end
    """
    low, high = between
    guide_at(low).walls(low)
    top = high
    while high - low > WITHIN * between[1]:
        try:
            guide_at(top).walls(top)
            low = top
        except StudyError:
            high = top
        top = 0.5 * (low + high)
    return between[0], low


def _width(wall: Wall | None, omega: float, nodal_lines: int) -> float:
    """Width (m) of a strip between two images of a wall that has a mode at omega (rad/s)."""
    root, target = None, (nodal_lines + 1) * np.pi
    if wall is not None and wall.closed:
        guess, reach = (target - wall.delay) / wall.wavenumber, 0.5 * np.pi / wall.wavenumber
        root = _root(
            lambda width: wall.phase(width, nodal_lines) - target,
            max(guess - reach, 2 * wall.setback),
            guess + reach,
        )
    if root is None:
        raise _no_mode(nodal_lines, _kilohertz(omega))
    return root


def _root(misfit: Callable[[float], float], low: float, high: float) -> float | None:
    """Zero of a growing function within an interval; None for no zero or a jump."""
    if not misfit(low) < 0 < misfit(high):
        return None
    root = float(scipy.optimize.brentq(misfit, low, high, rtol=1e-12))
    return root if abs(misfit(root)) < CLOSED else None


def _no_mode(nodal_lines: int, where: str) -> StudyError:
    return StudyError.no_answer(
        argument="waveguide.mode",
        given=f"{counted(nodal_lines, 'nodal line')} at {where}",
        allowed=f"a mode that {LEAD} forms between mirrors that no wave enters",
        cause="the strip is too narrow or too wide for it, or the frequency lies outside the mirrors' gap",
        next_step="use another number of nodal lines, another width, or frequencies within the gap",
    )


def _kilohertz(omega: float) -> str:
    return hz_text(omega / (2 * np.pi))
