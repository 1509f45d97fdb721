"""A plate like the prototype and its simulated vibration: sines in WG1, or everywhere outside of the gap."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from haptonic.cell import Pillar, UnitCell
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.parts import Actuator, Finger, Force, Plate
from haptonic.plate.layout.supports import Support
from haptonic.response import FrequencyResponse

GAP = (52.5e3, 60.2e3)
LINES = np.array([45e3, 58.8e3, 70e3])
ALUMINIUM = material("aluminium-2017a")
CELL = UnitCell(Lattice.square(7e-3), 1.5e-3, ALUMINIUM, Pillar(3.5e-3, 14.7e-3))


def prototype(rows: int = 20) -> Layout:
    """Three columns of cells, a waveguide of four tiles, three columns, a waveguide, three columns."""
    widths = [7e-3] * 3 + [8e-3] * 4 + [7e-3] * 3 + [8e-3] * 4 + [7e-3] * 3
    row = ("lattice",) * 3 + ("WG1",) * 4 + ("lattice",) * 3 + ("WG2",) * 4 + ("lattice",) * 3
    x = (0.0, *np.cumsum(widths).tolist())
    y = tuple((7e-3 * np.arange(rows + 1)).tolist())
    return Layout((row,) * rows, x, y, {"lattice": CELL}, 1.5e-3, ALUMINIUM)


def notched() -> Layout:
    """A corner is missing; one region has the form of an L; square pillars."""
    cell = UnitCell(Lattice.square(10e-3), 2e-3, ALUMINIUM, Pillar(5e-3, 8e-3, section="square"))
    tiles = (
        ("pad", "pad", "pad", "a"),
        ("pad", "a", "a", "a"),
        ("pad", "a", None, None),
    )
    lines = tuple((10e-3 * np.arange(5)).tolist())
    return Layout(tiles, lines, lines[:4], {"a": cell}, 2e-3, ALUMINIUM)


def plate() -> Plate:
    patch = Actuator("A1", (37e-3, 17.5e-3), (11.5e-3, 8e-3, 0.7e-3), material("pzt-4"), None)
    corners = Support("corners", "clamped", length=7e-3)
    return Plate(prototype(), supports=(corners,), actuators=(patch,))


def busy_plate() -> Plate:
    other = replace(plate().actuators[0], name="A2", centre=(90e-3, 120e-3))
    return Plate(
        prototype(),
        supports=(Support("left", "simple"), Support("top", "spring", stiffness=1e9), *plate().supports),
        actuators=(*plate().actuators, other),
        forces=(Force("F1", (90e-3, 50e-3), None), Force("F2", (30e-3, 60e-3), (6e-3, 4e-3))),
        finger=Finger((40e-3, 90e-3), 10e-3, 1e-3, 1e3, 1.0),
    )


def vibration(origin: str = "simulated") -> FrequencyResponse:
    """On the 2 mm grid: the whole plate below and above the gap, in the gap WG1 with nodes 8 mm apart."""
    x, y = (along.ravel() for along in np.meshgrid(np.arange(64) * 2e-3, np.arange(71) * 2e-3))
    inside = {"WG1": (x > 21e-3) & (x < 53e-3), "WG2": (x > 74e-3) & (x < 106e-3)}
    guided = np.sin(np.pi * (x - 21e-3) / 32e-3) * np.sin(np.pi * 17 * y / 140e-3) * inside["WG1"]
    leak = 0.02 * np.cos(400 * x) * np.cos(390 * y)
    values = np.stack([
        np.cos(2 * np.pi * x / 21e-3) * np.cos(2 * np.pi * y / 18e-3) * (0.4 + inside["WG1"]),
        guided + leak,
        np.cos(2 * np.pi * x / 15e-3) * np.cos(2 * np.pi * y / 14e-3),
    ]) * np.array([2e-5, 3e-4, 4e-5])[:, None] * np.exp(0.8j)  # fmt: skip
    region = np.select(list(inside.values()), list(inside), "")
    return FrequencyResponse.of(
        values[..., None], frequency=LINES, x=x, y=y, reference="A1, V", origin=origin,
        region=region.tolist(),
    )  # fmt: skip


def turned(degrees: float = 4.0) -> FrequencyResponse:
    """A slope along x and one along y, seen on a grid of 2 mm that is turned against the plate."""
    turn = np.exp(1j * np.radians(degrees))
    grid = turn * np.add.outer(1j * np.arange(-20, 160, 2) * 1e-3, np.arange(-20, 150, 2) * 1e-3).ravel()
    x, y = grid.real, grid.imag
    on = (x > 0) & (x < 127e-3) & (y > 0) & (y < 140e-3)
    values = np.stack([x[on] + 0j, 1j * y[on]])
    return FrequencyResponse.of(
        values[..., None], frequency=np.array([1e3, 2e3]), x=x[on].copy(), y=y[on].copy(),
        reference="A1, V", origin="simulated",
    )  # fmt: skip
