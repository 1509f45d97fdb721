"""Computation of the quantities of a case, from study to bands, and their comparison with the reference."""

from __future__ import annotations

import warnings
from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array
from haptonic.errors import HaptonicWarning, StudyError
from haptonic.results.bands import Bands
from haptonic.store import Store
from haptonic.study import Study, case_templates, loads
from haptonic.verification.catalogue import Case, CaseQuantity, OtherStudy


@dataclass(frozen=True, eq=False)
class CaseComparison:
    """A quantity of a case, with its reference.

    reference, reference_error : (values,) in the SI unit
    computed, computed_error : (variants, values); one variant for a case without variations
    """

    case: Case
    quantity: CaseQuantity
    reference: Array
    reference_error: Array
    computed: Array
    computed_error: Array

    @property
    def difference(self) -> float:
        """The largest relative difference; from the nearest variant where a case has several."""
        return float(np.abs(self._distance / self._scale).max())

    @property
    def signed_difference(self) -> float:
        """The relative difference with its sign, positive where haptonic's value is larger."""
        largest = int(np.abs(self._distance / self._scale).argmax())
        return float((self._distance / self._scale)[largest])

    @property
    def allowed(self) -> float:
        """The relative difference that both errors and the tolerance allow, at the largest difference."""
        largest = int(np.abs(self._distance / self._scale).argmax())
        return float((self._allowed / self._scale)[largest])

    @property
    def agrees(self) -> bool:
        """True if every value lies within both errors and the tolerance of its reference."""
        return bool((np.abs(self._distance) <= self._allowed).all())

    @property
    def _scale(self) -> Array:
        # frequencies of rigid motions are 0, so they are compared with the largest value
        size = np.abs(self.reference)
        return np.asarray(np.where(size > 1e-3 * size.max(), size, size.max()))

    @property
    def _distance(self) -> Array:
        """(values,) from the reference to the nearest point of the range of all variants."""
        nearest = np.clip(self.reference, self.computed.min(axis=0), self.computed.max(axis=0))
        return np.asarray(nearest - self.reference)

    @property
    def _allowed(self) -> Array:
        errors = self.computed_error.max(axis=0) + self.reference_error
        return np.asarray(errors + self.quantity.tolerance * self._scale)


def compare_case(case: Case, store: Store | None = None) -> list[CaseComparison]:
    """Compute a case, with results from the store if they were computed before.

    Raises
    ------
    StudyError : the study has no complete gap although a quantity needs one
    """
    study = load_case_study(case.study)
    variants = [study.with_keys(change) for change in case.vary] or [study]
    comparisons = []
    for quantity in case.quantity:
        computed = [_measured(variant, quantity, store) for variant in variants]
        if quantity.other is None:
            reference = np.array(quantity.published_values)
            error = np.zeros_like(reference)
        else:
            reference, error = _of_other(study, quantity, quantity.other, store)
        comparisons.append(
            CaseComparison(
                case=case,
                quantity=quantity,
                reference=reference,
                reference_error=error + np.array(quantity.uncertainty) * np.abs(reference),
                computed=np.array([values for values, _ in computed]),
                computed_error=np.array([errors for _, errors in computed]),
            )
        )
    return comparisons


def _of_other(
    study: Study, quantity: CaseQuantity, other: OtherStudy, store: Store | None
) -> tuple[Array, Array]:
    """Values and errors of the second study, sorted if they come from several wavevectors."""
    if other.study:
        study = load_case_study(other.study)
    changed = study.with_keys(other.change) if other.change else study
    parts = [
        _measured(changed, quantity.model_copy(update={"at": at, "bands": other.bands}), store)
        for at in other.at or (quantity.at,)
    ]
    values, errors = (np.concatenate(arrays) for arrays in zip(*parts, strict=True))
    order = np.argsort(values, kind="stable")
    count = len(quantity.bands) or len(values) // len(parts)
    return other.factor * values[order][:count], other.factor * errors[order][:count]


def load_case_study(name: str) -> Study:
    """Load the study of a case, without warnings on its unusual numbers."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", HaptonicWarning)
        return loads(case_templates()[name], name)


def _measured(study: Study, quantity: CaseQuantity, store: Store | None) -> tuple[Array, Array]:
    """(values,) of a quantity in SI units, and the bounds of their errors."""
    bands = study.run("bands", store=store, modes_at=quantity.at or None)
    assert isinstance(bands, Bands)
    if quantity.measure == "frequencies":
        chosen = [band - 1 for band in quantity.bands] or slice(None)
        data = bands.dataset
        return data["mode_frequency"].values[chosen], data["mode_error"].values[chosen]
    gaps = [gap for gap in bands.gaps if gap.complete]
    if not gaps:
        raise StudyError.missing(
            argument=study.title,
            given="no complete gap",
            allowed="a study with a complete gap, for its edges",
            cause="the study was changed, or bands are missing",
            next_step="write the case again: `haptonic new` copies it",
        )
    gap = max(gaps, key=lambda gap: gap.width)
    centre, error = 0.5 * (gap.lower + gap.upper), 0.5 * (gap.lower_error + gap.upper_error)
    value, bound = {
        "lower edge": (gap.lower, gap.lower_error),
        "upper edge": (gap.upper, gap.upper_error),
        "centre": (centre, error),
        "relative width": (gap.width / centre, 2 * error / centre),
    }[quantity.measure]
    return np.array([value]), np.array([bound])
