"""What force records of people who stroke a plate say: trials, conditions, tests, localisation."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from haptonic import plots
from haptonic.friction.phrases import AVERAGES
from haptonic.friction.recordings import Sensor, traces
from haptonic.friction.signals import Rules, exclusions, write_trials
from haptonic.friction.statistics.summary import Summary
from haptonic.later import Axes, Figure, pandas as pd, xarray as xr
from haptonic.names import cell
from haptonic.results.friction_tables import conditions_table, excluded_table, reported, tests_tables
from haptonic.results.plain import determined, plain, split
from haptonic.results.quality import quality
from haptonic.results.result import Result, figure, file
from haptonic.results.table import Table

PARTS = ("mean", "sd")
MOST_SHEETS = 60  # blocks that are drawn trial by trial


@dataclass(frozen=True, eq=False, repr=False)
class FrictionResult(Result):
    """Trials with all that was left out and why, and what they prove.

    source : folder or table that was read; sensor, rules : how
    trials : see `haptonic.friction.signals.measured`; guessed : what the files did not say
    doubts : what may be wrong with the records, or was done to them
    found : everything that the statistics say
    published : reductions, "driven" and "idle", and the share "stopped", that stand beside ours in pictures
    """

    title = "Friction trials"

    source: Path
    sensor: Sensor
    rules: Rules
    trials: xr.Dataset
    guessed: tuple[str, ...]
    found: Summary
    published: Mapping[str, float] = field(default_factory=dict)
    doubts: tuple[str, ...] = ()

    @classmethod
    def names(cls, options: Any = None) -> list[Any]:
        """Of all files; a draft of the table of trials writes none of them."""
        return [] if getattr(options, "draft", False) else super().names(options)

    @property
    def dataset(self) -> xr.Dataset:
        """Every trial."""
        return self.trials

    @property
    def origin(self) -> str:
        """ "measured", or "simulated" if any trial is."""
        return str(self.trials.attrs.get("origin", "measured"))

    @property
    def excluded(self) -> dict[str, int]:
        """How many trials were left out, by reason."""
        return {reason: count for reason, count in exclusions(self.trials).items() if count}

    @file("trials.nc", "trials.csv")
    def _write_trials(self, path: Path) -> None:
        write_trials(self.trials, path)

    @file("conditions.csv")
    def _write_conditions(self, path: Path) -> None:
        _write_rows([plain(one) for one in self.found.conditions], self.origin, path)

    @file("tests.csv")
    def _write_tests(self, path: Path) -> None:
        _write_rows([plain(one) for one in (*self.found.tests, *self.found.each)], self.origin, path)

    @file("quality.html")
    def _write_quality(self, path: Path) -> None:
        path.write_text(quality(self), encoding="utf-8")

    @figure("conditions", "{Origin} friction of the conditions, mean and one standard deviation over trials.")
    def _conditions(self, *, ax: Axes | None = None) -> Figure:
        return plots.conditions(self.found.conditions, origin=self.origin, ax=ax)

    @figure(
        "reductions",
        "{Origin} reductions with 95 % intervals: of people in general, and of each participant.",
    )
    def _reductions(self, *, ax: Axes | None = None) -> Figure:
        found = self.found
        roles = {guide: "driven" if guide == found.driven else "idle" for guide in found.reductions}
        published = {guide: self.published[role] for guide, role in roles.items() if role in self.published}
        return plots.reductions(found.reductions, found.own, origin=self.origin, published=published, ax=ax)

    def summary(self) -> list[str]:
        return reported(self)

    def remarks(self) -> list[str]:
        return [*self.doubts, *self.found.omissions]

    def tables(self) -> list[Table]:
        excluded = [excluded_table(self)] if self.excluded else []
        return [conditions_table(self), *tests_tables(self), *excluded]

    def blocks(self) -> tuple[list[tuple[str, int]], int]:
        """Blocks (participant, number) that are drawn trial by trial, and how many are not.

        If there are too many, those with the most excluded trials come first.
        """
        columns = [self.trials[name].values.tolist() for name in ("participant", "block", "excluded")]
        every = Counter({(person, block): 0 for person, block, _ in zip(*columns, strict=True)})
        every.update((person, block) for person, block, reason in zip(*columns, strict=True) if reason)
        chosen = {key for key, _ in every.most_common(MOST_SHEETS)}
        return [key for key in every if key in chosen], len(every) - len(chosen)

    def sheets(self, blocks: Sequence[tuple[str, int]]) -> Iterator[tuple[str, int, Figure]]:
        """Every trial of some blocks as a small plot; the files are read again for it."""
        trials = self.trials
        for person, block, drawn in traces(self.source, self.sensor, self.rules, blocks):
            here = (trials["participant"].values == person) & (trials["block"].values == block)
            yield person, block, plots.trial_sheet(trials.isel(stroke=here), drawn, origin=self.origin)

    def facts(self) -> dict[str, Any]:
        found, trials = self.found, self.trials
        named = ["participant", "block", "trial", "waveguide", "actuation", "excluded", "detail"]
        left_out = trials[named].isel(stroke=trials["excluded"].values != "")
        reported = {
            "trials": trials.sizes["stroke"],
            "excluded": split(left_out.reset_coords(), "stroke"),
            "exclusions": self.excluded,
            "remarks": self.guessed,
            "doubts": self.doubts,
            "omissions": found.omissions,
            "driven": found.driven,
            "driven_chosen": found.chosen,
            "conclusions": found.conclusions,
            "conditions": found.conditions,
            "tests": (*found.tests, *found.each),
            "reduction": found.reductions,
            "averages": AVERAGES,
            "own_reduction": [
                {"waveguide": guide, "participant": name, **plain(one)}
                for (guide, name), one in found.own.items()
            ],
            "stopped": found.stopped,
            "stopped_here": found.stopped_here,
            "equivalence": found.equivalences,
            "drift": found.drift,
        }
        return {name: determined(plain(one)) for name, one in reported.items()}


def _write_rows(rows: list[dict[str, Any]], origin: str, path: Path) -> None:
    """A CSV table; a pair (mean, standard deviation) becomes two columns, and each row says its origin."""
    flat = []
    for row in rows:
        pairs = {name: value for name, value in row.items() if isinstance(value, list)}
        plain = {name: value for name, value in row.items() if name not in pairs}
        plain |= {f"{name}_{part}": value[k] for name, value in pairs.items() for k, part in enumerate(PARTS)}
        flat.append({name: cell(value) for name, value in plain.items()} | {"origin": origin})
    pd.DataFrame(flat).to_csv(path, index=False)
