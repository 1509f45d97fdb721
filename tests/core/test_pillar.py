"""The pillar family: volumes, fillets and refusals against an outline of lines and circles."""

import math
import re
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given, strategies as st
from outlines import EXTREMES, arc_top, outline, pillars, side
from scipy.integrate import quad

from each import each
from five_parts import refusing
from haptonic.cell import Pillar, Step
from haptonic.errors import GeometryError

extremes = pytest.mark.parametrize("pillar", EXTREMES.values(), ids=EXTREMES)
MM = 1e-3
PLAIN = Pillar(3 * MM, 9 * MM)
STEPPED = replace(PLAIN, step=Step(2 * MM, 4 * MM))
FILLETED = Pillar(3 * MM, 9 * MM, fillet=0.5 * MM)


def integrated(pillar: Pillar) -> float:
    """Volume, by adaptive quadrature over the height of the sections' areas."""
    share = math.pi if pillar.section == "round" else 4.0
    borders = [0.0, arc_top(pillar), *([pillar.step.height] if pillar.step else []), pillar.height]
    total = 0.0
    for low, high in pairwise(borders):
        # u^2 from the foot makes the arc smooth there; the border itself belongs to what is below it
        def area(u, low=low, high=high):
            z = low + (high - low) * min(u * u, 1 - 1e-15)
            return 2 * u * (high - low) * share * outline(pillar, z) ** 2

        total += quad(area, 0.0, 1.0, epsabs=0.0, epsrel=1e-11)[0] if high > low else 0.0
    return total


@extremes
def test_volume_is_the_integral_of_the_outline(pillar):
    assert pillar.volume == pytest.approx(integrated(pillar), rel=1e-9)


@given(pillars())
def test_volume_is_the_integral_of_the_outline_for_any_member(pillar):
    assert pillar.volume == pytest.approx(integrated(pillar), rel=1e-9)


def test_volumes_by_hand():
    assert Pillar(2.0, 3.0).volume == pytest.approx(3 * math.pi)
    assert Pillar(2.0, 3.0, "square").volume == pytest.approx(12)
    # frustum: pi h / 3 (1 + 1/2 + 1/4)
    assert Pillar(2.0, 2.0, draft=math.atan(0.25)).volume == pytest.approx(math.pi * 7 / 6)
    assert Pillar(2.0, 3.0, step=Step(1.0, 1.0)).volume == pytest.approx(math.pi * (1 + 0.25 * 2))
    # Pappus: what a quarter circle leaves of its square, (1 - pi/4) r^2, with its centre of mass
    # (10 - 3 pi) / (12 - 3 pi) r away from the sides that it touches
    r = 0.5
    away = 1 + r * (10 - 3 * math.pi) / (12 - 3 * math.pi)
    ring = 2 * math.pi * away * (1 - math.pi / 4) * r**2
    assert Pillar(2.0, 3.0, fillet=r).volume == pytest.approx(3 * math.pi + ring)


filleted = pytest.mark.parametrize(
    "pillar", [p for p in EXTREMES.values() if p.fillet], ids=[n for n, p in EXTREMES.items() if p.fillet]
)


@filleted
def test_a_fillet_touches_the_plate_and_the_side(pillar):
    arc, size = pillar.arc, pillar.fillet
    first, last = arc.at(0.0), arc.at(1.0)
    assert first[1] == pytest.approx(0.0, abs=1e-14 * size)
    assert last[0] == pytest.approx(side(pillar, last[1]), rel=1e-13)
    step = 1e-5
    along = arc.at(step) - arc.at(0.0)
    assert abs(along[1]) < step * abs(along[0]), "level where it leaves the plate"
    up = arc.at(1.0) - arc.at(1.0 - step)
    assert -up[0] / up[1] == pytest.approx(math.tan(pillar.draft), abs=2 * step), "no kink at the side"
    points = arc.at(np.linspace(0, 1, 50))
    assert np.hypot(*(points - arc.centre).T) == pytest.approx(np.full(50, size), rel=1e-12)
    assert (np.diff(points[:, 1]) > 0).all(), "it rises all the way"
    assert all(w >= side(pillar, z) - 1e-12 * size for w, z in points)
    assert [w for w, _ in points] == pytest.approx([outline(pillar, z) for _, z in points], rel=1e-6)


