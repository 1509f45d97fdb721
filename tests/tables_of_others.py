"""Tables of bands as other programs write them, by kind, with the truth that they hold.

A kind is drawn for each part: layout, wavevectors, names, units, titles, separators, numbers, further
columns, encodings, damages. `Drawn.judged` decides whether an answer is right, wrong, or a refusal.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from haptonic.analyses.comparing import OfTable, of_dataset, of_table
from haptonic.analyses.table_path import OurPath
from haptonic.bloch.gap_datasets import dataset_of_gaps
from haptonic.errors import HaptonicError
from haptonic.results.comparison import Comparison

Choose = Callable[[Sequence[Any]], Any]

PITCH = 7e-3
BANDS = 5
LABELS = ("Γ", "X", "M", "Γ")
CORNERS = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0]])  # pi / pitch
LENGTHS = np.concatenate([[0.0], np.cumsum([1.0, 1.0, 2**0.5])]) * np.pi / PITCH
OPERATIONS = [np.diag(signs) for signs in ((1, 1), (1, -1), (-1, 1), (-1, -1))]
OPERATIONS += [operation[:, ::-1] for operation in OPERATIONS]


def bands_at(vectors: np.ndarray) -> np.ndarray:
    """(wavevector, band) Hz at wavevectors in pi over the pitch, of a lattice in particular."""
    x, y = np.cos(np.pi * vectors).T
    rigid = [np.sqrt(np.maximum(2 - x - y, 0)) * speed for speed in (2.1e3, 3.7e3)]
    return np.sort(
        np.stack([*rigid, 9e3 - 5e2 * x * y, 14e3 + 1e3 * (x + y), 19e3 - 7e2 * (x + y)], axis=1), axis=1
    )


def at_position(position: np.ndarray) -> np.ndarray:
    """(position, 2) wavevectors on the path, pi over the pitch."""
    return np.stack([np.interp(position, range(4), CORNERS[:, k]) for k in (0, 1)], axis=1)


def our_bands() -> xr.Dataset:
    """The bands as `haptonic bands` has them."""
    position = np.union1d(np.linspace(0, 3, 61), [1, 2])
    attrs = {
        "path_corners": json.dumps([int(np.flatnonzero(position == k)[0]) for k in range(4)]),
        "path_labels": json.dumps(LABELS),
        "inputs": json.dumps({"cell": {"pitch": PITCH}}),
        "lattice": json.dumps({"form": "square", "period": PITCH}),
        "zone": json.dumps([("Γ", (0.0, 0.0)), ("X", (1.0, 0.0)), ("M", (1.0, 1.0))]),
        "point_group": json.dumps([operation.tolist() for operation in OPERATIONS]),
    }
    data = {
        "distance": ("wavevector", np.interp(position, range(4), LENGTHS)),
        "frequency": (("wavevector", "band"), bands_at(at_position(position))),
    }
    return dataset_of_gaps(()).assign(data).assign_attrs(attrs)


NAMES = {
    "english": ("k", "Eigenfrequency", "Damping ratio", "Quality factor"),
    "comsol": ("k", "freq", "solid.zeta", "solid.Qeig"),
    "german": ("Wellenvektor", "Eigenfrequenz", "Dämpfungsgrad", "Güte"),
    "french": ("Vecteur d'onde", "Fréquence propre", "Taux d'amortissement", "Facteur de qualité"),
    "spanish": ("Vector de onda", "Frecuencia propia", "Amortiguamiento (damping)", "Quality factor"),
    "capitals": ("K", "FREQUENCY", "DAMPING RATIO", "Q"),
    "vibration": ("q", "Vibration frequency", "Loss factor", "Qeig"),
}
TITLES = (
    (),
    (
        "% Model:              cell.mph",
        "% Version:            COMSOL 6.1.0.252",
        "% Table:              Table 1 - Global",
    ),
    ("Source File Name:\tplate.svd", "Points: 12, Bands: 5"),
    ("# exported by a program", "# 12 wavevectors; 5 bands"),
    ("Bands of the plate", ""),
    ('"Date","Jan 5, 2024, 10:31"', "Version=6.1"),
    ("// units: SI", "! k along the path"),
)
UNIT_STYLES = ("({})", "[{}]", "[ {} ]", "in {}", "/ {}", "/{}", "line", "none")
SEPARATORS = ((",", "."), (";", "."), (";", ","), ("\t", "."), ("\t", ","), ("  ", "."), ("      ", "."),
              (" ", "."), (" | ", "."), (", ", "."), ("  ", ","), ("width", "."),
              ("narrow", "."))  # fmt: skip
WIDTHS = {"width": 26, "narrow": 17}  # of columns; longer names shift those behind them
LAYOUTS = (
    "wide",
    "wide",
    "long",
    "long",
    "blocks",
    "blocks without blank lines",
    "shuffled",
    "backwards",
    "headings",
)
WAVEVECTORS = ("segments", "share", "rad/m", "rad/mm", "1/m", "pi/a", "2pi/a", "kx rad/m", "kx 1/m",
               "kx rad/mm", "kx pi/a", "kx 2pi/a", "kx π/a")  # fmt: skip
NUMBERS = ("g", "E", "D", "complex", "brackets", "spaced", "quoted")
DAMAGES = ("", "", "", "word", "short", "long", "text row", "no names", "twice", "unit behind a number")


@dataclass(frozen=True)
class Drawn:
    """A table. kinds : what was drawn; asked : what its user gives; truth : (wavevector, 2), pi over pitch"""

    content: bytes
    kinds: dict[str, Any]
    asked: OfTable
    truth: np.ndarray
    damaged: bool

    def judged(self, path: Path, ours: xr.Dataset) -> str:
        """ "right", "refused", or what is wrong."""
        path.write_bytes(self.content)
        try:
            table = of_table(path, OurPath.of_dataset(ours), self.asked)
            Comparison(of_dataset("ours", ours), table).refuse_apart()
        except HaptonicError as error:
            parts = error.parts()
            return "refused" if all(parts.values()) else f"a part is missing: {parts}"
        expected = bands_at(at_position(table.position))
        if self.kinds["damage"] == "no names" and table.frequency.shape[1] > BANDS:
            return (
                "right" if np.allclose(table.frequency[:, :BANDS], expected, rtol=2e-4, atol=1.0) else "wrong"
            )
        if table.frequency.shape != expected.shape:
            return f"wrong: {table.frequency.shape} for {expected.shape}"
        if not np.allclose(table.frequency, expected, rtol=2e-4, atol=1.0):
            k, n = np.argwhere(~np.isclose(table.frequency, expected, rtol=2e-4, atol=1.0))[0]
            return f"wrong: {table.frequency[k, n]:g} for {expected[k, n]:g} Hz at {table.position[k]:g}"
        places = {tuple(np.round(sorted(np.abs(vector)), 3)) for vector in self.truth}
        seen = {tuple(np.round(sorted(np.abs(vector)), 3)) for vector in at_position(table.position)}
        return (
            "right" if seen == places or self.damaged else f"wrong: {len(seen)} wavevectors for {len(places)}"
        )


def named(head: str, unit: str, style: str) -> str:
    """A name with its unit; COMSOL's number of the band follows the unit."""
    if not unit or (unit == "1" and style[0] not in "(["):
        return head
    name, at, number = head.partition(" @ ")
    return f"{name} {style.format(unit)}{at}{number}"


