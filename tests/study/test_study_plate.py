"""The [plate] of a study: its map becomes tiles, its patches find their place, and nonsense is refused."""

import json
import math
import pickle
import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from five_parts import refused_study as refused, refusing
from haptonic.errors import HaptonicWarning, StudyError
from haptonic.fields import remade
from haptonic.fields.entries import Entries
from haptonic.materials import material
from haptonic.plate.layout.grid import Layout, pieces
from haptonic.plate.layout.parts import Plate
from haptonic.plate.layout.supports import Support
from haptonic.study import Study, load, loads
from quick import PROTOTYPE_PILLAR as PILLAR, PROTOTYPE_PLATE as CELL

STUDIES = Path(__file__).parents[2] / "studies"
PLATE = '''
[plate]
map = """
ooo1112f
ooo1112f
ooo1112f
"""
[plate.tiles]
o = "lattice"
f = "fine"
1 = "WG1"
2 = "WG2"
[plate.widths]
WG1 = "8 mm"
[[plate.cell]]
name = "fine"
change = { "cell.pillar.diameter" = "3 mm" }
[plate.clamp]
corners = "5 mm"
[[plate.actuator]]
name = "A1"
region = "WG1"
centre = ["12 mm", "10 mm"]
size = ["11.5 mm", "8 mm", "0.7 mm"]
material = "PZT 4"
bond = { thickness = "50 um", material = "Epoxy" }
voltage = "60 V"
[[plate.force]]
name = "F1"
region = "WG1"
centre = ["12 mm", "10 mm"]
size = ["4 mm", "4 mm"]
[plate.finger]
region = "WG1"
centre = ["12 mm", "10 mm"]
diameter = "10 mm"
damping = "10 N s/m"
[plate.response]
lowest = "1 kHz"
'''
TEXT = CELL + PILLAR + PLATE


def edited(*changes: tuple[str, str]) -> str:
    text = TEXT
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new, 1)
    return text


def drawn(lines: str, more: str = "", tiles: str = 'o = "lattice"\n1 = "WG1"') -> str:
    return f'{CELL}{PILLAR}[plate]\nmap = """\n{lines}\n"""\n{more}\n[plate.tiles]\n{tiles}\n'


OWN_PATCH = """
[plate.actuator.material]
s11 = "12.3 um^2/N"
s12 = "-4.05 um^2/N"
s13 = "-5.31 um^2/N"
s33 = "15.5 um^2/N"
s44 = "39 um^2/N"
d31 = "-123 pm/V"
d33 = "289 pm/V"
d15 = "496 pm/V"
permittivity_11 = 1475
permittivity_33 = 1300
density = "7500 kg/m^3"
name = "our ceramic"
[plate.actuator.bond]
thickness = "50 um"
material = {youngs_modulus = "3 GPa", poisson_ratio = 0.35, density = "1200 kg/m^3", name = "glue"}
"""
MAP = "ooo1112f\nooo1112f\nooo1112f\n"
CENTRE = 'centre = ["12 mm", "10 mm"]'
PATCH = 'size = ["11.5 mm", "8 mm", "0.7 mm"]'
A1 = '[[plate.actuator]]\nname = "A1"'
SECOND = (
    '[[plate.actuator]]\nname = "{}"\nregion = "WG1"\ncentre = ["{}", "10 mm"]\n'
    'size = ["4 mm", "4 mm", "0.5 mm"]\nmaterial = "pzt-4"\n' + A1
)
FORCE = '[[plate.force]]\nname = "F1"\nregion = "WG1"\n' + CENTRE
FINGER = '[plate.finger]\nregion = "WG1"\n' + CENTRE
FINE = 'change = { "cell.pillar.diameter" = "3 mm" }'
CLAMP = '[plate.clamp]\ncorners = "5 mm"'

