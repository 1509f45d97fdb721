"""The long way round for plates: whole matrices of an assembly, dense, with all losses in them."""

from functools import lru_cache

import numpy as np

from haptonic.plate.body.model import PlateModel
from haptonic.plate.layout.keys import PLATE, bond, ceramic, electric


def placed(size, form, unknowns, total):
    """Add a form of one tile; unknowns that are held, which have the number ``size``, drop out."""
    free = unknowns < size
    total[np.ix_(unknowns[free], unknowns[free])] += form[np.ix_(free, free)]


@lru_cache(maxsize=2)  # for every frequency of an answer
def forms(assembly):
    """Stiffness by part and mass, (size, size), without supports; callers must not change them."""
    size = assembly.size
    stiffness, mass = {}, np.zeros((size, size))
    for group in assembly.groups:
        for unknowns in group.unknowns:
            placed(size, group.tile.mass, unknowns, mass)
            for part, form in group.tile.stiffness.items():
                placed(size, form, unknowns, stiffness.setdefault(part, np.zeros((size, size))))
    return stiffness, mass


def foundations(model: PlateModel):
    """(size, size) of every support."""
    matrices = []
    for foundation in model.foundations:
        matrices.append(np.zeros((model.assembly.size,) * 2))
        matrices[-1][: model.assembly.free, : model.assembly.free] = foundation.stiffness.toarray()
    return matrices


def lossless(model: PlateModel):
    """Stiffness, supports included, and mass."""
    stiffness, mass = forms(model.assembly)
    return sum(stiffness.values()) + sum(foundations(model)), mass


def finger_impedance(finger, omega):
    """Force over displacement of a mass behind a spring and a damper, from its two equations of motion."""
    spring = finger.stiffness + 1j * omega * finger.damping
    if finger.mass is None:
        return spring
    behind = spring / (spring - omega**2 * finger.mass)  # displacement of the mass over that of the pad
    return spring * (1 - behind)


def dynamic(model: PlateModel, omega):
    """(size, size) complex dynamic stiffness with every loss and the finger."""
    plate, parts = model.plate, forms(model.assembly)
    stiffness, mass = parts
    total = (1 + 1j * plate.loss_factor) * stiffness[PLATE] - omega**2 * mass
    for actuator in plate.actuators:
        solid, name = actuator.material, actuator.name
        total = total + (1 + 1j * solid.loss_factor) * stiffness[ceramic(name)]
        total += stiffness[electric(name)] / (1 - 1j * solid.clamped_loss)
        if actuator.bond is not None:
            total += (1 + 1j * actuator.bond.material.loss_factor) * stiffness[bond(name)]
    for support, foundation in zip(
        [support for support in plate.supports if support.hold == "spring" or support.where == "corners"],
        foundations(model),
        strict=True,
    ):
        total += (1 + 1j * support.loss_factor) * foundation
    if plate.finger is not None:
        pad = model.pad.toarray()
        total += finger_impedance(plate.finger, omega) / len(pad) * pad.T @ pad
    return total


def answered(model: PlateModel, drives, omegas):
    """(size, n) answers to drives of given amplitudes, each by one dense solution."""
    return _answered(model, tuple(drives.items()), tuple(omegas))


@lru_cache(maxsize=4)
def _answered(model, drives, omegas):
    load = sum(amplitude * model.drives[name] for name, amplitude in drives)
    return np.stack([np.linalg.solve(dynamic(model, omega), load) for omega in omegas], axis=-1)


def energy(model: PlateModel, fields, omegas):
    """(n,) squares of the energy norm u* (K + omega^2 M) u of fields (size, n)."""
    K, M = lossless(model)
    stiff = np.einsum("in,in->n", fields.conj(), K @ fields).real
    return stiff + omegas**2 * np.einsum("in,in->n", fields.conj(), M @ fields).real
