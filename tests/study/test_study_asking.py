"""The tables that ask for more than bands: what they read and refuse, and that they come back as written."""

import math
import re
import tomllib

import pytest
from hypothesis import given, settings, strategies as st

from each import each
from five_parts import refused_study as refused, refusing
from haptonic.analyses import design
from haptonic.design.parameters import UNITS
from haptonic.errors import StudyError
from haptonic.study import Study, loads
from quick import PROTOTYPE as BASE

VARY = '[[design.vary]]\nparameter = "{}"\nfrom = {}\nto = {}\n'
OF = '[[tolerance.of]]\nparameter = "{}"\nspread = {}\n{}\n'
# what squares and rectangles do not have, nor cells of one pillar
OF_OTHERS = {
    "cell.pitch_2",
    "cell.angle",
    "cell.pillar.length",
    "cell.pillar.corner_radius",
    *(path for path in UNITS if path.startswith(("cell.site", "cell.disc", "cell.pillar.material."))),
    *(path for path in UNITS if path.startswith("material.c")),
}
PLAIN = 'material = "steel"\n[cell]\npitch = "10 mm"\nthickness = "1 mm"\n'


def vary(parameter: str, low: object, high: object) -> str:
    return VARY.format(parameter, low, high)


def of(parameter: str, spread: object, more: str = "") -> str:
    return OF.format(parameter, spread, more)


