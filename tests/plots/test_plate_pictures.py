"""Pictures of plates: what is drawn where, that it can be read, and that the moving one moves."""

from __future__ import annotations

import re
from dataclasses import replace

import matplotlib as mpl
import numpy as np
import pytest
import xarray as xr
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image
from seeing import Drawn, artists, assert_readable, shown_texts
from simulated_plates import ALUMINIUM, GAP, LINES, busy_plate, notched, plate, prototype, turned, vibration

from daily import daily
from haptonic import plots
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.parts import Plate
from haptonic.plate.layout.supports import Support
from haptonic.plots import spectra
from haptonic.plots.moving import FRAMES
from haptonic.response import FrequencyResponse

FREQUENCY = np.linspace(0.0, 100e3, 401)
INSIDE = (GAP[0] < FREQUENCY) & (GAP[1] > FREQUENCY)
CONTRAST = {
    "WG1 over WG2": np.where(INSIDE, 33.0, 1.0),
    "WG1 over the rest of the plate": np.where(INSIDE, 25.0, 0.0),
}
VELOCITY = {"WG1": np.full(401, 1e-4), "WG2": np.where(INSIDE, 1e-6, 1e-4), "rest": FREQUENCY * 1e-10}
LOW = replace(plate().actuators[0], centre=(37e-3, 7e-3), size=(6e-3, 5e-3, 0.5e-3))
PLACES = np.stack(np.meshgrid(np.arange(0, 0.128, 2e-3), np.arange(0, 0.014, 2e-3)), -1).reshape(-1, 2)
FRICTION = xr.Dataset(
    {end: ("point", np.linspace(0.1, 0.9, len(PLACES))) for end in ("value", "low", "high")},
    {"x": ("point", PLACES[:, 0]), "y": ("point", PLACES[:, 1])},
)
IMPEDANCE = 30 + 1 / (2j * np.pi * FREQUENCY[1:] * 1.8e-9)


def held(*supports: Support, layout: Layout | None = None) -> Plate:
    return Plate(layout or prototype(), supports=supports)


PICTURES = {
    "maps": lambda: plots.maps(vibration(), LINES.tolist(), prototype(), GAP),
    "maps, one, measured": lambda: plots.maps(vibration("measured"), [58.8e3], prototype(), None),
    "maps, two": lambda: plots.maps(vibration(), [45e3, 58.8e3], prototype(), GAP),
    "maps, compared": lambda: plots.maps_compared(
        {"computed": vibration(), "scan": vibration("measured")},
        LINES.tolist(),
        prototype(),
        GAP,
    ),
    "maps, turned": lambda: plots.maps(turned(), [1e3, 2e3], prototype(), None),
    "contrast": lambda: plots.contrast_spectrum(FREQUENCY, CONTRAST, [GAP]),
    "contrast, no gap": lambda: plots.contrast_spectrum(FREQUENCY, CONTRAST, []),
    "velocity": lambda: plots.velocity_spectrum(FREQUENCY, VELOCITY, [GAP]),
    "velocity, seven": lambda: plots.velocity_spectrum(
        FREQUENCY, {f"region {k}": np.full(401, 2.0**-k) for k in range(7)}, [GAP], units="m/s/N"
    ),
    "impedance": lambda: plots.impedance_spectrum(FREQUENCY[1:], IMPEDANCE, [GAP]),
    "plan": lambda: plots.plate_plan(plate()),
    "plan, busy": lambda: plots.plate_plan(busy_plate()),
    "plan, notched": lambda: plots.plate_plan(
        held(Support("corners", "clamped", length=6e-3), layout=notched())
    ),
    "plan, low": lambda: plots.plate_plan(Plate(prototype(rows=2))),
    "plan, two rows": lambda: plots.plate_plan(replace(plate(), layout=prototype(rows=2), actuators=(LOW,))),
    "friction": lambda: plots.friction_map(FRICTION, prototype(), title="58.8 kHz, simulated"),
}
# one of each kind, of the fullest and of the least usual shape
DAILY = ("maps, compared", "contrast", "velocity, seven", "impedance", "plan, busy", "friction")


