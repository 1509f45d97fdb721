"""``haptonic studio``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from haptonic.cli.console import speaking
from haptonic.studio.serving import open_browser, serve

STUDY = typer.Argument(
    metavar="STUDY",
    help="Study file (TOML); its folder becomes the folder of the studio.",
    show_default=False,
)


def run(
    study: Annotated[Path | None, STUDY] = None,
    no_browser: Annotated[
        bool, typer.Option("--no-browser", help="Only print the link, and open no browser.")
    ] = False,
    port: Annotated[
        int, typer.Option("--port", metavar="N", min=0, max=65535, help="Port of the server; 0 for any.")
    ] = 0,
) -> None:
    """Serve the page until Ctrl-C."""
    with speaking(False) as voice:

        def ready(link: str) -> None:
            voice.write("The studio is at this link, which works once; Ctrl-C ends it:")
            voice.print(f"  {link}\n")
            if not no_browser:
                open_browser(link)

        serve(study, port, ready)
