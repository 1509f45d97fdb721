"""Distance of neighbouring pillars in a plan: the pitch is the period."""

import pytest

import haptonic as hp


@pytest.mark.parametrize(
    ("lattice", "count", "distance"),
    [
        ("square", 1, "9 mm"),
        ("triangular", 1, "9 mm"),
        ("honeycomb", 2, "5.196 mm"),  # 9 mm / sqrt(3)
        ("kagome", 3, "4.5 mm"),
        ("lieb", 3, "4.5 mm"),
    ],
)
def test_a_plan_shows_neighbours(lattice, count, distance):
    pillar = {"diameter": "2 mm", "height": "8 mm"}
    cell = {"lattice": lattice, "pitch": "9 mm", "thickness": "1.5 mm", "pillar": pillar}
    tables = hp.Study(material="brass", cell=cell).plan().tables()
    rows = dict(next(table for table in tables if table.title == "sizes of the cell").rows)
    assert rows["pillars in a period"] == count
    assert rows["distance of nearest pillars, between axes"] == distance


def test_a_plan_of_plain_plate_has_no_neighbours():
    tables = hp.Study(material="brass", cell={"pitch": "9 mm", "thickness": "1.5 mm"}).plan().tables()
    rows = dict(next(table for table in tables if table.title == "sizes of the cell").rows)
    assert not any("nearest" in name for name in rows)