class TestRefusals:
    # (text after the reference study, path of the key, words of the error)
    CASES = {  # noqa: RUF012
        "spectrum upside down": (
            '[layers]\nlowest = "80 kHz"\nhighest = "40 kHz"', "layers.highest", ["40 kHz", "80 kHz"]
        ),
        "spectrum of one frequency": (
            '[layers]\nlowest = "60 kHz"\nhighest = "60 kHz"', "layers.highest", ["equal"]
        ),
        "grazing incidence": ('[layers]\nangle = "90 deg"', "layers.angle", ["below "]),
        "angle without a unit": ("[layers]\nangle = 30", "layers.angle", ["unit is missing"]),
        "half a row's direction": ("[layers]\nalong = [0, 1.5]", "layers.along", ["whole"]),
        "too many rows": ("[layers]\ncount = 21", "layers.count", ["at least 1 and at most 20"]),
        "mode of another form": ('[waveguide]\nmode = "17"', "waveguide.mode", ["'17'"]),
        "mode as a number": ("[waveguide]\nmode = 17", "waveguide.mode", ["not a text"]),
        "unknown end": ('[waveguide]\nends = "mirrors"', "waveguide.ends", ['write "mirror"', '"free"']),
        "half a row": ("[waveguide]\nrows = 0.5", "waveguide.rows", ["not a whole number"]),
        "misspelt parameter": (
            vary("cell.pillar.hight", '"13 mm"', '"16 mm"'), "design.vary[1].parameter",
            ["cell.pillar.hight", 'write "cell.pillar.height"', "others"],
        ),
        "parameter like no other": (
            vary("zzzzzzzz", '"13 mm"', '"16 mm"'), "design.vary[1].parameter", ["choose one of these"]
        ),
        "number for a parameter": (vary("x", 1, 2).replace('"x"', "3"), "design.vary[1].parameter", ["text"]),
        "bound without a unit": (
            vary("cell.pitch", '"6 mm"', '"7 mm"') + vary("cell.thickness", 1, '"2 mm"'),
            "design.vary[2].from", ["unit is missing", '"7 mm"'],
        ),
        "bound with a unit of another kind": (
            vary("cell.pillar.draft", '"1 mm"', '"2 deg"'), "design.vary[1].from", ["not a unit of "]
        ),
        "unit where none belongs": (
            vary("material.poisson_ratio", 0.3, '"0.35 mm"'), "design.vary[1].to", ["where none belongs"]
        ),
        "bounds upside down": (
            vary("cell.pillar.height", '"16 mm"', '"13 mm"'), "design.vary[1].to",
            ["13 mm", "more than the lowest value, 16 mm", "contradict", "exchange"],
        ),
        "equal bounds": (
            vary("cell.pitch", '"6 mm"', '"7 mm"') + vary("cell.pillar.draft", 0, 0), "design.vary[2].to",
            ["contradict"],
        ),
        "lowest value is no size": (
            vary("cell.pitch", '"-7 mm"', '"8 mm"'), "design.vary[1].from",
            ["-7 mm", "cell.pitch has to be at least 1 nm", "not be possible"],
        ),
        "highest value is not stable": (
            vary("material.poisson_ratio", 0.3, 0.5), "design.vary[1].to", ["below 0.5", "narrower"]
        ),
        "bound left out": (
            '[[design.vary]]\nparameter = "cell.pitch"\nfrom = "6 mm"', "design.vary[1].to", ["left out"]
        ),
        "same parameter twice": (
            vary("cell.pitch", '"6 mm"', '"7 mm"') * 2, "design.vary", ["cell.pitch, twice", "remove one"]
        ),
        "too many parameters": (vary("cell.pitch", '"6 mm"', '"7 mm"') * 13, "design.vary", ["at most 12"]),
        "no step in this cell": (
            vary("cell.pillar.step.height", '"6 mm"', '"7 mm"'), "design.vary[1].parameter",
            ["does not have it", "cell.pillar.diameter", "give it in [cell.pillar.step] first"],
        ),
        "sharp edge has no fillet": (
            vary("cell.pillar.fillet", 0, '"1 mm"'), "design.vary[1].parameter", ["does not have it"]
        ),
        "part of a finger": ('[design]\nfinger_force = "5 N"', "design.finger_force", ["all three", "add"]),
        "finger without force": (
            '[design]\nfinger_span = "5 mm"\nfinger_deflection = "5 um"', "design.finger_force", ["only some"]
        ),
        "weightless finger": (
            '[design]\nfinger_force = "0 N"\nfinger_span = "5 mm"\nfinger_deflection = "5 um"',
            "design.finger_force", ["above 0"],
        ),
        "no starts": ("[design]\nstarts = 0", "design.starts", ["at least 1 and at most 1024"]),
        "spread of nothing": (of("cell.piller.height", '"1 um"'), "tolerance.of[1].parameter", ["no number"]),
        "spread of zero": (of("cell.pitch", 0), "tolerance.of[1].spread", ["positive spread"]),
        "negative spread": (of("cell.pitch", '"-20 um"'), "tolerance.of[1].spread", ["-20 µm", "wrong sign"]),
        "spread that is no number": (of("cell.pitch", "nan"), "tolerance.of[1].spread", ["finite"]),
        "spread without a unit": (of("cell.pitch", 2e-5), "tolerance.of[1].spread", ["unit is missing"]),
        "plate per pillar": (
            of("cell.pitch", '"20 um"') + of("cell.thickness", '"20 um"', 'per = "pillar"'),
            "tolerance.of[2].per", ["cell.thickness", 'per = "batch"', "in common"],
        ),
        "unknown distribution": (
            of("cell.pitch", '"20 um"', 'distribution = "norml"'), "tolerance.of[1].distribution",
            ['write "normal"'],
        ),
        "same spread twice": (
            of("cell.pillar.height", '"20 um"') + of("cell.pillar.height", '"5 um"', 'per = "pillar"'),
            "tolerance.of", ["cell.pillar.height, twice"],
        ),
        "spread of an absent step": (
            of("cell.pitch", '"20 um"') + of("cell.pillar.step.diameter", '"20 um"'),
            "tolerance.of[2].parameter", ["does not have it", "leave this table out"],
        ),
        "certainty": ("[tolerance]\nconfidence = 1", "tolerance.confidence", ["below 1"]),
        "negative margin": ('[tolerance]\nmargin = "-1 Hz"', "tolerance.margin", ["at least 0"]),
        "too few samples": ("[tolerance]\nsamples = 15", "tolerance.samples", ["at least 16"]),
    }  # fmt: skip

    @each("case", CASES.items())
    def test_five_parts_at_the_right_place(self, case):
        text, path, words = case[1]
        error = refused(f"{BASE}\n{text}\n")
        assert error.argument == f"touchpad.toml: {path}"
        assert [word for word in words if word not in str(error)] == []

    def test_bounds_of_an_unknown_parameter_are_not_a_problem_of_their_own(self):
        error = refused(BASE + vary("cell.pich", '"6 mm"', '"7 mm"'))
        assert len(error.next_step.splitlines()) == 1

    def test_a_fillet_does_not_shrink_to_a_sharp_edge(self):
        filleted = BASE.replace('height = "14.7 mm"', 'height = "14.7 mm"\nfillet = "0.5 mm"')
        error = refused(filleted + vary("cell.pillar.fillet", 0, '"0.6 mm"'))
        assert (error.code, error.argument) == ("out-of-range", "touchpad.toml: design.vary[1].from")
        loads(filleted + vary("cell.pillar.fillet", '"50 um"', '"0.6 mm"'))

    def test_pitch_along_y_belongs_to_a_rectangle(self):
        error = refused(PLAIN + vary("cell.pitch_y", '"6 mm"', '"7 mm"'))
        assert error.argument == "touchpad.toml: design.vary[1].parameter"
        assert error.given == "'cell.pitch_y'"

    def test_plain_plate_has_no_pillar_to_vary(self):
        error = refused(PLAIN + of("cell.pillar.diameter", '"20 um"'))
        assert error.argument == "touchpad.toml: tolerance.of[1].parameter"

    @pytest.mark.parametrize(
        ("path", "parts", "next_step"),
        [
            ("cell.disc[3].high", 2, "write cell.disc[1].high or cell.disc[2].high"),
            ("cell.pillar.height", 2, "write cell.disc[1].high or cell.disc[2].high"),
            ("cell.pillar.diameter", 2, "write cell.disc[1].diameter"),
            ("cell.disc[1].high", 1, "write cell.pillar.height"),
            ("cell.disc[1].high", 0, "give it in [[cell.disc]] first, or leave this table out"),
            ("cell.pillar.height", 0, "give it in [cell.pillar] first, or leave this table out"),
        ],
    )
    def test_a_part_that_the_cell_lacks_is_replaced_or_given(self, path, parts, next_step):
        glue = '[[cell.disc]]\ndiameter = "3 mm"\nlow = "0 mm"\nhigh = "1 mm"\nmaterial = "epoxy"\n'
        pillar = '[[cell.disc]]\ndiameter = "3 mm"\nlow = "1 mm"\nhigh = "4 mm"\n'
        cell = {0: PLAIN, 1: BASE, 2: PLAIN + glue + pillar}[parts]
        error = refused(cell + vary(path, '"3 mm"', '"6 mm"'))
        assert error.argument == "touchpad.toml: design.vary[1].parameter"
        assert error.next_step == next_step

    def test_constants_of_a_ceramic_cannot_be_designed(self):
        """The design found could not be written as a study. They can have a spread, which needs none."""
        plain = re.sub(r'material = ".*"', 'material = "pzt-4"', PLAIN)
        error = refused(plain + vary("material.density", '"7000 kg/m^3"', '"8000 kg/m^3"'))
        assert (error.code, error.argument) == ("missing", "touchpad.toml: design.vary[1].parameter")
        assert loads(plain + of("material.density", '"10 kg/m^3"')).tolerance_settings.of[0].spread == 10


