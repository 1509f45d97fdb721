"""Numbers as expressions of named parameters: grammar, units, refusals, writing, sweeps."""

from __future__ import annotations

import math
import pickle
import re
import tomllib
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction

import pytest
from hypothesis import assume, given, settings, strategies as st

from each import each
from five_parts import assert_explained, refused
from haptonic import Study
from haptonic.cell import UnitCell
from haptonic.errors import HaptonicError, StudyError
from haptonic.fields import Entries, ExpressedNumber, Scope, read, table, unchecked
from haptonic.fields.arithmetic import ExactNumber
from haptonic.fields.dimension import dimension_of
from haptonic.fields.grammar import evaluate
from haptonic.lattice import Lattice
from haptonic.store import Store, content_key
from haptonic.study import loads
from quick import PROTOTYPE

NAMED = """
title = "Named"
carrier = "60 kHz"
material = "aluminium-2017a"

[parameters]
a = "7 mm"
d = "0.5*a"
share = 0.6

[cell]
pitch = "a"
thickness = "a/4 - 0.25 mm"

[cell.pillar]
diameter = "d"
height = "2.1*a"

[bands]
count = 6
"""
NUMBERS = """
title = "Named"
carrier = "60 kHz"
material = "aluminium-2017a"

[cell]
pitch = "7 mm"
thickness = "1.5 mm"

[cell.pillar]
diameter = "3.5 mm"
height = "14.7 mm"

[bands]
count = 6
"""
SWEEP = '\n[[sweep]]\nvary = "parameters.a"\nfrom = "6 mm"\nto = "8 mm"\nsteps = 3\n'
STUDY = loads(NAMED)
KEYS = table(Study)
SCOPE = Scope({"a": "7 mm", "f": "60 kHz", "n": 3, "turn": "30 deg"})


class TestValues:
    """Values are those of ordinary arithmetic; roundings are those of one division at the end."""

    @each(
        ("text", "unit", "value"),
        [
            ("a", "m", 7e-3),
            ("a/2", "m", 3.5e-3),
            ("0.5*a", "m", 3.5e-3),
            ("a - 1 mm", "m", 6e-3),
            ("1 mm*n", "m", 3e-3),
            ("(14.7 mm - a)/1 mm", "", 7.7),
            ("-a + 2*a", "m", 7e-3),
            ("--a", "m", 7e-3),
            ("2*a**2/a", "m", 14e-3),
            ("a^2/(1 mm)", "m", 49e-3),
            ("2**-1", "", 0.5),
            ("2**3**2/2**6", "", 8.0),
            ("-2**2", "", -4.0),
            ("sqrt(a*a)", "m", 7e-3),
            ("sqrt(2)*a", "m", math.sqrt(2) * 7e-3),
            ("2**0.5", "", math.sqrt(2)),
            ("cos(0)", "", 1.0),
            ("tan(pi/4)", "", 1.0),
            ("sin(turn)", "", 0.5),
            ("a*f", "m/s", 420.0),
            ("1/f", "s", 1 / 60e3),
            ("2 mm^2/a", "m", 2e-6 / 7e-3),
            ("5 N s/m*a*f/(1 N)", "", 5 * 7e-3 * 60e3),
            ("1e12 N/m^3", "N/m^3", 1e12),
            ("7 mm\u00b2 / a", "m", 1e-3),
            ("3 µm + 3 \u03bcm", "m", 6e-6),
            ("1 h/(60 min)", "", 1.0),
            ("0*a", "m", 0.0),
        ],
    )
    def test_of_texts(self, text, unit, value):
        number = SCOPE.expressed(text).checked(unit)
        assert number == pytest.approx(value, rel=4e-16, abs=0.0)

    @given(st.decimals(1, 100, places=3), st.decimals(1, 100, places=3))
    def test_sums_are_rounded_once(self, first, second):
        scope = Scope({"a": f"{first} mm"})
        assert scope.expressed(f"a + {second} mm") == float(Fraction(first + second) / 1000)
        assert scope.expressed(f"a/7*7 - {second} mm") == float(Fraction(first - second) / 1000)

    @settings(deadline=None)
    @given(st.data())
    def test_as_python_reads_the_same_text(self, data):
        names = {"x": 1.75, "y": -0.5, "z": 3.0}
        atoms = st.sampled_from([*names, "2", "0.25", "1e1", "pi"])
        text = data.draw(
            st.recursive(
                atoms,
                lambda inner: st.one_of(
                    st.tuples(inner, st.sampled_from(["+", " - ", "*", "/ "]), inner).map(
                        "({0[0]}{0[1]}{0[2]})".format
                    ),
                    st.tuples(inner, st.sampled_from(["2", "3", "-1"])).map("({0[0]})**{0[1]}".format),
                    st.tuples(st.sampled_from(["sin", "cos", "sqrt"]), inner).map("{0[0]}({0[1]})".format),
                    inner.map("-{}".format),
                ),
                max_leaves=6,
            )
        )
        space = {**names, "pi": math.pi, "sin": math.sin, "cos": math.cos, "sqrt": math.sqrt}
        try:
            wanted = float(eval(text, {"__builtins__": {}}, space))  # a text that this test wrote itself
        except (ZeroDivisionError, ValueError, OverflowError, TypeError):
            return
        assume(len(text) <= 200 and 1e-9 < abs(wanted) < 1e9)
        scope = Scope(names)
        with suppress(StudyError):  # exact arithmetic finds zeros that floats miss by a rounding
            assert scope.expressed(text) == pytest.approx(wanted, rel=1e-9)

    @settings(deadline=None)
    @given(st.floats(0.5, 5.0), st.sampled_from([
        "x", "3*x - 1", "x*x/(x + 2)", "x**3", "x**-2", "x**1.5", "2**x", "x**x", "sqrt(x)", "sin(x)*x",
        "cos(x/2)", "tan(x/4)", "1/(1 + x)", "-x", "sqrt(3)*(x - 0.1)",
    ]))  # fmt: skip
    def test_slopes_are_differences(self, here, text):
        def at(x):
            return float(Scope({"x": x}).value(text).value)

        slope = float(Scope({"x": here}).value(text).slopes["x"])
        step = 1e-4
        expected = (8 * (at(here + step) - at(here - step)) - at(here + 2 * step) + at(here - 2 * step)) / 12
        assert slope == pytest.approx(expected / step, rel=1e-7, abs=1e-9)

    def test_slopes_go_through_other_parameters(self):
        scope = Scope({"c": "2*b + a", "b": "a*a", "a": 3})
        assert {name: float(s) for name, s in scope.value("c").slopes.items()} == {"c": 1, "b": 2, "a": 13}
        assert scope.uses("c/2") == {"a", "b", "c"}
        assert scope.changed({"b": 4.0}).value("c").slopes["a"] == 1


