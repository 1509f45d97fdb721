"""Lattices as boundaries of a plain plate: the equivalent fixed line, and modes of a strip between two.

Within the gap, the lattice reflects flexural waves like a support at a line behind the interface. A strip of
plate between two such mirrors guides waves. With pillars on both faces, flexural waves are not coupled to
waves that are symmetric about the middle plane of the plate.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
import scipy

from haptonic.arrays import Array, Complex, Ints
from haptonic.bloch.evanescent import symmetric
from haptonic.bloch.layers import Interface
from haptonic.bloch.plate_waves import PlateWaves
from haptonic.bloch.rows import CondensedRows
from haptonic.errors import StudyError
from haptonic.later import linalg as la
from haptonic.names import counted
from haptonic.units import hz_text

LEAD = "A0"  # the wave that is guided
WITHIN = 1e-4  # of an interval's upper end: accuracy of the frequency from which further waves propagate
SAMPLES = 401  # positions of a mode across the strip
CLOSED = 1e-6  # rad, largest phase mismatch of a mode


@dataclass(frozen=True)
class Wall:
    """Lattice on the right as a boundary of the plate, at one frequency and tangential wavenumber.

    Widths of strips are measured from the average position of the lattice's face.

    plate : waves of the plate to the right that are coupled to the flexural wave
    members : (p,) their numbers among all waves of the plate to the right
    reflection : (p, p) amplitudes of their mirror images, to the left, for unit incident waves
    flexural : number of the propagating flexural wave
    closed : True if no wave coupled to the flexural one enters the lattice
    face : (h, p) harmonics of the normal motion along the lattice's face for unit waves
    setback : distance from the straight edge of the plain plate to the average face of the lattice, m
    """

    plate: PlateWaves
    members: Ints
    reflection: Complex
    flexural: int
    closed: bool
    face: Complex
    setback: float = 0.0

    @classmethod
    def of(cls, interface: Interface, omega: float) -> Wall | None:
        """Compute the wall at omega (rad/s); None if no flexural wave propagates towards it."""
        mirror = interface.mirror(omega)
        right = mirror.incoming
        leads = np.flatnonzero(right.labelled(LEAD) & (right.harmonic == 0))
        if not len(leads):
            return None
        images = replace(mirror, outgoing=right.mirrored(interface.plate.axes[0]))
        reflection = images.reflection()
        motion = right.waves.displacement + images.outgoing.waves.displacement @ reflection
        places = (mirror.motion @ motion).reshape(-1, interface.on_face.shape[1], 3, len(right))
        face = interface.on_face @ places[0, :, 2]
        entering, members = mirror.lattice.propagates, np.arange(len(right))
        if interface.mirrored:  # about the middle plane: A0 is antisymmetric
            levels = len(places)
            inside = mirror.lattice.displacement.reshape(levels, -1, 3, len(entering))
            entering = entering & ~symmetric(inside)
            profiles = right.waves.displacement.reshape(-1, levels, 3, len(right)).swapaxes(0, 1)
            antisymmetric = ~symmetric(profiles)
            right, reflection, face = (
                right.chosen(antisymmetric),
                reflection[np.ix_(antisymmetric, antisymmetric)],
                face[:, antisymmetric],
            )
            leads, members = np.cumsum(antisymmetric)[leads] - 1, np.flatnonzero(antisymmetric)
        return cls(
            plate=right,
            members=members,
            reflection=reflection,
            flexural=int(leads[0]),
            closed=not entering.any(),
            face=face,
            setback=interface.setback,
        )

    @property
    def wavenumber(self) -> float:
        """Wavenumber of the flexural wave across the interface, rad/m."""
        return float(np.abs(self.plate.wavenumber[self.flexural].real))

    @property
    def delay(self) -> float:
        """Phase (rad) from the lattice's face to the equivalent fixed line and back, from -pi/2 to 3 pi/2."""
        r = self.reflection[self.flexural, self.flexural]  # -1 for a support at the line itself
        r *= np.exp(2j * self.wavenumber * self.setback)
        return float(0.5 * np.pi - np.angle(-1j * r))

    @property
    def fixed_line(self) -> float:
        """Distance from the lattice's face to the equivalent support (w = 0) behind it, m."""
        return 0.5 * self.delay / self.wavenumber

    def phase(self, width: float, nodal_lines: int) -> float:
        """Phase (rad) of the flexural wave after its path across a strip and reflection at one wall.

        A mode reproduces itself after a round trip. Between mirrors that reflect all energy this is a
        condition on the phase, ``k w + delay = (n + 1) pi`` for n nodal lines across the width w.
        Evanescent waves also couple the walls; they are eliminated for fields of the parity of the mode and
        add to the phase. No other wave may propagate.
        """
        round_trip, _ = self._closing(width, nodal_lines)
        plain = width - 2 * self.setback
        alone = self.reflection[self.flexural, self.flexural] * np.exp(-1j * self.wavenumber * plain)
        return float(self.wavenumber * width + self.delay - np.angle(round_trip / alone))

    def across(self, width: float, nodal_lines: int) -> tuple[Array, Array, float]:
        """Positions (s,) from the middle of the strip, m, |w| (s,) there on the flat face, and at the edge.

        Positions cover the plain plate, which ends before an edge that is not straight. |w| is the root mean
        square over a period along the strip; its peak is 1.
        """
        end = 0.5 * width - self.setback
        position = np.linspace(-end, end, SAMPLES)
        size = np.linalg.norm(self.motion(width, nodal_lines, position), axis=0)
        at_edge = np.linalg.norm(self.face @ self.arriving(width, nodal_lines))
        return position, np.asarray(size / size.max()), float(at_edge / size.max())

    def motion(self, width: float, nodal_lines: int, position: Array) -> Complex:
        """(h, s) harmonics of w on the flat face at positions (s,) from the middle of a strip, m."""
        sign, end = (-1) ** nodal_lines, 0.5 * width - self.setback
        k = 1j * self.plate.wavenumber[:, None]
        away = np.exp(k * (end - position)) + sign * np.exp(k * (end + position))
        harmonics = int(self.plate.harmonic.max()) + 1
        on_face = self.plate.waves.displacement.reshape(harmonics, -1, 3, len(self.plate))[:, 0, 2]
        return np.asarray(on_face @ (self._amplitudes(width, nodal_lines)[:, None] * away))

    def arriving(self, width: float, nodal_lines: int) -> Complex:
        """(p,) amplitudes at the right wall of waves to the right."""
        plain = width - 2 * self.setback
        passed = np.exp(1j * self.plate.wavenumber * plain)
        return np.asarray((-1) ** nodal_lines * self._amplitudes(width, nodal_lines) * passed)

    def _amplitudes(self, width: float, nodal_lines: int) -> Complex:
        """(p,) amplitudes of the waves reflected by a wall, the flexural one 1."""
        _, others = self._closing(width, nodal_lines)
        return np.insert(others, self.flexural, 1.0)

    def _closing(self, width: float, nodal_lines: int) -> tuple[complex, Complex]:
        """Factor of the flexural wave after one crossing, and the other amplitudes for unit flexural wave.

        For a mode the factor is 1, or -1 if its number of nodal lines is odd.
        """
        sign = (-1) ** nodal_lines
        plain = width - 2 * self.setback
        passed = sign * self.reflection * np.exp(1j * self.plate.wavenumber * plain)
        k = self.flexural
        rest = np.delete(np.arange(len(self.plate)), k)
        inner = np.eye(len(rest)) - passed[np.ix_(rest, rest)]
        others = la.solve(inner, passed[rest, k])
        return sign * complex(passed[k, k] + passed[k, rest] @ others), others


