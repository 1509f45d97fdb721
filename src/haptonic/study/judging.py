"""A measurement against the plate that a study describes, and the study with the numbers that fit best."""

from __future__ import annotations

from collections.abc import Callable

from haptonic.response import FrequencyResponse
from haptonic.results import Verdict, VerdictQuestion, compute_verdict
from haptonic.study.runs import Study
from haptonic.units import format_quantity
from haptonic.updating.fit import Fit


def judged(
    study: Study,
    scan: FrequencyResponse,
    *,
    computed: FrequencyResponse | None = None,
    said: Callable[[str], None] = lambda words: None,
) -> Verdict:
    """A measurement of the plate beside its model, and the numbers of [[fit.vary]] fitted to it.

    Parameters
    ----------
    scan : response registered to the plate
    computed : response of this study's plate at lines and points of the scan; else it is computed
    said : called with words on what is done

    Raises
    ------
    StudyError : no [plate], or nothing that drives it
    ScanError : a measurement that cannot be of this plate, or that no fit explains
    """
    plate, section, asked = study.mounted_plate(), study.finite_plate, study.fit_settings
    assert section is not None
    question = VerdictQuestion(
        asked.lowest, asked.highest, section.response.tolerance, asked.unknowns, asked.points
    )
    return compute_verdict(
        plate, scan, question, computed=computed, written=lambda fit: _text(study, fit, scan),
        inputs=study.inputs(), fineness=study.fineness(), said=said,
    )  # fmt: skip


def _text(study: Study, fit: Fit, scan: FrequencyResponse) -> str:
    """The study with the numbers of a fit, and where they come from."""
    title, origin = scan.dataset.attrs["title"], scan.dataset.attrs["origin"]
    lines = [f"Numbers fitted to a {origin} response" + (f', "{title}":' if title else ":")]
    for one in fit.numbers:
        lines.append(f"{one.name}: {format_quantity(one.value, one.unit)}, 95 % interval: {one.told}")
    made = study.with_fitted({one.name: one.value for one in fit.numbers})
    head = [f"# {' '.join(line.splitlines())}" for line in lines]
    return "\n".join([*head, "", made.to_toml()])
