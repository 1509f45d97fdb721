"""The table of keys agrees with the schema."""

import re
import tomllib

import pytest

from daily import daily
from each import each
from five_parts import refusing
from haptonic.errors import StudyError
from haptonic.fields import table
from haptonic.fields.keys import leaves, slots
from haptonic.study import Study, load, loads

KEYS = table(Study)
# that a rectangular cell with one pillar cannot have; for those of sites see test_study_sites
OF_SITES = {
    path
    for path, key in KEYS.items()
    if path.startswith("cell.site[].") and key.kind not in {"table", "tables"}
}
OF_LATTICES = {"cell.pitch_2", "cell.angle", "cell.a1", "cell.a2"}
OF_SECTIONS = {
    f"cell.pillar.{name}" for name in ("length", "sides", "corner_radius", "point[].x", "point[].y")
}
# of a pillar without a fillet
# and those of materials that are no isotropic ones of the plate; see test_study_python and test_study_plate
OF_MATERIALS = {
    path
    for path, key in KEYS.items()
    if path.startswith(
        ("cell.pillar.material", "plate.actuator[].bond.material.", "plate.actuator[].material.")
    )
    or re.fullmatch(r"material\.(c\d\d|turn)", path)
    if key.kind not in {"table", "tables"}
}
# in place of a pillar; test_stack and test_cad_files read and write them
OF_DISCS = {
    path
    for path, key in KEYS.items()
    if path.startswith(("cell.disc[].", "cell.solid.")) and key.kind not in {"table", "tables"}
}
OF_OTHERS = OF_LATTICES | OF_SECTIONS | OF_SITES | OF_MATERIALS | OF_DISCS


def paths_of(data, prefix=""):
    for name, value in data.items():
        key = KEYS.get(f"{prefix}{name}")
        if key and key.kind in {"quantities", "entries"}:
            yield f"{prefix}{name}"
        elif isinstance(value, list):
            for item in value:
                yield from paths_of(item, f"{prefix}{name}[].")
        elif isinstance(value, dict):
            yield from paths_of(value, f"{prefix}{name}.")
        else:
            yield f"{prefix}{name}"


def test_the_table_has_every_key_and_no_other(every_key_text, reference_text):
    given = set(paths_of(tomllib.loads(every_key_text)))
    by_name = {"plate.actuator[].material", "plate.actuator[].bond.material"}
    plain = {path for path, key in KEYS.items() if key.kind not in {"table", "tables"}}
    assert given | OF_OTHERS == plain | by_name
    assert set(paths_of(tomllib.loads(reference_text))) < given
    loads(every_key_text)


def test_every_key_explains_itself():
    for key in KEYS.values():
        assert key.title[0].isupper()
        assert key.description.endswith(".")
        assert key.kind in {
            "quantity", "number", "integer", "boolean", "text", "choice", "table", "tables", "quantities",
            "entries",
        }  # fmt: skip
        assert not key.unit or key.kind in {"quantity", "quantities", "entries"}
        assert key.unit or key.kind != "quantity"


def test_declared_once_and_read_everywhere():
    pitch = KEYS["cell.pitch"]
    assert (pitch.title, pitch.unit, pitch.kind, pitch.required) == ("Pitch", "m", "quantity", False)
    assert pitch.label == "Pitch (m)"
    assert pitch.typical == "100 nm to 100 mm"
    assert KEYS["bands.count"].bounds == "at least 1 and at most 60"
    assert KEYS["bands.count"].default == "10"
    assert KEYS["mesh.order"].bounds == "at least 2 and at most 10"
    assert KEYS["cell.lattice"].choices[:4] == ("square", "rectangular", "triangular", "centred")
    assert KEYS["material.poisson_ratio"].bounds == "above -1 and below 0.5"
    assert not KEYS["carrier"].required
    assert KEYS["title"].bounds == "at most 200 characters"
    assert KEYS["sweep"].kind == "tables"


@each(
    "path",
    [
        path
        for path, key in KEYS.items()
        if key.required and path not in OF_OTHERS and not path.startswith("cell.solid.")
    ],
)
def test_required_keys_are_those_that_cannot_be_left_out(path, every_key_text):
    *sections, name = re.split(r"\[?\]?\.", path)
    lines: list[str] = []
    heading, skipping = "", False
    for line in every_key_text.splitlines():
        if line.startswith("["):
            heading = line.strip("[] ")
            skipping = not sections and (heading == name or heading.startswith(f"{name}."))
        is_key = heading == ".".join(sections) and line.split("=")[0].strip() == name
        if not skipping and not is_key:
            lines.append(line)
    with refusing(StudyError, "missing"):
        loads("\n".join(lines))


