"""Text tables: names, units, numbers and rows, as programs write them."""

from __future__ import annotations

import contextlib
import random

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from daily import daily
from each import each
from five_parts import refused
from haptonic.channels import opened
from haptonic.channels.cells import number_of
from haptonic.channels.headings import Heading
from haptonic.channels.labels import factor_of
from haptonic.channels.text_table import read_table
from haptonic.errors import ChannelError
from haptonic.units import to_si
from pace import within


@pytest.mark.parametrize(
    ("heading", "name", "unit"),
    [
        ("Fz (mN)", "Fz", "mN"),
        ("real ((m/s)/V)", "real", "(m/s)/V"),
        ("max(w) (mm)", "max(w)", "mm"),
        ("f / Hz", "f", "Hz"),
        ("F_z/N", "F_z", "N"),
        ("Zeit in s", "Zeit", "s"),
        ("Frequency, kHz", "Frequency", "kHz"),
        ("FREQ [KHZ]", "FREQ", "kHz"),
        ("freq (Hz) @ k=0.1", "freq @ k=0.1", "Hz"),
        ("f_MHz", "f", "MHz"),
        ("F(z)", "F(z)", ""),
        ("G, 0", "G, 0", ""),
        ("phase_deg", "phase_deg", ""),
        ("m/s", "m/s", ""),
    ],
)
def test_a_heading_is_a_name_and_perhaps_a_unit(heading, name, unit):
    parsed = Heading.of(heading)
    assert (parsed.name, parsed.unit) == (name, unit)


@each(
    ("text", "number"),
    [
        ("1.5", 1.5),
        ("-2.5D+03", -2500.0),
        (" 1.5e-3 ", 1.5e-3),
        ("Inf", np.inf),
        ("-1.#INF", -np.inf),
        ("1.5-101", 1.5e-101),
        ("3.12E-03i", 3.12e-3j),
        ("-2j", -2j),
        ("1+2i", 1 + 2j),
        ("1.5 - 2.5j", 1.5 - 2.5j),
        ("(1,2)", 1 + 2j),
        ("(1.5D0, -2D0)", 1.5 - 2j),
        ("(1+2j)", 1 + 2j),
        ("1+j2", 1 + 2j),
        ("110584.061+111i", 110584.061 + 111j),
        ("1_000", None),
        ("12 Hz", None),
        ("1,5", None),
        ("2024-01-05", None),
        ("i", None),
        ("0x1F", None),
        ("1 2", None),
    ],
)
def test_numbers_as_programs_write_them(text, number):
    assert number_of(text) == number
    if number is not None and not np.isinf(number) and "," not in text:
        assert number_of(text.replace(".", ","), ",") == number


@pytest.mark.parametrize("text", ["", "NaN", "-", "n/a", "1.#QNAN"])
def test_a_missing_number_is_nan(text):
    assert np.isnan(number_of(text))


TABLES = {
    "units in a second line": (
        "Source File Name:\tplate.svd\nSignal:\tH1, real\n\nf\tReal\n[ Hz ]\t[ (m/s)/V ]\n1\t2\n",
        4,
        ["f", "Real"],
        ["Hz", "(m/s)/V"],
    ),
    "titles with separators": (
        '"Start: 1"\n"Force: N","Counts: 10"\n"Fx","Fy","Time"\n"1","2","10:31"\n"2","3","10:32"\n',
        3,
        ["Fx", "Fy", "Time"],
        ["", "", ""],
    ),
    "a comment": ("# k, f1, f2\n0 1 2\n1 2 3\n", 1, ["k", "f1", "f2"], ["", "", ""]),
    "names of two words": (
        "% k      Angular frequency (rad/s) Damping ratio (1)\n0        1                         2\n",
        1,
        ["k", "Angular frequency", "Damping ratio"],
        ["", "rad/s", "1"],
    ),
    "no names": ("0;0,5\n1;1,5\n", None, ["1", "2"], ["", ""]),
    "a rule below": ("time  force\n----  -----\n0  1\n1  2\n", 1, ["time", "force"], ["", ""]),
    "bands by number": ("k 1 2 3\n0 1 2 3\n1 2 3 4\n", 1, ["k", "1", "2", "3"], [""] * 4),
}