class TestReading:
    def test_every_value_is_in_si_units(self, every_key_text):
        study = loads(every_key_text)
        assert study.cell.pillar.draft == pytest.approx(math.radians(2), rel=1e-15)
        assert study.layers_settings.angle == pytest.approx(math.radians(30), rel=1e-15)
        assert (study.layers_settings.lowest, study.layers_settings.highest) == (40e3, 80e3)
        assert study.waveguide_settings.nodal_lines == (1, 12)
        angle, ratio = study.design_settings.vary
        assert (angle.low, angle.unit) == (0.0, "rad")
        assert angle.high == pytest.approx(math.radians(3), rel=1e-15)
        assert (ratio.low, ratio.high, ratio.unit) == (0.3, 0.35, "")
        limits = study.design_settings.limits
        assert (limits.finger_force, limits.finger_span, limits.finger_deflection) == (5.0, 0.02, 20e-6)
        size, stiffness = study.tolerance_settings.of
        assert (size.parameter, size.spread, size.distribution, size.per) == (
            "cell.pillar.diameter", 20e-6, "uniform", "pillar",
        )  # fmt: skip
        assert (stiffness.spread, stiffness.distribution, stiffness.per) == (5e8, "normal", "batch")

    def test_the_pillar_reaches_the_core(self, every_key_text):
        pillar = loads(every_key_text).cell.pillar
        assert (pillar.section, pillar.fillet) == ("square", 0.3e-3)
        assert pillar.draft == pytest.approx(math.radians(2), rel=1e-15)
        assert (pillar.step.diameter, pillar.step.height) == (2e-3, 6e-3)

    def test_the_brief_has_what_the_study_asks(self, every_key_text):
        brief = design.brief(loads(every_key_text))
        assert brief.carrier == 60e3
        assert brief.paths == ("cell.pillar.draft", "material.poisson_ratio")
        assert (brief.allowed.slenderness, brief.allowed.tool, brief.allowed.reach) == (8.0, 2e-3, 20e-3)
        assert brief.allowed.finger_force == 5.0
        assert brief.count == 8

    def test_what_is_left_out(self):
        study = loads(BASE)
        assert study.design_settings.vary == study.tolerance_settings.of == ()
        assert study.design_settings.limits.finger_force is None
        assert study.waveguide_settings.nodal_lines == (0, 17)
        for asking, path in ((study.design, "design.vary"), (study.tolerance, "tolerance.of")):
            with pytest.raises(StudyError) as caught:
                asking()
            assert caught.value.argument == path
            assert all(caught.value.parts().values())

    @pytest.mark.parametrize("table", [vary("cell.pitch", '"6 mm"', '"7 mm"'), of("cell.pitch", '"20 um"')])
    def test_the_carrier_is_needed(self, table):
        text = BASE.replace('carrier = "60 kHz"', "") + table
        study = loads(text)
        with pytest.raises(StudyError) as caught:
            (study.design if study.design_settings.vary else study.tolerance)()
        assert caught.value.argument == "carrier"
        assert all(caught.value.parts().values())

    def test_any_number_of_the_cell_can_be_named(self, every_key_text):
        study = loads(every_key_text)
        own = study.parameters()
        known = {path: unit for path, unit in UNITS.items() if path not in OF_OTHERS}
        assert set(known) < set(own)
        start = every_key_text.index("[[tolerance.of]]")
        end = every_key_text.index("[[sweep]]")
        for path, unit in known.items():
            written = f'"{0.01 * own[path]!r} {unit}"' if unit else repr(0.01 * own[path])
            text = every_key_text[:start] + of(path, written) + every_key_text[end:]
            assert loads(text).tolerance_settings.of[0].spread == pytest.approx(0.01 * own[path], rel=1e-12)


