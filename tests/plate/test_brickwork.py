"""Plates that hold lattices whose rows are offset, or of several pillars: laid in bricks."""

from itertools import product

import full
import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from small import LOSS
from test_full_plate import SAME, modes
from whole import answered

from bricks import ALUMINIUM, CELLS, PITCH, THICKNESS, THIN, laid
from five_parts import assert_explained
from haptonic.cell import Brickwork, Pillar, UnitCell
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice
from haptonic.plate.body.model import PlateModel
from haptonic.plate.layout.parts import Force, Plate
from haptonic.plate.layout.supports import Support

LONG = [
    pytest.param(name, marks=pytest.mark.nightly)
    for name in ("askew", "thirds", "kagome", "lieb", "honeycomb")
]


@pytest.mark.parametrize("name", CELLS)
def test_pillars_are_at_lattice_points_and_bricks_fill_the_layout(name):
    """Every two pillars differ by a lattice vector and the way from site to site; none is missing inside."""
    cell = CELLS[name]
    layout = laid("pppppp pooooo pooooo pooooo pooooo pppppp", cell)
    vectors, sites = cell.lattice.vectors, cell.shares
    here = np.array([(x, y) for x, y, _ in layout.standing])
    numbers = {
        pillar: [k for k, other in enumerate(cell.pillars) if other == pillar] for pillar in cell.pillars
    }
    origin = None
    for number in numbers[layout.standing[0][2]]:
        shares = (here - here[0]) @ np.linalg.inv(vectors) + sites[number]
        fits = [
            any(np.abs((share - sites[k]) - np.round(share - sites[k])).max() < 1e-6 for k in numbers[pillar])
            for share, (_, _, pillar) in zip(shares, layout.standing, strict=True)
        ]
        if all(fits):
            origin = here[0] - sites[number] @ vectors
    assert origin is not None, "one of the sites is where the first pillar is"
    # all points of the lattice that are a period of its rows away from the border of the lattice's letters
    work = Brickwork.of(cell)
    size, away = np.array([work.width, work.height]), np.array([0, 1] if work.offset[1] else [1, 0])
    low, high = size * (1 + away), size * ([6, 5] - away)
    expected = [
        place
        for k, m, n in product(range(len(sites)), range(-12, 13), range(-12, 13))
        if cell.pillars[k] is not None
        for place in [origin + (sites[k] + (m, n)) @ vectors]
        if (place > low).all() and (place < high).all()
    ]
    away = np.linalg.norm(np.array(expected)[:, None] - here, axis=2).min(axis=1)
    assert len(expected) >= 8
    assert away.max() < 1e-9
    covered = sum(np.ptp(x) * np.ptp(y) for x, y in map(layout.lines, layout.blocks))
    assert covered == pytest.approx(layout.x[-1] * layout.y[-1])
    assert layout.left_out == {"square": 0, "rectangular": 0}.get(name, layout.left_out)
    assert len(layout.standing) + layout.left_out == 20 * sum(pillar is not None for pillar in cell.pillars)


def test_a_lattice_of_which_nothing_fits_is_plain_plate():
    """A single letter of an offset row."""
    layout = laid("ppp opp ppp", CELLS["triangular"])
    assert not layout.standing
    assert layout.left_out == 1
    assert all(layout.is_plain(tile) for tile in layout.of("o"))
    assert len(PlateModel.of(Plate(layout), 20e3, SAME).assembly.skeleton.blocks) <= len(layout.blocks)


@pytest.mark.parametrize("name", ["triangular", *LONG])
def test_modes_are_those_of_the_meshes_glued_together(name):
    plate = Plate(
        laid("ooo" if name == "askew" else "oo oo", CELLS[name]),
        supports=(Support("left", "clamped"),),
        loss_factor=LOSS,
    )
    exact = full.frequencies(full.full(plate, 2, 0, 3), 10, 10e3, full.quickly_factorised)
    frequencies = modes(PlateModel.of(plate, 60e3, SAME), 0.99 * exact[0], 1.003 * exact[-1])
    assert len(frequencies) == len(exact)
    assert (frequencies > exact * (1 - 1e-8)).all(), "Rayleigh-Ritz never falls below"
    assert frequencies == pytest.approx(exact, rel=3e-4)