# (changes of the study above, path of the key, words of the error)
MAPS = {
    "ragged rows": ((MAP, "ooo1112f\nooo112f\nooo1112f\n"), "plate.map", ["7 tiles in line 2", "8 tiles"]),
    "a row left out": ((MAP, "ooo1112f\n\nooo1112f\n"), "plate.map", ["0 tiles in line 2", "is empty"]),
    "unknown letter": ((MAP, "oooO112f\n" + MAP), "plate.map", ["'O' in line 1, column 4", 'write "o"']),
    "letter that looks alike": ((MAP, "ooo1l12f\n" + MAP), "plate.map", ["column 5", 'write "1"']),
    "letter like no other": ((MAP, "ooox112f\n" + MAP), "plate.map", ['add x = "..."']),
    "blank inside": ((MAP, "ooo 112f\n" + MAP), "plate.map", ["' ' in line 1, column 4", 'write "."']),
    "empty map": ((MAP, " \n"), "plate.map", ["empty"]),
    "map without tiles": ((MAP, "...\n...\n"), "plate.map", ["without tiles", "no plate"]),
    "number for a map": ((f'"""\n{MAP}"""', "3"), "plate.map", ["not a text"]),
    "first line of nothing": ((MAP, "........\n" + MAP), "plate.map", ["the first line"]),
    "last column of nothing": ((MAP, MAP.replace("f", "f.")), "plate.map", ["the last column"]),
    "rows no multiple": (("[plate.tiles]", "rows = 7\n[plate.tiles]"), "plate.rows", ["of 3", "rows = 6"]),
    "fewer rows than lines": (("[plate.tiles]", "rows = 1\n[plate.tiles]"), "plate.rows", ["rows = 3"]),
    "no rows": (("[plate.tiles]", "rows = 0\n[plate.tiles]"), "plate.rows", ["at least 1"]),
    "too many tiles": (
        (MAP, "ooo1112f" * 20 + "\n"), ("[plate.tiles]", "rows = 1000\n[plate.tiles]"),
        "plate.rows", ["1000 rows of 160 tiles", "at most 100000"],
    ),
    "letter without tiles": (('2 = "WG2"', '2 = "WG2"\nx = "WG3"'), "plate.tiles.x", ["'WG3'", "no tiles"]),
    "letter of two": (('2 = "WG2"', '2 = "WG2"\nxy = "WG3"'), "plate.tiles.xy", ["one letter"]),
    "letter of nothing": (('2 = "WG2"', '2 = "WG2"\n"." = "hole"'), "plate.tiles.'.'", ["absent"]),
    "two letters of a region": (('2 = "WG2"', '2 = "WG1"'), "plate.tiles.1", ["'WG1', twice"]),
    "blank name of a region": (('2 = "WG2"', '2 = " "'), "plate.tiles.2", ["that is not", "left blank"]),
    "number of a region": (('2 = "WG2"', "2 = 2"), "plate.tiles.2", ["not a text", "write a text in quotes"]),
    "no letters": (
        (PLATE[PLATE.index("[plate.tiles]"):], ""), "plate.tiles",
        ["meaning of the letters was left out", "[plate.tiles]"],
    ),
    "two pieces": ((MAP, "ooo1.12f\n" * 3), "plate.map", ["12 tiles, 9 tiles", "line 3, column 6"]),
    "joined by a corner": ((MAP, "ooo1112.\n" * 3 + ".......f\n"), "plate.map",
                           ["21 tiles, 1 tiles", "line 4"]),
    "columns": (("[plate.tiles]", "columns = 3\n[plate.tiles]"), "plate.columns",
                ["unknown key", "follows from its map", "add letters or rows"]),
    "pitch of a plate": (("[plate.tiles]", 'pitch = "7 mm"\n[plate.tiles]'), "plate.pitch",
                         ["give pitch in [cell]"]),
    "rim as a size": (("[plate.tiles]", 'margin = "3 mm"\n[plate.tiles]'), "plate.margin",
                      ["draw it with a letter of its own", "[plate.heights]"]),
}  # fmt: skip
LATTICES = {
    "lattice without a pillar": ((PILLAR, ""), (PLATE[PLATE.index("[[plate.cell]]"):], ""),
                                 ('f = "fine"', 'f = "WG3"'), "plate.tiles.o",
                                 ["plain plate", "[cell.pillar]"]),
    "other pitch in a column": (
        (MAP, MAP + "ffffffff\n"), (FINE, 'change = { "cell.pitch" = "8 mm" }'), "plate.map",
        ["in column 1", '8 mm of "fine" and 7 mm of "lattice"'],
    ),
    "other pitch in a row": ((FINE, 'change = { "cell.pitch" = "8 mm" }'), "plate.map",
                             ["in row 1 from below"]),
    "other thickness": ((FINE, 'change = { "cell.thickness" = "1 mm" }'), "plate.cell[1].change",
                        ["'cell.thickness'", "one of cell.pitch, cell.pitch_y",
                         "have its thickness and its material", "leave it out"]),
    "other material": ((FINE, 'change = { "material.density" = "8000 kg/m^3" }'), "plate.cell[1].change",
                       ["its material"]),
    "misspelt change": ((FINE, 'change = { "cell.pillar.heigth" = "3 mm" }'), "plate.cell[1].change",
                        ['write "cell.pillar.height"']),
    "change of a section": ((FINE, 'change = { "cell.pillar.section" = 3 }'), "plate.cell[1].change",
                            ["cannot differ between the lattices", "leave it out"]),
    "turn of a round section": ((FINE, 'change = { "cell.pillar.turn" = "9 deg" }'),
                                'plate.cell[1] "fine".change', ["cell.pillar.turn"]),
    "absent change": ((FINE, 'change = { "cell.pillar.step.height" = "3 mm" }'),
                      'plate.cell[1] "fine".change',
                      ["this study does not give it", "one of cell.pitch, cell.pillar.diameter"]),
    "change in another unit": ((FINE, 'change = { "cell.pillar.height" = "3 kHz" }'), "plate.cell[1].change",
                               ["not a unit of length"]),
    "change that does not build": ((FINE, 'change = { "cell.pillar.diameter" = "7 mm" }'),
                                   'plate.cell[1] "fine".change', ["less than 6.86 mm", "too wide"]),
    "negative change": ((FINE, 'change = { "cell.pillar.height" = "-7 mm" }'),
                        'plate.cell[1] "fine".change', ["cell.pillar.height = -7 mm", "negative"]),
    "no change": ((FINE, ""), "plate.cell[1].change", ["left out", "[plate.cell.change]"]),
    "changes that are a text": ((FINE, 'change = "3 mm"'), "plate.cell[1].change", ["a table is required"]),
    "lattice of the study's own name": (('name = "fine"', 'name = "lattice"'), "plate.cell[1].name",
                                        ["study's own cell"]),
    "lattice twice": (("[[plate.cell]]", f'[[plate.cell]]\nname = "fine"\n{FINE}\n[[plate.cell]]'),
                      "plate.cell[2].name", ["'fine'", "copied"]),
    "lattice without tiles": (('name = "fine"', 'name = "fime"'), "plate.cell[1].name",
                              ["no tile is of this lattice", '"fime" to [plate.tiles]']),
    "width of a lattice": (('WG1 = "8 mm"', 'fine = "8 mm"'), "plate.widths.fine",
                           ["it is a lattice", "plain plate"]),
    "width of an unknown region": (('WG1 = "8 mm"', 'WG11 = "8 mm"'), "plate.widths.WG11", ['write "WG1"']),
    "width beside a lattice": ((MAP, "ooooooof\n" + MAP), "plate.widths.WG1",
                               ["8 mm", "all its columns contain cells of a lattice"]),
    "height beside a lattice": (("[plate.widths]", '[plate.heights]\nWG1 = "8 mm"\n[plate.widths]'),
                                "plate.heights.WG1", ["all its rows contain cells of a lattice"]),
    "two widths in a column": ((MAP, MAP + "ooo2222f\n"), ('WG1 = "8 mm"', 'WG1 = "8 mm"\nWG2 = "9 mm"'),
                               "plate.widths", ["in column 4", '8 mm of "WG1" and 9 mm of "WG2"']),
    "width without a unit": (('WG1 = "8 mm"', "WG1 = 8"), "plate.widths.WG1", ["unit is missing"]),
    "width of nothing": (('WG1 = "8 mm"', 'WG1 = "0 mm"'), "plate.widths.WG1", ["zero"]),
    "one width for all": (
        ('[plate.widths]\nWG1 = "8 mm"\n', ""), ("[plate.tiles]", 'widths = "8 mm"\n[plate.tiles]'),
        "plate.widths", ["a table, [plate.widths], of lines", '"7 mm"'],
    ),
}  # fmt: skip
PATCHES = {
    "patch across a lattice": ((CENTRE, 'centre = ["5 mm", "10 mm"]'), 'plate.actuator[1] "A1".centre',
                               ["5 mm and 10 mm", 'across cells of the lattice "lattice"']),
    "patch on another region": ((CENTRE, 'centre = ["20 mm", "10 mm"]'), 'plate.actuator[1] "A1".centre',
                                ['onto the region "WG2"']),
    "patch beyond the plate": ((CENTRE, 'centre = ["12 mm", "1 mm"]'), 'plate.actuator[1] "A1".centre',
                               ["12 mm and 1 mm", "beyond the plate", 'lower left corner of']),
    "patch far away": ((CENTRE, 'centre = ["12 mm", "-1 m"]'), 'plate.actuator[1] "A1".centre', ["-1 m"]),
    "patch wider than its region": ((PATCH, 'size = ["24.1 mm", "8 mm", "0.7 mm"]'),
                                    'plate.actuator[1] "A1".centre', ["smaller"]),
    "patches overlap": ((A1, SECOND.format("A0", "8 mm")), 'plate.actuator[1] "A0".centre',
                        ['overlaps "A1"']),
    "patch on edge": ((PATCH, 'size = ["0.7 mm", "8 mm", "5 mm"]'), "plate.actuator[1].size",
                      ["5 mm", "at most its shorter side, 700 µm", "another order"]),
    "patch without thickness": ((PATCH, 'size = ["11.5 mm", "8 mm"]'), "plate.actuator[1].size",
                                ["left out"]),
    "patch of a text": ((PATCH, 'size = "8 mm"'), "plate.actuator[1].size",
                        ["a list of 3 quantities", "not a list"]),
    "patch of four sizes": ((PATCH, 'size = ["9 mm", "8 mm", "1 mm", "1 mm"]'), "plate.actuator[1].size",
                            ["a list of 3 quantities", "more than 3 items"]),
    "patch of no height": ((PATCH, 'size = ["9 mm", "8 mm", "0 mm"]'), "plate.actuator[1].size[3]", ["zero"]),
    "patch in Hz": ((PATCH, 'size = ["9 mm", "8 Hz", "1 mm"]'), "plate.actuator[1].size[2]",
                    ["not a unit of length"]),
    "steel patch": (('"PZT 4"', '"steel"'), 'plate.actuator[1].material',
                    ["not piezoelectric", "pzt-4"]),
    "unknown patch": (('"PZT 4"', '"PZT 44"'), 'plate.actuator[1].material', ['write "pzt-4"']),
    "unknown bond": (('"Epoxy"', '"epoxi"'), 'plate.actuator[1].bond.material', ['write "epoxy"']),
    "bond of nothing": (('"50 um"', '"0 um"'), "plate.actuator[1].bond.thickness", ["zero"]),
    "unknown region": (('region = "WG1"', 'region = "WG3"'), "plate.actuator[1].region",
                       ["'WG3'", 'write "WG']),
    "patch on the lattice": (('region = "WG1"', 'region = "fine"'), "plate.actuator[1].region",
                             ["it is a lattice"]),
    "name of two patches": ((A1, SECOND.format("A1", "2 mm")), "plate.actuator[2].name", ["'A1'", "copied"]),
    "force named like a patch": (('name = "F1"', 'name = "A1"'), "plate.force[1].name", ["'A1'"]),
    "negative voltage": (('"60 V"', '"-60 V"'), "plate.actuator[1].voltage", ["at least 0 V"]),
    "voltage in mm": (('"60 V"', '"60 mm"'), "plate.actuator[1].voltage", ["not a unit of voltage"]),
    "phase in s": (('voltage = "60 V"', 'phase = "1 s"'), "plate.actuator[1].phase", ["unit of angle"]),
    "force off its region": ((FORCE, FORCE.replace("12 mm", "1 mm")), 'plate.force[1] "F1".centre',
                             ['"lattice"']),
    "point off its region": ((FORCE, FORCE.replace("12 mm", "-1 um")), ('size = ["4 mm", "4 mm"]', ""),
                             'plate.force[1] "F1".centre', ['"lattice"']),
    "force on an unknown region": ((FORCE, FORCE.replace("WG1", "WG")), "plate.force[1].region", ['"WG']),
    "finger beyond the plate": ((FINGER, FINGER.replace("10 mm", "4.9 mm")), "plate.finger.centre",
                                ["12 mm and 4.9 mm", "disc of 10 mm reaches beyond"]),
    "finger on an unknown region": ((FINGER, FINGER.replace("WG1", "WG")), "plate.finger.region", ['"WG']),
    "finger that is not felt": (('damping = "10 N s/m"', 'mass = "1 g"'), "plate.finger.damping",
                ["nothing ties"]),
    "finger of no mass": (('damping = "10 N s/m"', 'mass = "0 kg"'), "plate.finger.mass", ["above 0 kg"]),
    "damping of a spring": (('"10 N s/m"', '"10 N/m"'), "plate.finger.damping", ["not a unit of damping"]),
}  # fmt: skip
SUPPORTS = {
    "spring without stiffness": ((CLAMP, '[plate.edges]\nleft = "spring"'), "plate.edges.spring",
                                 ["because left is on a spring", "1e12 N/m^3"]),
    "stiffness without spring": ((CLAMP, '[plate.edges]\nleft = "clamped"\nspring = "1e12 N/m^3"'),
                                 "plate.edges.spring", ["no edge is"]),
    "unknown support": ((CLAMP, '[plate.edges]\nleft = "clampd"'), "plate.edges.left", ['write "clamped"']),
    "unknown edge": ((CLAMP, '[plate.edges]\nuntop = "clamped"'), "plate.edges.untop", ['write "top"']),
    "stiffness of another kind": ((CLAMP, CLAMP + '\nspring = "1e12 N/m"'), "plate.clamp.spring",
                                  ["stiffness per area"]),
    "spring of nothing": ((CLAMP, CLAMP + '\nspring = "0 N/m^3"'), "plate.clamp.spring", ["above 0"]),
    "loss of a clamp": ((CLAMP, CLAMP + "\nloss_factor = 0.1"), "plate.clamp.loss_factor", ["does not move"]),
    "loss of an edge": ((CLAMP, "[plate.edges]\nloss_factor = 0.1"), "plate.edges.loss_factor",
                ["give a spring"]),
    "clamps that meet": ((CLAMP, CLAMP.replace("5", "99")), "plate.clamp.corners",
                         ["99 mm", "half of the shorter side", "would meet"]),
    "clamp of nothing": ((CLAMP, "[plate.clamp]"), "plate.clamp.corners", ["left out"]),
    "corners cut out": ((MAP, ".oo1112.\n" + MAP + ".oo1112.\n"), "plate.clamp.corners", ["cut out"]),
    "response upside down": (('lowest = "1 kHz"', 'lowest = "1 MHz"'), "plate.response.highest",
                             ["100 kHz", "more than the lowest frequency, 1 MHz"]),
    "response of one frequency": (('lowest = "1 kHz"', 'lowest = "100 kHz"'), "plate.response.highest",
                                  ["equal"]),
    "grid too wide": (('lowest = "1 kHz"', 'grid = "22 mm"'), "plate.response.grid",
                      ["at most 21 mm", "wider", 'grid = "1.05 mm"']),
    "tolerance of zero": (('lowest = "1 kHz"', "tolerance = 0"), "plate.response.tolerance", ["at most 0.1"]),
    "loss factor of one": (("[plate.tiles]", "loss_factor = 1\n[plate.tiles]"), "plate.loss_factor",
                ["below 1"]),
}  # fmt: skip


