"""Pictures from the store: drawn once, and never an old one."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
import xarray as xr

from haptonic import plots
from haptonic.errors import HaptonicWarning
from haptonic.plots import style
from haptonic.results import pictures
from haptonic.results.result import Result, figure

DRAWN: list[str] = []


@style.drawn
def line(dataset):
    picture = style.blank(4.0)
    picture.subplots().plot(dataset["height"])
    return picture


@dataclass(frozen=True, eq=False, repr=False)
class Line(Result):
    dataset: xr.Dataset

    @figure("line")
    def _line(self):
        DRAWN.append(self.dataset.attrs["title"])
        return line(self.dataset)


@dataclass(frozen=True, eq=False, repr=False)
class Marked(Line):
    mark: float = 0.0


def heights(*values, title="study", **attributes):
    return xr.Dataset(
        {"height": ("place", np.array(values), {"units": "m"}), "name": ("place", list("abc"))},
        attrs={"title": title, "wide": np.arange(2.0), **attributes},
    )


@pytest.fixture(autouse=True)
def store(tmp_path, monkeypatch):
    DRAWN.clear()
    monkeypatch.setenv("HAPTONIC_STORE", str(tmp_path / "store"))
    return tmp_path / "store"


@pytest.fixture
def out(tmp_path):
    """Folder with the pictures of a first result, which was drawn once."""
    Line(heights(1.0, 2.0, 4.0)).write(tmp_path / "out")
    assert len(DRAWN) == 1
    return tmp_path / "out"


def contents(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_the_same_result_is_not_drawn_again(out, tmp_path):
    Line(heights(1.0, 2.0, 4.0)).write(tmp_path / "other")
    assert len(DRAWN) == 1
    assert contents(tmp_path / "other") == contents(out)
    assert contents(out)["line.png"].startswith(b"\x89PNG")
    assert contents(out)["line.svg"].rstrip().endswith(b"</svg>")


@pytest.mark.parametrize(
    "changed",
    [
        heights(1.0, 2.0, 4.0 + 1e-15 * 4),
        heights(1.0, 2.0, 4.0, title="another study"),
        heights(1.0, 2.0, 4.0, carrier_hz=60e3),
        heights(1.0, 2.0, 4.0, wide=np.arange(2.0) + 1e-9),
        heights(1.0, 2.0, 4.0).assign(name=("place", list("abd"))),
        heights(1.0, 2.0, 4.0).assign(height=("place", [1.0, 2.0, 4.0], {"units": "mm"})),
        heights(1.0, 2.0, 4.0).rename(height="depth", name="height").rename(depth="name"),
        heights(1.0, 2.0, 4.0).rename(place="site"),
    ],
    ids=["value", "title", "attribute", "array", "text", "unit", "names", "dimension"],
)
def test_another_result_is_drawn(out, changed):
    Line(changed).write(out, overwrite=True)
    assert len(DRAWN) == 2


def test_the_study_before_is_found_again(out):
    """Two studies that take turns in one folder never get the picture of each other."""
    first = contents(out)
    Line(heights(4.0, 2.0, 1.0)).write(out, overwrite=True)
    assert contents(out)["line.png"] != first["line.png"]
    Line(heights(1.0, 2.0, 4.0)).write(out, overwrite=True)
    assert (contents(out), len(DRAWN)) == (first, 2)


@pytest.mark.parametrize(
    "part", ["haptonic.store.fingerprint", "haptonic.results.pictures.drawing_fingerprint"]
)
def test_other_code_draws_again(out, monkeypatch, part):
    monkeypatch.setattr(part, lambda: "another")
    Line(heights(1.0, 2.0, 4.0)).write(out, overwrite=True)
    assert len(DRAWN) == 2


@pytest.mark.parametrize("library", ["matplotlib", "pillow"])
def test_another_version_of_a_library_draws_again(out, monkeypatch, library):
    real = pictures.version
    monkeypatch.setattr(pictures, "version", lambda name: "9.9" if name == library else real(name))
    pictures.drawing_fingerprint.cache_clear()
    try:
        Line(heights(1.0, 2.0, 4.0)).write(out, overwrite=True)
    finally:
        pictures.drawing_fingerprint.cache_clear()
    assert len(DRAWN) == 2


def test_another_look_draws_again(out):
    for how in ({"style": "column"}, {"legend": False}, {"style": "slide"}):
        with plots.chosen(**how):
            Line(heights(1.0, 2.0, 4.0)).write(out, overwrite=True)
    assert len(DRAWN) == 4


def test_a_deleted_or_damaged_picture_of_the_user_is_written_again(out):
    first = contents(out)
    (out / "line.png").unlink()
    (out / "line.svg").write_bytes(b"damaged")
    Line(heights(1.0, 2.0, 4.0)).write(out, overwrite=True)
    assert (contents(out), len(DRAWN)) == (first, 1)


def test_a_damaged_picture_in_the_store_is_drawn_again(out, store):
    first = contents(out)
    (stored,) = store.rglob("*.png")
    stored.write_bytes(stored.read_bytes()[:-70] + bytes(70))
    with pytest.warns(HaptonicWarning, match="was damaged"):
        Line(heights(1.0, 2.0, 4.0)).write(out, overwrite=True)
    assert (contents(out), len(DRAWN)) == (first, 2)
    Line(heights(1.0, 2.0, 4.0)).write(out, overwrite=True)
    assert len(DRAWN) == 2


@pytest.mark.parametrize("kind", ["png", "svg"])
def test_a_picture_that_left_the_store_is_drawn_again(out, store, kind):
    (stored,) = store.rglob(f"*.{kind}")
    stored.unlink()
    Line(heights(1.0, 2.0, 4.0)).write(out, overwrite=True)
    assert len(DRAWN) == 2


def test_a_result_with_more_than_its_dataset_is_always_drawn(tmp_path):
    result = Marked(heights(1.0, 2.0, 4.0))
    result.write(tmp_path / "out")
    replace(result, mark=1.0).write(tmp_path / "out", overwrite=True)
    assert len(DRAWN) == 2


def test_a_store_that_cannot_be_written_does_not_lose_the_picture(tmp_path, monkeypatch):
    (tmp_path / "file").touch()
    monkeypatch.setenv("HAPTONIC_STORE", str(tmp_path / "file" / "store"))
    with pytest.warns(HaptonicWarning, match="cannot be used"):
        Line(heights(1.0, 2.0, 4.0)).write(tmp_path / "out")
    assert set(contents(tmp_path / "out")) == {"line.svg", "line.png"}