class TestRefusals:
    @each(
        ("text", "code", "words"),
        [
            ("1 mm + 2 kHz", "mismatch", "a length and a frequency"),
            ("a + 1", "mismatch", "a plain number"),
            ("a*a", "mismatch", "m^2"),
            ("7 a", "conflict", "7*a"),
            ("9**9**9*a", "too-large", "power"),
            ("a**a", "mismatch", "power"),
            ("2*" * 101 + "a", "too-large", "characters"),
            ("(" * 50 + "a" + ")" * 50, "too-large", "inside each other"),
            ("1" + "**1" * 40 + "*a", "too-large", "inside each other"),
            ("a/0", "out-of-range", "divided by zero"),
            ("a/(n - 3)", "out-of-range", "divided by zero"),
            ("0**-1*a", "out-of-range", "divided by zero"),
            ("sqrt(-a*a)", "out-of-range", "negative"),
            ("(-2)**0.5*a", "out-of-range", "positive"),
            ("1e300**2*a", "out-of-range", "too large"),
            ("1e-300**2*a", "out-of-range", "too small"),
            ("tan(1e999)*a", "out-of-range", "power of ten"),
            ("1e399*a", "out-of-range", "too large"),
            ("sin(a)*a", "mismatch", "length"),
            ("aa", "unknown", "the parameters are a, d, f, n"),
            ("mm", "unknown", "1 mm"),
            ("7 mmm*n", "unknown", "unit"),
            ("cell.pitch", "malformed", "[parameters]"),
            ("a +", "malformed", "at its end"),
            ("(a", "malformed", "at its end"),
            ("a a", "malformed", "in the place of"),
            ("sin", "malformed", "parentheses"),
            ("__import__", "unknown", "__import__"),
            ("__import__(n)", "unknown", "__import__"),
            ("2 mm^n", "malformed", "parentheses"),
            ("1 kHz/(1 mm)", "mismatch", "m^-1*s^-1"),
        ],
    )
    def test_of_texts(self, text, code, words):
        study = NAMED.replace("share = 0.6", 'f = "60 kHz"\nn = 3').replace(
            'pitch = "a"', f'pitch = "{text}"'
        )
        error = refused(lambda: loads(study), code=code, argument="cell.pitch")
        assert_explained(error, words)

    @pytest.mark.parametrize(
        ("old", "new", "code", "argument", "words"),
        [
            ('a = "7 mm"', 'a = "b"\nb = "2*c"\nc = "a"', "conflict", "parameters.a", "a -> "),
            ('a = "7 mm"', 'a = "a"', "conflict", "parameters.a", "a -> a"),
            ('d = "0.5*a"', 'd = "0.5*e"', "unknown", "parameters.d", "a, d, share"),
            ('d = "0.5*a"', 'd = "0.5*a"\nmm = "1 mm"', "malformed", "parameters.mm", "unit"),
            ('d = "0.5*a"', 'd = "0.5*a"\nsqrt = 2', "malformed", "parameters.sqrt", "function"),
            ('d = "0.5*a"', 'd = "0.5*a"\n"b c" = 2', "malformed", "'b c'", "letters"),
            ('d = "0.5*a"', 'd = "0.5*a"\nb = [2]', "malformed", "parameters.b", "neither"),
            ('d = "0.5*a"', 'd = "0.5*a"\nb = nan', "malformed", "parameters.b", "neither"),
            ('d = "0.5*a"', 'd = "0.5*a"\nb = true', "malformed", "parameters.b", "neither"),
            ('d = "0.5*a"', 'd = "0.5*a"\nb = ""', "malformed", "parameters.b", "at its end"),
            ('diameter = "d"', 'diameter = "10*d"', "out-of-range", "cell.pillar.diameter", ""),
            ('[parameters]', '[parameter]', "unknown", "parameter", '"parameters"'),
        ],
    )  # fmt: skip
    def test_of_tables(self, old, new, code, argument, words):
        error = refused(lambda: loads(NAMED.replace(old, new)), code=code, argument=argument)
        assert words in str(error)

    def test_one_slip_is_one_problem(self):
        error = refused(lambda: loads(NAMED.replace('a = "7 mm"', 'a = "7 mn"')), argument="parameters.a")
        assert "other problem" not in str(error)

    def test_too_many(self):
        many = "\n".join(f"p{number} = 1" for number in range(200))
        refused(lambda: loads(NAMED.replace("share = 0.6", many)), code="too-large")

    def test_a_long_chain_of_parameters_has_a_value(self):
        """However the table is ordered: values do not recurse."""
        chain = {"p0": "7 mm", **{f"p{n}": f"p{n - 1} + 1 um" for n in range(1, 99)}}
        for texts in (chain, dict(reversed(chain.items()))):
            assert Scope(texts).expressed("p98") == 7.098e-3

    @settings(deadline=None, max_examples=300)
    @given(st.text(alphabet="aan17.e+-*/^()% mHzkqrtpsi\u00b2_,\n'\"\\", max_size=60), st.booleans())
    def test_any_text_is_a_number_or_an_error_with_five_parts(self, text, in_table):
        table = {"a": "7 mm", "n": 3}
        given_texts = {**table, "x": text} if in_table else table
        cell = {"pitch": "a" if in_table else text, "thickness": "1 mm"}
        try:
            study = Study(parameters=given_texts, material="steel", cell=cell)
        except HaptonicError as error:
            assert_explained(error)
        else:
            assert all(math.isfinite(value) for value in study.parameters().values())
            assert loads(study.to_toml()) == study

    @settings(deadline=None)
    @given(st.text(max_size=30))
    def test_any_name_is_a_name_or_refused(self, name):
        try:
            study = Study(
                parameters={name: "7 mm"}, material="steel", cell={"pitch": name, "thickness": "1 mm"}
            )
        except HaptonicError as error:
            assert_explained(error)
        else:
            assert study.cell.lattice.pitch == 7e-3

    def test_a_letter_that_is_a_unit_of_time_may_be_a_height(self):
        named = NAMED.replace("share = 0.6", 'h = "14.7 mm"').replace('"2.1*a"', '"h"')
        assert loads(named).cell == STUDY.cell
        error = refused(lambda: loads(named.replace('"h"', '"1 mm/h"')), code="conflict")
        assert "in the place of a unit" in str(error)
        refused(lambda: loads(named.replace("count = 6", 'count = 6\nbudget = "1 h"')), code="conflict")


