"""Folders of force records as other laboratories write them, drawn from known friction."""

from __future__ import annotations

import csv
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from haptonic.errors import HaptonicError
from haptonic.friction.recordings import Sensor, analysed
from haptonic.friction.signals import Rules
from haptonic.friction.signals.rules import DRIFTS, JUMPS, OTHER_WAY

OFF, ON = 0.50, 0.25
ERROR = 0.01  # of a coefficient of friction
LIGHTEST = 0.6  # N
PEOPLE, TRIALS = ("P1", "P2", "P3"), 4
NAMES = {
    "Fz": ("Fx", "Fy", "Fz"), "F_z": ("F_x", "F_y", "F_z"), "fz": ("fx", "fy", "fz"),
    "Force Z": ("Force X", "Force Y", "Force Z"), "Force_Z": ("Force_X", "Force_Y", "Force_Z"),
    "Kraft_z": ("Kraft_x", "Kraft_y", "Kraft_z"), "Z Force": ("X Force", "Y Force", "Z Force"),
    "none": (), "strange": ("A", "B", "C"), "twice": ("Fy", "F_y", "Fz"),
}  # fmt: skip
FORCES = {
    "": 1.0, "N": 1.0, "mN": 1e3, "gf": 1 / 9.80665e-3, "lbf": 1 / 4.4482216152605, "V": 1.0,
    "counts": 1e6,
}  # fmt: skip
ANGLES = {"y": 0.0, "x": 90.0, "oblique": 35.0, "other": -60.0}
REASONS = {
    "": (),
    "gap": ("unreadable record",),
    "clipped": ("saturated channel",),
    # the rest at the end of such a record may look like the end of a range
    "early": (
        "contact before the stroke",
        "no contact",
        OTHER_WAY,
        "steady part too short",
        "saturated channel",
    ),
    "empty cell": ("missing numbers", "unreadable record"),
    "no file": ("unreadable record",),
    "restart": ("unreadable record",),
    "sign": (OTHER_WAY,),
    "jump": (JUMPS,),
}
# What is drawn of each folder; the first of every kind is the plain case.
KINDS: Mapping[str, tuple[Any, ...]] = {
    "seed": tuple(range(1000)),
    "rate": (500.0, 250.0, 400.0, 1000.0, 2000.0),
    "clock": (
        "even", "scatter", "scatter and rate", "milliseconds", "rounded", "polling", "doubled", "lost",
        "time of day", "12 hours", "ms unsaid", "no times", "ticks", "epoch", "doubled and rate",
    ),
    "names": tuple(NAMES),
    "unit": tuple(FORCES),
    "other_unit": (False, False, True),  # in the files of one participant
    "unit_in": ("brackets", "square", "name"),
    "direction": tuple(ANGLES),
    "turned_plane": (False, False, True),
    "sign": ("up", "down", "one down", "one up"),
    "answered": (False, True, True),  # the study gives what the files do not
    "separator": (",", ";", "\t", "; and comma", "tab and comma", "blanks"),
    "step": (0.0, 1e-3, 5e-3, 20e-3),
    "drift": (0.0, 0.05, -0.1),
    "rest_after": (0.25, 0.15, 0.0),
    "titles": ("none", "comments", "plain"),
    "position": ("none", "m", "mm"),
    "spoil": tuple(REASONS),
    "table": ("plain", "semicolons", "tabs", "capitals", "subjects", "german", "numbers", "empty row"),
    "bias": (0.0, 0.3, -2.0),
    "wander": (0.08, 0.0),
    "clip": ("pressing", "along"),  # which force the spoil "clipped" is about
    "noise": ("usual", "quiet"),  # quiet: far below a step of the converter
    "exchanged": (False, False, False, False, False, False, True),  # names of normal and tangential force
}  # fmt: skip


def drawn_at(number: int) -> dict[str, Any]:
    """The draw of this number."""
    rng = np.random.default_rng(number)
    return {name: some[rng.integers(len(some))] for name, some in KINDS.items()}