@pytest.fixture(scope="module")
def drawn() -> Drawn:
    return Drawn(PICTURES)


def segments(figure: Figure, gid: str) -> set:
    """Ends of the lines of a collection, in mm, rounded; the lower or left one first."""
    return {
        tuple(sorted(tuple(float(round(c, 6)) for c in end) for end in line))
        for collection in artists(figure, gid)
        for line in collection.get_segments()
    }


@pytest.mark.parametrize("name", daily(PICTURES, *DAILY))
class TestEveryPicture:
    def test_no_text_lies_on_another_or_leaves_the_picture(self, drawn, name):
        assert_readable(drawn[name])

    def test_legends_stay_in_the_picture(self, drawn, name):
        figure = drawn[name]
        FigureCanvasAgg(figure).draw()
        for legend in figure.legends:
            box = legend.get_window_extent()
            assert box.x0 >= 0
            assert box.x1 <= figure.bbox.width

    def test_axes_name_what_they_show_with_its_unit(self, drawn, name):
        known = {
            "kHz",
            "dB",
            "mm",
            "µm/s/V",
            "mm/s/V",
            "m/s/V",
            "m/s/N",
            "mS",
            "µS",
            "nF",
            "pm/V",
            "nm/V",
            "mm/V",
            "µm/V",
            "%",
        }
        panels = drawn[name].axes
        assert panels[0].get_ylabel()
        for axes in panels:
            for label in filter(None, (axes.get_xlabel(), axes.get_ylabel())):
                assert label[label.rindex("(") + 1 : label.rindex(")")] in known, label

    def test_type_and_panels_are_large_enough_to_read(self, drawn, name):
        figure = drawn[name]
        shrink = min(1.0, 12 / 2.54 / figure.get_figwidth())
        FigureCanvasAgg(figure).draw()
        for axes in figure.axes:
            sizes = [text.get_fontsize() for text in [*axes.texts, axes.title, axes.xaxis.label]]
            assert min([*sizes, *(t.get_fontsize() for t in axes.get_xticklabels())]) * shrink > 6.5
            if axes.get_label() != "<colorbar>":
                box = axes.get_position()
                assert box.width * figure.get_figwidth() * 2.54 > 3, "cm"
                assert box.height * figure.get_figheight() * 2.54 > 1.5, "cm"