class TestRefusals:
    @pytest.mark.filterwarnings("ignore::haptonic.errors.HaptonicWarning")
    @pytest.mark.parametrize(
        "case", {**MAPS, **LATTICES, **PATCHES, **SUPPORTS}.items(), ids=lambda case: case[0]
    )
    def test_five_parts_at_the_right_place(self, case):
        *changes, path, words = case[1]
        error = refused(edited(*changes))
        assert error.argument.removeprefix("touchpad.toml: ").startswith(path)
        assert [word for word in words if word not in str(error)] == []

    def test_the_study_that_they_change_is_in_order(self):
        assert isinstance(loads(TEXT).mounted_plate(), Plate)

    def test_the_error_for_a_missing_plate_names_the_table(self):
        with pytest.raises(StudyError) as caught:
            loads(CELL).mounted_plate()
        assert caught.value.argument == "plate"
        assert "[plate.tiles]" in caught.value.next_step
        assert all(caught.value.parts().values())

    def test_a_region_named_almost_like_a_lattice_is_warned_about(self):
        with pytest.warns(HaptonicWarning, match=r'plate\.tiles\.o: "Latice".* Did you mean "lattice"'):
            loads(edited(('o = "lattice"', 'o = "Latice"')))

    def test_each_number_of_a_list_has_its_own_usual_range(self):
        thin = loads(edited((PATCH, 'size = ["11.5 mm", "8 mm", "50 um"]')))  # no patch is 50 µm wide
        assert thin.unusual() == ()

    def test_an_unusual_number_is_warned_about_by_its_place(self):
        with pytest.warns(HaptonicWarning, match=r"plate\.actuator\[1\]\.size\[3\]: 5 µm is unusual"):
            loads(edited((PATCH, 'size = ["11.5 mm", "8 mm", "5 um"]')))
        with pytest.warns(HaptonicWarning, match=r"plate\.widths\.WG1: 8 m is unusual.* Did you mean 8 mm"):
            loads(edited(('WG1 = "8 mm"', 'WG1 = "8 m"')))


