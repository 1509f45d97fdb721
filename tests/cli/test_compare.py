"""Two sets of bands beside each other, and the tables that other programs write."""

from __future__ import annotations

import json
import tracemalloc
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pytest
import xarray as xr
from hypothesis import given, strategies as st

from each import each
from five_parts import assert_five_parts, refused
from haptonic.analyses import compare, named
from haptonic.analyses.comparing import PARTS, OfTable, loss_of, of_dataset, of_file, of_table
from haptonic.analyses.runner import Runner
from haptonic.analyses.table_path import OurPath
from haptonic.bloch import bloch_model
from haptonic.bloch.gap_datasets import dataset_of_gaps
from haptonic.channels.text_table import read_table
from haptonic.errors import ChannelError, StudyError
from haptonic.results.common import write_files
from haptonic.results.comparison import BandSet, Comparison
from haptonic.store import Store
from haptonic.study import load, loads
from haptonic.study.loading import load_as
from haptonic.study.schema import Description
from pace import within
from quick import QUICK_CELL

CORNERS = (0.0, 450.0, 900.0, 900.0 + 450.0 * 2**0.5)  # rad/m
SQUARE = [[[a, 0], [0, b]] for a in (1, -1) for b in (1, -1)] + [
    [[0, a], [b, 0]] for a in (1, -1) for b in (1, -1)
]
BANDS = 4


def dispersion(position: np.ndarray) -> np.ndarray:
    """(wavevector, band) Hz, of no lattice in particular; linear between corners, with a gap above band 2."""
    base = np.interp(position, [0, 1, 2, 3], [0.2, 1.0, 1.4, 0.2])
    return 1e4 * np.stack([base, base + 1.0, base + 4.0, base + 4.1], axis=1)


def ours(count: int = 31) -> xr.Dataset:
    """As `haptonic bands` has it."""
    position = np.union1d(np.linspace(0, 3, count), [1, 2])
    distance = np.interp(position, range(4), CORNERS)
    attrs = {
        "path_corners": json.dumps([int(np.flatnonzero(position == k)[0]) for k in range(4)]),
        "path_labels": json.dumps(["Γ", "X", "M", "Γ"]),
        "inputs": json.dumps({"cell": {"pitch": 0.007}}),
        "lattice": json.dumps({"form": "square", "period": np.pi / CORNERS[1]}),
        "zone": json.dumps([("Γ", (0.0, 0.0)), ("X", (1.0, 0.0)), ("M", (1.0, 1.0))]),
        "point_group": json.dumps(SQUARE),
    }
    data = {"distance": ("wavevector", distance), "frequency": (("wavevector", "band"), dispersion(position))}
    return dataset_of_gaps(()).assign(data).assign_attrs(attrs)


def laid(path: Path, wavevector: str | None = None, unit: str | None = None) -> BandSet:
    """The bands of a table on our path."""
    return of_table(path, OurPath.of_dataset(ours()), OfTable(wavevector=wavevector, frequency_unit=unit))


@st.composite
def exports(draw: st.DrawFn):
    """A table of bands as some program writes it: its text, and the units of its columns."""
    separator, decimal = draw(
        st.sampled_from(
            [
                (",", "."),
                (";", "."),
                (";", ","),
                ("\t", "."),
                ("\t", ","),
                ("   ", "."),
                (" ", ","),
                (" | ", "."),
                (", ", "."),
            ]
        )
    )
    wavevector = draw(st.sampled_from(["segments", "share", "rad/m", "rad/mm"]))
    unit, scale = draw(st.sampled_from([("Hz", 1.0), ("kHz", 1e3), ("MHz", 1e6)]))
    long, heads, comment = draw(st.booleans()), draw(st.booleans()), draw(st.sampled_from(["%", "#", ""]))
    complex_, behind = draw(st.booleans()), draw(st.booleans()) and separator.strip() != ""
    end = draw(st.sampled_from(["\n", "\r\n"]))
    position = np.linspace(0, 3, draw(st.integers(4, 9)))
    distance = np.interp(position, range(4), CORNERS)
    axis = {
        "segments": position,
        "share": distance / CORNERS[-1],
        "rad/m": distance,
        "rad/mm": distance / 1e3,
    }
    order = draw(st.permutations(range(BANDS)))

    def number(value: float, imaginary: bool = False) -> str:
        text = f"{value:.9g}".replace(".", decimal)
        return (
            f"{text}+{'0.25'.replace('.', decimal)}i" if imaginary and complex_ and decimal == "." else text
        )

    rows = []
    for k, frequencies in zip(axis[wavevector], dispersion(position) / scale, strict=True):
        cells = [number(frequencies[n], imaginary=True) for n in order]
        rows += [[number(k), cell] for cell in cells] if long else [[number(k), *cells]]
    columns = ["frequency"] if long else [f"band {n + 1}" for n in order]
    glue = separator if separator.strip() or separator == "\t" else "  "
    head = glue.join(
        [f"k ({wavevector})", *(f"{name} ({unit})".replace(" ", "_", name.count(" ")) for name in columns)]
    )
    lines = ["Model: cell.mph", f"{comment} {head}".strip() if comment else head] if heads else []
    lines = [f"{comment or '%'} exported", *lines[1:]] if heads else []
    text = end.join([*lines, *(separator.join(row) + (separator if behind else "") for row in rows)]) + end
    return text, wavevector, unit, heads, position


