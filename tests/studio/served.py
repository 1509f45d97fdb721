"""A studio on a real port, and what talks to it: HTTP without a browser's help, and a websocket."""

import http.client
import json
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import uvicorn
from websockets.sync.client import ClientConnection, connect

from haptonic.studio.app import Studio
from haptonic.studio.guard import Guard
from haptonic.studio.serving import listen, settings
from haptonic.studio.workspace import Workspace

PATIENCE = 120.0  # s, for a job on a busy machine


@dataclass
class Reply:
    status: int
    headers: http.client.HTTPMessage
    content: bytes

    @property
    def json(self) -> Any:
        return json.loads(self.content)


@dataclass
class Served:
    """A running studio; ``cookie`` is that of an admitted browser."""

    studio: Studio
    guard: Guard
    port: int
    cookie: str = ""

    @property
    def link(self) -> str:
        return f"http://127.0.0.1:{self.port}/?token={self.guard.token}"

    @property
    def origin(self) -> str:
        return f"http://127.0.0.1:{self.port}"

    def ask(self, method: str, path: str, body: bytes | None = None, **headers: str | None) -> Reply:
        """Send a request as the page does; a header that is None is left out."""
        usual = {"Host": f"127.0.0.1:{self.port}", "Origin": self.origin, "Cookie": self.cookie}
        given = {name.capitalize(): value for name, value in headers.items()}
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=PATIENCE)
        connection.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
        for name, value in (usual | given).items():
            if value is not None:
                connection.putheader(name, value)
        if body is not None:
            connection.putheader("Content-Length", str(len(body)))
        connection.endheaders(body)
        response = connection.getresponse()
        try:
            return Reply(response.status, response.headers, response.read())
        finally:
            connection.close()

    def post(self, action: str, /, **asked: Any) -> Reply:
        return self.ask("POST", f"/api/{action}", json.dumps(asked).encode())

    def listening(self, **headers: str) -> ClientConnection:
        given = {"Origin": self.origin, "Cookie": self.cookie} | headers
        origin = given.pop("Origin") or None
        address = f"ws://127.0.0.1:{self.port}/api/live"
        return connect(address, origin=origin, additional_headers=given, proxy=None)  # type: ignore[arg-type]

    def finished(self, number: int) -> Any:
        """The job when it has ended."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            job = self.ask("GET", f"/api/jobs/{number}").json
            if job["state"] != "running":
                return job
            time.sleep(0.1)
        raise AssertionError(f"job {number} does not end")


@contextmanager
def served(folder: Path, opened: str | None = None, *, admit: bool = True, port: int = 0) -> Iterator[Served]:
    """Run a studio in a thread of this process; ``admit`` uses its link."""
    socket = listen(port)
    port = socket.getsockname()[1]
    studio = Studio(Workspace(folder), opened)
    guard = Guard(studio.app(), port)
    server = uvicorn.Server(settings(guard))
    thread = threading.Thread(target=server.run, kwargs={"sockets": [socket]}, daemon=True)
    thread.start()
    running = Served(studio, guard, port)
    if admit:
        reply = running.ask("GET", f"/?token={guard.token}", cookie=None)
        assert reply.status == 200
        running.cookie = reply.headers["Set-Cookie"].split(";")[0]
    try:
        yield running
    finally:
        server.should_exit = True
        thread.join(20)
        socket.close()
        assert not thread.is_alive()
