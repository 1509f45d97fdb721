"""Distance of neighbouring pillars in a plan: the pitch is the period."""

import pytest

import haptonic as hp


@pytest.mark.parametrize(
    ("lattice", "count", "distance"),
    [
        ("honeycomb", 2, "5.196 mm"),
        ("kagome", 3, "4.5 mm"),
        ("lieb", 3, "4.5 mm"),
    ],  # 9 mm / sqrt(3), 9 mm / 2
)
def test_a_plan_shows_neighbours_of_several_pillars(lattice, count, distance):
    pillar = {"diameter": "2 mm", "height": "8 mm"}
    cell = {"lattice": lattice, "pitch": "9 mm", "thickness": "1.5 mm", "pillar": pillar}
    text = hp.Study(material="brass", cell=cell).plan().summary()[1]
    assert text == f"A period contains {count} pillars; the nearest are {distance} apart, between axes."


@pytest.mark.parametrize("pillar", [None, {"diameter": "2 mm", "height": "8 mm"}])
def test_a_plan_of_at_most_one_pillar_shows_the_pitch_only(pillar):
    cell = {"pitch": "9 mm", "thickness": "1.5 mm"} | ({"pillar": pillar} if pillar else {})
    assert len(hp.Study(material="brass", cell=cell).plan().summary()) == 1
