"""Every analysis answers for every feature of a cell, or refuses it in five parts: none leaves one out."""

from dataclasses import replace
from importlib import import_module
from types import SimpleNamespace

import numpy as np
import pytest

from five_parts import assert_explained, refusing
from haptonic.analyses import NAMES
from haptonic.analyses.export import ExportOptions
from haptonic.cell import Disc, Pillar, Site, Solid, UnitCell
from haptonic.cell.outlines import SECTIONS, taken_by
from haptonic.cell.pillar_parts import Corner
from haptonic.errors import StudyError
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.study import Study
from stacks import DRAFTED, STACKS

MM = 1e-3
NUMBERS = {
    "length": 2 * MM,
    "arm_width": 1 * MM,
    "sides": 5,
    "corner_radius": 0.2 * MM,
    "turn": 0.3,
    "point": tuple(Corner(x=x, y=y) for x, y in ((1, -1), (1, 1), (-1, 0.8), (-0.8, -1))),
}
SQUARE, TRIANGULAR = Lattice.square(7 * MM), Lattice.triangular(7 * MM)


def cell(pillar, lattice=SQUARE, **more):
    return UnitCell(lattice, 1.5 * MM, material("aluminium-2017a"), pillar, **more)


def with_section(lattice, **numbers):
    """A cell with a pillar, or with a disc of the same height if its section bends inwards."""
    if "arm_width" not in numbers:
        return cell(Pillar(3 * MM, 6 * MM, **numbers), lattice)
    return cell(None, lattice, disc=(Disc(3 * MM, high=6 * MM, **numbers),))


def features():
    """Cells by the feature that each of them has."""
    yield "plain plate", cell(None)
    for name, kind in SECTIONS.items():
        needed = {number: NUMBERS[number] for number, must in taken_by(kind).items() if must}
        every = {number: NUMBERS[number] for number in taken_by(kind)}
        for lattice in (SQUARE, TRIANGULAR):
            yield f"{name} on {lattice.name}", with_section(lattice, section=name, **needed)
            if every != needed:
                with_all = with_section(lattice, section=name, **every)
                yield f"{name} with every number on {lattice.name}", with_all
    yield "pillars on both faces", cell(Pillar(3 * MM, 6 * MM), faces="both")


FEATURES = dict(features())
PLATES = {"plate", "simulate scan", "feel", "verdict"}
WITHOUT_SOLIDS = {"design", "tolerance", "export", "reproduce"}
ANALYSES = {name: import_module(f"haptonic.analyses.{name.replace(' ', '_')}").ANALYSIS for name in NAMES}


@pytest.mark.parametrize("feature", FEATURES)
def test_each_analysis_supports_every_section(feature):
    for name, analysis in ANALYSES.items():
        options = ExportOptions() if name == "export" else None
        assert analysis.supports(FEATURES[feature], options) is None, name


@pytest.mark.parametrize("faces", ["one", "both"])
@pytest.mark.parametrize("feature", STACKS | DRAFTED)
def test_each_analysis_answers_for_discs_or_refuses_them(feature, faces):
    """Only finite plates refuse discs: those that open their lower face."""
    discs = (STACKS | DRAFTED)[feature]
    of_sites = Site(disc=discs), Site()
    for each in (
        UnitCell(SQUARE, 1.5 * MM, material("aluminium-2017a"), disc=discs, faces=faces),
        UnitCell(
            Lattice(lattice="honeycomb", pitch=12 * MM), 1.5 * MM, material("aluminium-2017a"), site=of_sites
        ),
    ):
        refused = set()
        for name, analysis in ANALYSES.items():
            options = ExportOptions() if name == "export" else None
            refusal = analysis.supports(each, options)
            if refusal is not None:
                assert_explained(refusal, refusal.code, refusal.argument)
                refused.add(name)
        through = feature in ("hole", "countersunk hole", "square cone in a round hole")
        opens_below = through or (feature == "blind hole" and each.faces == "both")
        of_plates = PLATES if opens_below else set()
        assert refused - {"layers"} == of_plates


def test_each_analysis_answers_for_solids_or_refuses_them(tmp_path):
    """Sizes in a CAD file have no names, and its drawing is the file itself; plates have no holes below."""
    pytest.importorskip("ngsolve")
    from mesh_cells import hexahedra, write

    across, upward = np.array([-3.5, -1.5, 1.5, 3.5]), np.array([0.0, 1.5])
    whole = hexahedra(across, upward, lambda x, y, z: "plate")
    hole = hexahedra(across, upward, lambda x, y, z: "" if x == y == 0 else "plate")
    assert refusing_solids(write(tmp_path / "whole.vtu", *whole)) == WITHOUT_SOLIDS
    assert refusing_solids(write(tmp_path / "hole.vtu", *hole)) == WITHOUT_SOLIDS | PLATES


def refusing_solids(path):
    """Names of the analyses that refuse the solids of a file."""
    solids = cell(None, solid=Solid(file=str(path)))
    refused = {}
    for name, analysis in ANALYSES.items():
        options = ExportOptions() if name == "export" else None
        refusal = analysis.supports(solids, options)
        if refusal is not None:
            assert_explained(refusal, "unsupported", "cell.solid")
            refused[name] = refusal
    return set(refused)


def test_the_report_asks_each_analysis_as_well():
    """A chapter of what an analysis refuses is never computed."""
    from haptonic.analyses import reproduce

    asked = []
    refusing_one = replace(
        ANALYSES["sweep"],
        supports=lambda cell, options: StudyError.unsupported(
            argument="cell", given="a hole", allowed="none", cause="a test", next_step="none"
        ),
        compute=lambda *_: asked.append("computed"),
    )
    with refusing(StudyError, "unsupported", "cell"):
        reproduce._compute(refusing_one, SimpleNamespace(cell=cell(None)), None, None)
    assert asked == []


def test_an_analysis_requires_supports():
    with pytest.raises(TypeError, match="supports"):
        type(ANALYSES["bands"])(name="mute", result=object, compute=print)


def test_a_plan_lists_analyses_that_refuse_the_cell():
    losses = Pillar(3 * MM, 6 * MM, material=material("epoxy"))
    study = Study(cell=cell(losses), carrier=60e3)
    costs = ANALYSES["plan"].compute(study, None, None).costs
    assert_explained(costs["layers"].refusal, code="unsupported", argument="cell.pillar.material")
    assert costs["bands"].refusal is None
