"""A written study reads back as the same study, bit for bit."""

import tomllib
import warnings

from hypothesis import given, settings, strategies as st

from haptonic.errors import HaptonicWarning
from haptonic.materials import library
from haptonic.study import Study, load, loads

lengths = st.floats(1e-9, 1e3)
texts = st.text(st.characters(exclude_categories=["Cs"]), min_size=1, max_size=40)
tables = st.fixed_dictionaries(
    {
        "name": texts.filter(str.strip),
        "youngs_modulus": st.floats(1e3, 1e13),
        "poisson_ratio": st.floats(-0.999, 0.499),
        "density": st.floats(1.0, 5e4),
    },
    optional={"loss_factor": st.floats(0, 0.999), "source": texts},
)


@st.composite
def studies(draw):
    pitch = draw(lengths)
    ratio = draw(st.none() | st.floats(1.01e-3, 0.99e3))
    pitch_y = ratio and min(max(ratio * pitch, 1e-9), 1e3)
    cell = {"pitch": pitch, "thickness": draw(lengths), "lattice": "rectangular" if pitch_y else "square"}
    if pitch_y:
        cell["pitch_y"] = pitch_y
    diameter = (min(pitch, pitch_y or pitch) - 0.02 * pitch) * draw(st.floats(0.1, 0.99))
    if 1e-9 < diameter < 1e3 and draw(st.booleans()):
        cell["pillar"] = {"diameter": diameter, "height": draw(lengths)}
    data = {"title": draw(texts), "material": draw(st.sampled_from(sorted(library())) | tables), "cell": cell}
    if draw(st.booleans()):
        data["carrier"] = draw(st.floats(1, 1e9))
    if draw(st.booleans()):
        data["bands"] = {"count": draw(st.integers(1, 60)), "accuracy": draw(st.floats(1e-6, 0.1))}
        data["mesh"] = {"order": draw(st.integers(2, 10))}
    return Study(**data)


@settings(deadline=None)
@given(studies())
def test_round_trip_is_exact(study):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", HaptonicWarning)
        again = loads(study.to_toml())
    assert again == study
    assert again.inputs() == study.inputs()
    assert again.to_toml() == study.to_toml()


def test_negative_zero_is_zero(reference_path):
    study = load(reference_path).with_parameter("material.loss_factor", -0.0)
    assert "loss_factor = 0.0" in study.to_toml()
    assert study.inputs() == loads(study.to_toml()).inputs()


def test_reference_study_with_its_sweeps(reference_path):
    study = load(reference_path)
    assert loads(study.to_toml()) == study


def test_sweep_with_units(edited):
    text = edited(
        ("cell.pillar.height / cell.pitch", "cell.pillar.height"),
        ("from = 1.0", 'from = "1 cm"'),
        ("to = 3.0", 'to = "21 mm"'),
    )
    study = loads(text)
    assert (study.sweep_settings[1].start, study.sweep_settings[1].stop) == (0.01, 0.021)
    assert loads(study.to_toml()) == study


def test_written_study_is_readable(reference_path):
    written = tomllib.loads(load(reference_path).to_toml())
    original = tomllib.loads(reference_path.read_text("utf-8"))
    pillar = original["cell"].pop("pillar")
    assert written["cell"].pop("faces") == "one"
    assert written["cell"].pop("pillar") == {"section": "round", "draft": "0 rad", "fillet": "0 m", **pillar}
    for section in ("cell", "bands", "sweep"):
        assert written[section] == original[section]
    assert written["carrier"] == "60 kHz"
    assert written["material"]["youngs_modulus"] == "70 GPa"
