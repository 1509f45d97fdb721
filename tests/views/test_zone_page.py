"""The Brillouin zone on the page of bands: its numbers, and what one picks in a real browser."""

import re

import numpy as np

from browser import STILL, faults_of_layout, page_at
from haptonic.bloch.model import bloch_model
from haptonic.bloch.wavevectors import wavevector_at
from haptonic.study import loads
from haptonic.units import uncertain
from quick import QUICK_CELL

MAP = ".zone canvas"
CONTOUR = """() => {
    const zone = document.querySelector(".zone canvas").zone;
    return zone.contour(0, zone.range(0)[1] / 2).flat();
}"""


def test_a_wavevector_of_the_zone_has_the_frequencies_of_the_model(browser, tmp_path):
    study = loads(QUICK_CELL)
    bands = study.bands(html=True, surface=True)
    model, data = bloch_model(study.cell, study.bands_settings), bands.dataset
    for sample in (3, 77, 200):
        solution = model.solve(data["zone_kappa"].values[sample])
        np.testing.assert_allclose(data["zone_frequency"][sample], solution.frequency, rtol=1e-9)
        np.testing.assert_allclose(data["zone_error"][sample], solution.error, rtol=1e-6)
    view = bands.view().dataset
    wavevector, sample = view["zone_wavevector"].values, view["zone_sample"].values
    largest = np.pi / 7e-3
    bands.write(tmp_path)
    with page_at(browser, (tmp_path / "bands.html").as_uri(), **STILL) as page:
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
            assert f"({x:g}, {y:g}) π/a" in words.inner_text()
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
