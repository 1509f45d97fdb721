"""Examples of the keys: values that a study may contain, and that a person would write."""

import tomllib

from haptonic.cell import Pillar, Step
from haptonic.cli.commands.keys import example
from haptonic.fields import table
from haptonic.friction.lubrication.parameters import Fingertip
from haptonic.study import Study
from haptonic.units import to_si

KEYS = table(Study)


def test_an_example_is_allowed_and_usual():
    refused, unusual, read = [], [], 0
    for path, key in KEYS.items():
        line = example(key)
        if key.quantity is None or not line:
            continue
        (value,) = tomllib.loads(line).values()
        for text in value if key.kind == "quantities" else [value]:
            number, read = to_si(text, key.unit, path), read + 1
            refused += [] if key.quantity.holds(number) else [path]
            of_another = key.kind == "quantities"  # the numbers of a list may be of different kinds
            unusual += [path] if key.quantity.unusual(number) and not of_another else []
    assert read > 150
    assert (refused, unusual) == ([], [])


def test_the_texts_of_errors_have_an_allowed_example():
    wrong = []
    for path, key in KEYS.items():
        if key.quantity and key.unit:
            text = key.quantity.allowed.split('"')[1]
            wrong += [] if key.quantity.holds(to_si(text, key.unit, path)) else [path]
    assert wrong == []


def test_the_example_of_a_step_fits_the_example_of_a_pillar():
    names = ("diameter", "height", "step.diameter", "step.height")
    below, whole, above, height = (to_si(KEYS[f"cell.pillar.{name}"].example, "m", name) for name in names)
    Pillar(below, whole, step=Step(above, height))


def test_the_examples_of_the_skin_are_read():
    lines = [example(key) for path, key in KEYS.items() if path.startswith("touch.skin.")]
    assert len(lines) == 10
    for line in lines:
        Fingertip(**{name: tuple(value) for name, value in tomllib.loads(line).items()})
