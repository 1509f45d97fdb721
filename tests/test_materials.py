"""Elastic constants against closed forms, published values and second routes."""

import json
import math
import pickle
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from each import each
from five_parts import refusing
from haptonic.errors import StudyError
from haptonic.materials import (
    IsotropicMaterial,
    OrthotropicMaterial,
    PiezoelectricMaterial,
    library,
    material,
)
from haptonic.study import loads
from plies import PLY

ROOT = Path(__file__).parents[1]
VACUUM = 8.8541878128e-12  # F/m
VOIGT = [(0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)]

NAMES = {
    "aluminium-2017a",
    "aluminium-paper",
    "aluminium-7075",
    "steel",
    "titanium-ti6al4v",
    "brass",
    "soda-lime-glass",
    "borosilicate-glass",
    "silicon",
    "pmma",
    "epoxy",
    "pzt-4",
    "pzt-5a",
    "sm111",
    "silver-epoxy",
}
solids = st.builds(
    IsotropicMaterial,
    st.floats(1e6, 1e12),
    st.floats(-0.95, 0.495),
    st.floats(100, 2e4),
    name=st.just("solid"),
)


def isotropic(**changed):
    constants = {"youngs_modulus": 70e9, "poisson_ratio": 0.33, "density": 2700.0, **changed}
    return IsotropicMaterial(**constants, name="solid")


def silicon(**changed):
    constants = dict.fromkeys(("c11", "c22", "c33"), 165.7e9)
    constants |= dict.fromkeys(("c12", "c13", "c23"), 63.9e9)
    constants |= dict.fromkeys(("c44", "c55", "c66"), 79.6e9)
    return OrthotropicMaterial(**(constants | {"name": "crystal", "density": 2330.0} | changed))


def fourth_order(stiffness):
    """c_ijkl of a (6, 6) matrix in Voigt order."""
    tensor = np.zeros((3, 3, 3, 3))
    for row, (i, j) in enumerate(VOIGT):
        for column, (k, m) in enumerate(VOIGT):
            for a, b in {(i, j), (j, i)}:
                for c, d in {(k, m), (m, k)}:
                    tensor[a, b, c, d] = stiffness[row, column]
    return tensor


def youngs_modulus_along(stiffness, direction):
    """1 / s'_1111 along a direction, from the inverse of the stiffness."""
    n = np.array(direction) / np.linalg.norm(direction)
    stress = np.array([n[i] * n[j] for i, j in VOIGT])  # of unit tension
    strain = np.linalg.solve(stiffness, stress)
    return 1 / (stress @ strain)  # stress : strain is the strain along n


@settings(deadline=None)
@given(solids)
def test_isotropic_stiffness_inverts_the_compliance(solid):
    young, nu = solid.youngs_modulus, solid.poisson_ratio
    compliance = np.diag([1, 1, 1, *[2 * (1 + nu)] * 3])
    compliance[:3, :3] += -nu * (1 - np.eye(3))
    assert np.allclose(solid.stiffness @ compliance / young, np.eye(6), atol=1e-9)


@settings(deadline=None)
@given(solids, st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda n: np.linalg.norm(n) > 0.1))
def test_speeds_solve_christoffel_in_every_direction(solid, direction):
    n = np.array(direction) / np.linalg.norm(direction)
    christoffel = np.einsum("ijkm,j,m->ik", fourth_order(solid.stiffness), n, n) / solid.density
    speeds = np.sqrt(np.linalg.eigvalsh(christoffel))
    expected = sorted([solid.shear_speed, solid.shear_speed, solid.longitudinal_speed])
    assert np.allclose(speeds, expected, rtol=1e-6)


@pytest.mark.parametrize(
    ("nu", "square"),
    [(0.0, 3 - np.sqrt(5)), (0.25, 2 - 2 / np.sqrt(3))],
)
def test_rayleigh_speed_where_the_cubic_factors(nu, square):
    solid = isotropic(poisson_ratio=nu)
    assert solid.rayleigh_speed / solid.shear_speed == pytest.approx(np.sqrt(square), rel=1e-8)


@settings(deadline=None)
@given(solids)
def test_rayleigh_speed_solves_the_equation_before_squaring(solid):
    x = (solid.rayleigh_speed / solid.shear_speed) ** 2
    ratio = (solid.shear_speed / solid.longitudinal_speed) ** 2
    assert 0 < x < 1
    assert (2 - x) ** 2 == pytest.approx(4 * np.sqrt(1 - x) * np.sqrt(1 - ratio * x), rel=1e-6)