@pytest.mark.parametrize("kind", TABLES)
def test_the_line_of_names_is_the_last_above_the_numbers_with_as_many_cells(tmp_path, kind):
    text, line, names, units = TABLES[kind]
    (tmp_path / "a.csv").write_text(text)
    table = read_table(tmp_path / "a.csv")
    assert (table.names_line, list(table.names), [column.unit for column in table.columns]) == (
        line,
        names,
        units,
    )


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("k,f\n0,1\n1,oops,3\n", "line 3"),
        ("k f\n0 1\nfailed\n2 3\n", "line 3"),
        ("k;f\n0,250;1,500\n9;9\n", ""),
        ("0 1.5\n0 x 2\n1 2.5\n", "line 2"),
        ("0 1.5x\n0 2.5\n1 2.5\n1 3\n", "line 1"),
        ("13 6 1\n0 1\n1 2\n2 3\n", "line 1"),
        ("a;b\n1,234;2,345\n2,345;3,456\n", "1,234"),
        ("0,05,1,07\n1,25,2,08\n", "05"),
        ("k,f\n1,2,3\n2,3,4\n", "line 1"),
    ],
)
def test_a_row_that_is_no_number_is_never_passed_over(tmp_path, text, words):
    (tmp_path / "a.csv").write_text(text)
    if words:
        refused(lambda: read_table(tmp_path / "a.csv"), words, argument="a.csv", kind=ChannelError)
    else:
        read_table(tmp_path / "a.csv")


def test_a_word_in_a_column_is_a_fault_of_its_numbers_only(tmp_path):
    (tmp_path / "a.csv").write_text("time,Fz,note\n0,1,\n1,lost,x\n2,3,\n3,4,\n")
    group = opened(tmp_path / "a.csv").group("")
    assert group["time"].tolist() == [0, 1, 2, 3]
    refused(lambda: group["Fz"], "line 3", "lost", argument="a.csv, column Fz", kind=ChannelError)


def test_a_table_of_words_has_its_names_in_the_first_full_line(tmp_path):
    path = tmp_path / "answers.csv"
    path.write_text("Answers of the first day\nparticipant,answer\nP1,yes\nP2,no\n")
    table = read_table(path)
    assert [(column.name, list(column.values)) for column in table.columns] == [
        ("participant", ["P1", "P2"]),
        ("answer", ["yes", "no"]),
    ]
    assert (table.titles, table.names_line) == (("Answers of the first day",), 2)


def test_comments_among_rows_and_short_rows_are_named(tmp_path):
    (tmp_path / "a.csv").write_text("k;f;g\n0;1;2\n# band 2\n\n0;1\n1;2;3\n")
    table = read_table(tmp_path / "a.csv")
    assert "line 3: '# band 2'" in table.remarks[0]
    assert table.short == (5,)
    assert table.lines.tolist() == [2, 5, 6]
    assert table.blocks.tolist() == [0, 1, 1]


@pytest.mark.parametrize(
    "text",
    [
        "1" * 10**5,
        "a(" * 50_000,
        "( " * 50_000,
        " " * 10**5 + "a",
        "1 + " * 40_000,
        "[  " * 30_000,
        '"' * 10**6,
    ],
)
def test_a_long_line_takes_no_longer_than_its_length(tmp_path, text):
    """Patterns that try every part of a line took minutes for such lines."""
    (tmp_path / "a.csv").write_text(f"{text}\n1 2\n3 4\n")
    with within(5.0), contextlib.suppress(ChannelError):
        read_table(tmp_path / "a.csv")


@pytest.mark.parametrize(
    ("text", "hertz"),
    [("rad/s", 1 / (2 * np.pi)), ("krad/s", 500 / np.pi), ("rpm", 1 / 60), ("deg/s", 1 / 360)],
)
def test_an_angle_per_time_is_a_frequency(text, hertz):
    assert factor_of(text, "Hz") == pytest.approx(hertz, rel=1e-14)
    assert to_si(f"{60e3 / hertz!r} {text}", "Hz", "carrier") == pytest.approx(60e3, rel=1e-14)


def test_more_names_than_columns_are_not_matched(tmp_path):
    (tmp_path / "a.txt").write_text("% a  b  c  d\n0 1\n1 2\n")
    table = read_table(tmp_path / "a.txt")
    assert (table.unmatched, table.names_line) == (1, None)
    assert "line 1 does not have 2 names" in table.remarks[0]


NAMES = (
    "Eigenfrequency", "Quality factor", "f1", "Eigenfrequenz in rad/s @ 3", "freq (Hz) @ 1", "Mode", "p_ax",
    "Damping ratio (1)", "Taux d'amortissement", "f / Hz", "real part", "Facteur de qualité", "Force x (N)",
    "k (rad/m)", "Vector de onda", "kx in 1/m", "a b c",
)  # fmt: skip


@pytest.mark.parametrize("seed", range(8))
def test_names_above_columns_in_blanks_are_theirs_or_none(tmp_path, seed):
    """Names longer than their columns shift those behind them: words of neighbours had been joined."""
    chance, path, known = random.Random(seed), tmp_path / "a.txt", 0
    for _ in range(100):
        names, width = chance.sample(NAMES, chance.randint(2, 6)), chance.randint(6, 28)
        aligned = chance.choice([str.ljust, str.rjust])
        form = chance.choice(["{:.9g}", "{:.4f}", "{:.3e}", "{:g}"])
        rows = [[form.format(chance.uniform(1, 1e5)) for _ in names] for _ in range(chance.choice([1, 3, 8]))]
        head, *lines = (
            "".join(aligned(c, max(width, len(c) + 1)) for c in cells) for cells in [names, *rows]
        )
        path.write_text("\n".join([chance.choice(["", "% ", "# "]) + head, *lines]))
        try:
            table = read_table(path)
        except ChannelError:
            continue
        if table.names_line is not None:
            assert [column.heading.text for column in table.columns] == names, path.read_text()
            known += 1
    assert known > 30