class TestStudies:
    def test_numbers_are_those_of_plain_texts_to_the_bit(self):
        plain = loads(NUMBERS)
        assert plain.cell == STUDY.cell
        assert content_key({"study": STUDY.inputs()}) == content_key({"study": plain.inputs()})

    def test_bands_are_those_of_plain_texts_to_the_bit(self, tmp_path):
        coarse = "points = 8\n[mesh]\norder = 2\nfoot_rings = 0\n"
        texts = {"named": NAMED, "plain": NUMBERS}
        bands = {
            name: loads(text + coarse).bands(store=Store(tmp_path / name)).dataset["frequency"].values
            for name, text in texts.items()
        }
        assert bands["named"].tobytes() == bands["plain"].tobytes()
        assert bands["named"].size > 20

    def test_the_plan_shows_values_and_expressions(self):
        sizes = next(table for table in STUDY.plan().tables() if table.title.startswith("sizes"))
        assert ("parameters.d", "3.5 mm", "0.5*a") in sizes.rows
        assert ("thickness", "1.5 mm", "a/4 - 0.25 mm") in sizes.rows
        assert ("parameters.a", "7 mm", None) in sizes.rows
        plain = next(table for table in loads(NUMBERS).plan().tables() if table.title == sizes.title)
        assert ("thickness", "1.5 mm") in plain.rows

    def test_written_as_given(self):
        written = STUDY.to_toml()
        for line in ('a = "7 mm"', 'd = "0.5*a"', "share = 0.6", 'pitch = "a"', 'height = "2.1*a"'):
            assert f"\n{line}\n" in written, line
        again = loads(written)
        assert again == STUDY
        assert again.to_toml() == written

    def test_in_python(self):
        cell = {"pitch": "a", "thickness": "a/4 - 0.25 mm", "pillar": {"diameter": "d", "height": "2.1*a"}}
        study = Study(
            title="Named", carrier="60 kHz", material="aluminium-2017a", cell=cell, bands={"count": 6},
            parameters={"a": "7 mm", "d": "0.5*a", "share": 0.6},
        )  # fmt: skip
        assert study == STUDY
        assert study.to_toml() == STUDY.to_toml()
        assert dict(study.named_parameters) == {"a": 7e-3, "d": 3.5e-3, "share": 0.6}

    def test_a_key_below_the_heading_of_the_parameters_is_explained(self):
        text = NUMBERS.replace('material = "aluminium-2017a"\n', "")
        text = text.replace("\n[cell]", '\n[parameters]\na = "7 mm"\nmaterial = "steel"\n\n[cell]', 1)
        error = refused(lambda: loads(text), code="unknown")
        assert error.argument.endswith("parameters.material")
        assert "if material is no parameter, move its line above [parameters]" in error.next_step

    def test_a_value_alone_knows_no_parameters(self):
        assert Lattice.square("2*3.5 mm").pitch == 7e-3
        error = refused(lambda: UnitCell(Lattice.square("7 mm"), "a", "steel"), code="unknown")
        assert "the study has no [parameters]" in str(error)

    def test_everywhere(self):
        text = PROTOTYPE.replace('pitch = "7 mm"', 'pitch = "a"').replace(
            "\n[cell]", '\n[parameters]\na = "7 mm"\n\n[cell]', 1
        )
        assert text != PROTOTYPE
        more = '\n[touch]\ndamping = ["5 N s/m", "(5 + 5)*1 N s/m", "30 N s/m"]\n[scan]\ngrid = "a/3.5"\n'
        study = loads(text + more)
        assert study.cell == loads(PROTOTYPE).cell
        assert study.scan_settings.grid == 2e-3
        assert 'damping = ["5 N s/m", "(5 + 5)*1 N s/m", "30 N s/m"]' in study.to_toml()

    def test_sites_discs_and_plates(self):
        start = 'material = "steel"\n[parameters]\na = "8 mm"\nx = "1/4"\n'
        start += '[cell]\npitch = "a"\nthickness = "1 mm"\n'
        pillar = 'pillar = { diameter = "a/8", height = "4 mm" }\n'
        sites = loads(
            f'{start}[[cell.site]]\nat = ["x", "x"]\n{pillar}'
            f'[[cell.site]]\nposition = ["0.7*a", "5.6 mm"]\n{pillar}'
        )
        assert sites.cell.site[0].at == (0.25, 0.25)
        assert sites.with_parameter("parameters.a", 9e-3).cell.site[1].position == (6.3e-3, 5.6e-3)
        discs = loads(
            f'{start}[[cell.disc]]\ndiameter = "a/2"\nempty = true\n[plate]\nmap = """\nooo\nooo"""\n'
            '[plate.tiles]\no = "lattice"\n[[plate.force]]\nname = "F"\n'
            'centre = ["a/2", "1.5*a"]\nforce = "x*4 N"\n'
        )
        assert discs.cell.disc[0].diameter == 4e-3
        assert discs.plate_settings.force[0].centre == (4e-3, 12e-3)

    def test_changed_parameters_move_all_that_follows(self):
        larger = STUDY.with_parameter("parameters.a", "8 mm")
        assert larger == STUDY.with_parameters({"parameters.a": 8e-3})
        assert larger.cell == UnitCell(
            Lattice.square(8e-3), 1.75e-3, STUDY.cell.material,
            replace(STUDY.cell.pillar, diameter=4e-3, height=16.8e-3),
        )  # fmt: skip
        assert larger == STUDY.with_keys({"parameters.a": "8 mm"})
        assert 'a = "8 mm"' in larger.to_toml()
        assert 'pitch = "a"' in larger.to_toml()
        assert larger.parameters()["parameters.d"] == 4e-3
        wider = STUDY.with_parameter("parameters.d", "4 mm")
        assert (wider.cell.pillar.diameter, wider.cell.lattice.pitch) == (4e-3, 7e-3)
        refused(lambda: STUDY.with_parameter("parameters.b", 1.0), code="unknown")
        refused(lambda: STUDY.with_parameter("parameters.a", "1 kHz"))

    def test_a_new_number_replaces_an_expression(self):
        for study in (
            STUDY.with_parameter("cell.pitch", 7.5e-3),
            STUDY.with_keys({"cell.pitch": "7.5 mm"}),
        ):
            assert 'pitch = "7.5 mm"' in study.to_toml()
            assert 'diameter = "d"' in study.to_toml()
            assert study.with_parameter("parameters.a", 8e-3).cell.lattice.pitch == 7.5e-3
        both = STUDY.with_parameters({"parameters.a": 8e-3, "cell.pitch": 7.5e-3})
        assert (both.cell.lattice.pitch, both.cell.pillar.diameter) == (7.5e-3, 4e-3)
        cell = replace(STUDY.cell, thickness=2e-3)
        replaced = Study(cell=cell, parameters=dict(STUDY.named_parameters))
        assert 'thickness = "2 mm"' in replaced.to_toml()
        assert 'diameter = "d"' in replaced.to_toml()
        other = Study(cell=STUDY.cell, parameters={"a": "6 mm"})
        assert 'diameter = "3.5 mm"' in other.to_toml()  # d is not known here, and a has another value
        assert loads(other.to_toml()).cell == STUDY.cell

    def test_expressed_numbers_are_floats(self):
        pitch = STUDY.cell.lattice.pitch
        assert isinstance(pitch, ExpressedNumber)
        assert repr(pitch) == "0.007"
        again = pickle.loads(pickle.dumps(pitch))
        assert (again, again.text, again.unit) == (7e-3, "a", "m")


