"""Models of rising cost, and the cheapest one that is accurate enough over the whole zone."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from haptonic.bloch.mesh_levels import (
    Lack,
    MeshLimits,
    check_memory,
    check_thickness,
    finer_level,
    first_level,
    refusal,
    starting_level,
)
from haptonic.bloch.model import BlochModel
from haptonic.bloch.resolution import LEVELS
from haptonic.bloch.settings import BandSettings
from haptonic.bloch.truncation import TRUNCATION_SHARE, TRUSTED_TRUNCATION, reach_truncation
from haptonic.cell import UnitCell
from haptonic.parallel import one_thread

# Share of the goal from which the interior is wider on the next mesh. With steel cores in rings of epoxy the
# truncation error was 0.7 of the goal on one mesh and above it on the next; one condensation less saves a
# quarter of 22 s there.
NEARLY = 0.5


def candidate_models(
    cell: UnitCell, settings: BandSettings, *, gaps_only: bool = False, limits: MeshLimits | None = None
) -> Iterator[BlochModel | Lack]:
    """Yield models of rising cost, from the first that may be accurate enough; last, why no model follows.

    The caller uses the first model of sufficient accuracy, or the best. The interior of the first mesh may
    grow beyond the budget, because a model needs a reliable error.

    Parameters
    ----------
    settings : if they contain a resolution, only this is computed, for any accuracy
    gaps_only : whether only gaps are needed
    limits : by default the budget of the settings and the free memory

    Raises
    ------
    ResourceError : not even the coarsest mesh fits
    GeometryError : a plate too thin to be computed, or a cell whose interior no mesh resolves
    """
    count, accuracy, chosen = settings.count, settings.accuracy, settings.resolution
    limits = MeshLimits.of(settings.budget) if limits is None else limits
    if chosen is None:
        level = first_level(cell, count, accuracy, limits)
        # the interior grows if the cell needs more than is usual for the accuracy
        usual = LEVELS[min(level, starting_level(accuracy))]
        mesh = replace(LEVELS[level], steps=usual.steps, block=usual.block).for_bands(cell, count)
        if cell.discs or cell.solid is not None:
            # a third block was enough for 55 of 64 cells with holes and inclusions
            mesh = replace(mesh, steps=mesh.steps + 1)
    else:
        check_thickness(cell)
        mesh, level, limits = chosen.for_bands(cell, count), len(LEVELS), replace(limits, seconds=math.inf)
        check_memory(cell, chosen, count, limits)
    goal = min(TRUSTED_TRUNCATION, TRUNCATION_SHARE * accuracy)
    spent, answered, highest = 0.0, False, None
    while True:
        with one_thread():
            reached, lack = reach_truncation(
                cell,
                mesh,
                count,
                goal=goal,
                limits=limits,
                spent=spent,
                measured=not gaps_only,
                highest=highest,
            )
        mesh, highest, excess = reached.mesh, reached.highest, 1.0
        if reached.truncation <= TRUSTED_TRUNCATION or (chosen is not None and lack is None):
            model = BlochModel.of(cell, mesh, count, whole=reached.whole, highest=highest)
            spent += mesh.seconds(cell)
            answered = True
            yield model
            excess = model.mesh_error / accuracy
        if lack is None:
            # a finer mesh needs a somewhat wider interior, and a second condensation takes all its time again
            wider = mesh.grown() if reached.truncation > NEARLY * goal else mesh
            finer = finer_level(cell, wider, level, excess, limits, spent)
            if not isinstance(finer, Lack):
                level, mesh = finer
                continue
            lack = finer
        break
    if not answered:
        raise refusal(cell, count, accuracy, lack)
    yield lack


@dataclass(frozen=True)
class BestModel:
    """Most accurate model; ``lack`` is the reason if it does not reach the accuracy."""

    model: BlochModel
    lack: Lack | None = None

    def attributes(
        self, settings: BandSettings, largest: float, beside: tuple[str, str] | None = None
    ) -> dict[str, Any]:
        """Attributes of a dataset on its accuracy: requested, reached, and the limit that prevented more;
        the name of a mesh whose edges are all straight.

        largest : largest relative error of what the dataset contains
        beside : name and text of a limit beside the mesh, which applies if the mesh is accurate enough
        """
        attributes: dict[str, Any] = {
            "accuracy": settings.accuracy,
            "budget_s": settings.budget,
            "largest_error": largest,
        }
        cell = self.model.cell
        if cell.solid is not None and cell.solid_period.straight:
            attributes["straight_mesh"] = Path(cell.solid.file).name
        if self.lack is not None:
            return attributes | self.lack.attributes(cell)
        if beside is not None and largest > settings.accuracy and not settings.resolution:
            return attributes | dict(zip(("stopped_by", "stopped_why"), beside, strict=True))
        return attributes


def best_model(
    cell: UnitCell,
    settings: BandSettings,
    *,
    limits: MeshLimits | None = None,
    tried: Callable[[BlochModel], object] | None = None,
) -> BestModel:
    """Compute the cheapest model of a given accuracy over the whole zone, or the most accurate one.

    Parameters and errors as in `candidate_models`; ``tried`` is called with each model before its errors over
    the zone are estimated.
    """
    best: BlochModel | None = None
    for candidate in candidate_models(cell, settings, limits=limits):
        if isinstance(candidate, Lack):
            assert best is not None, "the candidates contain neither a model nor an error"
            return BestModel(best, candidate)
        if tried is not None:
            tried(candidate)
        if best is None or candidate.worst_error < best.worst_error:
            best = candidate
        if settings.resolution or best.worst_error <= settings.accuracy:
            return BestModel(best)
    raise AssertionError("candidates end with the reason why no model follows")


def bloch_model(cell: UnitCell, settings: BandSettings, *, limits: MeshLimits | None = None) -> BlochModel:
    """Return the model of `best_model`; its ``worst_error`` is the accuracy reached."""
    return best_model(cell, settings, limits=limits).model