class TestMaps:
    def test_each_is_the_vibration_when_its_largest_point_is_farthest_out(self, drawn):
        """By another route: of all moments of the cycle, that one; its largest value ends the scale."""
        scales = set()
        for image, line in zip(artists(drawn["maps"], "map"), LINES, strict=True):
            shown = np.asarray(image.get_array())
            assert shown.shape == (71, 64)
            field = 1e12 * vibration().at(line).grid()[0, 0].values / (2 * np.pi * line)  # pm/V
            assert shown.max() == pytest.approx(np.abs(field).max())
            moments = np.exp(2j * np.pi * np.arange(3600) / 3600)
            peak = field[np.unravel_index(np.abs(field).argmax(), field.shape)]
            then = moments[(peak * moments).real.argmax()]
            assert shown == pytest.approx((field * then).real, abs=1e-3 * shown.max())
            scales.add((image.norm.vmin, image.norm.vmax))
        largest = max(np.asarray(image.get_array()).max() for image in artists(drawn["maps"], "map"))
        assert scales == {(-largest, largest)}, "one scale for all"
        (bar,) = [axes for axes in drawn["maps"].axes if axes.get_label() == "<colorbar>"]
        assert bar.get_xlim()[1] == pytest.approx(largest)
        assert bar.get_xlabel() == "simulated normal displacement (pm/V)"

    def test_of_a_known_drive_it_is_what_the_plate_does(self):
        """3e-4 m/s/V at 58.8 kHz and 60 V: 49 nm."""
        (driven, bar) = plots.maps(vibration(), [58.8e3], prototype(), None, drive=60.0).axes
        largest = 60 * np.abs(vibration().at(58.8e3).values).max() / (2 * np.pi * 58.8e3)
        assert driven.images[0].norm.vmax == pytest.approx(1e9 * largest)
        assert bar.get_xlabel() == "simulated normal displacement (nm) at 60 V"
        largest_nm = float(re.search(r"up to ([\d.]+) nm", driven.get_title())[1])
        assert largest_nm == pytest.approx(1e9 * largest, rel=5e-3)

    def test_points_lie_where_they_were_seen(self, drawn):
        """Pixels of 2 mm, their middles on the points; only WG1 moves in the gap."""
        image = artists(drawn["maps"], "map")[1]
        assert image.get_extent() == pytest.approx((-1, 127, -1, 141))
        assert image.origin == "lower"
        moving = np.abs(image.get_array()) > 0.1 * image.norm.vmax
        columns = 2.0 * np.flatnonzero(moving.any(axis=0))
        assert columns.min() > 21
        assert columns.max() < 53
        assert image.axes.get_xlim() == pytest.approx((0, 127))
        assert image.axes.get_ylim() == pytest.approx((0, 140))
        assert image.axes.get_aspect() == 1.0

    def test_a_plate_with_a_hole_is_smooth_up_to_its_edge(self):
        """A field that is even at the hole shows nothing of the hole beside it."""
        layout, step = notched(), 0.5
        x, y = (m.ravel() for m in np.meshgrid(step * (np.arange(80) + 0.5), step * (np.arange(60) + 0.5)))
        on = ~((x > 20) & (y > 20))
        seen = FrequencyResponse.of(
            np.sin(x[on] / 4)[None, :, None] + 0j, frequency=np.array([1e3]), x=1e-3 * x[on],
            y=1e-3 * y[on], reference="A1, V", origin="simulated",
        )  # fmt: skip
        picture = plots.maps(seen, [1e3], layout, None)
        (image,), (cover,) = artists(picture, "map"), artists(picture, "absent tiles")
        assert image.get_interpolation() == "bicubic"
        assert np.isfinite(image.get_array()).all()
        boxes = [path.get_extents().extents.tolist() for path in cover.get_paths()]
        assert boxes == [pytest.approx([20, 20, 30, 30]), pytest.approx([30, 20, 40, 30])]
        (unscanned,) = artists(plots.maps(seen, [1e3], prototype(), None), "map")
        assert unscanned.get_interpolation() == "nearest", "points of the plate without a value stay empty"

    def test_off_a_grid_every_place_shows_its_nearest_point(self, drawn):
        """The slopes are seen to half a diagonal of a square around a point; nothing is drawn beside."""
        for image, along in zip(artists(drawn["maps, turned"], "map"), (0, 1), strict=True):
            shown, (left, right, low, top) = np.asarray(image.get_array().filled(np.nan)), image.get_extent()
            rows, columns = shown.shape
            x = left + (right - left) * (np.arange(columns) + 0.5) / columns
            y = low + (top - low) * (np.arange(rows) + 0.5) / rows
            place = np.stack(np.meshgrid(x, y))[along]
            largest = 1e3 * turned().points[:, along].max()
            there = np.isfinite(shown)
            assert np.abs(shown / np.nanmax(shown) * largest - place)[there].max() < 1.5
            assert there[(y > 2) & (y < 138)][:, (x > 2) & (x < 125)].all()
            assert not there[:, (x < -1.5) | (x > 128.5)].any()
        frames = plots.maps(turned(0.0), [1e3], prototype(), None)
        assert artists(frames, "map")[0].get_array().shape == (69, 63)

    def test_rows_are_the_maps_of_each_response(self, drawn):
        panels = drawn["maps, compared"].axes[:6]
        assert [axes.get_ylabel().split("\n")[0] for axes in panels[::3]] == [
            "computed",
            "scan",
        ]
        assert drawn["maps, compared"].axes[-1].get_xlabel() == "normal displacement (pm/V)", "two origins"
        rows = np.array([np.asarray(image.get_array()) for image in artists(drawn["maps, compared"], "map")])
        assert rows[:3] == pytest.approx(rows[3:])

    def test_regions_are_outlined_and_named_at_their_place(self, drawn):
        for name, (left, right) in {"WG1": (21, 53), "WG2": (74, 106)}.items():
            lines = artists(drawn["maps"], f"outline {name}")
            assert len(lines) == 3
            ends = np.concatenate(lines[0].get_segments())
            assert (ends[:, 0].min(), ends[:, 0].max()) == pytest.approx((left, right))
            assert (ends[:, 1].min(), ends[:, 1].max()) == pytest.approx((0, 140))
            assert not ((ends[:, 0] > left + 1) & (ends[:, 0] < right - 1) & (ends[:, 1] % 140 > 1)).any()
            (text, *_) = (t for t in artists(drawn["maps"], "region name") if t.get_text() == name)
            assert text.xy[0] == pytest.approx(0.5 * (left + right))

    def test_titles_locate_the_frequency_and_give_the_displacement(self, drawn):
        assert [axes.get_title() for axes in drawn["maps"].axes[:3]] == [
            "below the gap\n45.0 kHz\nup to 99 pm/V",
            "in the gap\n58.8 kHz\nup to 821 pm/V",
            "above the gap\n70.0 kHz\nup to 90.9 pm/V",
        ]
        measured = drawn["maps, one, measured"].axes
        assert measured[0].get_title() == "58.8 kHz\nup to 821 pm/V"
        assert measured[1].get_xlabel().startswith("measured")

    def test_areas_without_data_are_not_drawn_as_zero(self):
        whole = vibration()
        half = FrequencyResponse(whole.dataset.isel(point=whole.points[:, 0] < 60e-3))
        figure = plots.maps(half, [58.8e3], prototype(), GAP)
        axes = figure.axes[0]
        assert artists(figure, "map")[0].get_extent()[1] == pytest.approx(59)
        zero = mpl.colormaps["RdBu_r"](0.5)
        assert np.abs(np.subtract(axes.get_facecolor(), zero))[:3].max() > 0.05

    def test_a_plate_at_rest_is_drawn(self):
        still = vibration().dataset.copy(deep=True)
        still["response"][:] = 0
        figure = plots.maps(FrequencyResponse(still), [58.8e3], prototype(), GAP)
        assert not artists(figure, "map")[0].get_array().any()