MANY_COLUMNS = {"commas": "1," * 10**6, "quoted": f'1,"{"2," * 10**5}"', "blanks": "1 " * 10**6}


@pytest.mark.parametrize("name", daily(MANY_COLUMNS, "quoted"))
def test_a_table_of_too_many_columns_is_refused(tmp_path, name):
    """Two megabytes of them took minutes, and a long cell in quotation marks ended in a traceback."""
    (tmp_path / "a.csv").write_text(f"{MANY_COLUMNS[name]}\n" * 2)
    with within(3.0):
        error = refused(lambda: read_table(tmp_path / "a.csv"), kind=ChannelError, code="unreadable")
    assert len(str(error)) < 1000


def test_columns_of_one_name_are_counted(tmp_path):
    (tmp_path / "a.csv").write_text(",".join(["f"] * 3000 + ["f.7"]) + "\n" + ",".join("1" * 3001) + "\n")
    names = list(read_table(tmp_path / "a.csv").columns_by_name)
    assert names[:2] == ["f", "f.1"]
    assert names[-2:] == ["f.2999", "f.7.1"]


@settings(max_examples=30)
@given(
    st.sampled_from(["\t", ";"]),
    st.sampled_from(["1,01e+06", "-2,5E-3", "0,5", "12,3456"]),
    st.integers(30, 400),
    st.data(),
)
def test_a_rare_decimal_comma_among_whole_numbers_is_one(tmp_path_factory, separator, rare, rows, data):
    at = data.draw(st.integers(0, rows - 1))
    path = tmp_path_factory.mktemp("rare") / "a.csv"
    cells = [["1000000", "-20"] for _ in range(rows)]
    cells[at][0] = rare
    path.write_text("\n".join(["time" + separator + "force", *map(separator.join, cells)]) + "\n")
    column = opened(path).group("")["time"]
    assert len(column) == rows
    assert column[at] == float(rare.replace(",", "."))
    assert np.delete(column, at) == pytest.approx(1e6)


@each(
    ("text", "number"),
    [
        ("9.838,85", 9838.85),
        ("-1.234.567,8", -1234567.8),
        ("1.234,5+2.345,6i", 1234.5 + 2345.6j),
        ("9.838", None),
        ("0.838,5", None),
        ("12.34,5", None),
        ("1.2345,6", None),
        ("1.234,567,8", None),
    ],
)
def test_points_between_three_digits_before_a_decimal_comma_separate_thousands(text, number):
    assert number_of(text, ",") == number


@pytest.mark.parametrize("separator", ["\t", ";", "|"])
def test_thousands_points_beside_decimal_commas_are_read_and_those_alone_refused(tmp_path, separator):
    lines = ["k;f", "0,000;0,04", "0,000;9.838,85", "0,010;12.839,00"]
    path = tmp_path / "a.csv"
    path.write_text("\n".join(lines).replace(";", separator))
    assert opened(path).group("")["f"][:].tolist() == [0.04, 9838.85, 12839.0]
    path.write_text("\n".join([*lines, "0,010;41.771"]).replace(";", separator))
    refused(
        lambda: opened(path).group("")["f"][:],
        "line 5: '41.771'",
        "write 41,771 or 41771 in line 5",
        code="malformed",
        kind=ChannelError,
    )


def test_a_rare_comma_that_may_be_of_thousands_is_refused(tmp_path):
    rows = ["1000000;-20"] * 400
    rows[201] = "1,000;-20"
    (tmp_path / "a.csv").write_text("\n".join(["time;force", *rows]) + "\n")
    refused(lambda: opened(tmp_path / "a.csv"), '"1,000" may be', code="unreadable", kind=ChannelError)


@pytest.mark.parametrize("name", ["time;force", "time;force,y"])
def test_a_clear_comma_far_from_the_first_rows_gives_the_meaning_of_all(tmp_path, name):
    rows = ["204,045;-203,943"] * 400
    (tmp_path / "a.csv").write_text("\n".join([name, *rows]) + "\n")
    refused(lambda: opened(tmp_path / "a.csv"), '"204,045" may be', code="unreadable", kind=ChannelError)
    rows[201] = "202,72;-203,943"
    (tmp_path / "a.csv").write_text("\n".join([name, *rows]) + "\n")
    assert opened(tmp_path / "a.csv").group("")["time"][[0, 201]].tolist() == [204.045, 202.72]