class TestSweeps:
    def test_every_number_follows(self):
        study = loads(NAMED + SWEEP)
        designs = study.designs(study.sweep_settings[0])
        sizes = [(d.cell.lattice.pitch, d.cell.pillar.diameter, d.cell.thickness) for d in designs]
        assert sizes == [(6e-3, 3e-3, 1.25e-3), (7e-3, 3.5e-3, 1.5e-3), (8e-3, 4e-3, 1.75e-3)]
        assert loads(study.to_toml()) == study
        assert study.sweep_settings[0].unit == "m"

    def test_other_expressions_give_other_inputs(self):
        """With equal numbers: the designs of the sweep differ."""
        study, other = loads(NAMED + SWEEP), loads(NAMED.replace('"d"', '"3.5 mm"') + SWEEP)
        assert study.cell == other.cell
        assert study.inputs() != other.inputs()

    def test_products_with_parameters(self):
        slender = SWEEP.replace('"parameters.a"', '"cell.pillar.height / parameters.a"')
        study = loads(NAMED + slender.replace('"6 mm"', "1.5").replace('"8 mm"', "2.5"))
        heights = [design.cell.pillar.height for design in study.designs(study.sweep_settings[0])]
        assert heights == pytest.approx([10.5e-3, 14e-3, 17.5e-3])

    @pytest.mark.parametrize(
        ("old", "new", "code", "argument", "words"),
        [
            ("parameters.a", "parameters.b", "unknown", "sweep[1].vary", "parameters.a"),
            ("parameters.a", "a", "unknown", "sweep[1].vary", '"parameters.a"'),
            ('"6 mm"', '"6 kHz"', "mismatch", "sweep[1].from", "a frequency"),
            ('"8 mm"', "8", "mismatch", "sweep[1].to", "a plain number"),
            ("parameters.a", "parameters.a * cell.pitch", "mismatch", "sweep[1].from", "m^2"),
            ('"parameters.a"\nfrom = "6 mm"\nto = "8 mm"', '"parameters.a / cell.pitch"\nfrom = 1\nto = 2',
             "conflict", "sweep[1].vary", "follows a named parameter"),
            ('"6 mm"', '"0.9 mm"', "out-of-range", "sweep[1]", "cell.thickness"),
        ],
    )  # fmt: skip
    def test_refused(self, old, new, code, argument, words):
        text = NAMED + SWEEP.replace(old, new)
        error = refused(lambda: loads(text), code=code, argument=argument)
        assert words in str(error)


