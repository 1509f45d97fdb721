"""Designs that an analysis reports while it computes, before its result is complete."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol


@dataclass(frozen=True)
class PointNumber:
    """A number of a computed design.

    value, error : in the unit; without an error the number is a preview, as from a coarse model
    unit : SI unit, empty for a bare number
    """

    title: str
    value: float
    unit: str
    error: float | None = None


@dataclass(frozen=True, kw_only=True)
class ComputedPoint:
    """A computed design.

    group : part of the analysis that computed it
    changes : its numbers that differ from the study, SI, by path
    varied : numbers that the analysis varies; results : numbers that it computed, none for a failed design
    """

    group: str
    changes: Mapping[str, float]
    varied: tuple[PointNumber, ...]
    results: tuple[PointNumber, ...]


class Points(Protocol):
    """Callback with each computed design."""

    def __call__(self, point: ComputedPoint, /) -> object: ...


def no_points(point: ComputedPoint, /) -> None:
    """Report nothing."""
