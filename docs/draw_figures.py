"""Draw the pictures of these pages that no page computes itself: `python docs/draw_figures.py [NAME ...]`.

Names are `badges`, `mesh`, `convergence`, `maps`, `ribbon`, `pages`, `studio` and `wizard`; without one, all
are drawn. `maps`, `ribbon` and `pages` compute for minutes. `pages`, `studio` and `wizard` need Chromium, and
`tests` and `tests/studio` in PYTHONPATH. The others take seconds.
"""

from __future__ import annotations

import json
import sys
import tomllib
from collections.abc import Callable, Iterator
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

import haptonic as hp
from haptonic.arrays import Array
from haptonic.bloch import bloch_model
from haptonic.bloch.settings import BandSettings, MeshSettings
from haptonic.cell import HexMesh, MeshPlan, UnitCell
from haptonic.cell.mesh import mesh_cell
from haptonic.cell.quadrature import lobatto
from haptonic.plots import style
from haptonic.views import InteractiveView, write_page

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Locator, Page

ROOT = Path(__file__).parents[1]
IMAGES = ROOT / "docs" / "images"
TOUCHPAD = ROOT / "studies" / "touchpad.toml"
CORNERS = {"G": (0.0, 0.0), "X": (np.pi, 0.0), "M": (np.pi, np.pi)}
MESHES = ((2, 1), (3, 1), (4, 1), (5, 1), (5, 2))  # order, thin rings
FOOT = (1.1, 2.5), (0.9, 2.3)  # range of the enlarged part of the section, mm
BANDS = 6  # up to the lower edge of the gap


def curves(mesh: HexMesh) -> Iterator[Array]:
    """(nodes, 3) points along each of the twelve edges of each element, m."""
    for family in mesh.topology.families:
        for axis in range(3):
            for ends in product((0, -1), repeat=2):
                index: list[slice | int] = list(ends)
                index.insert(axis, slice(None))
                for nodes in family.nodes[(slice(None), *index)]:
                    yield lagrange(len(nodes) - 1) @ mesh.points[nodes]


def lagrange(order: int, count: int = 41) -> Array:
    """(count, order + 1) polynomials on Gauss-Lobatto-Legendre points, at even places from -1 to 1."""
    nodes, places = lobatto(order)[0], np.linspace(-1, 1, count)
    others = [np.delete(nodes, number) for number in range(order + 1)]
    return np.stack(
        [
            np.prod((places[:, None] - other) / (node - other), axis=1)
            for node, other in zip(nodes, others, strict=True)
        ],
        axis=1,
    )


def draw_mesh() -> None:
    """The reference cell from above and in a section, its foot, and the polynomials of an element."""
    cell = hp.load(TOUCHPAD).cell
    mesh = mesh_cell(cell.tiles[0].tile, MeshPlan.suited(cell.tiles[0].tile, 4, 1))
    with style.styled():
        figure = style.blank(10.5)
        inner: list[tuple[float, float]] = []  # where edges of the section end next to the core, m
        panels = figure.subplot_mosaic(
            [["section", "foot", "above"], ["section", "basis", "basis"]], width_ratios=(1.2, 1, 1)
        )
        section, foot, above = (panels[name] for name in ("section", "foot", "above"))
        for points in curves(mesh):
            if np.abs(points[:, 2] - cell.thickness).max() < 1e-9:
                above.plot(*1e3 * points[:, :2].T, color=style.INK, linewidth=0.6)
            if np.abs(points[:, 0] - points[:, 1]).max() < 1e-9:
                along = points[:, :2].sum(axis=1) / np.sqrt(2)
                if np.ptp(points[:, 2]) < 1e-9:
                    inner.append((float(abs(along).min()), float(points[0, 2])))
                for axes in (section, foot):
                    axes.plot(1e3 * along, 1e3 * points[:, 2], color=style.INK, linewidth=0.6)
        core = min(inner)[0]
        for height in {round(z, 9) for along, z in inner if along < 1.001 * core}:
            for axes in (section, foot):
                axes.plot([-1e3 * core, 1e3 * core], [1e3 * height] * 2, color=style.INK, linewidth=0.6)
        above.set(
            aspect="equal", title="plate, from above", xlabel="x (mm)", ylabel="y (mm)", xticks=[-2, 0, 2]
        )
        section.set(aspect="equal", title="section", xlabel="along the diagonal (mm)", ylabel="z (mm)")
        foot.set(aspect="equal", title="foot, enlarged", xlabel="along the diagonal (mm)", ylabel="z (mm)")
        magnify(section, foot)
        draw_basis(panels["basis"])
        figure.savefig(IMAGES / "method-mesh.png", dpi=style.DOTS_PER_INCH)