def test_rayleigh_speed_reaches_its_limit_for_a_nearly_incompressible_solid():
    solid = isotropic(poisson_ratio=0.4999999)
    assert solid.rayleigh_speed / solid.shear_speed == pytest.approx(0.9553, abs=1e-4)


@pytest.mark.parametrize(
    ("direction", "published"), [((1, 0, 0), 130e9), ((1, 1, 0), 169e9), ((1, 1, 1), 188e9)]
)
def test_silicon_has_the_published_youngs_moduli(direction, published):
    """Values of [hopcroft2010], given to three digits there."""
    modulus = youngs_modulus_along(material("silicon").stiffness, direction)
    assert modulus == pytest.approx(published, rel=4e-3)


def test_orthotropic_entries_are_at_their_places():
    constants = ("c11", "c22", "c33", "c23", "c13", "c12", "c44", "c55", "c66")
    values = dict(zip(constants, [100e9, 110e9, 120e9, 23e9, 13e9, 12e9, 44e9, 55e9, 66e9], strict=True))
    stiffness = silicon(**values).stiffness
    for name, value in values.items():
        row, column = int(name[1]) - 1, int(name[2]) - 1
        assert stiffness[row, column] == stiffness[column, row] == value
    assert np.count_nonzero(stiffness) == 12


def test_constants_that_are_left_out_follow_from_the_symmetry():
    cubic = OrthotropicMaterial(c11=165.7e9, c12=63.9e9, c44=79.6e9, density=2330.0)
    assert np.array_equal(cubic.stiffness, silicon().stiffness)
    around = OrthotropicMaterial(c11=162e9, c12=92e9, c13=69e9, c33=181e9, c44=46.7e9, density=4506.0)
    expected = np.zeros((6, 6))
    expected[:3, :3] = [[162e9, 92e9, 69e9], [92e9, 162e9, 69e9], [69e9, 69e9, 181e9]]
    expected[3:, 3:] = np.diag([46.7e9, 46.7e9, 35e9])
    assert np.array_equal(around.stiffness, expected)
    turned = replace(around, turn=0.7).stiffness
    assert np.allclose(turned, expected, atol=1e-12 * 181e9)  # isotropic in the plane
    tetragonal = replace(around, c66=40e9)
    expected[5, 5] = 40e9
    assert np.array_equal(tetragonal.stiffness, expected)


def test_silicon_turned_by_45_degrees_is_stiff_along_the_axes_of_the_plate():
    turned = silicon(turn=math.radians(45)).stiffness
    assert youngs_modulus_along(turned, (1, 0, 0)) == pytest.approx(169e9, rel=4e-3)
    assert youngs_modulus_along(turned, (1, 1, 0)) == pytest.approx(130e9, rel=4e-3)


@given(st.floats(-4, 4), st.floats(-4, 4))
def test_a_turned_solid_is_as_stiff_along_turned_directions(turn, along):
    def direction(angle):
        return (math.cos(angle), math.sin(angle), 0.4)

    expected = youngs_modulus_along(PLY.stiffness, direction(along))
    turned = replace(PLY, turn=turn)
    assert youngs_modulus_along(turned.stiffness, direction(along + turn)) == pytest.approx(expected)


@each(
    ("constants", "argument", "words"),
    [
        ({"c66": 80e9}, "material.c13", "add c13 and c33"),
        ({"c13": 60e9}, "material.c33", "add c33"),
        ({"c22": 160e9}, "material.c13", "add c13, c23, c33, c55 and c66"),
        ({"c16": 1e9}, "material.c16", "their angle to the plate as turn"),
        ({"c21": 1e9}, "material.c21", 'write "c12"'),
        ({"e1": 1e9}, "material.e1", "invert its compliance matrix"),
        ({"nu12": 0.3}, "material.nu12", "invert its compliance matrix"),
        ({"c12": 170e9}, "material.c11", "which of them are compliances"),
        ({"turn": float("nan")}, "material.turn", "finite"),
    ],
)
def test_refuses_other_sets_of_constants(constants, argument, words):
    with pytest.raises(StudyError) as caught:
        OrthotropicMaterial(**({"c11": 166e9, "c12": 64e9, "c44": 80e9, "density": 2330.0} | constants))
    assert caught.value.argument == argument
    assert words in caught.value.next_step


def across(first, second, third, fourth, fifth, sixth):
    """(6, 6) constants 11, 12, 13, 33, 44 and 66 of a solid that is isotropic around axis 3."""
    matrix = np.diag([first, first, fourth, fifth, fifth, sixth])
    matrix[0, 1] = matrix[1, 0] = second
    matrix[:2, 2] = matrix[2, :2] = third
    return matrix