def drawn(choose: Choose) -> Drawn:
    """A table, by choices."""
    kinds: dict[str, Any] = {
        "layout": choose(LAYOUTS), "wavevector": choose(WAVEVECTORS), "names": choose(tuple(NAMES)),
        "titles": choose(range(len(TITLES))), "style": choose(UNIT_STYLES), "separator": choose(SEPARATORS),
        "number": choose(NUMBERS), "unit": choose(("Hz", "kHz", "MHz", "rad/s")),
        "comment": choose(("", "% ", "# ", "")),
        "further": choose(("", "", "quality", "infinite", "twice", "angular", "polarisation", "index",
                           "error", "period")),
        "damage": choose(DAMAGES), "start": choose((0, 0, 1, 2)), "image": choose(range(8)),
        "count": choose((4, 7, 13)), "encoding": choose(("utf-8", "utf-8-sig", "utf-16", "latin-1")),
        "end": choose(("\n", "\r\n")), "behind": choose((False, False, True)),
        "footer": choose((False, False, True)),
        "imaginary": choose((False, True)), "corners": choose(("once", "twice")),
        "numbering": choose((" {}", "_{}", " @ {}", "")), "order": choose(range(1000)),
    }  # fmt: skip
    chance = np.random.default_rng(kinds["order"])
    separator, decimal = kinds["separator"]
    two = kinds["wavevector"].startswith("kx")
    unit = kinds["wavevector"].removeprefix("kx ")
    position = np.union1d(np.linspace(0, 3, kinds["count"]), [1, 2]) if kinds["count"] > 4 else np.arange(4.0)
    if two:
        position = (position + kinds["start"]) % 3
    vectors = at_position(position)
    frequency = bands_at(vectors)
    scale = {"rad/m": np.pi / PITCH, "1/m": np.pi / PITCH, "rad/mm": 1e-3 * np.pi / PITCH, "pi/a": 1.0,
             "π/a": 1.0, "2pi/a": 0.5}.get(unit, 1.0)  # fmt: skip
    if two:
        axis = vectors @ OPERATIONS[kinds["image"]].T * scale
        axis_names = ["kx", "ky"]
    else:
        along = np.interp(position, range(4), LENGTHS) * PITCH / np.pi
        axis = {"segments": position, "share": along / along[-1]}.get(unit, along * scale)[:, None]
        axis_names = [NAMES[kinds["names"]][0]]
    per, shown = {
        "Hz": (1.0, "Hz"),
        "kHz": (1e3, "kHz"),
        "MHz": (1e6, "MHz"),
        "rad/s": (1 / (2 * np.pi), "rad/s"),
    }[kinds["unit"]]

    def number(value: float, kind: str = "g") -> str:
        text = {"E": f"{value:.8E}", "D": f"{value:.8E}".replace("E", "D")}.get(kind, f"{value:.9g}").replace(
            ".", decimal
        )
        if kind in ("complex", "brackets", "spaced") and decimal == ".":
            small = f"{abs(value) * 1e-3:.3g}"
            text = {
                "complex": f"{text}+{small}i",
                "brackets": f"({text}+{small}j)",
                "spaced": f"{text} + {small}i",
            }[kind]
        return f'"{text}"' if kind == "quoted" else text

    def frequency_cell(value: float) -> str:
        if value < 1.0 and kinds["imaginary"] and decimal == ".":
            return "3.12E-03i"
        return number(value / per, kinds["number"])

    plain = NAMES[kinds["names"]]
    extra: list[tuple[str, str, Callable[[float], str]]] = {
        "quality": [(plain[2], "1", lambda f: number(1e-3)), (plain[3], "1", lambda f: number(500.0))],
        "infinite": [(plain[2], "1", lambda f: "0"), (plain[3], "1", lambda f: "Inf")],
        "twice": [("Frequency" if plain[1] != "FREQUENCY" else "Eigenfrequency", shown,
                   lambda f: number(f / per))],
        "angular": [("Angular frequency", "rad/s", lambda f: number(2 * np.pi * f))],
        "polarisation": [("p_ax", "1", lambda f: number(0.3) if f > 5e3 else "NaN"),
                         ("p_tr", "1", lambda f: number(0.7))],
        "index": [("Mode number", "1", lambda f: "3")],
        "period": [("Period", "us", lambda f: number(1e6 / max(f, 1e-3)))],
        "error": [("Error", shown, lambda f: number(0.5 / per))],
    }.get(kinds["further"], [])  # fmt: skip
    if kinds["layout"].startswith("wide") or kinds["layout"] in ("shuffled", "backwards"):
        order = chance.permutation(BANDS)
        names = [f"{plain[1]}{kinds['numbering'].format(n + 1)}" for n in order]
        extra = []
        rows = [
            [*map(number, place), *(frequency_cell(line[n]) for n in order)]
            for place, line in zip(axis, frequency, strict=True)
        ]
    elif kinds["layout"] == "headings":
        extra, names = [], [plain[1]] * len(axis)
        rows = [[frequency_cell(line[n]) for line in frequency] for n in range(BANDS)]
    else:
        names = [plain[1]]

        def row(place: np.ndarray, value: float) -> list[str]:
            return [*map(number, place), frequency_cell(value), *(column[2](value) for column in extra)]

        if kinds["layout"] == "long":
            rows = [row(place, value) for place, line in zip(axis, frequency, strict=True) for value in line]
        else:
            rows = []
            for n in range(BANDS):
                rows += [row(place, line[n]) for place, line in zip(axis, frequency, strict=True)]
                rows += [[]] if kinds["layout"] == "blocks" and n < BANDS - 1 else []
    if kinds["layout"] == "shuffled":
        rows = [rows[k] for k in chance.permutation(len(rows))]
    if kinds["layout"] == "backwards":
        rows = rows[::-1]
    axis_unit = "" if unit in ("segments", "share") else unit
    units = [axis_unit] * len(axis_names) + [shown] * len(names) + [column[1] for column in extra]
    heads = [*axis_names, *names, *(column[0] for column in extra)]
    glue = separator if separator.strip() or separator == "\t" else "   "
    corners_twice = kinds["corners"] == "twice" and not two and kinds["layout"] in ("wide", "long")
    if corners_twice:  # as where the end of a segment and the start of the next are both written
        each = 1 if kinds["layout"] == "wide" else BANDS
        rows = [
            cells for k, group in enumerate(rows[j : j + each] for j in range(0, len(rows), each))
            for cells in group * (2 if position[k] in (1.0, 2.0) else 1)
        ]  # fmt: skip
    style = kinds["style"]
    if kinds["layout"] == "headings":
        behind = ["k={:.9g}"] if not two else ["kx={:.9g}, ky={:.9g}"]
        heads = [f"{plain[1]} ({shown}) @ {behind[0].format(*place)}" for place in axis]
        units, style = [shown] * len(heads), "heading"
        if separator.strip() == "," or decimal == ",":
            heads = [f'"{head}"' for head in heads]
    elif style not in ("line", "none"):
        heads = [named(head, u, style) for head, u in zip(heads, units, strict=True)]

    def line(cells: Sequence[str], between: str = separator, mark: str = "") -> str:
        if separator not in WIDTHS:
            return mark + between.join(cells)
        width = WIDTHS[separator]
        return (
            mark
            + "".join(
                cell.ljust(max(width, len(cell) + 1) - (0 if k else len(mark)))
                for k, cell in enumerate(cells)
            ).rstrip()
        )

    lines = [*TITLES[kinds["titles"]], line(heads, glue, kinds["comment"])]
    if style == "line":
        lines.append(line([f"[{u}]" if u else "[ ]" for u in units], glue, kinds["comment"]))
    damage = kinds["damage"]
    names_given = damage != "no names"
    if not names_given:
        lines = lines[: len(TITLES[kinds["titles"]])]
    ending = separator if kinds["behind"] and separator.strip() not in ("", *WIDTHS) else ""
    body = [line(row) + (ending if row else "") for row in rows]
    place = int(chance.integers(0, len(body)))
    if damage == "word" and rows[place]:
        rows[place][int(chance.integers(0, len(rows[place])))] = "failed"
        body[place] = line(rows[place])
    elif damage == "short" and rows[place]:
        body[place] = line(rows[place][:-1])
    elif damage == "long" and rows[place]:
        body[place] = line([*rows[place], "1"])
    elif damage == "text row":
        body.insert(place, "not converged")
    elif damage == "twice":
        body.insert(place, lines[-1])
    elif damage == "unit behind a number" and rows[place]:
        rows[place][-1] += "Hz"
        body[place] = line(rows[place])
    text = kinds["end"].join([*lines, *body, *(["% end of table"] if kinds["footer"] else [])]) + kinds["end"]
    in_file = names_given and style != "none"
    wavevector_unit = unit if (not axis_unit or not in_file or kinds["layout"] == "headings") else None
    asked = OfTable(wavevector=wavevector_unit, frequency_unit=None if in_file else kinds["unit"])
    encoding = kinds["encoding"]
    content = (
        text.replace("π", "pi").encode(encoding, errors="replace")
        if encoding == "latin-1"
        else text.encode(encoding)
    )
    return Drawn(content, kinds, asked, vectors, damaged=damage not in ("", "no names"))
