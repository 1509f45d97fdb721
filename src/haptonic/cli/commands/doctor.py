"""``haptonic doctor``."""

from __future__ import annotations

from haptonic.cli.commands import Json
from haptonic.cli.console import speaking
from haptonic.cli.doctor import examined, tables


def run(json: Json = False) -> None:
    """Examine the machine; exit code 1 if the check of the physics fails."""
    with speaking(json) as voice:
        with voice.counted("examining"):
            report = examined()
        for table in tables(report):
            voice.show(table)
        for reason in report["slow"]:
            voice.write(reason)
        if not report["slow"]:
            voice.write("haptonic found nothing that slows it down on this machine.")
        voice.answer(report)
        if not report["healthy"]:
            raise SystemExit(1)