def poled(d31, d33, d15):
    """(3, 6) charge constants of a ceramic that is poled along axis 3."""
    return np.array([[0, 0, 0, 0, d15, 0], [0, 0, 0, d15, 0, 0], [d31, d31, d33, 0, 0, 0]])


# the form that the ceramics are published in: compliance 1e-12/Pa, charge constants pm/V, free permittivities
# over that of vacuum, coupling factors k33, k31, k15
PUBLISHED = {
    "pzt-4": (
        across(12.3, -4.05, -5.31, 15.5, 39.0, 32.7),
        poled(-123, 289, 496),
        (1475, 1475, 1300),
        (0.70, 0.33, 0.71),
    ),
    "pzt-5a": (
        across(16.4, -5.74, -7.22, 18.8, 47.5, 44.28),  # printed 44.3
        poled(-171, 374, 584),
        (1730, 1730, 1700),
        (0.705, 0.344, 0.685),
    ),
}


@pytest.mark.parametrize("name", PUBLISHED)
class TestCeramics:
    """The stored stiffness form against the compliance form that the ceramics are published in."""

    def test_stiffness_is_the_inverse_of_the_compliance(self, name):
        assert np.allclose(material(name).stiffness @ PUBLISHED[name][0] * 1e-12, np.eye(6), atol=3e-5)

    def test_coupling_is_charge_constants_times_stiffness(self, name):
        compliance, charge, _, _ = PUBLISHED[name]
        expected = charge @ np.linalg.inv(compliance)
        assert np.allclose(np.array(material(name).coupling), expected, atol=1e-4 * 15)

    def test_stiffness_form_gives_the_published_free_permittivity(self, name):
        ceramic = material(name)
        charge = np.array(ceramic.coupling) @ np.linalg.inv(ceramic.stiffness)
        free = np.array(ceramic.permittivity) + charge @ np.array(ceramic.coupling).T
        assert np.allclose(free / VACUUM, np.diag(PUBLISHED[name][2]), atol=1)

    def test_coupling_factors_are_the_published_ones(self, name):
        ceramic = material(name)
        compliance = np.linalg.inv(ceramic.stiffness)
        charge = np.array(ceramic.coupling) @ compliance
        free = np.array(ceramic.permittivity) + charge @ np.array(ceramic.coupling).T
        k33 = charge[2, 2] / np.sqrt(compliance[2, 2] * free[2, 2])
        k31 = -charge[2, 0] / np.sqrt(compliance[0, 0] * free[2, 2])
        k15 = charge[0, 4] / np.sqrt(compliance[4, 4] * free[0, 0])
        assert (k33, k31, k15) == pytest.approx(PUBLISHED[name][3], abs=0.02)

    def test_is_isotropic_across_the_poling_axis(self, name):
        stiffness = material(name).stiffness
        assert stiffness[5, 5] == pytest.approx((stiffness[0, 0] - stiffness[0, 1]) / 2, rel=1e-3)

    def test_the_tensor_of_the_coupling_gives_the_charge_of_any_strain(self, name):
        ceramic = material(name)
        strain = np.array([[1.0, 0.2, -0.5], [0.2, -2.0, 0.7], [-0.5, 0.7, 3.0]])
        voigt = [strain[i, j] * (1 if i == j else 2) for i, j in VOIGT]
        charge = np.einsum("akl,kl->a", ceramic.coupling_tensor, strain)
        assert charge == pytest.approx(np.array(ceramic.coupling) @ voigt)


def test_sm111_is_pzt4_but_for_density_and_losses():
    ours, customary = material("sm111"), material("pzt-4")
    for matrix in ("stiffness", "coupling", "permittivity"):
        assert np.array_equal(getattr(ours, matrix), getattr(customary, matrix))
    assert ours.density != customary.density


# the customary stiffness form of PZT-4: Pa, C/m^2, and permittivities at constant strain over that of vacuum
STIFFNESS_FORM = {
    "c11": 138.999e9, "c12": 77.8366e9, "c13": 74.2836e9, "c33": 115.412e9, "c44": 25.641e9,
    "e31": -5.20279, "e33": 15.0804, "e15": 12.7179, "permittivity_11": 762.5, "permittivity_33": 663.2,
}  # fmt: skip


def test_both_forms_of_the_constants_are_the_same_ceramic():
    given = PiezoelectricMaterial(name="x", density=7500.0, **STIFFNESS_FORM)
    assert np.allclose(given.stiffness, material("pzt-4").stiffness, rtol=1e-5)
    assert np.allclose(given.coupling, material("pzt-4").coupling, rtol=1e-4)
    assert np.allclose(given.permittivity, material("pzt-4").permittivity, rtol=1e-3)