@given(exports(), st.data())
def test_whatever_parts_the_columns_the_bands_come_out(tmp_path_factory, export, data):
    text, wavevector, unit, heads, position = export
    path = tmp_path_factory.mktemp("export") / "theirs.txt"
    path.write_text(text, encoding=data.draw(st.sampled_from(["utf-8", "utf-8-sig", "utf-16"])), newline="")
    options = (None, None) if heads else (wavevector, unit)
    side = laid(path, *options)
    assert side.position == pytest.approx(position, abs=1e-6)
    assert side.frequency == pytest.approx(dispersion(position), rel=1e-7)
    if not heads:
        refused(
            lambda: laid(path, None, unit),
            wavevector,
            code="missing",
            argument="--wavevector",
            kind=ChannelError,
        )
        refused(
            lambda: laid(path, wavevector, None),
            code="missing",
            argument="--frequency-unit",
            kind=ChannelError,
        )
    result = Comparison(of_dataset("ours", ours()), side)
    assert np.nanmax(np.abs(result.relative)) < 1e-6


@pytest.mark.parametrize(
    ("text", "code", "argument", "given"),
    [
        ("", "unreadable", "theirs.csv", "no line with a number"),
        ("hello\nworld\n", "malformed", "theirs.csv", "a single column"),
        ("1\n2\n3\n", "malformed", "theirs.csv", "a single column"),
        ("0,1\n1,2\nend of table\n", "unreadable", "theirs.csv", "line 3"),
        ("0;1;2\n1;2\n2;3;4\n", "malformed", "theirs.csv", "line 2"),
        ("k,f\n0,5,1,5\n1,0,2,5\n", "unreadable", "theirs.csv", "line 1 has 2 cells and line 2 has 4"),
        ("0,1\n0.5,inf\n1,3\n", "malformed", "theirs.csv", "line 2"),
        ("0,1\n0.5,one\n1,3\n2,3\n", "malformed", "theirs.csv, column 2", "line 2"),
        ("nan,1\n0.5,2\n1,3\n", "malformed", "theirs.csv", "line 1"),
        ("0,1,2\n1,2,3\n0,4,5\n1,2,4\n", "malformed", "theirs.csv", "starts again in line 3"),
        ("0,1\n4,2\n", "mismatch", "theirs.csv, wavevector", "0 to 4"),
    ],
)
def test_what_is_no_table_of_bands(tmp_path, text, code, argument, given):
    path = tmp_path / "theirs.csv"
    path.write_text(text)
    refused(
        lambda: laid(path, "segments", "Hz"),
        given,
        code=code,
        argument=argument,
        kind=ChannelError,
    )


@pytest.mark.parametrize(
    ("unit", "code", "argument", "given"),
    [
        ("mm", "malformed", "--frequency-unit", "mm"),
        ("kilohurz", "malformed", "--frequency-unit", "kilohurz"),
    ],
)
def test_a_unit_that_is_none(tmp_path, unit, code, argument, given):
    path = tmp_path / "theirs.csv"
    path.write_text("0,1\n1,2\n")
    refused(lambda: laid(path, "segments", unit), given, code=code, argument=argument)
    refused(
        lambda: laid(path, unit, "Hz"),
        code="missing",
        argument="--wavevector",
    )


