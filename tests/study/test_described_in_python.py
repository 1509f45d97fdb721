"""Values made in Python with a slip: of every described class and every option, five parts and the name."""

from __future__ import annotations

from dataclasses import MISSING, fields
from importlib import import_module
from pkgutil import walk_packages

import pytest
from hypothesis import given, strategies as st
from pydantic.dataclasses import is_pydantic_dataclass

import haptonic
from five_parts import refused
from haptonic import Study
from haptonic.analyses import NAMES, named
from haptonic.analyses.options import option_of
from haptonic.cell import Pillar, UnitCell
from haptonic.errors import HaptonicError
from haptonic.fields.keys import slots
from haptonic.fields.of_number import NumberRange, OfNumber
from haptonic.lattice import Lattice


def described_classes() -> list[type]:
    """All of them, wherever they are declared."""
    classes = {}
    for module in walk_packages(haptonic.__path__, "haptonic."):
        if module.name.endswith("__main__"):
            continue
        for value in vars(import_module(module.name)).values():
            if (
                isinstance(value, type)
                and is_pydantic_dataclass(value)
                and value.__module__.startswith("haptonic")
            ):
                classes[value.__qualname__] = value
    # others are made of these two
    return [kind for kind in classes.values() if kind not in (OfNumber, NumberRange)]


CLASSES = described_classes()
STUDY = Study(cell=UnitCell(Lattice.square(7e-3), 1.5e-3, "steel", Pillar(3.5e-3, 14.7e-3)), carrier=60e3)
WRONG = {"m": "1 s", "Hz": "1 m", "s": "1 m", "V": "1 m", "N": "1 kHz", "Pa": "1 m", "rad": "1 m"}
NUMBERS = [
    (kind, slot)
    for kind in CLASSES
    for slot in slots(kind)
    if len(slot.quantities) == 1
    and not slot.kinds
    and "parameter" not in {other.name for other in slots(kind)}
]
UNITS = [
    (name, field.name, option.unit)
    for name in NAMES
    for field in fields(named(name).options)
    if (option := option_of(field)) and option.unit
]


@st.composite
def misspelt(draw: st.DrawFn, names: list[str]) -> str:
    """A name with a letter left out, doubled, or exchanged with the next."""
    name = draw(st.sampled_from([candidate for candidate in names if len(candidate) > 3]))
    at = draw(st.integers(1, len(name) - 2))
    slip = draw(st.sampled_from(["left out", "doubled", "exchanged"]))
    if slip == "left out":
        return name[:at] + name[at + 1 :]
    if slip == "doubled":
        return name[:at] + name[at] + name[at:]
    return name[:at] + name[at + 1] + name[at] + name[at + 2 :]


def test_there_are_many():
    assert len(CLASSES) > 40
    assert {"UnitCell", "Pillar", "Study", "Actuator", "BandSettings"} <= {kind.__name__ for kind in CLASSES}


@given(st.data())
def test_a_misspelt_key_is_refused_with_the_nearest(data):
    kind = data.draw(
        st.sampled_from([candidate for candidate in CLASSES if any(len(s.key) > 3 for s in slots(candidate))])
    )
    known = [slot.key for slot in slots(kind)]
    name = data.draw(misspelt(known).filter(lambda text: text not in known))
    error = refused(lambda: kind(**{name: 1.0}), code="unknown", argument=name)
    assert any(f'"{key}"' in error.next_step for key in known) or "move it" in error.next_step, (
        error.next_step
    )


@pytest.mark.parametrize("given", ["wrong unit", "no unit", "no number", "a list", "nothing of the kind"])
def test_a_number_that_is_none_is_reported_with_its_name(given):
    unnamed = []
    for kind, slot in NUMBERS:
        value = {
            "wrong unit": WRONG.get(slot.quantities[0].unit, "1 m"), "no unit": "1 gobbledygook",
            "no number": "wide", "a list": [1.0, 2.0], "nothing of the kind": object(),
        }[given]  # fmt: skip
        error = refused(lambda kind=kind, key=slot.key, value=value: kind(**{key: value}))
        if slot.key not in str(error):
            unnamed.append(f"{kind.__name__}.{slot.key}: {error}")
    assert unnamed == []


@pytest.mark.parametrize(("name", "option", "unit"), UNITS)
def test_the_error_names_an_option_with_a_wrong_unit(name, option, unit):
    needed = {
        field.name: "x"
        for field in fields(named(name).options)
        if field.default is MISSING and field.default_factory is MISSING
    }
    refused(
        lambda: STUDY.run(name, **needed | {option: WRONG[unit]}), "unit", argument=option.replace("_", "-")
    )


@given(st.data())
def test_a_misspelt_option_is_refused_with_the_nearest(data):
    name = data.draw(st.sampled_from([analysis for analysis in NAMES if fields(named(analysis).options)]))
    known = [field.name for field in fields(named(name).options)]
    if not any(len(option) > 3 for option in known):
        return
    slip = data.draw(misspelt(known).filter(lambda text: text not in known))
    error = refused(lambda: STUDY.run(name, **{slip: 1}), code="unknown", argument=slip)
    assert any(f'"{option}"' in error.next_step for option in known)


@pytest.mark.parametrize("value", ["12 s", "wide", "", None, [1.0], object()])
@pytest.mark.parametrize("change", ["with_parameter", "with_numbers"])
def test_a_changed_number_is_a_number(change, value):
    changes = {
        "with_parameter": lambda: STUDY.with_parameter("cell.pillar.height", value),
        "with_numbers": lambda: STUDY.cell.with_numbers({"cell.pillar.height": value}),
    }
    assert "cell.pillar.height" in str(refused(changes[change]))


def test_a_changed_number_may_be_a_text_with_its_unit():
    assert STUDY.with_parameter("cell.pillar.height", "12 mm").cell.pillar.height == 12e-3
    assert STUDY.cell.with_numbers({"cell.pillar.height": "12 mm"}).pillar.height == 12e-3


def test_every_error_is_of_the_family():
    with pytest.raises(HaptonicError):
        Study(plat={"map": "o"}, cell=STUDY.cell)
    with pytest.raises(HaptonicError):
        UnitCell(Lattice.square(7e-3), thickness="1 s", material="steel")