def magnify(section: Axes, foot: Axes) -> None:
    """Limit one panel to the thin elements at the edge of the pillar, and frame these in the section."""
    x, z = FOOT
    foot.set(xlim=x, ylim=z)
    section.add_patch(
        Rectangle(
            (x[0], z[0]), x[1] - x[0], z[1] - z[0], fill=False, edgecolor=style.RED, linewidth=1.0, zorder=5
        )
    )
    foot.spines[:].set(edgecolor=style.RED, linewidth=1.0)


def draw_basis(axes: Axes, order: int = 4) -> None:
    """Lagrange polynomials on the Gauss-Lobatto-Legendre points of an element."""
    nodes = lobatto(order)[0]
    colours = (style.BLUE, style.ORANGE, style.INK, style.SKY, style.RED)
    for curve, colour in zip(lagrange(order, 201).T, colours, strict=True):
        axes.plot(np.linspace(-1, 1, 201), curve, color=colour, linewidth=1.1)
    axes.plot(nodes, np.zeros_like(nodes), "o", color=style.INK, markersize=3)
    axes.set(
        title=f"polynomials, order {order}",
        xlabel="place in the element",
        ylabel="value",
        xticks=[-1, -0.5, 0, 0.5, 1],
    )


def measure(cell: UnitCell, order: int, rings: int) -> tuple[int, float, float]:
    """Unknowns of the mesh, and its largest relative error and estimate at the corners of the zone."""
    model = bloch_model(cell, BandSettings(mesh=MeshSettings(order=order, foot_rings=rings)))
    reference = json.loads((ROOT / "tests/data/reference_cell.json").read_text("utf-8"))
    errors, estimates = [], []
    for name, phases in CORNERS.items():
        solution = model.solve(np.array(phases))
        exact = np.array(reference[name][:BANDS], dtype=float)
        above = exact > 0
        errors.append(np.abs(solution.frequency[:BANDS] - exact)[above] / exact[above])
        estimates.append(solution.error[:BANDS][above] / exact[above])
    mesh = mesh_cell(cell.tiles[0].tile, MeshPlan.suited(cell.tiles[0].tile, order, rings))
    return mesh.unknowns, float(np.concatenate(errors).max()), float(np.concatenate(estimates).max())


def draw_convergence() -> None:
    """True errors and estimates of the reference cell against the unknowns of the mesh."""
    cell = hp.load(TOUCHPAD).cell
    unknowns, errors, estimates = zip(*(measure(cell, *fineness) for fineness in MESHES), strict=True)
    with style.styled():
        figure = style.blank(7.0, width=12.0)
        axes = figure.subplots()
        axes.plot(unknowns, 100 * np.array(estimates), "o--", color=style.GAP_EDGE, label="estimate")
        axes.plot(unknowns, 100 * np.array(errors), "o-", color=style.INK, label="true error")
        for place, error, (order, rings) in zip(unknowns, errors, MESHES, strict=True):
            label = f"order {order}" + (", 2 rings" if rings == 2 else "")
            axes.annotate(label, (place, 100 * error), (-5, -8), textcoords="offset points", ha="right")
        axes.margins(0.2, 0.15)
        style.logarithmic(axes)
        style.logarithmic(axes, across=True)
        axes.set(xlabel="unknowns of the mesh", ylabel="largest error of bands 1 to 6 (%)")
        axes.legend(frameon=False)
        figure.savefig(IMAGES / "method-convergence.png", dpi=style.DOTS_PER_INCH)


def draw_maps() -> None:
    """Maps of the prototype's vibration below, in and above its gap."""
    hp.load(TOUCHPAD).plate().plot("maps").savefig(IMAGES / "plate-maps.png", dpi=style.DOTS_PER_INCH)


def draw_ribbon() -> None:
    """Projected bands of the template of two honeycombs, and the wave along their edge."""
    waves = hp.load(ROOT / "src/haptonic/templates/edge.toml").ribbon()
    waves.plot("ribbon").savefig(IMAGES / "ribbon-edge.png", dpi=style.DOTS_PER_INCH)
    waves.plot("field").savefig(IMAGES / "ribbon-field.png", dpi=style.DOTS_PER_INCH)