@each("unit", [None, "kHz", "Hz", "us"])
@each(
    ("head", "why"),
    [
        ("Period (us)", "a period is not a frequency"), ("T [ms]", "a period is not a frequency"),
        ("x / s", "a period is not a frequency"), ("wavelength (mm)", "one of length"),
        ("max(w) (mm)", "one of length"), ("level [dB]", "of another quantity"),
        ("angle (deg)", "one of angle"),
        ("Period", ""), ("Wellenlänge", ""),
    ],
)  # fmt: skip
def test_what_is_measured_in_something_else_is_no_frequency(tmp_path, head, why, unit):
    """The next step had been --frequency-unit=kHz, by which periods were compared as frequencies."""
    path = tmp_path / "theirs.csv"
    path.write_text(f"k,{head}\n0,5\n1,2\n2,3\n3,5\n")
    error = refused(
        lambda: laid(path, "segments", unit), why, code="malformed", argument="theirs.csv", kind=ChannelError
    )
    assert "--frequency-unit" not in error.next_step
    assert not why or head.split()[0] in error.given


@pytest.mark.parametrize(("unit", "why"), [("us", "a period is not a frequency"), ("mm", "one of length")])
def test_a_frequency_unit_of_something_else(tmp_path, unit, why):
    path = tmp_path / "theirs.csv"
    path.write_text("k,f\n0,5\n1,2\n2,3\n3,5\n")
    error = refused(lambda: laid(path, "segments", unit), why, argument="--frequency-unit", kind=ChannelError)
    assert "--frequency-unit=kHz" in error.next_step


@pytest.mark.parametrize(
    "names",
    [
        ("longitudinal", "transverse"), ("Vibration 1", "Vibration 2"), ("symmetric", "antisymmetric"),
        ("z-polarised", "in-phase"), ("Schwingung", "acceleration mode"), ("onda longitudinal", "periodic"),
    ],
)  # fmt: skip
def test_bands_may_be_called_by_their_kind(tmp_path, names):
    """Columns in Hz had been left out for "ratio" in "vibration" and "symmetr" in "symmetric"."""
    path, position = tmp_path / "theirs.csv", np.linspace(0, 3, 5)
    rows = [f"{k},{f[0]},{f[1]}" for k, f in zip(position, dispersion(position), strict=True)]
    path.write_text("\n".join([f"k,{names[0]} (Hz),{names[1]} (Hz)", *rows]))
    side = laid(path, "segments", None)
    assert side.frequency == pytest.approx(dispersion(position)[:, :2])
    assert side.left == ()


@pytest.mark.parametrize("kind", ["backwards", "blocks", "one of each", "columns of one name", "other names"])
def test_large_tables_take_no_longer_than_their_size(tmp_path, kind):
    """Rows and columns were compared with all others: 10,000 columns took minutes, 20,000 rows 3 GB."""
    path, rows = tmp_path / "theirs.csv", 2000
    position = np.linspace(0, 3, rows)[:: -1 if kind == "backwards" else 1]
    head, lines = "k,f (Hz)", [f"{k},{1e3 * (k + 1)}" for k in position]
    if kind == "blocks":
        lines = [f"{line}\n" for line in lines]
    elif kind == "one of each":
        lines = [f"{k},5\n{k},6" for k in position]
    elif "name" in kind:
        names = [f"f{k}" if kind == "columns of one name" else f"{'nm'[k % 2]}{hex(k)}z" for k in range(rows)]
        head = ",".join(["k", *(f"{name} (Hz)" for name in names)])
        lines = [",".join([str(k), *(str(1e3 + 7 * j + k) for j in range(rows))]) for k in range(4)]
    path.write_text("\n".join([head, *lines]))
    tracemalloc.start()
    with within(2.4):  # tracemalloc takes most of it
        laid(path, "segments", None)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < (60e6 if "name" in kind else 24e6)


def test_two_columns_of_the_wavevector_make_a_way(tmp_path):
    """Γ-X-M-Γ of a square lattice, k_x and k_y in rad/m."""
    path = tmp_path / "theirs.csv"
    corners = np.array([[0, 0], [450, 0], [450, 450], [0, 0]])
    rows = [f"{x},{y},{f[0]},{f[1]}" for (x, y), f in zip(corners, dispersion(np.arange(4.0)), strict=True)]
    path.write_text("\n".join(["kx [rad/m],ky [rad/m],f1 [Hz],f2 [Hz]", *rows]))
    side = laid(path, None, None)
    assert side.position == pytest.approx([0, 1, 2], abs=1e-3)  # the end of the path is its start
    assert side.frequency[:, 1] == pytest.approx(dispersion(np.arange(3.0))[:, 1])


