"""Pictures: what is drawn where, that it can be read, and that it is written whole."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ET
from itertools import combinations, pairwise
from typing import ClassVar

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from seeing import artists, assert_readable, shown_texts

from five_parts import refusing
from haptonic import plots
from haptonic.bloch import bands_dataset
from haptonic.bloch.settings import BandSettings, MeshSettings
from haptonic.cell.skin import drawing_cells, outer_faces, outline_edges
from haptonic.errors import HaptonicError, ResourceError
from haptonic.plots import style
from haptonic.plots.bands import CURVE_STYLES, RIGID
from haptonic.plots.curves import PIECES
from haptonic.plots.labels import spread
from haptonic.results.bands import Bands
from simulated import reference_bands, reference_study, simulated_sweep


def pictures() -> dict[str, Figure]:
    bands = reference_bands()
    return {
        "dispersion": plots.dispersion(bands, carrier_hz=60e3, title="A title"),
        "natures": plots.dispersion(bands, carrier_hz=60e3, natures=True),
        "modes": plots.mode_shapes(bands),
        "iso": plots.iso_frequency(bands),
        "density": plots.density_of_states(bands),
        "sweep": plots.sweep(simulated_sweep()),
    }


@pytest.fixture(scope="module")
def drawn():
    return pictures()


@pytest.mark.parametrize("name", ["dispersion", "natures", "modes", "iso", "density", "sweep"])
class TestEveryPicture:
    def test_axes_name_what_they_show_with_its_unit(self, drawn, name):
        for axes in drawn[name].axes:
            labels = [axes.get_xlabel(), axes.get_ylabel()]
            if not axes.axison:
                continue
            if axes.get_label() == "<colorbar>":
                assert any(labels)
                continue
            inner = axes is not drawn[name].axes[0] and name == "iso"
            for label in labels[: 1 if inner else 2]:
                if label == "wavevector":
                    continue
                unit = label[label.rindex("(") + 1 : label.rindex(")")]
                assert any(known in unit for known in ("kHz", "rad/mm", "dimensionless")), label

    def test_no_text_lies_on_another_or_leaves_the_picture(self, drawn, name):
        assert_readable(drawn[name])

    def test_type_is_readable_when_the_picture_is_12_cm_wide(self, drawn, name):
        figure = drawn[name]
        shrink = min(1.0, 12 / 2.54 / figure.get_figwidth())
        FigureCanvasAgg(figure).draw()
        for axes in figure.axes:
            sizes = [text.get_fontsize() for text in [*axes.texts, axes.title, axes.xaxis.label]]
            sizes += [label.get_fontsize() for label in axes.get_xticklabels()]
            assert min(sizes) * shrink > 6.5

    def test_it_is_written_as_svg_and_png(self, drawn, name, tmp_path):
        svg, png = plots.save(drawn[name], tmp_path / "new", name)
        assert (svg.name, png.name) == (f"{name}.svg", f"{name}.png")
        assert ET.parse(svg).getroot().tag.endswith("svg")
        assert png.read_bytes().startswith(b"\x89PNG")
        assert svg.stat().st_size < 1.5e6
        assert sorted(p.name for p in (tmp_path / "new").iterdir()) == [png.name, svg.name]


def test_a_picture_does_not_replace_a_file_unasked(drawn, tmp_path):
    (tmp_path / "a.png").write_text("mine")
    with refusing(ResourceError, "repeated", "output file"):
        plots.save(drawn["density"], tmp_path, "a")
    assert (tmp_path / "a.png").read_text() == "mine"
    assert not (tmp_path / "a.svg").exists()
    plots.save(drawn["density"], tmp_path, "a", overwrite=True)
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")


def test_the_same_result_is_the_same_file(tmp_path):
    for folder in ("one", "two"):
        plots.save(plots.sweep(simulated_sweep()), tmp_path / folder, "sweep")
    first, second = (sorted((tmp_path / folder).iterdir()) for folder in ("one", "two"))
    for a, b in zip(first, second, strict=True):
        assert a.read_bytes() == b.read_bytes()


def test_drawing_changes_no_settings_and_opens_no_windows(tmp_path):
    with mpl.rc_context({"font.size": 30, "axes.grid": True}):
        before = dict(mpl.rcParams)
        figure = plots.sweep(simulated_sweep())
        plots.save(figure, tmp_path, "sweep")
        assert dict(mpl.rcParams) == before
        assert figure.axes[0].xaxis.label.get_fontsize() == 9
        assert not figure.axes[0].xaxis.get_gridlines()[0].get_visible()
    assert "matplotlib.pyplot" not in figure.canvas.__class__.__module__


class TestDispersion:
    def test_the_complete_gap_is_shaded_where_it_is(self, drawn):
        bands = reference_bands()
        complete = bands["gap_complete"].values.astype(bool)
        (patch,) = artists(drawn["dispersion"], "gap")
        assert patch.get_y() == pytest.approx(bands["gap_lower"].values[complete][0] / 1e3)
        assert patch.get_y() + patch.get_height() == pytest.approx(
            bands["gap_upper"].values[complete][0] / 1e3
        )
        assert (patch.get_x(), patch.get_width()) == (0, 1)  # of the width of the axes

    def test_a_gap_of_one_direction_is_not_shaded(self):
        bands = reference_bands()
        bands["gap_complete"][:] = 0
        figure = plots.dispersion(bands)
        assert not artists(figure, "gap")
        assert not any("complete gap" in text for text, _ in shown_texts(figure))

    def test_the_gap_is_labelled_with_its_edges_and_errors(self, drawn):
        bands = reference_bands()
        written = " ".join(text for text, _ in shown_texts(drawn["dispersion"]))
        for edge in ("gap_lower", "gap_upper"):
            value, error = (float(bands[name][0]) for name in (edge, f"{edge}_error"))
            khz = written.split("complete gap")[1]
            numbers = [float(word) for word in khz.replace("±", " ").split() if word[0].isdigit()]
            assert any(abs(number - value / 1e3) <= error / 1e3 for number in numbers), edge

    def test_the_carrier_is_where_it_is_and_in_view(self):
        figure = plots.dispersion(reference_bands(), carrier_hz=300e3)
        (line,) = artists(figure, "carrier")
        assert set(line.get_ydata()) == {300.0}
        assert figure.axes[0].get_ylim()[1] > 300

    def test_curves_follow_branches_and_carry_the_colour_of_their_character(self, drawn):
        bands = reference_bands()
        names = json.loads(bands.attrs["character_names"])
        distance = bands["distance"].values
        lines = [line for line in drawn["natures"].axes[0].lines if (line.get_gid() or "").startswith("br")]
        points = {}
        for line in lines:
            _, number, name = line.get_gid().split(" ", 2)
            assert line.get_color() == CURVE_STYLES[name].colour
            for x, y in zip(*line.get_data(), strict=True):
                points.setdefault((int(number), round(float(x), 6), round(float(y), 6)), set()).add(name)
        branch, kind = bands["branch"].values, bands["character"].values
        for i, j in np.ndindex(branch.shape):
            if names[kind[i, j]] == RIGID:
                continue
            key = (
                int(branch[i, j]),
                round(float(distance[i]), 6),
                round(float(bands["frequency"][i, j]) / 1e3, 6),
            )
            assert names[kind[i, j]] in points[key]

    def test_bands_are_plain_black_lines_through_all_frequencies(self, drawn):
        bands = reference_bands()
        lines = [
            line for line in drawn["dispersion"].axes[0].lines if (line.get_gid() or "").startswith("br")
        ]
        assert {line.get_color() for line in lines} == {style.INK}
        assert {(line.get_linestyle(), line.get_marker()) for line in lines} == {("-", "None")}
        heights = np.concatenate([line.get_ydata()[::PIECES] for line in lines])
        assert np.sort(heights) == pytest.approx(np.sort(bands["frequency"].values.ravel() / 1e3))
        assert not drawn["dispersion"].legends

    def test_plain_bands_end_where_one_above_the_last_may_lie(self, drawn):
        bands = reference_bands()
        top = float(bands["frequency"].isel(band=-1).min()) / 1e3
        assert drawn["dispersion"].axes[0].get_ylim() == pytest.approx((0, top), rel=0.02)
        assert drawn["dispersion"].axes[0].get_ylim()[1] < top  # that band is not on the frame
        three = bands.isel(band=slice(3))  # they are at rest at Γ
        low = plots.dispersion(three).axes[0].get_ylim()[1]
        assert low > float(three["frequency"].max()) / 1e3

    def test_colour_and_legend_can_be_chosen(self):
        result = Bands(reference_bands())
        lines = result.plot("dispersion", color="#0072B2").axes[0].lines
        assert "#0072B2" in {line.get_color() for line in lines}
        assert result.plot("natures").legends
        assert not result.plot("natures", legend=False).legends

    @pytest.mark.parametrize(("unit", "length"), [("rad/m", np.pi / 7e-3), ("pi/a", 1.0)])
    def test_the_length_of_the_path_is_written_in_a_unit(self, unit, length):
        axes = plots.dispersion(reference_bands(), wavevectors=unit).axes[0]
        name, written = axes.get_xticklabels()[1].get_text().split("\n")
        assert name == "X"
        assert float(written) == pytest.approx(length, rel=5e-3)
        assert unit.replace("pi", "π") in axes.get_xlabel()
        with pytest.raises(HaptonicError, match="wavevectors"):
            plots.dispersion(reference_bands(), wavevectors="1/m")

    def test_the_corners_are_named(self, drawn):
        axes = drawn["dispersion"].axes[0]
        assert [label.get_text() for label in axes.get_xticklabels()] == ["Γ", "X", "M", "Γ"]
        corners = json.loads(reference_bands().attrs["path_corners"])
        assert axes.get_xticks() == pytest.approx(reference_bands()["distance"].values[corners])


class TestColours:
    # Machado, Oliveira and Fernandes 2009 (doi 10.1109/TVCG.2009.113), complete loss, on linear sRGB
    VISION: ClassVar = {
        "usual": np.eye(3),
        "protanopia": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216],
                       [-0.003882, -0.048116, 1.051998]],
        "deuteranopia": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413],
                         [-0.011820, 0.042940, 0.968881]],
    }  # fmt: skip
    XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])

    def linear(self, colour, vision):
        rgb = np.array(mpl.colors.to_rgb(colour))
        light = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
        return np.clip(np.array(self.VISION[vision]) @ light, 0, 1)

    def lab(self, colour, vision):
        t = self.XYZ @ self.linear(colour, vision) / self.XYZ.sum(axis=1)
        f = np.where(t > 0.008856, np.cbrt(t), 7.787 * t + 16 / 116)
        return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])

    @pytest.mark.parametrize("vision", VISION)
    def test_any_two_curves_differ_for_all_readers(self, vision):
        for (name, a), (other_name, b) in combinations(CURVE_STYLES.items(), 2):
            difference = np.linalg.norm(self.lab(a.colour, vision) - self.lab(b.colour, vision))
            assert difference > (30 if a.dashes == b.dashes else 10), (name, other_name, difference)

    def test_curves_in_grey_differ_in_dashes_or_markers(self):
        assert len({(stroke.dashes, stroke.marker) for stroke in CURVE_STYLES.values()}) == len(CURVE_STYLES)

    def test_every_curve_has_contrast_with_the_paper(self):
        for name, stroke in CURVE_STYLES.items():
            luminance = (self.XYZ @ self.linear(stroke.colour, "usual"))[1]
            assert 1.05 / (luminance + 0.05) > 2.0, name

    def test_every_character_has_a_stroke(self):
        names = json.loads(reference_bands().attrs["character_names"])
        assert set(names) == set(CURVE_STYLES) | {RIGID}


class TestSweep:
    def points(self, figure, gid):
        """(value, kHz) of all points of this kind, sorted."""
        points = [line.get_xydata() for line in artists(figure, gid)]
        return sorted(map(tuple, np.concatenate(points))) if points else []

    def test_edges_are_points_and_the_gap_between_them_is_shaded(self, drawn):
        data = simulated_sweep()
        there = np.isfinite(data["gap_lower"].values) & (data["gap_below"].values != 3)
        steps, _ = np.nonzero(there)
        edges = [data[f"gap_{side}"].values[there] / 1e3 for side in ("lower", "upper")]
        wanted = sorted(
            (v, f) for edge in edges for v, f in zip(data["value"].values[steps], edge, strict=True)
        )
        assert np.array(self.points(drawn["sweep"], "certain gap")) == pytest.approx(np.array(wanted))
        shades = [
            area.get_paths()[0].get_extents() for area in artists(drawn["sweep"], "gap") if area.get_paths()
        ]
        low, high = data["gap_lower"].values[:, 0] / 1e3, data["gap_upper"].values[:, 0] / 1e3
        assert any((box.y0, box.y1) == pytest.approx((low.min(), high.max())) for box in shades)

    def test_points_of_a_gap_not_wider_than_its_errors_are_hollow(self, drawn):
        assert len(self.points(drawn["sweep"], "uncertain gap")) == 8
        for gid, hollow in (("uncertain gap", True), ("certain gap", False)):
            faces = {line.get_markerfacecolor() for line in artists(drawn["sweep"], gid)}
            assert (faces == {"white"}) == hollow

    def test_resonances_are_drawn_by_both_theories(self, drawn):
        data = simulated_sweep()
        for name, dashed in (("euler_bernoulli", True), ("timoshenko", False)):
            for k in range(3):
                (line,) = artists(drawn["sweep"], f"{name} {k + 1}")
                assert line.get_ydata() == pytest.approx(data[name].values[:, k] / 1e3)
                assert line.is_dashed() == dashed

    def test_the_end_of_the_search_is_a_line(self, drawn):
        (line,) = artists(drawn["sweep"], "beyond")
        assert line.get_ydata() == pytest.approx(simulated_sweep()["searched_up_to"].values / 1e3)

    def test_a_sweep_downwards_is_the_same_picture(self, drawn):
        down = plots.sweep(simulated_sweep().isel(step=slice(None, None, -1)))
        for gid in ("certain gap", "uncertain gap", "beyond", "timoshenko 1"):
            assert self.points(down, gid) == self.points(drawn["sweep"], gid)

    def test_the_own_design_is_marked_only_on_the_axis(self, drawn):
        (line,) = artists(drawn["sweep"], "own")
        assert set(line.get_xdata()) == {0.5}
        assert not artists(plots.sweep(simulated_sweep(own_value=2.0)), "own")
        without = simulated_sweep()
        del without.attrs["own_value"]
        assert not artists(plots.sweep(without), "own")

    def test_a_design_that_failed_is_crossed_out(self):
        data = simulated_sweep()
        data["searched_up_to"][2] = np.nan
        assert self.points(plots.sweep(data), "failed") == [(float(data["value"][2]), 0.0)]

    def test_lengths_are_drawn_in_mm(self):
        data = simulated_sweep(expression="cell.pitch", own_value=5e-4)
        data["value"] = data["value"] * 1e-3
        data["value"].attrs = {"units": "m"}
        axes = plots.sweep(data).axes[0]
        assert axes.get_xlabel() == "pitch (mm)"
        assert axes.get_xlim()[1] == pytest.approx(0.8 + 0.03 * 0.4)

    def test_a_sweep_without_gaps_or_pillar_is_drawn(self):
        data = simulated_sweep().isel(gap_slot=slice(0))
        data["euler_bernoulli"][:] = data["timoshenko"][:] = np.nan
        figure = plots.sweep(data)
        assert not self.points(figure, "certain gap")
        assert not any("pillar alone" in text for text, _ in shown_texts(figure))


class TestModes:
    def test_eight_modes_with_name_and_frequency(self, drawn):
        bands = reference_bands()
        titles = [axes.get_title() for axes in drawn["modes"].axes if axes.get_title()]
        assert len(titles) == 8
        for k, title in enumerate(titles):
            assert title.startswith(f"{k + 1}:  {float(bands['mode_frequency'][k]) / 1e3:.2f} kHz")

    def test_camera_and_scale_are_the_same(self, drawn):
        panels = [axes for axes in drawn["modes"].axes if axes.get_title()]
        assert len({(axes.get_xlim(), axes.get_ylim()) for axes in panels}) == 1
        assert all(axes.get_aspect() == 1 for axes in panels)

    def test_outer_faces_close_the_body(self):
        """The divergence theorem: the volume inside the faces is that of plate and pillar."""
        bands = reference_bands()
        cells, _ = drawing_cells(bands["subcell"].values, json.loads(bands.attrs["element_grids"]))
        position, faces = bands["node_position"].values + 0.1, outer_faces(cells)  # no face through 0
        corners = position[faces]
        volume = 0.0
        for a, b in ((1, 2), (2, 3)):  # two triangles
            area = np.cross(corners[:, a] - corners[:, 0], corners[:, b] - corners[:, 0])
            volume += np.einsum("ij,ij->", (corners[:, 0] + corners[:, a] + corners[:, b]) / 3, area) / 6
        wanted = 0.007**2 * 0.0015 + np.pi * 0.00175**2 * 0.0147
        assert volume == pytest.approx(wanted, rel=0.02)  # the pillar's surface is facetted

    def test_the_outline_is_a_box_and_a_pillar(self):
        bands = reference_bands()
        cells, on_edge = drawing_cells(bands["subcell"].values, json.loads(bands.attrs["element_grids"]))
        position = bands["node_position"].values
        edges = position[outline_edges(position, outer_faces(cells))]
        length = np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1).sum()
        assert length == pytest.approx(8 * 0.007 + 4 * 0.0015 + 2 * np.pi * 0.0035, rel=0.01)
        assert len(np.unique(on_edge)) == len(on_edge)

    def test_the_outline_is_complete_where_one_face_is_divided_more_finely(self):
        """As the lower face of a solid from a file, whose border has points that the sides lack."""
        around = np.array([(0, 0), (2, 0), (2, 2), (0, 2)], dtype=float)
        corners = np.vstack([np.column_stack([around, np.full(4, z)]) for z in (0, 2)])
        middle = [(1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 1, 0)]
        position = np.vstack([corners, middle])
        lower = [[0, 8, 12, 11], [8, 1, 9, 12], [12, 9, 2, 10], [11, 12, 10, 3]]
        sides = [[k, (k + 1) % 4, 4 + (k + 1) % 4, 4 + k] for k in range(4)]
        faces = np.array([face[::-1] for face in lower] + sides + [[4, 5, 6, 7]])
        edges = position[outline_edges(position, faces)]
        length = np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1).sum()
        assert length == pytest.approx(12 * 2 + 4 * 2)  # the border of the lower face twice

    def test_a_plate_without_a_pillar_is_drawn(self):
        plain = reference_study().cell.without_pillar()
        plate = bands_dataset(plain, BandSettings(10, 8, 2e-2, MeshSettings(2, 0)))
        figure = plots.mode_shapes(plate)
        assert len(artists(figure, "deformed")) == 8


class TestZone:
    def test_the_whole_zone_is_covered(self, drawn):
        edge = np.pi / 7
        for axes in [axes for axes in drawn["iso"].axes if axes.get_title()]:
            assert axes.get_xlim() == pytest.approx((-edge, edge))
            assert axes.get_ylim() == pytest.approx((-edge, edge))

    def test_the_bands_are_the_first_and_the_one_below_the_gap(self, drawn):
        titles = [axes.get_title() for axes in drawn["iso"].axes if axes.get_title()]
        assert titles == ["band 1", "band 6, below the gap"]

    def test_the_colours_are_those_of_the_band(self, drawn):
        for surface, band in zip(artists(drawn["iso"], "frequency"), (1, 6), strict=True):
            values = reference_bands()["zone_frequency"].sel(band=band).values / 1e3
            shown = surface.get_array()
            assert (shown.min(), shown.max()) == pytest.approx((values.min(), values.max()))

    def test_bands_can_be_chosen(self):
        figure = plots.iso_frequency(reference_bands(), (3,))
        assert [axes.get_title() for axes in figure.axes if axes.get_title()] == ["band 3"]

    def test_the_density_counts_the_bands_and_vanishes_in_the_gap(self, drawn):
        (curve,) = artists(drawn["density"], "density")
        values, edges, _ = curve.get_data()
        (gap,) = artists(drawn["density"], "gap")
        low, high = gap.get_x(), gap.get_x() + gap.get_width()
        assert values[(edges[:-1] > low) & (edges[1:] < high)].max() == 0
        assert (values * np.diff(edges))[edges[1:] < high].sum() == pytest.approx(6)


class TestSpread:
    @pytest.mark.parametrize(
        "places", [[], [0.5], [0.5, 0.5, 0.5], [0.0, 1.0], [0.9, 0.95, 1.0, 0.2], [1.0, 0.99, 0.0, 0.01, 0.5]]
    )
    def test_neighbours_are_apart_inside_the_limits_and_in_order(self, places):
        moved = spread(places, 0.1, 0.0, 1.0)
        assert all(-1e-9 <= place <= 1 + 1e-9 for place in moved)
        assert all(b - a >= 0.1 - 1e-9 for a, b in pairwise(sorted(moved)))
        assert all((a - b) * (c - d) >= 0 for a, c in zip(places, moved, strict=True)
                   for b, d in zip(places, moved, strict=True))  # fmt: skip

    def test_places_with_room_stay(self):
        assert spread([0.2, 0.8, 0.5], 0.1, 0.0, 1.0) == pytest.approx([0.2, 0.8, 0.5])
