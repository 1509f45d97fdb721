"""``haptonic verify``: compare computed cases with published and exact values."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from haptonic.cli.commands import Json
from haptonic.cli.console import speaking
from haptonic.cli.listing import pairs
from haptonic.names import counted
from haptonic.paths import target
from haptonic.verification import (
    Case,
    cases,
    compare_case,
    comparison_table,
    omitted_cases,
    plain_comparison,
    write_page,
)


def complete(incomplete: str) -> list[str]:
    """Names of cases that begin with the typed text, for the completion of a shell."""
    return [case.id for case in cases() if case.id.startswith(incomplete)]


Names = Annotated[
    list[str] | None,
    typer.Argument(
        metavar="CASE...", help="The cases; all if left out.", autocompletion=complete, show_default=False
    ),
]
Listing = Annotated[bool, typer.Option("--list", help="List the cases without computing them.")]
Page = Annotated[
    Path | None,
    typer.Option(
        "--page", metavar="DIR", help="Folder for a page with table and pictures; earlier ones are replaced."
    ),
]


def run(names: Names = None, listing: Listing = False, page: Page = None, json: Json = False) -> None:
    """Compare the cases; exit code 1 if a value lies outside its tolerance and both errors."""
    with speaking(json, kept="computed cases are stored; run the same command to continue") as voice:
        chosen = cases(names or ())
        if listing:
            pairs(voice, {case.id: _described(case) for case in chosen})
            voice.write(
                "`haptonic new STUDY FILE` copies the study of a case; most have the name of the case."
            )
            voice.answer({"cases": [case.model_dump() for case in chosen]})
            return
        folder = None if page is None else target(page, "--page")
        comparisons = []
        with voice.counted("verifying") as progress:
            for number, case in enumerate(chosen):
                progress(number, len(chosen), case.id)
                comparisons += compare_case(case)
        voice.show(comparison_table(comparisons))
        failed = sorted({comparison.case.id for comparison in comparisons if not comparison.agrees})
        for case in chosen:
            if case.remark and (case.id in failed or len(chosen) == 1):
                voice.write(f"{case.id}: {case.remark}")
        verdict = f"outside the errors: {', '.join(failed)}" if failed else "all agree"
        quantities = f"{len(comparisons)} {'quantity' if len(comparisons) == 1 else 'quantities'}"
        voice.write(f"{counted(len(chosen), 'case')}, {quantities}: {verdict}.")
        if folder is not None:
            write_page(folder, comparisons, omitted_cases())
            voice.write(f"written: {folder}")
        voice.answer({"comparisons": list(map(plain_comparison, comparisons)), "failed": failed})
        if failed:
            raise SystemExit(1)


def _described(case: Case) -> str:
    """Title, kind and source of a case, and its study if that has another name."""
    study = "" if case.study == case.id else f"; study {case.study}"
    return f"{case.title} ({case.kind}; {case.source}{study})"