EPOXY = 'diameter = "5 mm"\nmaterial = "epoxy"\n'


@pytest.mark.parametrize(("parts", "expected"), [
    ("", 5e-4),
    ('[cell.pillar]\ndiameter = "5 mm"\nheight = "4 mm"\n', 5e-4),
    (f'[cell.pillar]\nheight = "4 mm"\n{EPOXY}', None),
    (f'[[cell.site]]\nat = [0, 0]\n[cell.site.pillar]\nheight = "4 mm"\n{EPOXY}', None),
    (f"[[cell.disc]]\n{EPOXY}", None),
    (f"[[cell.site]]\nat = [0, 0]\n[[cell.site.disc]]\n{EPOXY}", None),
    ('[[cell.disc]]\ndiameter = "5 mm"\nempty = true\n', 5e-4),
])  # fmt: skip
def test_modes_of_several_materials_have_no_common_loss_factor(parts, expected):
    cell = 'material = "aluminium-7075"\n[cell]\npitch = "10 mm"\nthickness = "2 mm"\n'
    assert loss_of(loads(cell + parts).inputs()) == expected


BESIDE = {
    "Damping ratio": ("1", 2.5e-4),
    "Quality factor": ("1", 2000.0),
    "Angular frequency": ("rad/s", 9e4),
    "max(w)": ("mm", 3e-3),
    "phase": ("deg", 12.0),
}


@given(
    st.permutations(["Eigenfrequency", *BESIDE]), st.sampled_from([("Hz", 1.0), ("kHz", 1e3)]), st.booleans()
)
def test_what_is_no_frequency_is_left_out(tmp_path_factory, order, unit, unit_given):
    """Angular frequencies and others, which an evaluation of eigenfrequencies brings along.

    One of the columns of damping is used.
    """
    path, position = tmp_path_factory.mktemp("export") / "theirs.csv", np.linspace(0, 3, 5)
    heads = [f"{column} ({BESIDE.get(column, unit)[0]})" for column in order]
    rows = [
        [position[k], *(BESIDE[column][1] if column in BESIDE else f / unit[1] for column in order)]
        for k, line in enumerate(dispersion(position))
        for f in line
    ]
    path.write_text("\n".join([f"% k,{','.join(heads)}", *(",".join(map(str, row)) for row in rows)]))
    side = laid(path, "segments", unit[0] if unit_given else None)
    assert side.frequency == pytest.approx(dispersion(position))
    assert side.loss_from in ("Damping ratio", "Quality factor")
    assert side.left == tuple(column for column in order if column in BESIDE and column != side.loss_from)
    remark = Comparison(of_dataset("ours", ours()), side).remarks()[0]
    assert "Angular frequency" in remark
    assert side.loss_from not in remark


@pytest.mark.parametrize("moved", [(300.0, -200.0), (-100.0, -400.0), (250.0, 120.0)])
def test_both_edges_of_a_gap_are_compared(moved):
    """The gap is that above band 2 of a lattice in particular: of the second all bands are moved rigidly."""
    first = replace(of_dataset("first", ours()), ours=False)
    shift = np.array([moved[0], moved[0], moved[1], moved[1]])
    text = Comparison(first, replace(first, frequency=first.frequency + shift)).summary()[1]
    words = [f"{abs(by) / 1e3:.3g} kHz {'higher' if by > 0 else 'lower'}" for by in moved]
    assert (
        text
        == f"The gap between bands 2-3, at the wavevectors of first, begins {words[0]} and ends {words[1]}."
    )


def test_a_gap_is_compared_only_where_a_table_has_its_bands():
    first = replace(of_dataset("first", ours()), ours=False)
    theirs = np.array(1.001 * first.frequency)
    theirs[np.nanargmax(theirs[:, 1]), 1] = theirs[np.nanargmin(theirs[:, 2]), 2] = np.nan
    text = Comparison(first, replace(first, name="other", frequency=theirs)).summary()[1]
    shifts = [1e-6 * float(end) for end in (np.nanmax(theirs[:, 1]), np.nanmin(theirs[:, 2]))]
    first_words, last_words = (f"{shift:.3g} kHz higher" for shift in shifts)
    assert text == (
        f"The gap between bands 2-3, at the wavevectors of other, begins {first_words} and ends {last_words}."
    )


