"""Layers of cells between two half-infinite plain plates: reflection, transmission, conversion and losses.

Plate and lattice have the same thickness and material and are periodic along their common faces. The motion
of a face is restricted to tangential harmonics times the polynomials of the trace, and the forces of the
lattice are projected onto these motions, so energy is conserved for any truncation.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array, Complex, Ints
from haptonic.bloch.evanescent import FaceStiffness, Slab, Waves, bloch_waves
from haptonic.bloch.plate_waves import FAMILIES, HIGHER, PlainPlate, PlateWaves
from haptonic.bloch.rows import CondensedRows
from haptonic.errors import StudyError
from haptonic.later import linalg as la
from haptonic.units import hz_text

OUTGOING = (*FAMILIES, HIGHER)  # kinds of waves that carry energy away


def stacked(
    layer: FaceStiffness,
    count: int,
    parts: Sequence[FaceStiffness] = (),
    before: FaceStiffness | None = None,
) -> Iterator[FaceStiffness]:
    """Stack one layer, two layers, ... up to ``count`` by Schur complements of constant size.

    If a ``layer`` consists of several rows, ``parts`` have one, two, ... rows. ``before`` is an optional part
    on their left.
    """
    blocks, whole = (*parts, layer), before
    for number in range(count):
        block = blocks[number % len(blocks)]
        stack = block if whole is None else whole.followed_by(block)
        whole = stack if block is layer else whole
        yield stack


def scattered(
    slab: FaceStiffness, incoming: Waves, reflected: Waves, transmitted: Waves
) -> tuple[Complex, Complex]:
    """Amplitudes (n, i) of reflected and of transmitted waves for each incoming one of unit amplitude.

    The half-space on the left has waves to the right (``incoming``, i of them) and to the left
    (``reflected``), the one on the right has waves to the right (``transmitted``); all on the slab's n face
    unknowns. Motion and force are continuous at both faces of the slab of dynamic stiffness D:

        D [ u_in + u_r r ]   [  f_in + f_r r ]
          [ u_t t        ] = [ -f_t t        ]
    """
    back, ahead = reflected.displacement, transmitted.displacement
    answer = np.block([
        [slab.LL @ back - reflected.force, slab.LR @ ahead],
        [slab.RL @ back, slab.RR @ ahead + transmitted.force],
    ])  # fmt: skip
    drive = np.vstack([slab.LL @ incoming.displacement - incoming.force, slab.RL @ incoming.displacement])
    r, t = np.split(la.solve(answer, -drive), [len(reflected)])
    return r, t


def reflected_by(impedance: Complex, incoming: Waves, reflected: Waves) -> Complex:
    """(n, i) amplitudes r reflected by a half-space of given impedance Z (n, n), see `Waves.impedance`.

    Motion and force are continuous at its face: ``Z (u_in + u_r r) = f_in + f_r r``.
    """
    answer = impedance @ reflected.displacement - reflected.force
    return np.asarray(la.solve(answer, incoming.force - impedance @ incoming.displacement))


@dataclass(frozen=True)
class Scattering:
    """Reflected and transmitted energy as shares of the incident energy.

    incident : (i,) families of incident waves
    layers : (N,) numbers of layers
    reflected, transmitted : (N, i, 4) for the kinds of `OUTGOING`
    """

    incident: tuple[str, ...]
    layers: Ints
    reflected: Array
    transmitted: Array

    @property
    def dissipated(self) -> Array:
        """(N, i) share of energy dissipated in the layers."""
        return np.asarray(1 - self.reflected.sum(axis=-1) - self.transmitted.sum(axis=-1))

    @property
    def insulation(self) -> Array:
        """(N, i) insertion loss for waves of all kinds, dB."""
        return np.asarray(-10 * np.log10(self.transmitted.sum(axis=-1)))

    def of(self, family: str) -> Scattering:
        """Select one incident wave."""
        numbers = [self.incident.index(family)]
        return Scattering((family,), self.layers, self.reflected[:, numbers], self.transmitted[:, numbers])


@dataclass(frozen=True)
class Interface:
    """Line between a lattice and a plain plate, at a fixed tangential wavenumber.

    slab : rows of the lattice; parts : slabs with 1, 2, ... rows and plain plate instead of the others
    ends : plain plate before and behind the slab, if the faces of the rows are not plane
    plate : the plain plate
    tangential : (h,) wavenumbers of the harmonics, the given one first, rad/m; an odd number, at most the
        number of places of the line
    period : along the line, m
    setback : distance from the line to the average position of the rows' face, m
    trace : (n, p) motion of the line for each unknown (harmonic, level, component) of the plate
    on_face : (h, s) harmonics, by least squares, of values at the places of the rows' face
    mirrored : True if the plate's middle plane is a mirror of lattice and plate
    """

    slab: Slab
    parts: tuple[Slab, ...]
    ends: tuple[Slab, ...]
    plate: PlainPlate
    tangential: Array
    period: float
    setback: float
    trace: Complex
    on_face: Complex
    mirrored: bool

    @classmethod
    def of(cls, rows: CondensedRows, wavenumber: float) -> Interface:
        """Make the interface along rows, at a tangential wavenumber (rad/m).

        Raises
        ------
        StudyError : waves too short for the places of a face
        """
        period = rows.rows.period
        *parts, slab = rows.slabs(wavenumber * period)
        ends = rows.ends(wavenumber * period)
        position = (rows.line - rows.line[0]) @ rows.rows.turn[1]
        reach = (rows.harmonics - 1) // 2
        zone = round(wavenumber * period / (2 * np.pi))
        if abs(zone) > reach:
            raise _too_short(wavenumber, (2 * reach + 1) * np.pi / period)
        orders = np.arange(-reach, reach + 1) - zone
        orders = orders[np.argsort(np.abs(orders), kind="stable")]
        tangential = np.asarray(wavenumber + 2 * np.pi / period * orders, dtype=float)
        turning = np.exp(1j * np.outer(position, tangential))
        trace = np.einsum("pm,lj,cd->lpcmjd", turning, np.eye(rows.levels), np.eye(3))
        trace = trace.reshape(slab.size, -1)
        along = (rows.face - rows.line[0]) @ rows.rows.turn[1]
        return cls(
            slab=slab,
            parts=tuple(parts),
            ends=ends,
            plate=plain_plate(rows),
            tangential=tangential,
            period=period,
            setback=rows.setback,
            trace=trace,
            on_face=la.pinv(np.exp(1j * np.outer(along, tangential))),
            mirrored=rows.rows.cell.is_mirrored,
        )

    @classmethod
    def met_by(cls, rows: CondensedRows, omega: float, family: str, angle: float) -> Interface:
        """Make the interface for an incident wave at an angle (rad) from the normal, at omega (rad/s).

        Raises
        ------
        StudyError : the angle is not below 90 degrees, or the wave does not propagate
        """
        if not abs(angle) < 0.5 * np.pi:
            raise StudyError.out_of_range(
                argument="layers.angle",
                given=f"{np.degrees(angle):g} deg",
                allowed="more than -90 and less than 90 deg from the normal",
                cause="such a wave does not travel towards the layers",
                next_step="give a smaller angle",
            )
        k = plain_plate(rows).wavenumber(omega, angle, family)
        if k is None:
            raise _no_such_wave(family, omega)
        # with exp(+i omega t), a wave that runs in a direction has the opposite wavevector
        return cls.of(rows, -k * np.sin(angle))

    def plate_waves(self, omega: float) -> tuple[PlateWaves, PlateWaves]:
        """Waves of the plate to the right and to the left, on its unknowns."""
        return self.plate.waves(omega, self.tangential, self.period)

    def incoming(self, omega: float) -> tuple[str, ...]:
        """Families of the plate's waves that propagate with the wavenumber of the interface."""
        right, _ = self.plate_waves(omega)
        return tuple(name for name in FAMILIES if (right.labelled(name) & (right.harmonic == 0)).any())

    def scattering(
        self, omega: float, layers: int, incident: tuple[str, ...], loss_factor: float = 0.0
    ) -> Scattering:
        """Reflected and transmitted energy for 1, 2, ... ``layers`` layers between two plates without losses.

        Parameters
        ----------
        omega : rad/s; incident : families that arrive from the left, one at a time
        loss_factor : of the layers

        Raises
        ------
        StudyError : no layers, or an incident wave that does not propagate with this tangential wavenumber
        """
        if layers < 1:
            raise StudyError.out_of_range(
                argument="layers.count",
                given=layers,
                allowed="at least 1",
                cause="without layers there is nothing to scatter a wave",
                next_step="set one layer or more",
            )
        right, left = self.plate_waves(omega)
        chosen = np.array([self._number(right, family, omega) for family in incident])
        incoming = right.waves.chosen(chosen)
        lattice, *parts = (slab.at(omega, loss_factor) for slab in (self.slab, *self.parts))
        ends = [end.at(omega) for end in self.ends]
        shares = np.array([
            [_shares(r, left), _shares(t, right)]
            for rows in stacked(lattice, layers, parts, ends[0] if ends else None)
            for whole in [rows.followed_by(ends[1]) if ends else rows]
            for r, t in [scattered(whole.projected(self.trace), incoming, left.waves, right.waves)]
        ])  # fmt: skip
        return Scattering(incident, np.arange(1, layers + 1), shares[:, 0], shares[:, 1])

    def mirror(self, omega: float, loss_factor: float = 0.0) -> HalfSpace:
        """The half-infinite lattice on the right of the interface."""
        lattice, _ = bloch_waves(self.slab.at(omega, loss_factor), omega)
        impedance, motion = lattice.impedance(), self.trace
        if self.ends:
            before = self.ends[0].at(omega)
            follows = -la.solve(before.RR + impedance, before.RL)
            impedance, motion = before.LL + before.LR @ follows, follows @ motion
        impedance = self.trace.conj().T @ impedance @ self.trace
        return HalfSpace(*self.plate_waves(omega), lattice, impedance, motion)

    def _number(self, right: PlateWaves, family: str, omega: float) -> int:
        """Number of the wave of a family with the wavenumber of the interface."""
        numbers = np.flatnonzero(right.labelled(family) & (right.harmonic == 0))
        if not len(numbers):
            raise _no_such_wave(family, omega)
        return int(numbers[0])