LEFT_OUT = [
    path
    for path, key in KEYS.items()
    if not key.required
    and key.kind not in {"table", "tables"}
    and path not in OF_OTHERS
    and path != "cell.pitch"  # which two vectors may replace
    and path != "plate.actuator[].region"  # without it, the patch of this study would lie on a lattice
]


@pytest.mark.parametrize("path", daily(LEFT_OUT, *LEFT_OUT[::6]))
def test_every_other_key_can_be_left_out_of_its_table(path, every_key_text):
    """Alone, unless another key is there only because of it."""
    together = {
        "cell.lattice": {"cell.pitch_y"},
        "cell.pitch_y": {"cell.lattice"},
        "cell.pillar.section": {"cell.pillar.turn"},
        **{f"design.finger_{name}": {f"design.finger_{n}" for n in ("force", "span", "deflection")}
           for name in ("force", "span", "deflection")},
        **{f"plate.edges.{name}": {f"plate.edges.{n}" for n in ("left", "spring", "loss_factor")}
           for name in ("left", "spring")},
        "carrier": {"plate.actuator[].carrier", "plate.force[].carrier"},  # these differ from that one
        "plate.clamp.spring": {"plate.clamp.loss_factor"},
        "trials.exclude[].block": {"trials.exclude[].trial"},
    }.get(path, set()) | {path}  # fmt: skip
    heading, lines = "", []
    for line in every_key_text.splitlines():
        heading = line.strip("[] ") if line.startswith("[") else heading
        plain = f"{heading}.{line.split('=')[0].strip()}".lstrip(".")
        if plain not in {re.sub(r"\[\]", "", each) for each in together}:
            lines.append(line)
    study = loads("\n".join(lines))
    default = KEYS[path].default
    values = {re.sub(r"\[[0-9]+\]", "[]", name): value for name, value, _ in leaves(study)}
    assert values.get(path, "") == default or float(values[path]) == float(default)


def test_bounds_are_those_that_are_checked():
    """Each quantity accepts its bounds and refuses what lies just outside."""
    base = load_plain()
    periods = {"cell.pitch", "cell.pitch_y"}  # of similar size, so that they go to their bounds together
    for path in base.parameters():
        changed = periods if path in periods else {path}
        quantity = KEYS[path].quantity
        for bound, step in ((quantity.at_least, -1e-6), (quantity.at_most, 1e-6)):
            if abs(bound) in (0.0, float("inf")):
                continue
            with pytest.raises(StudyError):
                base.with_parameters(dict.fromkeys(changed, bound * (1 + step)))
            assert base.with_parameters(dict.fromkeys(changed, bound)).parameters()[path] == bound


def load_plain() -> Study:
    """A study without a pillar, so that every size can go to its bounds."""
    return loads(
        'carrier = "60 kHz"\n[material]\nyoungs_modulus = "70 GPa"\npoisson_ratio = 0.33\n'
        'density = "2700 kg/m^3"\n[cell]\nlattice = "rectangular"\npitch = "7 mm"\npitch_y = "8 mm"\n'
        'thickness = "1 mm"\n'
    )


def test_leaves_are_the_values_of_the_study(reference_path):
    values = {path: value for path, value, _ in leaves(load(reference_path))}
    assert values["cell.pillar.diameter"] == 0.0035
    assert values["sweep[2].to"] == 3.0
    assert values["material.name"] == "aluminium (paper)"
    assert "cell.pitch_y" not in values


def every_slot(kind, prefix=""):
    for slot in slots(kind):
        yield f"{prefix}{slot.name}", slot
        for below in slot.kinds:
            yield from every_slot(below, f"{prefix}{slot.name}.")


def test_a_title_is_declared_only_where_it_is_not_the_name():
    """A title like the name would have to be changed with it; the numbers of a model have their own."""
    own = {path: slot for path, slot in every_slot(Study) if slot.field.alias is None}
    own = {path: slot for path, slot in own.items() if not path.startswith("touch.skin.")}
    repeated = [path for path, slot in own.items()
                if slot.field.title == slot.name.replace("_", " ").capitalize()]  # fmt: skip
    assert repeated == []
