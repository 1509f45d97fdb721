"""Scans of a known field, written in the ways of other programs: drawn by hypothesis."""

from __future__ import annotations

import re
import warnings
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pyuff
import scipy.io
from hypothesis import strategies as st

DEGREE = np.pi / 180
LENGTHS = {"m": 1.0, "mm": 1e-3, "cm": 1e-2, "um": 1e-6}
HERTZ = {"Hz": 1.0, "kHz": 1e3, "rad/s": 0.5 / np.pi}
ANGLES = {"rad": 1.0, "deg": DEGREE, "°": DEGREE, "mrad": 1e-3, "degrees": DEGREE}
# unit of the response, one of it in SI units, and powers of i omega that turn it into a velocity
MOTIONS = {
    "m/s/V": (1.0, 0), "(m/s)/V": (1.0, 0), "mm/s/V": (1e-3, 0), "m/s/N": (1.0, 0), "um/s/mV": (1e-3, 0),
    "m/s^2/N": (1.0, -1), "g/V": (9.80665, -1), "m/N": (1.0, 1), "nm/V": (1e-9, 1),
}  # fmt: skip
PARTS = {"complex": ("response",), "parts": ("real", "imaginary"), "polar": ("amplitude", "phase")}
# names of frequency, response, real, imaginary, amplitude, phase, x, y, points, file
LANGUAGES = {
    "usual": ("Frequency", "FRF", "Real", "Imag", "Magnitude", "Phase", "X", "Y", "xy", "File"),
    "short": ("f", "H1", "re", "im", "mag", "phase", "x", "y", "points", "name"),
    "german": ("Frequenz", "Antwort", "Realteil", "Imaginärteil", "Betrag", "Phasenwinkel", "Rechts", "Hoch",
               "Orte", "Datei"),
    "french": ("Fréquence", "Réponse", "Partie réelle", "Partie imaginaire", "Module", "Déphasage",
               "Abscisse", "Ordonnée", "Lieux", "Fichier"),
    "spanish": ("Frecuencia", "Respuesta", "Parte real", "Parte imaginaria", "Módulo", "Fase", "Horizontal",
                "Vertical", "Puntos", "Archivo"),
    "chinese": ("频率", "响应", "实部", "虚部", "幅值", "相位", "横坐标", "纵坐标", "点", "文件"),
}  # fmt: skip
MEANINGS = ("frequency", "response", "real", "imaginary", "amplitude", "phase", "x", "y", "points", "file")
ASCII = {
    language: all(name.isascii() and " " not in name for name in names)
    for language, names in LANGUAGES.items()
}
ARRAYS = (
    "mat5", "mat5 structure", "mat5 cells", "mat5 structures", "mat73", "mat73 structure", "mat73 cells",
    "hdf5", "hdf5 group",
)  # fmt: skip
TABLES = ("folder",)


@dataclass(frozen=True)
class Stranger:
    """A scan of a field as somebody has stored it, and the options that give what the file lacks.

    values : (line, point) response in SI units of ``unit``; read back as velocity or displacement
    options : of `haptonic.read_scan`
    complete : True if file and options give everything, so that the scan must be read
    """

    container: str
    frequency: Any
    x: Any
    y: Any
    values: Any
    unit: str
    part: str
    language: str
    turned: bool
    shuffled: bool
    units: dict[str, str]
    said: bool
    options: dict[str, Any]
    complete: bool
    style: dict[str, Any] = field(default_factory=dict)

    @property
    def names(self) -> dict[str, str]:
        return dict(zip(MEANINGS, LANGUAGES[self.language], strict=True))