@dataclass(frozen=True)
class HalfSpace:
    """Half-infinite lattice behind a plain plate, at one frequency and tangential wavenumber.

    incoming, outgoing : waves of the plate to the right and to the left, p of each
    lattice : the n waves of the lattice to the right
    impedance : (p, p) force per displacement for the unknowns of the plate
    motion : (n, p) motion of the lattice's face for these unknowns
    """

    incoming: PlateWaves
    outgoing: PlateWaves
    lattice: Waves
    impedance: Complex
    motion: Complex

    def reflection(self) -> Complex:
        """(p, p) amplitudes of outgoing waves for unit incoming ones, evanescent waves included."""
        return reflected_by(self.impedance, self.incoming.waves, self.outgoing.waves)

    def transmission(self, reflection: Complex) -> Complex:
        """(n, p) amplitudes of the lattice's waves for a given reflection."""
        motion = self.incoming.waves.displacement + self.outgoing.waves.displacement @ reflection
        return np.asarray(la.solve(self.lattice.displacement, self.motion @ motion))


def plain_plate(rows: CondensedRows) -> PlainPlate:
    """Plain plate before and behind rows, with axes across and along them."""
    return PlainPlate.of(rows.rows.cell, rows.levels, rows.rows.turn)


def _shares(amplitudes: Complex, waves: PlateWaves) -> Array:
    """(i, 4) energies of outgoing waves (w, i), by kind."""
    energy = np.abs(amplitudes) ** 2
    return np.stack([energy[waves.labelled(kind)].sum(axis=0) for kind in OUTGOING], axis=-1)


def _too_short(wavenumber: float, highest: float) -> StudyError:
    return StudyError.out_of_range(
        argument="layers.angle",
        given=f"{wavenumber:.4g} rad/m along the layers",
        allowed=f"at most {highest:.4g} rad/m with this mesh",
        cause="the incident wave is too short for the spacing of nodes on a face",
        next_step="use a finer mesh, a lower frequency or a smaller angle",
    )


def _no_such_wave(family: str, omega: float) -> StudyError:
    return StudyError.no_answer(
        argument="layers.incident",
        given=f"{family} at {hz_text(omega / (2 * np.pi))}",
        allowed=f"one of {', '.join(FAMILIES)} that propagates towards the layers",
        cause="with this tangential wavenumber the wave is evanescent, or no wave has that name",
        next_step="use a smaller angle or a higher frequency",
    )
