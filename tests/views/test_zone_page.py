"""The Brillouin zone on the page of bands: its numbers and modes, and what one picks in a real browser."""

import re

import numpy as np
import pytest

from browser import STILL, advances, faults_of_layout, page_at, pixels
from daily import daily
from haptonic.bloch.bands import bands_dataset
from haptonic.bloch.candidates import bloch_model
from haptonic.bloch.wavevectors import wavevector_at
from haptonic.bloch.zone import ZoneModes, ZoneSurface
from haptonic.brillouin import IrreducibleZone
from haptonic.lattice import Lattice, Operation, PointGroup
from haptonic.study import loads
from haptonic.units import uncertain
from quick import QUICK_CELL

MINUS = "\N{MINUS SIGN}"
MAP, MODE = ".zone canvas", "[aria-label='Brillouin zone'] .mode canvas"
DRAWN = """canvas => {
    const { surface, uniforms, turns } = canvas.moving;
    const read = name => [...surface.getAttribute(name).array];
    return { position: read("position"), real: read("real"), imag: read("imag"), turns,
        turned: uniforms.turned.value.elements, period: canvas.moving.period };
}"""
MESH = """() => {
    const { zone } = document.querySelector(".zone canvas");
    const level = (image, band) => zone.at(zone.sample(image), band);
    return [0, 1, 2, 3].map((band) => zone.mesh(band).map((triangle) => triangle.map(
        (image) => [...zone.wavevector(image), level(image, band)])));
}"""
LEVELS = """() => {
    const { zone } = document.querySelector(".zone canvas");
    return [0, 1, 2, 3].map((band) => [zone.levels(band, 8), zone.range(band)]);
}"""
CONTOUR = """() => {
    const zone = document.querySelector(".zone canvas").zone;
    return zone.contour(0, zone.range(0)[1] / 2).flat();
}"""


def on_mesh(order: int, lattice: str = "square") -> str:
    text = QUICK_CELL.replace("order = 2\nfoot_rings = 0", f"order = {order}\nfoot_rings = 1")
    return text.replace("[cell]", f'[cell]\nlattice = "{lattice}"')


@pytest.fixture(scope="module")
def study():
    return loads(on_mesh(3))


@pytest.fixture(scope="module")
def bands(study):
    return study.bands(html=True, surface=True)


@pytest.fixture(scope="module")
def address(bands, tmp_path_factory) -> str:
    path = tmp_path_factory.mktemp("zone") / "bands.html"
    bands.files["bands.html"](path)
    return path.as_uri()


def test_a_wavevector_of_the_zone_has_the_frequencies_of_the_model(browser, study, bands, address):
    model, data = bloch_model(study.cell, study.bands_settings), bands.dataset
    for sample in (3, 77, 200):
        solution = model.solve(data["zone_kappa"].values[sample])
        np.testing.assert_allclose(data["zone_frequency"][sample], solution.frequency, rtol=1e-9)
        np.testing.assert_allclose(data["zone_error"][sample], solution.error, rtol=1e-6)
    view = bands.view().dataset
    wavevector, sample = view["zone_wavevector"].values, view["zone_sample"].values
    largest = np.pi / 7e-3
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(f"{MAP}[data-shown]")
        walk, words = page.get_by_role("application", name="Brillouin zone"), page.locator("#zone-point")

        def image() -> int:
            return int(page.locator(MAP).get_attribute("data-shown").split(",")[0])

        box = page.locator(MAP).bounding_box()
        scale = (box["width"] / 2 - 26) / largest  # 26 px around the zone
        for x, y in ((0.25, -0.5), (-0.75, 0.125)):
            position = {
                "x": box["width"] / 2 + scale * x * largest,
                "y": box["height"] / 2 - scale * y * largest,
            }
            page.locator(MAP).click(position=position)
            np.testing.assert_allclose(wavevector[image()], [x * largest, y * largest], atol=1e-6)
            assert f"({x:g}, {y:g}) π/a".replace("-", MINUS) in words.inner_text()
        step = largest / 24
        before = wavevector[image()]
        for key, move in (("ArrowRight", (1, 0)), ("ArrowUp", (0, 1)), ("ArrowLeft", (-1, 0))):
            walk.press(key)
            np.testing.assert_allclose(wavevector[image()] - before, np.array(move) * step, atol=1e-6)
            before = wavevector[image()]
        point = page.locator("#point").inner_text()
        page.get_by_role("region", name="Brillouin zone").locator("select").first.select_option("3")
        assert page.locator("#point").inner_text() != point  # one band for both diagrams
        here = sample[image()]
        frequency, error = (data[name].values[here] / 1e3 for name in ("zone_frequency", "zone_error"))
        assert "Band 3 at" in words.inner_text()
        assert words.inner_text().endswith(f"{uncertain(frequency[2], error[2])} kHz")
        page.get_by_text("Frequencies of all bands").click()
        page.get_by_role("table", name="Frequencies at").wait_for()
        cells = page.get_by_role("table", name="Frequencies at").locator("td:last-child").all_inner_texts()
        assert cells == [uncertain(*pair) for pair in zip(frequency, error, strict=True)]
        command = page.locator(".facts", has_text="Its modes").locator("code").inner_text()
        kappa, _ = wavevector_at(study.cell.zone, re.search('"(.+)"', command)[1])
        np.testing.assert_allclose(kappa, data["zone_kappa"].values[here], atol=1e-3)
        lines = np.array(page.evaluate(CONTOUR))
        height = data["zone_frequency"].values[:, 0].max() / 2
        for place in lines[::40]:  # a contour lies within the samples around it
            near = np.argsort(np.linalg.norm(wavevector - place, axis=1))[:12]
            around = data["zone_frequency"].values[sample[near], 0]
            assert around.min() <= height <= around.max()
        assert faults_of_layout(page) == []


