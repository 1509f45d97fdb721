"""A change of one key in a text changes nothing else."""

import tomllib

import pytest

from haptonic.errors import StudyError
from haptonic.studio.checking import checked
from haptonic.studio.editing import changed, lines_of
from haptonic.study import templates

TEXT = """\
# heading
title = "A" # of the report
[cell]  # one period
pitch = "7 mm"   # between pillars

[cell.pillar]
height = '1 mm'
[[sweep]]
vary = "cell.pitch" # first
from = "6 mm"
[[sweep]]
vary = "cell.pillar.height"
"""


@pytest.mark.parametrize(
    ("steps", "value", "line"),
    [
        (["title"], "B", 'title = "B" # of the report'),
        (["cell", "pitch"], "8 mm", 'pitch = "8 mm"   # between pillars'),
        (["cell", "pillar", "height"], "2 mm", 'height = "2 mm"'),
        (["sweep", 0, "from"], "5 mm", 'from = "5 mm"'),
        (["cell", "thickness"], "1 mm", 'thickness = "1 mm"'),
        (["carrier"], "60 kHz", 'carrier = "60 kHz"'),
        (["bands", "count"], 12, "count = 12"),
        (["cell", "a1"], ["6 mm", "0 mm"], 'a1 = ["6 mm", "0 mm"]'),
        (["sweep", 2], {"vary": "x"}, 'vary = "x"'),
        (["plate", "tiles", "a b"], "free", '"a b" = "free"'),
    ],
)
def test_a_change_is_one_line(steps, value, line):
    result = changed(TEXT, steps, value)
    assert line in result.splitlines()
    at = tomllib.loads(result)
    for step in steps:
        at = at[step]
    assert at == value
    gone = set(TEXT.splitlines()) - set(result.splitlines())
    assert len(gone) <= 1
    assert [line for line in gone if line.startswith("#")] == []


@pytest.mark.parametrize(
    ("steps", "gone"),
    [
        (["title"], "title"),
        (["cell", "pillar"], "1 mm"),
        (["sweep", 0], "cell.pitch"),
        (["cell", "pitch"], "7 mm"),
    ],
)
def test_a_key_or_a_table_is_removed(steps, gone):
    result = changed(TEXT, steps, None)
    assert gone not in result
    assert "# heading" in result


def test_the_last_table_of_a_list_leaves_no_empty_list():
    alone = changed(TEXT, ["sweep", 1], None)
    assert "sweep" not in tomllib.loads(changed(alone, ["sweep", 0], None))


@pytest.mark.parametrize("name", templates())
def test_every_value_of_every_template_can_be_changed(name):
    text = str(templates()[name])

    def leaves(tables, steps):
        for key, value in tables.items() if isinstance(tables, dict) else enumerate(tables):
            if isinstance(value, dict) or (isinstance(value, list) and isinstance(value[0], dict)):
                yield from leaves(value, [*steps, key])
            else:
                yield [*steps, key], value

    for steps, value in leaves(tomllib.loads(text), []):
        other = changed(text, steps, "another")
        assert other.count("another") == text.count("another") + 1, steps
        assert tomllib.loads(changed(other, steps, value)) == tomllib.loads(text), steps


@pytest.mark.parametrize(
    "steps", [["cell", 3], ["sweep", 9, "from"], ["cell", "pitch", "x"], ["missing"], [0]]
)
def test_an_impossible_change_is_refused(steps):
    with pytest.raises(StudyError, match="change the text itself"):
        changed(TEXT, steps, None if steps == ["missing"] else "x")


def test_a_text_that_is_not_toml_is_changed_by_hand():
    with pytest.raises(StudyError, match="change the text itself"):
        changed("a = [", ["a"], "x")


def test_lines_of_keys():
    lines = lines_of(TEXT)
    assert lines == {
        "title": 2, "cell": 3, "cell.pitch": 4, "cell.pillar": 6, "cell.pillar.height": 7, "sweep[1]": 8,
        "sweep[1].vary": 9, "sweep[1].from": 10, "sweep[2]": 11, "sweep[2].vary": 12,
    }  # fmt: skip
    text = '[plate]\nmap = """\no = x\n[o]\n"""\nrows = 1\n'
    text += '[[plate.force]]\nname = "a"\n[[plate.force]]\nname = "b"\n'
    assert lines_of(text)["plate.rows"] == 6
    assert lines_of(text)["plate.force[2].name"] == 10
    assert "plate.o" not in lines_of(text)
    nested = "[[site]]\n[[site.disc]]\nd = 1\n[[site.disc]]\nd = 2\n[[site]]\n[[site.disc]]\nd = 3\n"
    assert lines_of(nested)["site[1].disc[2].d"] == 5
    assert lines_of(nested)["site[2].disc[1].d"] == 8


def test_each_problem_has_its_key_and_line(tmp_path):
    text = TEXT.replace("7 mm", "7").replace("'1 mm'", "'-1 mm'")
    problems = {problem["path"]: problem for problem in checked(text, tmp_path)["problems"]}
    assert problems["cell.pitch"]["line"] == 4
    assert problems["cell.pitch"]["cause"] == "the unit is missing"
    assert problems["cell.pillar.height"]["line"] == 7
    assert problems["cell.thickness"]["line"] == 3  # missing: the line of its table
    assert problems["material"]["line"] is None
    assert problems["sweep[1].to"]["line"] == 8


def test_a_mistake_in_the_syntax_has_its_line(tmp_path):
    state = checked('title = "a"\npitch = 7 mm\n', tmp_path)
    assert state["values"] is None
    assert [problem["line"] for problem in state["problems"]] == [2]


def test_remarks_have_their_line(tmp_path):
    text = str(templates()["bare-cell"]).replace('"6 mm"', '"600 mm"')
    (remark,) = [each for each in checked(text, tmp_path)["remarks"] if each["path"] == "cell.pitch"]
    assert text.splitlines()[remark["line"] - 1].startswith("pitch")
