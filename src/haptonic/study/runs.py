"""The study: a description that can be asked to compute."""

from __future__ import annotations

import html
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Any

from haptonic.analyses import NAMES, named
from haptonic.analyses.runner import Runner
from haptonic.errors import StudyError
from haptonic.fields import extended
from haptonic.progress import Progress, in_notebook
from haptonic.results.plan import sentence_of
from haptonic.results.result import Result
from haptonic.store import Store
from haptonic.study.computing import AnalysisMethod
from haptonic.study.loading import load_as, load_trials_as, loads_as
from haptonic.study.schema import Description
from haptonic.study.trial_tables import TrialSettings

if TYPE_CHECKING:  # there is no such module: its stub follows from the table of analyses
    from haptonic.study.methods import Methods
else:
    Methods = object


@extended
class Study(Description, Methods):
    """What a study file describes, and all that can be computed from it.

    It is read by `haptonic.study.load`. What can be computed stands in the table of `haptonic.analyses`: each
    of them is a method too, ``study.bands(surface=True)``, ``study.plate(at="58.8 kHz")``, with the options
    of its command and those of `run`.
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
        """Compute the analysis of this name; the result holds all of the answer.

        Parameters
        ----------
        store : where results are kept; the user's own by default
        workers, scheduler : see `haptonic.jobs.run_all`
        progress : called with what is done and what is planned; by default a notebook shows a bar
        budget : "10 min", or s, of estimated processor time for the meshes of each cell; else the study's own
        options : those of its command; ``unnamed`` ones are refused

        Raises
        ------
        StudyError : there is no such analysis or option, or the study lacks what it needs
        """
        if unnamed:
            raise named(name).by_name_only(unnamed[0])
        with in_notebook(name) if progress is None else nullcontext(progress) as told:
            runner = Runner(Store.default() if store is None else store, workers, scheduler, told)
            return named(name).run(self.within(budget), runner, options)

    def __repr__(self) -> str:
        return f"<Study: {sentence_of(self.title, self.cell, self.carrier)}>"

    def _repr_html_(self) -> str:
        """What a notebook shows: a sentence, and below it the file that the study would be."""
        said = f"<p>{html.escape(sentence_of(self.title, self.cell, self.carrier))}</p>"
        try:
            written = self.to_toml()
        except StudyError:  # a material that no file describes
            return said
        return f"{said}<details><summary>study file</summary><pre>{html.escape(written)}</pre></details>"


for _name in NAMES:  # after the class is made: these are methods and no fields of a declared value
    setattr(Study, _name.replace(" ", "_"), AnalysisMethod(_name, Study.run))


def load(path: str | Path) -> Study:
    """Read a study file; see `haptonic.study.loading.load_as`."""
    return load_as(path, Study)


def loads(text: str, origin: str = "study") -> Study:
    """Read a study from text; ``origin`` is how errors and warnings call it. Otherwise as `load`."""
    return loads_as(text, Study, origin)


def load_trials(path: str | Path) -> tuple[TrialSettings, Study | None]:
    """The table [trials] of a study file, and the study; of a file with nothing else there is no study."""
    return load_trials_as(path, Study)