class TestTouchpad:
    """The reference prototype, from the published drawing."""

    def test_sizes_and_pillars(self):
        plate = load(STUDIES / "touchpad.toml").mounted_plate()
        layout = plate.layout
        assert (layout.columns, layout.rows, layout.pillars) == (17, 20, 180)
        assert (layout.x[-1], layout.y[-1]) == pytest.approx((0.127, 0.140), rel=1e-12)
        for name in ("WG1", "WG2"):
            assert layout.area(name) == pytest.approx(0.032 * 0.140, rel=1e-12)
        assert layout.regions == ("WG1", "WG2")
        assert layout.corner("WG2") == pytest.approx((0.074, 0.0), rel=1e-12)
        assert layout.cells["lattice"].pillar.diameter == 0.0035
        assert layout.thickness == 0.0015
        assert plate.loss_factor == 2e-3
        assert plate.supports == (Support("corners", "clamped", length=0.005),)
        assert not plate.rigid

    def test_patch(self):
        (patch,) = load(STUDIES / "touchpad.toml").mounted_plate().actuators
        assert (patch.name, patch.size, patch.voltage) == ("A1", (0.0115, 0.008, 0.0007), 60)
        assert patch.centre == pytest.approx((0.037, 0.035), rel=1e-12)
        assert patch.bond.thickness == 50e-6


