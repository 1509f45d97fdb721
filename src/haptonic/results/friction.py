"""Friction trials from force records: trials, conditions, tests, localisation."""

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
from haptonic.results.friction_view import friction_view
from haptonic.results.plain import determined, plain, split
from haptonic.results.quality import quality
from haptonic.results.result import Result, figure, file, page
from haptonic.results.table import Table
from haptonic.views import InteractiveView

PARTS = ("mean", "sd")
MOST_SHEETS = 60  # blocks that are drawn trial by trial


@dataclass(frozen=True, eq=False, repr=False)
class FrictionResult(Result):
    """Trials with exclusions and their reasons, and the statistics.

    source : folder or table of the records; sensor, rules : settings of the evaluation
    trials : see `haptonic.friction.signals.measured`; guessed : assumptions that the files do not confirm
    doubts : possible errors of the records, and corrections of them
    found : results of the statistics
    published : published reductions "driven" and "idle" and share "stopped", for comparison in pictures
    interactive : whether the interactive page is among its files
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
    interactive: bool = False

    @classmethod
    def names(cls, options: Any = None) -> list[Any]:
        """Names of all files; a draft of the table of trials writes none of them."""
        return [] if getattr(options, "draft", False) else super().names(options)

    @property
    def dataset(self) -> xr.Dataset:
        """All trials."""
        return self.trials

    @property
    def origin(self) -> str:
        """ "measured", or "simulated" if any trial is simulated."""
        return str(self.trials.attrs.get("origin", "measured"))

    @property
    def excluded(self) -> dict[str, int]:
        """Number of excluded trials, by reason."""
        return {reason: count for reason, count in exclusions(self.trials).items() if count}

    @file("trials.nc", "trials.csv")
    def _write_trials(self, path: Path) -> None:
        write_trials(self.trials, path)

    @file("conditions.csv")
    def _write_conditions(self, path: Path) -> None:
        _write_rows([plain(condition) for condition in self.found.conditions], self.origin, path)

    @file("tests.csv")
    def _write_tests(self, path: Path) -> None:
        _write_rows([plain(test) for test in (*self.found.tests, *self.found.each)], self.origin, path)

    @file("quality.html")
    def _write_quality(self, path: Path) -> None:
        path.write_text(quality(self), encoding="utf-8")

    _page = page("friction.html")

    def view(self) -> InteractiveView | None:
        """Interactive view of the estimates; None if it was not asked for."""
        return friction_view(self) if self.interactive else None

    @figure("conditions", "{Origin} friction of the conditions, mean and one standard deviation over trials.")
    def _conditions(self, *, ax: Axes | None = None) -> Figure:
        return plots.conditions(self.found.conditions, origin=self.origin, ax=ax)

    @figure(
        "reductions",
        "{Origin} reductions with 95 % intervals: for the population, and for each participant.",
    )
    def _reductions(self, *, ax: Axes | None = None) -> Figure:
        summary = self.found
        roles = {guide: "driven" if guide == summary.driven else "idle" for guide in summary.reductions}
        published = {guide: self.published[role] for guide, role in roles.items() if role in self.published}
        return plots.reductions(
            summary.reductions, summary.own, origin=self.origin, published=published, ax=ax
        )

    def summary(self) -> list[str]:
        return reported(self)

    def remarks(self) -> list[str]:
        return [*self.doubts, *self.found.omissions]

    def tables(self) -> list[Table]:
        excluded = [excluded_table(self)] if self.excluded else []
        return [conditions_table(self), *tests_tables(self), *excluded]

    def blocks(self) -> tuple[list[tuple[str, int]], int]:
        """Blocks (participant, number) to be drawn trial by trial, and the number of the others.

        If there are more than `MOST_SHEETS`, those with the most excluded trials are drawn.
        """
        columns = [self.trials[name].values.tolist() for name in ("participant", "block", "excluded")]
        every = Counter({(person, block): 0 for person, block, _ in zip(*columns, strict=True)})
        every.update((person, block) for person, block, reason in zip(*columns, strict=True) if reason)
        chosen = {key for key, _ in every.most_common(MOST_SHEETS)}
        return [key for key in every if key in chosen], len(every) - len(chosen)

    def sheets(self, blocks: Sequence[tuple[str, int]]) -> Iterator[tuple[str, int, Figure]]:
        """Every trial of some blocks as a small plot; the files are read again."""
        trials = self.trials
        for person, block, drawn in traces(self.source, self.sensor, self.rules, blocks):
            here = (trials["participant"].values == person) & (trials["block"].values == block)
            yield person, block, plots.trial_sheet(trials.isel(stroke=here), drawn, origin=self.origin)

    def facts(self) -> dict[str, Any]:
        summary, trials = self.found, self.trials
        named = ["participant", "block", "trial", "waveguide", "actuation", "excluded", "detail"]
        left_out = trials[named].isel(stroke=trials["excluded"].values != "")
        reported = {
            "trials": trials.sizes["stroke"],
            "excluded": split(left_out.reset_coords(), "stroke"),
            "exclusions": self.excluded,
            "remarks": self.guessed,
            "doubts": self.doubts,
            "omissions": summary.omissions,
            "driven": summary.driven,
            "driven_chosen": summary.chosen,
            "conclusions": summary.conclusions,
            "conditions": summary.conditions,
            "tests": (*summary.tests, *summary.each),
            "reduction": summary.reductions,
            "averages": AVERAGES,
            "own_reduction": [
                {"waveguide": guide, "participant": name, **plain(estimate)}
                for (guide, name), estimate in summary.own.items()
            ],
            "stopped": summary.stopped,
            "stopped_here": summary.stopped_here,
            "equivalence": summary.equivalences,
            "drift": summary.drift,
        }
        return {name: determined(plain(value)) for name, value in reported.items()}


def _write_rows(rows: list[dict[str, Any]], origin: str, path: Path) -> None:
    """Write a CSV table; a pair (mean, standard deviation) becomes two columns, each row has its origin."""
    flat = []
    for row in rows:
        pairs = {name: value for name, value in row.items() if isinstance(value, list)}
        plain = {name: value for name, value in row.items() if name not in pairs}
        plain |= {f"{name}_{part}": value[k] for name, value in pairs.items() for k, part in enumerate(PARTS)}
        flat.append({name: cell(value) for name, value in plain.items()} | {"origin": origin})
    pd.DataFrame(flat).to_csv(path, index=False)
