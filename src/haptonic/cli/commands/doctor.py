"""``haptonic doctor``."""

from __future__ import annotations

from haptonic.cli.commands import Json
from haptonic.cli.console import speaking
from haptonic.cli.doctor import examined
from haptonic.results.table import Table


def run(json: Json = False) -> None:
    """Examine the machine; exit code 1 if the check of the physics fails."""
    with speaking(json) as voice:
        with voice.counted("examining"):
            report = examined()
        rows = [(name.replace("_", " "), str(value)) for name, value in report.items()]
        voice.show(Table("haptonic doctor", ("what", "value"), rows))
        voice.answer(report)
        if not report["healthy"]:
            raise SystemExit(1)
