"""The grammar of ``vary``: read like arithmetic, solved exactly, and never executed."""

import math
import re

import pytest
from hypothesis import assume, given, settings, strategies as st

from each import each
from five_parts import refusing
from haptonic.errors import StudyError
from haptonic.study import Study, loads
from haptonic.study.sweeps import numeric_parameters
from haptonic.study.vary import parse
from quick import PROTOTYPE

STUDY = loads(PROTOTYPE)
PARAMETERS = STUDY.parameters()
FREE = ["cell.thickness", "cell.pillar.height", "material.density", "material.youngs_modulus", "carrier"]

numbers = st.sampled_from(["2", "0.5", "1e3", "3.25", ".125", "7.", "1E-2"])


@st.composite
def expressions(draw):
    """An expression whose first name can be changed freely; that name occurs there once."""
    varied = draw(st.sampled_from(FREE))
    others = st.sampled_from([name for name in PARAMETERS if name != varied])
    before = draw(st.lists(numbers, max_size=2))
    after = draw(st.lists(numbers | others, max_size=4))
    space = draw(st.sampled_from(["", " ", "  "]))
    text = ""
    for factor in [*before, varied, *after]:
        operator = draw(st.sampled_from("*/")) if text else ""
        text += f"{space}{operator}{space}{factor}" if text else factor
    return text


def by_python(text, parameters):
    """Value of the same text as Python reads it."""
    for name in sorted(parameters, key=len, reverse=True):
        text = text.replace(name, f"({parameters[name]!r})")
    return eval(text)  # a text that this test wrote itself


ZEROS = {name for name, value in PARAMETERS.items() if value == 0}


def test_some_parameters_are_zero():
    assert {"cell.pillar.draft", "cell.pillar.fillet"} == ZEROS


@settings(deadline=None)
@given(expressions())
def test_value_is_that_of_ordinary_arithmetic(text):
    expression = parse(text)
    if any(name in ZEROS and power < 0 for name, power in expression.powers):
        with refusing(StudyError, "out-of-range", "sweep.vary"):
            expression.value(PARAMETERS)
        return
    cancelled = re.compile(rf"/\s*(?:{'|'.join(map(re.escape, ZEROS))})")
    assume(not cancelled.search(text))  # here 0 / 0 cancels, for Python it does not
    assert expression.value(PARAMETERS) == pytest.approx(by_python(text, PARAMETERS), rel=1e-12)


@settings(deadline=None)
@given(expressions(), st.floats(0.5, 2.0))
def test_solved_study_has_the_value_and_nothing_else_changed(text, factor):
    expression = parse(text)
    if ZEROS & dict(expression.powers).keys():
        with refusing(StudyError, "out-of-range", "sweep.vary"):
            STUDY.solved(expression, factor)
        return
    assume(not any(name in text for name in ZEROS))
    wanted = expression.value(PARAMETERS) * factor
    solved = STUDY.solved(expression, wanted)
    assert by_python(text, solved.parameters()) == pytest.approx(wanted, rel=1e-12)
    changed = {name for name, value in solved.parameters().items() if value != PARAMETERS[name]}
    assert changed <= {expression.varied}


@settings(deadline=None)
@given(st.floats(0.2, 0.9))
def test_the_first_name_varies(ratio):
    by_width = STUDY.solved(parse("cell.pillar.diameter / cell.pitch"), ratio)
    assert by_width.cell.pillar.diameter == pytest.approx(ratio * 0.007, rel=1e-15)
    assert by_width.cell.lattice.pitch == 0.007
    by_pitch = STUDY.solved(parse("1 / cell.pitch * cell.pillar.diameter"), ratio)
    assert by_pitch.cell.lattice.pitch == pytest.approx(0.0035 / ratio, rel=1e-15)
    assert by_pitch.cell.pillar.diameter == 0.0035


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("cell.pitch", "m"),
        ("2 * cell.pitch", "m"),
        ("cell.pillar.diameter / cell.pitch", ""),
        ("cell.pillar.height / cell.pitch * material.poisson_ratio", ""),
        ("cell.pillar.height * cell.pitch", "m^2"),
        ("cell.thickness / cell.pitch / cell.pitch", "m^-1"),
        ("material.density", "kg*m^-3"),
        ("1 / material.density", "kg^-1*m^3"),
        ("cell.thickness * carrier", "m*Hz"),
        # a pure number, though no unit cancels by name: density times speed squared over stiffness
        ("cell.pitch * cell.thickness * carrier * carrier * material.density / material.youngs_modulus", ""),
    ],
)
def test_unit_of_an_expression(text, unit):
    assert parse(text).unit(numeric_parameters()) == unit


def test_dimensional_sweep_reads_units(edited):
    text = edited(
        ("cell.pillar.height / cell.pitch", "material.youngs_modulus / material.density"),
        ("from = 1.0", 'from = "2e7 m^2/s^2"'),
        ("to = 3.0", 'to = "30 GPa*m^3/Mg"'),
    )
    study = loads(text)
    designs = study.designs(study.sweep_settings[1])
    assert designs[0].parameters()["material.youngs_modulus"] == pytest.approx(2e7 * 2700, rel=1e-14)
    assert designs[-1].parameters()["material.youngs_modulus"] == pytest.approx(3e7 * 2700, rel=1e-14)
    assert loads(study.to_toml()) == study


