"""Waves of a plain plate against the exact equations of Rayleigh and Lamb, and against partial waves."""

from types import SimpleNamespace

import numpy as np
import pytest
import scipy.linalg as la
from hypothesis import given, settings, strategies as st
from scipy.optimize import brentq
from strategies import ALUMINIUM, reference_cell

from haptonic.bloch.evanescent import energy_flux
from haptonic.bloch.plate_waves import EVANESCENT, FAMILIES, HIGHER, PlainPlate
from haptonic.materials import elasticity_tensor

KILOHERTZ = 2e3 * np.pi
THICKNESS = reference_cell().thickness
LEVELS = 12
PLATE = PlainPlate.of(reference_cell(), LEVELS)
LENGTH = 7e-3


def lamb(k: complex, omega: float, symmetric: bool) -> complex:
    """Zero at a Lamb wave of the reference plate: Rayleigh and Lamb's equation, real for real k."""
    half = 0.5 * THICKNESS
    p, q = (
        np.sqrt(complex((omega / c) ** 2 - k**2))
        for c in (ALUMINIUM.longitudinal_speed, ALUMINIUM.shear_speed)
    )
    outer = (q**2 - k**2) ** 2
    if symmetric:
        value = outer * np.cos(p * half) * np.sin(q * half) / q
        value += 4 * k**2 * p * np.sin(p * half) * np.cos(q * half)
    else:
        value = outer * np.sin(p * half) / p * np.cos(q * half)
        value += 4 * k**2 * q * np.sin(q * half) * np.cos(p * half)
    return complex(value)


@pytest.mark.parametrize("kilohertz", [5.0, 58.8, 400.0, 1500.0])
@pytest.mark.parametrize("angle", [0.0, 0.6])
def test_the_three_families_are_lamb_waves_and_the_shear_wave(kilohertz, angle):
    omega = kilohertz * KILOHERTZ
    assert PLATE.wavenumber(omega, angle, "SH0") == pytest.approx(omega / ALUMINIUM.shear_speed, rel=1e-9)
    for family, symmetric in (("A0", False), ("S0", True)):
        k = PLATE.wavenumber(omega, angle, family)
        exact = brentq(lambda k: lamb(k, omega, symmetric).real, 0.99 * k, 1.01 * k, xtol=1e-10 * k)  # noqa: B023
        assert k == pytest.approx(exact, rel=1e-6)
        assert (family == "A0") == (k > omega / ALUMINIUM.shear_speed)


def misfit(k: complex, omega: float) -> float:
    """How far, relative to k, the nearest exact wave lies: Newton's step on either equation."""
    ahead, behind = k * (1 + 1e-6), k * (1 - 1e-6)
    steps = [
        lamb(k, omega, s) * 2e-6 / (lamb(ahead, omega, s) - lamb(behind, omega, s)) for s in (True, False)
    ]
    return min(abs(step) for step in steps)


def test_evanescent_waves_are_lamb_waves_or_shear_waves():
    omega = 58.8 * KILOHERTZ
    right, _ = PLATE.waves(omega, np.zeros(1), LENGTH)
    decay = right.wavenumber[right.labelled(EVANESCENT)][:6]
    half_waves = np.pi * np.arange(1, 4) / THICKNESS
    shear = 1j * np.sqrt(half_waves**2 - (omega / ALUMINIUM.shear_speed) ** 2)
    is_shear = (np.abs(decay[:, None] / shear - 1) < 1e-6).any(axis=1)
    assert is_shear.sum() == 2
    assert max(misfit(complex(k), omega) for k in decay[~is_shear]) < 1e-6


def test_more_levels_bring_the_wavenumber_in_at_the_rate_of_a_polynomial_method():
    omega = 800.0 * KILOHERTZ
    plates = [PlainPlate.of(reference_cell(), levels) for levels in (3, 4, 5, 6, 7)]
    error = [abs(p.wavenumber(omega, 0.0, "A0") / PLATE.wavenumber(omega, 0.0, "A0") - 1) for p in plates]
    assert all(after < 0.5 * before for before, after in zip(error, error[2:], strict=False))
    assert error[-1] < 1e-5


@pytest.mark.parametrize("k_t", [0.0, 90.0, -380.0])
def test_an_oblique_wave_is_a_turned_one(k_t):
    omega = 58.8 * KILOHERTZ
    for side in PLATE.waves(omega, np.array([k_t]), LENGTH):
        wavenumbers = {
            name: k for name, k in zip(side.label, side.wavenumber, strict=True) if name in FAMILIES
        }
        expected = {name: PLATE.wavenumber(omega, 0.3, name) for name in FAMILIES}
        assert set(wavenumbers) == {name for name, k in expected.items() if k > abs(k_t)}
        for name, k in wavenumbers.items():
            assert np.hypot(k.real, k_t) == pytest.approx(expected[name], rel=1e-8)


