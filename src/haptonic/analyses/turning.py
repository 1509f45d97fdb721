"""Numbers of a study that a user can turn, and previews of the bands while one of them is turned."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, Self

from haptonic.cell import UnitCell
from haptonic.design.parameters import COORDINATE, values_of
from haptonic.design.preview import CertifiedBands, DesignLine, Samples, refined_lines
from haptonic.errors import HaptonicError, HaptonicWarning
from haptonic.fields import numbers
from haptonic.fields.expressions import NAMED
from haptonic.fields.keys import key_of, table
from haptonic.fields.writing import parameters_of
from haptonic.later import xarray as xr
from haptonic.results.bands import Bands
from haptonic.study.named import expressions_of
from haptonic.study.schema import Description
from haptonic.units import format_quantity, to_si

LEAST, MOST = 0.8, 1.25  # ends of a slider, relative to the value of the study
INNER = 0.1  # share of a slider at either end in which a new study moves its range
NARROWER = (1.0, 0.5, 0.25, 0.1)  # shares of the range that are tried until both ends are possible designs
STEPS = 250  # most steps of a slider
MOST_LINES = 16  # that stay in memory, 0.5 MB each


@dataclass(frozen=True)
class Knob:
    """A number of a study with its slider; all values are in ``unit``.

    scale : SI units in one ``unit``
    """

    path: str
    title: str
    unit: str
    scale: float
    value: float
    low: float
    high: float
    step: float

    @classmethod
    def around(cls, path: str, title: str, value: float, unit: str) -> Self:
        """Slider around a value (SI); its steps begin with 1, 2 or 5, and the value is one of them."""
        shown, _, name = format_quantity(value, unit, digits=None if unit != "rad" else 6).partition(" ")
        here = float(shown)
        finest = (MOST - LEAST) * abs(here) / STEPS
        power = 10.0 ** math.floor(math.log10(finest))
        step = next(step for step in (power, 2 * power, 5 * power, 10 * power) if step >= finest)
        ends = sorted((LEAST * here, MOST * here))
        low, high = (_at_step(here, end - here, step) for end in ends)
        return cls(
            path=path, title=title, unit=name, scale=to_si(f"1 {name}", unit, path) if name else 1.0,
            value=here, low=low, high=high, step=step,
        )  # fmt: skip

    def narrowed(self, share: float) -> Self:
        """The slider with a share of its range on either side of the value."""
        low, high = (
            _at_step(self.value, share * (end - self.value), self.step) for end in (self.low, self.high)
        )
        return type(self)(**vars(self) | {"low": low, "high": high})

    def moved(self, value: float) -> Self | None:
        """The slider with another value (SI); None if that is not well inside its range."""
        here, room = value / self.scale, INNER * (self.high - self.low)
        inside = self.low + room <= here <= self.high - room
        return type(self)(**vars(self) | {"value": here}) if inside else None


def _at_step(start: float, distance: float, step: float) -> float:
    """The last whole step within a distance; rounded, because a step is no binary number."""
    return float(f"{start + step * math.trunc(distance / step):.12g}")


@dataclass
class BandsTurning:
    """Sliders and previews of the bands of one study after another; it remembers designs of the last ones."""

    _knobs: dict[str, Knob] = field(default_factory=dict)
    _lines: dict[tuple[Any, ...], DesignLine] = field(default_factory=dict)

    def knobs(self, study: Description) -> list[Knob]:
        """Numbers of the cell that the study gives, with exact derivatives and no expression, and named
        parameters.

        A slider keeps its range while its value is well inside.
        """
        varied, expressed, units = values_of(study.cell), expressions_of(study), study.units()
        scope = parameters_of(study)
        used = set[str]().union(*(scope.uses(text) for path, text in expressed.items() if path in varied))
        varied_names = {f"{NAMED}{name}" for name in used}
        knobs = []
        for path, value in numbers(study, names=True).items():
            varies = path in varied or path in varied_names
            if not value or not varies or path in expressed or COORDINATE.fullmatch(path):
                continue
            known = self._knobs.get(path)
            moved = known and known.moved(value)
            around = Knob.around(path, _title(path), value, units[path])
            tried = [*([moved] if moved else []), *(around.narrowed(share) for share in NARROWER)]
            knob = next((knob for knob in tried if _possible(study, knob)), None)
            if knob is not None:
                self._knobs[path] = knob
                knobs.append(knob)
        return knobs

    def certified(self, study: Description, result: Bands) -> CertifiedBands:
        """The result, with coarse bands of the same design."""
        return CertifiedBands(result.dataset, Samples.of(study.cell, study.bands_settings))

    def previews(
        self, study: Description, certified: CertifiedBands, knob: Knob
    ) -> Iterator[xr.Dataset | None]:
        """Previews along a slider, each better than the one before; None while there is none yet."""

        def design(value: float) -> UnitCell:
            return _design(study, knob.path, value).cell

        low, high = (knob.scale * end for end in (knob.low, knob.high))
        key = (knob.path, design(low), low, high, study.bands_settings)
        here = study.parameters()[knob.path]
        lines = refined_lines(
            self._lines.get(key), design, certified=certified, settings=study.bands_settings,
            ends=(low, high), here=here,
        )  # fmt: skip
        for line in lines:
            if line is not None:
                self._lines.pop(key, None)
                self._lines[key] = line  # as the newest
                for oldest in list(self._lines)[:-MOST_LINES]:
                    del self._lines[oldest]
            yield None if line is None else line.dataset(certified)


def _title(path: str) -> str:
    """Title of a number: that of its key, with the number of its site or disc, or the name of a parameter."""
    if path.startswith(NAMED):
        return path.removeprefix(NAMED)
    key = key_of(path, table(Description))
    assert key is not None, path
    numbers = [part.partition("[") for part in path.split(".")[:-1] if "[" in part]
    where = ", ".join(f"{name} {number.rstrip(']')}" for name, _, number in numbers)
    return f"{key.title}, {where}" if where else key.title


def _possible(study: Description, knob: Knob) -> bool:
    try:
        for end in (knob.low, knob.high):
            _design(study, knob.path, knob.scale * end)
    except HaptonicError:
        return False
    return knob.low < knob.high


def _design(study: Description, path: str, value: float) -> Description:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", HaptonicWarning)  # on unusual values, which the study itself reports
        return study.with_parameters({path: value})
