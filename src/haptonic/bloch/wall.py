"""A lattice as a boundary of a plain plate, and its equivalent fixed line.

Within the gap, the lattice reflects flexural waves like a support at a line behind the interface. With
pillars on both faces, flexural waves are not coupled to waves that are symmetric about the middle plane of
the plate.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from haptonic.arrays import Array, Complex, Ints
from haptonic.bloch.evanescent import symmetric
from haptonic.bloch.layers import Interface
from haptonic.bloch.plate_waves import PlateWaves
from haptonic.later import linalg as la

LEAD = "A0"  # the wave that is guided
SAMPLES = 401  # positions of a mode across the strip


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
