"""Waves of the cell of a study with NGSolve; see `ngsolve_discs`."""

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.bloch.wavevectors import wavevector_at
from peers.ngsolve_discs import PeerDisc, Solid, frequencies


def peer_frequencies(study: Any, at: str, count: int, order: int) -> NDArray[np.float64]:
    """The lowest frequencies, Hz, at a named wavevector of a square lattice with one stack or pillar."""
    cell = study.cell
    kappa, _ = wavevector_at(cell.zone, at)
    discs = _discs(cell)
    return frequencies(
        cell.lattice.period, cell.thickness, _constants(cell.material), discs, [tuple(kappa)], count,
        order=order, maxh=cell.thickness,
    )[0]  # fmt: skip


def _discs(cell: Any) -> list[PeerDisc]:
    """Discs and pillars with heights above the plate's lower face, on both faces where the cell has both."""
    if cell.pillar is None:
        discs = [
            PeerDisc.of(
                disc, cell.thickness, None if disc.empty else _constants(disc.material or cell.material)
            )
            for disc in cell.disc
        ]
    else:
        top = cell.thickness + cell.pillar.height
        solid = _constants(cell.pillar.material or cell.material)
        discs = [PeerDisc(cell.pillar.diameter, cell.thickness, top, solid)]
    if cell.faces == "both":
        turned = [(cell.thickness - disc.high, cell.thickness - disc.low) for disc in discs]
        discs += [replace(disc, low=low, high=high) for disc, (low, high) in zip(discs, turned, strict=True)]
    return discs


def _constants(solid: Any) -> Solid:
    stiffness = solid.stiffness
    return stiffness[0, 0], stiffness[0, 1], stiffness[3, 3], solid.density
