"""Keys of the store follow from the values that decide a result: every field of every one of them counts."""

from __future__ import annotations

import copy
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr
from small import CELL, COARSE, busy_plate

from haptonic.analyses.bands import compute_bands
from haptonic.analyses.designing.tasks import front_task, look_task
from haptonic.analyses.feel import compute_loaded
from haptonic.analyses.plate import compute_plate
from haptonic.analyses.runner import Runner
from haptonic.bloch.settings import BandSettings, MeshSettings
from haptonic.cell import Pillar, UnitCell
from haptonic.cell.pillar_parts import Step
from haptonic.design.brief import Brief
from haptonic.design.settings import DesignLimits
from haptonic.errors import HaptonicWarning
from haptonic.friction.lubrication.settings import Pad
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial
from haptonic.plate.vibration.settings import ResponseSettings
from haptonic.progress import silent
from haptonic.store import Store, content_key

MATERIAL = IsotropicMaterial(
    70e9, 0.33, 2700.0, 1e-3, name="aluminium", uncertainty={"density": 10.0}, note="as delivered"
)
FULL = UnitCell(
    Lattice.square(7e-3), 1.5e-3, MATERIAL,
    Pillar(3.5e-3, 14.7e-3, draft=0.01, fillet=0.2e-3, step=Step(3e-3, 5e-3)),
)  # fmt: skip
ASKED = BandSettings(6, 20, 1e-3, MeshSettings(3, 1))
BRIEF = Brief(
    FULL, 60e3, 8, {"cell.pitch": (5e-3, 9e-3), "cell.thickness": (1e-3, 2e-3)},
    DesignLimits(slenderness=8.0, tool=2e-3, reach=20e-3, finger_force=5.0, finger_span=30e-3,
    finger_deflection=1e-4), held={"cell.pillar.diameter": 3e-3},
)  # fmt: skip
QUESTION = ResponseSettings(lowest=40e3, highest=60e3, points=11, tolerance=1e-2, grid=2e-3)
PAD = Pad(10e-3, (0.5, 1.0, 2.0))


class FoundError(Exception):
    """The key that was asked for."""


@dataclass(frozen=True)
class Asking(Store):
    """A store that ends the computation at its first question."""

    def get(self, key: str) -> Any:
        raise FoundError(key)


STORE = Asking(Path("nowhere"))


def gaps_key(cell: UnitCell, asked: BandSettings) -> object:
    return Runner(STORE).gaps(cell, asked)


def bands_key(cell: UnitCell, asked: BandSettings) -> object:
    return compute_bands(cell, asked, surface=False, inputs={}, carrier=None, store=STORE)


def look_key(brief: Brief) -> object:
    raise FoundError(content_key(look_task(brief, np.array([0.5, 0.5])).key_inputs))


def front_key(brief: Brief) -> object:
    raise FoundError(content_key(front_task(brief, np.array([0.5, 0.5]), 3).key_inputs))


def plate_key(plate: Any, question: ResponseSettings, fineness: Any) -> object:
    return compute_plate(
        plate, question, carrier=5e4, gap=None, inputs={}, store=STORE, fineness=fineness
    )  # fmt: skip


def loaded_key(plate: Any, pad: Pad, fineness: Any) -> object:
    return compute_loaded(
        STORE, {}, silent, plate=plate, diameter=pad.diameter, damping=pad.damping, carrier=5e4, at=None,
        gap=None, grid=1e-3, tolerance=1e-2, fineness=fineness,
    )  # fmt: skip


QUESTIONS: dict[str, tuple[Callable[..., object], tuple[Any, ...], set[str]]] = {
    "gaps": (gaps_key, (FULL, ASKED), set()),
    "bands": (bands_key, (FULL, ASKED), set()),
    "look": (look_key, (BRIEF,), set()),
    "front": (front_key, (BRIEF,), set()),
    "plate": (plate_key, (busy_plate(), QUESTION, COARSE), set()),
    # a damper instead of the plate's own finger
    "loaded": (loaded_key, (busy_plate(), PAD, COARSE), {"finger"}),
}