def test_library_has_the_documented_materials():
    assert set(library()) == NAMES
    paper = material("aluminium-paper")
    assert (paper.youngs_modulus, paper.poisson_ratio, paper.density) == (70e9, 0.33, 2700.0)
    prototype = material("aluminium-2017a")
    assert (prototype.youngs_modulus, prototype.density) == (72.4e9, 2790.0)


@each("name", sorted(NAMES))
def test_every_material_is_a_stable_value_with_a_source(name):
    solid = material(name)
    assert solid.name == name
    assert solid.source
    assert solid.stiffness.shape == (6, 6)
    assert np.allclose(solid.stiffness, solid.stiffness.T)
    assert np.linalg.eigvalsh(solid.stiffness).min() > 0
    assert 0 <= solid.loss_factor < 0.1
    assert solid.loss_factor > 0 or name == "aluminium-paper"
    assert pickle.loads(pickle.dumps(solid)) == solid
    assert hash(pickle.loads(pickle.dumps(solid))) == hash(solid)
    assert json.loads(json.dumps(solid.to_dict()))["density"] == solid.density


def test_cited_keys_are_in_the_bibliography():
    keys = set(
        re.findall(r"^@\w+\{([^,]+),", (ROOT / "docs/references.bib").read_text("utf-8"), re.MULTILINE)
    )
    sources = [*(ROOT / "src/haptonic/materials").glob("*.py")]
    text = "".join(path.read_text("utf-8") for path in sources)
    cited = set(re.findall(r"\[([a-z]+[0-9]{3,4})\]", text))
    assert len(cited) >= 2
    assert cited <= keys


def test_a_source_is_found_without_our_bibliography():
    for solid in library().values():
        assert not re.search(r"\[[a-z][a-z0-9-]+\]", f"{solid.source} {solid.note}")


def test_unknown_name_suggests_the_nearest():
    with pytest.raises(StudyError) as caught:
        material("Aluminum-7075")
    assert caught.value.next_step == 'write "aluminium-7075"'
    assert "titanium-ti6al4v" in caught.value.allowed


def test_a_kind_of_material_suggests_the_materials_of_this_kind():
    with pytest.raises(StudyError) as caught:
        material("glass")
    assert caught.value.next_step == 'write "soda-lime-glass" or "borosilicate-glass"'


def test_empty_space_as_a_material_leads_to_a_hole():
    for name in ("void", "Air"):
        with pytest.raises(StudyError, match="empty = true"):
            material(name)


def test_library_and_uncertainty_cannot_be_changed():
    with pytest.raises(TypeError):
        library()["wood"] = material("steel")
    widths = {"density": 20.0}
    solid = isotropic(uncertainty=widths)
    widths["density"] = 1e9
    assert solid.uncertainty == {"density": 20.0}
    with pytest.raises(TypeError):
        solid.uncertainty["density"] = 0.0


def test_two_materials_that_differ_in_anything_have_different_dicts():
    changes = [
        {"youngs_modulus": 71e9},
        {"loss_factor": 1e-3},
        {"uncertainty": {"density": 1.0}},
        {"note": "x"},
    ]
    texts = {json.dumps(isotropic(**change).to_dict(), sort_keys=True) for change in [{}, *changes]}
    assert len(texts) == 5


@each(
    ("build", "change", "argument"),
    [
        (isotropic, {"poisson_ratio": 0.5}, "material.poisson_ratio"),
        (isotropic, {"poisson_ratio": 0.51}, "material.poisson_ratio"),
        (isotropic, {"poisson_ratio": -1.0}, "material.poisson_ratio"),
        (isotropic, {"poisson_ratio": float("nan")}, "material.poisson_ratio"),
        (isotropic, {"youngs_modulus": 0.0}, "material.youngs_modulus"),
        (isotropic, {"youngs_modulus": float("inf")}, "material.youngs_modulus"),
        (isotropic, {"youngs_modulus": "70 GHz"}, "material.youngs_modulus"),
        (isotropic, {"density": -1.0}, "material.density"),
        (isotropic, {"density": True}, "material.density"),
        (isotropic, {"loss_factor": -1e-3}, "material.loss_factor"),
        (isotropic, {"loss_factor": 1.0}, "material.loss_factor"),
        (isotropic, {"uncertainty": {"densty": 1.0}}, "material.uncertainty.densty"),
        (isotropic, {"uncertainty": {"density": -1.0}}, "material.uncertainty.density"),
        (silicon, {"c12": 170e9}, "material.c11"),
        (silicon, {"c44": 0.0}, "material.c44"),
        (silicon, {"c55": float("nan")}, "material.c55"),
        (silicon, {"density": 0}, "material.density"),
    ],
)
def test_refuses_what_no_stable_solid_has(build, change, argument):
    with pytest.raises(StudyError) as caught:
        build(**change)
    assert caught.value.argument == argument
    assert all(caught.value.parts().values())