@each(
    ("text", "code", "named"),
    [
        ("", "missing", ""),
        ("   ", "missing", ""),
        ("cell.pitch " * 100, "too-large", ""),
        ("2 * 3", "missing", ""),
        ("cell.pitch cell.thickness", "malformed", '"cell.thickness"'),
        ("cell.pitch *", "malformed", ""),
        ("* cell.pitch", "malformed", '"*"'),
        ("cell.pitch * / 2", "malformed", '"/"'),
        ("cell.pitch ** 2", "malformed", '"*"'),
        ("cell.pitch / (2 * cell.thickness)", "malformed", "'(' at position 14"),
        ("cell.pitch ^ 2", "malformed", "'^' at position 12"),
        ("cell.pitch + 1", "malformed", "'+' at position 12"),
        ("-cell.pitch", "malformed", "'-' at position 1"),
        ("cell.pitch * 0", "out-of-range", "0"),
        ("cell.pitch * 1e999", "out-of-range", "1e999"),
        ("cell.pitch * 1e300 * 1e300", "out-of-range", ""),
        ("cell.pitch / 1e300 / 1e300", "out-of-range", ""),
        ("cell.pitch * cell.pitch", "repeated", '"cell.pitch"'),
        ("cell.pitch / cell.pitch", "repeated", '"cell.pitch"'),
        ("cell['pitch']", "malformed", "'[' at position 5"),
        ("cell.pitch; import os", "malformed", "';' at position 11"),
        ("cell..pitch", "malformed", "'.' at position 5"),
        ("cell.p\u00eftch", "malformed", "position 7"),
        ("lambda: 0", "malformed", "':' at position 7"),
    ],
)
def test_text_outside_the_grammar_is_refused(text, code, named):
    with refusing(StudyError, code, "sweep.vary") as caught:
        parse(text)
    assert named in caught.value.cause


@settings(deadline=None)
@given(st.text(max_size=60))
def test_any_text_is_read_or_refused(text):
    try:
        expression = parse(text)
    except StudyError:
        return
    assert expression.varied in text


def test_dunder_names_are_only_names():
    with refusing(StudyError, "unknown", "sweep.vary"):
        STUDY.solved(parse("cell.__class__ / cell.pitch"), 1.0)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1 / cell.pitch", 0.0),
        ("cell.pitch", math.inf),
        ("cell.pitch", math.nan),
        ("cell.thickness", 0.0),
        ("cell.thickness", -1e-3),
        ("cell.pillar.diameter", 0.00699),
        ("material.poisson_ratio", 0.5),
        ("cell.pitch / 1e300", 1e300),
    ],
)
def test_impossible_designs_are_refused(text, value):
    with pytest.raises(StudyError):
        STUDY.solved(parse(text), value)


def test_parameter_that_is_zero_cannot_be_divided_out():
    lossless: Study = STUDY.with_parameter("material.loss_factor", 0.0)
    with refusing(StudyError, "out-of-range", "sweep.vary"):
        lossless.solved(parse("cell.pitch * material.loss_factor"), 1e-6)


@pytest.mark.parametrize(
    ("vary", "zero", "ends"),
    [
        ("1 / cell.pillar.draft", "cell.pillar.draft", (2, 4)),  # its own value would be infinite
        ("cell.thickness / cell.pillar.fillet", "cell.pillar.fillet", (2, 4)),
        ("cell.pitch / cell.pillar.draft", "cell.pillar.draft", ("1 mm/rad", "2 mm/rad")),
        ("cell.pillar.height / cell.pitch / material.loss_factor", "material.loss_factor", (2, 4)),
    ],
)
def test_sweep_that_divides_by_zero_is_refused(edited, vary, zero, ends):
    low, high = (f'"{end}"' if isinstance(end, str) else end for end in ends)
    text = edited(
        ("loss_factor = 1e-3\n", ""),
        ("cell.pillar.diameter / cell.pitch", vary),
        ("from = 0.2", f"from = {low}"), ("to = 0.8", f"to = {high}"),
    )  # fmt: skip
    with refusing(StudyError, "out-of-range", "study: sweep[1].vary") as caught:
        loads(text)
    assert zero in caught.value.cause
    assert zero in caught.value.next_step


def test_sweep_that_multiplies_by_zero_is_refused(edited):
    text = edited(
        ("cell.pillar.diameter / cell.pitch", "cell.thickness * cell.pillar.fillet / cell.pitch / cell.pitch")
    )
    with refusing(StudyError, "out-of-range", "study: sweep[1]") as caught:
        loads(text)
    assert caught.value.argument.startswith("study: sweep[1]")


def test_zero_itself_can_be_swept(edited):
    text = edited(
        ("cell.pillar.diameter / cell.pitch", "cell.pillar.draft"), ("from = 0.2", "from = 0"),
        ("to = 0.8", 'to = "4 deg"'),
    )  # fmt: skip
    study = loads(text)
    drafts = [design.cell.pillar.draft for design in study.designs(study.sweep_settings[0])]
    assert drafts[0] == 0
    assert drafts[-1] == pytest.approx(math.radians(4), rel=1e-15)


def test_poisson_ratio_can_pass_through_zero():
    assert STUDY.solved(parse("material.poisson_ratio"), 0.0).cell.material.poisson_ratio == 0.0