def key_of(ask: Callable[..., object], values: tuple[Any, ...]) -> str:
    with pytest.raises(FoundError) as raised:
        ask(*values)
    return str(raised.value)


def other(value: Any) -> Any:
    """A value of the same kind that is not equal, as near as one can be."""
    match value:
        case None:
            return 1.0
        case bool():
            return not value
        case int():
            return value + 1
        case float():
            return 1.0 if math.isinf(value) else float(np.nextafter(value, 1e300))
        case complex():
            return value + 1e-9j
        case str():
            return f"{value}x"
        case tuple():
            return (*value, value[-1]) if value else (1.0,)
        case Mapping():
            return {**value, "more": next(iter(value.values()), 1.0)}
    raise AssertionError(f"do not know how to change {value!r}")


def with_field(value: Any, name: str, inner: Any) -> Any:
    """A copy with one field replaced, even where the type itself would refuse or derive it."""
    changed = copy.copy(value)
    for cached in set(changed.__dict__) - {field.name for field in fields(changed)}:
        del changed.__dict__[cached]
    object.__setattr__(changed, name, inner)
    return changed


def neighbours(value: Any, at: str = "") -> Iterator[tuple[str, Any]]:
    """Copies of a value that differ in one field each, however deep, with the path of that field."""
    if is_dataclass(value):
        for field in fields(value):
            inner = getattr(value, field.name)
            for path, changed in neighbours(inner, f"{at}.{field.name}"):
                yield path, with_field(value, field.name, changed)
        return
    yield at, other(value)
    if isinstance(value, tuple):
        for k, inner in enumerate(value):
            for path, changed in neighbours(inner, f"{at}[{k}]"):
                yield path, (*value[:k], changed, *value[k + 1 :])
    elif isinstance(value, Mapping):
        for name, inner in value.items():
            for path, changed in neighbours(inner, f"{at}[{name}]"):
                yield path, {**value, name: changed}


@pytest.mark.parametrize("kind", QUESTIONS)
def test_every_field_of_what_is_asked_changes_the_key(kind):
    ask, values, ignored = QUESTIONS[kind]
    mine, same = key_of(ask, values), []
    count = 0
    for number, value in enumerate(values):
        for path, changed in neighbours(value):
            if path.strip(".").split(".")[0] in ignored:
                continue
            count += 1
            if key_of(ask, (*values[:number], changed, *values[number + 1 :])) == mine:
                same.append(f"{type(value).__name__}{path}")
    assert same == []
    assert count > 20, "the fields were seen"


def test_less_symmetry_than_the_lattice_is_another_cell():
    """The fault that was found: two cells that are unequal and had one key."""
    lower = UnitCell(with_field(CELL.lattice, "form", "rectangular"), 1.5e-3, CELL.material)
    whole = UnitCell(CELL.lattice, 1.5e-3, CELL.material)
    assert lower != whole
    assert key_of(gaps_key, (lower, ASKED)) != key_of(gaps_key, (whole, ASKED))


def test_shares_belong_to_the_order_of_their_paths():
    turned = with_field(BRIEF, "bounds", dict(reversed(BRIEF.bounds.items())))
    share = np.array([0.25, 0.5])
    assert content_key(look_task(BRIEF, share).key_inputs) != content_key(look_task(turned, share).key_inputs)


def test_results_of_two_questions_that_were_exchanged_are_not_believed(tmp_path):
    store, keys = Store(tmp_path), [content_key({"number": number}) for number in (1, 2)]
    for number, key in enumerate(keys):
        store.put(key, xr.Dataset(attrs={"number": number}))
    store.path(keys[0]).write_bytes(store.path(keys[1]).read_bytes())
    with pytest.warns(HaptonicWarning, match="has another key"):
        assert store.get(keys[0]) is None
    assert keys[0] not in store
    dataset = store.get(keys[1])
    assert dataset is not None
    assert dataset.attrs["number"] == 1