def test_dimensions_of_declared_units():
    """Each unit that the package declares is its own product of base units."""
    assert evaluate("1 N", {}).dimension == dimension_of("kg*m*s^-2")
    assert evaluate("1 Pa", {}).dimension == dimension_of("N/m^2")
    assert evaluate("1 V*1 F", {}).dimension == dimension_of("A*s") == evaluate("1 C", {}).dimension
    assert evaluate("1 V^2*1 F", {}).dimension == dimension_of("N m")
    assert evaluate("60 rpm", {}).dimension != dimension_of("Hz")
    assert evaluate("1 inch", {}) == ExactNumber(Fraction(254, 10000), dimension_of("m"))


def with_factor(tables, prefix=""):
    """The tables of a study with a factor ``one`` at every number that may be an expression."""
    written = {}
    for name, value in tables.items():
        path = f"{prefix}{name}"
        key = KEYS.get(path)
        if isinstance(value, dict) and (key is None or key.kind == "table"):
            written[name] = with_factor(value, f"{path}.")
        elif isinstance(value, dict):
            written[name] = {entry: factored(item) for entry, item in value.items()}
        elif isinstance(value, list) and key is not None and key.kind == "tables":
            written[name] = [with_factor(item, f"{path}[].") for item in value]
        elif isinstance(value, list):
            written[name] = [factored(item) for item in value]
        else:
            is_number = key is not None and (key.quantity is not None or key.kind == "number")
            written[name] = factored(value) if is_number else value
    return written