def test_the_zone_has_the_colours_of_frequencies_between_its_wavevectors(browser, bands, address):
    """Linear in each triangle; contours and their numbers cover a few pixels."""
    colours = np.array(bands.view().extra["colours"])
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(f"{MAP}[data-shown]")
        page.get_by_role("region", name="Brillouin zone").locator("select").first.select_option("1")
        page.wait_for_selector(f"{MAP}[data-shown$=',0']")
        (mesh, *_), drawn = np.array(page.evaluate(MESH)), pixels(page, MAP)[..., :3]
    side, largest = len(drawn), np.pi / 7e-3
    scale = (side / 2 - 26) / largest
    away = []
    for shares in ((0.7, 0.2, 0.1), (0.1, 0.1, 0.8)):
        x, y, frequency = np.moveaxis(np.tensordot(mesh, shares, axes=(1, 0)), -1, 0)
        place = np.stack([side / 2 - scale * y, side / 2 + scale * x]).astype(int)
        low, high = mesh[..., 2].min(), mesh[..., 2].max()
        level = (frequency - low) / (high - low)
        shades = np.linspace(0, 1, len(colours))
        expected = np.stack([np.interp(level, shades, part) for part in colours.T], axis=-1)
        away.append(np.abs(drawn[tuple(place)] - expected).max(axis=-1))
    assert np.mean(np.concatenate(away) <= 3) > 0.8


def test_triangles_cover_the_zone_and_their_edges_follow_the_band(browser, bands, address):
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(f"{MAP}[data-shown]")
        meshes, levels = np.array(page.evaluate(MESH)), page.evaluate(LEVELS)
    step = 1.5 * np.pi / 7e-3 / 24
    for mesh in meshes:
        first, second = mesh[:, 1, :2] - mesh[:, 0, :2], mesh[:, 2, :2] - mesh[:, 0, :2]
        area = np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]) / 2
        assert area.sum() == pytest.approx((2 * np.pi / 7e-3) ** 2)
        np.testing.assert_allclose(area, area[0])
        edges = mesh - np.roll(mesh, 1, axis=1)
        assert np.linalg.norm(edges[..., :2], axis=-1).max() < step
    turned = (meshes[:, None, :, :, :2] != meshes[None, :, :, :, :2]).any(axis=(2, 3, 4))
    assert turned.any()  # not the same edges for each band
    data = bands.dataset
    for band, (heights, (low, high)) in enumerate(levels):
        error = data["zone_error"].values[:, band].max()
        assert all(low + error < height < high - error for height in heights)
    assert any(heights for heights, _ in levels)


@pytest.mark.parametrize("lattice", daily(["square", "hexagonal"], "square"))
def test_group_velocities_on_a_finer_mesh_are_within_both_errors(lattice):
    """Velocities that are zero by symmetry differ by rounding only."""
    modes = []
    for order in (3, 4):
        study = loads(on_mesh(order, lattice))
        model = bloch_model(study.cell, study.bands_settings)
        modes.append(ZoneModes.of(model, model.cell.zone.triangles(4)[0]))
    own, finer = modes
    apart = np.linalg.norm(own.velocity - finer.velocity, axis=-1)
    moving = np.linalg.norm(own.velocity, axis=-1) > 0.1
    assert moving.sum() > 80
    assert (apart < own.velocity_error + finer.velocity_error)[moving].all()
    assert (apart > 0.1 * own.velocity_error)[moving].any()
    np.testing.assert_array_equal(np.isnan(own.velocity_error), np.isnan(own.velocity[..., 0]))


@pytest.mark.parametrize("lattice", daily(["square", "hexagonal"], "square"))
def test_group_velocities_of_the_path_on_a_finer_mesh_are_within_both_errors(lattice):
    studies = [loads(on_mesh(order, lattice)) for order in (3, 4)]
    own, finer = (bands_dataset(study.cell, study.bands_settings, moving=True) for study in studies)
    velocity, error = own["group_velocity"].values, own["group_velocity_error"].values
    apart = np.linalg.norm(velocity - finer["group_velocity"].values, axis=-1)
    moving = np.linalg.norm(velocity, axis=-1) > 0.1
    assert moving.sum() > 60
    assert (apart < error + finer["group_velocity_error"].values)[moving].all()
    assert (apart > 0.03 * error)[moving].any()
    np.testing.assert_array_equal(np.isnan(error), np.isnan(velocity[..., 0]))