def test_a_sharp_foot_has_no_arc():
    assert PLAIN.arc is None
    assert PLAIN.is_cylinder
    others = (STEPPED, FILLETED, replace(PLAIN, draft=0.01), replace(PLAIN, section="square"))
    assert not any(other.is_cylinder for other in others)


@given(pillars())
def test_widest_and_narrowest_are_those_of_the_outline(pillar):
    at_step = [pillar.step.height * share for share in (1 - 1e-12, 1)] if pillar.step else []
    heights = [*np.linspace(0.0, pillar.height, 401), *at_step]
    widths = [outline(pillar, z) for z in heights]
    assert pillar.widest == pytest.approx(max(widths), rel=1e-9)
    # the straight sides alone: a fillet takes nothing away, and may cover the narrowest place of an undercut
    sides = [side(pillar, z) for z in heights]
    assert pillar.narrowest == pytest.approx(min(sides), rel=1e-9)
    assert 0.05 * pillar.radius <= pillar.narrowest


@given(pillars(), st.floats(1e-4, 1e2))
def test_scaling_multiplies_every_length_and_no_angle(pillar, factor):
    larger = pillar.scaled(factor)
    assert (larger.draft, larger.section) == (pillar.draft, pillar.section)
    assert larger.diameter == factor * pillar.diameter
    assert larger.height == factor * pillar.height
    assert larger.fillet == factor * pillar.fillet
    assert (larger.step is None) == (pillar.step is None)
    if pillar.step:
        assert larger.step == Step(factor * pillar.step.diameter, factor * pillar.step.height)
    assert larger.volume == pytest.approx(factor**3 * pillar.volume, rel=1e-12)


REFUSED = {
    "no width": (PLAIN, {"diameter": 0.0}, "diameter"),
    "infinite height": (PLAIN, {"height": math.inf}, "height"),
    "no number": (PLAIN, {"height": math.nan}, "height"),
    "step's sign": (PLAIN, {"step": {"diameter": -2 * MM, "height": 4 * MM}}, "step.diameter"),
    "step in the plate": (PLAIN, {"step": {"diameter": 2 * MM, "height": 0.0}}, "step.height"),
    "section": (PLAIN, {"section": "hexagonal"}, "section"),
    "no angle": (PLAIN, {"draft": math.nan}, "draft"),
    "degrees": (PLAIN, {"draft": 2.0}, "draft"),
    "fillet's sign": (PLAIN, {"fillet": -0.1 * MM}, "fillet"),
    "no radius": (PLAIN, {"fillet": math.nan}, "fillet"),
    "step above the top": (PLAIN, {"step": Step(2 * MM, 9 * MM)}, "step.height"),
    "step outwards": (PLAIN, {"step": Step(3.1 * MM, 4 * MM)}, "step.diameter"),
    "hardly a step": (PLAIN, {"step": Step(2.9 * MM, 4 * MM)}, "step.diameter"),
    "wider than the cone": (replace(PLAIN, draft=0.1), {"step": Step(2.2 * MM, 4 * MM)}, "step.diameter"),
    "needle": (PLAIN, {"step": Step(0.1 * MM, 4 * MM)}, "step.diameter"),
    "pointed": (PLAIN, {"draft": 0.17}, "draft"),
    "pointed above the step": (replace(PLAIN, step=Step(1 * MM, 4 * MM)), {"draft": 0.12}, "draft"),
    "pointed below the step": (STEPPED, {"draft": 0.4}, "draft"),
    "fillet over the top": (PLAIN, {"fillet": 7.3 * MM}, "fillet"),
    "fillet over the step": (STEPPED, {"fillet": 3.3 * MM}, "fillet"),
    "fillet on a cone": (replace(PLAIN, draft=0.1), {"fillet": 8.1 * MM}, "fillet"),
    "fillet of an undercut": (replace(PLAIN, draft=-0.1), {"fillet": 6.7 * MM}, "fillet"),
}  # fmt: skip


