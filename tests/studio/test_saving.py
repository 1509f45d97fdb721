"""Files of a result from the studio: made by the result's own writers, in an export process."""

import io
import math
import os
import re
import signal
import zipfile

import pytest
from PIL import Image
from served import Served, served

from haptonic import plots
from haptonic.plots.looks import LOOKS
from haptonic.results.table import FORMS
from haptonic.studio.files import chosen_export, file_of
from haptonic.study import loads
from quick import QUICK_CELL

HOSTILE = QUICK_CELL.replace('"Quick"', '"<script>../../x</script>"')


@pytest.fixture(scope="module")
def studio(tmp_path_factory):
    with served(tmp_path_factory.mktemp("saving")) as running:
        yield running


@pytest.fixture(scope="module")
def job(studio) -> dict:
    reply = studio.post("run", analysis="bands", options={}, text=HOSTILE, file=None)
    return studio.finished(reply.json["number"])


def saved(studio: Served, job: dict, **wanted: object) -> tuple[str, bytes]:
    reply = studio.post("product", number=job["number"], **wanted)
    assert reply.status == 200, reply.content
    assert reply.headers["Content-Type"] == "application/octet-stream"
    (name,) = re.findall(r'^attachment; filename="([A-Za-z0-9._+-]+)"$', reply.headers["Content-Disposition"])
    return name, reply.content


def test_pictures_have_the_width_of_their_style(studio, job):
    name, content = saved(studio, job, kind="picture", name="dispersion", form="png", style="column")
    assert name == "dispersion.png"
    picture = Image.open(io.BytesIO(content))
    assert picture.width / picture.info["dpi"][0] * 25.4 == pytest.approx(85, abs=0.2)
    _, content = saved(studio, job, kind="picture", name="dispersion", form="pdf", style="wide")
    width = float(re.search(rb"/MediaBox \[ 0 0 ([0-9.]+)", content)[1])
    assert width / 72 * 25.4 == pytest.approx(180, abs=0.2)
    assert b"/Type3" not in content
    _, content = saved(studio, job, kind="picture", name="dispersion", form="svg")
    assert content == studio.ask("GET", f"/api/jobs/{job['number']}/pictures/dispersion").content


def test_tables_and_files_are_those_of_the_result(studio, job):
    (gaps, *_) = job["answer"]["tables"]
    name, content = saved(studio, job, kind="table", name=gaps["title"], form="latex")
    assert name.endswith(".tex")
    assert rb"\begin{tabular}" in content
    assert b"simulated" in content
    _, content = saved(studio, job, kind="table", name=gaps["title"], form="csv")
    assert len(content.decode().splitlines()) == 1 + gaps["count"]
    for file in job["answer"]["files"]:
        name, content = saved(studio, job, kind="file", name=file)
        assert name == file
        assert content
    name, content = saved(studio, job, kind="folder")
    assert name == "bands.zip"
    names = set(zipfile.ZipFile(io.BytesIO(content)).namelist())
    assert names >= {*job["answer"]["files"], "dispersion.svg", "dispersion.png", "modes.vtu", "bands.nc"}
    assert not any(".." in each or each.startswith("/") for each in names)


def test_axes_of_pictures_have_the_units_of_the_view(studio, job, monkeypatch):
    units = {"Hz": ["ωa/(2πcₜ)", 4.5e5], "rad/m": ["2π/a", 2 * math.pi / 7e-3]}
    wanted = {"kind": "picture", "name": "dispersion", "form": "svg"}
    usual, other = (saved(studio, job, **wanted, **more)[1] for more in ({}, {"units": units}))
    assert usual != other
    figures = []
    monkeypatch.setattr(plots, "rendered", lambda figure, kind: figures.append(figure) or b"")
    result = loads(QUICK_CELL).bands()
    for given in ({}, units):
        file_of(result, chosen_export(wanted | {"units": given}), "bands")
    plain, chosen = (figure.axes[0] for figure in figures)
    assert (plain.get_xlabel(), plain.get_ylabel()) == ("wavevector", "frequency (kHz)")
    assert (chosen.get_xlabel(), chosen.get_ylabel()) == ("length of the path (2π/a)", "ωa/(2πcₜ)")
    assert chosen.get_ylim() == plain.get_ylim()  # the same curves
    assert [text.get_text() for text in chosen.get_xticklabels()][1] == "X\n0.5"
    places = chosen.get_yticks()
    assert len(places) > 3
    for place in places:
        assert float(chosen.yaxis.get_major_formatter()(place, 0)) == pytest.approx(1e3 * place / 4.5e5)


def test_the_page_is_saved_and_never_shown_by_the_studio(studio, job):
    reply = studio.ask("GET", f"/api/jobs/{job['number']}/page")
    assert reply.headers["Content-Disposition"] == 'attachment; filename="bands.html"'
    assert reply.content.startswith(b"<!doctype html>")
    assert b"<script>../../x" not in reply.content
    assert studio.ask("GET", "/api/jobs/9999/page").status == 404


@pytest.mark.parametrize(
    "wanted",
    [
        {"kind": "picture", "name": "../../x", "form": "svg"},
        {"kind": "picture", "name": "dispersion", "form": "exe"},
        {"kind": "picture", "name": "dispersion", "form": "svg", "style": "__class__"},
        {"kind": "picture", "name": "dispersion", "form": "svg", "units": {"Hz": ["<script>", 1.0]}},
        {"kind": "picture", "name": "dispersion", "form": "svg", "units": {"rad/m": ["kHz", 1.0]}},
        {"kind": "picture", "name": "dispersion", "form": "svg", "units": {"Hz": ["kHz", 0]}},
        {"kind": "picture", "name": "dispersion", "form": "svg", "units": {"Hz": "kHz"}},
        {"kind": "picture", "name": "dispersion", "form": "svg", "units": ["kHz"]},
        {"kind": "table", "name": "none", "form": "csv"},
        {"kind": "file", "name": "../quick.toml"},
        {"kind": "file", "name": ["bands.nc"]},
        {"kind": "secret"},
        {"kind": ["folder"]},
        {},
    ],
)
def test_anything_else_is_refused(studio, job, wanted):
    reply = studio.post("product", number=job["number"], **wanted)
    assert reply.status == 422
    assert "next_step" in reply.json["error"]
    assert studio.post("product", number=9999, kind="folder").status == 422


def test_an_export_process_that_dies_is_replaced(studio, job):
    saved(studio, job, kind="table", name=job["answer"]["tables"][0]["title"], form="csv")
    process = studio.studio.exports._worker.process
    os.kill(process.pid, signal.SIGKILL)
    process.join()
    assert studio.post("product", number=job["number"], kind="folder").status == 200


def test_the_page_offers_what_plots_and_tables_offer(studio):
    offered = studio.ask("GET", "/api/start").json["exports"]
    assert offered["looks"].keys() == LOOKS.keys()
    assert offered["tables"] == list(FORMS)