class TestTwoCarriers:
    def test_two_lattices_around_an_l(self):
        plate = load(STUDIES / "two_carriers.toml").mounted_plate()
        layout = plate.layout
        assert {name: cell.pillar.height for name, cell in layout.cells.items()} == {
            "lattice": 0.0147, "short": 0.012,
        }  # fmt: skip
        assert layout.pillars == 72 - len(layout.of("L")) - len(layout.of("straight")) == 72 - 22 - 6
        assert set(layout.tiles[1]) == {"lattice", "L"}  # the foot of the L lies below

    def test_a_lattice_may_turn_its_sections(self):
        square = 'section = "square"\nturn = "20 deg"'
        text = edited((FINE, 'change = { "cell.pillar.turn" = "35 deg" }'))
        study = loads(text.replace("[cell.pillar]", f"[cell.pillar]\n{square}"))
        turns = {
            name: np.rad2deg(cell.pillar.turn) for name, cell in study.mounted_plate().layout.cells.items()
        }
        assert turns == pytest.approx({"lattice": 20, "fine": 35})
        assert loads(study.to_toml()) == study

    def test_without_a_region_a_centre_counts_from_the_corner_of_the_plate(self):
        study = load(STUDIES / "two_carriers.toml")
        named, plate = study.mounted_plate(), study.plate_settings
        placed = remade(plate, actuator=named.actuators, force=named.forces, finger=named.finger)
        assert remade(study, plate_settings=placed).mounted_plate() == named
        assert [patch.region for patch in placed.actuator] == [None, None, None]

    def test_antiphase_is_exact(self):
        arm, foot, _ = load(STUDIES / "two_carriers.toml").mounted_plate().actuators
        assert (arm.amplitude, foot.amplitude) == (60, -60)

    @pytest.mark.parametrize(
        ("carrier", "driven"), [(None, ("arm", "foot")), (58e3, ("arm", "foot")), (76e3, ("straight",))]
    )
    def test_drives_of_one_carrier_act_alone(self, carrier, driven):
        plate = load(STUDIES / "two_carriers.toml").mounted_plate(carrier)
        assert tuple(drive.name for drive in plate.drives if drive.amplitude) == driven
        assert len(plate.drives) == 3

    def test_carriers_begin_with_that_of_the_study(self):
        study = load(STUDIES / "two_carriers.toml")
        assert study.carriers == (58e3, 76e3)
        assert remade(study, carrier=76e3).carriers == (76e3,)
        assert study.without_plate().carriers == (58e3,)

    @pytest.mark.parametrize("carrier", [None, 60e3])
    def test_a_carrier_that_no_drive_has_is_refused(self, carrier):
        study = load(STUDIES / "two_carriers.toml")
        drives = tuple(replace(patch, carrier=76e3) for patch in study.plate_settings.actuator)
        plate = remade(study.plate_settings, actuator=drives)
        with refusing(StudyError, "conflict", "carrier", 'write carrier = "76 kHz" at the top of the study'):
            remade(study, carrier=carrier, plate_settings=plate)

    def test_lattices_beside_each_region(self):
        layout = load(STUDIES / "two_carriers.toml").mounted_plate().layout
        assert (layout.beside(["L"]), layout.beside(["straight"])) == (["lattice"], ["short"])
        assert layout.beside(["L", "straight"]) == ["lattice", "short"]
        assert layout.beside([]) == []


# --- layout ----------------------------------------------------------------------------------------------

pitches = st.floats(5e-3, 9e-3)
LETTERS = {"o": "lattice", "f": "fine", "1": "WG1", "2": "WG2"}