@pytest.mark.parametrize(
    ("position", "where"),
    [(0.000001, "Γ"), (0.999999, "X"), (1.000002, "X"), (1.996, "M"), (1.99, "0.99 of X-M"), (3.0, "Γ")],
)
def test_a_position_beside_a_corner_has_its_name_if_two_digits_do_not_differ(position, where):
    first = of_dataset("first", ours())
    second = replace(first, position=np.array([position]), frequency=first.at(np.array([position])) + 50.0)
    bands = Comparison(first, second).tables()[1]
    assert [row[-1] for row in bands.rows] == [where] * BANDS


def test_a_missing_band_is_reported(tmp_path):
    path = tmp_path / "theirs.csv"
    rows = [
        f"{k},{','.join(map(str, f[[0, 2, 3]]))}"
        for k, f in zip(range(4), dispersion(np.arange(4.0)), strict=True)
    ]
    path.write_text("\n".join(rows))
    result = Comparison(of_dataset("ours", ours()), laid(path, "segments", "Hz"))
    assert any("band 2" in text and "missing" in text for text in result.remarks())


def test_numbers_keep_their_names_and_units(tmp_path):
    path = tmp_path / "table.txt"
    path.write_text("% a comment\n% k          freq (kHz)\n0   1.5+2.1E-4i\n1   NaN\n")
    table = read_table(path)
    assert [(column.name, column.unit) for column in table.columns] == [("k", ""), ("freq", "kHz")]
    assert table.columns[1].values[0] == 1.5 + 2.1e-4j
    assert np.isnan(table.columns[1].values[1])


def _long(head: str, row: Callable[..., str], blocks: bool = False) -> Callable[..., str]:
    """A table with a row for each frequency, by wavevectors or by bands with empty lines between."""

    def text(position: np.ndarray, vectors: np.ndarray, frequency: np.ndarray) -> str:
        rows = [
            [row(k, x, y, f) for f in line]
            for k, (x, y), line in zip(position, vectors, frequency, strict=True)
        ]
        groups = zip(*rows, strict=True) if blocks else rows
        return "\n".join([head, *(line for group in groups for line in [*group, *([""] if blocks else [])])])

    return text


THEIRS = {
    "damping beside it": _long(
        "% k,Eigenfrequency (Hz),Quality factor (1)", lambda k, x, y, f: f"{k},{f},Inf"
    ),
    "angular": _long("k;omega (rad/s)", lambda k, x, y, f: f"{k};{2 * np.pi * f:.9g}".replace(".", ",")),
    "complex, rigid modes imaginary": _long(
        "% k      freq (kHz)",
        lambda k, x, y, f: f"{k}   " + ("3.1E-06i" if f < 5 else f"{f / 1e3:.9E}+{f / 1e6:.3E}i"),
    ),
    "blocks": _long("# k freq (Hz)", lambda k, x, y, f: f"{k} {f}", blocks=True),
    "kx and ky of another corner, block by block": _long(
        "kx [rad/mm]\tky [rad/mm]\tf [MHz]",
        lambda k, x, y, f: f"{-y / 1e3}\t{x / 1e3}\t{f / 1e6}",
        blocks=True,
    ),
    "names of two words": _long(
        "% k                       Eigenfrequency (Hz)       Angular frequency (rad/s) Damping ratio (1)",
        lambda k, x, y, f: f"{k:<25} {f:<25} {2 * np.pi * f:<25} 0.001",
    ),
}


