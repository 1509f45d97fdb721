"""Tables of a plan on the plate: its lattices, its regions and its drives."""

import numpy as np
import pytest

from haptonic.study import loads

HEXAGONAL = '''
carrier = "58 kHz"
material = "aluminium-paper"
[cell]
lattice = "hexagonal"
pitch = "8 mm"
thickness = "1.5 mm"
[cell.pillar]
diameter = "3 mm"
height = "10 mm"
[plate]
map = """
ootttt
o1o2tt
oo1ooo
"""
[plate.tiles]
o = "lattice"
t = "tall"
1 = "L"
2 = "R"
[[plate.cell]]
name = "tall"
change = { "cell.pillar.height" = "12 mm" }
[[plate.force]]
name = "F1"
region = "R"
centre = ["3 mm", "3 mm"]
'''


def tables_of(text):
    """Rows of the tables of a plan by the head of the first column, each a dictionary by the heads."""
    return {
        table.columns[0].head: [
            dict(zip((column.head for column in table.columns), row, strict=True)) for row in table.rows
        ]
        for table in loads(text).plan().tables()
    }


def test_tiles_are_the_letters_of_the_map():
    """Rows of a triangular lattice are offset, which cuts letters of lattices and of regions in two."""
    tables = tables_of(HEXAGONAL)
    assert [(row["lattice"], row["tiles"]) for row in tables["lattice"]] == [("lattice", 9), ("tall", 6)]
    assert {row["region"]: row["tiles"] for row in tables["region"]} == {"L": 2, "R": 1}
    regions = loads(HEXAGONAL).plan().dataset.tiles
    assert dict(zip(regions.region.values, regions.values, strict=True)) == {"L": 2, "R": 1}


def test_drives_are_listed_with_phases_and_carriers_if_they_differ():
    force = '[[plate.force]]\nname = "{}"\nregion = "L"\ncentre = ["9 mm", "3 mm"]\nforce = "2 N"\n{}'
    (alone,) = tables_of(HEXAGONAL)["force"]
    assert alone == {
        "force": "F1",
        "x / mm": 27e-3,
        "y / mm": pytest.approx(9.928e-3, rel=1e-3),
        "amplitude / N": 1,
    }
    more = force.format("F2", 'phase = "90 deg"') + "\n" + force.format("F3", 'carrier = "70 kHz"')
    first, second, third = tables_of(HEXAGONAL + more)["force"]
    assert (first["phase / deg"], second["phase / deg"]) == (0, pytest.approx(np.pi / 2))
    assert [row["carrier / kHz"] for row in (first, second, third)] == [58e3, 58e3, 70e3]


def test_patches_are_listed_with_their_phases():
    patch = '[[plate.actuator]]\nname = "{}"\nregion = "L"\ncentre = ["4 mm", "{}"]\nmaterial = "pzt-4"\n'
    patch += 'size = ["3 mm", "2 mm", "0.5 mm"]\nphase = "{}"\n'
    text = HEXAGONAL.replace("oo1ooo", "o11ooo")
    flat = tables_of(text + patch.format("A1", "9 mm", "0 deg"))["patch"]
    assert "phase / deg" not in flat[0]
    turned = tables_of(text + patch.format("A1", "9 mm", "60 deg"))["patch"]
    assert turned[0]["phase / deg"] == pytest.approx(np.pi / 3)