def test_time_runs_so_that_waves_to_the_right_have_negative_wavenumbers():
    right, left = PLATE.waves(58.8 * KILOHERTZ, np.zeros(1), LENGTH)
    assert (right.wavenumber[right.waves.propagates].real < 0).all()
    assert (right.wavenumber[~right.waves.propagates].imag > 0).all()
    assert left.wavenumber[left.waves.propagates].real.max() > 0
    assert right.label[:3] != right.label[3:6] == (EVANESCENT,) * 3


def test_higher_waves_appear_above_their_cut_off():
    """The first, SH1, is half a shear wave thick."""
    cut_off = np.pi * ALUMINIUM.shear_speed / THICKNESS
    for omega, more in ((0.99 * cut_off, 0), (1.01 * cut_off, 2)):  # A1 has the same cut-off
        right, _ = PLATE.waves(omega, np.zeros(1), LENGTH)
        assert sum(right.labelled(HIGHER)) == more
        assert all(right.labelled(name).sum() == 1 for name in FAMILIES)


@settings(max_examples=10)
@given(kilohertz=st.floats(5.0, 2000.0), k_t=st.floats(-900.0, 900.0))
def test_waves_carry_unit_energies_independently(kilohertz, k_t):
    omega = kilohertz * KILOHERTZ
    sides = PLATE.waves(omega, np.array([k_t, 2 * k_t + 1.0]), LENGTH)
    moving = [side.waves.chosen(np.flatnonzero(side.waves.propagates)) for side in sides]
    u, f = (np.hstack([getattr(w, name) for w in moving]) for name in ("displacement", "force"))
    sign = np.repeat([1.0, -1.0], [len(w) for w in moving])
    assert np.abs(energy_flux(u, f, omega) - np.diag(sign)).max(initial=0.0) < 1e-6


def plate_of(stiffness: np.ndarray, levels: int) -> PlainPlate:
    """A plate of any material; a lattice would not take it."""
    material = SimpleNamespace(stiffness=stiffness, density=2700.0)
    return PlainPlate.of(SimpleNamespace(thickness=THICKNESS, material=material), levels)


def triclinic(seed: int = 4) -> np.ndarray:
    noise = np.random.default_rng(seed).standard_normal((6, 6))
    return ALUMINIUM.stiffness + 4e9 * (noise @ noise.T)


@pytest.mark.parametrize("k_t", [0.0, 250.0])
def test_waves_of_a_triclinic_plate_leave_its_faces_free(k_t):
    """Exact partial waves exp(i k . r) that make up a plate wave (Nayfeh and Chimenti 1989)."""
    stiffness, omega = triclinic(), 400.0 * KILOHERTZ
    tensor = elasticity_tensor(stiffness)  # c_ikjl

    def looseness(k: float) -> float:
        flat = np.array([k, k_t, 0.0])
        constant = np.einsum("ikjl,k,l->ij", tensor, flat, flat) - 2700.0 * omega**2 * np.eye(3)
        linear = np.einsum("ijl,l->ij", tensor[:, 2], flat) + np.einsum("ikj,k->ij", tensor[..., 2], flat)
        quadratic = tensor[:, 2, :, 2]
        companion = np.block([
            [np.zeros((3, 3)), np.eye(3)],
            [-la.solve(quadratic, constant), -la.solve(quadratic, linear)],
        ])  # fmt: skip
        k_z, fields = la.eig(companion)
        vectors = np.column_stack([np.full(6, k), np.full(6, k_t), k_z])
        traction = np.einsum("ijl,wl,jw->iw", tensor[:, 2], vectors, fields[:3])
        both = np.vstack([traction, traction * np.exp(1j * k_z * THICKNESS)])
        both /= np.linalg.norm(both, axis=0)
        return float(np.linalg.svd(both, compute_uv=False)[-1])

    right, left = plate_of(stiffness, LEVELS).waves(omega, np.array([k_t]), LENGTH)
    for side in (right, left):
        moving = side.wavenumber[side.waves.propagates].real
        assert len(moving) >= 2
        for k in moving:
            assert looseness(k) < 1e-4 * min(looseness(1.01 * k), looseness(0.99 * k))
    assert right.waves.propagates.sum() == left.waves.propagates.sum()


@given(st.floats(0.0, 1.5), st.floats(-1.5, 1.5))
@settings(max_examples=10)
def test_turning_the_material_and_the_wave_changes_nothing(angle, turned):
    cubic = ALUMINIUM.stiffness.copy()
    cubic[np.arange(3, 6), np.arange(3, 6)] *= 1.7
    c, s = np.cos(turned), np.sin(turned)
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
    tensor = np.einsum("ai,bk,cj,dl,ikjl->abcd", *[turn] * 4, elasticity_tensor(cubic), optimize=True)
    pairs = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))
    rotated = np.array([[tensor[i, k, j, m] for j, m in pairs] for i, k in pairs])
    for family in FAMILIES:
        k = plate_of(cubic, 5).wavenumber(300.0 * KILOHERTZ, angle, family)
        assert plate_of(rotated, 5).wavenumber(300.0 * KILOHERTZ, angle + turned, family) == pytest.approx(k)
