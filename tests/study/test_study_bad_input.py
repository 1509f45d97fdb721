"""Bad input: five parts that name the key, the value, what is allowed, why, and what to do."""

import re
import tomllib
from collections.abc import Iterator
from typing import Any

import pytest

from each import each
from five_parts import refused_study as refused
from haptonic.cell import Pillar, UnitCell
from haptonic.errors import StudyError
from haptonic.fields import read, table
from haptonic.fields.keys import slots
from haptonic.fields.problems import MOST_LISTED
from haptonic.lattice import Lattice
from haptonic.study import Study, loads
from haptonic.study.plate_tables import PlateSettings

PITCH = 'pitch = "7 mm"'
RATIO = "cell.pillar.height / cell.pitch"
MATERIAL = "[material]"


# (change of the reference study, path of the key, words of the error)
NAMED_IN_THE_ISSUE = {
    "unknown key": (("diameter =", "diametre ="), "cell.pillar.diametre", ["slip", 'write "diameter"']),
    "missing unit": ((PITCH, "pitch = 7"), "cell.pitch", ["unit is missing", '"7 mm"']),
    "wrong unit": ((PITCH, 'pitch = "7 kHz"'), "cell.pitch", ["'7 kHz'", "not a unit of length"]),
    "pillar wider than the cell": (
        ('"3.5 mm"', '"8 mm"'),
        "cell.pillar.diameter",
        ["8 mm", "less than 6.86 mm", "too wide"],
    ),
    "pillar nearly as wide": (
        ('"3.5 mm"', '"6.9 mm"'),
        "cell.pillar.diameter",
        ["6.9 mm", "less than 6.86 mm"],
    ),
    "no room between rows": (
        ('lattice = "square"\n' + PITCH, 'a1 = ["7 mm", "0 mm"]\na2 = ["7 mm", "0.1 mm"]'),
        "cell.pillar.diameter",
        ["no pillar", "nearly parallel"],
    ),
    "zero size": (('"1.5 mm"', '"0 mm"'), "cell.thickness", ["zero"]),
    "negative size": (('"14.7 mm"', '"-14.7 mm"'), "cell.pillar.height", ["negative"]),
    "NaN in a text": ((PITCH, 'pitch = "nan mm"'), "cell.pitch", ["not a finite number"]),
    "NaN": ((PITCH, "pitch = nan"), "cell.pitch", ["not a finite number"]),
    "infinite": ((PITCH, "pitch = inf"), "cell.pitch", ["not a finite number"]),
    "infinite in a text": ((PITCH, 'pitch = "-inf mm"'), "cell.pitch", ["not a finite number"]),
    "absurd size": ((PITCH, 'pitch = "7000 km"'), "cell.pitch", ["7000 km", "at most 1 km"]),
    "absurdly small": ((PITCH, 'pitch = "7e-20 m"'), "cell.pitch", ["at least 1 nm"]),
    "Poisson ratio 0.5": (("0.33", "0.5"), "material.poisson_ratio", ["incompressible", "0.49"]),
}

