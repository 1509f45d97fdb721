"""What every command answers, recorded, and two such records compared: for changes that keep all answers.

    python same_answers.py record before.json      # at one commit
    python same_answers.py record after.json       # at another
    python same_answers.py compare before.json after.json

A record holds the JSON of every command on the studies of the repository and on ten more, which have what
those lack: other materials, sections, lattices, edges and drives. A refusal is recorded as an answer. A run
cut short goes on where it stopped. Two records agree if every number agrees to `TOLERANCE` of the largest
one in its array and all else is equal; every difference is listed. Errors of rest modes and of solvers, and
the order of rest modes, follow from rounding and differ between any two commits.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import re
import subprocess
import sys
import tempfile
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any

STUDIES = Path(__file__).parents[1] / "studies"
TOLERANCE = 1e-7  # relative: sums in another order move frequencies by some 1e-10, errors by some 1e-8
# other in every run or at every commit
OF_A_RUN = {"version", "created", "seconds", "files", "free_memory_gb", "code_fingerprint"}

CELL = """
title = "{title}"
carrier = "{carrier}"
material = "{material}"

[cell]
pitch = "{pitch}"
thickness = "{thickness}"
{lattice}

{pillar}

[bands]
count = {count}
accuracy = 5e-3
"""
PILLAR = '[cell.pillar]\ndiameter = "{}"\nheight = "{}"\n'
QUESTIONS = """
[layers]
count = 2
points = 5

[[sweep]]
vary = "cell.thickness"
from = "{}"
to = "{}"
steps = 2
"""
PLATE = """
[plate]
map = \"\"\"
oooo
o11o
oooo
\"\"\"
loss_factor = 5e-3

[plate.tiles]
o = "lattice"
1 = "guide"