@st.composite
def strangers(draw, containers=(*ARRAYS, *TABLES, "uff")) -> Stranger:
    """Any of these scans."""
    container = draw(st.sampled_from(containers))
    points, lines = draw(st.integers(1, 6)), draw(st.integers(2, 7))
    chance = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    frequency = np.sort(chance.choice(np.arange(400, 800), lines, replace=False)) * 100.0
    grid = np.array([(i % 3, i // 3) for i in range(points)], float).reshape(-1, 2)
    x, y = 4e-3 + 5e-3 * grid[:, 0], 2e-3 + 5e-3 * grid[:, 1]
    values = chance.normal(size=(lines, points)) + 1j * chance.normal(size=(lines, points))
    language = draw(st.sampled_from([name for name in LANGUAGES if container in TABLES or ASCII[name]]))
    part = draw(st.sampled_from(sorted(PARTS))) if container not in TABLES else draw(
        st.sampled_from(["parts", "polar"]))  # fmt: skip
    units = {
        "length": draw(st.sampled_from(sorted(LENGTHS))), "frequency": draw(st.sampled_from(sorted(HERTZ))),
        "phase": draw(st.sampled_from(sorted(ANGLES))), "response": draw(st.sampled_from(sorted(MOTIONS))),
    }  # fmt: skip
    has_units = draw(st.booleans())  # in names or attributes
    if container not in (*TABLES, "hdf5", "hdf5 group"):
        has_units = False
    options: dict[str, Any] = {}
    user_gives_units = draw(st.integers(0, 3)) > 0  # if the file has none
    if not has_units and user_gives_units and container != "uff":
        options = {"length_unit": LENGTHS[units["length"]], "frequency_unit": HERTZ[units["frequency"]],
                   "unit": units["response"]}  # fmt: skip
        if part == "polar":
            options["phase_unit"] = ANGLES[units["phase"]]
    usual = language in ("usual", "short")
    named = draw(st.integers(0, 3)) > 0 or usual
    placed = draw(st.sampled_from(["xy", "points", "at"])) if container in ARRAYS else draw(
        st.sampled_from(["xy", "xy", "at"]))  # fmt: skip
    if "cells" in container or "structures" in container:
        placed = "xy" if placed == "points" else placed
    square = container in ARRAYS and points == lines > 1
    sided = not square or draw(st.booleans())
    turned = draw(st.booleans()) and "cells" not in container and "structures" not in container
    if square and sided:
        options["points_in"] = "columns" if turned else "rows"
    axes = draw(st.sampled_from([2, 3, 3]))  # of a table of places
    both_sides = placed == "points" and points == axes > 1
    places_turned = draw(st.booleans())
    if both_sides and not square and (axes == 2 or draw(st.booleans())):
        options["points_in"] = "columns" if places_turned else "rows"
    style = {
        "placed": placed, "axes": axes, "places_turned": places_turned,
        "height": draw(st.sampled_from([0.0, 1e-3])), "separator": draw(st.sampled_from([",", ";", "\t"])),
        "decimal": draw(st.sampled_from([".", ","])), "titles": draw(st.integers(0, 3)),
        "below": draw(st.booleans()), "spectra": draw(st.booleans()), "h2": draw(
            st.sampled_from(["", "after", "before"])),
        "empty": draw(st.booleans()), "binary": draw(st.booleans()), "encoding": draw(
            st.sampled_from(["utf-8", "utf-8-sig", "utf-16"])),
    }  # fmt: skip
    if style["separator"] == ",":
        style["decimal"] = "."
    stranger = Stranger(
        container=container, frequency=frequency, x=x, y=y, values=values, unit=units["response"], part=part,
        language=language, turned=turned, shuffled=draw(st.booleans()), units=units, said=has_units,
        options=options, complete=True, style=style,
    )  # fmt: skip
    if not usual and named:
        wanted = ["frequency", *PARTS[part], *({"xy": ["x", "y"], "points": ["points"], "at": []}[placed])]
        wanted += ["file"] if container in TABLES and placed != "at" else []
        prefix = {"mat5 structure": "scan.", "mat5 structures": "scan.", "mat73 structure": "scan.",
                  "hdf5 group": "scan/"}.get(container, "")  # fmt: skip
        options["variables"] = {meaning: prefix + stranger.names[meaning] for meaning in wanted}
        if "cells" in container or "structures" in container:
            options["variables"] |= {meaning: options["variables"][meaning] for meaning in wanted}
    if placed == "at" or (container == "uff" and style["empty"]):
        options["at"] = list(zip(x, y, strict=True))
    complete = (
        (has_units or user_gives_units or container == "uff")
        and (named or container == "uff")
        and (sided or not square)
        and not (both_sides and square and axes == 2)
    )
    return Stranger(**{**vars(stranger), "complete": complete, "options": options})


def written(stranger: Stranger, folder: Path) -> Path:
    """The file or folder of a scan."""
    if stranger.container == "uff":
        return _uff(stranger, folder / "scan.uff")
    if stranger.container in TABLES:
        return _folder(stranger, folder)
    return _arrays(stranger, folder)


def numbers(stranger: Stranger) -> tuple[Any, Any, Any, dict[str, Any]]:
    """Frequencies, x, y and (line, point) parts in the units of the file, in its order of lines."""
    order = np.arange(len(stranger.frequency))
    if stranger.shuffled:
        order = np.random.default_rng(1).permutation(order)
    frequency = stranger.frequency[order] / HERTZ[stranger.units["frequency"]]
    x, y = (axis / LENGTHS[stranger.units["length"]] for axis in (stranger.x, stranger.y))
    values = stranger.values[order]
    if stranger.part == "complex":
        return frequency, x, y, {"response": values}
    if stranger.part == "parts":
        return frequency, x, y, {"real": values.real, "imaginary": values.imag}
    phase = np.angle(values) / ANGLES[stranger.units["phase"]]
    return frequency, x, y, {"amplitude": np.abs(values), "phase": phase}


def expected(stranger: Stranger) -> tuple[Any, str]:
    """(line, point) response as it is read, and its quantity."""
    factor, power = MOTIONS[stranger.unit]
    values = factor * stranger.values
    if power == -1:
        return values / (2j * np.pi * stranger.frequency[:, None]), "velocity"
    return values, "displacement" if power else "velocity"


def _arrays(stranger: Stranger, folder: Path) -> Path:
    frequency, x, y, parts = numbers(stranger)
    names, placed = stranger.names, stranger.style["placed"]
    table = {names["frequency"]: frequency}
    table |= {names[part]: values if stranger.turned else values.T for part, values in parts.items()}
    if placed == "xy":
        table |= {names["x"]: x, names["y"]: y}
    elif placed == "points":
        style = stranger.style
        places = np.column_stack([x, y, 0 * x + style["height"]])[:, : style["axes"]]
        table[names["points"]] = places.T if style["places_turned"] else places
    kind = stranger.container
    if "cells" in kind or "structures" in kind:
        for part in parts:
            table[names[part]] = list(parts[part].T)
    of_units = {"frequency": "frequency", "x": "length", "y": "length", "points": "length", "phase": "phase"}
    units = {names[meaning]: stranger.units[of_units.get(meaning, "response")] for meaning in names}
    if kind.startswith("mat5"):
        return _mat5(kind, table, names, folder / "scan.mat")
    if kind.startswith("mat73"):
        return _mat73(kind, table, folder / "scan.mat")
    with h5py.File(folder / "scan.h5", "w") as file:
        place = file.create_group("scan") if kind == "hdf5 group" else file
        for name, values in table.items():
            place[name] = values
            if stranger.said:
                place[name].attrs["units"] = units[name]
    return folder / "scan.h5"


def _mat5(kind: str, table: dict[str, Any], names: dict[str, str], path: Path) -> Path:
    if kind == "mat5 structures":
        count = max(len(value) for value in table.values() if isinstance(value, list))
        lists = {name: value for name, value in table.items() if isinstance(value, list)}
        each = {name: value for name, value in table.items() if name in (names["x"], names["y"])}
        kinds = [(name, object) for name in (*lists, *each, names["frequency"])]
        array = np.empty((1, count), dtype=kinds)
        for i in range(count):
            for name, value in lists.items():
                array[name][0, i] = value[i]
            for name, value in each.items():
                array[name][0, i] = value[i]
            array[names["frequency"]][0, i] = table[names["frequency"]]
        scipy.io.savemat(path, {"scan": array})
        return path
    for name, value in table.items():
        if isinstance(value, list):
            cells = np.empty((len(value), 1), dtype=object)
            for i, entry in enumerate(value):
                cells[i, 0] = entry
            table[name] = cells
    scipy.io.savemat(path, {"scan": table} if kind == "mat5 structure" else table)
    return path


def _mat73(kind: str, table: dict[str, Any], path: Path) -> Path:
    def stored(value):
        value = np.atleast_2d(value).T
        if np.iscomplexobj(value):
            pair = np.empty(value.shape, dtype=[("real", "f8"), ("imag", "f8")])
            pair["real"], pair["imag"] = value.real, value.imag
            return pair
        return value

    with h5py.File(path, "w", userblock_size=512) as file:
        place = file.create_group("scan") if kind == "mat73 structure" else file
        for name, value in table.items():
            if isinstance(value, list):
                for i, entry in enumerate(value):
                    file[f"#refs#/{name}{i}"] = stored(entry)
                references = [[file[f"#refs#/{name}{i}"].ref for i in range(len(value))]]
                place.create_dataset(
                    name, data=np.array(references, dtype=h5py.ref_dtype), dtype=h5py.ref_dtype
                )
                place[name].attrs["MATLAB_class"] = np.bytes_("cell")
            else:
                place[name] = stored(value)
    with path.open("rb+") as file:
        file.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(116))
    return path


def _folder(stranger: Stranger, folder: Path) -> Path:
    frequency, x, y, parts = numbers(stranger)
    names, style, units = stranger.names, stranger.style, stranger.units
    separator, decimal = style["separator"], style["decimal"]

    def text(value):
        return f"{value:.10g}".replace(".", decimal)

    def head(meaning, unit):
        return f"{names[meaning]} [{unit}]" if stranger.said and not style["below"] else names[meaning]

    def save(path, rows, columns, of_units):
        lines = ["Vibrometer export", "Source File:\tplate.svd", "Point Index: 1"][: style["titles"]]
        lines.append(separator.join(columns))
        if stranger.said and style["below"]:
            lines.append(separator.join(f"[ {unit} ]" for unit in of_units))
        lines += [separator.join(row) for row in rows]
        path.write_text("\n".join(lines) + "\n", encoding=style["encoding"])

    if style["placed"] != "at":
        rows = [[f"p{i}.csv", text(a), text(b)] for i, (a, b) in enumerate(zip(x, y, strict=True))]
        plain = {**style, "titles": 0, "below": False}
        heads = [
            names["file"],
            *(f"{names[axis]} [{units['length']}]" if stranger.said else names[axis] for axis in "xy"),
        ]
        content = "\n".join([separator.join(heads), *(separator.join(row) for row in rows)])
        (folder / "geometry.csv").write_text(content + "\n", encoding=plain["encoding"])
    of_unit = {"real": "response", "imaginary": "response", "amplitude": "response", "phase": "phase"}
    for i in range(len(x)):
        columns = [
            head("frequency", units["frequency"]),
            *(head(part, units[of_unit[part]]) for part in parts),
        ]
        rows = [[text(f), *(text(parts[part][k, i]) for part in parts)] for k, f in enumerate(frequency)]
        save(
            folder / f"p{i}.csv",
            rows,
            columns,
            [units["frequency"], *(units[of_unit[part]] for part in parts)],
        )
    return folder


def _uff(stranger: Stranger, path: Path) -> Path:
    style, count = stranger.style, len(stranger.x)
    over, _, under = stranger.unit.rpartition("/")
    like = {
        "type": 58, "binary": int(style["binary"]), "rsp_dir": 3, "ref_dir": 3, "ref_node": 1,
        "abscissa_spacing": 0, "abscissa_spec_data_type": 18, "abscissa_axis_units_lab": "Hz",
        "x": stranger.frequency, "ordinate_spec_data_type": 11, "orddenom_spec_data_type": 0,
    }  # fmt: skip
    zeros = np.zeros(count, dtype=int)
    sets: list[dict[str, Any]] = [
        {"type": 164, "units_code": 1, "length": 1.0, "force": 1.0, "temp": 1.0, "temp_offset": 0.0}
    ]
    if not style["empty"] and style["placed"] != "at":
        sets.append({"type": 2411, "node_nums": np.arange(1, count + 1), "def_cs": zeros, "disp_cs": zeros,
                     "color": zeros, "x": stranger.x, "y": stranger.y, "z": 0 * stranger.x})  # fmt: skip

    def curves(factor, name):
        return [
            like | {"func_type": 4, "rsp_node": i + 1, "id1": f"Transfer Function {name}",
                    "ordinate_axis_units_lab": over, "orddenom_axis_units_lab": under,
                    "ordinate_spec_data_type": 0,
                    "data": factor * stranger.values[:, i]}
            for i in range(count)
        ]  # fmt: skip

    if style["spectra"]:
        sets += [
            like | {"func_type": 0, "rsp_node": i + 1, "id1": "Response Linear Spectrum",
                    "ordinate_axis_units_lab": "m/s", "orddenom_axis_units_lab": "NONE",
                    "data": 7.0 * stranger.values[:, i]}
            for i in range(count)
        ]  # fmt: skip
    h1, h2 = curves(1.0, "H1"), curves(1.02, "H2")
    sets += {"": h1, "after": h1 + h2, "before": h2 + h1}[style["h2"]]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ResourceWarning)  # pyuff's binary writer leaves files open
        pyuff.UFF(str(path)).write_sets([dict(data_set) for data_set in sets], "overwrite")
    # pyuff writes no spectra: function 12 in place of 0
    spectrum = rb"(Response Linear Spectrum[^\n]*\n(?:[^\n]*\n){4})    0"
    path.write_bytes(re.sub(spectrum, rb"\1   12", path.read_bytes()))
    return path
