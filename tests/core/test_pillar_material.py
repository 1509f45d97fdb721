"""Pillars of another material than the plate: identities, a brute solution, limits, and what is refused."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from brute import assembled, frequencies, periodic_projection
from hypothesis import given, settings, strategies as st
from strategies import ALUMINIUM

import haptonic as hp
from daily import daily
from five_parts import refusing
from haptonic.bloch import BlochModel, Resolution
from haptonic.bloch.pencil import bloch_pencil, eigenpairs
from haptonic.cell import MeshPlan, Pillar, Site, Step, UnitCell, mesh_cell
from haptonic.errors import GeometryError, StudyError
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial, material
from haptonic.study import loads
from haptonic.superelement import Tiling, condense_by_parts, through_levels
from plies import PLY

EPOXY, STEEL = material("epoxy"), material("steel")
RUBBER = IsotropicMaterial(1.175e5, 0.469, 1300.0, name="rubber")
KAPPA = np.array([1.1, 2.3])
SHORT = Pillar(3.5e-3, 6e-3)
COARSE = Resolution(3, 1)


def with_pillar(pillar, lattice=None):
    return UnitCell(lattice or Lattice.square(7e-3), 1.5e-3, ALUMINIUM, pillar)


@cache
def lowest(cell, count=8):
    return BlochModel.of(cell, COARSE, count, measured=False).solve(KAPPA).frequency


CELLS = {
    "round": with_pillar(SHORT),
    "draft": with_pillar(replace(SHORT, draft=0.03)),
    "step": with_pillar(replace(SHORT, step=Step(2e-3, 4e-3))),
    "triangular": with_pillar(SHORT, Lattice.triangular(7e-3)),
    "both faces": replace(with_pillar(SHORT), faces="both"),
    "two sites": UnitCell(
        Lattice(lattice="honeycomb", pitch=9e-3),
        1.5e-3,
        ALUMINIUM,
        site=(Site(pillar=Pillar(2.4e-3, 5e-3)), Site(pillar=Pillar(2e-3, 4e-3))),
    ),
}


def changed(cell, solid):
    """The cell with all its pillars of a material."""
    sites = tuple(replace(site, pillar=replace(site.pillar, material=solid)) for site in cell.site)
    return replace(cell, pillar=cell.pillar and replace(cell.pillar, material=solid), site=sites)


@pytest.mark.parametrize("name", daily(CELLS, "round", "step"))
def test_a_pillar_of_the_plates_material_by_another_name_changes_nothing(name):
    same = replace(ALUMINIUM, name="the same metal")
    assert lowest(changed(CELLS[name], same)) == pytest.approx(lowest(CELLS[name]), rel=1e-12)


@pytest.mark.nightly
@pytest.mark.parametrize(
    "solid",
    [STEEL, EPOXY, RUBBER],
    ids=lambda solid: solid.name,
)
def test_frequencies_are_those_of_the_whole_mesh(solid):
    """Condensed in parts, against whole matrices of one mesh."""
    cell = changed(with_pillar(Pillar(3.5e-3, 4e-3)), solid)
    plan = MeshPlan.suited(cell, *((3, 0) if solid is STEEL else (3, 1)))
    mesh = mesh_cell(cell, plan)
    tile = condense_by_parts(cell, plan, 4, block=20, measured=False)
    frequency = np.sqrt(eigenpairs(bloch_pencil(Tiling.single(tile)), KAPPA, 8)[0]) / (2 * np.pi)
    through = through_levels(cell, mesh, tile.levels)
    P = periodic_projection(mesh.points, cell.lattice.vectors, KAPPA, through, mesh.topology.rim)
    # of rubber eight modes in the pillar leave out more than those of a plate
    apart = 1e-3 if solid is RUBBER else 2e-4
    assert frequency == pytest.approx(frequencies(*assembled(mesh, ALUMINIUM, solid), P, 8), rel=apart)


@settings(max_examples=2)
@given(st.floats(0.1, 5.0), st.floats(0.1, 5.0))
def test_stiffness_and_density_of_both_materials_scale_frequencies(stiffer, heavier):
    def scaled(solid):
        return replace(solid, youngs_modulus=stiffer * solid.youngs_modulus, density=heavier * solid.density)

    cell = changed(CELLS["round"], STEEL)
    other = replace(changed(cell, scaled(STEEL)), material=scaled(ALUMINIUM))
    assert lowest(other) == pytest.approx(lowest(cell) * np.sqrt(stiffer / heavier), rel=1e-7)


def test_a_pillar_that_weighs_and_resists_nothing_leaves_the_plain_plate():
    # ten times as fast as aluminium, so that the pillar has no mode of its own as low as the plate's first
    void = IsotropicMaterial(1e8, 0.3, 1.0, name="next to nothing")
    cell = changed(CELLS["round"], void)
    assert lowest(cell)[0] == pytest.approx(lowest(cell.without_pillar())[0], rel=5e-3)


def test_a_fillet_belongs_to_one_material():
    """Steel on aluminium with a fillet was up to six times its stated error off."""
    with refusing(GeometryError, "conflict", "cell.pillar.fillet"):
        replace(SHORT, fillet=0.4e-3, material=STEEL)


def test_symmetry_is_that_of_both_materials():
    square = CELLS["round"]
    turned = changed(square, PLY)
    assert len(square.point_group.operations) == 8
    assert len(turned.point_group.operations) == 4


STUDY = """
carrier = "60 kHz"
material = "aluminium-paper"
[cell]
pitch = "7 mm"
thickness = "1.5 mm"
[cell.pillar]
diameter = "3.5 mm"
height = "6 mm"
material = "epoxy"
"""


class TestStudies:
    def test_a_name_and_a_table_give_the_material(self):
        study = loads(STUDY)
        assert study.cell.pillar.material == EPOXY
        assert study.cell.pillar_material == EPOXY
        table = STUDY.replace('material = "epoxy"', "") + (
            '[cell.pillar.material]\nname = "tungsten"\nyoungs_modulus = "411 GPa"\n'
            'poisson_ratio = 0.28\ndensity = "19250 kg/m^3"\n'
        )
        tungsten = loads(table)
        assert tungsten.cell.pillar.material.density == 19250.0
        assert loads(tungsten.to_toml()) == tungsten
        assert loads(study.to_toml()) == study

    def test_constants_of_the_pillars_material_are_inputs_of_a_result(self):
        inputs = loads(STUDY).inputs()
        assert inputs["cell"]["materials"]["pillar.material"]["youngs_modulus"] == EPOXY.youngs_modulus
        plain = loads(STUDY.replace('material = "epoxy"', "")).inputs()
        assert "materials" not in plain["cell"]

    def test_an_unknown_name_is_refused_at_its_key(self):
        with refusing(StudyError, "unknown", "cell.pillar.material"):
            loads(STUDY.replace("epoxy", "unobtainium"))

    def test_a_material_may_be_given_in_python(self):
        study = hp.Study(
            material="brass",
            cell={"pitch": "7 mm", "thickness": "1 mm",
                  "pillar": {"diameter": "3 mm", "height": "4 mm", "material": STEEL}},
        )  # fmt: skip
        assert study.cell.pillar_material == STEEL
        assert "with pillars of steel" in study.plan().summary()[0]

    @pytest.mark.parametrize(("analysis", "argument"), [("layers", "cell.pillar.material")])
    def test_an_analysis_with_one_loss_factor_refuses_two(self, analysis, argument):
        with refusing(StudyError, "unsupported", argument):
            getattr(loads(STUDY), analysis)()

    def test_files_for_a_workshop_have_a_surface_for_each_material(self, tmp_path):
        files = loads(STUDY).export(stl=True)
        files.put(tmp_path)
        assert len(list(tmp_path.glob("*.stl"))) == len(files.facts()["materials"]) == 2

    def test_a_plate_asks_for_its_loss(self):
        tiles = '[plate.tiles]\nA = "lattice"\nP = "plain"\n[plate.widths]\nplain = "9 mm"\n'
        plate = f'[plate]\nmap = "APA"\n{tiles}'
        with refusing(StudyError, "missing", "plate.loss_factor"):
            loads(STUDY + plate)
        damped = loads(STUDY + plate.replace("map", "loss_factor = 0.01\nmap"))
        assert damped.plate_settings.loss_factor == 0.01
