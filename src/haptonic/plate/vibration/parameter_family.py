"""Plates on a small basis for a range of parameters, with solutions in milliseconds.

The dynamic stiffness is a sum of constant forms with weights that depend on parameters p,

    A(omega, p) = sum_j w_j(p) K_j - omega^2 sum_j v_j(p) M_j:

Young's modulus, loss factors, springs, and three forms for each bond. A basis V that contains the
solutions for some sets of parameters nearly contains those in between (reduced basis method; Rozza, Huynh and
Patera 2008, doi 10.1007/s11831-008-9019-9), and V^T A V follows from the small matrices V^T K_j V.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array, Complex
from haptonic.later import linalg as la
from haptonic.plate.body.bonds import Bond3
from haptonic.plate.body.model import PlateModel
from haptonic.plate.body.parameter_update import bond_thickness, stiffness_ratio, support_ratio, updated
from haptonic.plate.body.tile import applied
from haptonic.plate.body.unreduced import loss_factors
from haptonic.plate.layout.keys import PLATE, PartKey, bond, support
from haptonic.plate.layout.parts import Plate
from haptonic.plate.vibration.damping import real_times
from haptonic.plate.vibration.sweep import Band

MISSED = 1e-4  # largest share of the energy norm of a solution outside the basis


@dataclass(frozen=True, eq=False)
class Poles:
    """Modes of a damped plate on a basis; modes above the band represent the static stiffness.

    square : (r,) complex squares of angular frequencies, (rad/s)^2
    force : (r,) of the drives; shapes : (points, r) normal displacement
    """

    square: Complex
    force: Complex
    shapes: Complex

    def displacement(self, omega: Array) -> Complex:
        """(lines, points) displacement under the drives at angular frequencies, rad/s, m."""
        return np.asarray((self.force / (self.square - omega[:, None] ** 2)) @ self.shapes.T)


@dataclass(frozen=True, eq=False)
class Anchor:
    """Solutions for one set of parameters, within the requested tolerance.

    parts : (size, k) main fields of these, in the unknowns of the family's model
    displacement : (lines, points) normal, m
    """

    parts: Array
    displacement: Complex


@dataclass(frozen=True, eq=False)
class Family:
    """Forms of a plate on a basis.

    plate : with the parameters of the forms
    forms : stiffness by part and support, (r, r), but that of the bonds; bonds : by actuator; mass : (r, r)
    loads : (r,) of the drives; seen : (points, r) normal displacement
    """

    plate: Plate
    forms: Mapping[PartKey, Array]
    bonds: Mapping[str, Bond3]
    mass: Array
    loads: Complex
    seen: Array

    @classmethod
    def spanned(
        cls, model: PlateModel, anchors: Sequence[Anchor], drives: Mapping[str, complex], points: Array
    ) -> Family:
        """Make the family of a model on the span of its solutions for some sets of parameters.

        Parameters
        ----------
        model : without a finger, whose forces depend on frequency
        drives : complex amplitudes by name, V or N; points : (points, 2) of the flat face, m
        """
        assert model.plate.finger is None
        basis = _main_parts(model, np.hstack([anchor.parts for anchor in anchors]))
        values, turn = la.eigh(basis.T @ model.assembly.mass_times(basis))
        basis = basis @ (turn / np.sqrt(values))
        count = basis.shape[1]
        forms: dict[PartKey, Array] = {}
        bonds, mass = {}, np.zeros((count, count))
        for group, share in model.assembly.shares(basis):
            tile, flat = group.tile, share.reshape(-1, count)

            def on_basis(form: Array, share: Array = share, flat: Array = flat) -> Array:
                return np.asarray(flat.T @ applied(form, share).reshape(flat.shape))

            mass += on_basis(tile.mass)
            for part, form in tile.stiffness.items():
                forms[part] = forms.get(part, np.zeros_like(mass)) + on_basis(form)
            for name, glue in tile.bonds.items():
                thirds = np.stack([on_basis(form) for form in glue.stiffness])
                bonds[name] = Bond3(glue.thickness, thirds, glue.nominal, on_basis(glue.slope))
        on_skeleton = basis[: model.assembly.free]
        for foundation in model.foundations:
            forms[support(foundation.number)] = on_skeleton.T @ (foundation.stiffness @ on_skeleton)
        for name in bonds:
            del forms[bond(name)]
        return cls(
            plate=model.plate, forms=forms, bonds=bonds, mass=mass, loads=basis.T @ model.load(drives),
            seen=model.displaced(points, basis),
        )  # fmt: skip

    def poles(self, plate: Plate) -> Poles:
        """Compute modes for other parameters; see `haptonic.plate.body.parameter_update`."""
        thickness, factors = bond_thickness(plate), loss_factors(plate)
        factors[PLATE] *= stiffness_ratio(self.plate, plate)
        for number, spring in enumerate(plate.supports):
            ratio = support_ratio(self.plate, plate, number)
            factors[support(number)] = ratio * (1 + 1j * spring.loss_factor)
        stiffness = np.asarray(sum(factors[part] * form for part, form in self.forms.items()))
        mass = self.mass.copy()
        for name, glue in self.bonds.items():
            shares = glue.shares(thickness[name])
            stiffness = stiffness + factors[bond(name)] * np.tensordot(shares, glue.stiffness, 1)
            mass += (thickness[name] - glue.nominal) * glue.slope
        lower = la.cholesky(mass, lower=True)
        half = la.solve_triangular(lower, stiffness, lower=True)
        square, modes = la.eig(la.solve_triangular(lower, half.T, lower=True))
        force = la.solve(modes, la.solve_triangular(lower, self.loads, lower=True))
        shapes = la.solve_triangular(lower, modes, lower=True, trans=1)
        return Poles(square, force, self.seen @ shapes)


def anchored(
    model: PlateModel,
    plate: Plate,
    drives: Mapping[str, complex],
    frequencies: Array,
    tolerance: float,
    points: Array,
) -> Anchor:
    """Compute the solutions of a plate with other parameters on the tiles of a model.

    Parameters
    ----------
    frequencies : (lines,) Hz; tolerance : field error of every line
    points : (points, 2) of the flat face, m

    Raises
    ------
    HaptonicError : lines that stay above the tolerance
    """
    other = updated(model, plate)
    # from 0, because a band that begins higher may need a new basis
    band = Band.of(other.model, 0.0, float(frequencies[-1]))
    _, vibration = band.answer(drives, frequencies, tolerance)
    amplitudes = vibration.amplitudes
    seen = real_times(other.model.displaced(points, vibration.vectors), amplitudes).T
    fields = other.back(vibration.vectors @ np.hstack([amplitudes.real, amplitudes.imag]))
    size = np.sqrt(np.diag(_products(model, fields)))
    return Anchor(_main_parts(model, fields / size), seen)


def _products(model: PlateModel, fields: Array) -> Array:
    """(k, k) products of fields (size, k) in the energy norm."""
    assembly, omega = model.assembly, 2 * np.pi * model.highest
    heavy = assembly.stiffness_times(fields) + omega**2 * assembly.mass_times(fields)
    return np.asarray(fields.T @ heavy)


def _main_parts(model: PlateModel, fields: Array) -> Array:
    """(size, r) smallest set of fields that nearly spans given ones, the largest first."""
    weights, turn = la.eigh(_products(model, fields))
    return np.asarray(fields @ turn[:, weights > MISSED**2][:, ::-1])
