"""Trials of a study: their order from [protocol], the truth of a simulation from [participants]."""

from __future__ import annotations

from collections.abc import Mapping

from haptonic.analyses.needs import need_carrier
from haptonic.errors import StudyError
from haptonic.friction.participants import Participants
from haptonic.friction.protocol import Protocol
from haptonic.friction.simulation import Truth, explaining, film_of
from haptonic.results.protocol import StrokeTask
from haptonic.study.schema import Description
from haptonic.units import format_quantity, in_percent

SHORTEST, LONGEST = 0.4, 10.0  # s, duration of a stroke; touching down and lifting take a third of it
PUBLISHED = ("WG1", "WG2")  # names of the waveguides of a study without a plate [daunizeau-haptics]


def protocol_of(study: Description) -> Protocol:
    """Order of the trials of a study.

    Raises
    ------
    StudyError : fewer than two waveguides
    """
    section = study.protocol_settings
    balanced = section.order == "balanced"
    return Protocol(
        section.blocks,
        section.trials,
        counterbalanced=balanced,
        waveguides=waveguides_of(study),
        seed=section.seed if balanced else None,
    )


def waveguides_of(study: Description) -> tuple[str, str]:
    """Names of the driven and of the idle waveguide.

    Raises
    ------
    StudyError : a name that the plate does not have, or a plate with fewer than two regions
    """
    section, plate = study.protocol_settings, study.plate_settings
    regions = plate.regions if plate else []
    for key in ("driven", "idle"):
        name = getattr(section, key)
        if plate and name is not None and name not in regions:
            raise StudyError.unknown(
                f"protocol.{key}", name, regions, "no region of the plate has this name",
                next_step="choose one of these, or leave [plate] out",
            )  # fmt: skip
    actuated = [actuator.region for actuator in plate.actuator if actuator.region] if plate else []
    names = regions or list(PUBLISHED)
    driven = section.driven or next((n for n in [*actuated, *names] if n != section.idle), None)
    idle = section.idle or next((name for name in names if name != driven), None)
    if driven is None or idle is None:
        raise StudyError.missing(
            argument="protocol.idle",
            allowed="two waveguides, the driven one and one that should stay at rest",
            cause="the plate of this study has a single region",
            next_step="name another region in [plate.tiles]",
        )
    return driven, idle


def task_of(study: Description) -> StrokeTask:
    """Task of the participants: force and speed from [touch], the rest from [protocol].

    Raises
    ------
    StudyError : strokes that are too short or too long
    """
    section, touch = study.protocol_settings, study.touch
    task = StrokeTask(touch.speed, touch.force, section.stroke, section.pause)
    if not SHORTEST <= task.lasting <= LONGEST:
        raise StudyError.out_of_range(
            argument="protocol.stroke",
            given=f"{format_quantity(task.stroke, 'm')} at {format_quantity(task.speed, 'm/s')}, "
            f"{format_quantity(task.lasting, 's')}",
            allowed=f"a stroke that lasts {SHORTEST:g} to {LONGEST:g} s",
            cause="a slip in the unit of touch.speed or protocol.stroke",
            next_step="change one of them",
        )
    return task


def basis_of(study: Description, amplitudes: Mapping[str, float] | None) -> str:
    """Sentence on the origin of the assumed reductions, and on the way to use those of the study's plate."""
    if amplitudes is not None:
        return "The reductions are computed from the amplitudes of --from with the load-sharing model."
    people, published = study.participants, Participants()
    numbers = f"{in_percent(people.driven)} and {in_percent(people.idle)}"
    if (people.driven, people.idle) != (published.driven, published.idle):
        return f"The reductions, {numbers}, are given in [participants] of the study."
    if study.plate_settings is None:
        return f"The reductions, {numbers}, are values of the published prototype."
    return (
        f"The reductions, {numbers}, are values of the published prototype, not of this plate. "
        "`haptonic feel STUDY --json > feel.json` computes those of this plate; `--from feel.json` uses them."
    )


def truth_of(study: Description, amplitudes: Mapping[str, float] | None = None) -> Truth:
    """True values of a simulation of friction trials.

    Parameters
    ----------
    amplitudes : waveguide -> m; by default those that explain the reductions of [participants]

    Raises
    ------
    StudyError : no carrier, fewer than two waveguides, or a waveguide without an amplitude
    FrictionError : amplitudes or reductions that load sharing does not explain
    """
    people, carrier, names = study.participants, need_carrier(study), waveguides_of(study)
    task, skin = task_of(study), study.touch.skin
    force = (task.force, people.force_spread)
    if amplitudes is None:
        reductions = dict(zip(names, (people.driven, people.idle), strict=True))
        amplitudes = explaining(reductions, carrier, force, skin)
    for name in names:
        if name not in amplitudes:
            raise StudyError.mismatch(
                argument="amplitudes",
                given=", ".join(amplitudes) or "none",
                allowed=f"an amplitude for each of {' and '.join(names)}",
                cause="they were computed for another plate",
                next_step=f'add "{name}", or name the waveguides in [protocol]',
            )
    film = film_of({name: amplitudes[name] for name in names}, carrier, force, skin)
    return Truth(
        people,
        remaining=film.mean,
        force=force,
        speed=(task.speed, people.speed_spread),
        contact=task.lasting,
        film=film,
    )
