"""Parities of modes under the mirrors of a wavevector's little group."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Literal

import numpy as np

from haptonic.arrays import Array, Complex, Ints
from haptonic.later import linalg as la
from haptonic.lattice import Operation, PointGroup

SAME = 1e-4  # modes closer than this share of their frequency are treated as one degenerate group


def mirrors_at(group: PointGroup, kappa: Array) -> dict[str, Operation]:
    """Reflections, by name, that leave a wavevector unchanged and distinguish its modes."""
    return group.little_group(kappa).distinct_mirrors


def clusters(frequency: Array) -> list[slice]:
    """Groups of degenerate neighbours; all rest modes are one group."""
    apart = np.diff(frequency) > np.maximum(SAME * frequency[1:], 3 * SAME * frequency[-1])
    ends = [0, *(int(g) + 1 for g in np.flatnonzero(apart)), len(frequency)]
    return [slice(a, b) for a, b in pairwise(ends)]


Waves = Literal["all", "symmetric", "antisymmetric"]  # about the plate's middle plane
WAVES: dict[int, Waves] = {1: "symmetric", -1: "antisymmetric"}  # by parity
MIDDLE = "+1 symmetric, -1 antisymmetric about the plate's middle plane, 0 if that is not a mirror"


def split_groups(groups: list[slice], middle: Ints) -> list[Ints]:
    """Numbers of the modes of each group that have one parity (k,) in the plate's middle plane."""
    number = np.arange(len(middle))
    return [number[group][middle[group] == parity] for group in groups for parity in np.unique(middle[group])]


def sorted_by_parity(trace: Complex, image: Complex, groups: Sequence[Ints]) -> tuple[Complex, Array]:
    """Turn degenerate modes so that each is even or odd.

    Parameters
    ----------
    trace : (t, k) traces of the modes on one cell, phases included
    image : images of these traces in a reflection of the wavevector's little group
    groups : numbers of the modes of each degenerate group

    Returns
    -------
    turn : (k, k) unitary, block diagonal in the groups; new modes = old modes @ turn
    parity : (k,) expectation of the reflection, +1 or -1 but for numerical error
    """
    turn = np.eye(trace.shape[1], dtype=complex)
    # of each mode alone; most groups contain one
    parity = np.einsum("tk,tk->k", trace.conj(), image).real / np.einsum("tk,tk->k", trace.conj(), trace).real
    for group in groups:
        if len(group) == 1:
            continue
        of_group = trace[:, group]
        overlap, norm = of_group.conj().T @ image[:, group], of_group.conj().T @ of_group
        values, vectors = la.eigh(0.5 * (overlap + overlap.conj().T), norm)
        order = np.argsort(-values)
        vectors = vectors[:, order]
        # eigh normalises traces; make the combinations of modes orthonormal
        turn[np.ix_(group, group)] = np.linalg.qr(vectors)[0]
        parity[group] = values[order]
    return turn, parity


MULLIKEN = {"x+ y+ d+": "A1", "x- y- d-": "A2", "x+ y+ d-": "B1", "x- y- d+": "B2"}


def corner_labels(trace: Complex, images: dict[str, Complex], groups: Sequence[Ints]) -> list[str]:
    """Labels of modes at a corner of the zone by their behaviour under the mirrors of its little group.

    A single mode is even (+) or odd (-) under each mirror, such as ``x+ y-``; with all mirrors of the square
    the irreducible representation is named too. A pair that the mirrors mix is ``E``.

    Parameters
    ----------
    trace : (t, k) traces of the modes; groups : numbers of the modes of each degenerate group
    images : images of the traces in the mirrors, by name, see `haptonic.lattice.PointGroup.mirrors`
    """
    labels = [""] * trace.shape[1]
    for group in groups:
        of_group = trace[:, group]
        norm = of_group.conj().T @ of_group
        # character of a reflection: its trace on the group, independent of the basis
        characters = {
            name: float(np.trace(la.solve(norm, of_group.conj().T @ image[:, group])).real)
            for name, image in images.items()
        }
        if of_group.shape[1] == 1:
            text = " ".join(f"{name}{'+' if value > 0 else '-'}" for name, value in characters.items())
            symbol = MULLIKEN.get(text)
            label = f"{symbol} ({text})" if symbol else text
        elif of_group.shape[1] == 2 and characters and all(abs(value) < 0.5 for value in characters.values()):
            label = "E"
        else:
            label = "several"
        for mode in group:
            labels[mode] = label
    return labels