NOT_NAMED_THERE = {
    "unknown key at the top": (("carrier =", "carier ="), "carier", ['write "carrier"']),
    "unknown table": (("[bands]", "[bnads]"), "bnads", ['write "bands"']),
    "key of another table": (
        (PITCH, PITCH + '\ndiameter = "2 mm"'),
        "cell.diameter",
        ["move it to [cell.pillar]"],
    ),
    "missing key": ((PITCH, ""), "cell.pitch", ["left out", 'add pitch = "7 mm"']),
    "missing material": ((MATERIAL, "[stuff]"), "stuff", ["no key has this name", "material was left out"]),
    "misspelt material": ((MATERIAL, "[materiel]"), "materiel", ['write "material"']),
    "material of no kind": (
        ("carrier =", "material = 3\ncarrier ="),
        "touchpad.toml, line",
        ["[material]", "overwrite"],
    ),
    "missing stiffness": (
        ('youngs_modulus = "70 GPa"', ""),
        "material.youngs_modulus",
        ["the Young's modulus was left out"],
    ),
    "Poisson ratio -1": (("0.33", "-1.0"), "material.poisson_ratio", ["above -1"]),
    "negative stiffness": (('"70 GPa"', '"-70 GPa"'), "material.youngs_modulus", ["at least 1 kPa"]),
    "loss factor 1": (("loss_factor = 1e-3", "loss_factor = 1"), "material.loss_factor", ["below 1"]),
    "unit on a plain number": (("0.33", '"0.33 mm"'), "material.poisson_ratio", ["unit where none belongs"]),
    "boolean size": ((PITCH, "pitch = true"), "cell.pitch", ["True", "wrong type"]),
    "list of sizes": ((PITCH, 'pitch = ["7 mm", "8 mm"]'), "cell.pitch", ["wrong type"]),
    "date": ((PITCH, "pitch = 1979-05-27"), "cell.pitch", ["wrong type"]),
    "huge hexadecimal number": ((PITCH, "pitch = 0x" + "f" * 5000), "cell.pitch", ["a number of 20000 bits"]),
    "calculation": ((PITCH, 'pitch = "7 mm * 3 mm"'), "cell.pitch", ["a number in m^2"]),
    "tower of powers": ((PITCH, 'pitch = "10**10**10 m"'), "cell.pitch", ["the power is a length"]),
    "huge exponent": ((PITCH, 'pitch = "1e400 m"'), "cell.pitch", ["too large"]),
    "empty text": ((PITCH, 'pitch = ""'), "cell.pitch", ["empty"]),
    "very long text": ((PITCH, f'pitch = "{"7" * 10_000} mm"'), "cell.pitch", ["characters long"]),
    "full-width digits": ((PITCH, 'pitch = "\uff17 mm"'), "cell.pitch", ["not expected"]),
    "thousands": ((PITCH, 'pitch = "1,500 mm"'), "cell.pitch", ["decimal comma", "write a number"]),
    "decimal comma": ((PITCH, 'pitch = "7,0 mm"'), "cell.pitch", ["decimal comma", 'write "7.0 mm"']),
    "fraction of a band": (("count = 10", "count = 10.5"), "bands.count", ["not a whole number"]),
    "count in quotes": (("count = 10", 'count = "10"'), "bands.count", ["not a whole number"]),
    "boolean count": (("count = 10", "count = true"), "bands.count", ["not a whole number"]),
    "no bands": (("count = 10", "count = 0"), "bands.count", ["at least 1 and at most 60"]),
    "too many bands": (("count = 10", "count = 61"), "bands.count", ["at least 1 and at most 60"]),
    "too few points": (("points = 66", "points = 7"), "bands.points", ["at least 8"]),
    "accuracy zero": (("accuracy = 2e-3", "accuracy = 0"), "bands.accuracy", ["at most 0.1"]),
    "budget without a unit": (("accuracy = 2e-3", "budget = 10"), "bands.budget", ["at least 1 s"]),
    "budget of no time": (("accuracy = 2e-3", 'budget = "0.1 s"'), "bands.budget", ["at least 1 s"]),
    "accuracy too coarse": (("accuracy = 2e-3", "accuracy = 0.2"), "bands.accuracy", ["at most 0.1"]),
    "order too low": (("[bands]", "[mesh]\norder = 1\n[bands]"), "mesh.order", ["at least 2 and at most 10"]),
    "too many rings": (("[bands]", "[mesh]\nfoot_rings = 7\n[bands]"), "mesh.foot_rings", ["at most 6"]),
    "unknown lattice": (('"square"', '"sqare"'), "cell.lattice", ['write "square"', '"rectangular"']),
    "rectangle with one side": (('"square"', '"rectangular"'), "cell.pitch_y", ["left out"]),
    "square with two sides": ((PITCH, PITCH + '\npitch_y = "7 mm"'), "cell.pitch_y", ["without it"]),
    "blank name": (('"aluminium (paper)"', '" "'), "material.name", ["left out"]),
    "empty title": (('"Touchpad with two waveguides"', '""'), "title", ["text"]),
    "endless title": (
        ('"Touchpad with two waveguides"', f'"{"x" * 201}"'),
        "title",
        ["at most 200 characters"],
    ),
    "number for a title": (('"Touchpad with two waveguides"', "5"), "title", ["not a text"]),
    "carrier in mm": (('"60 kHz"', '"60 mm"'), "carrier", ["not a unit of frequency"]),
    "code in vary": (
        (RATIO, "__import__('os').system('true')"),
        "sweep[2].vary",
        ["not part of the grammar"],
    ),
    "unknown name in vary": ((RATIO, "cell.piller.height"), "sweep[2].vary", ['write "cell.pillar.height"']),
    "named parameter without its table in vary": (
        (RATIO, "glue"),
        "sweep[2].vary",
        ['write "parameters.glue"'],
    ),
    "text named in vary": ((RATIO, "cell.lattice / cell.pitch"), "sweep[2].vary", ["no numeric parameter"]),
    "absent name in vary": ((RATIO, "cell.pitch_y / cell.pitch"), "sweep[2]", ["does not give it"]),
    "missing unit in a sweep": (
        (RATIO, "cell.pillar.height"),
        "sweep[2].from",
        ["unit is missing", "sweep[2].to"],
    ),
    "unit of another kind in a sweep": (
        ("from = 1.0", 'from = "7 mm"'),
        "sweep[2].from",
        ["where none belongs"],
    ),
    "sweep from a number to itself": (("to = 0.8", "to = 0.2"), "sweep[1].to", ["the same"]),
    "sweep of one step": (("steps = 25", "steps = 1"), "sweep[1].steps", ["at least 2"]),
    "sweep of too many steps": (("steps = 25", "steps = 1001"), "sweep[1].steps", ["at most 1000"]),
    "sweep to NaN": (("to = 0.8", "to = nan"), "sweep[1].to", ["not a finite number"]),
    "sweep without end": (("to = 0.8", ""), "sweep[1].to", ["left out"]),
    "sweep past the cell": (
        ("to = 0.8", "to = 1.04"),
        "sweep[1]",
        ["= 1.005 at step 24 of 25", "cell.pillar.diameter would be 7.035 mm", "less than 6.86 mm"],
    ),
    "sweep through zero": (("from = 0.2", "from = -0.2"), "sweep[1]", ["at step 1 of 25", "negative"]),
    "unknown key in a sweep": (("steps = 25", "stepps = 25"), "sweep[1].stepps", ['write "steps"']),
}


