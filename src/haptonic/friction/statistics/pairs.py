"""Pairs of trials with the vibration on and off."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.errors import FrictionError
from haptonic.later import xarray as xr

Names = NDArray[np.str_]


@dataclass(frozen=True, eq=False)
class Pairs:
    """Pairs of trials on one waveguide: within a block, the first trial on and the first one off, and so on.

    waveguide : name
    participant : (pair,) names
    on, off : (pair,) coefficients of friction
    omitted : trials that were excluded or have no partner
    """

    waveguide: str
    participant: Names
    on: Array
    off: Array
    omitted: int

    @cached_property
    def people(self) -> tuple[str, ...]:
        """Names of the participants in the order of their first pair."""
        return tuple(dict.fromkeys(str(name) for name in self.participant))

    @cached_property
    def means(self) -> tuple[Array, Array]:
        """(participant,) mean friction on and off of each participant."""
        inside = [self.participant == name for name in self.people]
        return tuple(np.array([side[rows].mean() for rows in inside]) for side in (self.on, self.off))  # type: ignore[return-value]

    def of(self, participant: str) -> Pairs:
        """Pairs of one participant.

        Raises
        ------
        FrictionError : no pair of this participant
        """
        if participant not in self.people:
            cause = "the name is misspelt, or all trials were excluded"
            raise FrictionError.unknown("participant", participant, self.people, cause)
        rows = self.participant == participant
        return Pairs(self.waveguide, self.participant[rows], self.on[rows], self.off[rows], omitted=0)

    @property
    def reduction(self) -> float:
        """1 - mean on / mean off, with equal weight for every participant."""
        on, off = self.means
        return float(1 - on.mean() / off.mean())


def check_waveguide(argument: str, name: str, guides: Sequence[str]) -> None:
    """Raise FrictionError for a waveguide that is not among those of the trials."""
    if name not in guides:
        cause = "no trial was made there, or the name is misspelt"
        raise FrictionError.unknown(argument, name, guides, cause)


def paired(trials: xr.Dataset, waveguide: str) -> Pairs:
    """Make the pairs of a table of trials, such as that of `haptonic.friction.signals.measured`.

    A participant without a pair drops out; the trials are counted in ``omitted``.

    Raises
    ------
    FrictionError : a missing column, an unknown waveguide, or no pair
    """
    for name in ("participant", "block", "trial", "waveguide", "actuation", "friction", "excluded"):
        if name not in trials:
            raise FrictionError.mismatch(
                argument="trials",
                given=", ".join(str(name) for name in trials.data_vars) or "no columns",
                allowed=f"a table with the column {name}",
                cause="the table does not come from friction.signals",
                next_step="make it with signals.measured, or read it with signals.read_trials",
            )
    guides = list(dict.fromkeys(str(name) for name in trials["waveguide"].values))
    check_waveguide("waveguide", waveguide, guides)
    columns = {
        name: trials[name].values for name in ("participant", "block", "trial", "actuation", "friction")
    }
    here = trials["waveguide"].values == waveguide
    rows = sorted(np.flatnonzero(here), key=lambda row: int(columns["trial"][row]))
    usable = trials["excluded"].values == ""
    places: dict[tuple[str, int, int], dict[str, float]] = {}
    seen: dict[tuple[str, int, str], int] = {}
    for row in rows:
        person, block = str(columns["participant"][row]), int(columns["block"][row])
        side = str(columns["actuation"][row])
        rank = seen[person, block, side] = seen.get((person, block, side), 0) + 1
        pair = places.setdefault((person, block, rank), {})
        if usable[row]:
            pair[side] = float(columns["friction"][row])
    whole = {key: pair for key, pair in places.items() if len(pair) == 2}
    if not whole:
        sides = {str(columns["actuation"][row]) for row in rows}
        raise FrictionError.too_few(
            argument=f"trials on {waveguide}",
            given=f"{len(rows)} trials, {int(usable[rows].sum())} of them usable",
            allowed="at least one trial with the vibration on and one with it off in the same block",
            cause=f'all {len(rows)} trials are "{sides.pop()}"'
            if len(sides) == 1
            else "a condition is missing in every block, or all its trials were excluded",
            next_step="look at the column actuation, and at the reasons for exclusion",
        )
    return Pairs(
        waveguide=waveguide,
        participant=np.array([person for person, _, _ in whole]),
        on=np.array([pair["on"] for pair in whole.values()]),
        off=np.array([pair["off"] for pair in whole.values()]),
        omitted=len(rows) - 2 * len(whole),
    )