SHARP: dict[str, Any] = {  # context of a page whose type can be read in a column of text
    "viewport": {"width": 900, "height": 900}, "device_scale_factor": 2, "reduced_motion": "reduce",
}  # fmt: skip
MARGIN = 12  # CSS pixels around what a picture shows
SHOWN = {  # parts of a page at the lower end of its picture, from side to side; all below is left out
    "bands-page.png": ("#point",),
    "zone-page.png": (".facts dl", ":scope > div:last-child > .sides"),
    "studio-scan.png": ("table",),
    "studio-preview.png": (".mode .scale",),
    "layers-page.png": ("section:first-child > .curves", ".controls"),
}

SHOW_ONLY = """([parts, bottom]) => {
    for (const element of document.body.querySelectorAll("*")) {
        const { top, bottom: end } = element.getBoundingClientRect();
        const isPart = parts.some((part) => part.contains(element) || element.contains(part));
        const isCut = top > bottom - 1 || (element.childElementCount === 0 && end > bottom + 1);
        element.style.visibility = isPart && !isCut ? "" : "hidden";
    }
}"""


def draw_pages() -> None:
    """The interactive pages, drawn by a browser."""
    from browser import chromium  # of the tests

    touchpad, edge = hp.load(TOUCHPAD), hp.load(ROOT / "src/haptonic/templates/edge.toml")
    with chromium() as browser:
        for name, result in {
            "bands": touchpad.bands(html=True, surface=True),
            "layers": touchpad.layers(html=True),
            "waveguide": touchpad.waveguide(html=True),
            "ribbon": edge.ribbon(html=True),
            "plate": touchpad.plate(html=True),
            "feel": touchpad.feel(html=True),
        }.items():
            draw_page(browser, name, result.view())


def draw_page(browser: Browser, name: str, view: InteractiveView | None) -> None:
    """The page of a view, and the zone on the page of bands."""
    from browser import page_at  # of the tests

    with TemporaryDirectory() as folder:
        file = Path(folder) / f"{name}.html"
        write_page(view, file)
        with page_at(browser, file.as_uri(), **SHARP) as page:
            page.wait_for_selector(".walk canvas")
            page.wait_for_timeout(500)  # until all parts are drawn
            picture(page, f"{name}-page.png", page.locator(".pair").first)
            if name == "bands":
                draw_zone(page)


def picture(page: Page, name: str, *parts: Locator) -> None:
    """Save what parts of a page cover, with a margin; nothing has the focus."""
    page.evaluate("() => document.activeElement?.blur()")
    page.wait_for_timeout(200)
    ends = [end for part in parts for chosen in SHOWN.get(name, ()) for end in part.locator(chosen).all()]
    boxes, lowest = ([part.bounding_box() for part in these] for these in (parts, ends or parts))
    left, top = (min(box[side] for box in boxes if box) for side in ("x", "y"))
    right = max(box["x"] + box["width"] for box in boxes if box)
    bottom = max(box["y"] + box["height"] for box in lowest if box)
    page.evaluate(SHOW_ONLY, [[part.element_handle() for part in parts], bottom])
    x, y = page.evaluate("() => [scrollX, scrollY]")
    page.screenshot(
        path=IMAGES / name, full_page=True,
        clip={"x": left + x - MARGIN, "y": top + y - MARGIN,
              "width": right - left + 2 * MARGIN, "height": bottom - top + 2 * MARGIN},
    )  # fmt: skip
    page.evaluate(SHOW_ONLY, [[page.locator("body").element_handle()], 1e9])  # all


def draw_zone(page: Page) -> None:
    """The zone on the page of bands, at a wavevector inside it."""
    zone = page.get_by_role("application", name="Brillouin zone")
    for key, times in (("ArrowLeft", 9), ("ArrowDown", 5)):
        for _ in range(times):
            zone.press(key)
    page.add_style_tag(content=".insight { position: static !important; }")  # it would cover the picture
    page.wait_for_timeout(500)
    picture(page, "zone-page.png", page.locator(".pair").nth(1))


STUDIO = 1280  # CSS pixels, width of its window
STEPS = 40  # of the slider, from the design to the preview that is drawn