class Folder:
    """A folder of records, and what has to come out of it."""

    def __init__(self, folder: Path, draw: Mapping[str, Any]) -> None:
        self.folder, self.draw = folder, dict(draw)
        self.rng = np.random.default_rng(draw["seed"])
        self.truth: dict[tuple[str, int], float] = {}
        self.spoiled, self.clipped = ("P2", 2), dict[tuple[str, int], bool]()
        if self.draw["names"] == "none" or self.answers:  # the study gives the direction of the stroke
            self.draw |= {"direction": "y", "turned_plane": False}
        if self.draw["spoil"] == "clipped":  # no converter has less than a hundred steps up to its end
            finest = {"pressing": 5e-3, "along": 1e-3}[self.draw["clip"]]
            self.draw |= {"step": min(self.draw["step"], finest)}
        if self.draw["noise"] == "quiet":  # no finger presses evenly; a force that does looks like a limit
            self.draw |= {"wander": max(self.draw["wander"], 0.03)}
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        rows = []
        for person in PEOPLE:
            for trial in range(1, TRIALS + 1):
                friction = (OFF, ON)[trial % 2]
                self.truth[person, trial] = friction
                name = f"{person}-{trial}.csv"
                spoil = self.draw["spoil"] if (person, trial) == self.spoiled else ""
                if spoil != "no file":
                    (folder / name).write_text(
                        self._record((person, trial), friction, spoil), encoding="utf-8"
                    )
                rows.append((person, 1, trial, "WG1", ("off", "on")[trial % 2], name))
        self._table(rows)

    @property
    def answers(self) -> bool:
        """Whether the study gives the channels by number; exchanged numbers are a slip of the study."""
        unclear = self.draw["names"] in ("none", "strange", "twice") or self.draw["exchanged"]
        return bool(self.draw["answered"] and unclear)

    @property
    def sensor(self) -> Sensor:
        """Settings by a user who knows the files, as far as the draw has them."""
        settings: dict[str, Any] = {}
        names, unit, clock = (self.draw[key] for key in ("names", "unit", "clock"))
        if clock in ("scatter and rate", "no times", "doubled and rate"):
            settings["rate"] = self.draw["rate"]
        if self.answers:
            first = 1 if clock == "no times" else 2
            settings |= {"normal": str(first + 2), "tangential": str(first + 1)}
            settings |= {"time": "1"} if first == 2 and names == "none" else {}
        if self.draw["answered"] and (unit == "V" or (names == "none" and unit != "counts")):
            settings["force_unit"] = "N" if unit == "V" else unit
        if self.draw["answered"] and (clock == "ms unsaid" or (clock == "milliseconds" and names == "none")):
            settings["time_unit"] = "ms"
        return Sensor(**settings)

    @property
    def allowed(self) -> float:
        """Error of a coefficient that the files allow; noise that does not move a converter is no help."""
        quiet = self.draw["noise"] == "quiet"
        return ERROR + quiet * 0.5 * (1 + OFF) * self.draw["step"] / LIGHTEST

    @property
    def refused(self) -> bool:
        """Whether the files hold too little, so that a refusal is right."""
        if self.draw["answered"]:
            return False
        names, unit, clock = (self.draw[key] for key in ("names", "unit", "clock"))
        return (
            names in ("none", "strange", "twice") or unit == "V" or self.draw["exchanged"]
            or clock == "ms unsaid"
        )  # fmt: skip

    def _record(self, key: tuple[str, int], friction: float, spoil: str) -> str:
        draw, rng, rate, person = self.draw, self.rng, self.draw["rate"], key[0]
        after = draw["rest_after"]
        count = round((0.25 + 0.8 + after) * rate)
        even = np.arange(count) / rate
        time = self._taken(even)
        # forces at the times at which they were taken
        taken = even if draw["clock"] in ("scatter", "scatter and rate") else time
        wander = 1 + draw["wander"] * np.sin(2 * np.pi * 1.7 * taken + rng.uniform(0, 6))
        force = rng.uniform(LIGHTEST, 1.4)
        pressed = np.clip(np.minimum(taken - 0.25, 1.05 - taken if after else 9) / 0.1, 0, 1)
        normal = force * pressed * wander
        along = friction * normal * np.clip((taken - 0.35) / 0.05, 0, 1)
        angle = np.radians(ANGLES[draw["direction"]] + 90.0 * (draw["turned_plane"] and person == "P3"))
        orientation = 1 - 2 * (person == "P3")
        sign = {"up": 1, "down": -1, "one down": orientation, "one up": -orientation}
        turned = sign[draw["sign"]] * (-1 if spoil == "sign" else 1)
        axes = np.array([np.sin(angle) * along, np.cos(angle) * along, turned * normal])
        noise = max(3e-3, 0.4 * draw["step"])
        if draw["noise"] == "quiet":
            noise = max(5e-4, 0.15 * draw["step"])
        ramp = draw["drift"] * taken / taken[-1]
        axes = axes + noise * rng.standard_normal(axes.shape)
        axes += np.array([0.5, -1.0, 1.0])[:, None] * (draw["bias"] + ramp)
        if draw["step"]:
            axes = np.round(axes / draw["step"]) * draw["step"]
        if draw["spoil"] == "clipped":
            some = slice(2, 3) if draw["clip"] == "pressing" else slice(0, 2)
            end = np.round((abs(draw["bias"]) + {"pressing": 0.8, "along": 0.25}[draw["clip"]]) / 5e-3) * 5e-3
            # a reading at the end may be a larger force
            self.clipped[key] = bool((np.abs(axes[some]) > end - 1e-9).any())
            axes[some] = np.clip(axes[some], -end, end)
        middle = round(0.6 * rate)
        if spoil == "jump":
            axes[rng.integers(3), middle] += rng.choice([-3.0, 3.0])
        keep = np.ones(count, dtype=bool)
        if draw["clock"] == "lost":
            keep[rng.choice(np.arange(5, count - 5), 6, replace=False)] = False
        if spoil == "gap":
            first = round(0.55 * rate)
            keep[first : first + round(0.2 * rate)] = False
        if spoil == "early":
            keep[: round(0.5 * rate)] = False
        if spoil == "restart":
            time = np.where(np.arange(count) > count // 2, time - time[count // 2], time)
        position = 0.08 * np.clip(taken - 0.4, 0, None)
        unit = draw["unit"]
        if draw["other_unit"] and person == "P3" and draw["unit_in"] != "name" and draw["names"] != "none":
            unit = {"N": "mN", "mN": "N", "gf": "lbf", "lbf": "gf"}.get(unit, unit)
        return self._text(time[keep], axes[:, keep], position[keep], spoil, unit)

    def _taken(self, even: np.ndarray) -> np.ndarray:
        """Times at which samples are taken, before they are written."""
        rng, step = self.rng, 1 / self.draw["rate"]
        clock = self.draw["clock"]
        if clock in ("scatter", "scatter and rate"):
            return even + rng.uniform(-0.3, 0.3, len(even)) * step
        if clock == "polling":
            steps = step * rng.uniform(0.6, 1.5, len(even))
            steps[rng.choice(len(even), 3, replace=False)] += 0.012
            return np.cumsum(steps) - steps[0]
        return even

    def _text(self, time: np.ndarray, axes: np.ndarray, position: np.ndarray, spoil: str, unit: str) -> str:
        draw, clock, scale = self.draw, self.draw["clock"], FORCES[unit]
        x, y, z = NAMES[draw["names"]] or ("", "", "")
        if draw["exchanged"]:
            y, z = z, y
        written = {"counts": "", "": ""}.get(unit, unit)
        label = {"brackets": " ({})", "square": " [{}]", "name": "_{}"}[draw["unit_in"]].format(written)
        names = [name + (label if written and name else "") for name in (x, y, z)]
        values = axes * scale
        if not NAMES[draw["names"]]:
            order = values[[0, 1, 2]]
            values = order[[1, 1, 2]]
            values = values[[0, 2, 1]] if draw["exchanged"] else values
        columns = {names[k] or str(k): [f"{value:.6g}" for value in values[k]] for k in range(3)}
        if clock != "no times":
            columns = {self._time_name(): self._times(time), **columns}
        if draw["position"] != "none" and NAMES[draw["names"]]:
            factor = {"m": 1.0, "mm": 1e3}[draw["position"]]
            columns[f"position ({draw['position']})"] = [f"{factor * place:.6g}" for place in position]
        rows = [list(row) for row in zip(*columns.values(), strict=True)]
        if clock.startswith("doubled"):
            rows = [row for k, row in enumerate(rows) for _ in range(1 + (k % 7 == 3))]
        if spoil == "empty cell":
            rows[len(rows) // 2][-1] = ""
        separator = {"; and comma": ";", "tab and comma": "\t", "blanks": " "}.get(
            draw["separator"], draw["separator"]
        )
        head = list(columns)
        if separator == " ":
            separator = "\t" if any(" " in cell or not cell for row in [head, *rows] for cell in row) else " "
        if "and comma" in draw["separator"]:
            rows = [[cell.replace(".", ",") if ":" not in cell else cell for cell in row] for row in rows]
        lines = [separator.join(row) for row in rows]
        if NAMES[draw["names"]]:
            lines = [separator.join(head), *lines]
        titles = {"none": [], "comments": ["# recorded in the laboratory", "# sensor 3"],
                  "plain": ["Recorded by the program", "Sensor: 3"]}[draw["titles"]]  # fmt: skip
        if unit == "counts":
            titles = ["Force Units: N", "Counts per Unit Force: 1000000", *titles]
        return "\n".join([*titles, *lines]) + "\n"

    def _time_name(self) -> str:
        clock = self.draw["clock"]
        return {"milliseconds": "time (ms)", "time of day": "Time", "12 hours": "Time"}.get(clock, "time")

    def _times(self, time: np.ndarray) -> list[str]:
        clock = self.draw["clock"]
        if clock in ("milliseconds", "ms unsaid"):
            return [f"{1e3 * instant:.4f}" for instant in time]
        if clock == "rounded":
            return [f"{instant:.3f}" for instant in time]
        if clock == "ticks":
            return [f"{0.0156 * np.floor(instant / 0.0156):.4f}" for instant in time]
        if clock == "epoch":
            return [f"{1.7e9 + instant:.6f}" for instant in time]
        if clock in ("time of day", "12 hours"):
            return [self._of_day(86399.5 + instant) for instant in time]
        return [f"{instant:.6f}" for instant in time]

    def _of_day(self, seconds: float) -> str:
        milliseconds = round(1e3 * seconds) % 86_400_000
        hour, rest = divmod(milliseconds, 3_600_000)
        minute, rest = divmod(rest, 60_000)
        text = f"{minute:02d}:{rest // 1000:02d}.{rest % 1000:03d}"
        if self.draw["clock"] == "time of day":
            return f"{hour:02d}:{text}"
        return f"1/5/2024 {(hour - 1) % 12 + 1}:{text} {'AP'[hour >= 12]}M"

    def _table(self, rows: list[tuple[Any, ...]]) -> None:
        kind = self.draw["table"]
        head = ["participant", "block", "trial", "waveguide", "actuation", "file"]
        if kind == "capitals":
            head = [name.capitalize() for name in head]
        if kind == "subjects":
            head = ["Subject ID", "Session", "Trial No", "Region", "Condition", "File name"]
        if kind == "german":
            head = ["Proband", "Block", "Versuch", "Bereich", "Zustand", "Datei"]
            rows = [(*row[:4], {"on": "ein", "off": "aus"}[row[4]], row[5]) for row in rows]
        if kind == "numbers":
            head = ["participant", "block", "trial", "waveguide", "vibration", "file"]
            rows = [(*row[:4], {"on": 1, "off": 0}[row[4]], row[5]) for row in rows]
        if kind == "empty row":
            rows = [*rows, ("P3", "", 9, "WG1", "on", "P3-1.csv")]
        with (self.folder / "trials.csv").open("w", newline="", encoding="utf-8") as file:
            table = csv.writer(file, delimiter={"semicolons": ";", "tabs": "\t"}.get(kind, ","))
            table.writerow(head)
            table.writerows(rows)


def outcome(folder: Path, draw: Mapping[str, Any]) -> str:
    """Outcome of a drawn folder: "right", with a trial "left out", "refused", or something else: a fault.

    "noted": the files do not show what is wrong with a value, and a remark reports it.
    """
    drawn = Folder(folder, draw)
    try:
        read = analysed(folder, drawn.sensor, Rules())
        trials = read.trials
    except HaptonicError as error:
        nothing_left = bool(drawn.clipped) and all(drawn.clipped.values())
        nothing_left |= bool(draw["drift"]) and not draw["rest_after"] and DRIFTS in error.given
        whole = (drawn.refused or nothing_left) and all(error.parts().values())
        return "refused" if whole else f"fault: refused: {error.argument}: {error.given}; {error.cause}"
    verdict, noted = "right", any("records do not end at rest" in text for text in read.doubts)
    if draw["exchanged"] and draw["names"] == "none" and any("exchanged" in text for text in read.doubts):
        return "noted"  # the study names both forces, and not truly
    drifts = bool(draw["drift"]) and not draw["rest_after"]
    for row in range(trials.sizes["stroke"]):
        key = str(trials["participant"].values[row]), int(trials["trial"].values[row])
        reason, friction = str(trials["excluded"].values[row]), float(trials["friction"].values[row])
        spoil = draw["spoil"] if key == drawn.spoiled else ""
        spoil = "clipped" if drawn.clipped.get(key) else "" if spoil == "clipped" else spoil
        if reason:
            if reason not in (*REASONS[spoil], *((DRIFTS,) if drifts else ())):
                return f"fault: left out: {key}: {reason}: {trials['detail'].values[row]}"
            verdict = "left out" if verdict != "noted" else verdict
        elif not abs(friction - drawn.truth[key]) <= drawn.allowed:
            if not (drifts and noted):
                return f"wrong: {key}: {friction:.4f} instead of {drawn.truth[key]}"
            verdict = "noted"
    return verdict
