"""Fields of waves in rows: against modes of the whole lattice, and moving on the page of a mirror."""

import numpy as np
import pytest

from browser import STILL, advances, faults_of_layout, page_at, pixels
from haptonic.bloch.candidates import best_model
from haptonic.bloch.evanescent import bloch_waves
from haptonic.bloch.face_grid import FaceGrid, FlatFace, strongest
from haptonic.bloch.mirrors import condensed_rows
from haptonic.bloch.row_fields import RowFields
from haptonic.results.steps import STEPS
from haptonic.study import loads
from quick import QUICK_CELL

FIELD = "[aria-label='Waves of the lattice'] .map canvas"
HEXAGONAL = QUICK_CELL.replace("[cell]", '[cell]\nlattice = "hexagonal"')
LAYERS = "\n[layers]\npoints = 7\ncount = 2\n"


@pytest.mark.parametrize(
    ("text", "along", "phase"),
    [(QUICK_CELL, (0, 1), 0.4), (QUICK_CELL, (1, 1), 0.0), (HEXAGONAL, (0, 1), 0.7)],
)
def test_a_wave_in_rows_is_the_mode_of_the_lattice_at_its_phases(text, along, phase):
    study, omega = loads(text), 2 * np.pi * 20e3
    model = best_model(study.cell, study.bands_settings).model
    rows = condensed_rows(study.cell, model.resolution, along)
    fields, lattice = RowFields.of(rows, phase), rows.rows
    right, _ = bloch_waves(fields.slab.slab.at(omega), omega)
    waves = right.chosen(np.flatnonzero(right.propagates))
    assert len(waves), "nothing would be compared"
    drawn, position = fields.field(omega, waves), fields.grid
    per_row = rows.exponents(waves, phase)
    face = FlatFace.of(model.fine.tiling, lattice.turn)
    vectors = study.cell.lattice.vectors @ lattice.turn.T
    grid = FaceGrid.of(
        position.across, position.along, face.position[:, ::-1], face.triangles, vectors[:, ::-1]
    )
    basis = np.linalg.inv(np.array([lattice.along, lattice.across], dtype=float).T)
    for number, exponent in enumerate(per_row):
        kappa = np.array([phase, exponent.imag]) @ basis
        solution = model.solve(kappa)
        mode = int(np.abs(solution.frequency - 20e3).argmin())
        assert solution.frequency[mode] == pytest.approx(20e3, rel=1e-2)
        motion = model.displacement(solution)[face.nodes][..., [mode]]
        motion[:, :2] = np.einsum("xy,nyk->nxk", lattice.turn, motion[:, :2])
        chosen, component = strongest(motion)
        assert component[0] == drawn.component[number]
        other, own = grid.values(chosen, 1j * kappa)[0], drawn.field[number]
        factor = np.vdot(own, other) / np.vdot(own, own)
        assert np.abs(other - factor * own).max() < 0.02 * np.abs(other).max()


def test_the_page_of_a_mirror_moves_the_wave_that_one_picks(browser, tmp_path):
    layers = loads(QUICK_CELL + LAYERS).layers(html=True)
    data, view = layers.dataset, layers.view()
    layers.files["layers.html"](tmp_path / "layers.html")
    decay, phase = (data[name].transpose("frequency", "wave").values for name in ("slab_decay", "slab_phase"))
    with page_at(browser, (tmp_path / "layers.html").as_uri(), **STILL) as page:
        page.wait_for_selector(f"{FIELD}[data-shown]")
        lines, carrier = len(decay), int(np.abs(data["frequency"].values - 60e3).argmin())
        page.locator("h1").click()
        page.keyboard.press("w")
        page.keyboard.press("w")
        page.keyboard.press("W")
        page.wait_for_selector(f"{FIELD}[data-shown='{lines + carrier}']")
        words = page.locator("#wave").inner_text()
        scale = page.locator("[aria-label='Waves of the lattice'] .scale").inner_text()
        assert "1 is the largest in the first row" in scale
        assert scale.startswith("\N{MINUS SIGN}1")
        assert words.startswith("Wave 2 of 8")
        assert words.endswith("decays")
        error = float(view.dataset["decay_error"][1, carrier])
        shown = page.locator(".facts:has(#wave) dl").inner_text()
        assert f"{float(view.dataset['decay'][1, carrier]):.0f} ± {np.ceil(error):.0f} dB per row" in shown
        field = (
            (data["wave_real"] + 1j * data["wave_imag"])
            .transpose("frequency", "wave", ...)
            .values[carrier, 1]
        )
        colours, drawn = np.array(view.extra["colours"]), pixels(page, FIELD)[..., :3]
        height, width = drawn.shape[:2]
        for row in range(6):  # of the lattice, from left to right, two periods of them from bottom to top
            turned = (field * np.exp((1j * phase - decay)[carrier, 1] * row)).real[::-1]
            line = ((np.arange(16) + 0.5) / 32 * height).astype(int)
            column = ((row + (np.arange(16) + 0.5) / 16) / 6 * width).astype(int)
            expected = colours[np.rint(STEPS * turned).astype(int) + STEPS]
            away = np.abs(drawn[np.ix_(line, column)] - expected).max(axis=-1)
            assert np.median(away) < 12
        page.keyboard.press("t")
        table = page.get_by_role("table", name="Waves of the lattice")
        table.get_by_role("button", name="wave 4").click()
        page.wait_for_selector(f"{FIELD}[data-shown='{3 * lines + carrier}']")
        page.locator("h1").click()
        page.keyboard.press(" ")
        page.locator(FIELD).scroll_into_view_if_needed()
        assert advances(page, f"() => document.querySelector(`{FIELD}`).counted.frames")
        page.keyboard.press(" ")
        chart = page.locator("[aria-label='Waves of the lattice'] .u-over").first
        chart.scroll_into_view_if_needed()
        box = chart.bounding_box()
        decays = view.dataset["decay"].values
        lone, top = int(np.flatnonzero(decays[:, 0] > 1)[0]), min(60.0, 1.05 * decays.max())
        chart.click(position={"x": 3, "y": box["height"] * (1 - decays[lone, 0] / top)})
        page.wait_for_selector(f"{FIELD}[data-shown='{lone * lines}']")
        assert faults_of_layout(page) == []