def test_a_plate_turned_by_a_right_angle_has_the_same_modes():
    """Rows along x, and the map transposed with rows along y: meshes and frequencies agree to rounding."""
    results = []
    for name, text, held in (("triangular", "ooo ooo", "left"), ("upright", "oo oo oo", "bottom")):
        layout = laid(text, CELLS[name])
        plate = Plate(layout, supports=(Support(held, "clamped"),), loss_factor=LOSS)
        results.append((layout, modes(PlateModel.of(plate, 60e3, SAME), 1e3, 12e3)))
    (lying, below), (standing, above) = results
    assert (lying.x, lying.y) == (pytest.approx(standing.y), pytest.approx(standing.x))
    turned = sorted((y, x) for x, y, _ in lying.standing)
    assert np.array(turned) == pytest.approx(np.array(sorted((x, y) for x, y, _ in standing.standing)))
    assert len(below) >= 5
    assert above == pytest.approx(below, rel=1e-9)


def test_rows_lie_where_they_leave_pillars_more_room():
    """A honeycomb's along y, where its pillars are not next to each other in two rows."""
    for name, along_y in (("triangular", False), ("upright", True), ("honeycomb", True), ("kagome", False)):
        assert bool(Brickwork.of(CELLS[name]).offset[1]) is along_y
    assert Brickwork.of(CELLS["honeycomb"]).room == pytest.approx(0.25 * PITCH)


@pytest.mark.nightly
@pytest.mark.parametrize("name", ["triangular", "askew"])
def test_a_force_on_a_brick_is_answered_as_by_the_meshes(name):
    layout = laid("oo oo" if name == "triangular" else "oo", CELLS[name])
    where = (layout.standing[2][0] + 1e-3, layout.standing[2][1] - 1e-3)
    plate = Plate(
        layout, supports=(Support("left", "clamped"),), forces=(Force("F", where),), loss_factor=LOSS
    )
    whole, model, omega = full.full(plate, 2, 0, 3), PlateModel.of(plate, 40e3, SAME), 2 * np.pi * 17.8e3
    exact = full.answer_by_iteration(whole, whole.drive["F"], omega)
    ours = answered(model, {"F": 1.0}, [omega])[:, 0]
    assert model.drives["F"] @ ours == pytest.approx(whole.drive["F"] @ exact, rel=1e-2)
    places = np.random.default_rng(4).uniform(0, 1, (40, 2)) * (layout.x[-1], layout.y[-1])
    seen = whole.observed(places) @ exact
    assert np.linalg.norm(model.observed(places) @ ours - seen) < 1e-2 * np.linalg.norm(seen)


@given(
    st.sampled_from(["triangular", "honeycomb", "kagome", "lieb", "oblique", "centred"]),
    st.floats(0.05, 0.6),
    st.floats(0.4, 2.0),
    st.floats(0.4, 2.6),
)
@settings(max_examples=60, deadline=None)
def test_any_lattice_is_laid_or_refused_in_five_parts(name, wide, second, angle):
    further = {"oblique": {"pitch_2": second * PITCH, "angle": angle}, "centred": {"pitch_y": second * PITCH}}
    try:
        lattice = Lattice(lattice=name, pitch=PITCH, **further.get(name, {}))
        cell = UnitCell(lattice, THICKNESS, ALUMINIUM, Pillar(wide * PITCH, 9e-3))
    except GeometryError:
        return
    try:
        layout = laid("oop ooo", cell)
    except GeometryError as error:
        refused = error
    else:
        refused = None
    if refused is not None:
        assert refused.code in {"unsupported", "out-of-range"}
        assert_explained(refused)
        return
    for (x, y, pillar), (corner, laid_there) in zip(layout.standing, layout.bricks.items(), strict=True):
        (left, *_, right), (low, *_, top) = layout.lines(layout.block(corner))
        assert min(x - left, right - x, y - low, top - y) > pillar.radius
        assert layout.brick("o", laid_there.number).area == pytest.approx((right - left) * (top - low))


REFUSED = {
    "rows that lie askew": (
        Lattice.oblique(PITCH, 0.9 * PITCH, 1.2), (), "cell.lattice", "offset by",
    ),
    "a pillar across the line": (Lattice.triangular(PITCH), (), "cell.pillar.diameter", "less than 5.9"),
    "sites that do not line up": (
        Lattice.square(PITCH),
        tuple({"at": at, "pillar": THIN} for at in ((0.0, 0.0), (0.37, 0.5))), "plate.map", "do not meet",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_laid_is_refused(name):
    lattice, sites, argument, words = REFUSED[name]
    pillar = None if sites else Pillar(0.86 * PITCH if "across" in name else 2e-3, 9e-3)
    cell = UnitCell(lattice, THICKNESS, ALUMINIUM, pillar, site=sites)
    with pytest.raises(GeometryError) as caught:
        laid("oop ooo", cell)
    assert_explained(caught.value, words, argument=argument)
