"""The server of the studio: it listens on this machine only, until Ctrl-C."""

from __future__ import annotations

import gc
import os
import secrets
import socket
import threading
import webbrowser
from collections.abc import Callable
from contextlib import suppress
from importlib import import_module
from pathlib import Path

import uvicorn

from haptonic.errors import ResourceError, StudyError
from haptonic.later import USUAL_THRESHOLDS
from haptonic.paths import source
from haptonic.studio.guard import Guard
from haptonic.studio.memory import share_one_arena
from haptonic.studio.workspace import Workspace
from haptonic.study.text_file import text_of

ADDRESS = "127.0.0.1"
LARGEST_MESSAGE = 4096  # bytes of a message of the websocket; the page sends none


def serve(study: Path | None, port: int, ready: Callable[[str], object]) -> None:
    """Serve the folder of a study, or else the working directory, until Ctrl-C.

    Parameters
    ----------
    study : file with which the page begins
    port : 0 for any free one
    ready : called with the link of this start, which works once

    Raises
    ------
    HaptonicError : the study cannot be read, or the port is taken
    """
    share_one_arena()
    folder, opened = Path.cwd(), None
    if study is not None:
        path = source(study, "study", StudyError)
        text_of(path)
        folder, opened = path.absolute().parent, path.name
        Workspace(folder).read(opened)
    listening = listen(port)
    port = listening.getsockname()[1]
    token = secrets.token_urlsafe(32)
    ready(f"http://{ADDRESS}:{port}/?token={token}")
    with suppress(KeyboardInterrupt):
        # these modules take a second to load, while the browser starts; its first request waits in the socket
        studio = import_module("haptonic.studio.app").Studio(Workspace(folder), opened)
        guard = Guard(studio.app(), port, token)
        # the page asks for the list of analyses, whose modules take further time
        threading.Thread(target=import_module("haptonic.studio.offers").offers, daemon=True).start()
        # commands collect less often, see `haptonic.cli.app`; a server would keep garbage of cycles for long
        gc.set_threshold(*USUAL_THRESHOLDS)
        uvicorn.Server(settings(guard)).run(sockets=[listening])


def settings(guard: Guard) -> uvicorn.Config:
    """Settings of the server: a plain protocol, small messages, no compression, no log of requests."""
    return uvicorn.Config(
        guard,
        log_level="warning",
        access_log=False,
        server_header=False,
        date_header=False,
        http="h11",
        ws="websockets-sansio",
        ws_max_size=LARGEST_MESSAGE,
        ws_per_message_deflate=False,
        lifespan="on",
        timeout_graceful_shutdown=2,
    )


def listen(port: int) -> socket.socket:
    """A listening socket on this machine.

    Raises
    ------
    ResourceError : the port is taken, or not allowed
    """
    # the event loop sends small answers at once only if the protocol is named; else each waits for 40 ms
    listening = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    if os.name == "posix":  # on Windows this option would let another program take the port as well
        listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listening.bind((ADDRESS, port))
    except (OSError, OverflowError) as error:
        listening.close()
        raise ResourceError.conflict(
            argument="--port",
            given=port,
            allowed="a free port, 1024 to 65535; 0 for any",
            cause=getattr(error, "strerror", None) or str(error),
            next_step="leave --port out, or give another number",
        ) from None
    listening.listen(128)
    return listening


def open_browser(link: str) -> None:
    """Open a link in the browser of the user, without waiting for it."""
    threading.Thread(target=webbrowser.open, args=(link,), daemon=True).start()
