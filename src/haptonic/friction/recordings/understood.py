"""Reading of the records of an experiment, before any trial is measured."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from haptonic.errors import FrictionError
from haptonic.friction.recordings.analysis import channel_map_of, records_of
from haptonic.friction.recordings.channel_map import ChannelMap
from haptonic.friction.recordings.sensor import Sensor
from haptonic.friction.recordings.trial_table import TrialTable
from haptonic.friction.signals.record import Label, Record
from haptonic.friction.signals.tables import read_columns, read_records, read_trials

MOST_TRIED = 20  # trials that are tried for the first record


@dataclass(frozen=True, eq=False)
class Understood:
    """Trials and channels of an experiment.

    source : the folder or table
    trials : number of trials by participant, region and actuation
    channels : for each meaning the name of its channel, and the SI value of one unit, negative if turned
    first : the first trial with a record, as a sentence part, and the record; None for a table of trials
    remarks : assumptions; doubts : possible faults
    simulated : True if any trial is marked as simulated
    """

    source: Path
    trials: dict[tuple[str, str, str], int]
    channels: dict[str, tuple[str, float, str]] = field(default_factory=dict)
    first: tuple[str, Record] | None = None
    remarks: tuple[str, ...] = ()
    doubts: tuple[str, ...] = ()
    simulated: bool = False


def understood(source: Path, sensor: Sensor) -> Understood:
    """Read the table of trials and some records of a folder, or of a single table.

    Raises
    ------
    ResourceError : no such file or folder
    FrictionError : an invalid table, or channels that cannot be found
    """
    if source.is_dir() or not source.suffix:
        return _of_folder(TrialTable.read(source), sensor)
    columns = read_columns(source, [])
    simulated = "simulated" in {str(word) for word in columns.get("origin", ())}
    if "friction" in columns:
        read = read_trials(source)
        names = (read[name].values.tolist() for name in ("participant", "waveguide", "actuation"))
        trials = Counter(zip(*names, strict=True))
        return Understood(source=source, trials=dict(trials), simulated=simulated)
    labels: list[Label] = []
    first: tuple[str, Record] | None = None
    for label, record in read_records(source):
        first = first or (str(label), record)
        labels.append(label)
    remarks = () if first is None else first[1].remarks
    return Understood(
        source=source, trials=_counted(labels), first=first, remarks=remarks, simulated=simulated
    )


def _of_folder(table: TrialTable, sensor: Sensor) -> Understood:
    channel_map = channel_map_of(table, sensor)
    labels = [
        Label(**{name: column[row].item() for name, column in table.labels.items()})
        for row in range(len(table.files))
    ]
    reads = records_of(
        table.folder, channel_map, table.portion(range(min(MOST_TRIED, len(labels)))),
        table.labels["participant"],
    )  # fmt: skip
    read = next((read for read in reads if read.record is not None), None)
    if read is None or read.record is None:
        raise FrictionError.too_few(
            argument="trials",
            given=f"none of the first {min(MOST_TRIED, len(labels))} trials has a record that can be read",
            allowed="records of the trials in the table",
            cause="files are missing or damaged, or a channel has another name",
            next_step="run the analysis, which lists each trial with its reason",
        )
    return Understood(
        source=table.folder,
        trials=_counted(labels),
        channels=_channels(channel_map),
        first=(f"{labels[read.span.row]} ({table.files[read.span.row]})", read.record),
        remarks=channel_map.remarks,
        doubts=(*table.doubts, *channel_map.doubts),
        simulated=table.simulated or read.simulated,
    )


def _channels(channel_map: ChannelMap) -> dict[str, tuple[str, float, str]]:
    """Channel, SI value of one unit and SI unit by meaning; the gauges of a calibration are one channel."""
    of_gauges = {"forces": (", ".join(channel_map.gauges), 1.0, "V")} if channel_map.gauges else {}
    channels = {
        meaning: (scaled.name, 1.0 if scaled.usual is None else scaled.usual, scaled.dimension)
        for meaning, scaled in channel_map.scaled.items()
    }
    if any(mounting.angle for mounting in channel_map.mountings.values()) and "tangential" in channels:
        _, value, unit = channels["tangential"]
        channels["tangential"] = f"{' and '.join(channel_map.plane)}, along the stroke", value, unit
        channels.pop("across", None)
    return of_gauges | channels


def _counted(labels: Sequence[Label]) -> dict[tuple[str, str, str], int]:
    return dict(Counter((label.participant, label.waveguide, label.actuation) for label in labels))
