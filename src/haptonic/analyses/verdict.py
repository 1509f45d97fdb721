"""A measured response against the plate that a study describes, and the numbers that fit best."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from haptonic.analyses.analysis import Analysis, option
from haptonic.analyses.needs import fineness, response_settings
from haptonic.response import FrequencyResponse, read
from haptonic.results.judging import compute_verdict
from haptonic.results.runner import Runner
from haptonic.results.verdict import Verdict
from haptonic.study.schema import Description
from haptonic.units import format_quantity
from haptonic.updating.fit import Fit


def response_in(given: str) -> FrequencyResponse:
    """A response from its file."""
    return read(Path(given))


@dataclass(frozen=True)
class VerdictOptions:
    """What is compared: responses, or in Python also the paths of their files as text."""

    response: Any = option(
        help="response.nc that a scan has given.", read=response_in, metavar="RESPONSE", place="before"
    )
    computed: Any = option(
        None, "The model's response, if it is there already.", read=response_in, metavar="RESPONSE"
    )


def compute(study: Description, options: VerdictOptions, runner: Runner) -> Verdict:
    """The measurement beside its model, and the numbers of [[fit.vary]] fitted to it.

    Raises
    ------
    StudyError : no [plate], or nothing that drives it
    ScanError : a measurement that cannot be of this plate, or that no fit explains
    """
    return judged(study, options.response, options.computed, runner)


def judged(
    study: Description, scan: FrequencyResponse, computed: FrequencyResponse | None, runner: Runner
) -> Verdict:
    """See `compute`.

    Parameters
    ----------
    scan : response registered to the plate
    computed : response of this study's plate at lines and points of the scan; else it is computed
    """
    return compute_verdict(
        study.mounted_plate(),
        scan,
        study.fit_settings,
        tolerance=response_settings(study).tolerance,
        computed=computed,
        written=lambda fit: fitted_study(study, fit, scan),
        inputs=study.inputs(),
        fineness=fineness(study),
        progress=runner.progress,
    )


def fitted_study(study: Description, fit: Fit, scan: FrequencyResponse) -> str:
    """The study file with the numbers of a fit, and where they come from."""
    title, origin = scan.dataset.attrs["title"], scan.dataset.attrs["origin"]
    lines = [f"Numbers fitted to a {origin} response" + (f', "{title}":' if title else ":")]
    for one in fit.numbers:
        lines.append(f"{one.name}: {format_quantity(one.value, one.unit)}, 95 % interval: {one.range_text}")
    made = study.with_fitted({one.name: one.value for one in fit.numbers})
    head = [f"# {' '.join(line.splitlines())}" for line in lines]
    return "\n".join([*head, "", made.to_toml()])


ANALYSIS = Analysis(
    name="verdict",
    help="A response that a scan has given, once more against its plate's model: new unknowns, no records.",
    result=Verdict,
    compute=compute,
    options=VerdictOptions,
    doing="model",
)