def draw_studio() -> None:
    """The studio with the touchpad's study and its bands, drawn by a browser."""
    from served import served

    from browser import chromium, page_at  # of the tests

    with TemporaryDirectory() as temporary, chromium() as browser:
        folder = Path(temporary) / "studies"
        folder.mkdir()
        (folder / TOUCHPAD.name).write_text(TOUCHPAD.read_text("utf-8"), "utf-8")
        with (
            served(folder, TOUCHPAD.name, admit=False) as studio,
            page_at(
                browser, studio.link, **(SHARP | {"viewport": {"width": STUDIO, "height": 2000}})
            ) as page,
        ):
            page.locator(".paint table", has_text="haptonic plate").wait_for()
            picture(page, "paint.png", page.locator(".paint"))
            page.locator(".paint > summary").click()
            page.get_by_role("button", name="Compute bands").click()
            page.wait_for_selector("canvas[data-shown]", timeout=120_000)
            page.locator(".turning select").select_option("cell.pillar.diameter", timeout=120_000)
            page.wait_for_selector(".turning[data-prepared=true]", timeout=120_000)
            for _ in range(3):  # parts of the page follow its height
                lowest = page.locator(".results .mode .scale").bounding_box()
                assert lowest is not None
                page.set_viewport_size(
                    {"width": 1200, "height": int(lowest["y"] + lowest["height"]) + MARGIN}
                )
                page.wait_for_timeout(300)
            picture(page, "studio.png", page.locator("body"))
            page.set_viewport_size({"width": STUDIO, "height": 2000})  # nothing scrolls
            page.get_by_role("button", name="Hold this design").click()
            slider = page.locator(".turning input")
            for _ in range(STEPS):
                slider.press("ArrowRight")
            # between them, the sentences of the held design are hidden
            picture(
                page, "studio-preview.png", page.locator(".insight"), page.locator(".results .pair").first
            )


def draw_wizard() -> None:
    """The wizard of the studio with a simulated scan of a small plate, and the scan beside its model."""
    from served import served

    from browser import chromium, page_at  # of the tests
    from tiny_scan import TINY

    with TemporaryDirectory() as temporary, chromium() as browser:
        folder = Path(temporary) / "studies"
        folder.mkdir()
        (folder / "small.toml").write_text(TINY, "utf-8")
        hp.load(folder / "small.toml").simulate_scan(form="uff", time=False).write(Path(temporary) / "scan")
        with (
            served(folder, "small.toml", admit=False) as studio,
            page_at(browser, studio.link, **SHARP) as page,
        ):
            page.set_viewport_size({"width": 900, "height": 2400})  # the results scroll on a smaller page
            page.locator(".paint > summary").click()
            page.get_by_label("Analysis").select_option("scan")
            page.set_input_files("input[data-choose=files]", Path(temporary) / "scan" / "scan.uff")
            page.wait_for_selector(".reading .points", timeout=60_000)
            picture(page, "studio-scan.png", page.locator(".compute"))
            page.get_by_label("model", exact=True).check()
            page.wait_for_selector(".understood[aria-busy=false] .points", timeout=60_000)
            page.get_by_role("button", name="Compute scan").click()
            page.wait_for_selector(".map canvas[data-shown]", timeout=300_000)
            picture(page, "scan-page.png", page.locator("#result .plate"))


def draw_badges() -> None:
    """Python versions, licence and state of the project, from pyproject.toml."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    minors = [line.rpartition("3.")[2] for line in project["classifiers"] if "Python :: 3." in line]
    (state,) = (
        line.rpartition(" - ")[2] for line in project["classifiers"] if line.startswith("Development")
    )
    for name, key, value in (
        ("python", "python", f"3.{minors[0]} to 3.{minors[-1]}"),
        ("licence", "licence", project["license"]),
        ("status", "status", state.lower()),
    ):
        left, right = (10 + 6.5 * len(text) for text in (key, value))
        (IMAGES / f"badge-{name}.svg").write_text(
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{left + right}" height="20" role="img" '
            f'aria-label="{key}: {value}"><rect width="{left}" height="20" fill="#444"/>'
            f'<rect x="{left}" width="{right}" height="20" fill="#1a6b8f"/>'
            '<g fill="#fff" font-family="Verdana,sans-serif" font-size="11" text-anchor="middle">'
            f'<text x="{left / 2}" y="14">{key}</text><text x="{left + right / 2}" y="14">{value}</text>'
            "</g></svg>\n",
            encoding="utf-8",
        )


DRAWN: dict[str, Callable[[], None]] = {
    "badges": draw_badges, "mesh": draw_mesh, "convergence": draw_convergence, "maps": draw_maps,
    "ribbon": draw_ribbon, "pages": draw_pages, "studio": draw_studio, "wizard": draw_wizard,
}  # fmt: skip

if __name__ == "__main__":
    for chosen in sys.argv[1:] or DRAWN:
        DRAWN[chosen]()