class TestManyParametersAtOnce:
    def test_sizes_that_only_go_together(self):
        study = loads(BASE)
        for alone in ({"cell.pitch": 0.003}, {"cell.pillar.diameter": 0.009}):
            with refusing(StudyError, "out-of-range", "cell.pillar.diameter"):
                study.with_parameters(alone)
        small = study.with_parameters({"cell.pitch": 0.003, "cell.pillar.diameter": 0.002})
        assert (small.cell.lattice.pitch, small.cell.pillar.diameter) == (0.003, 0.002)
        assert small.cell.pillar.height == study.cell.pillar.height
        large = study.with_parameters({"cell.pillar.diameter": 0.009, "cell.pitch": 0.012})
        assert (large.cell.lattice.pitch, large.cell.pillar.diameter) == (0.012, 0.009)

    def test_nothing_else_changes(self, every_key_text):
        study = loads(every_key_text)
        values = {"cell.pillar.step.height": 0.007, "material.density": 2650.0, "cell.pillar.draft": 0.0}
        changed = study.with_parameters(values)
        assert changed.parameters() == {**study.parameters(), **values}
        assert changed.sweep_settings == ()
        for name in (
            "title",
            "bands_settings",
            "layers_settings",
            "waveguide_settings",
            "design_settings",
            "tolerance_settings",
        ):
            assert getattr(changed, name) == getattr(study, name)

    def test_an_impossible_design_is_refused(self, every_key_text):
        with refusing(StudyError, "out-of-range", "cell.pillar.step.height"):
            loads(every_key_text).with_parameters({"cell.pillar.height": 0.005})