class TestColours:
    def test_signs_differ_for_colour_blind_readers(self):
        """Red and blue ends differ in hue and are darker than zero, from which they fall evenly."""
        shades = plots.style.diverging()(np.linspace(0, 1, 21))[:, :3]
        light = np.where(shades <= 0.04045, shades / 12.92, ((shades + 0.055) / 1.055) ** 2.4) @ [
            0.2126, 0.7152, 0.0722
        ]  # fmt: skip
        assert (np.diff(light[:11]) > 0).all()
        assert (np.diff(light[10:]) < 0).all()
        low, high = shades[2], shades[-3]
        assert low[2] - low[0] > 0.3  # blue: also without red or without green cones
        assert high[0] - high[2] > 0.3


class TestSpectra:
    @pytest.mark.parametrize(("name", "panels"), [("contrast", 1), ("velocity", 1), ("impedance", 2)])
    def test_the_gap_is_shaded_in_every_panel(self, drawn, name, panels):
        shades = artists(drawn[name], "gap")
        assert len(shades) == panels
        for shade in shades:
            assert (shade.get_x(), shade.get_x() + shade.get_width()) == pytest.approx((52.5, 60.2))
        assert [text for text, _ in shown_texts(drawn[name])].count("band gap 52.5 to 60.2 kHz") == 1

    @pytest.mark.parametrize("gaps", [[], [(101e3, 120e3), (1e3, 2e3)]])
    def test_a_gap_out_of_view_is_not(self, gaps):
        part = FREQUENCY[100:]
        figure = plots.contrast_spectrum(part, {"a": part * 0}, gaps)
        assert not artists(figure, "gap")
        assert not any("gap" in text for text, _ in shown_texts(figure))

    @pytest.mark.parametrize(("name", "values"), [("contrast", CONTRAST), ("velocity", VELOCITY)])
    def test_curves_are_the_values_under_their_names(self, drawn, name, values):
        names = [mean.get_label() for mean in artists(drawn[name], "mean")]
        assert names == list(values)
        for label, curve in zip(names, artists(drawn[name], "curve"), strict=True):
            assert curve.get_xdata() == pytest.approx(FREQUENCY / 1e3)
            there = np.isfinite(curve.get_ydata())
            assert curve.get_ydata()[there] == pytest.approx(
                {"velocity": 1e6}.get(name, 1) * values[label][there]
            )
            assert (values[label][~there] == 0).all()

    def test_velocities_have_a_logarithmic_scale_and_their_own_unit(self, drawn):
        axes = drawn["velocity"].axes[0]
        assert axes.get_yscale() == "log"
        assert axes.get_ylabel().endswith("(µm/s/V)")
        driven = plots.velocity_spectrum(FREQUENCY, VELOCITY, [], drive=60.0).axes[0]
        assert driven.get_ylabel().endswith("(mm/s) at 60 V")
        assert driven.lines[0].get_ydata().max() == pytest.approx(6.0)
        assert drawn["velocity, seven"].axes[0].get_ylabel().endswith("(m/s/N)")

    def test_many_curves_differ_in_style(self, drawn):
        means = artists(drawn["velocity, seven"], "mean")
        assert len(means) == 7
        assert len({(c.get_color(), c.get_linestyle()) for c in means[:5]}) == 5

    def test_the_mean_of_many_lines_is_that_of_their_levels(self):
        """A level that alternates between 0 and 20 dB is 10 dB on average; few lines have no mean."""
        figure = plots.contrast_spectrum(FREQUENCY, {"a": 20.0 * (np.arange(401) % 2)}, [])
        (mean,) = artists(figure, "mean")
        assert mean.get_ydata()[20:-20] == pytest.approx(np.full(361, 10.0), abs=1.0)
        assert not artists(plots.contrast_spectrum(FREQUENCY[:9], {"a": np.ones(9)}, []), "mean")
        gaps = np.where(FREQUENCY < 50e3, np.nan, 3.0)
        mean = spectra.running_mean(gaps)
        assert np.isnan(mean[:190]).all()
        assert mean[210:] == pytest.approx(np.full(191, 3.0))

    def test_a_capacitor_with_a_resistor_has_their_conductance_and_capacitance(self, drawn):
        """30 ohm in series with 1.8 nF: by hand, G = w²RC² / (1 + (wRC)²), C / (1 + (wRC)²)."""
        above, below = drawn["impedance"].axes
        assert above.get_yscale() == "log"
        omega = 2 * np.pi * FREQUENCY[1:]
        turn = (omega * 30 * 1.8e-9) ** 2
        conductance, capacitance = (axes.lines[0].get_ydata() for axes in (above, below))
        assert conductance == pytest.approx(1e6 * turn / 30 / (1 + turn))
        assert capacitance == pytest.approx(1.8 / (1 + turn))
        assert above.get_ylabel() == "conductance (µS)"
        assert below.get_ylabel() == "capacitance (nF)"

    def test_a_conductance_below_zero_is_in_view(self):
        figure = plots.impedance_spectrum(FREQUENCY[1:], -IMPEDANCE * np.exp(0.3j), [])
        axes = figure.axes[0]
        assert axes.get_yscale() == "linear"
        values = axes.lines[0].get_ydata()
        assert values.min() < 0
        assert axes.get_ylim()[0] < values.min()