[plate.response]
lowest = "2 kHz"
highest = "20 kHz"
points = 19
"""
ACTUATOR = """
[[plate.actuator]]
name = "A1"
region = "guide"
centre = ["6 mm", "3 mm"]
size = ["4 mm", "3 mm", "0.5 mm"]
material = "pzt-4"
voltage = "10 V"
"""
FORCE = """
[[plate.force]]
name = "F1"
region = "guide"
centre = ["6 mm", "3 mm"]
force = "1 N"
"""


def _cell(title: str, material: str, pillar: str, **others: Any) -> str:
    plain = {"carrier": "60 kHz", "pitch": "6 mm", "thickness": "1.2 mm", "lattice": "", "count": 6}
    return CELL.format(title=title, material=material, pillar=pillar, **{**plain, **others})


def drawn() -> dict[str, str]:
    """Texts of ten studies, by name."""
    swept = QUESTIONS.format("1.1 mm", "1.3 mm")
    square = PILLAR.format("3 mm", "6 mm") + 'section = "square"\n'
    round_pillar = PILLAR.format("3 mm", "8 mm")
    return {
        "plain": _cell("Plain plate", "soda-lime-glass", ""),
        "brass": _cell("Brass", "brass", round_pillar) + swept,
        "square": _cell("Square pillar", "steel", square) + swept,
        "rectangular": _cell(
            "Rectangular",
            "aluminium-2017a",
            round_pillar,
            lattice='lattice = "rectangular"\npitch_y = "5 mm"',
        ),
        "fillet": _cell("Fillet", "aluminium-2017a", round_pillar + 'fillet = "0.4 mm"\n') + swept,
        "draft": _cell("Draft", "aluminium-2017a", round_pillar + 'draft = "2 deg"\nfillet = "0.4 mm"\n'),
        "many bands": _cell("Many bands", "aluminium-2017a", round_pillar, count=20),
        "forced": _cell("Driven by a force", "aluminium-2017a", round_pillar, carrier="10 kHz")
        + PLATE
        + FORCE,
        "patch": _cell("Driven by a patch", "steel", round_pillar, carrier="10 kHz") + PLATE + ACTUATOR,
        "clamped": _cell("Clamped", "soda-lime-glass", round_pillar, carrier="10 kHz")
        + PLATE
        + '[plate.edges]\nleft = "clamped"\nright = "simple"\n'
        + ACTUATOR
        + '\n[plate.finger]\nregion = "guide"\ncentre = ["6 mm", "3 mm"]\ndamping = "10 N s/m"\n',
    }


OF_A_STUDY = (
    ("bands", "--surface"), ("sweep",), ("layers",), ("waveguide",), ("design",), ("tolerance",), ("plate",),
    ("feel",), ("chirp",), ("protocol",), ("export", "--dxf", "--stl"), ("simulate", "friction"),
)  # fmt: skip


def questions(folder: Path) -> Iterator[tuple[str, list[str]]]:
    """(name, arguments) of every question; later ones may read what earlier ones wrote into ``folder``."""
    texts = {path.stem: path.read_text("utf-8") for path in sorted(STUDIES.glob("*.toml"))} | drawn()
    for name, text in texts.items():
        path = folder / f"{name}.toml"
        path.write_text(text, encoding="utf-8")
        for command, *options in OF_A_STUDY:
            words = (
                [command, options[0], str(path)] if command == "simulate" else [command, str(path), *options]
            )
            out = folder / f"{name}-{'-'.join([command, *options[:1]])}"
            yield f"{name}: {command} {' '.join(options)}".strip(), [*words, "--out", str(out)]
    touchpad, scan, response = folder / "touchpad.toml", folder / "scan", folder / "judged" / "response.nc"
    trials = folder / "touchpad-simulate-friction"
    for name, words in {
        "friction": ["friction", str(trials), "--out", str(folder / "felt")],
        "simulate scan": ["simulate", "scan", str(touchpad), "--out", str(scan)],
        "scan": ["scan", str(scan / "scan.h5"), "--out", str(folder / "maps")],
        "scan against": [
            "scan", str(scan / "scan.h5"), "--against", str(touchpad), "--out", str(folder / "judged")
        ],
        "verdict": ["verdict", str(response), str(touchpad), "--out", str(folder / "verdict")],
        "doctor": ["doctor"],
        "keys": ["keys"],
    }.items():  # fmt: skip
        yield name, words


def asked(words: list[str], store: Path) -> dict[str, Any]:
    """The JSON that a command answers; of a refusal its exit code and the argument that it names."""
    environment = {**os.environ, "HAPTONIC_STORE": str(store), "COLUMNS": "200", "NO_COLOR": "1"}
    done = subprocess.run(
        [sys.executable, "-m", "haptonic", *words, "--json"],
        capture_output=True, text=True, env=environment, check=False,
    )  # fmt: skip
    try:
        answer = json.loads(done.stdout)
    except ValueError:
        answer = {"printed": done.stdout, "said": done.stderr}
    return {"code": done.returncode, "answer": answer}


def record(path: Path) -> None:
    """Ask everything that the record does not hold yet; it is written whole after every answer."""
    answers = json.loads(path.read_text("utf-8")) if path.exists() else {}
    folder = Path(answers.setdefault("folder", tempfile.mkdtemp(prefix="answers-")))
    folder.mkdir(exist_ok=True)
    for name, words in questions(folder):
        if name in answers:
            continue
        answers[name] = asked(words, folder / "store")
        print(f"{name}: {answers[name]['code']}", flush=True)
        partial = path.with_suffix(".partial")
        partial.write_text(json.dumps(answers, indent=1), encoding="utf-8")
        partial.replace(path)


def leaves(tree: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    """(path, value) of everything in a JSON value that is no list or object and not other in every run."""
    if isinstance(tree, dict):
        for key, value in tree.items():
            if key not in OF_A_RUN:
                yield from leaves(value, f"{path}.{key}")
    elif isinstance(tree, list):
        for index, value in enumerate(tree):
            yield from leaves(value, f"{path}[{index}]")
    else:
        yield path, tree


def array_of(path: str) -> str:
    """Path without the places in lists."""
    return re.sub(r"\[[0-9]+\]", "", path)


def alike(value: Any, other: Any, largest: float) -> bool:
    """True for leaves that are equal to rounding; ``largest`` is the size of the largest in their array."""
    if isinstance(value, float) and isinstance(other, int | float):
        return math.isclose(value, other, rel_tol=TOLERANCE, abs_tol=max(TOLERANCE * largest, 1e-12))
    return bool(value == other)


def differences(before: dict[str, Any], after: dict[str, Any]) -> Iterator[str]:
    """What two records do not share, a line each."""
    for name in before.keys() | after.keys():
        if name == "folder":
            continue
        if name not in before or name not in after:
            yield f"{name}: only {'after' if name in after else 'before'}"
            continue
        folders = (before["folder"], after["folder"])
        first, second = (
            dict(leaves(json.loads(json.dumps(each[name]).replace(folder, "FOLDER"))))
            for each, folder in zip((before, after), folders, strict=True)
        )
        largest: dict[str, float] = defaultdict(float)
        for path, value in first.items():
            if isinstance(value, float):
                largest[array_of(path)] = max(largest[array_of(path)], abs(value))
        for path in sorted(first.keys() | second.keys()):
            both = path in first and path in second
            if not both or not alike(first[path], second[path], largest[array_of(path)]):
                yield f"{name}: {path}: {first.get(path, 'nothing')} -> {second.get(path, 'nothing')}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("what", choices=("record", "compare"))
    parser.add_argument("records", nargs="+", type=Path)
    given = parser.parse_args()
    if given.what == "record":
        record(given.records[0])
        return
    before, after = (json.loads(path.read_text("utf-8")) for path in given.records)
    changes = sorted(differences(before, after))
    print(*changes, f"{len(changes)} differences in {len(before) - 1} answers", sep="\n")
    raise SystemExit(bool(changes))


if __name__ == "__main__":
    main()