def factored(value):
    """The value with a factor, if it is a number with or without a unit."""
    if isinstance(value, float) or (isinstance(value, str) and re.match(r"-?[0-9]", value)):
        return f"one*({value})"
    return value


def test_every_number_may_be_an_expression(every_key_text):
    plain = loads(every_key_text)
    tables = with_factor(tomllib.loads(every_key_text))
    tables["parameters"] = {"one": 1.0}
    tables["cell"]["pitch"] = "one*7 mm"
    study = read(Study, tables)
    written = study.to_toml()
    expressions = [text for text in flat(tables) if text.startswith("one*")]
    assert len(expressions) > 100
    for text in set(expressions):
        assert written.count(f'"{text}"') == expressions.count(text), text
    assert replaced(study, Entries()) == replaced(plain, Entries())
    assert loads(written) == study
    larger = study.with_keys({"parameters.one": 1.001})
    assert larger.cell.lattice.pitch == 7.007e-3
    assert larger.touch.speed == pytest.approx(study.touch.speed * 1.001, rel=1e-15)


def replaced(study, parameters):
    return unchecked(study, named_parameters=parameters)


def flat(tables):
    """All texts in tables."""
    values = tables.values() if isinstance(tables, dict) else tables
    for value in values:
        if isinstance(value, dict | list):
            yield from flat(value)
        elif isinstance(value, str):
            yield value
