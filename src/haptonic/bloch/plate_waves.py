"""Waves of a plain infinite plate: polynomials through the thickness, exact in the plane.

This is the semi-analytic finite-element method (Bartoli et al. 2006, J. Sound Vib. 295, 685) with a single
element through the thickness, on the levels of a superelement's trace, so that plate and lattice have
equal unknowns on common faces. The material may be anisotropic. Axis "normal" runs from face to face of a
lattice, axis "tangential" along the faces.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial.legendre import leggauss

from haptonic.arrays import Array, Bools, Complex, Ints
from haptonic.bloch.evanescent import ON_CIRCLE, Waves, directed, symmetric
from haptonic.cell import UnitCell
from haptonic.cell.quadrature import interpolation, lobatto
from haptonic.later import linalg as la
from haptonic.materials import elasticity_tensor

FAMILIES = ("A0", "S0", "SH0")  # waves without a cut-off frequency
HIGHER, EVANESCENT = "higher", "evanescent"


@dataclass(frozen=True)
class PlateWaves:
    """Waves of a plate to one side, by harmonic.

    waves : displacement and force have rows (harmonic, level, component)
    wavenumber : (w,) complex, along the normal, rad/m; harmonic : (w,) number of the tangential wavenumber
    label : (w,) one of `FAMILIES`, or "higher", or "evanescent"
    """

    waves: Waves
    wavenumber: Complex
    harmonic: Ints
    label: tuple[str, ...]

    def __len__(self) -> int:
        return len(self.label)

    def labelled(self, name: str) -> Bools:
        """(w,) True for waves with a label."""
        return np.array([label == name for label in self.label])

    def chosen(self, own: Bools) -> PlateWaves:
        """Select waves; ``own`` (w,) True for these."""
        label = tuple(np.array(self.label)[own].tolist())
        members = np.flatnonzero(own)
        return PlateWaves(self.waves.chosen(members), self.wavenumber[own], self.harmonic[own], label)

    def mirrored(self, normal: Array) -> PlateWaves:
        """Images of the waves in a mirror across an axis (2,): waves to the other side."""
        mirror = mirror_across(normal)

        def image_of(rows: Complex) -> Complex:
            return np.asarray(mirror @ rows.reshape(-1, 3, len(self))).reshape(rows.shape)

        image = replace(
            self.waves,
            exponent=-self.waves.exponent,
            displacement=image_of(self.waves.displacement),
            force=-image_of(self.waves.force),
        )
        return replace(self, waves=image, wavenumber=-self.wavenumber)


def mirror_across(normal: Array) -> Array:
    """(3, 3) mirror that reverses a direction (2,) in the plane of the plate."""
    mirror = np.eye(3)
    mirror[:2, :2] -= 2 * np.outer(normal, normal)
    return mirror


@dataclass(frozen=True)
class PlainPlate:
    """Forms on the unknowns (level, component) of a plate, per area.

    With displacement ``U exp(i (k_0 x_normal + k_1 x_tangential))`` the dynamic stiffness is
    ``k_a k_b gradient_ab + i k_a (crossed_a^T - crossed_a) + still - omega^2 mass``.

    axes : (2, 2) normal direction of propagation, and tangential direction, in the plane of the plate
    gradient : (2, 2, q, q); crossed : (2, q, q) between slopes through the thickness and gradients
    still : (q, q); mass : (q, q)
    """

    thickness: float
    axes: Array
    gradient: Array
    crossed: Array
    still: Array
    mass: Array

    @classmethod
    def of(cls, cell: UnitCell, levels: int, axes: Array | None = None) -> PlainPlate:
        """Make the plate of a cell without its pillar, with the levels of a trace; by default along x."""
        axes = np.eye(2) if axes is None else axes
        points, _, derivative = lobatto(levels - 1)
        at, weight = leggauss(levels)
        value = interpolation(points, at)
        slope = value @ derivative
        half = 0.5 * cell.thickness
        overlap: Array = half * (value.T * weight) @ value
        bending: Array = (slope.T * weight) @ slope / half
        tensor = elasticity_tensor(cell.material.stiffness)
        stretched = np.einsum("ai,bj,cidj->abcd", axes, axes, tensor[:, :2, :, :2])
        sheared = np.einsum("ai,cid->acd", axes, tensor[:, :2, :, 2])
        return cls(
            thickness=cell.thickness,
            axes=axes,
            gradient=np.array([[np.kron(overlap, block) for block in row] for row in stretched]),
            crossed=np.array([np.kron((value.T * weight) @ slope, block) for block in sheared]),
            still=np.asarray(np.kron(bending, tensor[:, 2, :, 2]), dtype=float),
            mass=np.asarray(cell.material.density * np.kron(overlap, np.eye(3)), dtype=float),
        )

    def wavenumber(self, omega: float, angle: float, family: str) -> float | None:
        """Wavenumber (rad/m) of a family at an angle (rad) to the normal; None if it does not propagate."""
        along = np.array([np.cos(angle), np.sin(angle)])
        k, profiles = self._solutions(omega, along, np.zeros(2))
        real = np.abs(k.imag) * self.thickness < ON_CIRCLE
        labels = self._labels(k[:, None] * along, profiles, real & (k.real > 0))
        return float(k[labels.index(family)].real) if family in labels else None

    def waves(self, omega: float, tangential: Array, length: float) -> tuple[PlateWaves, PlateWaves]:
        """Waves at a frequency (rad/s) to the right and to the left.

        Parameters
        ----------
        tangential : (harmonics,) wavenumbers along the faces, rad/m
        length : of the part of a face whose forces are summed, one period, m
        """
        pairs = [self._harmonic(omega, number, float(k_t), length) for number, k_t in enumerate(tangential)]
        return _gathered([right for right, _ in pairs]), _gathered([left for _, left in pairs])

    def _harmonic(
        self, omega: float, number: int, k_t: float, length: float
    ) -> tuple[PlateWaves, PlateWaves]:
        """Waves to the right and to the left with one tangential wavenumber."""
        k, profiles = self._solutions(omega, np.array([1.0, 0.0]), np.array([0.0, k_t]))
        # resultants of the stress on planes across the normal, of the part left of it on the part right
        in_plane = (self.gradient[0, 0] @ profiles) * k + self.gradient[0, 1] @ profiles * k_t
        force = -length * (1j * in_plane + self.crossed[0] @ profiles)

        def named(waves: Waves) -> PlateWaves:
            k_n = waves.exponent / (1j * self.thickness)
            vectors = np.stack([k_n, np.full(len(k_n), k_t)], axis=1)
            labels = self._labels(vectors, waves.displacement, waves.propagates)
            return PlateWaves(waves, k_n, np.full(len(k_n), number), labels)

        right, left = directed(1j * k * self.thickness, profiles, force, omega)
        return named(right), named(left)

    def _solutions(self, omega: float, along: Array, offset: Array) -> tuple[Complex, Complex]:
        """Wavenumbers (2q,) and profiles (q, 2q) of all waves with wavevectors ``offset + k along``."""
        turning = 1j * (self.crossed.swapaxes(1, 2) - self.crossed)
        quadratic = np.einsum("a,b,abij->ij", along, along, self.gradient)
        mixed = np.einsum("a,b,abij->ij", along, offset, self.gradient)
        linear = mixed + mixed.T + np.tensordot(along, turning, axes=1)
        constant = np.einsum("a,b,abij->ij", offset, offset, self.gradient)
        constant = constant + np.tensordot(offset, turning, axes=1) + self.still - omega**2 * self.mass
        q, h = len(self.mass), self.thickness
        companion = np.zeros((2 * q, 2 * q), dtype=complex)
        companion[:q, q:] = np.eye(q)
        companion[q:] = -la.solve(quadratic, np.hstack([h**2 * constant, h * linear]), assume_a="pos")
        scaled, fields = la.eig(companion, check_finite=False)
        return scaled / h, fields[:q]

    def _labels(self, wavevectors: Complex, profiles: Complex, propagates: Bools) -> tuple[str, ...]:
        """Families by symmetry about the mid-plane and polarisation; each is the slowest of its kind."""
        field = profiles.reshape(-1, 3, profiles.shape[1])
        even = symmetric(field)
        in_plane = np.einsum("ai,liw->law", self.axes, field[:, :2])
        along = np.linalg.norm(np.einsum("lcw,wc->lw", in_plane, wavevectors), axis=0)
        crossing = wavevectors[:, ::-1] * np.array([-1.0, 1.0])
        across = np.linalg.norm(np.einsum("lcw,wc->lw", in_plane, crossing), axis=0)
        kinds = {"A0": ~even, "S0": even & (along > across), "SH0": even & (along <= across)}
        length = np.linalg.norm(wavevectors, axis=1)
        labels = np.where(propagates, HIGHER, EVANESCENT)
        for name, kind in kinds.items():
            members = np.flatnonzero(kind & propagates)
            if len(members):
                labels[members[np.argmax(length[members])]] = name
        return tuple(labels.tolist())


def _gathered(harmonics: list[PlateWaves]) -> PlateWaves:
    """Join the waves of all harmonics."""
    sets = [of_harmonic.waves for of_harmonic in harmonics]
    return PlateWaves(
        waves=Waves(
            exponent=np.concatenate([waves.exponent for waves in sets]),
            displacement=la.block_diag(*(waves.displacement for waves in sets)),
            force=la.block_diag(*(waves.force for waves in sets)),
            propagates=np.concatenate([waves.propagates for waves in sets]),
        ),
        wavenumber=np.concatenate([of_harmonic.wavenumber for of_harmonic in harmonics]),
        harmonic=np.concatenate([of_harmonic.harmonic for of_harmonic in harmonics]),
        label=tuple(label for of_harmonic in harmonics for label in of_harmonic.label),
    )