class TestWriting:
    def test_every_key_comes_back(self, every_key_text):
        study = loads(every_key_text)
        again = loads(study.to_toml())
        assert again == study
        assert again.inputs() == study.inputs()
        assert again.to_toml() == study.to_toml()
        assert tomllib.loads(study.to_toml())["design"]["vary"][0]["parameter"] == "cell.pillar.draft"
        assert 'spread = "20 µm"' in study.to_toml()

    @pytest.mark.filterwarnings("ignore::haptonic.errors.HaptonicWarning")
    @settings(max_examples=60)
    @given(st.data())
    def test_round_trip_is_exact(self, data):
        """Of studies with any possible pillar, and tables about anything that it has."""
        sizes = st.floats(0.5, 2.0)
        scale = data.draw(sizes)
        pillar = {
            "diameter": 3e-3 * scale, "height": 12e-3 * scale * data.draw(sizes),
            "section": data.draw(st.sampled_from(["round", "square"])),
            "draft": data.draw(st.floats(-0.01, 0.02)),
            "fillet": data.draw(st.just(0.0) | st.floats(1e-5, 5e-4)),
        }  # fmt: skip
        if data.draw(st.booleans()):
            pillar["step"] = {"diameter": 1.5e-3 * scale, "height": 0.4 * pillar["height"]}
        solid = {"youngs_modulus": 7e10 * data.draw(sizes), "poisson_ratio": 0.3, "density": 2700.0}
        cell = {"pitch": 7e-3 * scale, "thickness": 1e-3 * data.draw(sizes), "pillar": pillar}
        there = (
            set(UNITS)
            - {"cell.pitch_y"}
            - OF_OTHERS
            - ({"cell.pillar.fillet"} if not pillar["fillet"] else set())
        )
        there -= {path for path in UNITS if ".step." in path and "step" not in pillar}
        names = data.draw(st.lists(st.sampled_from(sorted(there)), unique=True, max_size=12))
        ranges = {"material.poisson_ratio": (0.1, 0.4), "cell.pillar.draft": (-0.3, 0.3)}
        rows = []
        for name in names:
            low, high = ranges.get(name, (1e3, 1e4) if name.startswith("material") else (1e-4, 1e-1))
            middle = data.draw(st.floats(low, high, exclude_min=True, exclude_max=True))
            rows.append({"parameter": name, "from": low, "to": middle})
        spreads = [
            {
                "parameter": name, "spread": data.draw(st.floats(1e-9, 1e6)),
                "distribution": data.draw(st.sampled_from(["normal", "uniform"])),
                "per": "pillar" if name.startswith("cell.pillar") and data.draw(st.booleans()) else "batch",
            }
            for name in names
        ]  # fmt: skip
        study = Study(
            material=solid,
            cell=cell,
            layers={"lowest": data.draw(st.floats(1, 1e4)), "angle": data.draw(st.floats(-1.5, 1.5))},
            waveguide={"width": data.draw(st.none() | st.floats(1e-9, 1e3))},
            design={"vary": rows, "tool": data.draw(st.none() | st.floats(1e-9, 1e3))},
            tolerance={"of": spreads, "margin": data.draw(st.floats(0, 1e9))},
        )
        again = loads(study.to_toml())
        assert again == study
        assert again.inputs() == study.inputs()
        assert again.to_toml() == study.to_toml()