SOLIDS = """
[cell]
pitch = "7 mm"
thickness = "1 mm"
[material]
density = "2330 kg/m^3"
"""
CUBIC = 'c11 = "166 GPa"\nc12 = "64 GPa"\nc44 = "80 GPa"\n'
ISOTROPIC = 'youngs_modulus = "70 GPa"\npoisson_ratio = 0.3\n'


@each(
    ("keys", "argument", "words"),
    [
        (ISOTROPIC + 'turn = "3 deg"\n', "material.turn", "keys of one kind only"),
        (ISOTROPIC + 'c11 = "3 GPa"\n', "material.c11", "keys of one kind only"),
        (CUBIC + "poisson_ratio = 0.3\n", "material.poisson_ratio", "keys of one kind only"),
        (CUBIC.replace("c", "s"), "material.s11", "invert its compliance matrix"),
        (CUBIC.replace("c", "C"), "material.C11", 'write "c11"'),
        (CUBIC.replace("c", "c_"), "material.c_11", 'write "c11"'),
        (CUBIC + '[material.uncertainty]\nc33 = "2 GPa"\nyoungs_modulus = "2 GPa"\n',
         "material.uncertainty.youngs_modulus", "leave it out"),
    ],
)  # fmt: skip
def test_tables_that_mix_kinds_of_materials_are_refused(keys, argument, words):
    with pytest.raises(StudyError) as caught:
        loads(SOLIDS + keys)
    assert caught.value.argument == f"study: {argument}"
    assert words in caught.value.next_step
    assert "youngs_modulus was left out" not in str(caught.value)


def test_a_degree_sign_is_a_unit():
    assert loads(SOLIDS + CUBIC + 'turn = "45°"\n').cell.material.turn == math.radians(45)


def test_incompressible_is_explained():
    with refusing(StudyError, "out-of-range", "material.poisson_ratio") as caught:
        isotropic(poisson_ratio=0.5)
    assert "0.49" in caught.value.next_step
    with pytest.raises(StudyError) as caught:
        isotropic(poisson_ratio=-1.0)
    assert "incompressible" not in str(caught.value)


@each(
    ("change", "argument", "words"),
    [
        ({"c44": -1e9}, "material.c11", "signs"),
        ({"c12": 150e9}, "material.c11", "signs"),
        ({"c13": None}, "material.c13", "add c13"),
        ({"s11": 12e-12}, "material.s11", "leave out s11"),
        ({name: None for name in STIFFNESS_FORM if name[0] in "ce"}, "material.d15", "add d15"),
        ({"e15": float("nan")}, "material.e15", "C/m^2"),
        ({"permittivity_33": 0.0}, "material.permittivity_33", ""),
        ({"dielectric_loss": 2.0}, "material.dielectric_loss", ""),
        ({"name": " "}, "material.name", ""),
    ],
)
def test_refuses_impossible_piezoelectrics(change, argument, words):
    with pytest.raises(StudyError) as caught:
        PiezoelectricMaterial(**({"name": "x", "density": 7500.0} | STIFFNESS_FORM | change))
    assert caught.value.argument == argument
    assert words in caught.value.next_step


@each("name", ["pzt-4", "pzt-5a"])
def test_a_free_element_has_the_loss_tangent_that_its_maker_prints(name):
    """From complex constants: the free permittivity is that at constant strain plus d c e."""
    ceramic = material(name)
    stiffness = ceramic.stiffness * (1 + 1j * ceramic.loss_factor)
    clamped = ceramic.permittivity[2, 2] * (1 - 1j * ceramic.clamped_loss)
    free = clamped + ceramic.coupling[2] @ np.linalg.inv(stiffness) @ ceramic.coupling[2]
    assert -free.imag / free.real == pytest.approx(ceramic.dielectric_loss, rel=1e-3)
    assert ceramic.clamped_loss > ceramic.dielectric_loss
    assert replace(ceramic, dielectric_loss=0.0).clamped_loss == 0.0


def test_charge_constants_too_large_for_the_permittivity_are_refused():
    with refusing(StudyError, "malformed", "material.permittivity_33"):
        replace(material("pzt-4"), permittivity_33=500.0)