@st.composite
def plates(draw):
    """(study, lines of its map) of one piece, with a width for regions that have columns of their own."""
    columns, count = draw(st.integers(1, 6)), draw(st.integers(1, 5))
    line = st.text("of12.", min_size=columns, max_size=columns)
    lines = draw(st.lists(line, min_size=count, max_size=count))
    for i, row in enumerate(lines):  # the first column and the last line tie all pieces together
        lines[i] = ("o" if row[0] == "." else row[0]) + row[1:]
        lines[i] = lines[i].replace(".", "o") if i == count - 1 or draw(st.booleans()) else lines[i]
    whole = ["".join(row) for row in lines]
    tiles = {letter: name for letter, name in LETTERS.items() if letter in "".join(whole)}
    free = [{row[j] for row in whole} for j in range(columns)]
    own = {
        name for letter, name in tiles.items() for column in free if letter in column and not column & {*"of"}
    }
    width = draw(st.floats(1e-3, 2e-2))
    plate = {
        "map": "\n".join(whole),
        "rows": count * draw(st.integers(1, 3)),
        "tiles": tiles,
        "widths": dict.fromkeys(sorted(own - {"lattice", "fine"}), width),
        "response": {"grid": 5e-4},
        "cell": [{"name": "fine", "change": {"cell.pillar.height": 0.012}}] if "f" in tiles else [],
    }
    solid = {"youngs_modulus": 7e10, "poisson_ratio": 0.33, "density": 2700.0, "loss_factor": 1e-3}
    cell = {
        "lattice": "rectangular", "pitch": draw(pitches), "pitch_y": draw(pitches),
        "thickness": 1.5e-3, "pillar": {"diameter": 3e-3, "height": 14e-3},
    }  # fmt: skip
    data = {"material": solid, "cell": cell, "plate": plate}
    there = [[letter != "." for letter in row] for row in whole]
    borders = [whole[0], whole[-1], "".join(r[0] for r in whole), "".join(r[-1] for r in whole)]
    if len(pieces(there * (plate["rows"] // count))) > 1 or any(set(b) == {"."} for b in borders):
        return draw(plates())
    return Study(**data), whole


class TestLayout:
    @settings(deadline=None, max_examples=60)
    @given(plates())
    def test_tiles_are_where_the_map_has_them(self, drawing):
        study, lines = drawing
        layout = study.mounted_plate().layout
        letters = {name: letter for letter, name in study.plate_settings.tiles.items()} | {None: "."}
        again = ["".join(letters[name] for name in row) for row in reversed(layout.tiles)]
        assert again == lines * (layout.rows // len(lines))
        assert study.plate_settings.map == "\n".join([*lines, ""])

    @settings(deadline=None, max_examples=60)
    @given(plates())
    def test_lines_ascend_and_areas_add_up(self, drawing):
        study, lines = drawing
        layout, cell = study.mounted_plate().layout, study.cell
        assert layout.x[0] == layout.y[0] == 0.0
        assert all(a < b for a, b in zip(layout.x, layout.x[1:], strict=False))
        assert all(a < b for a, b in zip(layout.y, layout.y[1:], strict=False))
        names = [*layout.regions, *layout.cells]
        box = layout.x[-1] * layout.y[-1]
        holes = sum(
            (layout.x[j + 1] - layout.x[j]) * (layout.y[i + 1] - layout.y[i])
            for i, row in enumerate(layout.tiles)
            for j, name in enumerate(row)
            if name is None
        )
        assert sum(layout.area(name) for name in names) == pytest.approx(box - holes, rel=1e-12)
        pillars = sum(line.count("o") + line.count("f") for line in lines) * (layout.rows // len(lines))
        assert layout.pillars == pillars
        lattice = sum(layout.area(name) for name in layout.cells)
        assert lattice == pytest.approx(pillars * cell.lattice.area, rel=1e-12)

    @settings(deadline=None, max_examples=60)
    @given(plates())
    def test_columns_have_the_widths_of_the_study(self, drawing):
        study, lines = drawing
        layout, widths = study.mounted_plate().layout, study.plate_settings.widths
        for j in range(layout.columns):
            names = {LETTERS.get(line[j]) for line in lines}
            wide = [] if names & {"lattice", "fine"} else [widths[name] for name in names if name in widths]
            expected = wide[0] if wide else study.cell.lattice.pitch
            assert layout.x[j + 1] - layout.x[j] == pytest.approx(expected, rel=1e-9)

    @settings(deadline=None, max_examples=60)
    @given(plates())
    def test_every_side_face_closes_the_outline(self, drawing):
        """What looks left is as long as what looks right, and the tiles at the rim are their own."""
        layout = drawing[0].mounted_plate().layout
        heights = {
            side: math.fsum(layout.bounds(tile)[3] - layout.bounds(tile)[1] for tile in layout.edge(side))
            for side in ("left", "right")
        }
        assert heights["left"] == pytest.approx(heights["right"], rel=1e-12)
        assert heights["left"] >= layout.y[-1] * (1 - 1e-12)
        assert {(0, j) for j in range(layout.columns) if layout.at((0, j))} <= set(layout.edge("bottom"))

    @settings(deadline=None, max_examples=60)
    @given(plates())
    def test_round_trip_is_exact(self, drawing):
        study, _ = drawing
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", HaptonicWarning)
            again = loads(study.to_toml())
        assert again == study
        assert hash(again) == hash(study)
        assert again.inputs() == study.inputs()
        assert again.to_toml() == study.to_toml()
        assert again.mounted_plate() == study.mounted_plate()

    @staticmethod
    def laid(*lines: str) -> Layout:
        study = loads(drawn("\n".join(lines)))
        return study.mounted_plate().layout

    def test_the_first_line_is_the_top(self):
        layout = self.laid("oo", "1o")
        assert layout.tiles == (("WG1", "lattice"), ("lattice", "lattice"))
        assert layout.corner("WG1") == (0.0, 0.0)

    def test_a_hole_and_a_notch(self):
        layout = self.laid("o11", "o.1", "o1.", "oo1")
        assert layout.at((2, 1)) is None
        assert layout.at((-1, 0)) is layout.at((0, 3)) is layout.at((4, 0)) is None
        assert layout.edge("right") == [(0, 2), (1, 1), (2, 0), (2, 2), (3, 2)]
        assert layout.edge("top") == [(0, 2), (1, 1), (3, 0), (3, 1), (3, 2)]

    def test_what_lies_under_a_rectangle(self):
        layout = self.laid("oo1", "oo1")
        p = 7e-3
        assert layout.under((p, 0.0, 2 * p, p)) == [(0, 1)]
        assert layout.under((0.99 * p, 0.0, 2 * p, 1.01 * p)) == [(0, 0), (0, 1), (1, 0), (1, 1)]
        assert layout.under((1.5 * p, 1.5 * p, 3.5 * p, 1.6 * p)) == [(1, 1), (1, 2), (1, 3)]
        assert layout.under((-0.5 * p, -0.5 * p, 0.5 * p, 0.5 * p)) == [(-1, -1), (-1, 0), (0, -1), (0, 0)]
        assert layout.under((0.5 * p, p, 0.5 * p, p)) == [(0, 0), (1, 0)]  # a point on a line touches both
        assert layout.under((0.5 * p, 0.5 * p, 0.5 * p, 0.5 * p)) == [(0, 0)]

    def test_widths_are_of_columns_without_a_lattice(self):
        study = loads(
            drawn("o1111\no1111\nooo11", tiles='o = "lattice"\n1 = "WG1"\n[plate.widths]\nWG1 = "9 mm"')
        )
        layout = study.mounted_plate().layout
        assert [round(1e3 * (b - a), 9) for a, b in zip(layout.x, layout.x[1:], strict=False)] == [
            7,
            7,
            7,
            9,
            9,
        ]

    def test_a_lattice_brings_its_own_pitch(self):
        text = CELL.replace("[cell]", '[cell]\nlattice = "rectangular"\npitch_y = "6 mm"') + PILLAR
        text += '[plate]\nmap = "of1"\n[plate.tiles]\no = "lattice"\nf = "fine"\n1 = "WG1"\n'
        text += (
            '[[plate.cell]]\nname = "fine"\nchange = { cell.pitch = "5 mm", "cell.pillar.height" = "9 mm" }\n'
        )
        layout = loads(text).mounted_plate().layout
        assert layout.x == pytest.approx((0, 7e-3, 12e-3, 19e-3), rel=1e-12)
        assert layout.y == (0.0, 6e-3)
        assert layout.cells["fine"].pillar.height == 9e-3
        assert layout.cells["fine"].material == layout.material

    def test_plain_plate_needs_no_pillar(self):
        layout = loads(CELL + '[plate]\nmap = "11\\n11"\ntiles = { 1 = "all" }\n').mounted_plate().layout
        assert (dict(layout.cells), layout.pillars, layout.regions) == ({}, 0, ("all",))


class TestPieces:
    def test_largest_first(self):
        assert pieces([[True, False, True], [True, False, False]]) == [{(0, 0), (1, 0)}, {(0, 2)}]
        assert pieces([[True, False], [False, True]]) == [{(0, 0)}, {(1, 1)}]
        assert pieces([]) == []


class TestWhatIsFixedToIt:
    def test_positions_count_from_the_corner_of_the_region(self):
        plate = loads(TEXT).mounted_plate()
        for part in (*plate.actuators, *plate.forces, plate.finger):
            assert part.centre == pytest.approx((0.033, 0.010), rel=1e-12)
        assert plate.forces[0].amplitude == 1
        assert (plate.finger.mass, plate.finger.stiffness, plate.finger.damping) == (None, 0.0, 10.0)
        assert plate.actuators[0].material.name == "pzt-4"
        assert plate.actuators[0].bond.material.name == "epoxy"
        assert plate.loss_factor == 1e-3  # the material's

    @pytest.mark.parametrize(("phase", "factor"), [(0, 1), (90, 1j), (-90, -1j), (270, -1j), (360, 1)])
    def test_phase(self, phase, factor):
        plate = loads(
            edited(('voltage = "60 V"', f'voltage = "60 V"\nphase = "{phase} deg"'))
        ).mounted_plate()
        assert plate.actuators[0].amplitude == 60 * factor

    def test_phase_in_between(self):
        plate = loads(edited(('voltage = "60 V"', 'voltage = "60 V"\nphase = "30 deg"'))).mounted_plate()
        assert plate.actuators[0].amplitude == pytest.approx(60 * (math.sqrt(0.75) + 0.5j), rel=1e-12)

    def test_a_patch_may_fill_its_region_and_touch_another(self):
        size = 'size = ["24 mm", "21 mm", "0.7 mm"]'
        plate = loads(edited((PATCH, size), (CENTRE, 'centre = ["12 mm", "10.5 mm"]'))).mounted_plate()
        assert plate.actuators[0].size == (0.024, 0.021, 0.0007)
        side_by_side = edited((A1, SECOND.format("A0", "2 mm")), (PATCH, PATCH.replace("11.5", "16")))
        assert (
            len(loads(side_by_side.replace(CENTRE, 'centre = ["12 mm", "10 mm"]')).mounted_plate().actuators)
            == 2
        )

    def test_a_patch_fits_into_an_l_or_not(self):
        """It may cross from one arm into the other, and not the notch between them."""
        patch = (
            '[[plate.actuator]]\nname = "A"\nregion = "WG1"\ncentre = ["{} mm", "{} mm"]\n'
            'size = ["10 mm", "10 mm", "1 mm"]\nmaterial = "pzt-4"\n'
        )
        guide = drawn("1oo\n1oo\n111")
        with refusing(StudyError, "out-of-range", 'study: plate.actuator[1] "A".centre'):
            loads(guide + patch.format(7, 7))
        wide = drawn("11o\n11o\n111")
        assert loads(wide + patch.format(7, 7)).mounted_plate().actuators[0].centre == (7e-3, 7e-3)

    def test_a_force_at_the_border_of_its_region(self):
        point = FORCE.replace("12 mm", "0 mm").replace("10 mm", "0 mm")
        plate = loads(edited((FORCE, point), ('size = ["4 mm", "4 mm"]', ""))).mounted_plate()
        assert (plate.forces[0].centre, plate.forces[0].size) == ((0.021, 0.0), None)

    def test_a_force_on_the_lattice(self):
        force = '[[plate.force]]\nname = "F"\nregion = "lattice"\ncentre = ["3 mm", "3 mm"]\nforce = "2 N"\n'
        assert loads(drawn("o11") + force).mounted_plate().forces[0].amplitude == 2

    def test_a_finger_at_the_rim_and_over_a_hole(self):
        finger = '[plate.finger]\nregion = "{}"\ncentre = {}\ndiameter = "14 mm"\nstiffness = "1 N/m"\n'
        inside = '["7 mm", "7 mm"]'
        assert loads(drawn("ooo\noo1") + finger.format("lattice", inside)).mounted_plate().finger.centre == (
            7e-3,
            7e-3,
        )
        for lines in ("oo1\no.o\nooo", "..1\noo1\nooo"):
            centre = '["7 mm", "12 mm"]'
            with refusing(StudyError, "out-of-range", "study: plate.finger.centre"):
                loads(drawn(lines) + finger.format("lattice", centre))
        # the tile that is cut out lies in the corner of the square around the disc, not under the disc
        rim = finger.replace("14 mm", "13.8 mm").format("lattice", '["7 mm", "7 mm"]')
        cut = drawn("o111\no111\n.o11")
        with refusing(StudyError, "out-of-range", "study: plate.finger.centre"):
            loads(cut + rim)
        far = finger.replace("14 mm", "9 mm").format("lattice", '["10.4 mm", "10.4 mm"]')
        assert loads(cut + far).mounted_plate().finger.diameter == 9e-3

    def test_a_material_of_any_spelling(self):
        for name in ("pzt-4", "PZT_4", " Pzt 4 "):
            assert (
                loads(edited(('"PZT 4"', f'"{name}"'))).mounted_plate().actuators[0].material.name == "pzt-4"
            )


class TestSupports:
    def supports(self, more: str) -> Plate:
        return loads(drawn("oo1\noo1", tiles='o = "lattice"\n1 = "WG1"\n' + more)).mounted_plate()

    def test_every_edge_and_the_corners(self):
        plate = self.supports(
            '[plate.edges]\nleft = "spring"\nright = "clamped"\nbottom = "simple"\nspring = "1e12 N/m^3"\n'
            'loss_factor = 0.1\n[plate.clamp]\ncorners = "7 mm"\nspring = "1e13 N/m^3"\nloss_factor = 0.2\n'
        )
        assert plate.supports == (
            Support("left", "spring", None, 1e12, 0.1),
            Support("right", "clamped"),
            Support("bottom", "simple"),
            Support("corners", "spring", 7e-3, 1e13, 0.2),
        )
        assert plate.rigid_modes == 0

    @pytest.mark.parametrize(
        ("edges", "count"),
        [
            ("", 6),
            ('left = "clamped"', 0),
            ('left = "spring"\nspring = "1e9 N/m^3"', 0),
            # a simply supported face slides along its normal, and turns about both lines in it: 3.
            # An opposite one forbids the turns; one at a right angle leaves the turn about the edge of both.
            ('left = "simple"', 3),
            ('top = "simple"', 3),
            ('left = "simple"\nright = "simple"', 1),
            ('bottom = "simple"\ntop = "simple"', 1),
            ('left = "simple"\ntop = "simple"', 1),
            ('left = "simple"\nright = "simple"\ntop = "simple"', 0),
        ],
    )
    def test_rigid_body_modes_are_counted(self, edges, count):
        plate = self.supports(f"[plate.edges]\n{edges}\n")
        assert plate.rigid_modes == count
        assert plate.rigid == (count > 0)

    def test_the_corners_hold_it(self):
        assert self.supports('[plate.clamp]\ncorners = "1 mm"\n').rigid_modes == 0


class TestInAStudy:
    def test_a_plate_that_is_not_there_leaves_no_trace(self):
        study = loads(CELL)
        assert study.plate_settings is None
        assert "[plate" not in study.to_toml()
        assert "plate" not in study.inputs()

    def test_inputs_hold_the_constants_of_patch_and_bond(self):
        inputs = json.loads(json.dumps(loads(TEXT).inputs(), allow_nan=False))["plate"]
        assert inputs["materials"]["actuator[1].material"]["density"] == 7500.0
        assert inputs["materials"]["actuator[1].bond.material"]["kind"] == "isotropic"
        assert inputs["tiles"] == {"o": "lattice", "f": "fine", "1": "WG1", "2": "WG2"}
        assert inputs["actuator"][0]["centre"] == [0.012, 0.010]

    def test_own_constants_of_patch_and_glue_come_back(self):
        named = 'material = "PZT 4"\nbond = { thickness = "50 um", material = "Epoxy" }\n'
        text = edited((named, ""), ("[[plate.force]]", OWN_PATCH + "[[plate.force]]"))
        study = loads(text)
        (patch,) = study.mounted_plate().actuators
        assert np.array_equal(patch.material.stiffness, material("pzt-4").stiffness)
        assert np.array_equal(patch.material.coupling, material("pzt-4").coupling)
        assert patch.bond.material.youngs_modulus == 3e9
        again = loads(study.to_toml())
        assert again == study
        assert again.inputs() == study.inputs()
        assert loads(text.replace('"-123 pm/V"', '"-140 pm/V"')).inputs() != study.inputs()

    def test_every_key_comes_back(self, every_key_text):
        study = loads(every_key_text)
        again = loads(study.to_toml())
        assert (again, again.mounted_plate()) == (study, study.mounted_plate())
        assert pickle.loads(pickle.dumps(study)) == study
        assert '"""\no11f\no11f\n2222\n"""' in study.to_toml()

    @pytest.mark.parametrize("title", ['a\nb "c"', "a\nb \\ c", "\na", "a\n", 'a\n"""', "a\nb\x7f", "a\r\nb"])
    def test_a_text_of_several_lines_comes_back(self, title):
        study = remade(loads(CELL), title=title)
        assert loads(study.to_toml()).title == title

    def test_a_changed_study_keeps_its_plate_and_a_sweep_does_not(self):
        study = loads(TEXT + '[[sweep]]\nvary = "cell.pitch"\nfrom = "4 mm"\nto = "8 mm"\nsteps = 3\n')
        thicker = study.with_parameter("cell.thickness", 1.6e-3)
        assert thicker.mounted_plate().layout.thickness == 1.6e-3
        assert thicker.mounted_plate().actuators == study.mounted_plate().actuators
        # with a pitch of 4 mm the patch would not fit on the plate
        assert [design.plate_settings for design in study.designs(study.sweep_settings[0])] == [None] * 3
        with refusing(StudyError, "out-of-range", 'plate.actuator[1] "A1".centre'):
            study.with_parameter("cell.pitch", 4e-3)

    def test_no_expression_names_the_plate(self):
        assert not [path for path in loads(TEXT).parameters() if path.startswith("plate")]


class TestEntries:
    def test_value(self):
        first, other = Entries({"a": 1, "b": 2}), Entries([("b", 2), ("a", 1)])
        assert first == other == {"a": 1, "b": 2}
        assert hash(first) == hash(other)
        assert Entries({"a": 1}) != first
        assert pickle.loads(pickle.dumps(first)) == first
        assert repr(first) == "Entries({'a': 1, 'b': 2})"
        with pytest.raises(TypeError):
            first["a"] = 3
