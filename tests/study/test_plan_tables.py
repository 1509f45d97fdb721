"""Tables of a plan on the plate: its lattices, its regions and its drives."""

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