def test_a_picked_wavevector_moves_in_the_mode_of_the_model(browser, study, address):
    model = bloch_model(study.cell, study.bands_settings)
    points, pitch = model.fine.tiling.points, study.cell.lattice.pitch
    largest = np.pi / pitch
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(f"{MODE}[data-shown]")
        walk, words = page.get_by_role("application", name="Brillouin zone"), page.locator("#zone-point")
        box = page.locator(MAP).bounding_box()
        scale = (box["width"] / 2 - 26) / largest
        page.get_by_role("region", name="Brillouin zone").locator("select").first.select_option("1")
        for x, y in ((0.25, -0.5), (-0.75, 0.125)):  # both outside the irreducible zone
            position = {
                "x": box["width"] / 2 + scale * x * largest,
                "y": box["height"] / 2 - scale * y * largest,
            }
            page.locator(MAP).click(position=position)
            kappa = np.pi * np.array([x, y])
            page.wait_for_function("words => document.querySelector('#zone-point').innerText.includes(words)",
                                   arg=f"({x:g}, {y:g})".replace("-", MINUS))  # fmt: skip
            drawn = page.eval_on_selector(MODE, DRAWN)
            at, real, imag = (np.reshape(drawn[name], (-1, 3)) for name in ("position", "real", "imag"))
            turned = np.reshape(drawn["turned"], (3, 3)).T  # the browser stores columns
            places = at * drawn["period"] @ turned.T  # about the middle of the cell, which is the origin
            own = (real + 1j * imag) @ turned.T
            solution = model.solve(kappa)
            away = np.linalg.norm(points - places[:, None], axis=-1)
            nodes = away.argmin(axis=1)
            assert away.min(axis=1).max() < 1e-6 * pitch
            other = model.displacement(solution)[nodes][..., 0]
            factor = np.vdot(own, other) / np.vdot(own, own)
            assert np.abs(other - factor * own).max() < 2e-3 * np.abs(other).max()
            turns = np.reshape(drawn["turns"], (2, 2, 2)) @ [1, 1j]  # of two times two cells
            np.testing.assert_allclose(
                turns, np.exp(1j * np.add.outer([0, kappa[0]], [0, kappa[1]])), atol=1e-6
            )
            step = 1e-5 * np.array([[1, 0], [0, 1]])
            slopes = [float(model.frequencies(kappa + d)[0] - model.frequencies(kappa - d)[0]) for d in step]
            velocity = np.pi * np.array(slopes) / 1e-5 * pitch
            text = page.locator("dl", has_text="group velocity").last.inner_text()
            speed, error, angle = re.search(
                r"([\d.]+) ± ([\d.]+) m/s at (-?\d+)°", text.replace(MINUS, "-")
            ).groups()
            assert float(speed) == pytest.approx(np.linalg.norm(velocity), abs=0.6 * float(error))
            assert float(error) < 0.1 * float(speed)
            assert float(angle) == pytest.approx(np.degrees(np.arctan2(velocity[1], velocity[0])), abs=0.6)
            assert "pillar bending 1" in text
        before = pixels(page, MODE)
        walk.press("PageUp")
        page.wait_for_selector(f"{MODE}[data-shown$=',1']")
        assert "Band 2 at" in words.inner_text()
        assert (pixels(page, MODE) != before).any()
        page.locator(MODE).scroll_into_view_if_needed()
        walk.press(" ")
        assert advances(page, f"() => document.querySelector(`{MODE}`).moving.frames")


def test_images_of_modes_are_turned_like_their_wavevectors():
    lattice = Lattice(lattice="hexagonal", pitch=7e-3)
    third: Operation = ((-1, -1), (1, 0))
    operations = tuple(tuple(map(tuple, np.linalg.matrix_power(third, n).tolist())) for n in range(3))
    kappa, nothing = np.array([[0.3, 0.1], [1.0, -0.4]]), np.zeros((2, 1))
    group = PointGroup((lattice.a1, lattice.a2), operations)  # without half a turn, so time reversal counts
    surface = ZoneSurface(IrreducibleZone(lattice, ()), group, kappa, np.zeros((0, 3), int), nothing, nothing)
    wavevector, _, _ = surface.unfolded()
    turns, signs = surface.turns()
    np.testing.assert_allclose(
        turns @ np.swapaxes(turns, 1, 2), np.broadcast_to(np.eye(2), (6, 2, 2)), atol=1e-12
    )
    assert signs.tolist() == [1, 1, 1, -1, -1, -1]
    expected = np.einsum("c,cij,nj->cni", signs, turns, lattice.wavevector(kappa))
    np.testing.assert_allclose(wavevector.reshape(6, 2, 2), expected, atol=1e-9)
