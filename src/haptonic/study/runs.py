"""The study: a description with methods that compute."""

from __future__ import annotations

import html
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from haptonic.analyses import NAMES, named
from haptonic.analyses.runner import Runner
from haptonic.errors import StudyError
from haptonic.fields import caller, extended, remade, warn_caller
from haptonic.fields.keys import slots
from haptonic.progress import Progress, in_notebook
from haptonic.results.plan import sentence_of
from haptonic.results.result import Result
from haptonic.store import Store
from haptonic.study.computing import AnalysisMethod
from haptonic.study.loading import load_as, load_trials_as, loads_as
from haptonic.study.schema import Description
from haptonic.study.trial_tables import TrialSettings

if TYPE_CHECKING:  # this module exists only as a stub, written from the table of analyses
    from haptonic.study.methods import Methods
else:
    Methods = object


@extended
class Study(Description, Methods):
    """Contents of a study file, with a method for each analysis.

    `haptonic.study.load` reads it. The methods are those of the table in `haptonic.analyses`, such as
    ``study.bands(surface=True)`` and ``study.plate(at="58.8 kHz")``, with the options of the command and of
    `run`.
    """

    def run(
        self,
        name: str,
        *unnamed: object,
        store: Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: Progress | None = None,
        budget: float | str | None = None,
        **options: Any,
    ) -> Result:
        """Compute the analysis of this name and return its result.

        Parameters
        ----------
        store : store of results; by default that of the user
        workers, scheduler : see `haptonic.jobs.run_all`
        progress : called with the steps done and planned; by default a notebook shows a bar
        budget : estimated processor time for the meshes of each cell, "10 min" or s; by default the study's
        options : options of the command; positional arguments (``unnamed``) are refused

        Raises
        ------
        StudyError : an unknown analysis or option, or missing inputs in the study
        """
        if unnamed:
            raise named(name).by_name_only(unnamed[0])
        with in_notebook(name) if progress is None else nullcontext(progress) as callback:
            runner = Runner(Store.default() if store is None else store, workers, scheduler, callback)
            return named(name).run(self.within(budget), runner, options)

    def replace(self, **changes: Any) -> Self:
        """The study with other tables and keys at the top of its file, and without sweeps: one design.

        ``study.replace(material="silicon", cell={"pitch": "6 mm", "thickness": "1 mm"})``

        Parameters
        ----------
        changes : as for a new study: numbers in SI, texts with units, whole tables, or values such as a
            `UnitCell`; `with_keys` changes single keys of a table

        Raises
        ------
        StudyError : an unknown key, a value that is not allowed, or an impossible study
        """
        design = self.with_parameters({})
        cell = changes.get("cell", design.cell)
        is_table = not isinstance(cell, type(design.cell))
        if is_table:
            changes = {"material": design.cell.material} | changes
        elif "material" in changes:
            changes |= {"cell": remade(cell, material=changes.pop("material"))}
        kept = {slot.key: getattr(design, slot.name) for slot in slots(type(design))}
        changed = type(design)(**kept | changes)
        warn_caller(changed._slips(), caller())
        return changed

    def __repr__(self) -> str:
        sentence = sentence_of(self.title, self.cell, self.carrier)
        return f"<{sentence}>" if sentence.startswith("Study: ") else f"<Study: {sentence}>"

    def _repr_html_(self) -> str:
        """HTML for a notebook: a sentence, and below it the text of the study file."""
        summary = f"<p>{html.escape(sentence_of(self.title, self.cell, self.carrier))}</p>"
        try:
            text = self.to_toml()
        except StudyError:  # a material that cannot be written to a file
            return summary
        return f"{summary}<details><summary>study file</summary><pre>{html.escape(text)}</pre></details>"


for _name in NAMES:  # after the class statement, so that methods do not become fields of the study
    setattr(Study, _name.replace(" ", "_"), AnalysisMethod(_name, Study.run))


def load(path: str | Path) -> Study:
    """Read a study from its file or from a result, ``bands.nc``; see `haptonic.study.loading.load_as`."""
    return load_as(path, Study)


def loads(text: str, origin: str = "study") -> Study:
    """Read a study from text; ``origin`` is its name in errors and warnings. Otherwise as `load`."""
    return loads_as(text, Study, origin)


def load_trials(path: str | Path) -> tuple[TrialSettings, Study | None]:
    """The table [trials] of a study file, and the study; None for a file without other tables."""
    return load_trials_as(path, Study)
