"""Options that several analyses have."""

from __future__ import annotations

from dataclasses import dataclass

from haptonic.analyses.analysis import option


@dataclass(frozen=True, kw_only=True)
class Seeded:
    """Of what draws by chance."""

    seed: int = option(0, "Of all that is drawn by chance.", metavar="N", least=0)


@dataclass(frozen=True, kw_only=True)
class UnitsOfFile:
    """Of what reads files that may not say their units."""

    frequency_unit: str | None = option(
        None, 'Of frequencies in files that give none, such as "kHz".', metavar="UNIT"
    )