@each("case", {**NAMED_IN_THE_ISSUE, **NOT_NAMED_THERE}.items())
def test_bad_value_is_refused(case, edited):
    change, path, words = case[1]
    error = refused(edited(change))
    assert error.argument.removeprefix("touchpad.toml: ").startswith(path)
    assert [word for word in words if word not in str(error)] == []


def test_misspelt_key_is_not_reported_as_missing_too(edited):
    assert len(refused(edited(("diameter =", "diametre ="))).next_step.splitlines()) == 1


def test_all_problems_are_reported_at_once(edited):
    error = refused(
        edited(
            (PITCH, "pitch = 7"), ("0.33", "0.5"), ("points = 66", "points = 4"), ("height = ", "heigth = ")
        )
    )
    assert error.argument == "touchpad.toml: cell.pillar.heigth"
    paths = re.findall(r"^ +(\S+): got ", error.next_step, re.M)
    assert sorted(paths) == ["bands.points", "cell.pitch", "material.poisson_ratio"]


KEYS = table(Study)
WORDS = sorted(
    {key.rpartition(".")[2].removesuffix("[]") for key in KEYS}
    | {slot.name for kind in (Study, UnitCell, Lattice, Pillar, PlateSettings) for slot in slots(kind)}
)


# a constant of a ceramic in [material] makes the others the wrong ones
OF_CERAMICS = {key.rpartition(".")[2] for key in KEYS if key.startswith("plate.actuator[].material.")}


def places(study: Any, path: str = "", pattern: str = "") -> Iterator[tuple[Any, str, str]]:
    """Every table of a study: itself, its path, and the path in the table of keys with a dot after it."""
    yield study, path, pattern
    for name, value in study.items():
        key = KEYS.get(f"{pattern}{name}")
        if key and key.kind == "table" and isinstance(value, dict):  # a material may be a name
            yield from places(value, f"{path}{name}.", f"{pattern}{name}.")
        if key and key.kind == "tables":
            for number, entry in enumerate(value, start=1):
                yield from places(entry, f"{path}{name}[{number}].", f"{pattern}{name}[].")


