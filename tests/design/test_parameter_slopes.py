"""Designs and tolerances of a named parameter: its numbers move together, with exact slopes."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from five_parts import refused
from haptonic.analyses.design import brief as brief_of
from haptonic.bloch.exact import exact_modes
from haptonic.bloch.pencil import bloch_pencil, eigenpairs
from haptonic.cell import MeshPlan
from haptonic.design.quick import QuickDesign
from haptonic.design.sensitivity import sensitivity
from haptonic.design.spread_designs import deviations, samples
from haptonic.study import loads
from haptonic.study.named import links_of
from haptonic.superelement import TiledMesh

A = "parameters.a"
KAPPA, BAND = np.array((1.3, 0.4)), 4
TEXT = """
carrier = "60 kHz"
[parameters]
a = "7 mm"
d = "0.5*a"
stiff = "70 GPa"
[material]
youngs_modulus = "stiff"
poisson_ratio = 0.33
density = "2700 kg/m^3"
[cell]
pitch = "a"
thickness = "1.5 mm"
[cell.pillar]
diameter = "d"
height = "2.1*a"
"""
SCALED = TEXT.replace('"1.5 mm"', '"1.5*a/7"')
UNEVEN = TEXT.replace('"stiff"', '"stiff*sqrt(a/(7 mm))"').replace("0.33", '"0.33*(a/(7 mm))**0.5"').replace(
    '"2700 kg/m^3"', '"1700 kg/m^3 + 1000 kg/m^3*a/(7 mm)"'
)  # fmt: skip
DISCS = """
[[cell.disc]]
diameter = "d"
high = "4 mm"
[[cell.disc]]
diameter = "d + 1 mm"
low = "4 mm"
high = "a - 1 mm"
"""
CAPPED = TEXT[: TEXT.index("[cell.pillar]")] + DISCS
SPREAD = '[[tolerance.of]]\nparameter = "parameters.a"\nspread = "20 um"\n'
DENSITY = '[[tolerance.of]]\nparameter = "material.density"\nspread = "20 kg/m^3"\n'
VARY = '[[design.vary]]\nparameter = "parameters.a"\nfrom = "0.8*a"\nto = "9 mm"\n'
THICKNESS = '[[design.vary]]\nparameter = "cell.thickness"\nfrom = "1.2 mm"\nto = "2 mm"\n'


@cache
def start(text):
    study = loads(text + SPREAD)
    plan = replace(MeshPlan.suited(study.cell, 2, 1), order=2)
    shared = TiledMesh.of(study.cell, [plan])
    guess = np.sqrt(
        eigenpairs(bloch_pencil(shared.condensed(2, 6, measured=False)), KAPPA, BAND + 1)[0][BAND]
    )
    return study, plan, shared, exact_modes(shared, KAPPA, float(guess))


@cache
def slope_of(text):
    study, _, shared, modes = start(text)
    links = links_of(study)
    result = sensitivity(shared, modes, [A], links.directions({A: float(links.own(A))}))
    return float(result.slopes[A][0])


def hertz(text, value):
    """Frequency of the same mesh for another value of the parameter, without any slope."""
    study, plan, _, modes = start(text)
    shared = TiledMesh.of(study.with_parameter(A, value).cell, [plan])
    return exact_modes(shared, KAPPA, modes.omega).omega / (2 * np.pi)


@pytest.mark.parametrize("text", [TEXT, UNEVEN, CAPPED], ids=["sizes", "constants too", "discs"])
def test_slopes_are_those_of_exact_frequencies(text):
    step = 2e-5 * 7e-3
    ahead, behind, far, near = (hertz(text, 7e-3 + k * step) for k in (1, -1, 2, -2))
    expected = (8 * (ahead - behind) - (far - near)) / (12 * step)
    assert slope_of(text) == pytest.approx(expected, rel=3e-6)


def test_a_scaled_cell_has_the_slope_of_its_size():
    """All lengths are proportional to a, so that every frequency is proportional to 1/a."""
    _, _, _, modes = start(SCALED)
    assert slope_of(SCALED) == pytest.approx(-modes.omega / (2 * np.pi) / 7e-3, rel=1e-8)


def test_slopes_of_the_search_are_sums_over_the_numbers():
    """The chain rule, with the slope of each number alone."""
    study = loads(UNEVEN + VARY)
    brief = brief_of(study)
    share = brief.share(study.cell)
    (moving,) = brief.directions(share).values()
    assert moving.keys() == {
        "cell.pitch", "cell.pillar.diameter", "cell.pillar.height", "material.youngs_modulus",
        "material.poisson_ratio", "material.density",
    }  # fmt: skip
    quick = QuickDesign.of(brief.at(share), 8)
    together = quick.sides(6, [A], {A: moving})
    apart = quick.sides(6, list(moving))
    for side, each in zip(together, apart, strict=True):
        assert side.slopes[:, 0] == pytest.approx(each.slopes @ list(moving.values()), rel=1e-6)


def test_designs_of_a_brief_are_those_of_the_study():
    study = loads(TEXT + VARY + THICKNESS)
    brief = brief_of(study)
    assert brief.bounds == {A: (5.6e-3, 9e-3), "cell.thickness": (1.2e-3, 2e-3)}
    values = {A: 8e-3, "cell.thickness": 1.6e-3}
    assert brief.made(values) == study.with_parameters(values).cell
    assert brief.made(values).pillar.diameter == 4e-3
    assert brief.values(brief.share(study.cell)) == pytest.approx([7e-3, 1.5e-3])
    assert [brief.links.unit(path) for path in brief.paths] == ["m", "m"]


def test_samples_of_a_tolerance_are_those_of_the_study():
    study = loads(TEXT + SPREAD + DENSITY)
    spreads = study.tolerance_settings.of
    assert [spread.unit for spread in spreads] == ["m", "kg/m^3"]
    assert [spread.is_machined for spread in spreads] == [True, False]
    rows = deviations(spreads, 16)
    for (length, density), cell in zip(rows, samples(study.cell, spreads, 16, links_of(study)), strict=True):
        changed = study.with_parameters({A: 7e-3 + length, "material.density": 2700 + density})
        assert cell == changed.cell


FIRST = "design.vary[1].parameter"
REFUSED = {
    "an unknown one": ((VARY, VARY.replace("parameters.a", "parameters.q")), "unknown", FIRST),
    "another unit": ((VARY, VARY.replace("9 mm", "9 kHz")), "mismatch", "design.vary[1].to"),
    "a plain spread": ((VARY, SPREAD.replace('"20 um"', "2e-5")), "mismatch", "tolerance.of[1].spread"),
    "a number too": ((VARY, VARY + THICKNESS.replace("thickness", "pitch")), "conflict", FIRST),
    "one that uses it": ((VARY, VARY + VARY.replace("parameters.a", "parameters.d")), "conflict", FIRST),
    "the carrier": (('"60 kHz"', '"60 kHz*(7 mm)/a"'), "conflict", FIRST),
    "a limit of the search": ((VARY, f'[design]\ntool = "a/7"\n{VARY}'), "conflict", FIRST),
    "nothing that follows": ((VARY, VARY.replace("parameters.a", "parameters.b")), "conflict", FIRST),
    "a turn": (
        ('height = "2.1*a"', 'height = "2.1*a"\nsection = "square"\nturn = "10 deg*a/(7 mm)"'),
        "conflict",
        FIRST,
    ),
    "no designs": ((VARY, VARY.replace('"9 mm"', '"990 m"')), "out-of-range", "design.vary[1].to"),
    "per pillar": ((VARY, f'{SPREAD}per = "pillar"\n'), "conflict", "tolerance.of[1].per"),
}


@pytest.mark.parametrize(("change", "code", "argument"), REFUSED.values(), ids=REFUSED)
def test_refused(change, code, argument):
    text = TEXT.replace("[material]", 'b = "3 mm"\n[material]') + VARY
    refused(lambda: loads(text.replace(*change)), code=code, argument=argument)


def test_discs_keep_the_order_of_their_borders():
    """A border that two discs share by value parts if only one of them follows the parameter."""
    text = CAPPED.replace('"d + 1 mm"', '"3.5 mm"')
    loads(text)
    refused(lambda: loads(text + SPREAD), code="conflict", argument="tolerance.of[1].parameter")
    loads(text.replace('"3.5 mm"', '"d"') + SPREAD)
