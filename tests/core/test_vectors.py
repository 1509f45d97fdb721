"""Lattices given by two vectors: they are what they are by name, and what is none is refused."""

from itertools import product

import numpy as np
import pytest
from hypothesis import given, strategies as st
from strategies import ALUMINIUM, lattices

from five_parts import refusing
from haptonic.brillouin import IrreducibleZone
from haptonic.cell import Pillar, Site, UnitCell
from haptonic.errors import GeometryError, StudyError
from haptonic.fields import table
from haptonic.fields.problems import example_at
from haptonic.lattice import Lattice
from haptonic.study import loads

# every basis of a lattice whose steps are small, right-handed and left-handed ones
BASES = [
    np.array([(a, b), (c, d)]) for a, b, c, d in product(range(-2, 3), repeat=4) if abs(a * d - b * c) == 1
]
STUDY = """
material = "aluminium-7075"
[cell]
{}
thickness = "1.5 mm"
[cell.pillar]
diameter = "3 mm"
height = "5 mm"
"""


def by_vectors(lattice: Lattice, basis=((1, 0), (0, 1))) -> Lattice:
    a1, a2 = np.array(basis) @ lattice.vectors
    return Lattice(a1=tuple(a1), a2=tuple(a2))


@given(lattices(), st.sampled_from(BASES))
def test_vectors_have_zone_path_and_symmetry_of_the_name(named, basis):
    lattice = by_vectors(named, basis)
    assert lattice.named.named is lattice.named
    assert lattice.pitch == pytest.approx(named.pitch, rel=1e-9)
    if lattice.name != named.name:  # a rectangle whose sides are equal by chance is a square, and so on
        assert len(lattice.point_group) > len(named.point_group)
        return
    assert lattice.area == pytest.approx(named.area, rel=1e-9)
    assert len(lattice.point_group) == len(named.point_group)
    mine, other = (IrreducibleZone.of(each, each.point_group) for each in (lattice, named))
    assert [label for label, _ in mine.corners] == [label for label, _ in other.corners]
    walked, meant = mine.path(40), other.path(40)
    assert lattice.wavevector(walked.kappa) * named.pitch == pytest.approx(
        named.wavevector(meant.kappa) * named.pitch, abs=1e-6
    )


@given(lattices(), st.sampled_from(BASES), st.tuples(st.floats(0, 0.999), st.floats(0, 0.999)))
def test_sites_count_in_the_vectors_that_were_given(named, basis, at):
    lattice = by_vectors(named, basis)
    place, vectors = lattice.counted(np.array(at)) @ lattice.vectors, np.array(basis) @ named.vectors
    steps = np.linalg.solve(vectors.T, place - np.array(at) @ vectors)
    assert steps == pytest.approx(np.round(steps), abs=1e-6)


def test_a_honeycomb_in_vectors_120_degrees_apart_is_one():
    """In vectors 60 degrees apart these shares are other places: a third of the pitch from each other."""
    lattice = Lattice(a1=("7 mm", "0 mm"), a2=("-3.5 mm", "6.0622 mm"))
    pillar = Pillar(2e-3, 3e-3)
    sites = tuple(Site(at=at, pillar=pillar) for at in (("1/3", "2/3"), ("2/3", "1/3")))
    cell = UnitCell(lattice, 1.5e-3, ALUMINIUM, site=sites)
    named = UnitCell(Lattice(lattice="honeycomb", pitch=7e-3), 1.5e-3, ALUMINIUM, pillar)
    assert len(cell.point_group) == len(named.point_group) == 12
    assert sorted(cell.shares.round(9).tolist()) == sorted(named.shares.round(9).tolist())


def test_a_study_with_vectors_comes_back_as_it_was():
    study = loads(STUDY.format('a1 = ["7 mm", "0 mm"]\na2 = ["3.5 mm", "6 mm"]'))
    lattice = study.cell.lattice
    assert (lattice.name, lattice.pitch, lattice.named.pitch_y) == ("centred", 7e-3, pytest.approx(12e-3))
    assert 'a1 = ["7 mm", "0 m"]' in study.to_toml()
    assert loads(study.to_toml()) == study
    changed = study.cell.with_numbers({"cell.a2[2]": 6.5e-3})
    assert changed.lattice.named.pitch_y == pytest.approx(13e-3)
    assert study.cell.scaled(2.0).lattice.vectors == pytest.approx(2.0 * lattice.vectors)


@pytest.mark.parametrize("height", ["6.062 mm", "6.0622 mm"])
def test_four_digits_of_a_root_are_a_triangular_lattice(height):
    assert len(Lattice(a1=("7 mm", "0 mm"), a2=("3.5 mm", height)).point_group) == 12
    assert len(Lattice(a1=("7 mm", "0 mm"), a2=("3.5 mm", "6.07 mm")).point_group) == 4