@pytest.mark.nightly
def test_a_key_in_any_place_but_its_own_is_refused_there(every_key_text):
    """Also the name of a value in Python, and a key at the top in the table that holds it."""
    study = tomllib.loads(every_key_text)
    for table_there, path, pattern in list(places(study)):
        others = OF_CERAMICS if pattern == "material." else set()
        wrong = [
            word
            for word in WORDS
            if word not in others and not any(f"{key}.".startswith(f"{pattern}{word}.") for key in KEYS)
        ]
        for first in range(0, len(wrong), MOST_LISTED):
            some = wrong[first : first + MOST_LISTED]
            table_there |= dict.fromkeys(some, "brass")
            with pytest.raises(StudyError) as caught:
                read(Study, study)
            reported = [
                caught.value.argument,
                *re.findall(r"^ +(\S+): got an unknown", caught.value.next_step, re.M),
            ]
            assert sorted(reported) == sorted(f"{path}{word}" for word in some)
            for word in some:
                del table_there[word]
        for word in others - {key.removeprefix(pattern) for key in KEYS}:
            with pytest.raises(StudyError) as caught:
                read(Study, study | {"material": study["material"] | {word: "brass"}})
            assert f"{path}{word}" in str(caught.value)


@pytest.mark.parametrize("beside", ["", 'material = "steel"'])
def test_a_material_in_the_cell_table_is_refused(beside):
    error = refused(f'{beside}\n[cell]\npitch = "7 mm"\nthickness = "1 mm"\nmaterial = "brass"')
    assert (error.code, error.argument) == ("unknown", "touchpad.toml: cell.material")


def test_list_of_problems_is_cut():
    error = refused("material = 'steel'\n[cell]\n" + "".join(f"zzz{number} = 1\n" for number in range(100)))
    assert " 101 " in error.next_step  # the other unknown keys, and the two sizes left out
    assert len(error.next_step.splitlines()) < 30


def test_number_of_sweeps_is_limited(reference_text):
    row = '[[sweep]]\nvary = "cell.pitch"\nfrom = "7 mm"\nto = "8 mm"\nsteps = 2\n'
    assert "at most 50 entries" in refused(reference_text + row * 49).allowed
    assert len(loads(reference_text + row * 48).sweep_settings) == 50


def test_unknown_library_material_suggests_the_nearest():
    error = refused('material = "steal"\n[cell]\npitch = "7 mm"\nthickness = "1 mm"')
    assert error.argument.endswith("material")
    assert 'write "steel"' in error.next_step


@pytest.mark.parametrize("value", ["3", "[1]", "true"])
def test_material_has_to_be_a_name_or_a_table(value):
    error = refused(f'material = {value}\n[cell]\npitch = "7 mm"\nthickness = "1 mm"')
    assert "built-in material" in error.allowed


@each(
    ("text", "words"),
    [
        ('material = "steel"\n[sweep]\nvary = "cell.pitch"', ["[[sweep]]"]),
        ('material = "steel"\ncell = 3', ["table"]),
        ("", ["empty"]),
        ("# nothing but a comment\n\n", ["comment"]),
        ('[cell]\npitch = 7 mm\nthickness = "1 mm"', ["line 2", "'pitch = 7 mm'", "quotes"]),
        ("[cell\npitch = 3", ["line 1"]),
        ('title = "open', ["line 1"]),
        ('title = "a"\ntitle = "b"', ["line 2", "overwrite"]),
        ("[cell]\n[cell]", ["line 2", "only once"]),
        ("a = " + "[" * 100_000, ["nested"]),
        ("a" + ".a" * 400 + " = 1", ["no key has this name", "{...}"]),
        ("[a" + ".a" * 50_000 + "]", ["too many dots"]),
        ("a = " + "9" * 5000, ["thousands of digits"]),
        ("title = 'x'\x01", ["line 1"]),
    ],
)
def test_text_that_is_no_study(text, words):
    error = refused(text)
    assert [word for word in words if word not in str(error)] == []