@each(("pillar", "change", "key"), REFUSED.values())
def test_refusals_name_the_key_in_five_parts(pillar, change, key):
    with pytest.raises(GeometryError) as refusal:
        replace(pillar, **change)
    parts = refusal.value.parts()
    assert parts.pop("code")
    assert parts.pop("argument") == f"cell.pillar.{key}"
    assert set(parts) == {"given", "allowed", "cause", "next_step"}
    assert all(len(text.strip()) > (2 if name == "given" else 3) for name, text in parts.items())
    assert f"cell.pillar.{key}: got {parts['given']}\n" in str(refusal.value)


LIMITS = [
    name for name in REFUSED if re.match("fillet (o|of an|on)|pointed|step (out|w)|hardly|needle", name)
]


@pytest.mark.parametrize("name", LIMITS)
def test_what_a_refusal_allows_is_the_border(name):
    """One part in a hundred inside of the number that is named makes a body, as much outside does not."""
    pillar, change, key = REFUSED[name]
    with pytest.raises(GeometryError) as refusal:
        replace(pillar, **change)
    allowed = refusal.value.allowed
    number, unit = re.search(r"(-?[\d.]+) (degrees|mm|um|µm)", allowed).groups()
    limit = float(number) * {"degrees": math.radians(1), "mm": MM}.get(unit, 1e-3 * MM)
    sign = +1 if "at least" in allowed else -1

    def there(value):
        if key.startswith("step."):
            step = pillar.step or change["step"]
            return replace(pillar, step=replace(step, **{key.removeprefix("step."): value}))
        return replace(pillar, **{key: value})

    there(limit * (1 + sign * 0.01))
    with refusing(GeometryError, "out-of-range", "", "cell.pillar."):  # a steeper side may leave no step
        there(limit * (1 - sign * 0.01))


@given(pillars())
def test_a_step_needs_to_be_a_step(pillar):
    assume(pillar.step is not None)
    below = 2 * side(replace(pillar, step=None, fillet=0.0), pillar.step.height)
    with refusing(GeometryError, "out-of-range", "cell.pillar.step.diameter"):
        replace(pillar, fillet=0.0, step=replace(pillar.step, diameter=0.96 * below))


class _Waisted(Pillar):
    """A body with a number that no other has: reports on a pillar follow its widths at all heights."""

    def half_width(self, height: float, stage: int) -> float:
        share = height / self.height
        return super().half_width(height, stage) * (1 - 0.4 * share * (1 - share))


@pytest.mark.parametrize(
    ("pillar", "is_prism"),
    [
        (Pillar(3.5e-3, 14e-3), True),
        (Pillar(3.5e-3, 14e-3, section="square", fillet=0.3e-3), True),
        (Pillar(3.5e-3, 14e-3, draft=math.radians(-1)), False),
        (Pillar(3.5e-3, 14e-3, step=Step(2e-3, 7e-3)), False),
        (_Waisted(3.5e-3, 14e-3), False),
    ],
)
def test_a_prism_has_a_constant_width(pillar, is_prism):
    assert pillar.is_prism is is_prism


def test_a_waist_between_equal_ends_counts():
    straight, waisted = (kind(3e-3, 8e-3) for kind in (Pillar, _Waisted))
    assert waisted.broadest == straight.broadest
    assert waisted.narrowest == pytest.approx(0.9 * straight.narrowest)
    # integral of (1 - 0.4 s (1 - s))^2 over s from 0 to 1
    assert waisted.volume / straight.volume == pytest.approx(1 - 0.8 / 6 + 0.16 / 30)