@pytest.mark.usefixtures("empty_pictures")
class TestCommand:
    @pytest.fixture(scope="class", autouse=True)
    @classmethod
    def written(cls, tmp_path_factory):
        folder = tmp_path_factory.mktemp("studies")
        (folder / "one.toml").write_text(QUICK_CELL)
        (folder / "two.toml").write_text(QUICK_CELL.replace("14.7 mm", "14 mm"))
        (folder / "other.toml").write_text(
            QUICK_CELL.replace("[cell]", '[cell]\nlattice = "triangular"').replace("count = 8", "count = 3")
        )
        cls.folder = folder

    def test_a_study_does_not_differ_from_itself(self, inside, tmp_path):
        study = self.folder / "one.toml"
        answer = inside("compare", study, study, "--json").json
        assert np.abs(answer["data"]["difference_hz"]).max() == 0
        assert answer["changed"] == []

    def test_two_studies(self, inside, tmp_path):
        out = tmp_path / "out"
        ran = inside("compare", self.folder / "one.toml", self.folder / "two.toml", "--out", out)
        assert ran.code == 0, ran.err
        assert {path.name for path in out.iterdir()} == {"compare.nc", "compare.svg", "compare.png"}
        assert "cell.pillar.height" in ran.out
        assert "cell.pillar.height, 14.7 mm and 14 mm" in " ".join(ran.out.split())
        assert "higher" in ran.out  # shorter pillars put the gap higher

    def test_crystals_of_different_symmetry_are_compared_at_the_same_wavevectors(self, inside, tmp_path):
        """A crystal turned by 20 degrees has no mirrors: its path has four sides. By 90, nothing changes."""
        constants = 'c11 = "166 GPa"\nc12 = "64 GPa"\nc44 = "80 GPa"\ndensity = "2330 kg/m^3"\nturn = "{}"\n'
        solid, plate = f"[material]\n{constants}", '[cell]\npitch = "7 mm"\nthickness = "1 mm"\n'
        plate += "[bands]\ncount = 4\npoints = 12\naccuracy = 0.01\n"
        studies = {}
        for turn in ("0 deg", "20 deg", "90 deg"):
            studies[turn] = tmp_path / f"{turn.replace(' ', '-')}.toml"
            studies[turn].write_text(solid.format(turn) + plate)
        straight, leaning, same = studies.values()
        answer = inside("compare", straight, leaning, "--json").json
        assert max(answer["data"]["position"]) == 4
        back = inside("compare", leaning, straight, "--json").json
        first, second = (np.array(each["data"]["difference_hz"]) for each in (answer, back))
        assert np.abs(first + second).max() < 0.02 * np.abs(first).max()  # each is at its own points
        assert np.abs(inside("compare", straight, same, "--json").json["data"]["difference_hz"]).max() < 1.0
        assert inside("bands", leaning, "--out", tmp_path / "leaning").code == 0
        refusal = inside("compare", straight, tmp_path / "leaning")
        assert_five_parts(refusal, "studies of both", code="mismatch", argument="SECOND")

    def test_a_result_is_its_study(self, inside, tmp_path):
        study, out = self.folder / "one.toml", tmp_path / "bands"
        assert inside("bands", study, "--out", out).code == 0
        for result in (out, out / "bands.nc"):
            answer = inside("compare", study, result, "--json").json
            assert np.abs(answer["data"]["difference_hz"]).max() < 1.0
            assert answer["changed"] == []

    def test_a_table_is_compared_at_its_own_wavevectors(self, inside, tmp_path):
        """With straight lines between the wavevectors of a diagram, a table differed from itself by 0.3 %."""
        study, out = self.folder / "one.toml", tmp_path / "bands"
        assert inside("bands", study, "--out", out).code == 0
        for written in (out / "bands.csv", self._of_higher_frequencies(out / "bands.csv")):
            answer = inside("compare", study, written, "--json").json
            data = answer["data"]
            frequency = np.array(data["frequency_hz"])
            moving = frequency > 1e3
            difference = np.array(data["difference_hz"])[moving] / frequency[moving]
            raised = 0.004 / 1.004 if "higher" in written.name else 0.0
            assert difference == pytest.approx(np.full(len(difference), raised), abs=2e-5)

    @staticmethod
    def _of_higher_frequencies(table: Path) -> Path:
        """A copy of a table of bands with frequencies that are 0.4 % higher."""
        head, *rows = table.read_text("utf-8").splitlines()
        names = head.split(",")
        raised = [
            ",".join(
                f"{1.004 * float(cell):.9g}" if name.startswith("f") else cell
                for name, cell in zip(names, row.split(","), strict=True)
            )
            for row in rows
        ]
        path = table.with_name("higher.csv")
        path.write_text("\n".join([head, *raised]) + "\n", "utf-8")
        return path

    @pytest.fixture(scope="class")
    @classmethod
    def result(cls, written, store_folder):
        """The content of a bands.nc."""
        bands = load(cls.folder / "one.toml").bands(store=Store(store_folder))
        write_files(cls.folder / "result", {"bands.nc": bands.files["bands.nc"]}, overwrite=False)
        return (cls.folder / "result" / "bands.nc").read_bytes()

    @pytest.mark.parametrize("part", [name for name in PARTS if name != "distance"])
    def test_a_part_of_another_size_is_not_read(self, tmp_path, monkeypatch, result, part):
        """A file of some kB took seconds, for 300 MB were unfolded before sizes were compared."""
        (tmp_path / "bands.nc").write_bytes(result)
        with h5py.File(tmp_path / "bands.nc", "r+") as file:
            del file[part]
            file.create_dataset(part, (3 * 10**7,), "u1", compression="gzip", fillvalue=7, chunks=(10**6,))
        asked = []
        monkeypatch.setattr("haptonic.channels.hdf5.ask", lambda *question, **_: asked.append(question))
        refused(lambda: of_file(tmp_path / "bands.nc"), kind=StudyError, code="unreadable")
        assert not asked

    @pytest.mark.parametrize("inputs", ["NaN", "7", "[1]", '"x"', '{"cell": 3}'])
    def test_inputs_that_are_no_table(self, tmp_path, result, inputs):
        (tmp_path / "bands.nc").write_bytes(result)
        with h5py.File(tmp_path / "bands.nc", "r+") as file:
            file.attrs["inputs"] = inputs
        refused(lambda: of_file(tmp_path / "bands.nc"), kind=StudyError, code="unreadable")

    @pytest.fixture(scope="class")
    @classmethod
    def bands(cls, written):
        """Corners and some wavevectors between them, as phases over pi, and their bands in Hz."""
        cell = load_as(cls.folder / "one.toml", Description).cell
        settings = load_as(cls.folder / "one.toml", Description).bands_settings
        path = cell.zone.path(13)
        model = bloch_model(cell, settings)
        position = np.interp(path.distance, path.distance[list(path.corners)], range(4))
        frequency = np.array([model.frequencies(kappa)[:5] for kappa in path.kappa])
        return position, path.kappa / cell.lattice.pitch, np.maximum(frequency, 0)

    @pytest.mark.parametrize("kind", THEIRS)
    def test_a_table_of_our_bands_lies_on_them(self, inside, tmp_path, bands, kind):
        table = tmp_path / "theirs.txt"
        table.write_text(THEIRS[kind](*bands))
        wavevector = [] if "kx" in table.read_text() else ["--wavevector", "segments"]
        ran = inside("compare", self.folder / "one.toml", table, *wavevector, "--json")
        assert ran.code == 0, ran.err
        relative = np.abs(ran.json["data"]["difference_hz"]) / bands[2].max()
        assert relative.shape[1] == 5
        assert np.nanmax(relative) < 2e-3  # straight between our wavevectors

    @pytest.mark.parametrize("row", [1, 2, 4])
    def test_a_wavevector_that_lacks_a_frequency_among_others_is_left_out(self, inside, tmp_path, bands, row):
        """The frequencies above it had been taken for those of the bands below, 5 % off, without a word."""
        position, _, frequency = bands
        lines = [f"{k},{f}" for k, row_of in zip(position, frequency, strict=True) for f in row_of]
        lines[5 * 3 + row] = f"{position[3]},NaN"
        table = tmp_path / "theirs.csv"
        table.write_text("\n".join(["k,f (Hz)", *lines]))
        asked = ["compare", self.folder / "one.toml", table, "--wavevector", "segments", "--json"]
        ran = inside(*asked)
        relative = np.abs(np.array(ran.json["data"]["difference_hz"], dtype=float)) / frequency.max()
        assert np.nanmax(relative) < 2e-3
        # the highest band alone may be missing
        wavevectors = len(position) - (row < 4)
        assert len(relative) == wavevectors
        remark = "its band is unknown" if row < 4 else "fewer than 5 frequencies"
        assert remark in ran.err

    def test_more_than_a_tenth_apart_is_an_error_unless_asked_for(self, inside, tmp_path, bands):
        table = tmp_path / "theirs.csv"
        position, _, frequency = bands
        for factor, cause in ((1.2, "1.2 times"), (2 * np.pi, "rad/s"), (1e-3, "kHz")):
            rows = [",".join(map(str, [k, *(factor * f)])) for k, f in zip(position, frequency, strict=True)]
            table.write_text("\n".join(["k,f1 (Hz),f2 (Hz),f3 (Hz),f4 (Hz),f5 (Hz)", *rows]))
            asked = ["compare", self.folder / "one.toml", table, "--wavevector", "segments"]
            assert_five_parts(inside(*asked), "--any-difference", cause, code="mismatch", argument="theirs")
        assert inside(*asked, "--any-difference", "--out", tmp_path / "out").code == 0

    def test_rigid_modes_alone_are_compared_and_a_lost_one_is_seen(self, inside, tmp_path):
        """At the centre of the zone alone every difference was a share of nothing, and so none."""
        table = tmp_path / "theirs.csv"
        asked = ["compare", self.folder / "one.toml", table, "--wavevector", "segments"]
        table.write_text("k,f (Hz)\n0,0\n0,0\n0,0\n")
        assert inside(*asked, "--out", tmp_path / "out").code == 0
        table.write_text("k,f (Hz)\n0,0\n0,0\n0,12000\n")
        assert_five_parts(inside(*asked), "band 3 at Γ", code="mismatch", argument="theirs")

    def test_what_cannot_be_compared(self, inside, tmp_path):
        study, table = self.folder / "one.toml", tmp_path / "theirs.csv"
        table.write_text("0,1\n3,2\n")
        assert_five_parts(
            inside("compare", table, study), f"compare {study} {table}", code="conflict", argument="FIRST"
        )
        assert_five_parts(
            inside("compare", study, self.folder / "other.toml"), "path", code="mismatch", argument="SECOND"
        )
        assert_five_parts(
            inside("compare", study, table), "--wavevector=segments", code="missing", argument="--wavevector"
        )
        assert_five_parts(
            inside("compare", study, table, "--wavevector", "segments"),
            code="missing",
            argument="--frequency-unit",
        )
        assert_five_parts(
            inside("compare", study, tmp_path), code="not-found", argument="bands of an earlier run"
        )
        (tmp_path / "bands.nc").write_bytes(b"\x89HDF\r\n\x1a\n" + bytes(200))
        assert_five_parts(
            inside("compare", study, tmp_path), code="unreadable", argument="bands of an earlier run"
        )
        assert_five_parts(inside("compare", study, tmp_path / "none.csv"))
        assert_five_parts(inside("compare", study, tmp_path / "none.toml"))

    def test_each_pair_has_its_folder(self, inside, tmp_path, monkeypatch):
        monkeypatch.chdir(tmp_path)
        for second in ("one", "two"):
            assert inside("compare", self.folder / "one.toml", self.folder / f"{second}.toml").code == 0
        again = inside("compare", self.folder / "one.toml", self.folder / "two.toml")
        assert_five_parts(again, "--overwrite", code="repeated", argument="output file")
        assert {path.name for path in (tmp_path / "results").iterdir()} == {
            "one-one-compare",
            "one-two-compare",
        }

    def test_an_incomplete_table_is_refused_before_bands_are_computed(self, inside, tmp_path):
        store = tmp_path / "store"
        table = tmp_path / "comsol.csv"
        table.write_text("% Model:,bands.mph\n% k,Eigenfrequency (Hz)\n0,10+0.1i\n3,20000+2i\n")
        assert_five_parts(
            inside("compare", self.folder / "one.toml", table, store=store),
            "--wavevector=segments",
            code="missing",
            argument="--wavevector",
        )
        table.write_text("k,f\n0,10\n3,20000\n")
        asked = ["compare", self.folder / "one.toml", table, "--wavevector", "segments"]
        assert_five_parts(inside(*asked, store=store), code="missing", argument="--frequency-unit")
        shares = inside(*asked[:3], "--wavevector", "share", store=store)
        assert_five_parts(shares, code="mismatch", argument="comsol.csv, wavevector")
        assert not store.exists()


def test_a_study_is_read_once(tmp_path, monkeypatch):
    """It is read before bands are computed, so that an error in either file is reported at once."""
    study, table = tmp_path / "a.toml", tmp_path / "b.csv"
    study.write_text(QUICK_CELL)
    table.write_text("share,f1 (kHz),f2 (kHz)\n0,1,2\n1,3,4\n")
    read = []
    monkeypatch.setattr(compare, "load_as", lambda path, kind: read.append(path) or load_as(path, kind))
    named("compare").run(
        None,
        Runner(Store(tmp_path / "store")),
        {"first": study, "second": table, "wavevector": "share", "any_difference": True},
    )
    assert read == [study]


def test_an_error_in_the_second_study_is_reported_before_the_first_is_computed(tmp_path):
    for name, text in (("a.toml", QUICK_CELL), ("b.toml", "[cell]\n")):
        (tmp_path / name).write_text(text)
    asked = {"first": tmp_path / "a.toml", "second": tmp_path / "b.toml"}
    refused(
        lambda: named("compare").run(None, Runner(Store(tmp_path / "store")), asked), argument="cell.pitch"
    )
    assert not (tmp_path / "store").exists()