class TestPlan:
    def test_pillars_are_drawn_in_the_middle_of_their_cells(self, drawn):
        (pillars,) = artists(drawn["plan"], "pillars")
        boxes = [path.get_extents() for path in pillars.get_paths()]
        assert len(boxes) == 180
        middles = np.array([[0.5 * (b.x0 + b.x1), 0.5 * (b.y0 + b.y1)] for b in boxes])
        columns = [3.5, 10.5, 17.5, 56.5, 63.5, 70.5, 109.5, 116.5, 123.5]
        assert sorted(set(middles[:, 0].round(6))) == pytest.approx(columns)
        assert sorted(set(middles[:, 1].round(6))) == pytest.approx(3.5 + 7 * np.arange(20))
        assert {round(b.width, 3) for b in boxes} == {3.5}
        assert "pillars on the back (180)" in [t for t, _ in shown_texts(drawn["plan"])]

    def test_actuators_are_where_they_are(self, drawn):
        (patch,) = artists(drawn["plan"], "actuator A1")
        assert (patch.get_x(), patch.get_y()) == pytest.approx((37 - 5.75, 17.5 - 4))
        assert (patch.get_width(), patch.get_height()) == pytest.approx((11.5, 8))
        assert {t.get_text() for t in artists(drawn["plan, busy"], "name")} == {"A1", "A2", "F1", "F2"}
        (finger,) = artists(drawn["plan, busy"], "finger")
        assert (finger.center, finger.radius) == (pytest.approx((40, 90)), pytest.approx(5))

    def test_clamped_corners(self, drawn):
        """Two pieces of 7 mm at each corner; with steps of 7 mm in y the vertical ones are whole tiles."""
        expected = {((x, a), (x, b)) for x in (0.0, 127.0) for a, b in ((0.0, 7.0), (133.0, 140.0))}
        expected |= {((a, y), (b, y)) for y in (0.0, 140.0) for a, b in ((0.0, 7.0), (120.0, 127.0))}
        assert segments(drawn["plan"], "held clamped") == expected

    def test_corners_of_a_notched_plate(self, drawn):
        """The missing corner cannot be held, and the sides of the notch are no outer sides."""
        expected = {
            ((0.0, 0.0), (0.0, 6.0)), ((0.0, 24.0), (0.0, 30.0)), ((40.0, 0.0), (40.0, 6.0)),
            ((0.0, 0.0), (6.0, 0.0)), ((34.0, 0.0), (40.0, 0.0)), ((0.0, 30.0), (6.0, 30.0)),
        }  # fmt: skip
        assert segments(drawn["plan, notched"], "held clamped") == expected

    @pytest.mark.parametrize(
        ("side", "axis", "places"),
        [("left", 0, {0.0}), ("right", 0, {20.0, 40.0}), ("bottom", 1, {0.0}), ("top", 1, {20.0, 30.0})],
    )
    def test_a_side_is_every_face_that_looks_there(self, side, axis, places):
        figure = plots.plate_plan(held(Support(side, "simple"), layout=notched()))
        sides = segments(figure, "held simple")
        assert {end[axis] for line in sides for end in line} == places
        total = sum(np.hypot(b[0] - a[0], b[1] - a[1]) for a, b in sides)
        assert total == pytest.approx(30 if axis == 0 else 40)

    def test_names_of_regions_lie_in_them_and_away_from_what_is_drawn_there(self, drawn):
        (pad,) = artists(drawn["plan, notched"], "region name")
        x, y = pad.get_position()
        assert (x < 10 and y < 30) or (x < 30 and y < 10)
        for name in artists(drawn["plan, busy"], "region name"):
            x, y = name.get_position()
            low = {"WG1": 21, "WG2": 74}[name.get_text()]
            assert low < x < low + 32
            for a, b in ((37, 17.5), (40, 90), (30, 60), (90, 120), (90, 50)):
                assert np.hypot(x - a, y - b) > 40

    def test_the_legend_names_no_more_than_is_drawn(self, drawn):
        written = {
            name: {text.get_text() for text in drawn[name].legends[0].get_texts()}
            for name in ("plan", "plan, busy", "plan, low")
        }
        common = {"region of plain plate", "pillars on the back (180)"}
        assert written["plan"] == common | {"clamped", "actuator on the back"}
        rest = {"simple support", "elastic foundation", "normal force", "finger"}
        assert written["plan, busy"] == written["plan"] | rest
        assert written["plan, low"] == {"region of plain plate", "pillars on the back (18)"}

    def test_a_plain_plate_is_drawn(self):
        bare = Layout((("all",),), (0.0, 0.1), (0.0, 0.05), {}, 1e-3, ALUMINIUM)
        figure = plots.plate_plan(replace(plate(), layout=bare))
        assert [t.get_text() for t in artists(figure, "region name")] == ["all"]


