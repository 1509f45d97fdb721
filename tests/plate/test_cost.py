"""What cannot be computed here is reported before anything is computed."""

from __future__ import annotations

import re
import warnings
from pathlib import Path
from types import SimpleNamespace
from typing import NoReturn

import pytest
from hypothesis import given, settings, strategies as st

from daily import daily
from haptonic.bloch.resolution import Resolution
from haptonic.errors import HaptonicWarning, ResourceError
from haptonic.plate.body.reduction import BLOCK, STEPS
from haptonic.store import Store
from haptonic.study import loads
from pace import within
from quick import PROTOTYPE

STUDY = (
    PROTOTYPE
    + '''
[plate]
map = """
{line}
"""
rows = {rows}
[plate.tiles]
o = "lattice"
1 = "G"
[plate.response]
grid = "{grid} m"
[[plate.force]]
region = "G"
name = "F1"
centre = ["1 mm", "1 mm"]
force = "1 N"
'''
)


class Stopping(Store):
    """Work begins where the store is asked whether it is done already, and ends there."""

    def get(self, key: str) -> NoReturn:
        raise KeyboardInterrupt


STORE = Stopping(Path("nowhere"))
ASKS = {
    "a band": lambda study: study.plate(store=STORE),
    "one frequency": lambda study: study.plate(at=58e3, store=STORE),
    "a finger": lambda study: study.feel(store=STORE),
    "a finger at one frequency": lambda study: study.feel(at=58e3, store=STORE),
}
MEMORY = SimpleNamespace(total=24e9, available=20e9)


@pytest.fixture(scope="module", autouse=True)
def imported() -> None:
    """What the first question of a process imports is no part of its answer."""
    with pytest.warns(HaptonicWarning, match="unusual"):
        study = loads(STUDY.format(line="ooo1", rows=4, grid=1e-9))
    for ask in ASKS.values():
        with pytest.raises(ResourceError):
            ask(study)


@pytest.mark.parametrize("asked", daily(ASKS, "a band", "a finger at one frequency"))
@settings(max_examples=2, deadline=None)
@given(grid=st.sampled_from([1e-9, 1e-7, 1e-5, 2e-3]), rows=st.integers(3, 220), columns=st.integers(3, 220))
def test_it_is_refused_at_once_or_begun(asked: str, grid: float, rows: int, columns: int) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of a fine grid
        study = loads(STUDY.format(line="o" * (columns - 1) + "1", rows=rows, grid=grid))
    with pytest.MonkeyPatch.context() as patch, within(2.0):
        patch.setattr("psutil.virtual_memory", lambda: MEMORY)
        with pytest.raises((ResourceError, KeyboardInterrupt)) as caught:
            ASKS[asked](study)
    begun = isinstance(caught.value, KeyboardInterrupt)
    if isinstance(caught.value, ResourceError):
        assert caught.value.argument in ("plate.response.grid", "plate.map")
        assert all(caught.value.parts().values())
    most = 24e9 / 0.8e6 if asked == "one frequency" else 3000
    heavy = grid < 1e-4 or rows * columns > most
    light = grid > 1e-4 and rows * columns < most / 3
    assert not (heavy and begun)
    assert not light or begun


@pytest.mark.parametrize("asked", daily(["a band", "one frequency", "a finger"], "one frequency", "a finger"))
@given(order=st.integers(2, 10), rings=st.integers(0, 4), free=st.floats(1e9, 40e9))
@settings(max_examples=8, deadline=None)
def test_a_mesh_that_somebody_chose_is_held_or_refused_with_one_that_is(
    asked: str, order: int, rings: int, free: float
) -> None:
    """For the bands of its cell and for the plate alike."""
    text = STUDY.format(line="oo1", rows=3, grid=2e-3) + "[mesh]\norder = {}\nfoot_rings = {}\n"

    def outcome(tried: int) -> BaseException:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr("psutil.virtual_memory", lambda: SimpleNamespace(total=1e12, available=free))
            with pytest.raises((ResourceError, KeyboardInterrupt)) as caught:
                ASKS[asked](loads(text.format(tried, rings)))
        return caught.value

    cell = loads(text.format(order, rings)).cell
    error = outcome(order)
    needed = Resolution(order, rings, STEPS, BLOCK).memory(cell)
    if isinstance(error, KeyboardInterrupt):
        assert needed < 1.1 * free
        return
    assert isinstance(error, ResourceError)
    assert error.argument == "mesh"
    assert f"order = {order}" in error.given
    assert 0.9 * free < needed
    if advised := re.search(r"order = (\d+)", error.next_step):
        assert not isinstance(outcome(int(advised[1])), ResourceError)