@dataclass(frozen=True)
class GuidedMode:
    """Mode of a strip.

    omega : rad/s; wavenumber : along the strip, rad/m; width : m; nodal_lines : across
    position : (s,) from the middle, m; amplitude : (s,) of w on the flat face, its peak 1
    at_edge : amplitude at the edge of the lattice, as a share of that peak
    """

    omega: float
    wavenumber: float
    width: float
    nodal_lines: int
    position: Array
    amplitude: Array
    at_edge: float


@dataclass(frozen=True)
class Guide:
    """Strip of plain plate between two half-infinite lattices that are mirror images of each other.

    interface : its right edge, at the wavenumber along the strip
    """

    interface: Interface

    @classmethod
    def of(cls, rows: CondensedRows, wavenumber: float) -> Guide:
        """Make a guide for waves of a wavenumber (rad/m) along rows."""
        return cls(Interface.of(rows, wavenumber))

    def width(self, omega: float, nodal_lines: int) -> float:
        """Width (m) of the strip that has a mode at omega (rad/s) with a number of nodal lines across.

        Raises
        ------
        StudyError : other waves propagate across the strip, or no strip guides such a mode
        """
        wall, target = self.wall(omega), (nodal_lines + 1) * np.pi
        root = None
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

    def mode_at(self, omega: float, nodal_lines: int) -> GuidedMode:
        """Mode at omega (rad/s) of the strip with the `width` for this mode."""
        width, wall = self.width(omega, nodal_lines), self.wall(omega)
        assert wall is not None, "a width was found only with a wall"
        along = float(self.interface.tangential[0])
        return _guided_mode(wall, omega, along, width, nodal_lines)

    def mode(self, width: float, nodal_lines: int, between: tuple[float, float]) -> GuidedMode:
        """Mode with a number of nodal lines across, and an angular frequency within an interval.

        Raises
        ------
        StudyError : other waves propagate across the strip, or it guides no such mode within the interval
        """
        return _mode(lambda _: self, width, nodal_lines, between)

    def wall(self, omega: float) -> Wall | None:
        """Wall at the right edge of the strip; None below the cut-off of the flexural wave.

        Raises
        ------
        StudyError : other waves propagate across the strip
        """
        wall = Wall.of(self.interface, omega)
        if wall is not None and wall.plate.waves.propagates.sum() > 1:
            raise StudyError.no_answer(
                argument="waveguide.mode",
                given=f"{self.interface.tangential[0]:.4g} rad/m at {_kilohertz(omega)}",
                allowed=f"a wavenumber at which only {LEAD} propagates across the strip",
                cause="waves so long along the strip also excite in-plane waves or diffracted waves",
                next_step="use another number of intervals along the strip, or a lower frequency",
            )
        return wall


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
) -> GuidedMode:
    """Mode of a strip of finite length with a number of intervals between nodal lines along it.

    Parameters
    ----------
    rows : on both sides of the strip; width, length : of the strip, m
    intervals, nodal_lines : along and across the strip
    between : range of angular frequencies, rad/s
    closed_by : see `along_strip`

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
        return Guide.of(rows, along_strip(omega, length, intervals, closed_by))

    if closed_by is None:
        return guide_at(between[0]).mode(width, nodal_lines, between)
    return _mode(guide_at, width, nodal_lines, between)


def _mode(
    guide_at: Callable[[float], Guide], width: float, nodal_lines: int, between: tuple[float, float]
) -> GuidedMode:
    """Mode of a strip whose wavenumber along it may depend on the angular frequency."""

    def misfit(omega: float) -> float:
        wall = guide_at(omega).wall(omega)
        return (wall.phase(width, nodal_lines) if wall else 0.0) - (nodal_lines + 1) * np.pi

    try:
        omega = _root(misfit, *between)
    except StudyError:  # other waves propagate at the upper end
        between = _with_one_wave(guide_at, between)
        omega = _root(misfit, *between)
    if omega is not None:
        guide = guide_at(omega)
        wall = guide.wall(omega)
        if wall is not None and wall.closed:
            along = float(guide.interface.tangential[0])
            return _guided_mode(wall, omega, along, width, nodal_lines)
    raise _no_mode(nodal_lines, f"{_kilohertz(between[0])} to {_kilohertz(between[1])}")


def _with_one_wave(guide_at: Callable[[float], Guide], between: tuple[float, float]) -> tuple[float, float]:
    """The lower part of an interval of angular frequencies, in which one wave propagates across the strip.

    In-plane and diffracted waves propagate above a frequency of their own.

    Raises
    ------
    StudyError : other waves propagate already at the lower end
    """
    low, high = between
    guide_at(low).wall(low)
    top = high
    while high - low > WITHIN * between[1]:
        try:
            guide_at(top).wall(top)
            low = top
        except StudyError:
            high = top
        top = 0.5 * (low + high)
    return between[0], low


def _guided_mode(wall: Wall, omega: float, along: float, width: float, nodal_lines: int) -> GuidedMode:
    position, amplitude, at_edge = wall.across(width, nodal_lines)
    return GuidedMode(
        omega=omega, wavenumber=along, width=width, nodal_lines=nodal_lines, position=position,
        amplitude=amplitude, at_edge=at_edge,
    )  # fmt: skip


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