@pytest.fixture(scope="module")
def moving(tmp_path_factory):
    path = tmp_path_factory.mktemp("moving") / "a.gif"
    path.write_bytes(plots.animated(vibration(), 58.8e3, prototype()))
    return path


def test_each_map_of_friction_gives_its_largest_reduction():
    friction = FRICTION.assign(low=FRICTION["low"] - 0.1, high=FRICTION["high"] + 0.1)
    titles = [axes.get_title() for axes in plots.friction_map(friction, prototype()).axes]
    assert [title.replace("\n", " ") for title in titles if title] == [
        "prediction, up to 90 %", "smallest plausible, up to 80 %",
        "largest plausible, up to 100 %",
    ]  # fmt: skip


class TestAnimation:
    @staticmethod
    def frames(path) -> np.ndarray:
        with Image.open(path) as picture:
            frames = []
            for number in range(picture.n_frames):
                picture.seek(number)
                frames.append(np.asarray(picture.convert("RGB"), dtype=float))
        return np.array(frames)

    def test_one_cycle_that_repeats_in_a_small_file(self, moving):
        with Image.open(moving) as picture:
            assert picture.format == "GIF"
            assert picture.n_frames == FRAMES == 24
            assert picture.info["loop"] == 0
        assert moving.stat().st_size < 1_000_000

    def test_it_swings_as_a_cosine_and_only_where_the_plate_moves(self, moving):
        """Red minus blue follows the velocity: largest at the beginning, opposite half a cycle later."""
        frames = self.frames(moving)
        tint = frames[..., 0] - frames[..., 2]
        swing = np.abs(tint - tint[0]).max(axis=0)
        busy = np.argwhere(swing > 100)
        assert len(busy) > 500
        assert np.ptp(busy[:, 1]) < 0.35 * frames.shape[2], "WG1 alone"
        row, column = np.unravel_index((tint[0] - tint[12]).argmax(), swing.shape)
        curve = tint[:, row, column]
        cosine = np.cos(2 * np.pi * np.arange(24) / 24)
        assert np.corrcoef(curve, cosine)[0, 1] > 0.97
        assert np.abs(tint[6][swing > 100]).max() < 60, "all pass zero together"

    def test_a_travelling_wave_follows_exp_i_omega_t(self, tmp_path):
        """exp(-i k x) runs to larger x."""
        standing = vibration()
        x = standing.points[:, 0]
        wave = np.exp(-2j * np.pi * x / 60e-3)[None, :, None]
        running = FrequencyResponse.of(
            wave, frequency=np.array([58.8e3]), x=x, y=standing.points[:, 1], reference="A1, V",
            origin="simulated",
        )  # fmt: skip
        bare = Layout((("",),), (0.0, 0.127), (0.0, 0.14), {}, 1e-3, ALUMINIUM)
        path = tmp_path / "a.gif"
        path.write_bytes(plots.animated(running, 58.8e3, replace(bare, tiles=((None,),))))
        tint = (lambda f: f[..., 0] - f[..., 2])(self.frames(path))
        height, width = tint.shape[1:]
        row = tint[:, height // 3, int(0.3 * width) : int(0.8 * width)]
        spectrum = np.fft.fft2(row - row.mean())
        positive, negative = np.abs(spectrum[1, 1:4]).max(), np.abs(spectrum[1, -3:]).max()
        assert negative > 3 * positive
