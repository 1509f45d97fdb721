"""Names of regions in the plan of a plate, which nothing covers."""

from itertools import combinations

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from haptonic import plots
from haptonic.study import loads

STUDY = '''
carrier = "58 kHz"
material = "aluminium-paper"
[cell]
pitch = "7 mm"
thickness = "1.5 mm"
[cell.pillar]
diameter = "3.5 mm"
height = "10 mm"
[plate]
map = """
oo11oo22o
oo11oo22o
o3ooooooo
"""
[plate.tiles]
o = "lattice"
1 = "L"
2 = "{name}"
3 = "C"
[[plate.actuator]]
name = "A1"
region = "L"
centre = ["8 mm", "7 mm"]
size = ["8 mm", "6 mm", "0.5 mm"]
material = "pzt-4"
[[plate.actuator]]
name = "A2"
region = "{name}"
centre = ["7 mm", "7 mm"]
size = ["6 mm", "8 mm", "0.7 mm"]
material = "pzt-5a"
[[plate.force]]
name = "F1"
region = "C"
centre = ["3 mm", "3 mm"]
'''


@pytest.mark.parametrize("name", ["R", "WG2"])
def test_neither_parts_nor_their_names_cover_the_name_of_a_region(name):
    figure = plots.plate_plan(loads(STUDY.format(name=name)).mounted_plate())
    FigureCanvasAgg(figure).draw()
    (axes,) = figure.axes
    boxes = {text.get_text(): text.get_window_extent() for text in axes.texts}
    assert boxes.keys() == {"A1", "A2", "F1", "L", name, "C"}
    drawn = [*axes.patches, *axes.lines]
    boxes |= {part.get_gid(): part.get_window_extent() for part in drawn if part.get_gid()}
    for (first, box), (second, other) in combinations(boxes.items(), 2):
        if {first, second} & {"L", name, "C"}:
            assert not box.overlaps(other), (first, second)