@pytest.mark.parametrize(
    ("text", "code", "key", "words"),
    [
        ('a1 = ["7 mm", "0 mm"]', "missing", "cell.a2", "spans no lattice"),
        ('a1 = ["0 mm", "0 mm"]\na2 = ["7 mm", "0 mm"]', "out-of-range", "cell.a1", "length zero"),
        ('a1 = ["7 mm", "0 mm"]\na2 = ["7 mm", "5 um"]', "out-of-range", "cell.a2", "nearly"),
        ('a1 = ["7 mm", "0 mm"]\na2 = ["-7 mm", "0 mm"]', "out-of-range", "cell.a2", "parallel"),
        ('a1 = ["7 mm", 0]\na2 = [0, "7 mm"]\npitch = "7 mm"', "conflict", "cell.pitch", "remove pitch"),
        ('a1 = ["7 mm", 0]\na2 = [0, "7 mm"]\nlattice = "square"', "conflict", "cell.lattice", "twice"),
        ('a1 = ["5 mm", "5 mm"]\na2 = ["-5 mm", "5 mm"]', "unsupported", "cell.a1", '["7.07107 mm", "0 mm"]'),
        ('a1 = ["7 mm", "1.3 mm"]\na2 = ["1.7 mm", "6 mm"]', "unsupported", "cell.a1", "rotated"),
        ('a1 = ["7 mm", "0 mm"]\na2 = ["1 um", "6 mm"]', "out-of-range", "cell.a1", "so short a side"),
        ('a1 = ["7 mm", 0]\na2 = ["0.1 mm", "8 m"]', "out-of-range", "cell.a1", "ratio"),
        ('a1 = 7\na2 = [0, "7 mm"]', "malformed", "cell.a1", "not a list"),
        ('lattice = "trianglar"\npitch = "7 mm"', "unknown", "cell.lattice", 'write "triangular"'),
        ('lattice = "triangular"', "missing", "cell.pitch", "left out"),
    ],
)  # fmt: skip
def test_what_spans_no_lattice_is_refused(text, code, key, words):
    with refusing(StudyError, code, key, words):
        loads(STUDY.format(text))


def test_refusals_from_python_name_the_cell():
    with refusing(GeometryError, "out-of-range", "cell.a2", "parallel"):
        Lattice(a1=(7e-3, 0.0), a2=(14e-3, 0.0))


SWEEP = '\n[[sweep]]\nvary = "{}"\nfrom = "{}"\nto = "{}"\nsteps = 3\n'
VECTORS = STUDY.format('a1 = ["7 mm", "0 mm"]\na2 = ["3.5 mm", "6 mm"]')
SITES = """
[[cell.site]]
at = [0, 0]
pillar = { diameter = "2 mm", height = "5 mm" }
[[cell.site]]
position = ["3 mm", "3.5 mm"]
"""


def swept(text: str) -> list[UnitCell]:
    study = loads(text)
    return [design.cell for design in study.designs(study.sweep_settings[0])]


def test_a_sweep_of_a_vector_meets_the_lattices_of_a_sweep_by_name():
    """The height of a centred rectangle is twice that of the vector; a vector moved aside is a shear."""
    by_name = STUDY.format('lattice = "centred"\npitch = "7 mm"\npitch_y = "12 mm"')
    named = swept(by_name + SWEEP.format("cell.pitch_y", "11 mm", "13 mm"))
    cells = swept(VECTORS + SWEEP.format("cell.a2[2]", "5.5 mm", "6.5 mm"))
    for cell, other in zip(cells, named, strict=True):
        assert cell.lattice.vectors == pytest.approx(other.lattice.vectors, abs=1e-12)
    sheared = swept(VECTORS + SWEEP.format("cell.a2[1]", "0 mm", "3.5 mm"))
    assert [cell.lattice.name for cell in sheared] == ["rectangular", "oblique", "centred"]
    assert [cell.area for cell in sheared] == pytest.approx([42e-6] * 3)


def test_a_sweep_moves_a_site():
    sites = STUDY.format('pitch = "7 mm"').split("[cell.pillar]")[0] + SITES
    moved = swept(sites + SWEEP.format("cell.site[2].position[1]", "3 mm", "4 mm"))
    assert [cell.shares[1, 0] for cell in moved] == pytest.approx([3 / 7, 3.5 / 7, 4 / 7])


@pytest.mark.parametrize("table", ["design.vary", "tolerance.of"])
@pytest.mark.parametrize("path", ["cell.a1[1]", "cell.a2", "cell.site[2].at[1]", "cell.site[1].position[2]"])
def test_designs_and_tolerances_keep_the_symmetry_and_name_the_way(table, path):
    rest = "from = 1\nto = 2" if table == "design.vary" else "spread = 1"
    with refusing(StudyError, "unsupported", f"{table}[1].parameter", "cell.pitch_2 and cell.angle"):
        loads(f'{VECTORS}\n[[{table}]]\nparameter = "{path}"\n{rest}\n')


@pytest.mark.parametrize(
    ("path", "words"),
    [("cell.a2[0]", "count from 1"), ("cell.a2[3]", 'write "cell.a2[2]"'), ("cell.a2", 'write "cell.a2[1]"')],
)
def test_a_coordinate_that_does_not_exist_is_refused(path, words):
    with refusing(StudyError, "unknown", "sweep[1].vary", words):
        loads(VECTORS + SWEEP.format(path, "5 mm", "6 mm"))


def test_the_examples_of_both_keys_span_a_lattice():
    lines = [example_at(table(UnitCell, "cell.")[f"cell.{key}"]) for key in ("a1", "a2")]
    assert loads(STUDY.format("\n".join(lines))).cell.lattice.name == "centred"
